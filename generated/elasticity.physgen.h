// Accessor classes of the object types in elasticity.h. Written by physgen: change the schema, not this file.
#ifndef PHYSGEN_ELASTICITY_H_B477B507AEEAB8D9
#define PHYSGEN_ELASTICITY_H_B477B507AEEAB8D9

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 4
#error "elasticity.physgen.h is for version 4 of the physgen runtime: generate it again with the installed physgen"
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

/// How the fields of one DeformationGradient are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of DeformationGradientArray.
template <class Space>
struct DeformationGradientFormats {
  using F = physgen::format::Native;
};

struct DeformationGradientObject;
/// DeformationGradientFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = DeformationGradientFormats<physgen::Host>,
          class Object = DeformationGradientObject, int first = 0>
struct DeformationGradientProbe {
  using array_ = ArrayTag;
  using F = physgen::Probe<ArrayTag, Object, first + 0, typename Base::F>;
};

/// Where each field begins in the record of one DeformationGradient [bytes].
template <class Real, class Formats>
struct DeformationGradientRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(),
  }});
  static constexpr int F = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One DeformationGradient of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class DeformationGradientRef {
  using Record = DeformationGradientRecord<Real, Formats>;

 public:
  using Value = DeformationGradient<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit DeformationGradientRef(const Cursor& cursor) : at_(cursor) {}
  DeformationGradientRef(const DeformationGradientRef&) = default;
  DeformationGradientRef& operator=(const DeformationGradientRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const DeformationGradientRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// current over rest shape; the identity at rest [1]
  PHYSGEN_FUNCTION decltype(auto) F() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(Record::F);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = DeformationGradientRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = DeformationGradientRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(
        "F", "1", DeformationGradientRecord<Real, Formats>::F, 1, 0.0),
  }};
  template <class Space>
  using Formats = DeformationGradientFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = DeformationGradientProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<DeformationGradientObject, Space>>
using DeformationGradientView = physgen::View<DeformationGradientObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<DeformationGradientObject, Space>>
using DeformationGradientArray = physgen::Array<DeformationGradientObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<DeformationGradientObject, float, DeformationGradientFormats<physgen::Host>>(
    36, 4, {0}));
static_assert(physgen::is_sound_record<DeformationGradientObject, double, DeformationGradientFormats<physgen::Host>>(
    72, 8, {0}));

// ---- DeformationGradientDifferential --------------------------------------------------------------------------------

/// Differential of the deformation gradient.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct DeformationGradientDifferential {
  /// change of F along a displacement differential [1]
  Eigen::Matrix<Real, 3, 3> dF;
};

/// How the fields of one DeformationGradientDifferential are stored in a memory space. To store some otherwise, derive
/// from it, declare those anew, and name the derived struct as the last argument of
/// DeformationGradientDifferentialArray.
template <class Space>
struct DeformationGradientDifferentialFormats {
  using dF = physgen::format::Native;
};

struct DeformationGradientDifferentialObject;
/// DeformationGradientDifferentialFormats whose reads and writes are told apart for the array that the tag ArrayTag
/// names; see <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = DeformationGradientDifferentialFormats<physgen::Host>,
          class Object = DeformationGradientDifferentialObject, int first = 0>
struct DeformationGradientDifferentialProbe {
  using array_ = ArrayTag;
  using dF = physgen::Probe<ArrayTag, Object, first + 0, typename Base::dF>;
};

/// Where each field begins in the record of one DeformationGradientDifferential [bytes].
template <class Real, class Formats>
struct DeformationGradientDifferentialRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::dF, Real>(),
  }});
  static constexpr int dF = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One DeformationGradientDifferential of an array, or those under a SIMD index: fields by name, all of them by get and
/// put.
template <class Real, class Formats, class Cursor>
class DeformationGradientDifferentialRef {
  using Record = DeformationGradientDifferentialRecord<Real, Formats>;

 public:
  using Value = DeformationGradientDifferential<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit DeformationGradientDifferentialRef(const Cursor& cursor) : at_(cursor) {}
  DeformationGradientDifferentialRef(const DeformationGradientDifferentialRef&) = default;
  DeformationGradientDifferentialRef& operator=(const DeformationGradientDifferentialRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const DeformationGradientDifferentialRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// change of F along a displacement differential [1]
  PHYSGEN_FUNCTION decltype(auto) dF() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::dF, Real>(Record::dF);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = DeformationGradientDifferentialRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = DeformationGradientDifferentialRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::dF, Real>(
        "dF", "1", DeformationGradientDifferentialRecord<Real, Formats>::dF, 1, 0.0),
  }};
  template <class Space>
  using Formats = DeformationGradientDifferentialFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = DeformationGradientDifferentialProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<DeformationGradientDifferentialObject, Space>>
using DeformationGradientDifferentialView = physgen::View<DeformationGradientDifferentialObject, Real, Layout, Formats,
    Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<DeformationGradientDifferentialObject, Space>>
using DeformationGradientDifferentialArray = physgen::Array<DeformationGradientDifferentialObject, Real, Space, Layout,
    Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<DeformationGradientDifferentialObject, float,
    DeformationGradientDifferentialFormats<physgen::Host>>(
    36, 4, {0}));
static_assert(physgen::is_sound_record<DeformationGradientDifferentialObject, double,
    DeformationGradientDifferentialFormats<physgen::Host>>(
    72, 8, {0}));

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

/// How the fields of one DeformationSvd are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of DeformationSvdArray.
template <class Space>
struct DeformationSvdFormats {
  using U = physgen::format::Native;
  using V = physgen::format::Native;
  using s = physgen::format::Native;
};

struct DeformationSvdObject;
/// DeformationSvdFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = DeformationSvdFormats<physgen::Host>, class Object = DeformationSvdObject,
          int first = 0>
struct DeformationSvdProbe {
  using array_ = ArrayTag;
  using U = physgen::Probe<ArrayTag, Object, first + 0, typename Base::U>;
  using V = physgen::Probe<ArrayTag, Object, first + 1, typename Base::V>;
  using s = physgen::Probe<ArrayTag, Object, first + 2, typename Base::s>;
};

