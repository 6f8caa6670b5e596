// Accessor classes of the object types in elasticity.h. Written by physgen: change the schema, not this file.
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
#ifndef PHYSGEN_ELASTICITY_H_3A348FE4FB677C38
#define PHYSGEN_ELASTICITY_H_3A348FE4FB677C38

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 7
#error "elasticity.physgen.h is for version 7 of the physgen runtime: generate it again with the installed physgen"
#endif
#ifdef PHYSGEN_SCHEMA_H
#error "a program includes elasticity.physgen.h in place of the schema: remove the #include of the schema"
#endif
#define PHYSGEN_GENERATED_HEADER

namespace elasticity {

// ---- DeformationGradient --------------------------------------------------------------------------------------------

/// Deformation gradient of one element, F = Ds Dm^-1.
template <class Real>
struct DeformationGradient {
  /// current over rest shape; the identity at rest [1]
  physgen::MatrixValue<Real, 3, 3> F = decltype(F)::Zero();
};

template <class Space>
struct DeformationGradientFormats {
  using F = physgen::format::Native;
};

struct DeformationGradientObject;
template <class ArrayTag, class Base = DeformationGradientFormats<physgen::Host>,
          class Object = DeformationGradientObject, int first = 0>
struct DeformationGradientProbe {
  using array_ = ArrayTag;
  using F = physgen::Probe<ArrayTag, Object, first + 0, typename Base::F>;
};

template <class Real, class Formats>
struct DeformationGradientRecord {
  using F = physgen::StoredField<DeformationGradientRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::F, Real>;
  using fields_ = physgen::RecordFields<F>;
};

template <class Real, class Formats, class Cursor>
struct DeformationGradientRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = DeformationGradientRecord<Real, Formats>;
  using Value = DeformationGradient<typename Cursor::template Lanes<Real>>;

