// Accessor classes of the object types in quasistatic.h. Written by physgen: change the schema, not this file.
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
#ifndef PHYSGEN_QUASISTATIC_H_5F8FC0B54580FAFD
#define PHYSGEN_QUASISTATIC_H_5F8FC0B54580FAFD

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 7
#error "quasistatic.physgen.h is for version 7 of the physgen runtime: generate it again with the installed physgen"
#endif
#ifdef PHYSGEN_SCHEMA_H
#error "a program includes quasistatic.physgen.h in place of the schema: remove the #include of the schema"
#endif
#define PHYSGEN_GENERATED_HEADER

namespace quasistatic {

// ---- NodeConstraint -------------------------------------------------------------------------------------------------

/// Which components of a node's position are prescribed: bit k is set for component k.
template <class Real>
struct NodeConstraint {
  /// 0: free; 7: held in all directions
  physgen::same_lanes_t<Real, std::int32_t> fixed = {};
};

template <class Space>
struct NodeConstraintFormats {
  using fixed = physgen::format::Native;
};

struct NodeConstraintObject;
template <class ArrayTag, class Base = NodeConstraintFormats<physgen::Host>, class Object = NodeConstraintObject,
          int first = 0>
struct NodeConstraintProbe {
  using array_ = ArrayTag;
  using fixed = physgen::Probe<ArrayTag, Object, first + 0, typename Base::fixed>;
};

template <class Real, class Formats>
struct NodeConstraintRecord {
  using fixed = physgen::StoredField<
      NodeConstraintRecord, 0, physgen::shape::Scalar, typename Formats::fixed, std::int32_t>;
  using fields_ = physgen::RecordFields<fixed>;
};

template <class Real, class Formats, class Cursor>
struct NodeConstraintRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeConstraintRecord<Real, Formats>;
  using Value = NodeConstraint<typename Cursor::template Lanes<Real>>;