/// Where each field begins in the record of one DeformationSvd [bytes].
template <class Real, class Formats>
struct DeformationSvdRecord {
  static constexpr auto plan_ = physgen::plan_record<3>({{
    physgen::slot<physgen::shape::Rotation, typename Formats::U, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::V, Real>(),
    physgen::slot<physgen::shape::Diagonal<3>, typename Formats::s, Real>(),
  }});
  static constexpr int U = plan_.offset[0];
  static constexpr int V = plan_.offset[1];
  static constexpr int s = plan_.offset[2];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One DeformationSvd of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class DeformationSvdRef {
  using Record = DeformationSvdRecord<Real, Formats>;

 public:
  using Value = DeformationSvd<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit DeformationSvdRef(const Cursor& cursor) : at_(cursor) {}
  DeformationSvdRef(const DeformationSvdRef&) = default;
  DeformationSvdRef& operator=(const DeformationSvdRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const DeformationSvdRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::U, Real>(Record::U);
  }
  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::V, Real>(Record::V);
  }
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const {
    return at_.template field<physgen::shape::Diagonal<3>, typename Formats::s, Real>(Record::s);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = DeformationSvdRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = DeformationSvdRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 3> fields = {{
    physgen::field_info<physgen::shape::Rotation, typename Formats::U, Real>(
        "U", "", DeformationSvdRecord<Real, Formats>::U, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::V, Real>(
        "V", "", DeformationSvdRecord<Real, Formats>::V, 1, 0.0),
    physgen::field_info<physgen::shape::Diagonal<3>, typename Formats::s, Real>(
        "s", "1", DeformationSvdRecord<Real, Formats>::s, 1, 0.0),
  }};
  template <class Space>
  using Formats = DeformationSvdFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = DeformationSvdProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<DeformationSvdObject, Space>>
using DeformationSvdView = physgen::View<DeformationSvdObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<DeformationSvdObject, Space>>
using DeformationSvdArray = physgen::Array<DeformationSvdObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<DeformationSvdObject, float, DeformationSvdFormats<physgen::Host>>(
    84, 4, {0, 36, 72}));
static_assert(physgen::is_sound_record<DeformationSvdObject, double, DeformationSvdFormats<physgen::Host>>(
    168, 8, {0, 72, 144}));

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

/// How the fields of one QuaternionSvd are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of QuaternionSvdArray.
template <class Space>
struct QuaternionSvdFormats {
  using u = physgen::format::Native;
  using v = physgen::format::Native;
  using s = physgen::format::Native;
};

struct QuaternionSvdObject;
/// QuaternionSvdFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = QuaternionSvdFormats<physgen::Host>, class Object = QuaternionSvdObject,
          int first = 0>
struct QuaternionSvdProbe {
  using array_ = ArrayTag;
  using u = physgen::Probe<ArrayTag, Object, first + 0, typename Base::u>;
  using v = physgen::Probe<ArrayTag, Object, first + 1, typename Base::v>;
  using s = physgen::Probe<ArrayTag, Object, first + 2, typename Base::s>;
};

/// Where each field begins in the record of one QuaternionSvd [bytes].
template <class Real, class Formats>
struct QuaternionSvdRecord {
  static constexpr auto plan_ = physgen::plan_record<3>({{
    physgen::slot<physgen::shape::Vector<4>, typename Formats::u, Real>(),
    physgen::slot<physgen::shape::Vector<4>, typename Formats::v, Real>(),
    physgen::slot<physgen::shape::Diagonal<3>, typename Formats::s, Real>(),
  }});
  static constexpr int u = plan_.offset[0];
  static constexpr int v = plan_.offset[1];
  static constexpr int s = plan_.offset[2];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One QuaternionSvd of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class QuaternionSvdRef {
  using Record = QuaternionSvdRecord<Real, Formats>;

 public:
  using Value = QuaternionSvd<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit QuaternionSvdRef(const Cursor& cursor) : at_(cursor) {}
  QuaternionSvdRef(const QuaternionSvdRef&) = default;
  QuaternionSvdRef& operator=(const QuaternionSvdRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const QuaternionSvdRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// unit quaternions w, x, y, z of U and V, w >= 0
  PHYSGEN_FUNCTION decltype(auto) u() const {
    return at_.template field<physgen::shape::Vector<4>, typename Formats::u, Real>(Record::u);
  }
  /// unit quaternions w, x, y, z of U and V, w >= 0
  PHYSGEN_FUNCTION decltype(auto) v() const {
    return at_.template field<physgen::shape::Vector<4>, typename Formats::v, Real>(Record::v);
  }
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const {
    return at_.template field<physgen::shape::Diagonal<3>, typename Formats::s, Real>(Record::s);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = QuaternionSvdRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = QuaternionSvdRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 3> fields = {{
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::u, Real>(
        "u", "", QuaternionSvdRecord<Real, Formats>::u, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::v, Real>(
        "v", "", QuaternionSvdRecord<Real, Formats>::v, 1, 0.0),
    physgen::field_info<physgen::shape::Diagonal<3>, typename Formats::s, Real>(
        "s", "1", QuaternionSvdRecord<Real, Formats>::s, 1, 0.0),
  }};
  template <class Space>
  using Formats = QuaternionSvdFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = QuaternionSvdProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<QuaternionSvdObject, Space>>
using QuaternionSvdView = physgen::View<QuaternionSvdObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<QuaternionSvdObject, Space>>
using QuaternionSvdArray = physgen::Array<QuaternionSvdObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<QuaternionSvdObject, float, QuaternionSvdFormats<physgen::Host>>(
    44, 4, {0, 16, 32}));
static_assert(physgen::is_sound_record<QuaternionSvdObject, double, QuaternionSvdFormats<physgen::Host>>(
    88, 8, {0, 32, 64}));

// ---- PrincipalDirections --------------------------------------------------------------------------------------------

/// Principal directions of the deformation gradient alone: what the force differential reads of its SVD.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PrincipalDirections {
  /// U in the current, V in the rest shape. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> U;
  /// U in the current, V in the rest shape. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> V;
};

/// How the fields of one PrincipalDirections are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of PrincipalDirectionsArray.
template <class Space>
struct PrincipalDirectionsFormats {
  using U = physgen::format::Native;
  using V = physgen::format::Native;
};

struct PrincipalDirectionsObject;
/// PrincipalDirectionsFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PrincipalDirectionsFormats<physgen::Host>,
          class Object = PrincipalDirectionsObject, int first = 0>
struct PrincipalDirectionsProbe {
  using array_ = ArrayTag;
  using U = physgen::Probe<ArrayTag, Object, first + 0, typename Base::U>;
  using V = physgen::Probe<ArrayTag, Object, first + 1, typename Base::V>;
};

/// Where each field begins in the record of one PrincipalDirections [bytes].
template <class Real, class Formats>
struct PrincipalDirectionsRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Rotation, typename Formats::U, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::V, Real>(),
  }});
  static constexpr int U = plan_.offset[0];
  static constexpr int V = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PrincipalDirections of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PrincipalDirectionsRef {
  using Record = PrincipalDirectionsRecord<Real, Formats>;

 public:
  using Value = PrincipalDirections<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PrincipalDirectionsRef(const Cursor& cursor) : at_(cursor) {}
  PrincipalDirectionsRef(const PrincipalDirectionsRef&) = default;
  PrincipalDirectionsRef& operator=(const PrincipalDirectionsRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PrincipalDirectionsRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::U, Real>(Record::U);
  }
  /// U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::V, Real>(Record::V);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.U = U().get();
    value.V = V().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    U() = value.U;
    V() = value.V;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of PrincipalDirections.
struct PrincipalDirectionsObject {
  static constexpr std::string_view name = "elasticity::PrincipalDirections";
  template <class Real>
  using Value = PrincipalDirections<Real>;
  template <class Real, class Formats>
  using Record = PrincipalDirectionsRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PrincipalDirectionsRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Rotation, typename Formats::U, Real>(
        "U", "", PrincipalDirectionsRecord<Real, Formats>::U, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::V, Real>(
        "V", "", PrincipalDirectionsRecord<Real, Formats>::V, 1, 0.0),
  }};
  template <class Space>
  using Formats = PrincipalDirectionsFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PrincipalDirectionsProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PrincipalDirectionsObject, Space>>
using PrincipalDirectionsView = physgen::View<PrincipalDirectionsObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PrincipalDirectionsObject, Space>>
using PrincipalDirectionsArray = physgen::Array<PrincipalDirectionsObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PrincipalDirectionsObject, float, PrincipalDirectionsFormats<physgen::Host>>(
    72, 4, {0, 36}));
static_assert(physgen::is_sound_record<PrincipalDirectionsObject, double, PrincipalDirectionsFormats<physgen::Host>>(
    144, 8, {0, 72}));

// ---- PrincipalStretches ---------------------------------------------------------------------------------------------

/// Principal stretches of the deformation gradient alone.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PrincipalStretches {
  /// s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  Eigen::Matrix<Real, 3, 1> s;
};

/// How the fields of one PrincipalStretches are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of PrincipalStretchesArray.
template <class Space>
struct PrincipalStretchesFormats {
  using s = physgen::format::Native;
};

struct PrincipalStretchesObject;
/// PrincipalStretchesFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PrincipalStretchesFormats<physgen::Host>,
          class Object = PrincipalStretchesObject, int first = 0>
struct PrincipalStretchesProbe {
  using array_ = ArrayTag;
  using s = physgen::Probe<ArrayTag, Object, first + 0, typename Base::s>;
};

/// Where each field begins in the record of one PrincipalStretches [bytes].
template <class Real, class Formats>
struct PrincipalStretchesRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Diagonal<3>, typename Formats::s, Real>(),
  }});
  static constexpr int s = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PrincipalStretches of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PrincipalStretchesRef {
  using Record = PrincipalStretchesRecord<Real, Formats>;

 public:
  using Value = PrincipalStretches<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PrincipalStretchesRef(const Cursor& cursor) : at_(cursor) {}
  PrincipalStretchesRef(const PrincipalStretchesRef&) = default;
  PrincipalStretchesRef& operator=(const PrincipalStretchesRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PrincipalStretchesRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const {
    return at_.template field<physgen::shape::Diagonal<3>, typename Formats::s, Real>(Record::s);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = PrincipalStretchesRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PrincipalStretchesRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Diagonal<3>, typename Formats::s, Real>(
        "s", "1", PrincipalStretchesRecord<Real, Formats>::s, 1, 0.0),
  }};
  template <class Space>
  using Formats = PrincipalStretchesFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PrincipalStretchesProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PrincipalStretchesObject, Space>>
using PrincipalStretchesView = physgen::View<PrincipalStretchesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PrincipalStretchesObject, Space>>
using PrincipalStretchesArray = physgen::Array<PrincipalStretchesObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PrincipalStretchesObject, float, PrincipalStretchesFormats<physgen::Host>>(
    12, 4, {0}));
static_assert(physgen::is_sound_record<PrincipalStretchesObject, double, PrincipalStretchesFormats<physgen::Host>>(
    24, 8, {0}));

// ---- ElementRotation ------------------------------------------------------------------------------------------------

/// A rotation: the polar factor R = U V^T of the deformation gradient, or principal directions by themselves.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct ElementRotation {
  /// det R = 1. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> R;
};

/// How the fields of one ElementRotation are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of ElementRotationArray.
template <class Space>
struct ElementRotationFormats {
  using R = physgen::format::Native;
};

struct ElementRotationObject;
/// ElementRotationFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = ElementRotationFormats<physgen::Host>, class Object = ElementRotationObject,
          int first = 0>
struct ElementRotationProbe {
  using array_ = ArrayTag;
  using R = physgen::Probe<ArrayTag, Object, first + 0, typename Base::R>;
};

