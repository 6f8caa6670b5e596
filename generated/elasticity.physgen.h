// Accessor classes of the object types in elasticity.h. Written by physgen: change the schema, not this file.
#pragma once

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 1
#error "elasticity.physgen.h is for version 1 of the physgen runtime: generate it again with the installed physgen"
#endif

namespace elasticity {

// ---- DeformationGradient --------------------------------------------------------------------------------------------

/// Deformation gradient of one element, F = Ds Dm^-1.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct DeformationGradient {
  /// current over rest shape; the identity at rest [1]
  Eigen::Matrix<Real, 3, 3> F;
};

/// Where each field begins in the record of one DeformationGradient [bytes].
template <class Real>
struct DeformationGradientRecord {
  static constexpr int F = 0;
  static constexpr int bytes = 9 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One DeformationGradient of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class DeformationGradientRef {
  using Record = DeformationGradientRecord<Real>;

 public:
  using Value = DeformationGradient<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit DeformationGradientRef(const Cursor& cursor) : at_(cursor) {}

  /// current over rest shape; the identity at rest [1]
  PHYSGEN_FUNCTION decltype(auto) F() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::F);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.F = F().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { F() = value.F; }

 private:
  Cursor at_;
};

/// What the runtime knows of DeformationGradient.
struct DeformationGradientObject {
  static constexpr std::string_view name = "elasticity::DeformationGradient";
  template <class Real>
  using Value = DeformationGradient<Real>;
  template <class Real>
  using Record = DeformationGradientRecord<Real>;
  template <class Real, class Cursor>
  using Ref = DeformationGradientRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"F", "1", physgen::element_type<Real>, DeformationGradientRecord<Real>::F, 9, 0},
  }};
};

template <class Real, class Layout>
using DeformationGradientView = physgen::View<DeformationGradientObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using DeformationGradientArray = physgen::Array<DeformationGradientObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<DeformationGradientObject, float>(36, 4));
static_assert(physgen::is_sound_record<DeformationGradientObject, double>(72, 8));

// ---- DeformationGradientDifferential --------------------------------------------------------------------------------

/// Differential of the deformation gradient.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct DeformationGradientDifferential {
  /// change of F along a displacement differential [1]
  Eigen::Matrix<Real, 3, 3> dF;
};

/// Where each field begins in the record of one DeformationGradientDifferential [bytes].
template <class Real>
struct DeformationGradientDifferentialRecord {
  static constexpr int dF = 0;
  static constexpr int bytes = 9 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One DeformationGradientDifferential of an array, or those under a SIMD index: fields by name, all of them by get and
/// put.
template <class Real, class Cursor>
class DeformationGradientDifferentialRef {
  using Record = DeformationGradientDifferentialRecord<Real>;

 public:
  using Value = DeformationGradientDifferential<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit DeformationGradientDifferentialRef(const Cursor& cursor) : at_(cursor) {}

  /// change of F along a displacement differential [1]
  PHYSGEN_FUNCTION decltype(auto) dF() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::dF);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.dF = dF().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { dF() = value.dF; }

 private:
  Cursor at_;
};

/// What the runtime knows of DeformationGradientDifferential.
struct DeformationGradientDifferentialObject {
  static constexpr std::string_view name = "elasticity::DeformationGradientDifferential";
  template <class Real>
  using Value = DeformationGradientDifferential<Real>;
  template <class Real>
  using Record = DeformationGradientDifferentialRecord<Real>;
  template <class Real, class Cursor>
  using Ref = DeformationGradientDifferentialRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"dF", "1", physgen::element_type<Real>, DeformationGradientDifferentialRecord<Real>::dF, 9, 0},
  }};
};

template <class Real, class Layout>
using DeformationGradientDifferentialView = physgen::View<DeformationGradientDifferentialObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using DeformationGradientDifferentialArray = physgen::Array<DeformationGradientDifferentialObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<DeformationGradientDifferentialObject, float>(36, 4));
static_assert(physgen::is_sound_record<DeformationGradientDifferentialObject, double>(72, 8));

// ---- DeformationSvd -------------------------------------------------------------------------------------------------

/// Rotation-variant SVD of the deformation gradient, F = U diag(s) V^T.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct DeformationSvd {
  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> U;
  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> V;
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  Eigen::Matrix<Real, 3, 1> s;
};