  /// current over rest shape; the identity at rest [1]
  PHYSGEN_FUNCTION decltype(auto) F() const { return this->field_(typename Record::F(), Record::F::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {F().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { F() = value.F; }
};

struct DeformationGradientObject : physgen::ObjectTag<
    DeformationGradientObject, DeformationGradient, DeformationGradientFormats, DeformationGradientRecord,
    DeformationGradientRef, DeformationGradientProbe> {
  static constexpr std::string_view name = "elasticity::DeformationGradient";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"F", "1"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "current over rest shape; the identity at rest",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<DeformationGradientObject, Space>>
using DeformationGradientView = physgen::View<DeformationGradientObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<DeformationGradientObject, Space>>
using DeformationGradientArray = physgen::Array<DeformationGradientObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<DeformationGradientObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- DeformationGradientDifferential --------------------------------------------------------------------------------

/// Differential of the deformation gradient.
template <class Real>
struct DeformationGradientDifferential {
  /// change of F along a displacement differential [1]
  physgen::MatrixValue<Real, 3, 3> dF = decltype(dF)::Zero();
};

template <class Space>
struct DeformationGradientDifferentialFormats {
  using dF = physgen::format::Native;
};

struct DeformationGradientDifferentialObject;
template <class ArrayTag, class Base = DeformationGradientDifferentialFormats<physgen::Host>,
          class Object = DeformationGradientDifferentialObject, int first = 0>
struct DeformationGradientDifferentialProbe {
  using array_ = ArrayTag;
  using dF = physgen::Probe<ArrayTag, Object, first + 0, typename Base::dF>;
};

template <class Real, class Formats>
struct DeformationGradientDifferentialRecord {
  using dF = physgen::StoredField<
      DeformationGradientDifferentialRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::dF, Real>;
  using fields_ = physgen::RecordFields<dF>;
};

template <class Real, class Formats, class Cursor>
struct DeformationGradientDifferentialRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = DeformationGradientDifferentialRecord<Real, Formats>;
  using Value = DeformationGradientDifferential<typename Cursor::template Lanes<Real>>;

  /// change of F along a displacement differential [1]
  PHYSGEN_FUNCTION decltype(auto) dF() const { return this->field_(typename Record::dF(), Record::dF::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {dF().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { dF() = value.dF; }
};

struct DeformationGradientDifferentialObject : physgen::ObjectTag<
    DeformationGradientDifferentialObject, DeformationGradientDifferential, DeformationGradientDifferentialFormats,
    DeformationGradientDifferentialRecord, DeformationGradientDifferentialRef, DeformationGradientDifferentialProbe> {
  static constexpr std::string_view name = "elasticity::DeformationGradientDifferential";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"dF", "1"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "change of F along a displacement differential",
  };
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
static_assert(physgen::are_sound_records<DeformationGradientDifferentialObject, physgen::Host>(
    {36, 4, {0}}, {72, 8, {0}}));

// ---- DeformationSvd -------------------------------------------------------------------------------------------------

/// Rotation-variant SVD of the deformation gradient, F = U diag(s) V^T.
template <class Real>
struct DeformationSvd {
  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> U = decltype(U)::Identity();
  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> V = decltype(V)::Identity();
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  physgen::MatrixValue<Real, 3, 1> s = decltype(s)::Zero();
};

template <class Space>
struct DeformationSvdFormats {
  using U = physgen::format::Native;
  using V = physgen::format::Native;
  using s = physgen::format::Native;
};

struct DeformationSvdObject;
template <class ArrayTag, class Base = DeformationSvdFormats<physgen::Host>, class Object = DeformationSvdObject,
          int first = 0>
struct DeformationSvdProbe {
  using array_ = ArrayTag;
  using U = physgen::Probe<ArrayTag, Object, first + 0, typename Base::U>;
  using V = physgen::Probe<ArrayTag, Object, first + 1, typename Base::V>;
  using s = physgen::Probe<ArrayTag, Object, first + 2, typename Base::s>;
};

template <class Real, class Formats>
struct DeformationSvdRecord {
  using U = physgen::StoredField<DeformationSvdRecord, 0, physgen::shape::Rotation, typename Formats::U, Real>;
  using V = physgen::StoredField<DeformationSvdRecord, 1, physgen::shape::Rotation, typename Formats::V, Real>;
  using s = physgen::StoredField<DeformationSvdRecord, 2, physgen::shape::Diagonal<3>, typename Formats::s, Real>;
  using fields_ = physgen::RecordFields<U, V, s>;
};

template <class Real, class Formats, class Cursor>
struct DeformationSvdRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = DeformationSvdRecord<Real, Formats>;
  using Value = DeformationSvd<typename Cursor::template Lanes<Real>>;

  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const { return this->field_(typename Record::U(), Record::U::offset); }
  /// principal directions: U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const { return this->field_(typename Record::V(), Record::V::offset); }
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const { return this->field_(typename Record::s(), Record::s::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {U().get(), V().get(), s().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    U() = value.U;
    V() = value.V;
    s() = value.s;
  }
};

struct DeformationSvdObject : physgen::ObjectTag<
    DeformationSvdObject, DeformationSvd, DeformationSvdFormats, DeformationSvdRecord, DeformationSvdRef,
    DeformationSvdProbe> {
  static constexpr std::string_view name = "elasticity::DeformationSvd";
  static constexpr std::array<physgen::FieldText, 3> texts = {{{"U"}, {"V"}, {"s", "1"}}};
  static constexpr std::array<std::string_view, 3> docs = {
    "principal directions: U in the current, V in the rest shape",
    "principal directions: U in the current, V in the rest shape",
    "principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<DeformationSvdObject, Space>>
using DeformationSvdView = physgen::View<DeformationSvdObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<DeformationSvdObject, Space>>
using DeformationSvdArray = physgen::Array<DeformationSvdObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<DeformationSvdObject, physgen::Host>(
    {84, 4, {0, 36, 72}}, {168, 8, {0, 72, 144}}));

// ---- QuaternionSvd --------------------------------------------------------------------------------------------------

/// The same with the rotations as unit quaternions: 11 scalars instead of 21.
template <class Real>
struct QuaternionSvd {
  /// unit quaternions w, x, y, z of U and V, w >= 0
  physgen::MatrixValue<Real, 4, 1> u = decltype(u)::Zero();
  /// unit quaternions w, x, y, z of U and V, w >= 0
  physgen::MatrixValue<Real, 4, 1> v = decltype(v)::Zero();
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  physgen::MatrixValue<Real, 3, 1> s = decltype(s)::Zero();
};

template <class Space>
struct QuaternionSvdFormats {
  using u = physgen::format::Native;
  using v = physgen::format::Native;
  using s = physgen::format::Native;
};

struct QuaternionSvdObject;
template <class ArrayTag, class Base = QuaternionSvdFormats<physgen::Host>, class Object = QuaternionSvdObject,
          int first = 0>
struct QuaternionSvdProbe {
  using array_ = ArrayTag;
  using u = physgen::Probe<ArrayTag, Object, first + 0, typename Base::u>;
  using v = physgen::Probe<ArrayTag, Object, first + 1, typename Base::v>;
  using s = physgen::Probe<ArrayTag, Object, first + 2, typename Base::s>;
};

template <class Real, class Formats>
struct QuaternionSvdRecord {
  using u = physgen::StoredField<QuaternionSvdRecord, 0, physgen::shape::Vector<4>, typename Formats::u, Real>;
  using v = physgen::StoredField<QuaternionSvdRecord, 1, physgen::shape::Vector<4>, typename Formats::v, Real>;
  using s = physgen::StoredField<QuaternionSvdRecord, 2, physgen::shape::Diagonal<3>, typename Formats::s, Real>;
  using fields_ = physgen::RecordFields<u, v, s>;
};

template <class Real, class Formats, class Cursor>
struct QuaternionSvdRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = QuaternionSvdRecord<Real, Formats>;
  using Value = QuaternionSvd<typename Cursor::template Lanes<Real>>;

  /// unit quaternions w, x, y, z of U and V, w >= 0
  PHYSGEN_FUNCTION decltype(auto) u() const { return this->field_(typename Record::u(), Record::u::offset); }
  /// unit quaternions w, x, y, z of U and V, w >= 0
  PHYSGEN_FUNCTION decltype(auto) v() const { return this->field_(typename Record::v(), Record::v::offset); }
  /// principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const { return this->field_(typename Record::s(), Record::s::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {u().get(), v().get(), s().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    u() = value.u;
    v() = value.v;
    s() = value.s;
  }
};

struct QuaternionSvdObject : physgen::ObjectTag<
    QuaternionSvdObject, QuaternionSvd, QuaternionSvdFormats, QuaternionSvdRecord, QuaternionSvdRef,
    QuaternionSvdProbe> {
  static constexpr std::string_view name = "elasticity::QuaternionSvd";
  static constexpr std::array<physgen::FieldText, 3> texts = {{{"u"}, {"v"}, {"s", "1"}}};
  static constexpr std::array<std::string_view, 3> docs = {
    "unit quaternions w, x, y, z of U and V, w >= 0", "unit quaternions w, x, y, z of U and V, w >= 0",
    "principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<QuaternionSvdObject, Space>>
using QuaternionSvdView = physgen::View<QuaternionSvdObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<QuaternionSvdObject, Space>>
using QuaternionSvdArray = physgen::Array<QuaternionSvdObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<QuaternionSvdObject, physgen::Host>(
    {44, 4, {0, 16, 32}}, {88, 8, {0, 32, 64}}));

// ---- PrincipalDirections --------------------------------------------------------------------------------------------

/// Principal directions of the deformation gradient alone: what the force differential reads of its SVD.
template <class Real>
struct PrincipalDirections {
  /// U in the current, V in the rest shape. Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> U = decltype(U)::Identity();
  /// U in the current, V in the rest shape. Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> V = decltype(V)::Identity();
};

template <class Space>
struct PrincipalDirectionsFormats {
  using U = physgen::format::Native;
  using V = physgen::format::Native;
};

struct PrincipalDirectionsObject;
template <class ArrayTag, class Base = PrincipalDirectionsFormats<physgen::Host>,
          class Object = PrincipalDirectionsObject, int first = 0>
struct PrincipalDirectionsProbe {
  using array_ = ArrayTag;
  using U = physgen::Probe<ArrayTag, Object, first + 0, typename Base::U>;
  using V = physgen::Probe<ArrayTag, Object, first + 1, typename Base::V>;
};

template <class Real, class Formats>
struct PrincipalDirectionsRecord {
  using U = physgen::StoredField<PrincipalDirectionsRecord, 0, physgen::shape::Rotation, typename Formats::U, Real>;
  using V = physgen::StoredField<PrincipalDirectionsRecord, 1, physgen::shape::Rotation, typename Formats::V, Real>;
  using fields_ = physgen::RecordFields<U, V>;
};

template <class Real, class Formats, class Cursor>
struct PrincipalDirectionsRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PrincipalDirectionsRecord<Real, Formats>;
  using Value = PrincipalDirections<typename Cursor::template Lanes<Real>>;

  /// U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const { return this->field_(typename Record::U(), Record::U::offset); }
  /// U in the current, V in the rest shape. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const { return this->field_(typename Record::V(), Record::V::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {U().get(), V().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    U() = value.U;
    V() = value.V;
  }
};

struct PrincipalDirectionsObject : physgen::ObjectTag<
    PrincipalDirectionsObject, PrincipalDirections, PrincipalDirectionsFormats, PrincipalDirectionsRecord,
    PrincipalDirectionsRef, PrincipalDirectionsProbe> {
  static constexpr std::string_view name = "elasticity::PrincipalDirections";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"U"}, {"V"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "U in the current, V in the rest shape", "U in the current, V in the rest shape",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PrincipalDirectionsObject, Space>>
using PrincipalDirectionsView = physgen::View<PrincipalDirectionsObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PrincipalDirectionsObject, Space>>
using PrincipalDirectionsArray = physgen::Array<PrincipalDirectionsObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PrincipalDirectionsObject, physgen::Host>(
    {72, 4, {0, 36}}, {144, 8, {0, 72}}));

// ---- PrincipalStretches ---------------------------------------------------------------------------------------------

/// Principal stretches of the deformation gradient alone.
template <class Real>
struct PrincipalStretches {
  /// s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  physgen::MatrixValue<Real, 3, 1> s = decltype(s)::Zero();
};

template <class Space>
struct PrincipalStretchesFormats {
  using s = physgen::format::Native;
};

struct PrincipalStretchesObject;
template <class ArrayTag, class Base = PrincipalStretchesFormats<physgen::Host>,
          class Object = PrincipalStretchesObject, int first = 0>
struct PrincipalStretchesProbe {
  using array_ = ArrayTag;
  using s = physgen::Probe<ArrayTag, Object, first + 0, typename Base::s>;
};

template <class Real, class Formats>
struct PrincipalStretchesRecord {
  using s = physgen::StoredField<PrincipalStretchesRecord, 0, physgen::shape::Diagonal<3>, typename Formats::s, Real>;
  using fields_ = physgen::RecordFields<s>;
};

template <class Real, class Formats, class Cursor>
struct PrincipalStretchesRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PrincipalStretchesRecord<Real, Formats>;
  using Value = PrincipalStretches<typename Cursor::template Lanes<Real>>;

  /// s1 >= s2 >= |s3|; s3 < 0 where inverted [1]. Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const { return this->field_(typename Record::s(), Record::s::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {s().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { s() = value.s; }
};

struct PrincipalStretchesObject : physgen::ObjectTag<
    PrincipalStretchesObject, PrincipalStretches, PrincipalStretchesFormats, PrincipalStretchesRecord,
    PrincipalStretchesRef, PrincipalStretchesProbe> {
  static constexpr std::string_view name = "elasticity::PrincipalStretches";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"s", "1"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "s1 >= s2 >= |s3|; s3 < 0 where inverted",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PrincipalStretchesObject, Space>>
using PrincipalStretchesView = physgen::View<PrincipalStretchesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PrincipalStretchesObject, Space>>
using PrincipalStretchesArray = physgen::Array<PrincipalStretchesObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PrincipalStretchesObject, physgen::Host>({12, 4, {0}}, {24, 8, {0}}));

// ---- ElementRotation ------------------------------------------------------------------------------------------------

/// A rotation: the polar factor R = U V^T of the deformation gradient, or principal directions by themselves.
template <class Real>
struct ElementRotation {
  /// det R = 1. Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> R = decltype(R)::Identity();
};

template <class Space>
struct ElementRotationFormats {
  using R = physgen::format::Native;
};

struct ElementRotationObject;
template <class ArrayTag, class Base = ElementRotationFormats<physgen::Host>, class Object = ElementRotationObject,
          int first = 0>
struct ElementRotationProbe {
  using array_ = ArrayTag;
  using R = physgen::Probe<ArrayTag, Object, first + 0, typename Base::R>;
};

template <class Real, class Formats>
struct ElementRotationRecord {
  using R = physgen::StoredField<ElementRotationRecord, 0, physgen::shape::Rotation, typename Formats::R, Real>;
  using fields_ = physgen::RecordFields<R>;
};

template <class Real, class Formats, class Cursor>
struct ElementRotationRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = ElementRotationRecord<Real, Formats>;
  using Value = ElementRotation<typename Cursor::template Lanes<Real>>;

  /// det R = 1. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) R() const { return this->field_(typename Record::R(), Record::R::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {R().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { R() = value.R; }
};

struct ElementRotationObject : physgen::ObjectTag<
    ElementRotationObject, ElementRotation, ElementRotationFormats, ElementRotationRecord, ElementRotationRef,
    ElementRotationProbe> {
  static constexpr std::string_view name = "elasticity::ElementRotation";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"R"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "det R = 1",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<ElementRotationObject, Space>>
using ElementRotationView = physgen::View<ElementRotationObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<ElementRotationObject, Space>>
using ElementRotationArray = physgen::Array<ElementRotationObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<ElementRotationObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- StressDerivative -----------------------------------------------------------------------------------------------

/// Isotropic stress derivative in principal axes (12 scalars): x_iikk = d2psi/(ds_i ds_k), and for the pairs (a,b) =
/// (2,1), (3,1), (3,2) the entries x_abab and x_abba.
template <class Real>
struct StressDerivative {
  /// stretch: the symmetric 3x3 block [Pa]
  Real x1111 = {};
  /// stretch: the symmetric 3x3 block [Pa]
  Real x2211 = {};
  /// stretch: the symmetric 3x3 block [Pa]
  Real x3311 = {};
  /// stretch: the symmetric 3x3 block [Pa]
  Real x2222 = {};
  /// stretch: the symmetric 3x3 block [Pa]
  Real x3322 = {};
  /// stretch: the symmetric 3x3 block [Pa]
  Real x3333 = {};
  /// shear: one 2x2 block per pair [Pa]
  Real x2121 = {};
  /// shear: one 2x2 block per pair [Pa]
  Real x2112 = {};
  /// shear: one 2x2 block per pair [Pa]
  Real x3131 = {};
  /// shear: one 2x2 block per pair [Pa]
  Real x3113 = {};
  /// shear: one 2x2 block per pair [Pa]
  Real x3232 = {};
  /// shear: one 2x2 block per pair [Pa]
  Real x3223 = {};
};

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

template <class Real, class Formats>
struct StressDerivativeRecord {
  using x1111 = physgen::StoredField<StressDerivativeRecord, 0, physgen::shape::Scalar, typename Formats::x1111, Real>;
  using x2211 = physgen::StoredField<StressDerivativeRecord, 1, physgen::shape::Scalar, typename Formats::x2211, Real>;
  using x3311 = physgen::StoredField<StressDerivativeRecord, 2, physgen::shape::Scalar, typename Formats::x3311, Real>;
  using x2222 = physgen::StoredField<StressDerivativeRecord, 3, physgen::shape::Scalar, typename Formats::x2222, Real>;
  using x3322 = physgen::StoredField<StressDerivativeRecord, 4, physgen::shape::Scalar, typename Formats::x3322, Real>;
  using x3333 = physgen::StoredField<StressDerivativeRecord, 5, physgen::shape::Scalar, typename Formats::x3333, Real>;
  using x2121 = physgen::StoredField<StressDerivativeRecord, 6, physgen::shape::Scalar, typename Formats::x2121, Real>;
  using x2112 = physgen::StoredField<StressDerivativeRecord, 7, physgen::shape::Scalar, typename Formats::x2112, Real>;
  using x3131 = physgen::StoredField<StressDerivativeRecord, 8, physgen::shape::Scalar, typename Formats::x3131, Real>;
  using x3113 = physgen::StoredField<StressDerivativeRecord, 9, physgen::shape::Scalar, typename Formats::x3113, Real>;
  using x3232 = physgen::StoredField<StressDerivativeRecord, 10, physgen::shape::Scalar, typename Formats::x3232, Real>;
  using x3223 = physgen::StoredField<StressDerivativeRecord, 11, physgen::shape::Scalar, typename Formats::x3223, Real>;
  using fields_ = physgen::RecordFields<
      x1111, x2211, x3311, x2222, x3322, x3333, x2121, x2112, x3131, x3113, x3232, x3223>;
};

template <class Real, class Formats, class Cursor>
struct StressDerivativeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = StressDerivativeRecord<Real, Formats>;
  using Value = StressDerivative<typename Cursor::template Lanes<Real>>;

  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x1111() const {
    return this->field_(typename Record::x1111(), Record::x1111::offset);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2211() const {
    return this->field_(typename Record::x2211(), Record::x2211::offset);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3311() const {
    return this->field_(typename Record::x3311(), Record::x3311::offset);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2222() const {
    return this->field_(typename Record::x2222(), Record::x2222::offset);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3322() const {
    return this->field_(typename Record::x3322(), Record::x3322::offset);
  }
  /// stretch: the symmetric 3x3 block [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3333() const {
    return this->field_(typename Record::x3333(), Record::x3333::offset);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2121() const {
    return this->field_(typename Record::x2121(), Record::x2121::offset);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2112() const {
    return this->field_(typename Record::x2112(), Record::x2112::offset);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3131() const {
    return this->field_(typename Record::x3131(), Record::x3131::offset);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3113() const {
    return this->field_(typename Record::x3113(), Record::x3113::offset);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3232() const {
    return this->field_(typename Record::x3232(), Record::x3232::offset);
  }
  /// shear: one 2x2 block per pair [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3223() const {
    return this->field_(typename Record::x3223(), Record::x3223::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {x1111(), x2211(), x3311(), x2222(), x3322(), x3333(), x2121(), x2112(), x3131(), x3113(), x3232(), x3223()};
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
};

struct StressDerivativeObject : physgen::ObjectTag<
    StressDerivativeObject, StressDerivative, StressDerivativeFormats, StressDerivativeRecord, StressDerivativeRef,
    StressDerivativeProbe> {
  static constexpr std::string_view name = "elasticity::StressDerivative";
  static constexpr std::array<physgen::FieldText, 12> texts = {{
      {"x1111", "Pa"}, {"x2211", "Pa"}, {"x3311", "Pa"}, {"x2222", "Pa"}, {"x3322", "Pa"}, {"x3333", "Pa"},
      {"x2121", "Pa"}, {"x2112", "Pa"}, {"x3131", "Pa"}, {"x3113", "Pa"}, {"x3232", "Pa"}, {"x3223", "Pa"}}};
  static constexpr std::array<std::string_view, 12> docs = {
    "stretch: the symmetric 3x3 block", "stretch: the symmetric 3x3 block", "stretch: the symmetric 3x3 block",
    "stretch: the symmetric 3x3 block", "stretch: the symmetric 3x3 block", "stretch: the symmetric 3x3 block",
    "shear: one 2x2 block per pair", "shear: one 2x2 block per pair", "shear: one 2x2 block per pair",
    "shear: one 2x2 block per pair", "shear: one 2x2 block per pair", "shear: one 2x2 block per pair",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StressDerivativeObject, Space>>
using StressDerivativeView = physgen::View<StressDerivativeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StressDerivativeObject, Space>>
using StressDerivativeArray = physgen::Array<StressDerivativeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<StressDerivativeObject, physgen::Host>(
    {48, 4, {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44}}, {96, 8, {0, 8, 16, 24, 32, 40, 48, 56, 64, 72, 80, 88}}));

// ---- Stress ---------------------------------------------------------------------------------------------------------

/// First Piola-Kirchhoff stress of one element.
template <class Real>
struct Stress {
  /// dpsi/dF: force in the current shape per area of the rest shape [Pa]
  physgen::MatrixValue<Real, 3, 3> P = decltype(P)::Zero();
};

template <class Space>
struct StressFormats {
  using P = physgen::format::Native;
};

struct StressObject;
template <class ArrayTag, class Base = StressFormats<physgen::Host>, class Object = StressObject, int first = 0>
struct StressProbe {
  using array_ = ArrayTag;
  using P = physgen::Probe<ArrayTag, Object, first + 0, typename Base::P>;
};

template <class Real, class Formats>
struct StressRecord {
  using P = physgen::StoredField<StressRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::P, Real>;
  using fields_ = physgen::RecordFields<P>;
};

template <class Real, class Formats, class Cursor>
struct StressRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = StressRecord<Real, Formats>;
  using Value = Stress<typename Cursor::template Lanes<Real>>;

  /// dpsi/dF: force in the current shape per area of the rest shape [Pa]
  PHYSGEN_FUNCTION decltype(auto) P() const { return this->field_(typename Record::P(), Record::P::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {P().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { P() = value.P; }
};

struct StressObject : physgen::ObjectTag<StressObject, Stress, StressFormats, StressRecord, StressRef, StressProbe> {
  static constexpr std::string_view name = "elasticity::Stress";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"P", "Pa"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "dpsi/dF: force in the current shape per area of the rest shape",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StressObject, Space>>
using StressView = physgen::View<StressObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StressObject, Space>>
using StressArray = physgen::Array<StressObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<StressObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- StressDifferential ---------------------------------------------------------------------------------------------

/// Differential of the first Piola-Kirchhoff stress.
template <class Real>
struct StressDifferential {
  /// change of P along dF [Pa]
  physgen::MatrixValue<Real, 3, 3> dP = decltype(dP)::Zero();
};

template <class Space>
struct StressDifferentialFormats {
  using dP = physgen::format::Native;
};

struct StressDifferentialObject;
template <class ArrayTag, class Base = StressDifferentialFormats<physgen::Host>,
          class Object = StressDifferentialObject, int first = 0>
struct StressDifferentialProbe {
  using array_ = ArrayTag;
  using dP = physgen::Probe<ArrayTag, Object, first + 0, typename Base::dP>;
};

template <class Real, class Formats>
struct StressDifferentialRecord {
  using dP = physgen::StoredField<
      StressDifferentialRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::dP, Real>;
  using fields_ = physgen::RecordFields<dP>;
};

template <class Real, class Formats, class Cursor>
struct StressDifferentialRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = StressDifferentialRecord<Real, Formats>;
  using Value = StressDifferential<typename Cursor::template Lanes<Real>>;

  /// change of P along dF [Pa]
  PHYSGEN_FUNCTION decltype(auto) dP() const { return this->field_(typename Record::dP(), Record::dP::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {dP().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { dP() = value.dP; }
};

struct StressDifferentialObject : physgen::ObjectTag<
    StressDifferentialObject, StressDifferential, StressDifferentialFormats, StressDifferentialRecord,
    StressDifferentialRef, StressDifferentialProbe> {
  static constexpr std::string_view name = "elasticity::StressDifferential";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"dP", "Pa"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "change of P along dF",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StressDifferentialObject, Space>>
using StressDifferentialView = physgen::View<StressDifferentialObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StressDifferentialObject, Space>>
using StressDifferentialArray = physgen::Array<StressDifferentialObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<StressDifferentialObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- RestShape ------------------------------------------------------------------------------------------------------

/// Rest shape of one tet.
template <class Real>
struct RestShape {
  /// Dm^-1, with Dm = [Xj-Xi, Xk-Xi, Xl-Xi] by columns [1/m]
  physgen::MatrixValue<Real, 3, 3> dm_inverse = decltype(dm_inverse)::Zero();
  /// det(Dm) / 6, positive [m^3]
  Real volume = {};
};

template <class Space>
struct RestShapeFormats {
  using dm_inverse = physgen::format::Native;
  using volume = physgen::format::Native;
};

struct RestShapeObject;
template <class ArrayTag, class Base = RestShapeFormats<physgen::Host>, class Object = RestShapeObject, int first = 0>
struct RestShapeProbe {
  using array_ = ArrayTag;
  using dm_inverse = physgen::Probe<ArrayTag, Object, first + 0, typename Base::dm_inverse>;
  using volume = physgen::Probe<ArrayTag, Object, first + 1, typename Base::volume>;
};

template <class Real, class Formats>
struct RestShapeRecord {
  using dm_inverse = physgen::StoredField<
      RestShapeRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::dm_inverse, Real>;
  using volume = physgen::StoredField<RestShapeRecord, 1, physgen::shape::Scalar, typename Formats::volume, Real>;
  using fields_ = physgen::RecordFields<dm_inverse, volume>;
};

template <class Real, class Formats, class Cursor>
struct RestShapeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = RestShapeRecord<Real, Formats>;
  using Value = RestShape<typename Cursor::template Lanes<Real>>;

  /// Dm^-1, with Dm = [Xj-Xi, Xk-Xi, Xl-Xi] by columns [1/m]
  PHYSGEN_FUNCTION decltype(auto) dm_inverse() const {
    return this->field_(typename Record::dm_inverse(), Record::dm_inverse::offset);
  }
  /// det(Dm) / 6, positive [m^3]
  PHYSGEN_FUNCTION decltype(auto) volume() const {
    return this->field_(typename Record::volume(), Record::volume::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {dm_inverse().get(), volume()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    dm_inverse() = value.dm_inverse;
    volume() = value.volume;
  }
};

struct RestShapeObject : physgen::ObjectTag<
    RestShapeObject, RestShape, RestShapeFormats, RestShapeRecord, RestShapeRef, RestShapeProbe> {
  static constexpr std::string_view name = "elasticity::RestShape";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"dm_inverse", "1/m"}, {"volume", "m^3"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "Dm^-1, with Dm = [Xj-Xi, Xk-Xi, Xl-Xi] by columns", "det(Dm) / 6, positive",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<RestShapeObject, Space>>
using RestShapeView = physgen::View<RestShapeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<RestShapeObject, Space>>
using RestShapeArray = physgen::Array<RestShapeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<RestShapeObject, physgen::Host>({40, 4, {0, 36}}, {80, 8, {0, 72}}));

// ---- CornerForces ---------------------------------------------------------------------------------------------------

/// Forces of one tet on its corners j, k, l, by columns; the force on i is minus their sum.
template <class Real>
struct CornerForces {
  /// G = -volume P Dm^-T [N]
  physgen::MatrixValue<Real, 3, 3> G = decltype(G)::Zero();
};

template <class Space>
struct CornerForcesFormats {
  using G = physgen::format::Native;
};

struct CornerForcesObject;
template <class ArrayTag, class Base = CornerForcesFormats<physgen::Host>, class Object = CornerForcesObject,
          int first = 0>
struct CornerForcesProbe {
  using array_ = ArrayTag;
  using G = physgen::Probe<ArrayTag, Object, first + 0, typename Base::G>;
};

template <class Real, class Formats>
struct CornerForcesRecord {
  using G = physgen::StoredField<CornerForcesRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::G, Real>;
  using fields_ = physgen::RecordFields<G>;
};

template <class Real, class Formats, class Cursor>
struct CornerForcesRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = CornerForcesRecord<Real, Formats>;
  using Value = CornerForces<typename Cursor::template Lanes<Real>>;

  /// G = -volume P Dm^-T [N]
  PHYSGEN_FUNCTION decltype(auto) G() const { return this->field_(typename Record::G(), Record::G::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {G().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { G() = value.G; }
};

struct CornerForcesObject : physgen::ObjectTag<
    CornerForcesObject, CornerForces, CornerForcesFormats, CornerForcesRecord, CornerForcesRef, CornerForcesProbe> {
  static constexpr std::string_view name = "elasticity::CornerForces";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"G", "N"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "G = -volume P Dm^-T",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<CornerForcesObject, Space>>
using CornerForcesView = physgen::View<CornerForcesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<CornerForcesObject, Space>>
using CornerForcesArray = physgen::Array<CornerForcesObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<CornerForcesObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- ElementRecord --------------------------------------------------------------------------------------------------

/// All that dP from dF reads and writes of one element, in one record of 48 scalars: what simulators with an array of
/// whole elements have. For comparison.
template <class Real>
struct ElementRecord {
  /// principal directions. Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> U = decltype(U)::Identity();
  /// principal directions. Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> V = decltype(V)::Identity();
  /// as in StressDerivative [Pa]
  Real x1111 = {};
  /// as in StressDerivative [Pa]
  Real x2211 = {};
  /// as in StressDerivative [Pa]
  Real x3311 = {};
  /// as in StressDerivative [Pa]
  Real x2222 = {};
  /// as in StressDerivative [Pa]
  Real x3322 = {};
  /// as in StressDerivative [Pa]
  Real x3333 = {};
  /// as in StressDerivative [Pa]
  Real x2121 = {};
  /// as in StressDerivative [Pa]
  Real x2112 = {};
  /// as in StressDerivative [Pa]
  Real x3131 = {};
  /// as in StressDerivative [Pa]
  Real x3113 = {};
  /// as in StressDerivative [Pa]
  Real x3232 = {};
  /// as in StressDerivative [Pa]
  Real x3223 = {};
  /// change of F along a displacement differential [1]
  physgen::MatrixValue<Real, 3, 3> dF = decltype(dF)::Zero();
  /// change of P along dF [Pa]
  physgen::MatrixValue<Real, 3, 3> dP = decltype(dP)::Zero();
};

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

template <class Real, class Formats>
struct ElementRecordRecord {
  using U = physgen::StoredField<ElementRecordRecord, 0, physgen::shape::Rotation, typename Formats::U, Real>;
  using V = physgen::StoredField<ElementRecordRecord, 1, physgen::shape::Rotation, typename Formats::V, Real>;
  using x1111 = physgen::StoredField<ElementRecordRecord, 2, physgen::shape::Scalar, typename Formats::x1111, Real>;
  using x2211 = physgen::StoredField<ElementRecordRecord, 3, physgen::shape::Scalar, typename Formats::x2211, Real>;
  using x3311 = physgen::StoredField<ElementRecordRecord, 4, physgen::shape::Scalar, typename Formats::x3311, Real>;
  using x2222 = physgen::StoredField<ElementRecordRecord, 5, physgen::shape::Scalar, typename Formats::x2222, Real>;
  using x3322 = physgen::StoredField<ElementRecordRecord, 6, physgen::shape::Scalar, typename Formats::x3322, Real>;
  using x3333 = physgen::StoredField<ElementRecordRecord, 7, physgen::shape::Scalar, typename Formats::x3333, Real>;
  using x2121 = physgen::StoredField<ElementRecordRecord, 8, physgen::shape::Scalar, typename Formats::x2121, Real>;
  using x2112 = physgen::StoredField<ElementRecordRecord, 9, physgen::shape::Scalar, typename Formats::x2112, Real>;
  using x3131 = physgen::StoredField<ElementRecordRecord, 10, physgen::shape::Scalar, typename Formats::x3131, Real>;
  using x3113 = physgen::StoredField<ElementRecordRecord, 11, physgen::shape::Scalar, typename Formats::x3113, Real>;
  using x3232 = physgen::StoredField<ElementRecordRecord, 12, physgen::shape::Scalar, typename Formats::x3232, Real>;
  using x3223 = physgen::StoredField<ElementRecordRecord, 13, physgen::shape::Scalar, typename Formats::x3223, Real>;
  using dF = physgen::StoredField<ElementRecordRecord, 14, physgen::shape::Matrix<3, 3>, typename Formats::dF, Real>;
  using dP = physgen::StoredField<ElementRecordRecord, 15, physgen::shape::Matrix<3, 3>, typename Formats::dP, Real>;
  using fields_ = physgen::RecordFields<
      U, V, x1111, x2211, x3311, x2222, x3322, x3333, x2121, x2112, x3131, x3113, x3232, x3223, dF, dP>;
};

template <class Real, class Formats, class Cursor>
struct ElementRecordRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = ElementRecordRecord<Real, Formats>;
  using Value = ElementRecord<typename Cursor::template Lanes<Real>>;

  /// principal directions. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const { return this->field_(typename Record::U(), Record::U::offset); }
  /// principal directions. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const { return this->field_(typename Record::V(), Record::V::offset); }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x1111() const {
    return this->field_(typename Record::x1111(), Record::x1111::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2211() const {
    return this->field_(typename Record::x2211(), Record::x2211::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3311() const {
    return this->field_(typename Record::x3311(), Record::x3311::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2222() const {
    return this->field_(typename Record::x2222(), Record::x2222::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3322() const {
    return this->field_(typename Record::x3322(), Record::x3322::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3333() const {
    return this->field_(typename Record::x3333(), Record::x3333::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2121() const {
    return this->field_(typename Record::x2121(), Record::x2121::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x2112() const {
    return this->field_(typename Record::x2112(), Record::x2112::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3131() const {
    return this->field_(typename Record::x3131(), Record::x3131::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3113() const {
    return this->field_(typename Record::x3113(), Record::x3113::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3232() const {
    return this->field_(typename Record::x3232(), Record::x3232::offset);
  }
  /// as in StressDerivative [Pa]
  PHYSGEN_FUNCTION decltype(auto) x3223() const {
    return this->field_(typename Record::x3223(), Record::x3223::offset);
  }
  /// change of F along a displacement differential [1]
  PHYSGEN_FUNCTION decltype(auto) dF() const { return this->field_(typename Record::dF(), Record::dF::offset); }
  /// change of P along dF [Pa]
  PHYSGEN_FUNCTION decltype(auto) dP() const { return this->field_(typename Record::dP(), Record::dP::offset); }

  PHYSGEN_FUNCTION const Value get() const {
    return {
        U().get(), V().get(), x1111(), x2211(), x3311(), x2222(), x3322(), x3333(), x2121(), x2112(), x3131(), x3113(),
        x3232(), x3223(), dF().get(), dP().get()};
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
};

struct ElementRecordObject : physgen::ObjectTag<
    ElementRecordObject, ElementRecord, ElementRecordFormats, ElementRecordRecord, ElementRecordRef,
    ElementRecordProbe> {
  static constexpr std::string_view name = "elasticity::ElementRecord";
  static constexpr std::array<physgen::FieldText, 16> texts = {{
      {"U"}, {"V"}, {"x1111", "Pa"}, {"x2211", "Pa"}, {"x3311", "Pa"}, {"x2222", "Pa"}, {"x3322", "Pa"},
      {"x3333", "Pa"}, {"x2121", "Pa"}, {"x2112", "Pa"}, {"x3131", "Pa"}, {"x3113", "Pa"}, {"x3232", "Pa"},
      {"x3223", "Pa"}, {"dF", "1"}, {"dP", "Pa"}}};
  static constexpr std::array<std::string_view, 16> docs = {
    "principal directions", "principal directions", "as in StressDerivative", "as in StressDerivative",
    "as in StressDerivative", "as in StressDerivative", "as in StressDerivative", "as in StressDerivative",
    "as in StressDerivative", "as in StressDerivative", "as in StressDerivative", "as in StressDerivative",
    "as in StressDerivative", "as in StressDerivative", "change of F along a displacement differential",
    "change of P along dF",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<ElementRecordObject, Space>>
using ElementRecordView = physgen::View<ElementRecordObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<ElementRecordObject, Space>>
using ElementRecordArray = physgen::Array<ElementRecordObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<ElementRecordObject, physgen::Host>(
    {192, 4, {0, 36, 72, 76, 80, 84, 88, 92, 96, 100, 104, 108, 112, 116, 120, 156}},
    {384, 8, {0, 72, 144, 152, 160, 168, 176, 184, 192, 200, 208, 216, 224, 232, 240, 312}}));

// ---- NodePosition ---------------------------------------------------------------------------------------------------

/// Current position of a node.
template <class Real>
struct NodePosition {
  /// position [m]
  physgen::MatrixValue<Real, 3, 1> x = decltype(x)::Zero();
};

template <class Space>
struct NodePositionFormats {
  using x = physgen::format::Native;
};

struct NodePositionObject;
template <class ArrayTag, class Base = NodePositionFormats<physgen::Host>, class Object = NodePositionObject,
          int first = 0>
struct NodePositionProbe {
  using array_ = ArrayTag;
  using x = physgen::Probe<ArrayTag, Object, first + 0, typename Base::x>;
};

template <class Real, class Formats>
struct NodePositionRecord {
  using x = physgen::StoredField<NodePositionRecord, 0, physgen::shape::Vector<3>, typename Formats::x, Real>;
  using fields_ = physgen::RecordFields<x>;
};

template <class Real, class Formats, class Cursor>
struct NodePositionRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodePositionRecord<Real, Formats>;
  using Value = NodePosition<typename Cursor::template Lanes<Real>>;

  /// position [m]
  PHYSGEN_FUNCTION decltype(auto) x() const { return this->field_(typename Record::x(), Record::x::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {x().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { x() = value.x; }
};

struct NodePositionObject : physgen::ObjectTag<
    NodePositionObject, NodePosition, NodePositionFormats, NodePositionRecord, NodePositionRef, NodePositionProbe> {
  static constexpr std::string_view name = "elasticity::NodePosition";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"x", "m"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "position",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodePositionObject, Space>>
using NodePositionView = physgen::View<NodePositionObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodePositionObject, Space>>
using NodePositionArray = physgen::Array<NodePositionObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodePositionObject, physgen::Host>({12, 4, {0}}, {24, 8, {0}}));

// ---- NodeForce ------------------------------------------------------------------------------------------------------

/// Force on a node.
template <class Real>
struct NodeForce {
  /// sum of the elements' forces on the node [N]
  physgen::MatrixValue<Real, 3, 1> f = decltype(f)::Zero();
};

template <class Space>
struct NodeForceFormats {
  using f = physgen::format::Native;
};

struct NodeForceObject;
template <class ArrayTag, class Base = NodeForceFormats<physgen::Host>, class Object = NodeForceObject, int first = 0>
struct NodeForceProbe {
  using array_ = ArrayTag;
  using f = physgen::Probe<ArrayTag, Object, first + 0, typename Base::f>;
};

template <class Real, class Formats>
struct NodeForceRecord {
  using f = physgen::StoredField<NodeForceRecord, 0, physgen::shape::Vector<3>, typename Formats::f, Real>;
  using fields_ = physgen::RecordFields<f>;
};

template <class Real, class Formats, class Cursor>
struct NodeForceRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeForceRecord<Real, Formats>;
  using Value = NodeForce<typename Cursor::template Lanes<Real>>;

  /// sum of the elements' forces on the node [N]
  PHYSGEN_FUNCTION decltype(auto) f() const { return this->field_(typename Record::f(), Record::f::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {f().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { f() = value.f; }
};

struct NodeForceObject : physgen::ObjectTag<
    NodeForceObject, NodeForce, NodeForceFormats, NodeForceRecord, NodeForceRef, NodeForceProbe> {
  static constexpr std::string_view name = "elasticity::NodeForce";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"f", "N"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "sum of the elements' forces on the node",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeForceObject, Space>>
using NodeForceView = physgen::View<NodeForceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodeForceObject, Space>>
using NodeForceArray = physgen::Array<NodeForceObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeForceObject, physgen::Host>({12, 4, {0}}, {24, 8, {0}}));

// ---- PlacedForce ----------------------------------------------------------------------------------------------------

/// Force of one tet on one of its corners, at its place in the row of that corner's node.
template <class Real>
struct PlacedForce {
  /// of the tet on the node [N]
  physgen::MatrixValue<Real, 3, 1> f = decltype(f)::Zero();
};

template <class Space>
struct PlacedForceFormats {
  using f = physgen::format::Native;
};

struct PlacedForceObject;
template <class ArrayTag, class Base = PlacedForceFormats<physgen::Host>, class Object = PlacedForceObject,
          int first = 0>
struct PlacedForceProbe {
  using array_ = ArrayTag;
  using f = physgen::Probe<ArrayTag, Object, first + 0, typename Base::f>;
};

template <class Real, class Formats>
struct PlacedForceRecord {
  using f = physgen::StoredField<PlacedForceRecord, 0, physgen::shape::Vector<3>, typename Formats::f, Real>;
  using fields_ = physgen::RecordFields<f>;
};

template <class Real, class Formats, class Cursor>
struct PlacedForceRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PlacedForceRecord<Real, Formats>;
  using Value = PlacedForce<typename Cursor::template Lanes<Real>>;

  /// of the tet on the node [N]
  PHYSGEN_FUNCTION decltype(auto) f() const { return this->field_(typename Record::f(), Record::f::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {f().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { f() = value.f; }
};

struct PlacedForceObject : physgen::ObjectTag<
    PlacedForceObject, PlacedForce, PlacedForceFormats, PlacedForceRecord, PlacedForceRef, PlacedForceProbe> {
  static constexpr std::string_view name = "elasticity::PlacedForce";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"f", "N"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "of the tet on the node",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PlacedForceObject, Space>>
using PlacedForceView = physgen::View<PlacedForceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<PlacedForceObject, Space>>
using PlacedForceArray = physgen::Array<PlacedForceObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PlacedForceObject, physgen::Host>({12, 4, {0}}, {24, 8, {0}}));

// ---- NodeDisplacement -----------------------------------------------------------------------------------------------

/// Displacement differential of a node.
template <class Real>
struct NodeDisplacement {
  /// direction in which forces are differentiated [m]
  physgen::MatrixValue<Real, 3, 1> dx = decltype(dx)::Zero();
};

template <class Space>
struct NodeDisplacementFormats {
  using dx = physgen::format::Native;
};

struct NodeDisplacementObject;
template <class ArrayTag, class Base = NodeDisplacementFormats<physgen::Host>, class Object = NodeDisplacementObject,
          int first = 0>
struct NodeDisplacementProbe {
  using array_ = ArrayTag;
  using dx = physgen::Probe<ArrayTag, Object, first + 0, typename Base::dx>;
};

template <class Real, class Formats>
struct NodeDisplacementRecord {
  using dx = physgen::StoredField<NodeDisplacementRecord, 0, physgen::shape::Vector<3>, typename Formats::dx, Real>;
  using fields_ = physgen::RecordFields<dx>;
};

template <class Real, class Formats, class Cursor>
struct NodeDisplacementRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeDisplacementRecord<Real, Formats>;
  using Value = NodeDisplacement<typename Cursor::template Lanes<Real>>;

  /// direction in which forces are differentiated [m]
  PHYSGEN_FUNCTION decltype(auto) dx() const { return this->field_(typename Record::dx(), Record::dx::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {dx().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { dx() = value.dx; }
};

struct NodeDisplacementObject : physgen::ObjectTag<
    NodeDisplacementObject, NodeDisplacement, NodeDisplacementFormats, NodeDisplacementRecord, NodeDisplacementRef,
    NodeDisplacementProbe> {
  static constexpr std::string_view name = "elasticity::NodeDisplacement";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"dx", "m"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "direction in which forces are differentiated",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeDisplacementObject, Space>>
using NodeDisplacementView = physgen::View<NodeDisplacementObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodeDisplacementObject, Space>>
using NodeDisplacementArray = physgen::Array<NodeDisplacementObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeDisplacementObject, physgen::Host>({12, 4, {0}}, {24, 8, {0}}));

// ---- NodeForceDifferential ------------------------------------------------------------------------------------------

/// Force differential of a node.
template <class Real>
struct NodeForceDifferential {
  /// change of the node's force along the displacement differential [N]
  physgen::MatrixValue<Real, 3, 1> df = decltype(df)::Zero();
};

template <class Space>
struct NodeForceDifferentialFormats {
  using df = physgen::format::Native;
};

struct NodeForceDifferentialObject;
template <class ArrayTag, class Base = NodeForceDifferentialFormats<physgen::Host>,
          class Object = NodeForceDifferentialObject, int first = 0>
struct NodeForceDifferentialProbe {
  using array_ = ArrayTag;
  using df = physgen::Probe<ArrayTag, Object, first + 0, typename Base::df>;
};

template <class Real, class Formats>
struct NodeForceDifferentialRecord {
  using df = physgen::StoredField<
      NodeForceDifferentialRecord, 0, physgen::shape::Vector<3>, typename Formats::df, Real>;
  using fields_ = physgen::RecordFields<df>;
};

template <class Real, class Formats, class Cursor>
struct NodeForceDifferentialRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeForceDifferentialRecord<Real, Formats>;
  using Value = NodeForceDifferential<typename Cursor::template Lanes<Real>>;

  /// change of the node's force along the displacement differential [N]
  PHYSGEN_FUNCTION decltype(auto) df() const { return this->field_(typename Record::df(), Record::df::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {df().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { df() = value.df; }
};

struct NodeForceDifferentialObject : physgen::ObjectTag<
    NodeForceDifferentialObject, NodeForceDifferential, NodeForceDifferentialFormats, NodeForceDifferentialRecord,
    NodeForceDifferentialRef, NodeForceDifferentialProbe> {
  static constexpr std::string_view name = "elasticity::NodeForceDifferential";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"df", "N"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "change of the node's force along the displacement differential",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeForceDifferentialObject, Space>>
using NodeForceDifferentialView = physgen::View<NodeForceDifferentialObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodeForceDifferentialObject, Space>>
using NodeForceDifferentialArray = physgen::Array<NodeForceDifferentialObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeForceDifferentialObject, physgen::Host>({12, 4, {0}}, {24, 8, {0}}));

// ---- NodeStiffness --------------------------------------------------------------------------------------------------

/// Diagonal block of a node.
template <class Real>
struct NodeStiffness {
  /// df(v)/dx(v) [N/m]. Symmetric, 6 stored.
  physgen::MatrixValue<Real, 3, 3> K = decltype(K)::Zero();
};

template <class Space>
struct NodeStiffnessFormats {
  using K = physgen::format::Native;
};

struct NodeStiffnessObject;
template <class ArrayTag, class Base = NodeStiffnessFormats<physgen::Host>, class Object = NodeStiffnessObject,
          int first = 0>
struct NodeStiffnessProbe {
  using array_ = ArrayTag;
  using K = physgen::Probe<ArrayTag, Object, first + 0, typename Base::K>;
};

template <class Real, class Formats>
struct NodeStiffnessRecord {
  using K = physgen::StoredField<NodeStiffnessRecord, 0, physgen::shape::Symmetric<3>, typename Formats::K, Real>;
  using fields_ = physgen::RecordFields<K>;
};

template <class Real, class Formats, class Cursor>
struct NodeStiffnessRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeStiffnessRecord<Real, Formats>;
  using Value = NodeStiffness<typename Cursor::template Lanes<Real>>;

  /// df(v)/dx(v) [N/m]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) K() const { return this->field_(typename Record::K(), Record::K::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {K().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { K() = value.K; }
};

struct NodeStiffnessObject : physgen::ObjectTag<
    NodeStiffnessObject, NodeStiffness, NodeStiffnessFormats, NodeStiffnessRecord, NodeStiffnessRef,
    NodeStiffnessProbe> {
  static constexpr std::string_view name = "elasticity::NodeStiffness";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"K", "N/m"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "df(v)/dx(v)",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeStiffnessObject, Space>>
using NodeStiffnessView = physgen::View<NodeStiffnessObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<NodeStiffnessObject, Space>>
using NodeStiffnessArray = physgen::Array<NodeStiffnessObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeStiffnessObject, physgen::Host>({24, 4, {0}}, {48, 8, {0}}));

// ---- EdgeStiffness --------------------------------------------------------------------------------------------------

/// Off-diagonal block of an edge (m,n). The symmetric product streams it, edge after edge.
template <class Real>
struct EdgeStiffness {
  /// df(m)/dx(n) [N/m]
  physgen::MatrixValue<Real, 3, 3> E = decltype(E)::Zero();
};

template <class Space>
struct EdgeStiffnessFormats {
  using E = physgen::format::Native;
};

struct EdgeStiffnessObject;
template <class ArrayTag, class Base = EdgeStiffnessFormats<physgen::Host>, class Object = EdgeStiffnessObject,
          int first = 0>
struct EdgeStiffnessProbe {
  using array_ = ArrayTag;
  using E = physgen::Probe<ArrayTag, Object, first + 0, typename Base::E>;
};

template <class Real, class Formats>
struct EdgeStiffnessRecord {
  using E = physgen::StoredField<EdgeStiffnessRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::E, Real>;
  using fields_ = physgen::RecordFields<E>;
};

template <class Real, class Formats, class Cursor>
struct EdgeStiffnessRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = EdgeStiffnessRecord<Real, Formats>;
  using Value = EdgeStiffness<typename Cursor::template Lanes<Real>>;

  /// df(m)/dx(n) [N/m]
  PHYSGEN_FUNCTION decltype(auto) E() const { return this->field_(typename Record::E(), Record::E::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {E().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { E() = value.E; }
};

struct EdgeStiffnessObject : physgen::ObjectTag<
    EdgeStiffnessObject, EdgeStiffness, EdgeStiffnessFormats, EdgeStiffnessRecord, EdgeStiffnessRef,
    EdgeStiffnessProbe> {
  static constexpr std::string_view name = "elasticity::EdgeStiffness";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"E", "N/m"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "df(m)/dx(n)",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<EdgeStiffnessObject, Space>>
using EdgeStiffnessView = physgen::View<EdgeStiffnessObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<EdgeStiffnessObject, Space>>
using EdgeStiffnessArray = physgen::Array<EdgeStiffnessObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<EdgeStiffnessObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- TetStiffness ---------------------------------------------------------------------------------------------------

/// Blocks of one tet, before the sums over the tets of a node and of an edge.
template <class Real>
struct TetStiffness {
  /// corners i, j, k, l [N/m]. Symmetric, 6 stored.
  physgen::MatrixValue<Real, 3, 3> k[4] = {
      std::remove_extent_t<decltype(k)>::Zero(), std::remove_extent_t<decltype(k)>::Zero(),
      std::remove_extent_t<decltype(k)>::Zero(), std::remove_extent_t<decltype(k)>::Zero()};
  /// edges ij, ik, il, jk, jl, kl: df(first)/dx(second) [N/m]
  physgen::MatrixValue<Real, 3, 3> e[6] = {
      std::remove_extent_t<decltype(e)>::Zero(), std::remove_extent_t<decltype(e)>::Zero(),
      std::remove_extent_t<decltype(e)>::Zero(), std::remove_extent_t<decltype(e)>::Zero(),
      std::remove_extent_t<decltype(e)>::Zero(), std::remove_extent_t<decltype(e)>::Zero()};
};

template <class Space>
struct TetStiffnessFormats {
  using k = physgen::format::Native;
  using e = physgen::format::Native;
};

struct TetStiffnessObject;
template <class ArrayTag, class Base = TetStiffnessFormats<physgen::Host>, class Object = TetStiffnessObject,
          int first = 0>
struct TetStiffnessProbe {
  using array_ = ArrayTag;
  using k = physgen::Probe<ArrayTag, Object, first + 0, typename Base::k>;
  using e = physgen::Probe<ArrayTag, Object, first + 1, typename Base::e>;
};

template <class Real, class Formats>
struct TetStiffnessRecord {
  using k = physgen::StoredField<TetStiffnessRecord, 0, physgen::shape::Symmetric<3>, typename Formats::k, Real, 4>;
  using e = physgen::StoredField<TetStiffnessRecord, 1, physgen::shape::Matrix<3, 3>, typename Formats::e, Real, 6>;
  using fields_ = physgen::RecordFields<k, e>;
};

template <class Real, class Formats, class Cursor>
struct TetStiffnessRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = TetStiffnessRecord<Real, Formats>;
  using Value = TetStiffness<typename Cursor::template Lanes<Real>>;

  /// corners i, j, k, l [N/m]. Symmetric, 6 stored.
  /// @pre 0 <= entry < 4
  PHYSGEN_FUNCTION decltype(auto) k(int entry) const {
    physgen::check_inner(entry, 4, "an entry of elasticity::TetStiffness::k");
    return this->field_(typename Record::k(), Record::k::offset + entry * Record::k::stride);
  }
  /// edges ij, ik, il, jk, jl, kl: df(first)/dx(second) [N/m]
  /// @pre 0 <= entry < 6
  PHYSGEN_FUNCTION decltype(auto) e(int entry) const {
    physgen::check_inner(entry, 6, "an entry of elasticity::TetStiffness::e");
    return this->field_(typename Record::e(), Record::e::offset + entry * Record::e::stride);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {
        {k(0).get(), k(1).get(), k(2).get(), k(3).get()}, {e(0).get(), e(1).get(), e(2).get(), e(3).get(), e(4).get(),
        e(5).get()}};
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 4; ++entry) k(entry) = value.k[entry];
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 6; ++entry) e(entry) = value.e[entry];
  }
};

struct TetStiffnessObject : physgen::ObjectTag<
    TetStiffnessObject, TetStiffness, TetStiffnessFormats, TetStiffnessRecord, TetStiffnessRef, TetStiffnessProbe> {
  static constexpr std::string_view name = "elasticity::TetStiffness";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"k", "N/m"}, {"e", "N/m"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "corners i, j, k, l", "edges ij, ik, il, jk, jl, kl: df(first)/dx(second)",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TetStiffnessObject, Space>>
using TetStiffnessView = physgen::View<TetStiffnessObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetStiffnessObject, Space>>
using TetStiffnessArray = physgen::Array<TetStiffnessObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<TetStiffnessObject, physgen::Host>({312, 4, {0, 96}}, {624, 8, {0, 192}}));

// ---- Tet ------------------------------------------------------------------------------------------------------------

/// Nodes of a tet.
template <class Real>
struct Tet {
  /// corners i, j, k, l; det(Dm) > 0
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> nodes = decltype(nodes)::Zero();
};

template <class Space>
struct TetFormats {
  using nodes = physgen::format::Native;
};

struct TetObject;
template <class ArrayTag, class Base = TetFormats<physgen::Host>, class Object = TetObject, int first = 0>
struct TetProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
};

template <class Real, class Formats>
struct TetRecord {
  using nodes = physgen::StoredField<TetRecord, 0, physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>;
  using fields_ = physgen::RecordFields<nodes>;
};

template <class Real, class Formats, class Cursor>
struct TetRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = TetRecord<Real, Formats>;
  using Value = Tet<typename Cursor::template Lanes<Real>>;

  /// corners i, j, k, l; det(Dm) > 0
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return this->field_(typename Record::nodes(), Record::nodes::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {nodes().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { nodes() = value.nodes; }
};

struct TetObject : physgen::ObjectTag<TetObject, Tet, TetFormats, TetRecord, TetRef, TetProbe> {
  static constexpr std::string_view name = "elasticity::Tet";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"nodes"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "corners i, j, k, l; det(Dm) > 0",
  };
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<TetObject, Space>>
using TetView = physgen::View<TetObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetObject, Space>>
using TetArray = physgen::Array<TetObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<TetObject, physgen::Host>({16, 4, {0}}, {16, 4, {0}}));

// ---- TetPlaces ------------------------------------------------------------------------------------------------------

/// Where the corners of a tet stand among the incidences of nodes.
template <class Real>
struct TetPlaces {
  /// of corners i, j, k, l: numbers of entries
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> places = decltype(places)::Zero();
};

template <class Space>
struct TetPlacesFormats {
  using places = physgen::format::Native;
};

struct TetPlacesObject;
template <class ArrayTag, class Base = TetPlacesFormats<physgen::Host>, class Object = TetPlacesObject, int first = 0>
struct TetPlacesProbe {
  using array_ = ArrayTag;
  using places = physgen::Probe<ArrayTag, Object, first + 0, typename Base::places>;
};

template <class Real, class Formats>
struct TetPlacesRecord {
  using places = physgen::StoredField<
      TetPlacesRecord, 0, physgen::shape::Vector<4>, typename Formats::places, std::int32_t>;
  using fields_ = physgen::RecordFields<places>;
};

template <class Real, class Formats, class Cursor>
struct TetPlacesRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = TetPlacesRecord<Real, Formats>;
  using Value = TetPlaces<typename Cursor::template Lanes<Real>>;

  /// of corners i, j, k, l: numbers of entries
  PHYSGEN_FUNCTION decltype(auto) places() const {
    return this->field_(typename Record::places(), Record::places::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {places().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { places() = value.places; }
};

struct TetPlacesObject : physgen::ObjectTag<
    TetPlacesObject, TetPlaces, TetPlacesFormats, TetPlacesRecord, TetPlacesRef, TetPlacesProbe> {
  static constexpr std::string_view name = "elasticity::TetPlaces";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"places"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "of corners i, j, k, l: numbers of entries",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TetPlacesObject, Space>>
using TetPlacesView = physgen::View<TetPlacesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetPlacesObject, Space>>
using TetPlacesArray = physgen::Array<TetPlacesObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<TetPlacesObject, physgen::Host>({16, 4, {0}}, {16, 4, {0}}));

// ---- Edge -----------------------------------------------------------------------------------------------------------

/// Nodes of an edge.
template <class Real>
struct Edge {
  /// m and n: the block of the edge is df(m)/dx(n)
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> nodes = decltype(nodes)::Zero();
};

template <class Space>
struct EdgeFormats {
  using nodes = physgen::format::Native;
};

struct EdgeObject;
template <class ArrayTag, class Base = EdgeFormats<physgen::Host>, class Object = EdgeObject, int first = 0>
struct EdgeProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
};

template <class Real, class Formats>
struct EdgeRecord {
  using nodes = physgen::StoredField<EdgeRecord, 0, physgen::shape::Vector<2>, typename Formats::nodes, std::int32_t>;
  using fields_ = physgen::RecordFields<nodes>;
};

template <class Real, class Formats, class Cursor>
struct EdgeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = EdgeRecord<Real, Formats>;
  using Value = Edge<typename Cursor::template Lanes<Real>>;

  /// m and n: the block of the edge is df(m)/dx(n)
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return this->field_(typename Record::nodes(), Record::nodes::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {nodes().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { nodes() = value.nodes; }
};

struct EdgeObject : physgen::ObjectTag<EdgeObject, Edge, EdgeFormats, EdgeRecord, EdgeRef, EdgeProbe> {
  static constexpr std::string_view name = "elasticity::Edge";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"nodes"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "m and n: the block of the edge is df(m)/dx(n)",
  };
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<EdgeObject, Space>>
using EdgeView = physgen::View<EdgeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<EdgeObject, Space>>
using EdgeArray = physgen::Array<EdgeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<EdgeObject, physgen::Host>({8, 4, {0}}, {8, 4, {0}}));

// ---- IncidenceRange -------------------------------------------------------------------------------------------------

/// The incidences of one node or edge: entries begin up to, not including, end of an array of Incidence.
template <class Real>
struct IncidenceRange {
  /// half-open range
  physgen::same_lanes_t<Real, std::int32_t> begin = {};
  /// half-open range
  physgen::same_lanes_t<Real, std::int32_t> end = {};
};

template <class Space>
struct IncidenceRangeFormats {
  using begin = physgen::format::Native;
  using end = physgen::format::Native;
};

struct IncidenceRangeObject;
template <class ArrayTag, class Base = IncidenceRangeFormats<physgen::Host>, class Object = IncidenceRangeObject,
          int first = 0>
struct IncidenceRangeProbe {
  using array_ = ArrayTag;
  using begin = physgen::Probe<ArrayTag, Object, first + 0, typename Base::begin>;
  using end = physgen::Probe<ArrayTag, Object, first + 1, typename Base::end>;
};

template <class Real, class Formats>
struct IncidenceRangeRecord {
  using begin = physgen::StoredField<
      IncidenceRangeRecord, 0, physgen::shape::Scalar, typename Formats::begin, std::int32_t>;
  using end = physgen::StoredField<
      IncidenceRangeRecord, 1, physgen::shape::Scalar, typename Formats::end, std::int32_t>;
  using fields_ = physgen::RecordFields<begin, end>;
};

template <class Real, class Formats, class Cursor>
struct IncidenceRangeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = IncidenceRangeRecord<Real, Formats>;
  using Value = IncidenceRange<typename Cursor::template Lanes<Real>>;

  /// half-open range
  PHYSGEN_FUNCTION decltype(auto) begin() const {
    return this->field_(typename Record::begin(), Record::begin::offset);
  }
  /// half-open range
  PHYSGEN_FUNCTION decltype(auto) end() const { return this->field_(typename Record::end(), Record::end::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {begin(), end()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    begin() = value.begin;
    end() = value.end;
  }
};

struct IncidenceRangeObject : physgen::ObjectTag<
    IncidenceRangeObject, IncidenceRange, IncidenceRangeFormats, IncidenceRangeRecord, IncidenceRangeRef,
    IncidenceRangeProbe> {
  static constexpr std::string_view name = "elasticity::IncidenceRange";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"begin"}, {"end"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "half-open range", "half-open range",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<IncidenceRangeObject, Space>>
using IncidenceRangeView = physgen::View<IncidenceRangeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<IncidenceRangeObject, Space>>
using IncidenceRangeArray = physgen::Array<IncidenceRangeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<IncidenceRangeObject, physgen::Host>({8, 4, {0, 4}}, {8, 4, {0, 4}}));

// ---- Incidence ------------------------------------------------------------------------------------------------------

/// An element that touches a node or an edge.
template <class Real>
struct Incidence {
  /// which tet, or which edge
  physgen::same_lanes_t<Real, std::int32_t> element = {};
  /// which of its corners, or of its edges, it is
  physgen::same_lanes_t<Real, std::int32_t> local = {};
};

template <class Space>
struct IncidenceFormats {
  using element = physgen::format::Native;
  using local = physgen::format::Native;
};

struct IncidenceObject;
template <class ArrayTag, class Base = IncidenceFormats<physgen::Host>, class Object = IncidenceObject, int first = 0>
struct IncidenceProbe {
  using array_ = ArrayTag;
  using element = physgen::Probe<ArrayTag, Object, first + 0, typename Base::element>;
  using local = physgen::Probe<ArrayTag, Object, first + 1, typename Base::local>;
};

template <class Real, class Formats>
struct IncidenceRecord {
  using element = physgen::StoredField<
      IncidenceRecord, 0, physgen::shape::Scalar, typename Formats::element, std::int32_t>;
  using local = physgen::StoredField<IncidenceRecord, 1, physgen::shape::Scalar, typename Formats::local, std::int32_t>;
  using fields_ = physgen::RecordFields<element, local>;
};

template <class Real, class Formats, class Cursor>
struct IncidenceRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = IncidenceRecord<Real, Formats>;
  using Value = Incidence<typename Cursor::template Lanes<Real>>;

  /// which tet, or which edge
  PHYSGEN_FUNCTION decltype(auto) element() const {
    return this->field_(typename Record::element(), Record::element::offset);
  }
  /// which of its corners, or of its edges, it is
  PHYSGEN_FUNCTION decltype(auto) local() const {
    return this->field_(typename Record::local(), Record::local::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {element(), local()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    element() = value.element;
    local() = value.local;
  }
};

struct IncidenceObject : physgen::ObjectTag<
    IncidenceObject, Incidence, IncidenceFormats, IncidenceRecord, IncidenceRef, IncidenceProbe> {
  static constexpr std::string_view name = "elasticity::Incidence";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"element"}, {"local"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "which tet, or which edge", "which of its corners, or of its edges, it is",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<IncidenceObject, Space>>
using IncidenceView = physgen::View<IncidenceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<IncidenceObject, Space>>
using IncidenceArray = physgen::Array<IncidenceObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<IncidenceObject, physgen::Host>({8, 4, {0, 4}}, {8, 4, {0, 4}}));

}  // namespace elasticity

#endif  // PHYSGEN_ELASTICITY_H_3A348FE4FB677C38