/// Where each field begins in the record of one ElementRotation [bytes].
template <class Real, class Formats>
struct ElementRotationRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Rotation, typename Formats::R, Real>(),
  }});
  static constexpr int R = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One ElementRotation of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class ElementRotationRef {
  using Record = ElementRotationRecord<Real, Formats>;

 public:
  using Value = ElementRotation<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit ElementRotationRef(const Cursor& cursor) : at_(cursor) {}
  ElementRotationRef(const ElementRotationRef&) = default;
  ElementRotationRef& operator=(const ElementRotationRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const ElementRotationRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// det R = 1. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) R() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::R, Real>(Record::R);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = ElementRotationRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = ElementRotationRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Rotation, typename Formats::R, Real>(
        "R", "", ElementRotationRecord<Real, Formats>::R, 1, 0.0),
  }};
  template <class Space>
  using Formats = ElementRotationFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = ElementRotationProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<ElementRotationObject, Space>>
using ElementRotationView = physgen::View<ElementRotationObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<ElementRotationObject, Space>>
using ElementRotationArray = physgen::Array<ElementRotationObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<ElementRotationObject, float, ElementRotationFormats<physgen::Host>>(
    36, 4, {0}));
static_assert(physgen::is_sound_record<ElementRotationObject, double, ElementRotationFormats<physgen::Host>>(
    72, 8, {0}));

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

/// How the fields of one StressDerivative are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of StressDerivativeArray.
template <class Space>
struct StressDerivativeFormats {
  using x1111 = physgen::format::Native;
  using x2211 = physgen::format::Native;
  using x3311 = physgen::format::Native;
  using x2222 = physgen::format::Native;
  using x3322 = physgen::format::Native;
  using x3333 = physgen::format::Native;
  using x2121 = physgen::format::Native;
  using x2112 = physgen::format::Native;
  using x3131 = physgen::format::Native;
  using x3113 = physgen::format::Native;
  using x3232 = physgen::format::Native;
  using x3223 = physgen::format::Native;
};

struct StressDerivativeObject;
/// StressDerivativeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = StressDerivativeFormats<physgen::Host>, class Object = StressDerivativeObject,
          int first = 0>
struct StressDerivativeProbe {
  using array_ = ArrayTag;
  using x1111 = physgen::Probe<ArrayTag, Object, first + 0, typename Base::x1111>;
  using x2211 = physgen::Probe<ArrayTag, Object, first + 1, typename Base::x2211>;
  using x3311 = physgen::Probe<ArrayTag, Object, first + 2, typename Base::x3311>;
  using x2222 = physgen::Probe<ArrayTag, Object, first + 3, typename Base::x2222>;
  using x3322 = physgen::Probe<ArrayTag, Object, first + 4, typename Base::x3322>;
  using x3333 = physgen::Probe<ArrayTag, Object, first + 5, typename Base::x3333>;
  using x2121 = physgen::Probe<ArrayTag, Object, first + 6, typename Base::x2121>;
  using x2112 = physgen::Probe<ArrayTag, Object, first + 7, typename Base::x2112>;
  using x3131 = physgen::Probe<ArrayTag, Object, first + 8, typename Base::x3131>;
  using x3113 = physgen::Probe<ArrayTag, Object, first + 9, typename Base::x3113>;
  using x3232 = physgen::Probe<ArrayTag, Object, first + 10, typename Base::x3232>;
  using x3223 = physgen::Probe<ArrayTag, Object, first + 11, typename Base::x3223>;
};

/// Where each field begins in the record of one StressDerivative [bytes].
template <class Real, class Formats>
struct StressDerivativeRecord {
  static constexpr auto plan_ = physgen::plan_record<12>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::x1111, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x2211, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3311, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x2222, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3322, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3333, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x2121, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x2112, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3131, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3113, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3232, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3223, Real>(),
  }});
  static constexpr int x1111 = plan_.offset[0];
  static constexpr int x2211 = plan_.offset[1];
  static constexpr int x3311 = plan_.offset[2];
  static constexpr int x2222 = plan_.offset[3];
  static constexpr int x3322 = plan_.offset[4];
  static constexpr int x3333 = plan_.offset[5];
  static constexpr int x2121 = plan_.offset[6];
  static constexpr int x2112 = plan_.offset[7];
  static constexpr int x3131 = plan_.offset[8];
  static constexpr int x3113 = plan_.offset[9];
  static constexpr int x3232 = plan_.offset[10];
  static constexpr int x3223 = plan_.offset[11];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One StressDerivative of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class StressDerivativeRef {
  using Record = StressDerivativeRecord<Real, Formats>;

 public:
  using Value = StressDerivative<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StressDerivativeRef(const Cursor& cursor) : at_(cursor) {}
  StressDerivativeRef(const StressDerivativeRef&) = default;
  StressDerivativeRef& operator=(const StressDerivativeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const StressDerivativeRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x1111() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x1111, Real>(Record::x1111);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2211() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2211, Real>(Record::x2211);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3311() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3311, Real>(Record::x3311);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2222() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2222, Real>(Record::x2222);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3322() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3322, Real>(Record::x3322);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3333() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3333, Real>(Record::x3333);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2121() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2121, Real>(Record::x2121);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2112() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2112, Real>(Record::x2112);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3131() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3131, Real>(Record::x3131);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3113() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3113, Real>(Record::x3113);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3232() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3232, Real>(Record::x3232);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3223() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3223, Real>(Record::x3223);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = StressDerivativeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = StressDerivativeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 12> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::x1111, Real>(
        "x1111", "Pa", StressDerivativeRecord<Real, Formats>::x1111, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2211, Real>(
        "x2211", "Pa", StressDerivativeRecord<Real, Formats>::x2211, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3311, Real>(
        "x3311", "Pa", StressDerivativeRecord<Real, Formats>::x3311, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2222, Real>(
        "x2222", "Pa", StressDerivativeRecord<Real, Formats>::x2222, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3322, Real>(
        "x3322", "Pa", StressDerivativeRecord<Real, Formats>::x3322, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3333, Real>(
        "x3333", "Pa", StressDerivativeRecord<Real, Formats>::x3333, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2121, Real>(
        "x2121", "Pa", StressDerivativeRecord<Real, Formats>::x2121, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2112, Real>(
        "x2112", "Pa", StressDerivativeRecord<Real, Formats>::x2112, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3131, Real>(
        "x3131", "Pa", StressDerivativeRecord<Real, Formats>::x3131, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3113, Real>(
        "x3113", "Pa", StressDerivativeRecord<Real, Formats>::x3113, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3232, Real>(
        "x3232", "Pa", StressDerivativeRecord<Real, Formats>::x3232, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3223, Real>(
        "x3223", "Pa", StressDerivativeRecord<Real, Formats>::x3223, 1, 0.0),
  }};
  template <class Space>
  using Formats = StressDerivativeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = StressDerivativeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StressDerivativeObject, Space>>
using StressDerivativeView = physgen::View<StressDerivativeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StressDerivativeObject, Space>>
using StressDerivativeArray = physgen::Array<StressDerivativeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<StressDerivativeObject, float, StressDerivativeFormats<physgen::Host>>(
    48, 4, {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44}));
static_assert(physgen::is_sound_record<StressDerivativeObject, double, StressDerivativeFormats<physgen::Host>>(
    96, 8, {0, 8, 16, 24, 32, 40, 48, 56, 64, 72, 80, 88}));

// ---- Stress ---------------------------------------------------------------------------------------------------------

/// First Piola-Kirchhoff stress of one element.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Stress {
  /// dpsi/dF: force in the current shape per area of the rest shape [Pa]
  Eigen::Matrix<Real, 3, 3> P;
};

/// How the fields of one Stress are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of StressArray.
template <class Space>
struct StressFormats {
  using P = physgen::format::Native;
};

struct StressObject;
/// StressFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = StressFormats<physgen::Host>, class Object = StressObject, int first = 0>
struct StressProbe {
  using array_ = ArrayTag;
  using P = physgen::Probe<ArrayTag, Object, first + 0, typename Base::P>;
};

/// Where each field begins in the record of one Stress [bytes].
template <class Real, class Formats>
struct StressRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::P, Real>(),
  }});
  static constexpr int P = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Stress of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class StressRef {
  using Record = StressRecord<Real, Formats>;

 public:
  using Value = Stress<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StressRef(const Cursor& cursor) : at_(cursor) {}
  StressRef(const StressRef&) = default;
  StressRef& operator=(const StressRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const StressRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// dpsi/dF: force in the current shape per area of the rest shape [Pa]
  PHYSGEN_FUNCTION decltype(auto) P() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::P, Real>(Record::P);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = StressRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = StressRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::P, Real>(
        "P", "Pa", StressRecord<Real, Formats>::P, 1, 0.0),
  }};
  template <class Space>
  using Formats = StressFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = StressProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StressObject, Space>>
using StressView = physgen::View<StressObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StressObject, Space>>
using StressArray = physgen::Array<StressObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<StressObject, float, StressFormats<physgen::Host>>(36, 4, {0}));
static_assert(physgen::is_sound_record<StressObject, double, StressFormats<physgen::Host>>(72, 8, {0}));

// ---- StressDifferential ---------------------------------------------------------------------------------------------

/// Differential of the first Piola-Kirchhoff stress.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct StressDifferential {
  /// change of P along dF [Pa]
  Eigen::Matrix<Real, 3, 3> dP;
};

/// How the fields of one StressDifferential are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of StressDifferentialArray.
template <class Space>
struct StressDifferentialFormats {
  using dP = physgen::format::Native;
};

struct StressDifferentialObject;
/// StressDifferentialFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = StressDifferentialFormats<physgen::Host>,
          class Object = StressDifferentialObject, int first = 0>
struct StressDifferentialProbe {
  using array_ = ArrayTag;
  using dP = physgen::Probe<ArrayTag, Object, first + 0, typename Base::dP>;
};

/// Where each field begins in the record of one StressDifferential [bytes].
template <class Real, class Formats>
struct StressDifferentialRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::dP, Real>(),
  }});
  static constexpr int dP = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One StressDifferential of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class StressDifferentialRef {
  using Record = StressDifferentialRecord<Real, Formats>;

 public:
  using Value = StressDifferential<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StressDifferentialRef(const Cursor& cursor) : at_(cursor) {}
  StressDifferentialRef(const StressDifferentialRef&) = default;
  StressDifferentialRef& operator=(const StressDifferentialRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const StressDifferentialRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// change of P along dF [Pa]
  PHYSGEN_FUNCTION decltype(auto) dP() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::dP, Real>(Record::dP);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = StressDifferentialRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = StressDifferentialRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::dP, Real>(
        "dP", "Pa", StressDifferentialRecord<Real, Formats>::dP, 1, 0.0),
  }};
  template <class Space>
  using Formats = StressDifferentialFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = StressDifferentialProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StressDifferentialObject, Space>>
using StressDifferentialView = physgen::View<StressDifferentialObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StressDifferentialObject, Space>>
using StressDifferentialArray = physgen::Array<StressDifferentialObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<StressDifferentialObject, float, StressDifferentialFormats<physgen::Host>>(
    36, 4, {0}));