/// Where each field begins in the record of one DeformationSvd [bytes].
template <class Real>
struct DeformationSvdRecord {
  static constexpr int U = 0;
  static constexpr int V = 9 * sizeof(Real);
  static constexpr int s = 18 * sizeof(Real);
  static constexpr int bytes = 21 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One DeformationSvd of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class DeformationSvdRef {
  using Record = DeformationSvdRecord<Real>;

 public:
  using Value = DeformationSvd<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit DeformationSvdRef(const Cursor& cursor) : at_(cursor) {}

  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const { return at_.template field<physgen::shape::Rotation, Real>(Record::U); }
  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const { return at_.template field<physgen::shape::Rotation, Real>(Record::V); }
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const { return at_.template field<physgen::shape::Diagonal<3>, Real>(Record::s); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.U = U().get();
    value.V = V().get();
    value.s = s().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    U() = value.U;
    V() = value.V;
    s() = value.s;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of DeformationSvd.
struct DeformationSvdObject {
  static constexpr std::string_view name = "elasticity::DeformationSvd";
  template <class Real>
  using Value = DeformationSvd<Real>;
  template <class Real>
  using Record = DeformationSvdRecord<Real>;
  template <class Real, class Cursor>
  using Ref = DeformationSvdRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 3> fields = {{
      {"U", "", physgen::element_type<Real>, DeformationSvdRecord<Real>::U, 9, 0},
      {"V", "", physgen::element_type<Real>, DeformationSvdRecord<Real>::V, 9, 0},
      {"s", "1", physgen::element_type<Real>, DeformationSvdRecord<Real>::s, 3, 0},
  }};
};

template <class Real, class Layout>
using DeformationSvdView = physgen::View<DeformationSvdObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using DeformationSvdArray = physgen::Array<DeformationSvdObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<DeformationSvdObject, float>(84, 4));
static_assert(physgen::is_sound_record<DeformationSvdObject, double>(168, 8));

// ---- QuaternionSvd --------------------------------------------------------------------------------------------------

/// The same with the rotations as unit quaternions: 11 scalars instead of 21.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct QuaternionSvd {
  /// unit quaternions w, x, y, z of U and V, w >= 0
  Eigen::Matrix<Real, 4, 1> u;
  /// unit quaternions w, x, y, z of U and V, w >= 0
  Eigen::Matrix<Real, 4, 1> v;
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  Eigen::Matrix<Real, 3, 1> s;
};

/// Where each field begins in the record of one QuaternionSvd [bytes].
template <class Real>
struct QuaternionSvdRecord {
  static constexpr int u = 0;
  static constexpr int v = 4 * sizeof(Real);
  static constexpr int s = 8 * sizeof(Real);
  static constexpr int bytes = 11 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One QuaternionSvd of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class QuaternionSvdRef {
  using Record = QuaternionSvdRecord<Real>;

 public:
  using Value = QuaternionSvd<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit QuaternionSvdRef(const Cursor& cursor) : at_(cursor) {}

  /// unit quaternions w, x, y, z of U and V, w >= 0
  PHYSGEN_FUNCTION decltype(auto) u() const { return at_.template field<physgen::shape::Vector<4>, Real>(Record::u); }
  /// unit quaternions w, x, y, z of U and V, w >= 0
  PHYSGEN_FUNCTION decltype(auto) v() const { return at_.template field<physgen::shape::Vector<4>, Real>(Record::v); }
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const { return at_.template field<physgen::shape::Diagonal<3>, Real>(Record::s); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.u = u().get();
    value.v = v().get();
    value.s = s().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    u() = value.u;
    v() = value.v;
    s() = value.s;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of QuaternionSvd.
struct QuaternionSvdObject {
  static constexpr std::string_view name = "elasticity::QuaternionSvd";
  template <class Real>
  using Value = QuaternionSvd<Real>;
  template <class Real>
  using Record = QuaternionSvdRecord<Real>;
  template <class Real, class Cursor>
  using Ref = QuaternionSvdRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 3> fields = {{
      {"u", "", physgen::element_type<Real>, QuaternionSvdRecord<Real>::u, 4, 0},
      {"v", "", physgen::element_type<Real>, QuaternionSvdRecord<Real>::v, 4, 0},
      {"s", "1", physgen::element_type<Real>, QuaternionSvdRecord<Real>::s, 3, 0},
  }};
};

template <class Real, class Layout>
using QuaternionSvdView = physgen::View<QuaternionSvdObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using QuaternionSvdArray = physgen::Array<QuaternionSvdObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<QuaternionSvdObject, float>(44, 4));
static_assert(physgen::is_sound_record<QuaternionSvdObject, double>(88, 8));

// ---- PrincipalStretches ---------------------------------------------------------------------------------------------

/// Principal stretches of the deformation gradient alone.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PrincipalStretches {
  /// s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  Eigen::Matrix<Real, 3, 1> s;
};

/// Where each field begins in the record of one PrincipalStretches [bytes].
template <class Real>
struct PrincipalStretchesRecord {
  static constexpr int s = 0;
  static constexpr int bytes = 3 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One PrincipalStretches of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class PrincipalStretchesRef {
  using Record = PrincipalStretchesRecord<Real>;

 public:
  using Value = PrincipalStretches<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PrincipalStretchesRef(const Cursor& cursor) : at_(cursor) {}

  /// s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const { return at_.template field<physgen::shape::Diagonal<3>, Real>(Record::s); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.s = s().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { s() = value.s; }

 private:
  Cursor at_;
};

/// What the runtime knows of PrincipalStretches.
struct PrincipalStretchesObject {
  static constexpr std::string_view name = "elasticity::PrincipalStretches";
  template <class Real>
  using Value = PrincipalStretches<Real>;
  template <class Real>
  using Record = PrincipalStretchesRecord<Real>;
  template <class Real, class Cursor>
  using Ref = PrincipalStretchesRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"s", "1", physgen::element_type<Real>, PrincipalStretchesRecord<Real>::s, 3, 0},
  }};
};

template <class Real, class Layout>
using PrincipalStretchesView = physgen::View<PrincipalStretchesObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using PrincipalStretchesArray = physgen::Array<PrincipalStretchesObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<PrincipalStretchesObject, float>(12, 4));
static_assert(physgen::is_sound_record<PrincipalStretchesObject, double>(24, 8));

// ---- ElementRotation ------------------------------------------------------------------------------------------------

/// A rotation: the polar factor R = U V^T of the deformation gradient, or principal directions by themselves.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct ElementRotation {
  /// det R = 1. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> R;
};