  /// 0: free; 7: held in all directions
  PHYSGEN_FUNCTION decltype(auto) fixed() const {
    return this->field_(typename Record::fixed(), Record::fixed::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {fixed()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { fixed() = value.fixed; }
};

struct NodeConstraintObject : physgen::ObjectTag<
    NodeConstraintObject, NodeConstraint, NodeConstraintFormats, NodeConstraintRecord, NodeConstraintRef,
    NodeConstraintProbe> {
  static constexpr std::string_view name = "quasistatic::NodeConstraint";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"fixed"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "0: free; 7: held in all directions",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeConstraintObject, Space>>
using NodeConstraintView = physgen::View<NodeConstraintObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeConstraintObject, Space>>
using NodeConstraintArray = physgen::Array<NodeConstraintObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeConstraintObject, physgen::Host>({4, 4, {0}}, {4, 4, {0}}));

// ---- NodeParents ----------------------------------------------------------------------------------------------------

/// The two nodes of the next coarser level half-way between which a node lies; twice the same where it coincides.
template <class Real>
struct NodeParents {
  /// numbers on the coarser level
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> nodes = decltype(nodes)::Zero();
};

template <class Space>
struct NodeParentsFormats {
  using nodes = physgen::format::Native;
};

struct NodeParentsObject;
template <class ArrayTag, class Base = NodeParentsFormats<physgen::Host>, class Object = NodeParentsObject,
          int first = 0>
struct NodeParentsProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
};

template <class Real, class Formats>
struct NodeParentsRecord {
  using nodes = physgen::StoredField<
      NodeParentsRecord, 0, physgen::shape::Vector<2>, typename Formats::nodes, std::int32_t>;
  using fields_ = physgen::RecordFields<nodes>;
};

template <class Real, class Formats, class Cursor>
struct NodeParentsRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeParentsRecord<Real, Formats>;
  using Value = NodeParents<typename Cursor::template Lanes<Real>>;

  /// numbers on the coarser level
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return this->field_(typename Record::nodes(), Record::nodes::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {nodes().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { nodes() = value.nodes; }
};

struct NodeParentsObject : physgen::ObjectTag<
    NodeParentsObject, NodeParents, NodeParentsFormats, NodeParentsRecord, NodeParentsRef, NodeParentsProbe> {
  static constexpr std::string_view name = "quasistatic::NodeParents";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"nodes"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "numbers on the coarser level",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeParentsObject, Space>>
using NodeParentsView = physgen::View<NodeParentsObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeParentsObject, Space>>
using NodeParentsArray = physgen::Array<NodeParentsObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeParentsObject, physgen::Host>({8, 4, {0}}, {8, 4, {0}}));

// ---- GridParents ----------------------------------------------------------------------------------------------------

/// The tet of a background grid in which a node lies: linear interpolation between its corners.
template <class Real>
struct GridParents {
  /// numbers on the coarser level; a corner without weight repeats the first
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> nodes = decltype(nodes)::Zero();
  /// they add up to 1 [1]
  physgen::MatrixValue<Real, 4, 1> weights = decltype(weights)::Zero();
};

template <class Space>
struct GridParentsFormats {
  using nodes = physgen::format::Native;
  using weights = physgen::format::Native;
};

struct GridParentsObject;
template <class ArrayTag, class Base = GridParentsFormats<physgen::Host>, class Object = GridParentsObject,
          int first = 0>
struct GridParentsProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
  using weights = physgen::Probe<ArrayTag, Object, first + 1, typename Base::weights>;
};

template <class Real, class Formats>
struct GridParentsRecord {
  using nodes = physgen::StoredField<
      GridParentsRecord, 0, physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>;
  using weights = physgen::StoredField<
      GridParentsRecord, 1, physgen::shape::Vector<4>, typename Formats::weights, Real>;
  using fields_ = physgen::RecordFields<nodes, weights>;
};

template <class Real, class Formats, class Cursor>
struct GridParentsRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = GridParentsRecord<Real, Formats>;
  using Value = GridParents<typename Cursor::template Lanes<Real>>;

  /// numbers on the coarser level; a corner without weight repeats the first
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return this->field_(typename Record::nodes(), Record::nodes::offset);
  }
  /// they add up to 1 [1]
  PHYSGEN_FUNCTION decltype(auto) weights() const {
    return this->field_(typename Record::weights(), Record::weights::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {nodes().get(), weights().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    nodes() = value.nodes;
    weights() = value.weights;
  }
};

struct GridParentsObject : physgen::ObjectTag<
    GridParentsObject, GridParents, GridParentsFormats, GridParentsRecord, GridParentsRef, GridParentsProbe> {
  static constexpr std::string_view name = "quasistatic::GridParents";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"nodes"}, {"weights", "1"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "numbers on the coarser level; a corner without weight repeats the first", "they add up to 1",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<GridParentsObject, Space>>
using GridParentsView = physgen::View<GridParentsObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<GridParentsObject, Space>>
using GridParentsArray = physgen::Array<GridParentsObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<GridParentsObject, physgen::Host>({32, 4, {0, 16}}, {48, 8, {32, 0}}));

// ---- NodeScale ------------------------------------------------------------------------------------------------------

/// The scale of a node's unknowns inside the preconditioner, a power of two, so that scaling rounds nothing.
template <class Real>
struct NodeScale {
  /// the largest entry on the diagonal of scale^2 K is in [1/2, 2)
  Real scale = {};
  /// 1 / scale
  Real inverse = {};
};

template <class Space>
struct NodeScaleFormats {
  using scale = physgen::format::Native;
  using inverse = physgen::format::Native;
};

struct NodeScaleObject;
template <class ArrayTag, class Base = NodeScaleFormats<physgen::Host>, class Object = NodeScaleObject, int first = 0>
struct NodeScaleProbe {
  using array_ = ArrayTag;
  using scale = physgen::Probe<ArrayTag, Object, first + 0, typename Base::scale>;
  using inverse = physgen::Probe<ArrayTag, Object, first + 1, typename Base::inverse>;
};

template <class Real, class Formats>
struct NodeScaleRecord {
  using scale = physgen::StoredField<NodeScaleRecord, 0, physgen::shape::Scalar, typename Formats::scale, Real>;
  using inverse = physgen::StoredField<NodeScaleRecord, 1, physgen::shape::Scalar, typename Formats::inverse, Real>;
  using fields_ = physgen::RecordFields<scale, inverse>;
};

template <class Real, class Formats, class Cursor>
struct NodeScaleRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeScaleRecord<Real, Formats>;
  using Value = NodeScale<typename Cursor::template Lanes<Real>>;

  /// the largest entry on the diagonal of scale^2 K is in [1/2, 2)
  PHYSGEN_FUNCTION decltype(auto) scale() const {
    return this->field_(typename Record::scale(), Record::scale::offset);
  }
  /// 1 / scale
  PHYSGEN_FUNCTION decltype(auto) inverse() const {
    return this->field_(typename Record::inverse(), Record::inverse::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {scale(), inverse()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    scale() = value.scale;
    inverse() = value.inverse;
  }
};

struct NodeScaleObject : physgen::ObjectTag<
    NodeScaleObject, NodeScale, NodeScaleFormats, NodeScaleRecord, NodeScaleRef, NodeScaleProbe> {
  static constexpr std::string_view name = "quasistatic::NodeScale";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"scale"}, {"inverse"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "the largest entry on the diagonal of scale^2 K is in [1/2, 2)", "1 / scale",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeScaleObject, Space>>
using NodeScaleView = physgen::View<NodeScaleObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeScaleObject, Space>>
using NodeScaleArray = physgen::Array<NodeScaleObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeScaleObject, physgen::Host>({8, 4, {0, 4}}, {16, 8, {0, 8}}));

// ---- NodeInverse ----------------------------------------------------------------------------------------------------

/// The inverse of a node's diagonal block: block Jacobi.
template <class Real>
struct NodeInverse {
  /// -K^-1 over the free components, 0 in prescribed ones. Symmetric, 6 stored.
  physgen::MatrixValue<Real, 3, 3> D = decltype(D)::Zero();
};

template <class Space>
struct NodeInverseFormats {
  using D = physgen::format::Native;
};

struct NodeInverseObject;
template <class ArrayTag, class Base = NodeInverseFormats<physgen::Host>, class Object = NodeInverseObject,
          int first = 0>
struct NodeInverseProbe {
  using array_ = ArrayTag;
  using D = physgen::Probe<ArrayTag, Object, first + 0, typename Base::D>;
};

template <class Real, class Formats>
struct NodeInverseRecord {
  using D = physgen::StoredField<NodeInverseRecord, 0, physgen::shape::Symmetric<3>, typename Formats::D, Real>;
  using fields_ = physgen::RecordFields<D>;
};

template <class Real, class Formats, class Cursor>
struct NodeInverseRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeInverseRecord<Real, Formats>;
  using Value = NodeInverse<typename Cursor::template Lanes<Real>>;

  /// -K^-1 over the free components, 0 in prescribed ones. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) D() const { return this->field_(typename Record::D(), Record::D::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {D().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { D() = value.D; }
};

struct NodeInverseObject : physgen::ObjectTag<
    NodeInverseObject, NodeInverse, NodeInverseFormats, NodeInverseRecord, NodeInverseRef, NodeInverseProbe> {
  static constexpr std::string_view name = "quasistatic::NodeInverse";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"D"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "-K^-1 over the free components, 0 in prescribed ones",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeInverseObject, Space>>
using NodeInverseView = physgen::View<NodeInverseObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<NodeInverseObject, Space>>
using NodeInverseArray = physgen::Array<NodeInverseObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeInverseObject, physgen::Host>({24, 4, {0}}, {48, 8, {0}}));

// ---- TranslationStiffness -------------------------------------------------------------------------------------------

/// How stiffness without its prescribed components resists a translation of all nodes: its rows, summed.
template <class Real>
struct TranslationStiffness {
  /// sum of df(v)/dx(w) over all nodes w; 0 far from what is prescribed [N/m]
  physgen::MatrixValue<Real, 3, 3> T = decltype(T)::Zero();
};

template <class Space>
struct TranslationStiffnessFormats {
  using T = physgen::format::Native;
};

struct TranslationStiffnessObject;
template <class ArrayTag, class Base = TranslationStiffnessFormats<physgen::Host>,
          class Object = TranslationStiffnessObject, int first = 0>
struct TranslationStiffnessProbe {
  using array_ = ArrayTag;
  using T = physgen::Probe<ArrayTag, Object, first + 0, typename Base::T>;
};

template <class Real, class Formats>
struct TranslationStiffnessRecord {
  using T = physgen::StoredField<
      TranslationStiffnessRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::T, Real>;
  using fields_ = physgen::RecordFields<T>;
};

template <class Real, class Formats, class Cursor>
struct TranslationStiffnessRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = TranslationStiffnessRecord<Real, Formats>;
  using Value = TranslationStiffness<typename Cursor::template Lanes<Real>>;

  /// sum of df(v)/dx(w) over all nodes w; 0 far from what is prescribed [N/m]
  PHYSGEN_FUNCTION decltype(auto) T() const { return this->field_(typename Record::T(), Record::T::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {T().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { T() = value.T; }
};

struct TranslationStiffnessObject : physgen::ObjectTag<
    TranslationStiffnessObject, TranslationStiffness, TranslationStiffnessFormats, TranslationStiffnessRecord,
    TranslationStiffnessRef, TranslationStiffnessProbe> {
  static constexpr std::string_view name = "quasistatic::TranslationStiffness";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"T", "N/m"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "sum of df(v)/dx(w) over all nodes w; 0 far from what is prescribed",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TranslationStiffnessObject, Space>>
using TranslationStiffnessView = physgen::View<TranslationStiffnessObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<TranslationStiffnessObject, Space>>
using TranslationStiffnessArray = physgen::Array<TranslationStiffnessObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<TranslationStiffnessObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- TetTangent -----------------------------------------------------------------------------------------------------

/// The tangent of one tet: the blocks of its edges are formed from it where they are summed.
template <class Real>
struct TetTangent {
  /// principal directions in the current shape
  physgen::MatrixValue<Real, 3, 3> U = decltype(U)::Zero();
  /// by columns: V^T grad of corners j, k, l [1/m]
  physgen::MatrixValue<Real, 3, 3> g = decltype(g)::Zero();
  /// volume times those of StressDerivative [N m]
  Real x1111 = {};
  /// volume times those of StressDerivative [N m]
  Real x2211 = {};
  /// volume times those of StressDerivative [N m]
  Real x3311 = {};
  /// volume times those of StressDerivative [N m]
  Real x2222 = {};
  /// volume times those of StressDerivative [N m]
  Real x3322 = {};
  /// volume times those of StressDerivative [N m]
  Real x3333 = {};
  /// volume times those of StressDerivative [N m]
  Real x2121 = {};
  /// volume times those of StressDerivative [N m]
  Real x2112 = {};
  /// volume times those of StressDerivative [N m]
  Real x3131 = {};
  /// volume times those of StressDerivative [N m]
  Real x3113 = {};
  /// volume times those of StressDerivative [N m]
  Real x3232 = {};
  /// volume times those of StressDerivative [N m]
  Real x3223 = {};
};

template <class Space>
struct TetTangentFormats {
  using U = physgen::format::Native;
  using g = physgen::format::Native;
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

struct TetTangentObject;
template <class ArrayTag, class Base = TetTangentFormats<physgen::Host>, class Object = TetTangentObject, int first = 0>
struct TetTangentProbe {
  using array_ = ArrayTag;
  using U = physgen::Probe<ArrayTag, Object, first + 0, typename Base::U>;
  using g = physgen::Probe<ArrayTag, Object, first + 1, typename Base::g>;
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
};

template <class Real, class Formats>
struct TetTangentRecord {
  using U = physgen::StoredField<TetTangentRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::U, Real>;
  using g = physgen::StoredField<TetTangentRecord, 1, physgen::shape::Matrix<3, 3>, typename Formats::g, Real>;
  using x1111 = physgen::StoredField<TetTangentRecord, 2, physgen::shape::Scalar, typename Formats::x1111, Real>;
  using x2211 = physgen::StoredField<TetTangentRecord, 3, physgen::shape::Scalar, typename Formats::x2211, Real>;
  using x3311 = physgen::StoredField<TetTangentRecord, 4, physgen::shape::Scalar, typename Formats::x3311, Real>;
  using x2222 = physgen::StoredField<TetTangentRecord, 5, physgen::shape::Scalar, typename Formats::x2222, Real>;
  using x3322 = physgen::StoredField<TetTangentRecord, 6, physgen::shape::Scalar, typename Formats::x3322, Real>;
  using x3333 = physgen::StoredField<TetTangentRecord, 7, physgen::shape::Scalar, typename Formats::x3333, Real>;
  using x2121 = physgen::StoredField<TetTangentRecord, 8, physgen::shape::Scalar, typename Formats::x2121, Real>;
  using x2112 = physgen::StoredField<TetTangentRecord, 9, physgen::shape::Scalar, typename Formats::x2112, Real>;
  using x3131 = physgen::StoredField<TetTangentRecord, 10, physgen::shape::Scalar, typename Formats::x3131, Real>;
  using x3113 = physgen::StoredField<TetTangentRecord, 11, physgen::shape::Scalar, typename Formats::x3113, Real>;
  using x3232 = physgen::StoredField<TetTangentRecord, 12, physgen::shape::Scalar, typename Formats::x3232, Real>;
  using x3223 = physgen::StoredField<TetTangentRecord, 13, physgen::shape::Scalar, typename Formats::x3223, Real>;
  using fields_ = physgen::RecordFields<
      U, g, x1111, x2211, x3311, x2222, x3322, x3333, x2121, x2112, x3131, x3113, x3232, x3223>;
};

template <class Real, class Formats, class Cursor>
struct TetTangentRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = TetTangentRecord<Real, Formats>;
  using Value = TetTangent<typename Cursor::template Lanes<Real>>;

  /// principal directions in the current shape
  PHYSGEN_FUNCTION decltype(auto) U() const { return this->field_(typename Record::U(), Record::U::offset); }
  /// by columns: V^T grad of corners j, k, l [1/m]
  PHYSGEN_FUNCTION decltype(auto) g() const { return this->field_(typename Record::g(), Record::g::offset); }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x1111() const {
    return this->field_(typename Record::x1111(), Record::x1111::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x2211() const {
    return this->field_(typename Record::x2211(), Record::x2211::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3311() const {
    return this->field_(typename Record::x3311(), Record::x3311::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x2222() const {
    return this->field_(typename Record::x2222(), Record::x2222::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3322() const {
    return this->field_(typename Record::x3322(), Record::x3322::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3333() const {
    return this->field_(typename Record::x3333(), Record::x3333::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x2121() const {
    return this->field_(typename Record::x2121(), Record::x2121::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x2112() const {
    return this->field_(typename Record::x2112(), Record::x2112::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3131() const {
    return this->field_(typename Record::x3131(), Record::x3131::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3113() const {
    return this->field_(typename Record::x3113(), Record::x3113::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3232() const {
    return this->field_(typename Record::x3232(), Record::x3232::offset);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3223() const {
    return this->field_(typename Record::x3223(), Record::x3223::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {
        U().get(), g().get(), x1111(), x2211(), x3311(), x2222(), x3322(), x3333(), x2121(), x2112(), x3131(), x3113(),
        x3232(), x3223()};
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    U() = value.U;
    g() = value.g;
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

struct TetTangentObject : physgen::ObjectTag<
    TetTangentObject, TetTangent, TetTangentFormats, TetTangentRecord, TetTangentRef, TetTangentProbe> {
  static constexpr std::string_view name = "quasistatic::TetTangent";
  static constexpr std::array<physgen::FieldText, 14> texts = {{
      {"U"}, {"g", "1/m"}, {"x1111", "N m"}, {"x2211", "N m"}, {"x3311", "N m"}, {"x2222", "N m"}, {"x3322", "N m"},
      {"x3333", "N m"}, {"x2121", "N m"}, {"x2112", "N m"}, {"x3131", "N m"}, {"x3113", "N m"}, {"x3232", "N m"},
      {"x3223", "N m"}}};
  static constexpr std::array<std::string_view, 14> docs = {
    "principal directions in the current shape", "by columns: V^T grad of corners j, k, l",
    "volume times those of StressDerivative", "volume times those of StressDerivative",
    "volume times those of StressDerivative", "volume times those of StressDerivative",
    "volume times those of StressDerivative", "volume times those of StressDerivative",
    "volume times those of StressDerivative", "volume times those of StressDerivative",
    "volume times those of StressDerivative", "volume times those of StressDerivative",
    "volume times those of StressDerivative", "volume times those of StressDerivative",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TetTangentObject, Space>>
using TetTangentView = physgen::View<TetTangentObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetTangentObject, Space>>
using TetTangentArray = physgen::Array<TetTangentObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<TetTangentObject, physgen::Host>(
    {120, 4, {0, 36, 72, 76, 80, 84, 88, 92, 96, 100, 104, 108, 112, 116}},
    {240, 8, {0, 72, 144, 152, 160, 168, 176, 184, 192, 200, 208, 216, 224, 232}}));

// ---- TetPatch -------------------------------------------------------------------------------------------------------

/// Which patch a tet's volume is averaged over.
template <class Real>
struct TetPatch {
  /// its number
  physgen::same_lanes_t<Real, std::int32_t> patch = {};
};

template <class Space>
struct TetPatchFormats {
  using patch = physgen::format::Native;
};

struct TetPatchObject;
template <class ArrayTag, class Base = TetPatchFormats<physgen::Host>, class Object = TetPatchObject, int first = 0>
struct TetPatchProbe {
  using array_ = ArrayTag;
  using patch = physgen::Probe<ArrayTag, Object, first + 0, typename Base::patch>;
};

template <class Real, class Formats>
struct TetPatchRecord {
  using patch = physgen::StoredField<TetPatchRecord, 0, physgen::shape::Scalar, typename Formats::patch, std::int32_t>;
  using fields_ = physgen::RecordFields<patch>;
};

template <class Real, class Formats, class Cursor>
struct TetPatchRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = TetPatchRecord<Real, Formats>;
  using Value = TetPatch<typename Cursor::template Lanes<Real>>;

  /// its number
  PHYSGEN_FUNCTION decltype(auto) patch() const {
    return this->field_(typename Record::patch(), Record::patch::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {patch()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { patch() = value.patch; }
};

struct TetPatchObject : physgen::ObjectTag<
    TetPatchObject, TetPatch, TetPatchFormats, TetPatchRecord, TetPatchRef, TetPatchProbe> {
  static constexpr std::string_view name = "quasistatic::TetPatch";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"patch"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "its number",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TetPatchObject, Space>>
using TetPatchView = physgen::View<TetPatchObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetPatchObject, Space>>
using TetPatchArray = physgen::Array<TetPatchObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<TetPatchObject, physgen::Host>({4, 4, {0}}, {4, 4, {0}}));

// ---- PatchParent ----------------------------------------------------------------------------------------------------

/// The patch of the next coarser level where a patch lies.
template <class Real>
struct PatchParent {
  /// its number on the coarser level
  physgen::same_lanes_t<Real, std::int32_t> patch = {};
};

template <class Space>
struct PatchParentFormats {
  using patch = physgen::format::Native;
};

struct PatchParentObject;
template <class ArrayTag, class Base = PatchParentFormats<physgen::Host>, class Object = PatchParentObject,
          int first = 0>
struct PatchParentProbe {
  using array_ = ArrayTag;
  using patch = physgen::Probe<ArrayTag, Object, first + 0, typename Base::patch>;
};

template <class Real, class Formats>
struct PatchParentRecord {
  using patch = physgen::StoredField<
      PatchParentRecord, 0, physgen::shape::Scalar, typename Formats::patch, std::int32_t>;
  using fields_ = physgen::RecordFields<patch>;
};

template <class Real, class Formats, class Cursor>
struct PatchParentRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PatchParentRecord<Real, Formats>;
  using Value = PatchParent<typename Cursor::template Lanes<Real>>;

  /// its number on the coarser level
  PHYSGEN_FUNCTION decltype(auto) patch() const {
    return this->field_(typename Record::patch(), Record::patch::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {patch()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { patch() = value.patch; }
};

struct PatchParentObject : physgen::ObjectTag<
    PatchParentObject, PatchParent, PatchParentFormats, PatchParentRecord, PatchParentRef, PatchParentProbe> {
  static constexpr std::string_view name = "quasistatic::PatchParent";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"patch"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "its number on the coarser level",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchParentObject, Space>>
using PatchParentView = physgen::View<PatchParentObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchParentObject, Space>>
using PatchParentArray = physgen::Array<PatchParentObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PatchParentObject, physgen::Host>({4, 4, {0}}, {4, 4, {0}}));

// ---- PatchNodes -----------------------------------------------------------------------------------------------------

/// The nodes of a patch of tets.
template <class Real>
struct PatchNodes {
  /// unused ones repeat the first
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 8, 1> nodes = decltype(nodes)::Zero();
};

template <class Space>
struct PatchNodesFormats {
  using nodes = physgen::format::Native;
};

struct PatchNodesObject;
template <class ArrayTag, class Base = PatchNodesFormats<physgen::Host>, class Object = PatchNodesObject, int first = 0>
struct PatchNodesProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
};

template <class Real, class Formats>
struct PatchNodesRecord {
  using nodes = physgen::StoredField<
      PatchNodesRecord, 0, physgen::shape::Vector<8>, typename Formats::nodes, std::int32_t>;
  using fields_ = physgen::RecordFields<nodes>;
};

template <class Real, class Formats, class Cursor>
struct PatchNodesRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PatchNodesRecord<Real, Formats>;
  using Value = PatchNodes<typename Cursor::template Lanes<Real>>;

  /// unused ones repeat the first
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return this->field_(typename Record::nodes(), Record::nodes::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {nodes().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { nodes() = value.nodes; }
};

struct PatchNodesObject : physgen::ObjectTag<
    PatchNodesObject, PatchNodes, PatchNodesFormats, PatchNodesRecord, PatchNodesRef, PatchNodesProbe> {
  static constexpr std::string_view name = "quasistatic::PatchNodes";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"nodes"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "unused ones repeat the first",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchNodesObject, Space>>
using PatchNodesView = physgen::View<PatchNodesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchNodesObject, Space>>
using PatchNodesArray = physgen::Array<PatchNodesObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PatchNodesObject, physgen::Host>({32, 4, {0}}, {32, 4, {0}}));

// ---- PatchTet -------------------------------------------------------------------------------------------------------

/// A tet of a patch.
template <class Real>
struct PatchTet {
  /// its number
  physgen::same_lanes_t<Real, std::int32_t> tet = {};
  /// which of the patch's nodes its corners are: 3 bits each, corner i lowest
  physgen::same_lanes_t<Real, std::int32_t> slots = {};
};

template <class Space>
struct PatchTetFormats {
  using tet = physgen::format::Native;
  using slots = physgen::format::Native;
};

struct PatchTetObject;
template <class ArrayTag, class Base = PatchTetFormats<physgen::Host>, class Object = PatchTetObject, int first = 0>
struct PatchTetProbe {
  using array_ = ArrayTag;
  using tet = physgen::Probe<ArrayTag, Object, first + 0, typename Base::tet>;
  using slots = physgen::Probe<ArrayTag, Object, first + 1, typename Base::slots>;
};

template <class Real, class Formats>
struct PatchTetRecord {
  using tet = physgen::StoredField<PatchTetRecord, 0, physgen::shape::Scalar, typename Formats::tet, std::int32_t>;
  using slots = physgen::StoredField<PatchTetRecord, 1, physgen::shape::Scalar, typename Formats::slots, std::int32_t>;
  using fields_ = physgen::RecordFields<tet, slots>;
};

template <class Real, class Formats, class Cursor>
struct PatchTetRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PatchTetRecord<Real, Formats>;
  using Value = PatchTet<typename Cursor::template Lanes<Real>>;

  /// its number
  PHYSGEN_FUNCTION decltype(auto) tet() const { return this->field_(typename Record::tet(), Record::tet::offset); }
  /// which of the patch's nodes its corners are: 3 bits each, corner i lowest
  PHYSGEN_FUNCTION decltype(auto) slots() const {
    return this->field_(typename Record::slots(), Record::slots::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {tet(), slots()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    tet() = value.tet;
    slots() = value.slots;
  }
};

struct PatchTetObject : physgen::ObjectTag<
    PatchTetObject, PatchTet, PatchTetFormats, PatchTetRecord, PatchTetRef, PatchTetProbe> {
  static constexpr std::string_view name = "quasistatic::PatchTet";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"tet"}, {"slots"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "its number", "which of the patch's nodes its corners are: 3 bits each, corner i lowest",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchTetObject, Space>>
using PatchTetView = physgen::View<PatchTetObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<PatchTetObject, Space>>
using PatchTetArray = physgen::Array<PatchTetObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PatchTetObject, physgen::Host>({8, 4, {0, 4}}, {8, 4, {0, 4}}));

// ---- MeanVolume -----------------------------------------------------------------------------------------------------

/// The volume of a patch, or the mean one of the tets of a node, and what resists its change.
template <class Real>
struct MeanVolume {
  /// at rest [m^3]
  Real volume = {};
  /// T: current over rest volume [1]
  Real ratio = {};
  /// U'(T): of the forces [Pa]
  Real pressure = {};
  /// pi, which converges to U'(T) T or, of a quadratic law, to U'(T) [Pa]
  Real linearised = {};
  /// of the tangent [Pa]
  Real tangent_pressure = {};
  /// pi before a Newton step, and after all of it [Pa]
  Real before = {};
  /// pi before a Newton step, and after all of it [Pa]
  Real full = {};
};

template <class Space>
struct MeanVolumeFormats {
  using volume = physgen::format::Native;
  using ratio = physgen::format::Native;
  using pressure = physgen::format::Native;
  using linearised = physgen::format::Native;
  using tangent_pressure = physgen::format::Native;
  using before = physgen::format::Native;
  using full = physgen::format::Native;
};

struct MeanVolumeObject;
template <class ArrayTag, class Base = MeanVolumeFormats<physgen::Host>, class Object = MeanVolumeObject, int first = 0>
struct MeanVolumeProbe {
  using array_ = ArrayTag;
  using volume = physgen::Probe<ArrayTag, Object, first + 0, typename Base::volume>;
  using ratio = physgen::Probe<ArrayTag, Object, first + 1, typename Base::ratio>;
  using pressure = physgen::Probe<ArrayTag, Object, first + 2, typename Base::pressure>;
  using linearised = physgen::Probe<ArrayTag, Object, first + 3, typename Base::linearised>;
  using tangent_pressure = physgen::Probe<ArrayTag, Object, first + 4, typename Base::tangent_pressure>;
  using before = physgen::Probe<ArrayTag, Object, first + 5, typename Base::before>;
  using full = physgen::Probe<ArrayTag, Object, first + 6, typename Base::full>;
};

template <class Real, class Formats>
struct MeanVolumeRecord {
  using volume = physgen::StoredField<MeanVolumeRecord, 0, physgen::shape::Scalar, typename Formats::volume, Real>;
  using ratio = physgen::StoredField<MeanVolumeRecord, 1, physgen::shape::Scalar, typename Formats::ratio, Real>;
  using pressure = physgen::StoredField<MeanVolumeRecord, 2, physgen::shape::Scalar, typename Formats::pressure, Real>;
  using linearised = physgen::StoredField<
      MeanVolumeRecord, 3, physgen::shape::Scalar, typename Formats::linearised, Real>;
  using tangent_pressure = physgen::StoredField<
      MeanVolumeRecord, 4, physgen::shape::Scalar, typename Formats::tangent_pressure, Real>;
  using before = physgen::StoredField<MeanVolumeRecord, 5, physgen::shape::Scalar, typename Formats::before, Real>;
  using full = physgen::StoredField<MeanVolumeRecord, 6, physgen::shape::Scalar, typename Formats::full, Real>;
  using fields_ = physgen::RecordFields<volume, ratio, pressure, linearised, tangent_pressure, before, full>;
};

template <class Real, class Formats, class Cursor>
struct MeanVolumeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = MeanVolumeRecord<Real, Formats>;
  using Value = MeanVolume<typename Cursor::template Lanes<Real>>;

  /// at rest [m^3]
  PHYSGEN_FUNCTION decltype(auto) volume() const {
    return this->field_(typename Record::volume(), Record::volume::offset);
  }
  /// T: current over rest volume [1]
  PHYSGEN_FUNCTION decltype(auto) ratio() const {
    return this->field_(typename Record::ratio(), Record::ratio::offset);
  }
  /// U'(T): of the forces [Pa]
  PHYSGEN_FUNCTION decltype(auto) pressure() const {
    return this->field_(typename Record::pressure(), Record::pressure::offset);
  }
  /// pi, which converges to U'(T) T or, of a quadratic law, to U'(T) [Pa]
  PHYSGEN_FUNCTION decltype(auto) linearised() const {
    return this->field_(typename Record::linearised(), Record::linearised::offset);
  }
  /// of the tangent [Pa]
  PHYSGEN_FUNCTION decltype(auto) tangent_pressure() const {
    return this->field_(typename Record::tangent_pressure(), Record::tangent_pressure::offset);
  }
  /// pi before a Newton step, and after all of it [Pa]
  PHYSGEN_FUNCTION decltype(auto) before() const {
    return this->field_(typename Record::before(), Record::before::offset);
  }
  /// pi before a Newton step, and after all of it [Pa]
  PHYSGEN_FUNCTION decltype(auto) full() const { return this->field_(typename Record::full(), Record::full::offset); }

  PHYSGEN_FUNCTION const Value get() const {
    return {volume(), ratio(), pressure(), linearised(), tangent_pressure(), before(), full()};
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    volume() = value.volume;
    ratio() = value.ratio;
    pressure() = value.pressure;
    linearised() = value.linearised;
    tangent_pressure() = value.tangent_pressure;
    before() = value.before;
    full() = value.full;
  }
};

struct MeanVolumeObject : physgen::ObjectTag<
    MeanVolumeObject, MeanVolume, MeanVolumeFormats, MeanVolumeRecord, MeanVolumeRef, MeanVolumeProbe> {
  static constexpr std::string_view name = "quasistatic::MeanVolume";
  static constexpr std::array<physgen::FieldText, 7> texts = {{
      {"volume", "m^3"}, {"ratio", "1"}, {"pressure", "Pa"}, {"linearised", "Pa"}, {"tangent_pressure", "Pa"},
      {"before", "Pa"}, {"full", "Pa"}}};
  static constexpr std::array<std::string_view, 7> docs = {
    "at rest", "T: current over rest volume", "U'(T): of the forces",
    "pi, which converges to U'(T) T or, of a quadratic law, to U'(T)", "of the tangent",
    "pi before a Newton step, and after all of it", "pi before a Newton step, and after all of it",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<MeanVolumeObject, Space>>
using MeanVolumeView = physgen::View<MeanVolumeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<MeanVolumeObject, Space>>
using MeanVolumeArray = physgen::Array<MeanVolumeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<MeanVolumeObject, physgen::Host>(
    {28, 4, {0, 4, 8, 12, 16, 20, 24}}, {56, 8, {0, 8, 16, 24, 32, 40, 48}}));

// ---- RingNode -------------------------------------------------------------------------------------------------------

/// One of a node's ring: a neighbour, or the node itself. Neighbours are in each other's rings.
template <class Real>
struct RingNode {
  /// its number
  physgen::same_lanes_t<Real, std::int32_t> node = {};
  /// change of its mean volume with the node whose ring it is in [m^2]
  physgen::MatrixValue<Real, 3, 1> g = decltype(g)::Zero();
};

template <class Space>
struct RingNodeFormats {
  using node = physgen::format::Native;
  using g = physgen::format::Native;
};

struct RingNodeObject;
template <class ArrayTag, class Base = RingNodeFormats<physgen::Host>, class Object = RingNodeObject, int first = 0>
struct RingNodeProbe {
  using array_ = ArrayTag;
  using node = physgen::Probe<ArrayTag, Object, first + 0, typename Base::node>;
  using g = physgen::Probe<ArrayTag, Object, first + 1, typename Base::g>;
};

template <class Real, class Formats>
struct RingNodeRecord {
  using node = physgen::StoredField<RingNodeRecord, 0, physgen::shape::Scalar, typename Formats::node, std::int32_t>;
  using g = physgen::StoredField<RingNodeRecord, 1, physgen::shape::Vector<3>, typename Formats::g, Real>;
  using fields_ = physgen::RecordFields<node, g>;
};

template <class Real, class Formats, class Cursor>
struct RingNodeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = RingNodeRecord<Real, Formats>;
  using Value = RingNode<typename Cursor::template Lanes<Real>>;

  /// its number
  PHYSGEN_FUNCTION decltype(auto) node() const { return this->field_(typename Record::node(), Record::node::offset); }
  /// change of its mean volume with the node whose ring it is in [m^2]
  PHYSGEN_FUNCTION decltype(auto) g() const { return this->field_(typename Record::g(), Record::g::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {node(), g().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    node() = value.node;
    g() = value.g;
  }
};

struct RingNodeObject : physgen::ObjectTag<
    RingNodeObject, RingNode, RingNodeFormats, RingNodeRecord, RingNodeRef, RingNodeProbe> {
  static constexpr std::string_view name = "quasistatic::RingNode";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"node"}, {"g", "m^2"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "its number", "change of its mean volume with the node whose ring it is in",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<RingNodeObject, Space>>
using RingNodeView = physgen::View<RingNodeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<RingNodeObject, Space>>
using RingNodeArray = physgen::Array<RingNodeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<RingNodeObject, physgen::Host>({16, 4, {0, 4}}, {28, 8, {24, 0}}));

// ---- NodeVolumeTangent ----------------------------------------------------------------------------------------------

/// The resistance to a change of a node's mean volume: k of its k g g^T in the tangent.
template <class Real>
struct NodeVolumeTangent {
  /// U''(T) / volume, or its linearised form [N/m^5]
  Real k = {};
};

template <class Space>
struct NodeVolumeTangentFormats {
  using k = physgen::format::Native;
};

struct NodeVolumeTangentObject;
template <class ArrayTag, class Base = NodeVolumeTangentFormats<physgen::Host>, class Object = NodeVolumeTangentObject,
          int first = 0>
struct NodeVolumeTangentProbe {
  using array_ = ArrayTag;
  using k = physgen::Probe<ArrayTag, Object, first + 0, typename Base::k>;
};

template <class Real, class Formats>
struct NodeVolumeTangentRecord {
  using k = physgen::StoredField<NodeVolumeTangentRecord, 0, physgen::shape::Scalar, typename Formats::k, Real>;
  using fields_ = physgen::RecordFields<k>;
};

template <class Real, class Formats, class Cursor>
struct NodeVolumeTangentRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeVolumeTangentRecord<Real, Formats>;
  using Value = NodeVolumeTangent<typename Cursor::template Lanes<Real>>;

  /// U''(T) / volume, or its linearised form [N/m^5]
  PHYSGEN_FUNCTION decltype(auto) k() const { return this->field_(typename Record::k(), Record::k::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {k()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { k() = value.k; }
};

struct NodeVolumeTangentObject : physgen::ObjectTag<
    NodeVolumeTangentObject, NodeVolumeTangent, NodeVolumeTangentFormats, NodeVolumeTangentRecord, NodeVolumeTangentRef,
    NodeVolumeTangentProbe> {
  static constexpr std::string_view name = "quasistatic::NodeVolumeTangent";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"k", "N/m^5"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "U''(T) / volume, or its linearised form",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeVolumeTangentObject, Space>>
using NodeVolumeTangentView = physgen::View<NodeVolumeTangentObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<NodeVolumeTangentObject, Space>>
using NodeVolumeTangentArray = physgen::Array<NodeVolumeTangentObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeVolumeTangentObject, physgen::Host>({4, 4, {0}}, {8, 8, {0}}));

// ---- CoarseInverse --------------------------------------------------------------------------------------------------

/// A block of the inverse of the coarsest level's stiffness, which is dense.
template <class Real>
struct CoarseInverse {
  /// of nodes i and j of n, in object i n + j
  physgen::MatrixValue<Real, 3, 3> G = decltype(G)::Zero();
};

template <class Space>
struct CoarseInverseFormats {
  using G = physgen::format::Native;
};

struct CoarseInverseObject;
template <class ArrayTag, class Base = CoarseInverseFormats<physgen::Host>, class Object = CoarseInverseObject,
          int first = 0>
struct CoarseInverseProbe {
  using array_ = ArrayTag;
  using G = physgen::Probe<ArrayTag, Object, first + 0, typename Base::G>;
};

template <class Real, class Formats>
struct CoarseInverseRecord {
  using G = physgen::StoredField<CoarseInverseRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::G, Real>;
  using fields_ = physgen::RecordFields<G>;
};

template <class Real, class Formats, class Cursor>
struct CoarseInverseRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = CoarseInverseRecord<Real, Formats>;
  using Value = CoarseInverse<typename Cursor::template Lanes<Real>>;

  /// of nodes i and j of n, in object i n + j
  PHYSGEN_FUNCTION decltype(auto) G() const { return this->field_(typename Record::G(), Record::G::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {G().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { G() = value.G; }
};

struct CoarseInverseObject : physgen::ObjectTag<
    CoarseInverseObject, CoarseInverse, CoarseInverseFormats, CoarseInverseRecord, CoarseInverseRef,
    CoarseInverseProbe> {
  static constexpr std::string_view name = "quasistatic::CoarseInverse";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"G"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "of nodes i and j of n, in object i n + j",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<CoarseInverseObject, Space>>
using CoarseInverseView = physgen::View<CoarseInverseObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<CoarseInverseObject, Space>>
using CoarseInverseArray = physgen::Array<CoarseInverseObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<CoarseInverseObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- PatchTangent ---------------------------------------------------------------------------------------------------

/// The part of the tangent that a patch's volume has: k g g^T.
template <class Real>
struct PatchTangent {
  /// by columns: change of the patch's volume with its nodes [m^2]
  physgen::MatrixValue<Real, 3, 8> g = decltype(g)::Zero();
  /// U''(T) / volume, or its linearised form [N/m^5]
  Real k = {};
};

template <class Space>
struct PatchTangentFormats {
  using g = physgen::format::Native;
  using k = physgen::format::Native;
};

struct PatchTangentObject;
template <class ArrayTag, class Base = PatchTangentFormats<physgen::Host>, class Object = PatchTangentObject,
          int first = 0>
struct PatchTangentProbe {
  using array_ = ArrayTag;
  using g = physgen::Probe<ArrayTag, Object, first + 0, typename Base::g>;
  using k = physgen::Probe<ArrayTag, Object, first + 1, typename Base::k>;
};

template <class Real, class Formats>
struct PatchTangentRecord {
  using g = physgen::StoredField<PatchTangentRecord, 0, physgen::shape::Matrix<3, 8>, typename Formats::g, Real>;
  using k = physgen::StoredField<PatchTangentRecord, 1, physgen::shape::Scalar, typename Formats::k, Real>;
  using fields_ = physgen::RecordFields<g, k>;
};

template <class Real, class Formats, class Cursor>
struct PatchTangentRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PatchTangentRecord<Real, Formats>;
  using Value = PatchTangent<typename Cursor::template Lanes<Real>>;

  /// by columns: change of the patch's volume with its nodes [m^2]
  PHYSGEN_FUNCTION decltype(auto) g() const { return this->field_(typename Record::g(), Record::g::offset); }
  /// U''(T) / volume, or its linearised form [N/m^5]
  PHYSGEN_FUNCTION decltype(auto) k() const { return this->field_(typename Record::k(), Record::k::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {g().get(), k()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    g() = value.g;
    k() = value.k;
  }
};

struct PatchTangentObject : physgen::ObjectTag<
    PatchTangentObject, PatchTangent, PatchTangentFormats, PatchTangentRecord, PatchTangentRef, PatchTangentProbe> {
  static constexpr std::string_view name = "quasistatic::PatchTangent";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"g", "m^2"}, {"k", "N/m^5"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "by columns: change of the patch's volume with its nodes", "U''(T) / volume, or its linearised form",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchTangentObject, Space>>
using PatchTangentView = physgen::View<PatchTangentObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchTangentObject, Space>>
using PatchTangentArray = physgen::Array<PatchTangentObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PatchTangentObject, physgen::Host>({100, 4, {0, 96}}, {200, 8, {0, 192}}));

// ---- PatchChange ----------------------------------------------------------------------------------------------------

/// The change of a patch's forces along a displacement, on the CPU in a product without blocks of edges.
template <class Real>
struct PatchChange {
  /// k g . dx [N/m^2]
  Real change = {};
};

template <class Space>
struct PatchChangeFormats {
  using change = physgen::format::Native;
};

struct PatchChangeObject;
template <class ArrayTag, class Base = PatchChangeFormats<physgen::Host>, class Object = PatchChangeObject,
          int first = 0>
struct PatchChangeProbe {
  using array_ = ArrayTag;
  using change = physgen::Probe<ArrayTag, Object, first + 0, typename Base::change>;
};

template <class Real, class Formats>
struct PatchChangeRecord {
  using change = physgen::StoredField<PatchChangeRecord, 0, physgen::shape::Scalar, typename Formats::change, Real>;
  using fields_ = physgen::RecordFields<change>;
};

template <class Real, class Formats, class Cursor>
struct PatchChangeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PatchChangeRecord<Real, Formats>;
  using Value = PatchChange<typename Cursor::template Lanes<Real>>;

  /// k g . dx [N/m^2]
  PHYSGEN_FUNCTION decltype(auto) change() const {
    return this->field_(typename Record::change(), Record::change::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {change()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { change() = value.change; }
};

struct PatchChangeObject : physgen::ObjectTag<
    PatchChangeObject, PatchChange, PatchChangeFormats, PatchChangeRecord, PatchChangeRef, PatchChangeProbe> {
  static constexpr std::string_view name = "quasistatic::PatchChange";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"change", "N/m^2"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "k g . dx",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchChangeObject, Space>>
using PatchChangeView = physgen::View<PatchChangeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchChangeObject, Space>>
using PatchChangeArray = physgen::Array<PatchChangeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PatchChangeObject, physgen::Host>({4, 4, {0}}, {8, 8, {0}}));

// ---- SchwarzNode ----------------------------------------------------------------------------------------------------

/// Where a node stands in the order of blocks.
template <class Real>
struct SchwarzNode {
  /// number of its SchwarzSlot; -1: all its components are prescribed
  physgen::same_lanes_t<Real, std::int32_t> slot = {};
};

template <class Space>
struct SchwarzNodeFormats {
  using slot = physgen::format::Native;
};

struct SchwarzNodeObject;
template <class ArrayTag, class Base = SchwarzNodeFormats<physgen::Host>, class Object = SchwarzNodeObject,
          int first = 0>
struct SchwarzNodeProbe {
  using array_ = ArrayTag;
  using slot = physgen::Probe<ArrayTag, Object, first + 0, typename Base::slot>;
};

template <class Real, class Formats>
struct SchwarzNodeRecord {
  using slot = physgen::StoredField<SchwarzNodeRecord, 0, physgen::shape::Scalar, typename Formats::slot, std::int32_t>;
  using fields_ = physgen::RecordFields<slot>;
};

template <class Real, class Formats, class Cursor>
struct SchwarzNodeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = SchwarzNodeRecord<Real, Formats>;
  using Value = SchwarzNode<typename Cursor::template Lanes<Real>>;

  /// number of its SchwarzSlot; -1: all its components are prescribed
  PHYSGEN_FUNCTION decltype(auto) slot() const { return this->field_(typename Record::slot(), Record::slot::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {slot()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { slot() = value.slot; }
};

struct SchwarzNodeObject : physgen::ObjectTag<
    SchwarzNodeObject, SchwarzNode, SchwarzNodeFormats, SchwarzNodeRecord, SchwarzNodeRef, SchwarzNodeProbe> {
  static constexpr std::string_view name = "quasistatic::SchwarzNode";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"slot"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "number of its SchwarzSlot; -1: all its components are prescribed",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzNodeObject, Space>>
using SchwarzNodeView = physgen::View<SchwarzNodeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzNodeObject, Space>>
using SchwarzNodeArray = physgen::Array<SchwarzNodeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<SchwarzNodeObject, physgen::Host>({4, 4, {0}}, {4, 4, {0}}));

// ---- SchwarzSlot ----------------------------------------------------------------------------------------------------

/// A place in a block: slots 32 b .. 32 b + 31 are those of block b.
template <class Real>
struct SchwarzSlot {
  /// which node stands here, or behind the first level which supernode; -1: none
  physgen::same_lanes_t<Real, std::int32_t> source = {};
  /// the supernode of the next level that it belongs to; -1 on the last level
  physgen::same_lanes_t<Real, std::int32_t> parent = {};
};

template <class Space>
struct SchwarzSlotFormats {
  using source = physgen::format::Native;
  using parent = physgen::format::Native;
};

struct SchwarzSlotObject;
template <class ArrayTag, class Base = SchwarzSlotFormats<physgen::Host>, class Object = SchwarzSlotObject,
          int first = 0>
struct SchwarzSlotProbe {
  using array_ = ArrayTag;
  using source = physgen::Probe<ArrayTag, Object, first + 0, typename Base::source>;
  using parent = physgen::Probe<ArrayTag, Object, first + 1, typename Base::parent>;
};

template <class Real, class Formats>
struct SchwarzSlotRecord {
  using source = physgen::StoredField<
      SchwarzSlotRecord, 0, physgen::shape::Scalar, typename Formats::source, std::int32_t>;
  using parent = physgen::StoredField<
      SchwarzSlotRecord, 1, physgen::shape::Scalar, typename Formats::parent, std::int32_t>;
  using fields_ = physgen::RecordFields<source, parent>;
};

template <class Real, class Formats, class Cursor>
struct SchwarzSlotRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = SchwarzSlotRecord<Real, Formats>;
  using Value = SchwarzSlot<typename Cursor::template Lanes<Real>>;

  /// which node stands here, or behind the first level which supernode; -1: none
  PHYSGEN_FUNCTION decltype(auto) source() const {
    return this->field_(typename Record::source(), Record::source::offset);
  }
  /// the supernode of the next level that it belongs to; -1 on the last level
  PHYSGEN_FUNCTION decltype(auto) parent() const {
    return this->field_(typename Record::parent(), Record::parent::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {source(), parent()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    source() = value.source;
    parent() = value.parent;
  }
};

struct SchwarzSlotObject : physgen::ObjectTag<
    SchwarzSlotObject, SchwarzSlot, SchwarzSlotFormats, SchwarzSlotRecord, SchwarzSlotRef, SchwarzSlotProbe> {
  static constexpr std::string_view name = "quasistatic::SchwarzSlot";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"source"}, {"parent"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "which node stands here, or behind the first level which supernode; -1: none",
    "the supernode of the next level that it belongs to; -1 on the last level",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzSlotObject, Space>>
using SchwarzSlotView = physgen::View<SchwarzSlotObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzSlotObject, Space>>
using SchwarzSlotArray = physgen::Array<SchwarzSlotObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<SchwarzSlotObject, physgen::Host>({8, 4, {0, 4}}, {8, 4, {0, 4}}));

// ---- SchwarzBlock ---------------------------------------------------------------------------------------------------

/// A block of 32 slots.
template <class Real>
struct SchwarzBlock {
  /// a power of two, by which the stored factor is smaller than the real one
  Real scale = {};
  /// the block of the next level that its supernodes belong to; -1 on the last level
  physgen::same_lanes_t<Real, std::int32_t> parent = {};
  /// how many blocks of the level before have this one as their parent
  physgen::same_lanes_t<Real, std::int32_t> children = {};
  /// how many of them have handed their forces over; 0 between two applications
  physgen::same_lanes_t<Real, std::int32_t> arrived = {};
};

template <class Space>
struct SchwarzBlockFormats {
  using scale = physgen::format::Native;
  using parent = physgen::format::Native;
  using children = physgen::format::Native;
  using arrived = physgen::format::Native;
};

struct SchwarzBlockObject;
template <class ArrayTag, class Base = SchwarzBlockFormats<physgen::Host>, class Object = SchwarzBlockObject,
          int first = 0>
struct SchwarzBlockProbe {
  using array_ = ArrayTag;
  using scale = physgen::Probe<ArrayTag, Object, first + 0, typename Base::scale>;
  using parent = physgen::Probe<ArrayTag, Object, first + 1, typename Base::parent>;
  using children = physgen::Probe<ArrayTag, Object, first + 2, typename Base::children>;
  using arrived = physgen::Probe<ArrayTag, Object, first + 3, typename Base::arrived>;
};

template <class Real, class Formats>
struct SchwarzBlockRecord {
  using scale = physgen::StoredField<SchwarzBlockRecord, 0, physgen::shape::Scalar, typename Formats::scale, Real>;
  using parent = physgen::StoredField<
      SchwarzBlockRecord, 1, physgen::shape::Scalar, typename Formats::parent, std::int32_t>;
  using children = physgen::StoredField<
      SchwarzBlockRecord, 2, physgen::shape::Scalar, typename Formats::children, std::int32_t>;
  using arrived = physgen::StoredField<
      SchwarzBlockRecord, 3, physgen::shape::Scalar, typename Formats::arrived, std::int32_t>;
  using fields_ = physgen::RecordFields<scale, parent, children, arrived>;
};

template <class Real, class Formats, class Cursor>
struct SchwarzBlockRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = SchwarzBlockRecord<Real, Formats>;
  using Value = SchwarzBlock<typename Cursor::template Lanes<Real>>;

  /// a power of two, by which the stored factor is smaller than the real one
  PHYSGEN_FUNCTION decltype(auto) scale() const {
    return this->field_(typename Record::scale(), Record::scale::offset);
  }
  /// the block of the next level that its supernodes belong to; -1 on the last level
  PHYSGEN_FUNCTION decltype(auto) parent() const {
    return this->field_(typename Record::parent(), Record::parent::offset);
  }
  /// how many blocks of the level before have this one as their parent
  PHYSGEN_FUNCTION decltype(auto) children() const {
    return this->field_(typename Record::children(), Record::children::offset);
  }
  /// how many of them have handed their forces over; 0 between two applications
  PHYSGEN_FUNCTION decltype(auto) arrived() const {
    return this->field_(typename Record::arrived(), Record::arrived::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {scale(), parent(), children(), arrived()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    scale() = value.scale;
    parent() = value.parent;
    children() = value.children;
    arrived() = value.arrived;
  }
};

struct SchwarzBlockObject : physgen::ObjectTag<
    SchwarzBlockObject, SchwarzBlock, SchwarzBlockFormats, SchwarzBlockRecord, SchwarzBlockRef, SchwarzBlockProbe> {
  static constexpr std::string_view name = "quasistatic::SchwarzBlock";
  static constexpr std::array<physgen::FieldText, 4> texts = {{{"scale"}, {"parent"}, {"children"}, {"arrived"}}};
  static constexpr std::array<std::string_view, 4> docs = {
    "a power of two, by which the stored factor is smaller than the real one",
    "the block of the next level that its supernodes belong to; -1 on the last level",
    "how many blocks of the level before have this one as their parent",
    "how many of them have handed their forces over; 0 between two applications",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzBlockObject, Space>>
using SchwarzBlockView = physgen::View<SchwarzBlockObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzBlockObject, Space>>
using SchwarzBlockArray = physgen::Array<SchwarzBlockObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<SchwarzBlockObject, physgen::Host>(
    {16, 4, {0, 4, 8, 12}}, {20, 8, {0, 8, 12, 16}}));

// ---- Supernode ------------------------------------------------------------------------------------------------------

/// Nodes that are connected within one block, and move as one on the next level.
template <class Real>
struct Supernode {
  /// sum of the stiffness of its nodes and of the edges among them [N/m]. Symmetric, 6 stored.
  physgen::MatrixValue<Real, 3, 3> K = decltype(K)::Zero();
  /// sum of its nodes' |K_kk|: what rounding is measured against [N/m]
  physgen::MatrixValue<Real, 3, 1> magnitude = decltype(magnitude)::Zero();
};

template <class Space>
struct SupernodeFormats {
  using K = physgen::format::Native;
  using magnitude = physgen::format::Native;
};

struct SupernodeObject;
template <class ArrayTag, class Base = SupernodeFormats<physgen::Host>, class Object = SupernodeObject, int first = 0>
struct SupernodeProbe {
  using array_ = ArrayTag;
  using K = physgen::Probe<ArrayTag, Object, first + 0, typename Base::K>;
  using magnitude = physgen::Probe<ArrayTag, Object, first + 1, typename Base::magnitude>;
};

template <class Real, class Formats>
struct SupernodeRecord {
  using K = physgen::StoredField<SupernodeRecord, 0, physgen::shape::Symmetric<3>, typename Formats::K, Real>;
  using magnitude = physgen::StoredField<
      SupernodeRecord, 1, physgen::shape::Vector<3>, typename Formats::magnitude, Real>;
  using fields_ = physgen::RecordFields<K, magnitude>;
};

template <class Real, class Formats, class Cursor>
struct SupernodeRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = SupernodeRecord<Real, Formats>;
  using Value = Supernode<typename Cursor::template Lanes<Real>>;

  /// sum of the stiffness of its nodes and of the edges among them [N/m]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) K() const { return this->field_(typename Record::K(), Record::K::offset); }
  /// sum of its nodes' |K_kk|: what rounding is measured against [N/m]
  PHYSGEN_FUNCTION decltype(auto) magnitude() const {
    return this->field_(typename Record::magnitude(), Record::magnitude::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {K().get(), magnitude().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    K() = value.K;
    magnitude() = value.magnitude;
  }
};

struct SupernodeObject : physgen::ObjectTag<
    SupernodeObject, Supernode, SupernodeFormats, SupernodeRecord, SupernodeRef, SupernodeProbe> {
  static constexpr std::string_view name = "quasistatic::Supernode";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"K", "N/m"}, {"magnitude", "N/m"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "sum of the stiffness of its nodes and of the edges among them",
    "sum of its nodes' |K_kk|: what rounding is measured against",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SupernodeObject, Space>>
using SupernodeView = physgen::View<SupernodeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SupernodeObject, Space>>
using SupernodeArray = physgen::Array<SupernodeObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<SupernodeObject, physgen::Host>({36, 4, {0, 24}}, {72, 8, {0, 48}}));

// ---- SchwarzTerm ----------------------------------------------------------------------------------------------------

/// One term of the sum for a supernode, or for a pair of them.
template <class Real>
struct SchwarzTerm {
  /// a node or an edge of the level before
  physgen::same_lanes_t<Real, std::int32_t> source = {};
  /// of a supernode: 0 a node, 1 an edge inside; of a pair: 0 an edge, 1 an edge the other way round
  physgen::same_lanes_t<Real, std::int32_t> kind = {};
};

template <class Space>
struct SchwarzTermFormats {
  using source = physgen::format::Native;
  using kind = physgen::format::Native;
};

struct SchwarzTermObject;
template <class ArrayTag, class Base = SchwarzTermFormats<physgen::Host>, class Object = SchwarzTermObject,
          int first = 0>
struct SchwarzTermProbe {
  using array_ = ArrayTag;
  using source = physgen::Probe<ArrayTag, Object, first + 0, typename Base::source>;
  using kind = physgen::Probe<ArrayTag, Object, first + 1, typename Base::kind>;
};

template <class Real, class Formats>
struct SchwarzTermRecord {
  using source = physgen::StoredField<
      SchwarzTermRecord, 0, physgen::shape::Scalar, typename Formats::source, std::int32_t>;
  using kind = physgen::StoredField<SchwarzTermRecord, 1, physgen::shape::Scalar, typename Formats::kind, std::int32_t>;
  using fields_ = physgen::RecordFields<source, kind>;
};

template <class Real, class Formats, class Cursor>
struct SchwarzTermRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = SchwarzTermRecord<Real, Formats>;
  using Value = SchwarzTerm<typename Cursor::template Lanes<Real>>;

  /// a node or an edge of the level before
  PHYSGEN_FUNCTION decltype(auto) source() const {
    return this->field_(typename Record::source(), Record::source::offset);
  }
  /// of a supernode: 0 a node, 1 an edge inside; of a pair: 0 an edge, 1 an edge the other way round
  PHYSGEN_FUNCTION decltype(auto) kind() const { return this->field_(typename Record::kind(), Record::kind::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {source(), kind()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    source() = value.source;
    kind() = value.kind;
  }
};

struct SchwarzTermObject : physgen::ObjectTag<
    SchwarzTermObject, SchwarzTerm, SchwarzTermFormats, SchwarzTermRecord, SchwarzTermRef, SchwarzTermProbe> {
  static constexpr std::string_view name = "quasistatic::SchwarzTerm";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"source"}, {"kind"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "a node or an edge of the level before",
    "of a supernode: 0 a node, 1 an edge inside; of a pair: 0 an edge, 1 an edge the other way " "round",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzTermObject, Space>>
using SchwarzTermView = physgen::View<SchwarzTermObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzTermObject, Space>>
using SchwarzTermArray = physgen::Array<SchwarzTermObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<SchwarzTermObject, physgen::Host>({8, 4, {0, 4}}, {8, 4, {0, 4}}));

// ---- SchwarzPair ----------------------------------------------------------------------------------------------------

/// An edge whose two ends stand in one block.
template <class Real>
struct SchwarzPair {
  /// its number
  physgen::same_lanes_t<Real, std::int32_t> edge = {};
  /// that of m + 32 that of n
  physgen::same_lanes_t<Real, std::int32_t> places = {};
};

template <class Space>
struct SchwarzPairFormats {
  using edge = physgen::format::Native;
  using places = physgen::format::Native;
};

struct SchwarzPairObject;
template <class ArrayTag, class Base = SchwarzPairFormats<physgen::Host>, class Object = SchwarzPairObject,
          int first = 0>
struct SchwarzPairProbe {
  using array_ = ArrayTag;
  using edge = physgen::Probe<ArrayTag, Object, first + 0, typename Base::edge>;
  using places = physgen::Probe<ArrayTag, Object, first + 1, typename Base::places>;
};

template <class Real, class Formats>
struct SchwarzPairRecord {
  using edge = physgen::StoredField<SchwarzPairRecord, 0, physgen::shape::Scalar, typename Formats::edge, std::int32_t>;
  using places = physgen::StoredField<
      SchwarzPairRecord, 1, physgen::shape::Scalar, typename Formats::places, std::int32_t>;
  using fields_ = physgen::RecordFields<edge, places>;
};

template <class Real, class Formats, class Cursor>
struct SchwarzPairRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = SchwarzPairRecord<Real, Formats>;
  using Value = SchwarzPair<typename Cursor::template Lanes<Real>>;

  /// its number
  PHYSGEN_FUNCTION decltype(auto) edge() const { return this->field_(typename Record::edge(), Record::edge::offset); }
  /// that of m + 32 that of n
  PHYSGEN_FUNCTION decltype(auto) places() const {
    return this->field_(typename Record::places(), Record::places::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {edge(), places()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    edge() = value.edge;
    places() = value.places;
  }
};

struct SchwarzPairObject : physgen::ObjectTag<
    SchwarzPairObject, SchwarzPair, SchwarzPairFormats, SchwarzPairRecord, SchwarzPairRef, SchwarzPairProbe> {
  static constexpr std::string_view name = "quasistatic::SchwarzPair";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"edge"}, {"places"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "its number", "that of m + 32 that of n",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzPairObject, Space>>
using SchwarzPairView = physgen::View<SchwarzPairObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzPairObject, Space>>
using SchwarzPairArray = physgen::Array<SchwarzPairObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<SchwarzPairObject, physgen::Host>({8, 4, {0, 4}}, {8, 4, {0, 4}}));

// ---- SchwarzFactor --------------------------------------------------------------------------------------------------

/// A part of W, W^T W being the inverse of a block's -K: 3x3 blocks of the lower triangle, diagonal after diagonal.
/// Those i + d below, i and, of a distance of 32 - d, i below, i + d - 32 share the 32 objects of d.
template <class Real>
struct SchwarzFactor {
  /// of block b in objects 544 b + 32 d + i, d = 0 .. 16
  physgen::MatrixValue<Real, 3, 3> W = decltype(W)::Zero();
};

template <class Space>
struct SchwarzFactorFormats {
  using W = physgen::format::Native;
};

struct SchwarzFactorObject;
template <class ArrayTag, class Base = SchwarzFactorFormats<physgen::Host>, class Object = SchwarzFactorObject,
          int first = 0>
struct SchwarzFactorProbe {
  using array_ = ArrayTag;
  using W = physgen::Probe<ArrayTag, Object, first + 0, typename Base::W>;
};

template <class Real, class Formats>
struct SchwarzFactorRecord {
  using W = physgen::StoredField<SchwarzFactorRecord, 0, physgen::shape::Matrix<3, 3>, typename Formats::W, Real>;
  using fields_ = physgen::RecordFields<W>;
};

template <class Real, class Formats, class Cursor>
struct SchwarzFactorRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = SchwarzFactorRecord<Real, Formats>;
  using Value = SchwarzFactor<typename Cursor::template Lanes<Real>>;

  /// of block b in objects 544 b + 32 d + i, d = 0 .. 16
  PHYSGEN_FUNCTION decltype(auto) W() const { return this->field_(typename Record::W(), Record::W::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {W().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { W() = value.W; }
};

struct SchwarzFactorObject : physgen::ObjectTag<
    SchwarzFactorObject, SchwarzFactor, SchwarzFactorFormats, SchwarzFactorRecord, SchwarzFactorRef,
    SchwarzFactorProbe> {
  static constexpr std::string_view name = "quasistatic::SchwarzFactor";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"W"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "of block b in objects 544 b + 32 d + i, d = 0 .. 16",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzFactorObject, Space>>
using SchwarzFactorView = physgen::View<SchwarzFactorObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<SchwarzFactorObject, Space>>
using SchwarzFactorArray = physgen::Array<SchwarzFactorObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<SchwarzFactorObject, physgen::Host>({36, 4, {0}}, {72, 8, {0}}));

// ---- LinearSolve ----------------------------------------------------------------------------------------------------

/// Conjugate gradients; in double.
template <class Real>
struct LinearSolve {
  /// r . z of this iteration [N m]
  Real rz = {};
  /// of the first [N m]
  Real rz_first = {};
  /// of sqrt(rz / rz_first) [1]
  Real tolerance = {};
  /// the length of this step, and what the next keeps of its direction [1]
  Real alpha = {};
  /// the length of this step, and what the next keeps of its direction [1]
  Real beta = {};
  /// done
  physgen::same_lanes_t<Real, std::int32_t> iterations = {};
  /// fem::LinearStatus
  physgen::same_lanes_t<Real, std::int32_t> status = {};
};

template <class Space>
struct LinearSolveFormats {
  using rz = physgen::format::Native;
  using rz_first = physgen::format::Native;
  using tolerance = physgen::format::Native;
  using alpha = physgen::format::Native;
  using beta = physgen::format::Native;
  using iterations = physgen::format::Native;
  using status = physgen::format::Native;
};

struct LinearSolveObject;
template <class ArrayTag, class Base = LinearSolveFormats<physgen::Host>, class Object = LinearSolveObject,
          int first = 0>
struct LinearSolveProbe {
  using array_ = ArrayTag;
  using rz = physgen::Probe<ArrayTag, Object, first + 0, typename Base::rz>;
  using rz_first = physgen::Probe<ArrayTag, Object, first + 1, typename Base::rz_first>;
  using tolerance = physgen::Probe<ArrayTag, Object, first + 2, typename Base::tolerance>;
  using alpha = physgen::Probe<ArrayTag, Object, first + 3, typename Base::alpha>;
  using beta = physgen::Probe<ArrayTag, Object, first + 4, typename Base::beta>;
  using iterations = physgen::Probe<ArrayTag, Object, first + 5, typename Base::iterations>;
  using status = physgen::Probe<ArrayTag, Object, first + 6, typename Base::status>;
};

template <class Real, class Formats>
struct LinearSolveRecord {
  using rz = physgen::StoredField<LinearSolveRecord, 0, physgen::shape::Scalar, typename Formats::rz, Real>;
  using rz_first = physgen::StoredField<LinearSolveRecord, 1, physgen::shape::Scalar, typename Formats::rz_first, Real>;
  using tolerance = physgen::StoredField<
      LinearSolveRecord, 2, physgen::shape::Scalar, typename Formats::tolerance, Real>;
  using alpha = physgen::StoredField<LinearSolveRecord, 3, physgen::shape::Scalar, typename Formats::alpha, Real>;
  using beta = physgen::StoredField<LinearSolveRecord, 4, physgen::shape::Scalar, typename Formats::beta, Real>;
  using iterations = physgen::StoredField<
      LinearSolveRecord, 5, physgen::shape::Scalar, typename Formats::iterations, std::int32_t>;
  using status = physgen::StoredField<
      LinearSolveRecord, 6, physgen::shape::Scalar, typename Formats::status, std::int32_t>;
  using fields_ = physgen::RecordFields<rz, rz_first, tolerance, alpha, beta, iterations, status>;
};

template <class Real, class Formats, class Cursor>
struct LinearSolveRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = LinearSolveRecord<Real, Formats>;
  using Value = LinearSolve<typename Cursor::template Lanes<Real>>;

  /// r . z of this iteration [N m]
  PHYSGEN_FUNCTION decltype(auto) rz() const { return this->field_(typename Record::rz(), Record::rz::offset); }
  /// of the first [N m]
  PHYSGEN_FUNCTION decltype(auto) rz_first() const {
    return this->field_(typename Record::rz_first(), Record::rz_first::offset);
  }
  /// of sqrt(rz / rz_first) [1]
  PHYSGEN_FUNCTION decltype(auto) tolerance() const {
    return this->field_(typename Record::tolerance(), Record::tolerance::offset);
  }
  /// the length of this step, and what the next keeps of its direction [1]
  PHYSGEN_FUNCTION decltype(auto) alpha() const {
    return this->field_(typename Record::alpha(), Record::alpha::offset);
  }
  /// the length of this step, and what the next keeps of its direction [1]
  PHYSGEN_FUNCTION decltype(auto) beta() const { return this->field_(typename Record::beta(), Record::beta::offset); }
  /// done
  PHYSGEN_FUNCTION decltype(auto) iterations() const {
    return this->field_(typename Record::iterations(), Record::iterations::offset);
  }
  /// fem::LinearStatus
  PHYSGEN_FUNCTION decltype(auto) status() const {
    return this->field_(typename Record::status(), Record::status::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {rz(), rz_first(), tolerance(), alpha(), beta(), iterations(), status()};
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    rz() = value.rz;
    rz_first() = value.rz_first;
    tolerance() = value.tolerance;
    alpha() = value.alpha;
    beta() = value.beta;
    iterations() = value.iterations;
    status() = value.status;
  }
};

struct LinearSolveObject : physgen::ObjectTag<
    LinearSolveObject, LinearSolve, LinearSolveFormats, LinearSolveRecord, LinearSolveRef, LinearSolveProbe> {
  static constexpr std::string_view name = "quasistatic::LinearSolve";
  static constexpr std::array<physgen::FieldText, 7> texts = {{
      {"rz", "N m"}, {"rz_first", "N m"}, {"tolerance", "1"}, {"alpha", "1"}, {"beta", "1"}, {"iterations"},
      {"status"}}};
  static constexpr std::array<std::string_view, 7> docs = {
    "r . z of this iteration", "of the first", "of sqrt(rz / rz_first)",
    "the length of this step, and what the next keeps of its direction",
    "the length of this step, and what the next keeps of its direction", "done", "fem::LinearStatus",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<LinearSolveObject, Space>>
using LinearSolveView = physgen::View<LinearSolveObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<LinearSolveObject, Space>>
using LinearSolveArray = physgen::Array<LinearSolveObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<LinearSolveObject, physgen::Host>(
    {28, 4, {0, 4, 8, 12, 16, 20, 24}}, {48, 8, {0, 8, 16, 24, 32, 40, 44}}));

// ---- PackedIncidence ------------------------------------------------------------------------------------------------

/// An element that touches a node or an edge, and where in it, in one number.
template <class Real>
struct PackedIncidence {
  /// element 2^bits + local: each list has bits of its own (fem::PackedEntry)
  physgen::same_lanes_t<Real, std::int32_t> code = {};
};

template <class Space>
struct PackedIncidenceFormats {
  using code = physgen::format::Native;
};

struct PackedIncidenceObject;
template <class ArrayTag, class Base = PackedIncidenceFormats<physgen::Host>, class Object = PackedIncidenceObject,
          int first = 0>
struct PackedIncidenceProbe {
  using array_ = ArrayTag;
  using code = physgen::Probe<ArrayTag, Object, first + 0, typename Base::code>;
};

template <class Real, class Formats>
struct PackedIncidenceRecord {
  using code = physgen::StoredField<
      PackedIncidenceRecord, 0, physgen::shape::Scalar, typename Formats::code, std::int32_t>;
  using fields_ = physgen::RecordFields<code>;
};

template <class Real, class Formats, class Cursor>
struct PackedIncidenceRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PackedIncidenceRecord<Real, Formats>;
  using Value = PackedIncidence<typename Cursor::template Lanes<Real>>;

  /// element 2^bits + local: each list has bits of its own (fem::PackedEntry)
  PHYSGEN_FUNCTION decltype(auto) code() const { return this->field_(typename Record::code(), Record::code::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {code()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { code() = value.code; }
};

struct PackedIncidenceObject : physgen::ObjectTag<
    PackedIncidenceObject, PackedIncidence, PackedIncidenceFormats, PackedIncidenceRecord, PackedIncidenceRef,
    PackedIncidenceProbe> {
  static constexpr std::string_view name = "quasistatic::PackedIncidence";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"code"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "element 2^bits + local: each list has bits of its own (fem::PackedEntry)",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PackedIncidenceObject, Space>>
using PackedIncidenceView = physgen::View<PackedIncidenceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<PackedIncidenceObject, Space>>
using PackedIncidenceArray = physgen::Array<PackedIncidenceObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PackedIncidenceObject, physgen::Host>({4, 4, {0}}, {4, 4, {0}}));

// ---- Smoother -------------------------------------------------------------------------------------------------------

/// How a level is smoothed.
template <class Real>
struct Smoother {
  /// an estimate of the largest eigenvalue of -D K [1]
  Real largest = {};
  /// of the vector that power iterations began with [1]
  Real length = {};
};

template <class Space>
struct SmootherFormats {
  using largest = physgen::format::Native;
  using length = physgen::format::Native;
};

struct SmootherObject;
template <class ArrayTag, class Base = SmootherFormats<physgen::Host>, class Object = SmootherObject, int first = 0>
struct SmootherProbe {
  using array_ = ArrayTag;
  using largest = physgen::Probe<ArrayTag, Object, first + 0, typename Base::largest>;
  using length = physgen::Probe<ArrayTag, Object, first + 1, typename Base::length>;
};

template <class Real, class Formats>
struct SmootherRecord {
  using largest = physgen::StoredField<SmootherRecord, 0, physgen::shape::Scalar, typename Formats::largest, Real>;
  using length = physgen::StoredField<SmootherRecord, 1, physgen::shape::Scalar, typename Formats::length, Real>;
  using fields_ = physgen::RecordFields<largest, length>;
};

template <class Real, class Formats, class Cursor>
struct SmootherRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = SmootherRecord<Real, Formats>;
  using Value = Smoother<typename Cursor::template Lanes<Real>>;

  /// an estimate of the largest eigenvalue of -D K [1]
  PHYSGEN_FUNCTION decltype(auto) largest() const {
    return this->field_(typename Record::largest(), Record::largest::offset);
  }
  /// of the vector that power iterations began with [1]
  PHYSGEN_FUNCTION decltype(auto) length() const {
    return this->field_(typename Record::length(), Record::length::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {largest(), length()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    largest() = value.largest;
    length() = value.length;
  }
};

struct SmootherObject : physgen::ObjectTag<
    SmootherObject, Smoother, SmootherFormats, SmootherRecord, SmootherRef, SmootherProbe> {
  static constexpr std::string_view name = "quasistatic::Smoother";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"largest", "1"}, {"length", "1"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "an estimate of the largest eigenvalue of -D K", "of the vector that power iterations began with",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SmootherObject, Space>>
using SmootherView = physgen::View<SmootherObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SmootherObject, Space>>
using SmootherArray = physgen::Array<SmootherObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<SmootherObject, physgen::Host>({8, 4, {0, 4}}, {16, 8, {0, 8}}));

// ---- Equilibrium ----------------------------------------------------------------------------------------------------

/// Energy and residual of a state; in double.
template <class Real>
struct Equilibrium {
  /// energy of the tets [J]
  Real elastic = {};
  /// energy of the mean volumes [J]
  Real volumetric = {};
  /// potential of the external forces and of rigid planes [J]
  Real loads = {};
  /// squared length of the forces in free components [N^2]
  Real free_square = {};
  /// squared length of reactions: of prescribed components and of planes [N^2]
  Real fixed_square = {};
  /// of the forces along a step [J]
  Real work = {};
  /// the smallest J [1]
  Real smallest_ratio = {};
};

template <class Space>
struct EquilibriumFormats {
  using elastic = physgen::format::Native;
  using volumetric = physgen::format::Native;
  using loads = physgen::format::Native;
  using free_square = physgen::format::Native;
  using fixed_square = physgen::format::Native;
  using work = physgen::format::Native;
  using smallest_ratio = physgen::format::Native;
};

struct EquilibriumObject;
template <class ArrayTag, class Base = EquilibriumFormats<physgen::Host>, class Object = EquilibriumObject,
          int first = 0>
struct EquilibriumProbe {
  using array_ = ArrayTag;
  using elastic = physgen::Probe<ArrayTag, Object, first + 0, typename Base::elastic>;
  using volumetric = physgen::Probe<ArrayTag, Object, first + 1, typename Base::volumetric>;
  using loads = physgen::Probe<ArrayTag, Object, first + 2, typename Base::loads>;
  using free_square = physgen::Probe<ArrayTag, Object, first + 3, typename Base::free_square>;
  using fixed_square = physgen::Probe<ArrayTag, Object, first + 4, typename Base::fixed_square>;
  using work = physgen::Probe<ArrayTag, Object, first + 5, typename Base::work>;
  using smallest_ratio = physgen::Probe<ArrayTag, Object, first + 6, typename Base::smallest_ratio>;
};

template <class Real, class Formats>
struct EquilibriumRecord {
  using elastic = physgen::StoredField<EquilibriumRecord, 0, physgen::shape::Scalar, typename Formats::elastic, Real>;
  using volumetric = physgen::StoredField<
      EquilibriumRecord, 1, physgen::shape::Scalar, typename Formats::volumetric, Real>;
  using loads = physgen::StoredField<EquilibriumRecord, 2, physgen::shape::Scalar, typename Formats::loads, Real>;
  using free_square = physgen::StoredField<
      EquilibriumRecord, 3, physgen::shape::Scalar, typename Formats::free_square, Real>;
  using fixed_square = physgen::StoredField<
      EquilibriumRecord, 4, physgen::shape::Scalar, typename Formats::fixed_square, Real>;
  using work = physgen::StoredField<EquilibriumRecord, 5, physgen::shape::Scalar, typename Formats::work, Real>;
  using smallest_ratio = physgen::StoredField<
      EquilibriumRecord, 6, physgen::shape::Scalar, typename Formats::smallest_ratio, Real>;
  using fields_ = physgen::RecordFields<elastic, volumetric, loads, free_square, fixed_square, work, smallest_ratio>;
};

template <class Real, class Formats, class Cursor>
struct EquilibriumRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = EquilibriumRecord<Real, Formats>;
  using Value = Equilibrium<typename Cursor::template Lanes<Real>>;

  /// energy of the tets [J]
  PHYSGEN_FUNCTION decltype(auto) elastic() const {
    return this->field_(typename Record::elastic(), Record::elastic::offset);
  }
  /// energy of the mean volumes [J]
  PHYSGEN_FUNCTION decltype(auto) volumetric() const {
    return this->field_(typename Record::volumetric(), Record::volumetric::offset);
  }
  /// potential of the external forces and of rigid planes [J]
  PHYSGEN_FUNCTION decltype(auto) loads() const {
    return this->field_(typename Record::loads(), Record::loads::offset);
  }
  /// squared length of the forces in free components [N^2]
  PHYSGEN_FUNCTION decltype(auto) free_square() const {
    return this->field_(typename Record::free_square(), Record::free_square::offset);
  }
  /// squared length of reactions: of prescribed components and of planes [N^2]
  PHYSGEN_FUNCTION decltype(auto) fixed_square() const {
    return this->field_(typename Record::fixed_square(), Record::fixed_square::offset);
  }
  /// of the forces along a step [J]
  PHYSGEN_FUNCTION decltype(auto) work() const { return this->field_(typename Record::work(), Record::work::offset); }
  /// the smallest J [1]
  PHYSGEN_FUNCTION decltype(auto) smallest_ratio() const {
    return this->field_(typename Record::smallest_ratio(), Record::smallest_ratio::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {elastic(), volumetric(), loads(), free_square(), fixed_square(), work(), smallest_ratio()};
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    elastic() = value.elastic;
    volumetric() = value.volumetric;
    loads() = value.loads;
    free_square() = value.free_square;
    fixed_square() = value.fixed_square;
    work() = value.work;
    smallest_ratio() = value.smallest_ratio;
  }
};

struct EquilibriumObject : physgen::ObjectTag<
    EquilibriumObject, Equilibrium, EquilibriumFormats, EquilibriumRecord, EquilibriumRef, EquilibriumProbe> {
  static constexpr std::string_view name = "quasistatic::Equilibrium";
  static constexpr std::array<physgen::FieldText, 7> texts = {{
      {"elastic", "J"}, {"volumetric", "J"}, {"loads", "J"}, {"free_square", "N^2"}, {"fixed_square", "N^2"},
      {"work", "J"}, {"smallest_ratio", "1"}}};
  static constexpr std::array<std::string_view, 7> docs = {
    "energy of the tets", "energy of the mean volumes", "potential of the external forces and of rigid planes",
    "squared length of the forces in free components",
    "squared length of reactions: of prescribed components and of planes", "of the forces along a step",
    "the smallest J",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<EquilibriumObject, Space>>
using EquilibriumView = physgen::View<EquilibriumObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<EquilibriumObject, Space>>
using EquilibriumArray = physgen::Array<EquilibriumObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<EquilibriumObject, physgen::Host>(
    {28, 4, {0, 4, 8, 12, 16, 20, 24}}, {56, 8, {0, 8, 16, 24, 32, 40, 48}}));

}  // namespace quasistatic

#endif  // PHYSGEN_QUASISTATIC_H_5F8FC0B54580FAFD