static_assert(physgen::is_sound_record<StressDifferentialObject, double, StressDifferentialFormats<physgen::Host>>(
    72, 8, {0}));

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

/// How the fields of one RestShape are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of RestShapeArray.
template <class Space>
struct RestShapeFormats {
  using dm_inverse = physgen::format::Native;
  using volume = physgen::format::Native;
};

struct RestShapeObject;
/// RestShapeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = RestShapeFormats<physgen::Host>, class Object = RestShapeObject, int first = 0>
struct RestShapeProbe {
  using array_ = ArrayTag;
  using dm_inverse = physgen::Probe<ArrayTag, Object, first + 0, typename Base::dm_inverse>;
  using volume = physgen::Probe<ArrayTag, Object, first + 1, typename Base::volume>;
};

/// Where each field begins in the record of one RestShape [bytes].
template <class Real, class Formats>
struct RestShapeRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::dm_inverse, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::volume, Real>(),
  }});
  static constexpr int dm_inverse = plan_.offset[0];
  static constexpr int volume = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One RestShape of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class RestShapeRef {
  using Record = RestShapeRecord<Real, Formats>;

 public:
  using Value = RestShape<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit RestShapeRef(const Cursor& cursor) : at_(cursor) {}
  RestShapeRef(const RestShapeRef&) = default;
  RestShapeRef& operator=(const RestShapeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const RestShapeRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Dm^-1, with Dm = [Xj-Xi, Xk-Xi, Xl-Xi] by columns [1/m]
  PHYSGEN_FUNCTION decltype(auto) dm_inverse() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::dm_inverse, Real>(Record::dm_inverse);
  }
  /// det(Dm) / 6, positive [m^3]
  PHYSGEN_FUNCTION decltype(auto) volume() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::volume, Real>(Record::volume);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = RestShapeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = RestShapeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::dm_inverse, Real>(
        "dm_inverse", "1/m", RestShapeRecord<Real, Formats>::dm_inverse, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::volume, Real>(
        "volume", "m^3", RestShapeRecord<Real, Formats>::volume, 1, 0.0),
  }};
  template <class Space>
  using Formats = RestShapeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = RestShapeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<RestShapeObject, Space>>
using RestShapeView = physgen::View<RestShapeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<RestShapeObject, Space>>
using RestShapeArray = physgen::Array<RestShapeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<RestShapeObject, float, RestShapeFormats<physgen::Host>>(40, 4, {0, 36}));
static_assert(physgen::is_sound_record<RestShapeObject, double, RestShapeFormats<physgen::Host>>(80, 8, {0, 72}));

// ---- CornerForces ---------------------------------------------------------------------------------------------------

/// Forces of one tet on its corners j, k, l, by columns; the force on i is minus their sum.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct CornerForces {
  /// G = -volume P Dm^-T [N]
  Eigen::Matrix<Real, 3, 3> G;
};

/// How the fields of one CornerForces are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of CornerForcesArray.
template <class Space>
struct CornerForcesFormats {
  using G = physgen::format::Native;
};

struct CornerForcesObject;
/// CornerForcesFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = CornerForcesFormats<physgen::Host>, class Object = CornerForcesObject,
          int first = 0>
struct CornerForcesProbe {
  using array_ = ArrayTag;
  using G = physgen::Probe<ArrayTag, Object, first + 0, typename Base::G>;
};

/// Where each field begins in the record of one CornerForces [bytes].
template <class Real, class Formats>
struct CornerForcesRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::G, Real>(),
  }});
  static constexpr int G = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One CornerForces of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class CornerForcesRef {
  using Record = CornerForcesRecord<Real, Formats>;

 public:
  using Value = CornerForces<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit CornerForcesRef(const Cursor& cursor) : at_(cursor) {}
  CornerForcesRef(const CornerForcesRef&) = default;
  CornerForcesRef& operator=(const CornerForcesRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const CornerForcesRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// G = -volume P Dm^-T [N]
  PHYSGEN_FUNCTION decltype(auto) G() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::G, Real>(Record::G);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = CornerForcesRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = CornerForcesRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::G, Real>(
        "G", "N", CornerForcesRecord<Real, Formats>::G, 1, 0.0),
  }};
  template <class Space>
  using Formats = CornerForcesFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = CornerForcesProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<CornerForcesObject, Space>>
using CornerForcesView = physgen::View<CornerForcesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<CornerForcesObject, Space>>
using CornerForcesArray = physgen::Array<CornerForcesObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<CornerForcesObject, float, CornerForcesFormats<physgen::Host>>(36, 4, {0}));
static_assert(physgen::is_sound_record<CornerForcesObject, double, CornerForcesFormats<physgen::Host>>(72, 8, {0}));

// ---- ElementRecord --------------------------------------------------------------------------------------------------

/// All that dP from dF reads and writes of one element, in one record of 48 scalars: what simulators with an array of
/// whole elements have. For comparison.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct ElementRecord {
  /// principal directions. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> U;
  /// principal directions. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> V;
  /// as in StressDerivative [Pa]
  Real x1111;
  /// as in StressDerivative [Pa]
  Real x2211;
  /// as in StressDerivative [Pa]
  Real x3311;
  /// as in StressDerivative [Pa]
  Real x2222;
  /// as in StressDerivative [Pa]
  Real x3322;
  /// as in StressDerivative [Pa]
  Real x3333;
  /// as in StressDerivative [Pa]
  Real x2121;
  /// as in StressDerivative [Pa]
  Real x2112;
  /// as in StressDerivative [Pa]
  Real x3131;
  /// as in StressDerivative [Pa]
  Real x3113;
  /// as in StressDerivative [Pa]
  Real x3232;
  /// as in StressDerivative [Pa]
  Real x3223;
  /// change of F along a displacement differential [1]
  Eigen::Matrix<Real, 3, 3> dF;
  /// change of P along dF [Pa]
  Eigen::Matrix<Real, 3, 3> dP;
};

/// How the fields of one ElementRecord are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of ElementRecordArray.
template <class Space>
struct ElementRecordFormats {
  using U = physgen::format::Native;
  using V = physgen::format::Native;
  using x1111 = physgen::format::Native;
  using x2211 = physgen::format::Native;
  using x3311 = physgen::format::Native;
  using x2222 = physgen::format::Native;
  using x3322 = physgen::format::Native;
  using x3333 = physgen::format::Native;
  using x2121 = physgen::format::Native;
  using x2112 = physgen::format::Native;
  using x3131 = physgen::format::Native;
  using x3113 = physgen::format::Native;
  using x3232 = physgen::format::Native;
  using x3223 = physgen::format::Native;
  using dF = physgen::format::Native;
  using dP = physgen::format::Native;
};

struct ElementRecordObject;
/// ElementRecordFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = ElementRecordFormats<physgen::Host>, class Object = ElementRecordObject,
          int first = 0>
