// Accessor classes of the object types in materials.h. Written by physgen: change the schema, not this file.
//
// Of each object type X:
//   X<Real> is the value of one object, all its fields. Real is float, double, or a SIMD batch of one of them.
//   XFormats<Space> says how each field is stored in a memory space. To change a field's format, derive a struct from
//   it, redeclare the field's alias there, and pass the struct as the last argument of XArray.
//   XProbe are formats that tell reads and writes apart for the array that the tag ArrayTag names; see
//   <physgen/probe.h>. The list of fields of Object has the first of these as number first.
//   XRecord<Real, Formats> says where each field lies in the record of one object, and as what.
//   XRef<Real, Formats, Cursor> has the accessors of one object of an array, or of those under a SIMD index: a function
//   for each field; get() and put() load and store all of them.
//   XObject is what the runtime knows of the type; XView and XArray are what programs name.
//
// The static_asserts compare what physgen planned with what the compiler finds, with Real = float and with Real =
// double: bytes and alignment of a record, and the offsets of its fields. physgen has proved of them, for every layout
// and every number of objects, that no two channels share a byte, and that each is aligned to its elements and lies
// inside its tile.
#ifndef PHYSGEN_MATERIALS_H_C23AF320C80E4485
#define PHYSGEN_MATERIALS_H_C23AF320C80E4485

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 7
#error "materials.physgen.h is for version 7 of the physgen runtime: generate it again with the installed physgen"
#endif
#ifdef PHYSGEN_SCHEMA_H
#error "a program includes materials.physgen.h in place of the schema: remove the #include of the schema"
#endif
#define PHYSGEN_GENERATED_HEADER

namespace material {

// ---- Lame -----------------------------------------------------------------------------------------------------------

/// Elastic constants.
template <class Real>
struct Lame {
  /// Shear modulus. [Pa]
  Real mu = {};
  /// [Pa]
  Real lambda = {};
};

template <class Space>
struct LameFormats {
  using mu = physgen::format::Native;
  using lambda = physgen::format::Native;
};

struct LameObject;
template <class ArrayTag, class Base = LameFormats<physgen::Host>, class Object = LameObject, int first = 0>
struct LameProbe {
  using array_ = ArrayTag;
  using mu = physgen::Probe<ArrayTag, Object, first + 0, typename Base::mu>;
  using lambda = physgen::Probe<ArrayTag, Object, first + 1, typename Base::lambda>;
};

template <class Real, class Formats>
struct LameRecord {
  using mu = physgen::StoredField<LameRecord, 0, physgen::shape::Scalar, typename Formats::mu, Real>;
  using lambda = physgen::StoredField<LameRecord, 1, physgen::shape::Scalar, typename Formats::lambda, Real>;
  using fields_ = physgen::RecordFields<mu, lambda>;
};

template <class Real, class Formats, class Cursor>
struct LameRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = LameRecord<Real, Formats>;
  using Value = Lame<typename Cursor::template Lanes<Real>>;

  /// Shear modulus. [Pa]
  PHYSGEN_FUNCTION decltype(auto) mu() const { return this->field_(typename Record::mu(), Record::mu::offset); }
  /// [Pa]
  PHYSGEN_FUNCTION decltype(auto) lambda() const {
    return this->field_(typename Record::lambda(), Record::lambda::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {mu(), lambda()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    mu() = value.mu;
    lambda() = value.lambda;
  }
};

struct LameObject : physgen::ObjectTag<LameObject, Lame, LameFormats, LameRecord, LameRef, LameProbe> {
  static constexpr std::string_view name = "material::Lame";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"mu", "Pa"}, {"lambda", "Pa"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "Shear modulus.", "",
  };
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<LameObject, Space>>
using LameView = physgen::View<LameObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<LameObject, Space>>
using LameArray = physgen::Array<LameObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<LameObject, physgen::Host>({8, 4, {0, 4}}, {16, 8, {0, 8}}));

// ---- Fibre ----------------------------------------------------------------------------------------------------------

/// One family of fibres.
template <class Real>
struct Fibre {
  /// Unit vector along the fibre.
  physgen::MatrixValue<physgen::same_lanes_t<Real, float>, 3, 1> direction = decltype(direction)::Zero();
  /// [Pa]
  physgen::same_lanes_t<Real, double> strength = {};
};

template <class Space>
struct FibreFormats {
  using direction = physgen::format::Native;
  using strength = physgen::format::Native;
};

struct FibreObject;
template <class ArrayTag, class Base = FibreFormats<physgen::Host>, class Object = FibreObject, int first = 0>
struct FibreProbe {
  using array_ = ArrayTag;
  using direction = physgen::Probe<ArrayTag, Object, first + 0, typename Base::direction>;
  using strength = physgen::Probe<ArrayTag, Object, first + 1, typename Base::strength>;
};

template <class Real, class Formats>
struct FibreRecord {
  using direction = physgen::StoredField<FibreRecord, 0, physgen::shape::Vector<3>, typename Formats::direction, float>;
  using strength = physgen::StoredField<FibreRecord, 1, physgen::shape::Scalar, typename Formats::strength, double>;
  using fields_ = physgen::RecordFields<direction, strength>;
};

template <class Real, class Formats, class Cursor>
struct FibreRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = FibreRecord<Real, Formats>;
  using Value = Fibre<typename Cursor::template Lanes<Real>>;

  /// Unit vector along the fibre.
  PHYSGEN_FUNCTION decltype(auto) direction() const {
    return this->field_(typename Record::direction(), Record::direction::offset);
  }
  /// [Pa]
  PHYSGEN_FUNCTION decltype(auto) strength() const {
    return this->field_(typename Record::strength(), Record::strength::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {direction().get(), strength()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    direction() = value.direction;
    strength() = value.strength;
  }
};

struct FibreObject : physgen::ObjectTag<FibreObject, Fibre, FibreFormats, FibreRecord, FibreRef, FibreProbe> {
  static constexpr std::string_view name = "material::Fibre";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"direction"}, {"strength", "Pa"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "Unit vector along the fibre.", "",
  };
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<FibreObject, Space>>
using FibreView = physgen::View<FibreObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<FibreObject, Space>>
using FibreArray = physgen::Array<FibreObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<FibreObject, physgen::Host>({20, 8, {8, 0}}, {20, 8, {8, 0}}));

}  // namespace material

#endif  // PHYSGEN_MATERIALS_H_C23AF320C80E4485
