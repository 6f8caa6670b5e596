// Accessor classes of the object types in materials.h. Written by physgen: change the schema, not this file.
#ifndef PHYSGEN_MATERIALS_H_66B56C20E9066756
#define PHYSGEN_MATERIALS_H_66B56C20E9066756

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 4
#error "materials.physgen.h is for version 4 of the physgen runtime: generate it again with the installed physgen"
#endif

namespace material {

// ---- Lame -----------------------------------------------------------------------------------------------------------

/// Elastic constants.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Lame {
  /// Shear modulus. [Pa]
  Real mu;
  /// [Pa]
  Real lambda;
};

/// How the fields of one Lame are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of LameArray.
template <class Space>
struct LameFormats {
  using mu = physgen::format::Native;
  using lambda = physgen::format::Native;
};

struct LameObject;
/// LameFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see <physgen/probe.h>.
/// The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = LameFormats<physgen::Host>, class Object = LameObject, int first = 0>
struct LameProbe {
  using array_ = ArrayTag;
  using mu = physgen::Probe<ArrayTag, Object, first + 0, typename Base::mu>;
  using lambda = physgen::Probe<ArrayTag, Object, first + 1, typename Base::lambda>;
};

/// Where each field begins in the record of one Lame [bytes].
template <class Real, class Formats>
struct LameRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::mu, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::lambda, Real>(),
  }});
  static constexpr int mu = plan_.offset[0];
  static constexpr int lambda = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Lame of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class LameRef {
  using Record = LameRecord<Real, Formats>;

 public:
  using Value = Lame<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit LameRef(const Cursor& cursor) : at_(cursor) {}
  LameRef(const LameRef&) = default;
  LameRef& operator=(const LameRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const LameRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Shear modulus. [Pa]
  PHYSGEN_FUNCTION decltype(auto) mu() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::mu, Real>(Record::mu);
  }
  /// [Pa]
  PHYSGEN_FUNCTION decltype(auto) lambda() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::lambda, Real>(Record::lambda);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.mu = mu();
    value.lambda = lambda();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    mu() = value.mu;
    lambda() = value.lambda;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Lame.
struct LameObject {
  static constexpr std::string_view name = "material::Lame";
  template <class Real>
  using Value = Lame<Real>;
  template <class Real, class Formats>
  using Record = LameRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = LameRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::mu, Real>(
        "mu", "Pa", LameRecord<Real, Formats>::mu, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::lambda, Real>(
        "lambda", "Pa", LameRecord<Real, Formats>::lambda, 1, 0.0),
  }};
  template <class Space>
  using Formats = LameFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = LameProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<LameObject, Space>>
using LameView = physgen::View<LameObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<LameObject, Space>>
using LameArray = physgen::Array<LameObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<LameObject, float, LameFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<LameObject, double, LameFormats<physgen::Host>>(16, 8, {0, 8}));

// ---- Fibre ----------------------------------------------------------------------------------------------------------

/// One family of fibres.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Fibre {
  /// Unit vector along the fibre.
  Eigen::Matrix<physgen::same_lanes_t<Real, float>, 3, 1> direction;
  /// [Pa]
  physgen::same_lanes_t<Real, double> strength;
};

/// How the fields of one Fibre are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of FibreArray.
template <class Space>
struct FibreFormats {
  using direction = physgen::format::Native;
  using strength = physgen::format::Native;
};

struct FibreObject;
/// FibreFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see <physgen/probe.h>.
/// The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = FibreFormats<physgen::Host>, class Object = FibreObject, int first = 0>
struct FibreProbe {
  using array_ = ArrayTag;
  using direction = physgen::Probe<ArrayTag, Object, first + 0, typename Base::direction>;
  using strength = physgen::Probe<ArrayTag, Object, first + 1, typename Base::strength>;
};

/// Where each field begins in the record of one Fibre [bytes].
template <class Real, class Formats>
struct FibreRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Vector<3>, typename Formats::direction, float>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::strength, double>(),
  }});
  static constexpr int direction = plan_.offset[0];
  static constexpr int strength = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Fibre of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class FibreRef {
  using Record = FibreRecord<Real, Formats>;

 public:
  using Value = Fibre<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit FibreRef(const Cursor& cursor) : at_(cursor) {}
  FibreRef(const FibreRef&) = default;
  FibreRef& operator=(const FibreRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const FibreRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Unit vector along the fibre.
  PHYSGEN_FUNCTION decltype(auto) direction() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::direction, float>(Record::direction);
  }
  /// [Pa]
  PHYSGEN_FUNCTION decltype(auto) strength() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::strength, double>(Record::strength);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.direction = direction().get();
    value.strength = strength();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    direction() = value.direction;
    strength() = value.strength;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Fibre.
struct FibreObject {
  static constexpr std::string_view name = "material::Fibre";
  template <class Real>
  using Value = Fibre<Real>;
  template <class Real, class Formats>
  using Record = FibreRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = FibreRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::direction, float>(
        "direction", "", FibreRecord<Real, Formats>::direction, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::strength, double>(
        "strength", "Pa", FibreRecord<Real, Formats>::strength, 1, 0.0),
  }};
  template <class Space>
  using Formats = FibreFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = FibreProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<FibreObject, Space>>
using FibreView = physgen::View<FibreObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<FibreObject, Space>>
using FibreArray = physgen::Array<FibreObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<FibreObject, float, FibreFormats<physgen::Host>>(20, 8, {8, 0}));
static_assert(physgen::is_sound_record<FibreObject, double, FibreFormats<physgen::Host>>(20, 8, {8, 0}));

}  // namespace material

#endif  // PHYSGEN_MATERIALS_H_66B56C20E9066756