struct ElementRecordProbe {
  using array_ = ArrayTag;
  using U = physgen::Probe<ArrayTag, Object, first + 0, typename Base::U>;
  using V = physgen::Probe<ArrayTag, Object, first + 1, typename Base::V>;
  using x1111 = physgen::Probe<ArrayTag, Object, first + 2, typename Base::x1111>;
  using x2211 = physgen::Probe<ArrayTag, Object, first + 3, typename Base::x2211>;
  using x3311 = physgen::Probe<ArrayTag, Object, first + 4, typename Base::x3311>;
  using x2222 = physgen::Probe<ArrayTag, Object, first + 5, typename Base::x2222>;
  using x3322 = physgen::Probe<ArrayTag, Object, first + 6, typename Base::x3322>;
  using x3333 = physgen::Probe<ArrayTag, Object, first + 7, typename Base::x3333>;
  using x2121 = physgen::Probe<ArrayTag, Object, first + 8, typename Base::x2121>;
  using x2112 = physgen::Probe<ArrayTag, Object, first + 9, typename Base::x2112>;
  using x3131 = physgen::Probe<ArrayTag, Object, first + 10, typename Base::x3131>;
  using x3113 = physgen::Probe<ArrayTag, Object, first + 11, typename Base::x3113>;
  using x3232 = physgen::Probe<ArrayTag, Object, first + 12, typename Base::x3232>;
  using x3223 = physgen::Probe<ArrayTag, Object, first + 13, typename Base::x3223>;
  using dF = physgen::Probe<ArrayTag, Object, first + 14, typename Base::dF>;
  using dP = physgen::Probe<ArrayTag, Object, first + 15, typename Base::dP>;
};

/// Where each field begins in the record of one ElementRecord [bytes].
template <class Real, class Formats>
struct ElementRecordRecord {
  static constexpr auto plan_ = physgen::plan_record<16>({{
    physgen::slot<physgen::shape::Rotation, typename Formats::U, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::V, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x1111, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x2211, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3311, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x2222, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3322, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3333, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x2121, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x2112, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3131, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3113, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3232, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::x3223, Real>(),
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::dF, Real>(),
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::dP, Real>(),
  }});
  static constexpr int U = plan_.offset[0];
  static constexpr int V = plan_.offset[1];
  static constexpr int x1111 = plan_.offset[2];
  static constexpr int x2211 = plan_.offset[3];
  static constexpr int x3311 = plan_.offset[4];
  static constexpr int x2222 = plan_.offset[5];
  static constexpr int x3322 = plan_.offset[6];
  static constexpr int x3333 = plan_.offset[7];
  static constexpr int x2121 = plan_.offset[8];
  static constexpr int x2112 = plan_.offset[9];
  static constexpr int x3131 = plan_.offset[10];
  static constexpr int x3113 = plan_.offset[11];
  static constexpr int x3232 = plan_.offset[12];
  static constexpr int x3223 = plan_.offset[13];
  static constexpr int dF = plan_.offset[14];
  static constexpr int dP = plan_.offset[15];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One ElementRecord of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class ElementRecordRef {
  using Record = ElementRecordRecord<Real, Formats>;

 public:
  using Value = ElementRecord<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit ElementRecordRef(const Cursor& cursor) : at_(cursor) {}
  ElementRecordRef(const ElementRecordRef&) = default;
  ElementRecordRef& operator=(const ElementRecordRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const ElementRecordRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// principal directions. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::U, Real>(Record::U);
  }
  /// principal directions. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::V, Real>(Record::V);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x1111() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x1111, Real>(Record::x1111);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2211() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2211, Real>(Record::x2211);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3311() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3311, Real>(Record::x3311);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2222() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2222, Real>(Record::x2222);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3322() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3322, Real>(Record::x3322);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3333() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3333, Real>(Record::x3333);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2121() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2121, Real>(Record::x2121);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2112() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2112, Real>(Record::x2112);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3131() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3131, Real>(Record::x3131);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3113() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3113, Real>(Record::x3113);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3232() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3232, Real>(Record::x3232);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3223() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3223, Real>(Record::x3223);
  }
  /// change of F along a displacement differential [1]
  PHYSGEN_FUNCTION decltype(auto) dF() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::dF, Real>(Record::dF);
  }
  /// change of P along dF [Pa]
  PHYSGEN_FUNCTION decltype(auto) dP() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::dP, Real>(Record::dP);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.U = U().get();
    value.V = V().get();
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
    value.dF = dF().get();
    value.dP = dP().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    U() = value.U;
    V() = value.V;
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
    dF() = value.dF;
    dP() = value.dP;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of ElementRecord.
