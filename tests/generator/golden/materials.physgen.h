// Accessor classes of the object types in materials.h. Written by physgen: change the schema, not this file.
#pragma once

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 1
#error "materials.physgen.h is for version 1 of the physgen runtime: generate it again with the installed physgen"
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

/// Where each field begins in the record of one Lame [bytes].
template <class Real>
struct LameRecord {
  static constexpr int mu = 0;
  static constexpr int lambda = sizeof(Real);
  static constexpr int bytes = 2 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One Lame of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class LameRef {
  using Record = LameRecord<Real>;

 public:
  using Value = Lame<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit LameRef(const Cursor& cursor) : at_(cursor) {}

  /// Shear modulus. [Pa]
  PHYSGEN_FUNCTION decltype(auto) mu() const { return at_.template element<Real>(Record::mu); }
  /// [Pa]
  PHYSGEN_FUNCTION decltype(auto) lambda() const { return at_.template element<Real>(Record::lambda); }

  PHYSGEN_FUNCTION Value get() const {
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
  template <class Real>
  using Record = LameRecord<Real>;
  template <class Real, class Cursor>
  using Ref = LameRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
      {"mu", "Pa", physgen::element_type<Real>, LameRecord<Real>::mu, 1, 0},
      {"lambda", "Pa", physgen::element_type<Real>, LameRecord<Real>::lambda, 1, 0},
  }};
};

template <class Real, class Layout>
using LameView = physgen::View<LameObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using LameArray = physgen::Array<LameObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<LameObject, float>(8, 4));
static_assert(physgen::is_sound_record<LameObject, double>(16, 8));

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

/// Where each field begins in the record of one Fibre [bytes].
template <class Real>
struct FibreRecord {
  static constexpr int strength = 0;
  static constexpr int direction = 8;
  static constexpr int bytes = 20;
  static constexpr int alignment = 8;
};

/// One Fibre of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class FibreRef {
  using Record = FibreRecord<Real>;

 public:
  using Value = Fibre<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit FibreRef(const Cursor& cursor) : at_(cursor) {}

  /// Unit vector along the fibre.
  PHYSGEN_FUNCTION decltype(auto) direction() const {
    return at_.template field<physgen::shape::Vector<3>, float>(Record::direction);
  }
  /// [Pa]
  PHYSGEN_FUNCTION decltype(auto) strength() const { return at_.template element<double>(Record::strength); }

  PHYSGEN_FUNCTION Value get() const {
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
  template <class Real>
  using Record = FibreRecord<Real>;
  template <class Real, class Cursor>
  using Ref = FibreRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
      {"direction", "", physgen::ElementType::float32, FibreRecord<Real>::direction, 3, 0},
      {"strength", "Pa", physgen::ElementType::float64, FibreRecord<Real>::strength, 1, 0},
  }};
};

template <class Real, class Layout>
using FibreView = physgen::View<FibreObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using FibreArray = physgen::Array<FibreObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<FibreObject, float>(20, 8));
static_assert(physgen::is_sound_record<FibreObject, double>(20, 8));

}  // namespace material