/// Where each field begins in the record of one ElementRotation [bytes].
template <class Real>
struct ElementRotationRecord {
  static constexpr int R = 0;
  static constexpr int bytes = 9 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One ElementRotation of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class ElementRotationRef {
  using Record = ElementRotationRecord<Real>;

 public:
  using Value = ElementRotation<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit ElementRotationRef(const Cursor& cursor) : at_(cursor) {}

  /// det R = 1. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) R() const { return at_.template field<physgen::shape::Rotation, Real>(Record::R); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.R = R().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { R() = value.R; }

 private:
  Cursor at_;
};

/// What the runtime knows of ElementRotation.
struct ElementRotationObject {
  static constexpr std::string_view name = "elasticity::ElementRotation";
  template <class Real>
  using Value = ElementRotation<Real>;
  template <class Real>
  using Record = ElementRotationRecord<Real>;
  template <class Real, class Cursor>
  using Ref = ElementRotationRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"R", "", physgen::element_type<Real>, ElementRotationRecord<Real>::R, 9, 0},
  }};
};

template <class Real, class Layout>
using ElementRotationView = physgen::View<ElementRotationObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using ElementRotationArray = physgen::Array<ElementRotationObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<ElementRotationObject, float>(36, 4));
static_assert(physgen::is_sound_record<ElementRotationObject, double>(72, 8));

// ---- StressDerivative -----------------------------------------------------------------------------------------------

/// Isotropic stress derivative in principal axes (12 scalars): x_iikk = d2psi/(ds_i ds_k), and for the pairs (a,b) =
/// (2,1), (3,1), (3,2) the entries x_abab and x_abba.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct StressDerivative {
  /// stretch: the symmetric 3x3 block [Pa]
  Real x1111;
  /// stretch: the symmetric 3x3 block [Pa]
  Real x2211;
  /// stretch: the symmetric 3x3 block [Pa]
  Real x3311;
  /// stretch: the symmetric 3x3 block [Pa]
  Real x2222;
  /// stretch: the symmetric 3x3 block [Pa]
  Real x3322;
  /// stretch: the symmetric 3x3 block [Pa]
  Real x3333;
  /// shear: one 2x2 block per pair [Pa]
  Real x2121;
  /// shear: one 2x2 block per pair [Pa]
  Real x2112;
  /// shear: one 2x2 block per pair [Pa]
  Real x3131;
  /// shear: one 2x2 block per pair [Pa]
  Real x3113;
  /// shear: one 2x2 block per pair [Pa]
  Real x3232;
  /// shear: one 2x2 block per pair [Pa]
  Real x3223;
};

/// Where each field begins in the record of one StressDerivative [bytes].
template <class Real>
struct StressDerivativeRecord {
  static constexpr int x1111 = 0;
  static constexpr int x2211 = sizeof(Real);
  static constexpr int x3311 = 2 * sizeof(Real);
  static constexpr int x2222 = 3 * sizeof(Real);
  static constexpr int x3322 = 4 * sizeof(Real);
  static constexpr int x3333 = 5 * sizeof(Real);
  static constexpr int x2121 = 6 * sizeof(Real);
  static constexpr int x2112 = 7 * sizeof(Real);
  static constexpr int x3131 = 8 * sizeof(Real);
  static constexpr int x3113 = 9 * sizeof(Real);
  static constexpr int x3232 = 10 * sizeof(Real);
  static constexpr int x3223 = 11 * sizeof(Real);
  static constexpr int bytes = 12 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One StressDerivative of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class StressDerivativeRef {
  using Record = StressDerivativeRecord<Real>;

 public:
  using Value = StressDerivative<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StressDerivativeRef(const Cursor& cursor) : at_(cursor) {}

  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x1111() const { return at_.template element<Real>(Record::x1111); }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2211() const { return at_.template element<Real>(Record::x2211); }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3311() const { return at_.template element<Real>(Record::x3311); }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2222() const { return at_.template element<Real>(Record::x2222); }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3322() const { return at_.template element<Real>(Record::x3322); }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3333() const { return at_.template element<Real>(Record::x3333); }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2121() const { return at_.template element<Real>(Record::x2121); }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2112() const { return at_.template element<Real>(Record::x2112); }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3131() const { return at_.template element<Real>(Record::x3131); }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3113() const { return at_.template element<Real>(Record::x3113); }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3232() const { return at_.template element<Real>(Record::x3232); }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3223() const { return at_.template element<Real>(Record::x3223); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.x1111 = x1111();
    value.x2211 = x2211();
    value.x3311 = x3311();
    value.x2222 = x2222();
    value.x3322 = x3322();
    value.x3333 = x3333();
    value.x2121 = x2121();
    value.x2112 = x2112();
    value.x3131 = x3131();
    value.x3113 = x3113();
    value.x3232 = x3232();
    value.x3223 = x3223();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    x1111() = value.x1111;
    x2211() = value.x2211;
    x3311() = value.x3311;
    x2222() = value.x2222;
    x3322() = value.x3322;
    x3333() = value.x3333;
    x2121() = value.x2121;
    x2112() = value.x2112;
    x3131() = value.x3131;
    x3113() = value.x3113;
    x3232() = value.x3232;
    x3223() = value.x3223;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of StressDerivative.
struct StressDerivativeObject {
  static constexpr std::string_view name = "elasticity::StressDerivative";
  template <class Real>
  using Value = StressDerivative<Real>;
  template <class Real>
  using Record = StressDerivativeRecord<Real>;
  template <class Real, class Cursor>
  using Ref = StressDerivativeRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 12> fields = {{
      {"x1111", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x1111, 1, 0},
      {"x2211", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x2211, 1, 0},
      {"x3311", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x3311, 1, 0},
      {"x2222", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x2222, 1, 0},
      {"x3322", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x3322, 1, 0},
      {"x3333", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x3333, 1, 0},
      {"x2121", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x2121, 1, 0},
      {"x2112", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x2112, 1, 0},
      {"x3131", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x3131, 1, 0},
      {"x3113", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x3113, 1, 0},
      {"x3232", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x3232, 1, 0},
      {"x3223", "Pa", physgen::element_type<Real>, StressDerivativeRecord<Real>::x3223, 1, 0},
  }};
};

template <class Real, class Layout>
using StressDerivativeView = physgen::View<StressDerivativeObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using StressDerivativeArray = physgen::Array<StressDerivativeObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<StressDerivativeObject, float>(48, 4));
static_assert(physgen::is_sound_record<StressDerivativeObject, double>(96, 8));

// ---- Stress ---------------------------------------------------------------------------------------------------------

/// First Piola-Kirchhoff stress of one element.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Stress {
  /// dpsi/dF: force in the current shape per area of the rest shape [Pa]
  Eigen::Matrix<Real, 3, 3> P;
};

/// Where each field begins in the record of one Stress [bytes].
template <class Real>
struct StressRecord {
  static constexpr int P = 0;
  static constexpr int bytes = 9 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One Stress of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class StressRef {
  using Record = StressRecord<Real>;

 public:
  using Value = Stress<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StressRef(const Cursor& cursor) : at_(cursor) {}

  /// dpsi/dF: force in the current shape per area of the rest shape [Pa]
  PHYSGEN_FUNCTION decltype(auto) P() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::P);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.P = P().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { P() = value.P; }

