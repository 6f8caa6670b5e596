// Accessor classes of the object types in stress.h. Written by physgen: change the schema, not this file.
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
#ifndef PHYSGEN_STRESS_H_DC4DF776F1BF8F8D
#define PHYSGEN_STRESS_H_DC4DF776F1BF8F8D

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 7
#error "stress.physgen.h is for version 7 of the physgen runtime: generate it again with the installed physgen"
#endif
#ifdef PHYSGEN_SCHEMA_H
#error "a program includes stress.physgen.h in place of the schema: remove the #include of the schema"
#endif
#define PHYSGEN_GENERATED_HEADER

namespace model {

// ---- Stress ---------------------------------------------------------------------------------------------------------

/// The value of one Stress.
template <class Real>
struct Stress {
  /// [Pa]. Symmetric, 6 stored.
  physgen::MatrixValue<Real, 3, 3> sigma = decltype(sigma)::Zero();
  /// [Pa]
  Real pressure = {};
};

template <class Space>
struct StressFormats {
  using sigma = physgen::format::Native;
  using pressure = physgen::format::Native;
};

struct StressObject;
template <class ArrayTag, class Base = StressFormats<physgen::Host>, class Object = StressObject, int first = 0>
struct StressProbe {
  using array_ = ArrayTag;
  using sigma = physgen::Probe<ArrayTag, Object, first + 0, typename Base::sigma>;
  using pressure = physgen::Probe<ArrayTag, Object, first + 1, typename Base::pressure>;
};

template <class Real, class Formats>
struct StressRecord {
  using sigma = physgen::StoredField<StressRecord, 0, physgen::shape::Symmetric<3>, typename Formats::sigma, Real>;
  using pressure = physgen::StoredField<StressRecord, 1, physgen::shape::Scalar, typename Formats::pressure, Real>;
  using fields_ = physgen::RecordFields<sigma, pressure>;
};

template <class Real, class Formats, class Cursor>
struct StressRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = StressRecord<Real, Formats>;
  using Value = Stress<typename Cursor::template Lanes<Real>>;

  /// [Pa]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) sigma() const {
    return this->field_(typename Record::sigma(), Record::sigma::offset);
  }
  /// [Pa]
  PHYSGEN_FUNCTION decltype(auto) pressure() const {
    return this->field_(typename Record::pressure(), Record::pressure::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {sigma().get(), pressure()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    sigma() = value.sigma;
    pressure() = value.pressure;
  }
};

struct StressObject : physgen::ObjectTag<StressObject, Stress, StressFormats, StressRecord, StressRef, StressProbe> {
  static constexpr std::string_view name = "model::Stress";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"sigma", "Pa"}, {"pressure", "Pa"}}};
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StressObject, Space>>
using StressView = physgen::View<StressObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StressObject, Space>>
using StressArray = physgen::Array<StressObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<StressObject, physgen::Host>({28, 4, {0, 24}}, {56, 8, {0, 48}}));

}  // namespace model

#endif  // PHYSGEN_STRESS_H_DC4DF776F1BF8F8D