struct ElementRecordObject {
  static constexpr std::string_view name = "elasticity::ElementRecord";
  template <class Real>
  using Value = ElementRecord<Real>;
  template <class Real, class Formats>
  using Record = ElementRecordRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = ElementRecordRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 16> fields = {{
    physgen::field_info<physgen::shape::Rotation, typename Formats::U, Real>(
        "U", "", ElementRecordRecord<Real, Formats>::U, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::V, Real>(
        "V", "", ElementRecordRecord<Real, Formats>::V, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x1111, Real>(
        "x1111", "Pa", ElementRecordRecord<Real, Formats>::x1111, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2211, Real>(
        "x2211", "Pa", ElementRecordRecord<Real, Formats>::x2211, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3311, Real>(
        "x3311", "Pa", ElementRecordRecord<Real, Formats>::x3311, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2222, Real>(
        "x2222", "Pa", ElementRecordRecord<Real, Formats>::x2222, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3322, Real>(
        "x3322", "Pa", ElementRecordRecord<Real, Formats>::x3322, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3333, Real>(
        "x3333", "Pa", ElementRecordRecord<Real, Formats>::x3333, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2121, Real>(
        "x2121", "Pa", ElementRecordRecord<Real, Formats>::x2121, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2112, Real>(
        "x2112", "Pa", ElementRecordRecord<Real, Formats>::x2112, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3131, Real>(
        "x3131", "Pa", ElementRecordRecord<Real, Formats>::x3131, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3113, Real>(
        "x3113", "Pa", ElementRecordRecord<Real, Formats>::x3113, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3232, Real>(
        "x3232", "Pa", ElementRecordRecord<Real, Formats>::x3232, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3223, Real>(
        "x3223", "Pa", ElementRecordRecord<Real, Formats>::x3223, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::dF, Real>(
        "dF", "1", ElementRecordRecord<Real, Formats>::dF, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::dP, Real>(
        "dP", "Pa", ElementRecordRecord<Real, Formats>::dP, 1, 0.0),
  }};
  template <class Space>
  using Formats = ElementRecordFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = ElementRecordProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<ElementRecordObject, Space>>
using ElementRecordView = physgen::View<ElementRecordObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<ElementRecordObject, Space>>
using ElementRecordArray = physgen::Array<ElementRecordObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<ElementRecordObject, float, ElementRecordFormats<physgen::Host>>(
    192, 4, {0, 36, 72, 76, 80, 84, 88, 92, 96, 100, 104, 108, 112, 116, 120, 156}));
static_assert(physgen::is_sound_record<ElementRecordObject, double, ElementRecordFormats<physgen::Host>>(
    384, 8, {0, 72, 144, 152, 160, 168, 176, 184, 192, 200, 208, 216, 224, 232, 240, 312}));

// ---- NodePosition ---------------------------------------------------------------------------------------------------

/// Current position of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodePosition {
  /// position [m]
  Eigen::Matrix<Real, 3, 1> x;
};

/// How the fields of one NodePosition are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of NodePositionArray.
template <class Space>
struct NodePositionFormats {
  using x = physgen::format::Native;
};

struct NodePositionObject;
/// NodePositionFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodePositionFormats<physgen::Host>, class Object = NodePositionObject,
          int first = 0>
struct NodePositionProbe {
  using array_ = ArrayTag;
  using x = physgen::Probe<ArrayTag, Object, first + 0, typename Base::x>;
};

/// Where each field begins in the record of one NodePosition [bytes].
template <class Real, class Formats>
struct NodePositionRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<3>, typename Formats::x, Real>(),
  }});
  static constexpr int x = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodePosition of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodePositionRef {
  using Record = NodePositionRecord<Real, Formats>;

 public:
  using Value = NodePosition<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodePositionRef(const Cursor& cursor) : at_(cursor) {}
  NodePositionRef(const NodePositionRef&) = default;
  NodePositionRef& operator=(const NodePositionRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodePositionRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// position [m]
  PHYSGEN_FUNCTION decltype(auto) x() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::x, Real>(Record::x);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = NodePositionRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodePositionRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::x, Real>(
        "x", "m", NodePositionRecord<Real, Formats>::x, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodePositionFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodePositionProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodePositionObject, Space>>
using NodePositionView = physgen::View<NodePositionObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodePositionObject, Space>>
using NodePositionArray = physgen::Array<NodePositionObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodePositionObject, float, NodePositionFormats<physgen::Host>>(12, 4, {0}));
static_assert(physgen::is_sound_record<NodePositionObject, double, NodePositionFormats<physgen::Host>>(24, 8, {0}));

// ---- NodeForce ------------------------------------------------------------------------------------------------------

/// Force on a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeForce {
  /// sum of the elements' forces on the node [N]
  Eigen::Matrix<Real, 3, 1> f;
};

/// How the fields of one NodeForce are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of NodeForceArray.
template <class Space>
struct NodeForceFormats {
  using f = physgen::format::Native;
};

struct NodeForceObject;
/// NodeForceFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeForceFormats<physgen::Host>, class Object = NodeForceObject, int first = 0>
struct NodeForceProbe {
  using array_ = ArrayTag;
  using f = physgen::Probe<ArrayTag, Object, first + 0, typename Base::f>;
};

/// Where each field begins in the record of one NodeForce [bytes].
template <class Real, class Formats>
struct NodeForceRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<3>, typename Formats::f, Real>(),
  }});
  static constexpr int f = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeForce of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeForceRef {
  using Record = NodeForceRecord<Real, Formats>;

 public:
  using Value = NodeForce<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeForceRef(const Cursor& cursor) : at_(cursor) {}
  NodeForceRef(const NodeForceRef&) = default;
  NodeForceRef& operator=(const NodeForceRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeForceRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// sum of the elements' forces on the node [N]
  PHYSGEN_FUNCTION decltype(auto) f() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::f, Real>(Record::f);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = NodeForceRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeForceRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::f, Real>(
        "f", "N", NodeForceRecord<Real, Formats>::f, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeForceFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeForceProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeForceObject, Space>>
using NodeForceView = physgen::View<NodeForceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodeForceObject, Space>>
using NodeForceArray = physgen::Array<NodeForceObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeForceObject, float, NodeForceFormats<physgen::Host>>(12, 4, {0}));
static_assert(physgen::is_sound_record<NodeForceObject, double, NodeForceFormats<physgen::Host>>(24, 8, {0}));

// ---- PlacedForce ----------------------------------------------------------------------------------------------------

/// Force of one tet on one of its corners, at its place in the row of that corner's node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PlacedForce {
  /// of the tet on the node [N]
  Eigen::Matrix<Real, 3, 1> f;
};

/// How the fields of one PlacedForce are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of PlacedForceArray.
template <class Space>
struct PlacedForceFormats {
  using f = physgen::format::Native;
};

struct PlacedForceObject;
/// PlacedForceFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PlacedForceFormats<physgen::Host>, class Object = PlacedForceObject,
          int first = 0>
struct PlacedForceProbe {
  using array_ = ArrayTag;
  using f = physgen::Probe<ArrayTag, Object, first + 0, typename Base::f>;
};

/// Where each field begins in the record of one PlacedForce [bytes].
template <class Real, class Formats>
struct PlacedForceRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<3>, typename Formats::f, Real>(),
  }});
  static constexpr int f = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PlacedForce of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PlacedForceRef {
  using Record = PlacedForceRecord<Real, Formats>;

 public:
  using Value = PlacedForce<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PlacedForceRef(const Cursor& cursor) : at_(cursor) {}
  PlacedForceRef(const PlacedForceRef&) = default;
  PlacedForceRef& operator=(const PlacedForceRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PlacedForceRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// of the tet on the node [N]
  PHYSGEN_FUNCTION decltype(auto) f() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::f, Real>(Record::f);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.f = f().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { f() = value.f; }

 private:
  Cursor at_;
};

/// What the runtime knows of PlacedForce.
struct PlacedForceObject {
  static constexpr std::string_view name = "elasticity::PlacedForce";
  template <class Real>
  using Value = PlacedForce<Real>;
  template <class Real, class Formats>
  using Record = PlacedForceRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PlacedForceRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::f, Real>(
        "f", "N", PlacedForceRecord<Real, Formats>::f, 1, 0.0),
  }};
  template <class Space>
  using Formats = PlacedForceFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PlacedForceProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PlacedForceObject, Space>>
using PlacedForceView = physgen::View<PlacedForceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<PlacedForceObject, Space>>
using PlacedForceArray = physgen::Array<PlacedForceObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PlacedForceObject, float, PlacedForceFormats<physgen::Host>>(12, 4, {0}));
static_assert(physgen::is_sound_record<PlacedForceObject, double, PlacedForceFormats<physgen::Host>>(24, 8, {0}));

// ---- NodeDisplacement -----------------------------------------------------------------------------------------------

/// Displacement differential of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeDisplacement {
  /// direction in which forces are differentiated [m]
  Eigen::Matrix<Real, 3, 1> dx;
};

/// How the fields of one NodeDisplacement are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of NodeDisplacementArray.
template <class Space>
struct NodeDisplacementFormats {
  using dx = physgen::format::Native;
};

struct NodeDisplacementObject;
/// NodeDisplacementFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeDisplacementFormats<physgen::Host>, class Object = NodeDisplacementObject,
          int first = 0>
struct NodeDisplacementProbe {
  using array_ = ArrayTag;
  using dx = physgen::Probe<ArrayTag, Object, first + 0, typename Base::dx>;
};

/// Where each field begins in the record of one NodeDisplacement [bytes].
template <class Real, class Formats>
struct NodeDisplacementRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<3>, typename Formats::dx, Real>(),
  }});
  static constexpr int dx = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeDisplacement of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeDisplacementRef {
  using Record = NodeDisplacementRecord<Real, Formats>;

 public:
  using Value = NodeDisplacement<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeDisplacementRef(const Cursor& cursor) : at_(cursor) {}
  NodeDisplacementRef(const NodeDisplacementRef&) = default;
  NodeDisplacementRef& operator=(const NodeDisplacementRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeDisplacementRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// direction in which forces are differentiated [m]
  PHYSGEN_FUNCTION decltype(auto) dx() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::dx, Real>(Record::dx);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = NodeDisplacementRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeDisplacementRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::dx, Real>(
        "dx", "m", NodeDisplacementRecord<Real, Formats>::dx, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeDisplacementFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeDisplacementProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeDisplacementObject, Space>>
using NodeDisplacementView = physgen::View<NodeDisplacementObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodeDisplacementObject, Space>>
using NodeDisplacementArray = physgen::Array<NodeDisplacementObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeDisplacementObject, float, NodeDisplacementFormats<physgen::Host>>(
    12, 4, {0}));
static_assert(physgen::is_sound_record<NodeDisplacementObject, double, NodeDisplacementFormats<physgen::Host>>(
    24, 8, {0}));

// ---- NodeForceDifferential ------------------------------------------------------------------------------------------

/// Force differential of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeForceDifferential {
  /// change of the node's force along the displacement differential [N]
  Eigen::Matrix<Real, 3, 1> df;
};

/// How the fields of one NodeForceDifferential are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of NodeForceDifferentialArray.
template <class Space>
struct NodeForceDifferentialFormats {
  using df = physgen::format::Native;
};

struct NodeForceDifferentialObject;
/// NodeForceDifferentialFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeForceDifferentialFormats<physgen::Host>,
          class Object = NodeForceDifferentialObject, int first = 0>
struct NodeForceDifferentialProbe {
  using array_ = ArrayTag;
  using df = physgen::Probe<ArrayTag, Object, first + 0, typename Base::df>;
};

/// Where each field begins in the record of one NodeForceDifferential [bytes].
template <class Real, class Formats>
struct NodeForceDifferentialRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<3>, typename Formats::df, Real>(),
  }});
  static constexpr int df = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeForceDifferential of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeForceDifferentialRef {
  using Record = NodeForceDifferentialRecord<Real, Formats>;

 public:
  using Value = NodeForceDifferential<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeForceDifferentialRef(const Cursor& cursor) : at_(cursor) {}
  NodeForceDifferentialRef(const NodeForceDifferentialRef&) = default;
  NodeForceDifferentialRef& operator=(const NodeForceDifferentialRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeForceDifferentialRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// change of the node's force along the displacement differential [N]
  PHYSGEN_FUNCTION decltype(auto) df() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::df, Real>(Record::df);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = NodeForceDifferentialRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeForceDifferentialRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::df, Real>(
        "df", "N", NodeForceDifferentialRecord<Real, Formats>::df, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeForceDifferentialFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeForceDifferentialProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeForceDifferentialObject, Space>>
using NodeForceDifferentialView = physgen::View<NodeForceDifferentialObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodeForceDifferentialObject, Space>>
using NodeForceDifferentialArray = physgen::Array<NodeForceDifferentialObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeForceDifferentialObject, float, NodeForceDifferentialFormats<physgen::Host>>(
    12, 4, {0}));
static_assert(physgen::is_sound_record<NodeForceDifferentialObject, double,
    NodeForceDifferentialFormats<physgen::Host>>(
    24, 8, {0}));

// ---- NodeStiffness --------------------------------------------------------------------------------------------------

/// Diagonal block of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeStiffness {
  /// df(v)/dx(v) [N/m]. Symmetric, 6 stored.
  Eigen::Matrix<Real, 3, 3> K;
};

/// How the fields of one NodeStiffness are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of NodeStiffnessArray.
template <class Space>
struct NodeStiffnessFormats {
  using K = physgen::format::Native;
};

struct NodeStiffnessObject;
/// NodeStiffnessFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeStiffnessFormats<physgen::Host>, class Object = NodeStiffnessObject,
          int first = 0>
struct NodeStiffnessProbe {
  using array_ = ArrayTag;
  using K = physgen::Probe<ArrayTag, Object, first + 0, typename Base::K>;
};

/// Where each field begins in the record of one NodeStiffness [bytes].
template <class Real, class Formats>
struct NodeStiffnessRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Symmetric<3>, typename Formats::K, Real>(),
  }});
  static constexpr int K = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeStiffness of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeStiffnessRef {
  using Record = NodeStiffnessRecord<Real, Formats>;

 public:
  using Value = NodeStiffness<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeStiffnessRef(const Cursor& cursor) : at_(cursor) {}
  NodeStiffnessRef(const NodeStiffnessRef&) = default;
  NodeStiffnessRef& operator=(const NodeStiffnessRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeStiffnessRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// df(v)/dx(v) [N/m]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) K() const {
    return at_.template field<physgen::shape::Symmetric<3>, typename Formats::K, Real>(Record::K);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = NodeStiffnessRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeStiffnessRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::K, Real>(
        "K", "N/m", NodeStiffnessRecord<Real, Formats>::K, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeStiffnessFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeStiffnessProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeStiffnessObject, Space>>
using NodeStiffnessView = physgen::View<NodeStiffnessObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<NodeStiffnessObject, Space>>
using NodeStiffnessArray = physgen::Array<NodeStiffnessObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeStiffnessObject, float, NodeStiffnessFormats<physgen::Host>>(24, 4, {0}));
static_assert(physgen::is_sound_record<NodeStiffnessObject, double, NodeStiffnessFormats<physgen::Host>>(48, 8, {0}));

// ---- EdgeStiffness --------------------------------------------------------------------------------------------------

/// Off-diagonal block of an edge (m,n). The symmetric product streams it, edge after edge.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct EdgeStiffness {
  /// df(m)/dx(n) [N/m]
  Eigen::Matrix<Real, 3, 3> E;
};

/// How the fields of one EdgeStiffness are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of EdgeStiffnessArray.
template <class Space>
struct EdgeStiffnessFormats {
  using E = physgen::format::Native;
};

struct EdgeStiffnessObject;
/// EdgeStiffnessFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = EdgeStiffnessFormats<physgen::Host>, class Object = EdgeStiffnessObject,
          int first = 0>
struct EdgeStiffnessProbe {
  using array_ = ArrayTag;
  using E = physgen::Probe<ArrayTag, Object, first + 0, typename Base::E>;
};

/// Where each field begins in the record of one EdgeStiffness [bytes].
template <class Real, class Formats>
struct EdgeStiffnessRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::E, Real>(),
  }});
  static constexpr int E = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One EdgeStiffness of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class EdgeStiffnessRef {
  using Record = EdgeStiffnessRecord<Real, Formats>;

 public:
  using Value = EdgeStiffness<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit EdgeStiffnessRef(const Cursor& cursor) : at_(cursor) {}
  EdgeStiffnessRef(const EdgeStiffnessRef&) = default;
  EdgeStiffnessRef& operator=(const EdgeStiffnessRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const EdgeStiffnessRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// df(m)/dx(n) [N/m]
  PHYSGEN_FUNCTION decltype(auto) E() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::E, Real>(Record::E);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = EdgeStiffnessRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = EdgeStiffnessRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::E, Real>(
        "E", "N/m", EdgeStiffnessRecord<Real, Formats>::E, 1, 0.0),
  }};
  template <class Space>
  using Formats = EdgeStiffnessFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = EdgeStiffnessProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<EdgeStiffnessObject, Space>>