 private:
  Cursor at_;
};

/// What the runtime knows of Stress.
struct StressObject {
  static constexpr std::string_view name = "elasticity::Stress";
  template <class Real>
  using Value = Stress<Real>;
  template <class Real>
  using Record = StressRecord<Real>;
  template <class Real, class Cursor>
  using Ref = StressRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"P", "Pa", physgen::element_type<Real>, StressRecord<Real>::P, 9, 0},
  }};
};

template <class Real, class Layout>
using StressView = physgen::View<StressObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using StressArray = physgen::Array<StressObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<StressObject, float>(36, 4));
static_assert(physgen::is_sound_record<StressObject, double>(72, 8));

// ---- StressDifferential ---------------------------------------------------------------------------------------------

/// Differential of the first Piola-Kirchhoff stress.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct StressDifferential {
  /// change of P along dF [Pa]
  Eigen::Matrix<Real, 3, 3> dP;
};

/// Where each field begins in the record of one StressDifferential [bytes].
template <class Real>
struct StressDifferentialRecord {
  static constexpr int dP = 0;
  static constexpr int bytes = 9 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One StressDifferential of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class StressDifferentialRef {
  using Record = StressDifferentialRecord<Real>;

 public:
  using Value = StressDifferential<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StressDifferentialRef(const Cursor& cursor) : at_(cursor) {}

  /// change of P along dF [Pa]
  PHYSGEN_FUNCTION decltype(auto) dP() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::dP);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.dP = dP().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { dP() = value.dP; }

 private:
  Cursor at_;
};

/// What the runtime knows of StressDifferential.
struct StressDifferentialObject {
  static constexpr std::string_view name = "elasticity::StressDifferential";
  template <class Real>
  using Value = StressDifferential<Real>;
  template <class Real>
  using Record = StressDifferentialRecord<Real>;
  template <class Real, class Cursor>
  using Ref = StressDifferentialRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"dP", "Pa", physgen::element_type<Real>, StressDifferentialRecord<Real>::dP, 9, 0},
  }};
};

template <class Real, class Layout>
using StressDifferentialView = physgen::View<StressDifferentialObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using StressDifferentialArray = physgen::Array<StressDifferentialObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<StressDifferentialObject, float>(36, 4));
static_assert(physgen::is_sound_record<StressDifferentialObject, double>(72, 8));

// ---- RestShape ------------------------------------------------------------------------------------------------------

/// Rest shape of one tet.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct RestShape {
  /// Dm^-1, with Dm = [Xj-Xi, Xk-Xi, Xl-Xi] by columns [1/m]
  Eigen::Matrix<Real, 3, 3> dm_inverse;
  /// det(Dm) / 6, positive [m^3]
  Real volume;
};

/// Where each field begins in the record of one RestShape [bytes].
template <class Real>
struct RestShapeRecord {
  static constexpr int dm_inverse = 0;
  static constexpr int volume = 9 * sizeof(Real);
  static constexpr int bytes = 10 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One RestShape of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class RestShapeRef {
  using Record = RestShapeRecord<Real>;

 public:
  using Value = RestShape<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit RestShapeRef(const Cursor& cursor) : at_(cursor) {}

  /// Dm^-1, with Dm = [Xj-Xi, Xk-Xi, Xl-Xi] by columns [1/m]
  PHYSGEN_FUNCTION decltype(auto) dm_inverse() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::dm_inverse);
  }
  /// det(Dm) / 6, positive [m^3]
  PHYSGEN_FUNCTION decltype(auto) volume() const { return at_.template element<Real>(Record::volume); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.dm_inverse = dm_inverse().get();
    value.volume = volume();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    dm_inverse() = value.dm_inverse;
    volume() = value.volume;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of RestShape.
struct RestShapeObject {
  static constexpr std::string_view name = "elasticity::RestShape";
  template <class Real>
  using Value = RestShape<Real>;
  template <class Real>
  using Record = RestShapeRecord<Real>;
  template <class Real, class Cursor>
  using Ref = RestShapeRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
      {"dm_inverse", "1/m", physgen::element_type<Real>, RestShapeRecord<Real>::dm_inverse, 9, 0},
      {"volume", "m^3", physgen::element_type<Real>, RestShapeRecord<Real>::volume, 1, 0},
  }};
};

template <class Real, class Layout>
using RestShapeView = physgen::View<RestShapeObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using RestShapeArray = physgen::Array<RestShapeObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<RestShapeObject, float>(40, 4));
static_assert(physgen::is_sound_record<RestShapeObject, double>(80, 8));

// ---- CornerForces ---------------------------------------------------------------------------------------------------

/// Forces of one tet on its corners j, k, l, by columns; the force on i is minus their sum.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct CornerForces {
  /// G = -volume P Dm^-T [N]
  Eigen::Matrix<Real, 3, 3> G;
};

/// Where each field begins in the record of one CornerForces [bytes].
template <class Real>
struct CornerForcesRecord {
  static constexpr int G = 0;
  static constexpr int bytes = 9 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One CornerForces of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class CornerForcesRef {
  using Record = CornerForcesRecord<Real>;

 public:
  using Value = CornerForces<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit CornerForcesRef(const Cursor& cursor) : at_(cursor) {}

  /// G = -volume P Dm^-T [N]
  PHYSGEN_FUNCTION decltype(auto) G() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::G);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.G = G().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { G() = value.G; }

 private:
  Cursor at_;
};

/// What the runtime knows of CornerForces.
struct CornerForcesObject {
  static constexpr std::string_view name = "elasticity::CornerForces";
  template <class Real>
  using Value = CornerForces<Real>;
  template <class Real>
  using Record = CornerForcesRecord<Real>;
  template <class Real, class Cursor>
  using Ref = CornerForcesRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"G", "N", physgen::element_type<Real>, CornerForcesRecord<Real>::G, 9, 0},
  }};
};

template <class Real, class Layout>
using CornerForcesView = physgen::View<CornerForcesObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using CornerForcesArray = physgen::Array<CornerForcesObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<CornerForcesObject, float>(36, 4));
static_assert(physgen::is_sound_record<CornerForcesObject, double>(72, 8));

// ---- NodePosition ---------------------------------------------------------------------------------------------------

/// Current position of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodePosition {
  /// position [m]
  Eigen::Matrix<Real, 3, 1> x;
};

/// Where each field begins in the record of one NodePosition [bytes].
template <class Real>
struct NodePositionRecord {
  static constexpr int x = 0;
  static constexpr int bytes = 3 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One NodePosition of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class NodePositionRef {
  using Record = NodePositionRecord<Real>;

 public:
  using Value = NodePosition<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodePositionRef(const Cursor& cursor) : at_(cursor) {}

  /// position [m]
  PHYSGEN_FUNCTION decltype(auto) x() const { return at_.template field<physgen::shape::Vector<3>, Real>(Record::x); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.x = x().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { x() = value.x; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodePosition.
struct NodePositionObject {
  static constexpr std::string_view name = "elasticity::NodePosition";
  template <class Real>
  using Value = NodePosition<Real>;
  template <class Real>
  using Record = NodePositionRecord<Real>;
  template <class Real, class Cursor>
  using Ref = NodePositionRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"x", "m", physgen::element_type<Real>, NodePositionRecord<Real>::x, 3, 0},
  }};
};

template <class Real, class Layout>
using NodePositionView = physgen::View<NodePositionObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>>
using NodePositionArray = physgen::Array<NodePositionObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<NodePositionObject, float>(12, 4));
static_assert(physgen::is_sound_record<NodePositionObject, double>(24, 8));

// ---- NodeForce ------------------------------------------------------------------------------------------------------

/// Force on a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeForce {
  /// sum of the elements' forces on the node [N]
  Eigen::Matrix<Real, 3, 1> f;
};

/// Where each field begins in the record of one NodeForce [bytes].
template <class Real>
struct NodeForceRecord {
  static constexpr int f = 0;
  static constexpr int bytes = 3 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One NodeForce of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class NodeForceRef {
  using Record = NodeForceRecord<Real>;

 public:
  using Value = NodeForce<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeForceRef(const Cursor& cursor) : at_(cursor) {}

  /// sum of the elements' forces on the node [N]
  PHYSGEN_FUNCTION decltype(auto) f() const { return at_.template field<physgen::shape::Vector<3>, Real>(Record::f); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.f = f().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { f() = value.f; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeForce.
struct NodeForceObject {
  static constexpr std::string_view name = "elasticity::NodeForce";
  template <class Real>
  using Value = NodeForce<Real>;
  template <class Real>
  using Record = NodeForceRecord<Real>;
  template <class Real, class Cursor>
  using Ref = NodeForceRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"f", "N", physgen::element_type<Real>, NodeForceRecord<Real>::f, 3, 0},
  }};
};

template <class Real, class Layout>
using NodeForceView = physgen::View<NodeForceObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>>
using NodeForceArray = physgen::Array<NodeForceObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<NodeForceObject, float>(12, 4));
static_assert(physgen::is_sound_record<NodeForceObject, double>(24, 8));

// ---- NodeDisplacement -----------------------------------------------------------------------------------------------

/// Displacement differential of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeDisplacement {
  /// direction in which forces are differentiated [m]
  Eigen::Matrix<Real, 3, 1> dx;
};