using EdgeStiffnessView = physgen::View<EdgeStiffnessObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<EdgeStiffnessObject, Space>>
using EdgeStiffnessArray = physgen::Array<EdgeStiffnessObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<EdgeStiffnessObject, float, EdgeStiffnessFormats<physgen::Host>>(36, 4, {0}));
static_assert(physgen::is_sound_record<EdgeStiffnessObject, double, EdgeStiffnessFormats<physgen::Host>>(72, 8, {0}));

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

/// How the fields of one TetStiffness are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of TetStiffnessArray.
template <class Space>
struct TetStiffnessFormats {
  using k = physgen::format::Native;
  using e = physgen::format::Native;
};

struct TetStiffnessObject;
/// TetStiffnessFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = TetStiffnessFormats<physgen::Host>, class Object = TetStiffnessObject,
          int first = 0>
struct TetStiffnessProbe {
  using array_ = ArrayTag;
  using k = physgen::Probe<ArrayTag, Object, first + 0, typename Base::k>;
  using e = physgen::Probe<ArrayTag, Object, first + 1, typename Base::e>;
};

/// Where each field begins in the record of one TetStiffness [bytes].
template <class Real, class Formats>
struct TetStiffnessRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Symmetric<3>, typename Formats::k, Real>(4),
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::e, Real>(6),
  }});
  static constexpr int k = plan_.offset[0];
  static constexpr int e = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One TetStiffness of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class TetStiffnessRef {
  using Record = TetStiffnessRecord<Real, Formats>;

 public:
  using Value = TetStiffness<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit TetStiffnessRef(const Cursor& cursor) : at_(cursor) {}
  TetStiffnessRef(const TetStiffnessRef&) = default;
  TetStiffnessRef& operator=(const TetStiffnessRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const TetStiffnessRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// corners i, j, k, l [N/m]. Symmetric, 6 stored.
  /// @pre 0 <= entry < 4
  PHYSGEN_FUNCTION decltype(auto) k(int entry) const {
    physgen::check_inner(entry, 4, "an entry of elasticity::TetStiffness::k");
    return at_.template field<physgen::shape::Symmetric<3>, typename Formats::k, Real>(
        Record::k + entry * Record::plan_.stride[0]);
  }
  /// edges ij, ik, il, jk, jl, kl: df(first)/dx(second) [N/m]
  /// @pre 0 <= entry < 6
  PHYSGEN_FUNCTION decltype(auto) e(int entry) const {
    physgen::check_inner(entry, 6, "an entry of elasticity::TetStiffness::e");
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::e, Real>(
        Record::e + entry * Record::plan_.stride[1]);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = TetStiffnessRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = TetStiffnessRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::k, Real>(
        "k", "N/m", TetStiffnessRecord<Real, Formats>::k, 4, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::e, Real>(
        "e", "N/m", TetStiffnessRecord<Real, Formats>::e, 6, 0.0),
  }};
  template <class Space>
  using Formats = TetStiffnessFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = TetStiffnessProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TetStiffnessObject, Space>>
using TetStiffnessView = physgen::View<TetStiffnessObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetStiffnessObject, Space>>
using TetStiffnessArray = physgen::Array<TetStiffnessObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<TetStiffnessObject, float, TetStiffnessFormats<physgen::Host>>(312, 4, {0, 96}));
static_assert(physgen::is_sound_record<TetStiffnessObject, double, TetStiffnessFormats<physgen::Host>>(
    624, 8, {0, 192}));

// ---- Tet ------------------------------------------------------------------------------------------------------------

/// Nodes of a tet.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Tet {
  /// corners i, j, k, l; det(Dm) > 0
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> nodes;
};

/// How the fields of one Tet are stored in a memory space. To store some otherwise, derive from it, declare those anew,
/// and name the derived struct as the last argument of TetArray.
template <class Space>
struct TetFormats {
  using nodes = physgen::format::Native;
};

struct TetObject;
/// TetFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see <physgen/probe.h>.
/// The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = TetFormats<physgen::Host>, class Object = TetObject, int first = 0>
struct TetProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
};

/// Where each field begins in the record of one Tet [bytes].
template <class Real, class Formats>
struct TetRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(),
  }});
  static constexpr int nodes = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Tet of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class TetRef {
  using Record = TetRecord<Real, Formats>;

 public:
  using Value = Tet<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit TetRef(const Cursor& cursor) : at_(cursor) {}
  TetRef(const TetRef&) = default;
  TetRef& operator=(const TetRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const TetRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// corners i, j, k, l; det(Dm) > 0
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return at_.template field<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(Record::nodes);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = TetRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = TetRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(
        "nodes", "", TetRecord<Real, Formats>::nodes, 1, 0.0),
  }};
  template <class Space>
  using Formats = TetFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = TetProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<TetObject, Space>>
using TetView = physgen::View<TetObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetObject, Space>>
using TetArray = physgen::Array<TetObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<TetObject, float, TetFormats<physgen::Host>>(16, 4, {0}));
static_assert(physgen::is_sound_record<TetObject, double, TetFormats<physgen::Host>>(16, 4, {0}));

// ---- TetPlaces ------------------------------------------------------------------------------------------------------