/// Where each field begins in the record of one NodeDisplacement [bytes].
template <class Real>
struct NodeDisplacementRecord {
  static constexpr int dx = 0;
  static constexpr int bytes = 3 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One NodeDisplacement of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class NodeDisplacementRef {
  using Record = NodeDisplacementRecord<Real>;

 public:
  using Value = NodeDisplacement<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeDisplacementRef(const Cursor& cursor) : at_(cursor) {}

  /// direction in which forces are differentiated [m]
  PHYSGEN_FUNCTION decltype(auto) dx() const { return at_.template field<physgen::shape::Vector<3>, Real>(Record::dx); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.dx = dx().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { dx() = value.dx; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeDisplacement.
struct NodeDisplacementObject {
  static constexpr std::string_view name = "elasticity::NodeDisplacement";
  template <class Real>
  using Value = NodeDisplacement<Real>;
  template <class Real>
  using Record = NodeDisplacementRecord<Real>;
  template <class Real, class Cursor>
  using Ref = NodeDisplacementRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"dx", "m", physgen::element_type<Real>, NodeDisplacementRecord<Real>::dx, 3, 0},
  }};
};

template <class Real, class Layout>
using NodeDisplacementView = physgen::View<NodeDisplacementObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>>
using NodeDisplacementArray = physgen::Array<NodeDisplacementObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<NodeDisplacementObject, float>(12, 4));
static_assert(physgen::is_sound_record<NodeDisplacementObject, double>(24, 8));

// ---- NodeForceDifferential ------------------------------------------------------------------------------------------

/// Force differential of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeForceDifferential {
  /// change of the node's force along the displacement differential [N]
  Eigen::Matrix<Real, 3, 1> df;
};

/// Where each field begins in the record of one NodeForceDifferential [bytes].
template <class Real>
struct NodeForceDifferentialRecord {
  static constexpr int df = 0;
  static constexpr int bytes = 3 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One NodeForceDifferential of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class NodeForceDifferentialRef {
  using Record = NodeForceDifferentialRecord<Real>;

 public:
  using Value = NodeForceDifferential<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeForceDifferentialRef(const Cursor& cursor) : at_(cursor) {}

  /// change of the node's force along the displacement differential [N]
  PHYSGEN_FUNCTION decltype(auto) df() const { return at_.template field<physgen::shape::Vector<3>, Real>(Record::df); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.df = df().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { df() = value.df; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeForceDifferential.
struct NodeForceDifferentialObject {
  static constexpr std::string_view name = "elasticity::NodeForceDifferential";
  template <class Real>
  using Value = NodeForceDifferential<Real>;
  template <class Real>
  using Record = NodeForceDifferentialRecord<Real>;
  template <class Real, class Cursor>
  using Ref = NodeForceDifferentialRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"df", "N", physgen::element_type<Real>, NodeForceDifferentialRecord<Real>::df, 3, 0},
  }};
};

template <class Real, class Layout>
using NodeForceDifferentialView = physgen::View<NodeForceDifferentialObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>>
using NodeForceDifferentialArray = physgen::Array<NodeForceDifferentialObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<NodeForceDifferentialObject, float>(12, 4));
static_assert(physgen::is_sound_record<NodeForceDifferentialObject, double>(24, 8));

// ---- NodeStiffness --------------------------------------------------------------------------------------------------

/// Diagonal block of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeStiffness {
  /// df(v)/dx(v) [N/m]. Symmetric, 6 stored.
  Eigen::Matrix<Real, 3, 3> K;
};

/// Where each field begins in the record of one NodeStiffness [bytes].
template <class Real>
struct NodeStiffnessRecord {
  static constexpr int K = 0;
  static constexpr int bytes = 6 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One NodeStiffness of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class NodeStiffnessRef {
  using Record = NodeStiffnessRecord<Real>;

 public:
  using Value = NodeStiffness<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeStiffnessRef(const Cursor& cursor) : at_(cursor) {}

  /// df(v)/dx(v) [N/m]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) K() const {
    return at_.template field<physgen::shape::Symmetric<3>, Real>(Record::K);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.K = K().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { K() = value.K; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeStiffness.
struct NodeStiffnessObject {
  static constexpr std::string_view name = "elasticity::NodeStiffness";
  template <class Real>
  using Value = NodeStiffness<Real>;
  template <class Real>
  using Record = NodeStiffnessRecord<Real>;
  template <class Real, class Cursor>
  using Ref = NodeStiffnessRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"K", "N/m", physgen::element_type<Real>, NodeStiffnessRecord<Real>::K, 6, 0},
  }};
};

template <class Real, class Layout>
using NodeStiffnessView = physgen::View<NodeStiffnessObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using NodeStiffnessArray = physgen::Array<NodeStiffnessObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<NodeStiffnessObject, float>(24, 4));
static_assert(physgen::is_sound_record<NodeStiffnessObject, double>(48, 8));

// ---- EdgeStiffness --------------------------------------------------------------------------------------------------

/// Off-diagonal block of an edge (m,n). Nodes gather it, so on CUDA whole records are read: half the time of tiles.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct EdgeStiffness {
  /// df(m)/dx(n) [N/m]
  Eigen::Matrix<Real, 3, 3> E;
};

/// Where each field begins in the record of one EdgeStiffness [bytes].
template <class Real>
struct EdgeStiffnessRecord {
  static constexpr int E = 0;
  static constexpr int bytes = 9 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One EdgeStiffness of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class EdgeStiffnessRef {
  using Record = EdgeStiffnessRecord<Real>;

 public:
  using Value = EdgeStiffness<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit EdgeStiffnessRef(const Cursor& cursor) : at_(cursor) {}

  /// df(m)/dx(n) [N/m]
  PHYSGEN_FUNCTION decltype(auto) E() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::E);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.E = E().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { E() = value.E; }

 private:
  Cursor at_;
};

/// What the runtime knows of EdgeStiffness.
struct EdgeStiffnessObject {
  static constexpr std::string_view name = "elasticity::EdgeStiffness";
  template <class Real>
  using Value = EdgeStiffness<Real>;
  template <class Real>
  using Record = EdgeStiffnessRecord<Real>;
  template <class Real, class Cursor>
  using Ref = EdgeStiffnessRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"E", "N/m", physgen::element_type<Real>, EdgeStiffnessRecord<Real>::E, 9, 0},
  }};
};

template <class Real, class Layout>
using EdgeStiffnessView = physgen::View<EdgeStiffnessObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aos>>
using EdgeStiffnessArray = physgen::Array<EdgeStiffnessObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<EdgeStiffnessObject, float>(36, 4));
static_assert(physgen::is_sound_record<EdgeStiffnessObject, double>(72, 8));

// ---- TetStiffness ---------------------------------------------------------------------------------------------------

/// Blocks of one tet, before the sums over the tets of a node and of an edge.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct TetStiffness {
  /// corners i, j, k, l [N/m]. Symmetric, 6 stored.
  Eigen::Matrix<Real, 3, 3> k[4];
  /// edges ij, ik, il, jk, jl, kl: df(first)/dx(second) [N/m]
  Eigen::Matrix<Real, 3, 3> e[6];
};

/// Where each field begins in the record of one TetStiffness [bytes].
template <class Real>
struct TetStiffnessRecord {
  static constexpr int k = 0;
  static constexpr int e = 24 * sizeof(Real);
  static constexpr int bytes = 78 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One TetStiffness of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class TetStiffnessRef {
  using Record = TetStiffnessRecord<Real>;

 public:
  using Value = TetStiffness<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit TetStiffnessRef(const Cursor& cursor) : at_(cursor) {}

  /// corners i, j, k, l [N/m]. Symmetric, 6 stored.
  /// @pre 0 <= entry < 4
  PHYSGEN_FUNCTION decltype(auto) k(int entry) const {
    return at_.template field<physgen::shape::Symmetric<3>, Real>(Record::k + entry * int{6 * sizeof(Real)});
  }
  /// edges ij, ik, il, jk, jl, kl: df(first)/dx(second) [N/m]
  /// @pre 0 <= entry < 6
  PHYSGEN_FUNCTION decltype(auto) e(int entry) const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::e + entry * int{9 * sizeof(Real)});
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 4; ++entry) value.k[entry] = k(entry).get();
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 6; ++entry) value.e[entry] = e(entry).get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 4; ++entry) k(entry) = value.k[entry];
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 6; ++entry) e(entry) = value.e[entry];
  }

 private:
  Cursor at_;
};

/// What the runtime knows of TetStiffness.
struct TetStiffnessObject {
  static constexpr std::string_view name = "elasticity::TetStiffness";
  template <class Real>
  using Value = TetStiffness<Real>;
  template <class Real>
  using Record = TetStiffnessRecord<Real>;
  template <class Real, class Cursor>
  using Ref = TetStiffnessRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
      {"k", "N/m", physgen::element_type<Real>, TetStiffnessRecord<Real>::k, 24, 0},
      {"e", "N/m", physgen::element_type<Real>, TetStiffnessRecord<Real>::e, 54, 0},
  }};
};

template <class Real, class Layout>
using TetStiffnessView = physgen::View<TetStiffnessObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using TetStiffnessArray = physgen::Array<TetStiffnessObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<TetStiffnessObject, float>(312, 4));
static_assert(physgen::is_sound_record<TetStiffnessObject, double>(624, 8));

// ---- Tet ------------------------------------------------------------------------------------------------------------

/// Nodes of a tet.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Tet {
  /// corners i, j, k, l; det(Dm) > 0
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> nodes;
};

/// Where each field begins in the record of one Tet [bytes].
template <class Real>
struct TetRecord {
  static constexpr int nodes = 0;
  static constexpr int bytes = 16;
  static constexpr int alignment = 4;
};

/// One Tet of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class TetRef {
  using Record = TetRecord<Real>;

 public:
  using Value = Tet<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit TetRef(const Cursor& cursor) : at_(cursor) {}

  /// corners i, j, k, l; det(Dm) > 0
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return at_.template field<physgen::shape::Vector<4>, std::int32_t>(Record::nodes);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.nodes = nodes().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { nodes() = value.nodes; }

 private:
  Cursor at_;
};

/// What the runtime knows of Tet.
struct TetObject {
  static constexpr std::string_view name = "elasticity::Tet";
  template <class Real>
  using Value = Tet<Real>;
  template <class Real>
  using Record = TetRecord<Real>;
  template <class Real, class Cursor>
  using Ref = TetRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"nodes", "", physgen::ElementType::int32, TetRecord<Real>::nodes, 4, 0},
  }};
};

template <class Real, class Layout>
using TetView = physgen::View<TetObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using TetArray = physgen::Array<TetObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<TetObject, float>(16, 4));
static_assert(physgen::is_sound_record<TetObject, double>(16, 4));

// ---- Edge -----------------------------------------------------------------------------------------------------------

/// Nodes of an edge.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Edge {
  /// m and n: the block of the edge is df(m)/dx(n)
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> nodes;
};

/// Where each field begins in the record of one Edge [bytes].
template <class Real>
struct EdgeRecord {
  static constexpr int nodes = 0;
  static constexpr int bytes = 8;
  static constexpr int alignment = 4;
};