/// Where the corners of a tet stand among the incidences of nodes.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct TetPlaces {
  /// of corners i, j, k, l: numbers of entries
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> places;
};

/// How the fields of one TetPlaces are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of TetPlacesArray.
template <class Space>
struct TetPlacesFormats {
  using places = physgen::format::Native;
};

struct TetPlacesObject;
/// TetPlacesFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = TetPlacesFormats<physgen::Host>, class Object = TetPlacesObject, int first = 0>
struct TetPlacesProbe {
  using array_ = ArrayTag;
  using places = physgen::Probe<ArrayTag, Object, first + 0, typename Base::places>;
};

/// Where each field begins in the record of one TetPlaces [bytes].
template <class Real, class Formats>
struct TetPlacesRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<4>, typename Formats::places, std::int32_t>(),
  }});
  static constexpr int places = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One TetPlaces of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class TetPlacesRef {
  using Record = TetPlacesRecord<Real, Formats>;

 public:
  using Value = TetPlaces<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit TetPlacesRef(const Cursor& cursor) : at_(cursor) {}
  TetPlacesRef(const TetPlacesRef&) = default;
  TetPlacesRef& operator=(const TetPlacesRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const TetPlacesRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// of corners i, j, k, l: numbers of entries
  PHYSGEN_FUNCTION decltype(auto) places() const {
    return at_.template field<physgen::shape::Vector<4>, typename Formats::places, std::int32_t>(Record::places);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.places = places().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { places() = value.places; }

 private:
  Cursor at_;
};

/// What the runtime knows of TetPlaces.
struct TetPlacesObject {
  static constexpr std::string_view name = "elasticity::TetPlaces";
  template <class Real>
  using Value = TetPlaces<Real>;
  template <class Real, class Formats>
  using Record = TetPlacesRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = TetPlacesRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::places, std::int32_t>(
        "places", "", TetPlacesRecord<Real, Formats>::places, 1, 0.0),
  }};
  template <class Space>
  using Formats = TetPlacesFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = TetPlacesProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TetPlacesObject, Space>>
using TetPlacesView = physgen::View<TetPlacesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetPlacesObject, Space>>
using TetPlacesArray = physgen::Array<TetPlacesObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<TetPlacesObject, float, TetPlacesFormats<physgen::Host>>(16, 4, {0}));
static_assert(physgen::is_sound_record<TetPlacesObject, double, TetPlacesFormats<physgen::Host>>(16, 4, {0}));

// ---- Edge -----------------------------------------------------------------------------------------------------------

/// Nodes of an edge.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Edge {
  /// m and n: the block of the edge is df(m)/dx(n)
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> nodes;
};

/// How the fields of one Edge are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of EdgeArray.
template <class Space>
struct EdgeFormats {
  using nodes = physgen::format::Native;
};

struct EdgeObject;
/// EdgeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see <physgen/probe.h>.
/// The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = EdgeFormats<physgen::Host>, class Object = EdgeObject, int first = 0>
struct EdgeProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
};

/// Where each field begins in the record of one Edge [bytes].
template <class Real, class Formats>
struct EdgeRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<2>, typename Formats::nodes, std::int32_t>(),
  }});
  static constexpr int nodes = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Edge of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class EdgeRef {
  using Record = EdgeRecord<Real, Formats>;

 public:
  using Value = Edge<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit EdgeRef(const Cursor& cursor) : at_(cursor) {}
  EdgeRef(const EdgeRef&) = default;
  EdgeRef& operator=(const EdgeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const EdgeRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// m and n: the block of the edge is df(m)/dx(n)
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return at_.template field<physgen::shape::Vector<2>, typename Formats::nodes, std::int32_t>(Record::nodes);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = EdgeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = EdgeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::nodes, std::int32_t>(
        "nodes", "", EdgeRecord<Real, Formats>::nodes, 1, 0.0),
  }};
  template <class Space>
  using Formats = EdgeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = EdgeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<EdgeObject, Space>>
using EdgeView = physgen::View<EdgeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<EdgeObject, Space>>
using EdgeArray = physgen::Array<EdgeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<EdgeObject, float, EdgeFormats<physgen::Host>>(8, 4, {0}));
static_assert(physgen::is_sound_record<EdgeObject, double, EdgeFormats<physgen::Host>>(8, 4, {0}));

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

/// How the fields of one IncidenceRange are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of IncidenceRangeArray.
template <class Space>
struct IncidenceRangeFormats {
  using begin = physgen::format::Native;
  using end = physgen::format::Native;
};

struct IncidenceRangeObject;
/// IncidenceRangeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = IncidenceRangeFormats<physgen::Host>, class Object = IncidenceRangeObject,
          int first = 0>
struct IncidenceRangeProbe {
  using array_ = ArrayTag;
  using begin = physgen::Probe<ArrayTag, Object, first + 0, typename Base::begin>;
  using end = physgen::Probe<ArrayTag, Object, first + 1, typename Base::end>;
};

/// Where each field begins in the record of one IncidenceRange [bytes].
template <class Real, class Formats>
struct IncidenceRangeRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::begin, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::end, std::int32_t>(),
  }});
  static constexpr int begin = plan_.offset[0];
  static constexpr int end = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One IncidenceRange of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class IncidenceRangeRef {
  using Record = IncidenceRangeRecord<Real, Formats>;

 public:
  using Value = IncidenceRange<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit IncidenceRangeRef(const Cursor& cursor) : at_(cursor) {}
  IncidenceRangeRef(const IncidenceRangeRef&) = default;
  IncidenceRangeRef& operator=(const IncidenceRangeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const IncidenceRangeRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// half-open range
  PHYSGEN_FUNCTION decltype(auto) begin() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::begin, std::int32_t>(Record::begin);
  }
  /// half-open range
  PHYSGEN_FUNCTION decltype(auto) end() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::end, std::int32_t>(Record::end);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = IncidenceRangeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = IncidenceRangeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::begin, std::int32_t>(
        "begin", "", IncidenceRangeRecord<Real, Formats>::begin, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::end, std::int32_t>(
        "end", "", IncidenceRangeRecord<Real, Formats>::end, 1, 0.0),
  }};
  template <class Space>
  using Formats = IncidenceRangeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = IncidenceRangeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<IncidenceRangeObject, Space>>
using IncidenceRangeView = physgen::View<IncidenceRangeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<IncidenceRangeObject, Space>>
using IncidenceRangeArray = physgen::Array<IncidenceRangeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<IncidenceRangeObject, float, IncidenceRangeFormats<physgen::Host>>(
    8, 4, {0, 4}));
static_assert(physgen::is_sound_record<IncidenceRangeObject, double, IncidenceRangeFormats<physgen::Host>>(
    8, 4, {0, 4}));

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

/// How the fields of one Incidence are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of IncidenceArray.
template <class Space>
struct IncidenceFormats {
  using element = physgen::format::Native;
  using local = physgen::format::Native;
};

struct IncidenceObject;
/// IncidenceFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = IncidenceFormats<physgen::Host>, class Object = IncidenceObject, int first = 0>
struct IncidenceProbe {
  using array_ = ArrayTag;
  using element = physgen::Probe<ArrayTag, Object, first + 0, typename Base::element>;
  using local = physgen::Probe<ArrayTag, Object, first + 1, typename Base::local>;
};

/// Where each field begins in the record of one Incidence [bytes].
template <class Real, class Formats>
struct IncidenceRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::element, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::local, std::int32_t>(),
  }});
  static constexpr int element = plan_.offset[0];
  static constexpr int local = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Incidence of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class IncidenceRef {
  using Record = IncidenceRecord<Real, Formats>;

 public:
  using Value = Incidence<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit IncidenceRef(const Cursor& cursor) : at_(cursor) {}
  IncidenceRef(const IncidenceRef&) = default;
  IncidenceRef& operator=(const IncidenceRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const IncidenceRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// which tet, or which edge
  PHYSGEN_FUNCTION decltype(auto) element() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::element, std::int32_t>(Record::element);
  }
  /// which of its corners, or of its edges, it is
  PHYSGEN_FUNCTION decltype(auto) local() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::local, std::int32_t>(Record::local);
  }

  PHYSGEN_FUNCTION const Value get() const {
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
  template <class Real, class Formats>
  using Record = IncidenceRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = IncidenceRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::element, std::int32_t>(
        "element", "", IncidenceRecord<Real, Formats>::element, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::local, std::int32_t>(
        "local", "", IncidenceRecord<Real, Formats>::local, 1, 0.0),
  }};
  template <class Space>
  using Formats = IncidenceFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = IncidenceProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<IncidenceObject, Space>>
using IncidenceView = physgen::View<IncidenceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<IncidenceObject, Space>>
using IncidenceArray = physgen::Array<IncidenceObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<IncidenceObject, float, IncidenceFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<IncidenceObject, double, IncidenceFormats<physgen::Host>>(8, 4, {0, 4}));

}  // namespace elasticity

#endif  // PHYSGEN_ELASTICITY_H_B477B507AEEAB8D9