/// One Edge of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class EdgeRef {
  using Record = EdgeRecord<Real>;

 public:
  using Value = Edge<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit EdgeRef(const Cursor& cursor) : at_(cursor) {}

  /// m and n: the block of the edge is df(m)/dx(n)
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return at_.template field<physgen::shape::Vector<2>, std::int32_t>(Record::nodes);
  }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.nodes = nodes().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { nodes() = value.nodes; }

 private:
  Cursor at_;
};

/// What the runtime knows of Edge.
struct EdgeObject {
  static constexpr std::string_view name = "elasticity::Edge";
  template <class Real>
  using Value = Edge<Real>;
  template <class Real>
  using Record = EdgeRecord<Real>;
  template <class Real, class Cursor>
  using Ref = EdgeRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
      {"nodes", "", physgen::ElementType::int32, EdgeRecord<Real>::nodes, 2, 0},
  }};
};

template <class Real, class Layout>
using EdgeView = physgen::View<EdgeObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using EdgeArray = physgen::Array<EdgeObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<EdgeObject, float>(8, 4));
static_assert(physgen::is_sound_record<EdgeObject, double>(8, 4));

// ---- IncidenceRange -------------------------------------------------------------------------------------------------

/// The incidences of one node or edge: entries begin up to, not including, end of an array of Incidence.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct IncidenceRange {
  /// half-open range
  physgen::same_lanes_t<Real, std::int32_t> begin;
  /// half-open range
  physgen::same_lanes_t<Real, std::int32_t> end;
};

/// Where each field begins in the record of one IncidenceRange [bytes].
template <class Real>
struct IncidenceRangeRecord {
  static constexpr int begin = 0;
  static constexpr int end = 4;
  static constexpr int bytes = 8;
  static constexpr int alignment = 4;
};

/// One IncidenceRange of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class IncidenceRangeRef {
  using Record = IncidenceRangeRecord<Real>;

 public:
  using Value = IncidenceRange<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit IncidenceRangeRef(const Cursor& cursor) : at_(cursor) {}

  /// half-open range
  PHYSGEN_FUNCTION decltype(auto) begin() const { return at_.template element<std::int32_t>(Record::begin); }
  /// half-open range
  PHYSGEN_FUNCTION decltype(auto) end() const { return at_.template element<std::int32_t>(Record::end); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.begin = begin();
    value.end = end();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    begin() = value.begin;
    end() = value.end;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of IncidenceRange.
struct IncidenceRangeObject {
  static constexpr std::string_view name = "elasticity::IncidenceRange";
  template <class Real>
  using Value = IncidenceRange<Real>;
  template <class Real>
  using Record = IncidenceRangeRecord<Real>;
  template <class Real, class Cursor>
  using Ref = IncidenceRangeRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
      {"begin", "", physgen::ElementType::int32, IncidenceRangeRecord<Real>::begin, 1, 0},
      {"end", "", physgen::ElementType::int32, IncidenceRangeRecord<Real>::end, 1, 0},
  }};
};

template <class Real, class Layout>
using IncidenceRangeView = physgen::View<IncidenceRangeObject, Real, Layout>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>>
using IncidenceRangeArray = physgen::Array<IncidenceRangeObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<IncidenceRangeObject, float>(8, 4));
static_assert(physgen::is_sound_record<IncidenceRangeObject, double>(8, 4));

// ---- Incidence ------------------------------------------------------------------------------------------------------

/// An element that touches a node or an edge.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Incidence {
  /// which tet, or which edge
  physgen::same_lanes_t<Real, std::int32_t> element;
  /// which of its corners, or of its edges, it is
  physgen::same_lanes_t<Real, std::int32_t> local;
};

/// Where each field begins in the record of one Incidence [bytes].
template <class Real>
struct IncidenceRecord {
  static constexpr int element = 0;
  static constexpr int local = 4;
  static constexpr int bytes = 8;
  static constexpr int alignment = 4;
};

/// One Incidence of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class IncidenceRef {
  using Record = IncidenceRecord<Real>;

 public:
  using Value = Incidence<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit IncidenceRef(const Cursor& cursor) : at_(cursor) {}

  /// which tet, or which edge
  PHYSGEN_FUNCTION decltype(auto) element() const { return at_.template element<std::int32_t>(Record::element); }
  /// which of its corners, or of its edges, it is
  PHYSGEN_FUNCTION decltype(auto) local() const { return at_.template element<std::int32_t>(Record::local); }

  PHYSGEN_FUNCTION Value get() const {
    Value value;
    value.element = element();
    value.local = local();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    element() = value.element;
    local() = value.local;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Incidence.
struct IncidenceObject {
  static constexpr std::string_view name = "elasticity::Incidence";
  template <class Real>
  using Value = Incidence<Real>;
  template <class Real>
  using Record = IncidenceRecord<Real>;
  template <class Real, class Cursor>
  using Ref = IncidenceRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
      {"element", "", physgen::ElementType::int32, IncidenceRecord<Real>::element, 1, 0},
      {"local", "", physgen::ElementType::int32, IncidenceRecord<Real>::local, 1, 0},
  }};
};

template <class Real, class Layout>
using IncidenceView = physgen::View<IncidenceObject, Real, Layout>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>>
using IncidenceArray = physgen::Array<IncidenceObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<IncidenceObject, float>(8, 4));
static_assert(physgen::is_sound_record<IncidenceObject, double>(8, 4));

}  // namespace elasticity
