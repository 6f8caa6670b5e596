// Accessor classes of the object types in quasistatic.h. Written by physgen: change the schema, not this file.
#ifndef PHYSGEN_QUASISTATIC_H_6E3E071CF1659351
#define PHYSGEN_QUASISTATIC_H_6E3E071CF1659351

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 4
#error "quasistatic.physgen.h is for version 4 of the physgen runtime: generate it again with the installed physgen"
#endif

namespace quasistatic {

// ---- NodeConstraint -------------------------------------------------------------------------------------------------

/// Which components of a node's position are prescribed: bit k is set for component k.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeConstraint {
  /// 0: free; 7: held in all directions
  physgen::same_lanes_t<Real, std::int32_t> fixed;
};

/// How the fields of one NodeConstraint are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of NodeConstraintArray.
template <class Space>
struct NodeConstraintFormats {
  using fixed = physgen::format::Native;
};

struct NodeConstraintObject;
/// NodeConstraintFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeConstraintFormats<physgen::Host>, class Object = NodeConstraintObject,
          int first = 0>
struct NodeConstraintProbe {
  using array_ = ArrayTag;
  using fixed = physgen::Probe<ArrayTag, Object, first + 0, typename Base::fixed>;
};

/// Where each field begins in the record of one NodeConstraint [bytes].
template <class Real, class Formats>
struct NodeConstraintRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::fixed, std::int32_t>(),
  }});
  static constexpr int fixed = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeConstraint of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeConstraintRef {
  using Record = NodeConstraintRecord<Real, Formats>;

 public:
  using Value = NodeConstraint<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeConstraintRef(const Cursor& cursor) : at_(cursor) {}
  NodeConstraintRef(const NodeConstraintRef&) = default;
  NodeConstraintRef& operator=(const NodeConstraintRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeConstraintRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// 0: free; 7: held in all directions
  PHYSGEN_FUNCTION decltype(auto) fixed() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::fixed, std::int32_t>(Record::fixed);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.fixed = fixed();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { fixed() = value.fixed; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeConstraint.
struct NodeConstraintObject {
  static constexpr std::string_view name = "quasistatic::NodeConstraint";
  template <class Real>
  using Value = NodeConstraint<Real>;
  template <class Real, class Formats>
  using Record = NodeConstraintRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeConstraintRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::fixed, std::int32_t>(
        "fixed", "", NodeConstraintRecord<Real, Formats>::fixed, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeConstraintFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeConstraintProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeConstraintObject, Space>>
using NodeConstraintView = physgen::View<NodeConstraintObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeConstraintObject, Space>>
using NodeConstraintArray = physgen::Array<NodeConstraintObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeConstraintObject, float, NodeConstraintFormats<physgen::Host>>(4, 4, {0}));
static_assert(physgen::is_sound_record<NodeConstraintObject, double, NodeConstraintFormats<physgen::Host>>(4, 4, {0}));

// ---- NodeParents ----------------------------------------------------------------------------------------------------

/// The two nodes of the next coarser level half-way between which a node lies; twice the same where it coincides.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeParents {
  /// numbers on the coarser level
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> nodes;
};

/// How the fields of one NodeParents are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of NodeParentsArray.
template <class Space>
struct NodeParentsFormats {
  using nodes = physgen::format::Native;
};

struct NodeParentsObject;
/// NodeParentsFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeParentsFormats<physgen::Host>, class Object = NodeParentsObject,
          int first = 0>
struct NodeParentsProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
};

/// Where each field begins in the record of one NodeParents [bytes].
template <class Real, class Formats>
struct NodeParentsRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<2>, typename Formats::nodes, std::int32_t>(),
  }});
  static constexpr int nodes = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeParents of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeParentsRef {
  using Record = NodeParentsRecord<Real, Formats>;

 public:
  using Value = NodeParents<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeParentsRef(const Cursor& cursor) : at_(cursor) {}
  NodeParentsRef(const NodeParentsRef&) = default;
  NodeParentsRef& operator=(const NodeParentsRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeParentsRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// numbers on the coarser level
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

/// What the runtime knows of NodeParents.
struct NodeParentsObject {
  static constexpr std::string_view name = "quasistatic::NodeParents";
  template <class Real>
  using Value = NodeParents<Real>;
  template <class Real, class Formats>
  using Record = NodeParentsRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeParentsRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::nodes, std::int32_t>(
        "nodes", "", NodeParentsRecord<Real, Formats>::nodes, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeParentsFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeParentsProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeParentsObject, Space>>
using NodeParentsView = physgen::View<NodeParentsObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeParentsObject, Space>>
using NodeParentsArray = physgen::Array<NodeParentsObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeParentsObject, float, NodeParentsFormats<physgen::Host>>(8, 4, {0}));
static_assert(physgen::is_sound_record<NodeParentsObject, double, NodeParentsFormats<physgen::Host>>(8, 4, {0}));

// ---- GridParents ----------------------------------------------------------------------------------------------------

/// The tet of a background grid in which a node lies: linear interpolation between its corners.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct GridParents {
  /// numbers on the coarser level; a corner without weight repeats the first
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> nodes;
  /// they add up to 1 [1]
  Eigen::Matrix<Real, 4, 1> weights;
};

/// How the fields of one GridParents are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of GridParentsArray.
template <class Space>
struct GridParentsFormats {
  using nodes = physgen::format::Native;
  using weights = physgen::format::Native;
};

struct GridParentsObject;
/// GridParentsFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = GridParentsFormats<physgen::Host>, class Object = GridParentsObject,
          int first = 0>
struct GridParentsProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
  using weights = physgen::Probe<ArrayTag, Object, first + 1, typename Base::weights>;
};

/// Where each field begins in the record of one GridParents [bytes].
template <class Real, class Formats>
struct GridParentsRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(),
    physgen::slot<physgen::shape::Vector<4>, typename Formats::weights, Real>(),
  }});
  static constexpr int nodes = plan_.offset[0];
  static constexpr int weights = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One GridParents of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class GridParentsRef {
  using Record = GridParentsRecord<Real, Formats>;

 public:
  using Value = GridParents<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit GridParentsRef(const Cursor& cursor) : at_(cursor) {}
  GridParentsRef(const GridParentsRef&) = default;
  GridParentsRef& operator=(const GridParentsRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const GridParentsRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// numbers on the coarser level; a corner without weight repeats the first
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return at_.template field<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(Record::nodes);
  }
  /// they add up to 1 [1]
  PHYSGEN_FUNCTION decltype(auto) weights() const {
    return at_.template field<physgen::shape::Vector<4>, typename Formats::weights, Real>(Record::weights);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.nodes = nodes().get();
    value.weights = weights().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    nodes() = value.nodes;
    weights() = value.weights;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of GridParents.
struct GridParentsObject {
  static constexpr std::string_view name = "quasistatic::GridParents";
  template <class Real>
  using Value = GridParents<Real>;
  template <class Real, class Formats>
  using Record = GridParentsRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = GridParentsRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(
        "nodes", "", GridParentsRecord<Real, Formats>::nodes, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::weights, Real>(
        "weights", "1", GridParentsRecord<Real, Formats>::weights, 1, 0.0),
  }};
  template <class Space>
  using Formats = GridParentsFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = GridParentsProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<GridParentsObject, Space>>
using GridParentsView = physgen::View<GridParentsObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<GridParentsObject, Space>>
using GridParentsArray = physgen::Array<GridParentsObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<GridParentsObject, float, GridParentsFormats<physgen::Host>>(32, 4, {0, 16}));
static_assert(physgen::is_sound_record<GridParentsObject, double, GridParentsFormats<physgen::Host>>(48, 8, {32, 0}));

// ---- NodeScale ------------------------------------------------------------------------------------------------------

/// The scale of a node's unknowns inside the preconditioner, a power of two, so that scaling rounds nothing.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeScale {
  /// the largest entry on the diagonal of scale^2 K is in [1/2, 2)
  Real scale;
  /// 1 / scale
  Real inverse;
};

/// How the fields of one NodeScale are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of NodeScaleArray.
template <class Space>
struct NodeScaleFormats {
  using scale = physgen::format::Native;
  using inverse = physgen::format::Native;
};

struct NodeScaleObject;
/// NodeScaleFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeScaleFormats<physgen::Host>, class Object = NodeScaleObject, int first = 0>
struct NodeScaleProbe {
  using array_ = ArrayTag;
  using scale = physgen::Probe<ArrayTag, Object, first + 0, typename Base::scale>;
  using inverse = physgen::Probe<ArrayTag, Object, first + 1, typename Base::inverse>;
};

/// Where each field begins in the record of one NodeScale [bytes].
template <class Real, class Formats>
struct NodeScaleRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::scale, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::inverse, Real>(),
  }});
  static constexpr int scale = plan_.offset[0];
  static constexpr int inverse = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeScale of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeScaleRef {
  using Record = NodeScaleRecord<Real, Formats>;

 public:
  using Value = NodeScale<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeScaleRef(const Cursor& cursor) : at_(cursor) {}
  NodeScaleRef(const NodeScaleRef&) = default;
  NodeScaleRef& operator=(const NodeScaleRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeScaleRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// the largest entry on the diagonal of scale^2 K is in [1/2, 2)
  PHYSGEN_FUNCTION decltype(auto) scale() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::scale, Real>(Record::scale);
  }
  /// 1 / scale
  PHYSGEN_FUNCTION decltype(auto) inverse() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::inverse, Real>(Record::inverse);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.scale = scale();
    value.inverse = inverse();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    scale() = value.scale;
    inverse() = value.inverse;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeScale.
struct NodeScaleObject {
  static constexpr std::string_view name = "quasistatic::NodeScale";
  template <class Real>
  using Value = NodeScale<Real>;
  template <class Real, class Formats>
  using Record = NodeScaleRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeScaleRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::scale, Real>(
        "scale", "", NodeScaleRecord<Real, Formats>::scale, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::inverse, Real>(
        "inverse", "", NodeScaleRecord<Real, Formats>::inverse, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeScaleFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeScaleProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeScaleObject, Space>>
using NodeScaleView = physgen::View<NodeScaleObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeScaleObject, Space>>
using NodeScaleArray = physgen::Array<NodeScaleObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeScaleObject, float, NodeScaleFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<NodeScaleObject, double, NodeScaleFormats<physgen::Host>>(16, 8, {0, 8}));

// ---- NodeInverse ----------------------------------------------------------------------------------------------------

/// The inverse of a node's diagonal block: block Jacobi.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeInverse {
  /// -K^-1 over the free components, 0 in prescribed ones. Symmetric, 6 stored.
  Eigen::Matrix<Real, 3, 3> D;
};

/// How the fields of one NodeInverse are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of NodeInverseArray.
template <class Space>
struct NodeInverseFormats {
  using D = physgen::format::Native;
};

struct NodeInverseObject;
/// NodeInverseFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeInverseFormats<physgen::Host>, class Object = NodeInverseObject,
          int first = 0>
struct NodeInverseProbe {
  using array_ = ArrayTag;
  using D = physgen::Probe<ArrayTag, Object, first + 0, typename Base::D>;
};

/// Where each field begins in the record of one NodeInverse [bytes].
template <class Real, class Formats>
struct NodeInverseRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Symmetric<3>, typename Formats::D, Real>(),
  }});
  static constexpr int D = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeInverse of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeInverseRef {
  using Record = NodeInverseRecord<Real, Formats>;

 public:
  using Value = NodeInverse<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeInverseRef(const Cursor& cursor) : at_(cursor) {}
  NodeInverseRef(const NodeInverseRef&) = default;
  NodeInverseRef& operator=(const NodeInverseRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeInverseRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// -K^-1 over the free components, 0 in prescribed ones. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) D() const {
    return at_.template field<physgen::shape::Symmetric<3>, typename Formats::D, Real>(Record::D);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.D = D().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { D() = value.D; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeInverse.
struct NodeInverseObject {
  static constexpr std::string_view name = "quasistatic::NodeInverse";
  template <class Real>
  using Value = NodeInverse<Real>;
  template <class Real, class Formats>
  using Record = NodeInverseRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeInverseRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::D, Real>(
        "D", "", NodeInverseRecord<Real, Formats>::D, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeInverseFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeInverseProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeInverseObject, Space>>
using NodeInverseView = physgen::View<NodeInverseObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<NodeInverseObject, Space>>
using NodeInverseArray = physgen::Array<NodeInverseObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeInverseObject, float, NodeInverseFormats<physgen::Host>>(24, 4, {0}));
static_assert(physgen::is_sound_record<NodeInverseObject, double, NodeInverseFormats<physgen::Host>>(48, 8, {0}));

// ---- TranslationStiffness -------------------------------------------------------------------------------------------

/// How stiffness without its prescribed components resists a translation of all nodes: its rows, summed.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct TranslationStiffness {
  /// sum of df(v)/dx(w) over all nodes w; 0 far from what is prescribed [N/m]
  Eigen::Matrix<Real, 3, 3> T;
};

/// How the fields of one TranslationStiffness are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of TranslationStiffnessArray.
template <class Space>
struct TranslationStiffnessFormats {
  using T = physgen::format::Native;
};

struct TranslationStiffnessObject;
/// TranslationStiffnessFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = TranslationStiffnessFormats<physgen::Host>,
          class Object = TranslationStiffnessObject, int first = 0>
struct TranslationStiffnessProbe {
  using array_ = ArrayTag;
  using T = physgen::Probe<ArrayTag, Object, first + 0, typename Base::T>;
};

/// Where each field begins in the record of one TranslationStiffness [bytes].
template <class Real, class Formats>
struct TranslationStiffnessRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::T, Real>(),
  }});
  static constexpr int T = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One TranslationStiffness of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class TranslationStiffnessRef {
  using Record = TranslationStiffnessRecord<Real, Formats>;

 public:
  using Value = TranslationStiffness<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit TranslationStiffnessRef(const Cursor& cursor) : at_(cursor) {}
  TranslationStiffnessRef(const TranslationStiffnessRef&) = default;
  TranslationStiffnessRef& operator=(const TranslationStiffnessRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const TranslationStiffnessRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// sum of df(v)/dx(w) over all nodes w; 0 far from what is prescribed [N/m]
  PHYSGEN_FUNCTION decltype(auto) T() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::T, Real>(Record::T);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.T = T().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { T() = value.T; }

 private:
  Cursor at_;
};

/// What the runtime knows of TranslationStiffness.
struct TranslationStiffnessObject {
  static constexpr std::string_view name = "quasistatic::TranslationStiffness";
  template <class Real>
  using Value = TranslationStiffness<Real>;
  template <class Real, class Formats>
  using Record = TranslationStiffnessRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = TranslationStiffnessRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::T, Real>(
        "T", "N/m", TranslationStiffnessRecord<Real, Formats>::T, 1, 0.0),
  }};
  template <class Space>
  using Formats = TranslationStiffnessFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = TranslationStiffnessProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TranslationStiffnessObject, Space>>
using TranslationStiffnessView = physgen::View<TranslationStiffnessObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<TranslationStiffnessObject, Space>>
using TranslationStiffnessArray = physgen::Array<TranslationStiffnessObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<TranslationStiffnessObject, float, TranslationStiffnessFormats<physgen::Host>>(
    36, 4, {0}));
static_assert(physgen::is_sound_record<TranslationStiffnessObject, double, TranslationStiffnessFormats<physgen::Host>>(
    72, 8, {0}));

// ---- TetTangent -----------------------------------------------------------------------------------------------------

/// The tangent of one tet: the blocks of its edges are formed from it where they are summed.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct TetTangent {
  /// principal directions in the current shape
  Eigen::Matrix<Real, 3, 3> U;
  /// by columns: V^T grad of corners j, k, l [1/m]
  Eigen::Matrix<Real, 3, 3> g;
  /// volume times those of StressDerivative [N m]
  Real x1111;
  /// volume times those of StressDerivative [N m]
  Real x2211;
  /// volume times those of StressDerivative [N m]
  Real x3311;
  /// volume times those of StressDerivative [N m]
  Real x2222;
  /// volume times those of StressDerivative [N m]
  Real x3322;
  /// volume times those of StressDerivative [N m]
  Real x3333;
  /// volume times those of StressDerivative [N m]
  Real x2121;
  /// volume times those of StressDerivative [N m]
  Real x2112;
  /// volume times those of StressDerivative [N m]
  Real x3131;
  /// volume times those of StressDerivative [N m]
  Real x3113;
  /// volume times those of StressDerivative [N m]
  Real x3232;
  /// volume times those of StressDerivative [N m]
  Real x3223;
};

/// How the fields of one TetTangent are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of TetTangentArray.
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
/// TetTangentFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
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

/// Where each field begins in the record of one TetTangent [bytes].
template <class Real, class Formats>
struct TetTangentRecord {
  static constexpr auto plan_ = physgen::plan_record<14>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::U, Real>(),
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::g, Real>(),
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
  static constexpr int U = plan_.offset[0];
  static constexpr int g = plan_.offset[1];
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
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One TetTangent of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class TetTangentRef {
  using Record = TetTangentRecord<Real, Formats>;

 public:
  using Value = TetTangent<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit TetTangentRef(const Cursor& cursor) : at_(cursor) {}
  TetTangentRef(const TetTangentRef&) = default;
  TetTangentRef& operator=(const TetTangentRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const TetTangentRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// principal directions in the current shape
  PHYSGEN_FUNCTION decltype(auto) U() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::U, Real>(Record::U);
  }
  /// by columns: V^T grad of corners j, k, l [1/m]
  PHYSGEN_FUNCTION decltype(auto) g() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::g, Real>(Record::g);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x1111() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x1111, Real>(Record::x1111);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x2211() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2211, Real>(Record::x2211);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3311() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3311, Real>(Record::x3311);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x2222() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2222, Real>(Record::x2222);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3322() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3322, Real>(Record::x3322);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3333() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3333, Real>(Record::x3333);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x2121() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2121, Real>(Record::x2121);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x2112() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x2112, Real>(Record::x2112);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3131() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3131, Real>(Record::x3131);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3113() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3113, Real>(Record::x3113);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3232() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3232, Real>(Record::x3232);
  }
  /// volume times those of StressDerivative [N m]
  PHYSGEN_FUNCTION decltype(auto) x3223() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::x3223, Real>(Record::x3223);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.U = U().get();
    value.g = g().get();
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

 private:
  Cursor at_;
};

/// What the runtime knows of TetTangent.
struct TetTangentObject {
  static constexpr std::string_view name = "quasistatic::TetTangent";
  template <class Real>
  using Value = TetTangent<Real>;
  template <class Real, class Formats>
  using Record = TetTangentRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = TetTangentRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 14> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::U, Real>(
        "U", "", TetTangentRecord<Real, Formats>::U, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::g, Real>(
        "g", "1/m", TetTangentRecord<Real, Formats>::g, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x1111, Real>(
        "x1111", "N m", TetTangentRecord<Real, Formats>::x1111, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2211, Real>(
        "x2211", "N m", TetTangentRecord<Real, Formats>::x2211, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3311, Real>(
        "x3311", "N m", TetTangentRecord<Real, Formats>::x3311, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2222, Real>(
        "x2222", "N m", TetTangentRecord<Real, Formats>::x2222, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3322, Real>(
        "x3322", "N m", TetTangentRecord<Real, Formats>::x3322, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3333, Real>(
        "x3333", "N m", TetTangentRecord<Real, Formats>::x3333, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2121, Real>(
        "x2121", "N m", TetTangentRecord<Real, Formats>::x2121, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x2112, Real>(
        "x2112", "N m", TetTangentRecord<Real, Formats>::x2112, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3131, Real>(
        "x3131", "N m", TetTangentRecord<Real, Formats>::x3131, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3113, Real>(
        "x3113", "N m", TetTangentRecord<Real, Formats>::x3113, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3232, Real>(
        "x3232", "N m", TetTangentRecord<Real, Formats>::x3232, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::x3223, Real>(
        "x3223", "N m", TetTangentRecord<Real, Formats>::x3223, 1, 0.0),
  }};
  template <class Space>
  using Formats = TetTangentFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = TetTangentProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TetTangentObject, Space>>
using TetTangentView = physgen::View<TetTangentObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetTangentObject, Space>>
using TetTangentArray = physgen::Array<TetTangentObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<TetTangentObject, float, TetTangentFormats<physgen::Host>>(
    120, 4, {0, 36, 72, 76, 80, 84, 88, 92, 96, 100, 104, 108, 112, 116}));
static_assert(physgen::is_sound_record<TetTangentObject, double, TetTangentFormats<physgen::Host>>(
    240, 8, {0, 72, 144, 152, 160, 168, 176, 184, 192, 200, 208, 216, 224, 232}));

// ---- TetPatch -------------------------------------------------------------------------------------------------------

/// Which patch a tet's volume is averaged over.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct TetPatch {
  /// its number
  physgen::same_lanes_t<Real, std::int32_t> patch;
};

/// How the fields of one TetPatch are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of TetPatchArray.
template <class Space>
struct TetPatchFormats {
  using patch = physgen::format::Native;
};

struct TetPatchObject;
/// TetPatchFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = TetPatchFormats<physgen::Host>, class Object = TetPatchObject, int first = 0>
struct TetPatchProbe {
  using array_ = ArrayTag;
  using patch = physgen::Probe<ArrayTag, Object, first + 0, typename Base::patch>;
};

/// Where each field begins in the record of one TetPatch [bytes].
template <class Real, class Formats>
struct TetPatchRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::patch, std::int32_t>(),
  }});
  static constexpr int patch = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One TetPatch of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class TetPatchRef {
  using Record = TetPatchRecord<Real, Formats>;

 public:
  using Value = TetPatch<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit TetPatchRef(const Cursor& cursor) : at_(cursor) {}
  TetPatchRef(const TetPatchRef&) = default;
  TetPatchRef& operator=(const TetPatchRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const TetPatchRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// its number
  PHYSGEN_FUNCTION decltype(auto) patch() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::patch, std::int32_t>(Record::patch);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.patch = patch();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { patch() = value.patch; }

 private:
  Cursor at_;
};

/// What the runtime knows of TetPatch.
struct TetPatchObject {
  static constexpr std::string_view name = "quasistatic::TetPatch";
  template <class Real>
  using Value = TetPatch<Real>;
  template <class Real, class Formats>
  using Record = TetPatchRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = TetPatchRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::patch, std::int32_t>(
        "patch", "", TetPatchRecord<Real, Formats>::patch, 1, 0.0),
  }};
  template <class Space>
  using Formats = TetPatchFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = TetPatchProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<TetPatchObject, Space>>
using TetPatchView = physgen::View<TetPatchObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<TetPatchObject, Space>>
using TetPatchArray = physgen::Array<TetPatchObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<TetPatchObject, float, TetPatchFormats<physgen::Host>>(4, 4, {0}));
static_assert(physgen::is_sound_record<TetPatchObject, double, TetPatchFormats<physgen::Host>>(4, 4, {0}));

// ---- PatchParent ----------------------------------------------------------------------------------------------------

/// The patch of the next coarser level where a patch lies.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PatchParent {
  /// its number on the coarser level
  physgen::same_lanes_t<Real, std::int32_t> patch;
};

/// How the fields of one PatchParent are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of PatchParentArray.
template <class Space>
struct PatchParentFormats {
  using patch = physgen::format::Native;
};

struct PatchParentObject;
/// PatchParentFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PatchParentFormats<physgen::Host>, class Object = PatchParentObject,
          int first = 0>
struct PatchParentProbe {
  using array_ = ArrayTag;
  using patch = physgen::Probe<ArrayTag, Object, first + 0, typename Base::patch>;
};

/// Where each field begins in the record of one PatchParent [bytes].
template <class Real, class Formats>
struct PatchParentRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::patch, std::int32_t>(),
  }});
  static constexpr int patch = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PatchParent of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PatchParentRef {
  using Record = PatchParentRecord<Real, Formats>;

 public:
  using Value = PatchParent<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PatchParentRef(const Cursor& cursor) : at_(cursor) {}
  PatchParentRef(const PatchParentRef&) = default;
  PatchParentRef& operator=(const PatchParentRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PatchParentRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// its number on the coarser level
  PHYSGEN_FUNCTION decltype(auto) patch() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::patch, std::int32_t>(Record::patch);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.patch = patch();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { patch() = value.patch; }

 private:
  Cursor at_;
};

/// What the runtime knows of PatchParent.
struct PatchParentObject {
  static constexpr std::string_view name = "quasistatic::PatchParent";
  template <class Real>
  using Value = PatchParent<Real>;
  template <class Real, class Formats>
  using Record = PatchParentRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PatchParentRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::patch, std::int32_t>(
        "patch", "", PatchParentRecord<Real, Formats>::patch, 1, 0.0),
  }};
  template <class Space>
  using Formats = PatchParentFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PatchParentProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchParentObject, Space>>
using PatchParentView = physgen::View<PatchParentObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchParentObject, Space>>
using PatchParentArray = physgen::Array<PatchParentObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PatchParentObject, float, PatchParentFormats<physgen::Host>>(4, 4, {0}));
static_assert(physgen::is_sound_record<PatchParentObject, double, PatchParentFormats<physgen::Host>>(4, 4, {0}));

// ---- PatchNodes -----------------------------------------------------------------------------------------------------

/// The nodes of a patch of tets.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PatchNodes {
  /// unused ones repeat the first
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 8, 1> nodes;
};

/// How the fields of one PatchNodes are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of PatchNodesArray.
template <class Space>
struct PatchNodesFormats {
  using nodes = physgen::format::Native;
};

struct PatchNodesObject;
/// PatchNodesFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PatchNodesFormats<physgen::Host>, class Object = PatchNodesObject, int first = 0>
struct PatchNodesProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
};

/// Where each field begins in the record of one PatchNodes [bytes].
template <class Real, class Formats>
struct PatchNodesRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<8>, typename Formats::nodes, std::int32_t>(),
  }});
  static constexpr int nodes = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PatchNodes of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PatchNodesRef {
  using Record = PatchNodesRecord<Real, Formats>;

 public:
  using Value = PatchNodes<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PatchNodesRef(const Cursor& cursor) : at_(cursor) {}
  PatchNodesRef(const PatchNodesRef&) = default;
  PatchNodesRef& operator=(const PatchNodesRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PatchNodesRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// unused ones repeat the first
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return at_.template field<physgen::shape::Vector<8>, typename Formats::nodes, std::int32_t>(Record::nodes);
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

/// What the runtime knows of PatchNodes.
struct PatchNodesObject {
  static constexpr std::string_view name = "quasistatic::PatchNodes";
  template <class Real>
  using Value = PatchNodes<Real>;
  template <class Real, class Formats>
  using Record = PatchNodesRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PatchNodesRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<8>, typename Formats::nodes, std::int32_t>(
        "nodes", "", PatchNodesRecord<Real, Formats>::nodes, 1, 0.0),
  }};
  template <class Space>
  using Formats = PatchNodesFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PatchNodesProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchNodesObject, Space>>
using PatchNodesView = physgen::View<PatchNodesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchNodesObject, Space>>
using PatchNodesArray = physgen::Array<PatchNodesObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PatchNodesObject, float, PatchNodesFormats<physgen::Host>>(32, 4, {0}));
static_assert(physgen::is_sound_record<PatchNodesObject, double, PatchNodesFormats<physgen::Host>>(32, 4, {0}));

// ---- PatchTet -------------------------------------------------------------------------------------------------------

/// A tet of a patch.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PatchTet {
  /// its number
  physgen::same_lanes_t<Real, std::int32_t> tet;
  /// which of the patch's nodes its corners are: 3 bits each, corner i lowest
  physgen::same_lanes_t<Real, std::int32_t> slots;
};

/// How the fields of one PatchTet are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of PatchTetArray.
template <class Space>
struct PatchTetFormats {
  using tet = physgen::format::Native;
  using slots = physgen::format::Native;
};

struct PatchTetObject;
/// PatchTetFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PatchTetFormats<physgen::Host>, class Object = PatchTetObject, int first = 0>
struct PatchTetProbe {
  using array_ = ArrayTag;
  using tet = physgen::Probe<ArrayTag, Object, first + 0, typename Base::tet>;
  using slots = physgen::Probe<ArrayTag, Object, first + 1, typename Base::slots>;
};

/// Where each field begins in the record of one PatchTet [bytes].
template <class Real, class Formats>
struct PatchTetRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::tet, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::slots, std::int32_t>(),
  }});
  static constexpr int tet = plan_.offset[0];
  static constexpr int slots = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PatchTet of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PatchTetRef {
  using Record = PatchTetRecord<Real, Formats>;

 public:
  using Value = PatchTet<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PatchTetRef(const Cursor& cursor) : at_(cursor) {}
  PatchTetRef(const PatchTetRef&) = default;
  PatchTetRef& operator=(const PatchTetRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PatchTetRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// its number
  PHYSGEN_FUNCTION decltype(auto) tet() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::tet, std::int32_t>(Record::tet);
  }
  /// which of the patch's nodes its corners are: 3 bits each, corner i lowest
  PHYSGEN_FUNCTION decltype(auto) slots() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::slots, std::int32_t>(Record::slots);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.tet = tet();
    value.slots = slots();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    tet() = value.tet;
    slots() = value.slots;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of PatchTet.
struct PatchTetObject {
  static constexpr std::string_view name = "quasistatic::PatchTet";
  template <class Real>
  using Value = PatchTet<Real>;
  template <class Real, class Formats>
  using Record = PatchTetRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PatchTetRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::tet, std::int32_t>(
        "tet", "", PatchTetRecord<Real, Formats>::tet, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::slots, std::int32_t>(
        "slots", "", PatchTetRecord<Real, Formats>::slots, 1, 0.0),
  }};
  template <class Space>
  using Formats = PatchTetFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PatchTetProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchTetObject, Space>>
using PatchTetView = physgen::View<PatchTetObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<PatchTetObject, Space>>
using PatchTetArray = physgen::Array<PatchTetObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PatchTetObject, float, PatchTetFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<PatchTetObject, double, PatchTetFormats<physgen::Host>>(8, 4, {0, 4}));

// ---- MeanVolume -----------------------------------------------------------------------------------------------------

/// The volume of a patch, or the mean one of the tets of a node, and what resists its change.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct MeanVolume {
  /// at rest [m^3]
  Real volume;
  /// T: current over rest volume [1]
  Real ratio;
  /// U'(T): of the forces [Pa]
  Real pressure;
  /// pi, which converges to U'(T) T or, of a quadratic law, to U'(T) [Pa]
  Real linearised;
  /// of the tangent [Pa]
  Real tangent_pressure;
  /// pi before a Newton step, and after all of it [Pa]
  Real before;
  /// pi before a Newton step, and after all of it [Pa]
  Real full;
};

/// How the fields of one MeanVolume are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of MeanVolumeArray.
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
/// MeanVolumeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
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

/// Where each field begins in the record of one MeanVolume [bytes].
template <class Real, class Formats>
struct MeanVolumeRecord {
  static constexpr auto plan_ = physgen::plan_record<7>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::volume, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::ratio, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::pressure, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::linearised, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::tangent_pressure, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::before, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::full, Real>(),
  }});
  static constexpr int volume = plan_.offset[0];
  static constexpr int ratio = plan_.offset[1];
  static constexpr int pressure = plan_.offset[2];
  static constexpr int linearised = plan_.offset[3];
  static constexpr int tangent_pressure = plan_.offset[4];
  static constexpr int before = plan_.offset[5];
  static constexpr int full = plan_.offset[6];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One MeanVolume of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class MeanVolumeRef {
  using Record = MeanVolumeRecord<Real, Formats>;

 public:
  using Value = MeanVolume<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit MeanVolumeRef(const Cursor& cursor) : at_(cursor) {}
  MeanVolumeRef(const MeanVolumeRef&) = default;
  MeanVolumeRef& operator=(const MeanVolumeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const MeanVolumeRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// at rest [m^3]
  PHYSGEN_FUNCTION decltype(auto) volume() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::volume, Real>(Record::volume);
  }
  /// T: current over rest volume [1]
  PHYSGEN_FUNCTION decltype(auto) ratio() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::ratio, Real>(Record::ratio);
  }
  /// U'(T): of the forces [Pa]
  PHYSGEN_FUNCTION decltype(auto) pressure() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::pressure, Real>(Record::pressure);
  }
  /// pi, which converges to U'(T) T or, of a quadratic law, to U'(T) [Pa]
  PHYSGEN_FUNCTION decltype(auto) linearised() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::linearised, Real>(Record::linearised);
  }
  /// of the tangent [Pa]
  PHYSGEN_FUNCTION decltype(auto) tangent_pressure() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::tangent_pressure, Real>(
        Record::tangent_pressure);
  }
  /// pi before a Newton step, and after all of it [Pa]
  PHYSGEN_FUNCTION decltype(auto) before() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::before, Real>(Record::before);
  }
  /// pi before a Newton step, and after all of it [Pa]
  PHYSGEN_FUNCTION decltype(auto) full() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::full, Real>(Record::full);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.volume = volume();
    value.ratio = ratio();
    value.pressure = pressure();
    value.linearised = linearised();
    value.tangent_pressure = tangent_pressure();
    value.before = before();
    value.full = full();
    return value;
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

 private:
  Cursor at_;
};

/// What the runtime knows of MeanVolume.
struct MeanVolumeObject {
  static constexpr std::string_view name = "quasistatic::MeanVolume";
  template <class Real>
  using Value = MeanVolume<Real>;
  template <class Real, class Formats>
  using Record = MeanVolumeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = MeanVolumeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 7> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::volume, Real>(
        "volume", "m^3", MeanVolumeRecord<Real, Formats>::volume, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::ratio, Real>(
        "ratio", "1", MeanVolumeRecord<Real, Formats>::ratio, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::pressure, Real>(
        "pressure", "Pa", MeanVolumeRecord<Real, Formats>::pressure, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::linearised, Real>(
        "linearised", "Pa", MeanVolumeRecord<Real, Formats>::linearised, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::tangent_pressure, Real>(
        "tangent_pressure", "Pa", MeanVolumeRecord<Real, Formats>::tangent_pressure, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::before, Real>(
        "before", "Pa", MeanVolumeRecord<Real, Formats>::before, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::full, Real>(
        "full", "Pa", MeanVolumeRecord<Real, Formats>::full, 1, 0.0),
  }};
  template <class Space>
  using Formats = MeanVolumeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = MeanVolumeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<MeanVolumeObject, Space>>
using MeanVolumeView = physgen::View<MeanVolumeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<MeanVolumeObject, Space>>
using MeanVolumeArray = physgen::Array<MeanVolumeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<MeanVolumeObject, float, MeanVolumeFormats<physgen::Host>>(
    28, 4, {0, 4, 8, 12, 16, 20, 24}));
static_assert(physgen::is_sound_record<MeanVolumeObject, double, MeanVolumeFormats<physgen::Host>>(
    56, 8, {0, 8, 16, 24, 32, 40, 48}));

// ---- RingNode -------------------------------------------------------------------------------------------------------

/// One of a node's ring: a neighbour, or the node itself. Neighbours are in each other's rings.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct RingNode {
  /// its number
  physgen::same_lanes_t<Real, std::int32_t> node;
  /// change of its mean volume with the node whose ring it is in [m^2]
  Eigen::Matrix<Real, 3, 1> g;
};

/// How the fields of one RingNode are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of RingNodeArray.
template <class Space>
struct RingNodeFormats {
  using node = physgen::format::Native;
  using g = physgen::format::Native;
};

struct RingNodeObject;
/// RingNodeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = RingNodeFormats<physgen::Host>, class Object = RingNodeObject, int first = 0>
struct RingNodeProbe {
  using array_ = ArrayTag;
  using node = physgen::Probe<ArrayTag, Object, first + 0, typename Base::node>;
  using g = physgen::Probe<ArrayTag, Object, first + 1, typename Base::g>;
};

/// Where each field begins in the record of one RingNode [bytes].
template <class Real, class Formats>
struct RingNodeRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::node, std::int32_t>(),
    physgen::slot<physgen::shape::Vector<3>, typename Formats::g, Real>(),
  }});
  static constexpr int node = plan_.offset[0];
  static constexpr int g = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One RingNode of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class RingNodeRef {
  using Record = RingNodeRecord<Real, Formats>;

 public:
  using Value = RingNode<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit RingNodeRef(const Cursor& cursor) : at_(cursor) {}
  RingNodeRef(const RingNodeRef&) = default;
  RingNodeRef& operator=(const RingNodeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const RingNodeRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// its number
  PHYSGEN_FUNCTION decltype(auto) node() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::node, std::int32_t>(Record::node);
  }
  /// change of its mean volume with the node whose ring it is in [m^2]
  PHYSGEN_FUNCTION decltype(auto) g() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::g, Real>(Record::g);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.node = node();
    value.g = g().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    node() = value.node;
    g() = value.g;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of RingNode.
struct RingNodeObject {
  static constexpr std::string_view name = "quasistatic::RingNode";
  template <class Real>
  using Value = RingNode<Real>;
  template <class Real, class Formats>
  using Record = RingNodeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = RingNodeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::node, std::int32_t>(
        "node", "", RingNodeRecord<Real, Formats>::node, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::g, Real>(
        "g", "m^2", RingNodeRecord<Real, Formats>::g, 1, 0.0),
  }};
  template <class Space>
  using Formats = RingNodeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = RingNodeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<RingNodeObject, Space>>
using RingNodeView = physgen::View<RingNodeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<RingNodeObject, Space>>
using RingNodeArray = physgen::Array<RingNodeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<RingNodeObject, float, RingNodeFormats<physgen::Host>>(16, 4, {0, 4}));
static_assert(physgen::is_sound_record<RingNodeObject, double, RingNodeFormats<physgen::Host>>(28, 8, {24, 0}));

// ---- NodeVolumeTangent ----------------------------------------------------------------------------------------------

/// What resists the change of a node's mean volume: k of its k g g^T in the tangent.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeVolumeTangent {
  /// U''(T) / volume, or its linearised form [N/m^5]
  Real k;
};

/// How the fields of one NodeVolumeTangent are stored in a memory space. To store some otherwise, derive from it,
/// declare those anew, and name the derived struct as the last argument of NodeVolumeTangentArray.
template <class Space>
struct NodeVolumeTangentFormats {
  using k = physgen::format::Native;
};

struct NodeVolumeTangentObject;
/// NodeVolumeTangentFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeVolumeTangentFormats<physgen::Host>, class Object = NodeVolumeTangentObject,
          int first = 0>
struct NodeVolumeTangentProbe {
  using array_ = ArrayTag;
  using k = physgen::Probe<ArrayTag, Object, first + 0, typename Base::k>;
};

/// Where each field begins in the record of one NodeVolumeTangent [bytes].
template <class Real, class Formats>
struct NodeVolumeTangentRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::k, Real>(),
  }});
  static constexpr int k = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeVolumeTangent of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeVolumeTangentRef {
  using Record = NodeVolumeTangentRecord<Real, Formats>;

 public:
  using Value = NodeVolumeTangent<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeVolumeTangentRef(const Cursor& cursor) : at_(cursor) {}
  NodeVolumeTangentRef(const NodeVolumeTangentRef&) = default;
  NodeVolumeTangentRef& operator=(const NodeVolumeTangentRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeVolumeTangentRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// U''(T) / volume, or its linearised form [N/m^5]
  PHYSGEN_FUNCTION decltype(auto) k() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::k, Real>(Record::k);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.k = k();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { k() = value.k; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeVolumeTangent.
struct NodeVolumeTangentObject {
  static constexpr std::string_view name = "quasistatic::NodeVolumeTangent";
  template <class Real>
  using Value = NodeVolumeTangent<Real>;
  template <class Real, class Formats>
  using Record = NodeVolumeTangentRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeVolumeTangentRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::k, Real>(
        "k", "N/m^5", NodeVolumeTangentRecord<Real, Formats>::k, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeVolumeTangentFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeVolumeTangentProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeVolumeTangentObject, Space>>
using NodeVolumeTangentView = physgen::View<NodeVolumeTangentObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<NodeVolumeTangentObject, Space>>
using NodeVolumeTangentArray = physgen::Array<NodeVolumeTangentObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeVolumeTangentObject, float, NodeVolumeTangentFormats<physgen::Host>>(
    4, 4, {0}));
static_assert(physgen::is_sound_record<NodeVolumeTangentObject, double, NodeVolumeTangentFormats<physgen::Host>>(
    8, 8, {0}));

// ---- CoarseInverse --------------------------------------------------------------------------------------------------

/// A block of the inverse of the coarsest level's stiffness, which is dense.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct CoarseInverse {
  /// of nodes i and j of n, in object i n + j
  Eigen::Matrix<Real, 3, 3> G;
};

/// How the fields of one CoarseInverse are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of CoarseInverseArray.
template <class Space>
struct CoarseInverseFormats {
  using G = physgen::format::Native;
};

struct CoarseInverseObject;
/// CoarseInverseFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = CoarseInverseFormats<physgen::Host>, class Object = CoarseInverseObject,
          int first = 0>
struct CoarseInverseProbe {
  using array_ = ArrayTag;
  using G = physgen::Probe<ArrayTag, Object, first + 0, typename Base::G>;
};

/// Where each field begins in the record of one CoarseInverse [bytes].
template <class Real, class Formats>
struct CoarseInverseRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::G, Real>(),
  }});
  static constexpr int G = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One CoarseInverse of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class CoarseInverseRef {
  using Record = CoarseInverseRecord<Real, Formats>;

 public:
  using Value = CoarseInverse<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit CoarseInverseRef(const Cursor& cursor) : at_(cursor) {}
  CoarseInverseRef(const CoarseInverseRef&) = default;
  CoarseInverseRef& operator=(const CoarseInverseRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const CoarseInverseRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// of nodes i and j of n, in object i n + j
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

/// What the runtime knows of CoarseInverse.
struct CoarseInverseObject {
  static constexpr std::string_view name = "quasistatic::CoarseInverse";
  template <class Real>
  using Value = CoarseInverse<Real>;
  template <class Real, class Formats>
  using Record = CoarseInverseRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = CoarseInverseRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::G, Real>(
        "G", "", CoarseInverseRecord<Real, Formats>::G, 1, 0.0),
  }};
  template <class Space>
  using Formats = CoarseInverseFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = CoarseInverseProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<CoarseInverseObject, Space>>
using CoarseInverseView = physgen::View<CoarseInverseObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<CoarseInverseObject, Space>>
using CoarseInverseArray = physgen::Array<CoarseInverseObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<CoarseInverseObject, float, CoarseInverseFormats<physgen::Host>>(36, 4, {0}));
static_assert(physgen::is_sound_record<CoarseInverseObject, double, CoarseInverseFormats<physgen::Host>>(72, 8, {0}));

// ---- PatchTangent ---------------------------------------------------------------------------------------------------

/// The part of the tangent that a patch's volume has: k g g^T.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PatchTangent {
  /// by columns: change of the patch's volume with its nodes [m^2]
  Eigen::Matrix<Real, 3, 8> g;
  /// U''(T) / volume, or its linearised form [N/m^5]
  Real k;
};

/// How the fields of one PatchTangent are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of PatchTangentArray.
template <class Space>
struct PatchTangentFormats {
  using g = physgen::format::Native;
  using k = physgen::format::Native;
};

struct PatchTangentObject;
/// PatchTangentFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PatchTangentFormats<physgen::Host>, class Object = PatchTangentObject,
          int first = 0>
struct PatchTangentProbe {
  using array_ = ArrayTag;
  using g = physgen::Probe<ArrayTag, Object, first + 0, typename Base::g>;
  using k = physgen::Probe<ArrayTag, Object, first + 1, typename Base::k>;
};

/// Where each field begins in the record of one PatchTangent [bytes].
template <class Real, class Formats>
struct PatchTangentRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Matrix<3, 8>, typename Formats::g, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::k, Real>(),
  }});
  static constexpr int g = plan_.offset[0];
  static constexpr int k = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PatchTangent of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PatchTangentRef {
  using Record = PatchTangentRecord<Real, Formats>;

 public:
  using Value = PatchTangent<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PatchTangentRef(const Cursor& cursor) : at_(cursor) {}
  PatchTangentRef(const PatchTangentRef&) = default;
  PatchTangentRef& operator=(const PatchTangentRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PatchTangentRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// by columns: change of the patch's volume with its nodes [m^2]
  PHYSGEN_FUNCTION decltype(auto) g() const {
    return at_.template field<physgen::shape::Matrix<3, 8>, typename Formats::g, Real>(Record::g);
  }
  /// U''(T) / volume, or its linearised form [N/m^5]
  PHYSGEN_FUNCTION decltype(auto) k() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::k, Real>(Record::k);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.g = g().get();
    value.k = k();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    g() = value.g;
    k() = value.k;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of PatchTangent.
struct PatchTangentObject {
  static constexpr std::string_view name = "quasistatic::PatchTangent";
  template <class Real>
  using Value = PatchTangent<Real>;
  template <class Real, class Formats>
  using Record = PatchTangentRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PatchTangentRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 8>, typename Formats::g, Real>(
        "g", "m^2", PatchTangentRecord<Real, Formats>::g, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::k, Real>(
        "k", "N/m^5", PatchTangentRecord<Real, Formats>::k, 1, 0.0),
  }};
  template <class Space>
  using Formats = PatchTangentFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PatchTangentProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchTangentObject, Space>>
using PatchTangentView = physgen::View<PatchTangentObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchTangentObject, Space>>
using PatchTangentArray = physgen::Array<PatchTangentObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PatchTangentObject, float, PatchTangentFormats<physgen::Host>>(100, 4, {0, 96}));
static_assert(physgen::is_sound_record<PatchTangentObject, double, PatchTangentFormats<physgen::Host>>(
    200, 8, {0, 192}));

// ---- PatchChange ----------------------------------------------------------------------------------------------------

/// What a patch's forces change by along a displacement, on the CPU in a product without blocks of edges.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PatchChange {
  /// k g . dx [N/m^2]
  Real change;
};

/// How the fields of one PatchChange are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of PatchChangeArray.
template <class Space>
struct PatchChangeFormats {
  using change = physgen::format::Native;
};

struct PatchChangeObject;
/// PatchChangeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PatchChangeFormats<physgen::Host>, class Object = PatchChangeObject,
          int first = 0>
struct PatchChangeProbe {
  using array_ = ArrayTag;
  using change = physgen::Probe<ArrayTag, Object, first + 0, typename Base::change>;
};

/// Where each field begins in the record of one PatchChange [bytes].
template <class Real, class Formats>
struct PatchChangeRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::change, Real>(),
  }});
  static constexpr int change = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PatchChange of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PatchChangeRef {
  using Record = PatchChangeRecord<Real, Formats>;

 public:
  using Value = PatchChange<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PatchChangeRef(const Cursor& cursor) : at_(cursor) {}
  PatchChangeRef(const PatchChangeRef&) = default;
  PatchChangeRef& operator=(const PatchChangeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PatchChangeRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// k g . dx [N/m^2]
  PHYSGEN_FUNCTION decltype(auto) change() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::change, Real>(Record::change);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.change = change();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { change() = value.change; }

 private:
  Cursor at_;
};

/// What the runtime knows of PatchChange.
struct PatchChangeObject {
  static constexpr std::string_view name = "quasistatic::PatchChange";
  template <class Real>
  using Value = PatchChange<Real>;
  template <class Real, class Formats>
  using Record = PatchChangeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PatchChangeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::change, Real>(
        "change", "N/m^2", PatchChangeRecord<Real, Formats>::change, 1, 0.0),
  }};
  template <class Space>
  using Formats = PatchChangeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PatchChangeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PatchChangeObject, Space>>
using PatchChangeView = physgen::View<PatchChangeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchChangeObject, Space>>
using PatchChangeArray = physgen::Array<PatchChangeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PatchChangeObject, float, PatchChangeFormats<physgen::Host>>(4, 4, {0}));
static_assert(physgen::is_sound_record<PatchChangeObject, double, PatchChangeFormats<physgen::Host>>(8, 8, {0}));

// ---- SchwarzNode ----------------------------------------------------------------------------------------------------

/// Where a node stands in the order of blocks.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct SchwarzNode {
  /// number of its SchwarzSlot; -1: all its components are prescribed
  physgen::same_lanes_t<Real, std::int32_t> slot;
};

/// How the fields of one SchwarzNode are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of SchwarzNodeArray.
template <class Space>
struct SchwarzNodeFormats {
  using slot = physgen::format::Native;
};

struct SchwarzNodeObject;
/// SchwarzNodeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = SchwarzNodeFormats<physgen::Host>, class Object = SchwarzNodeObject,
          int first = 0>
struct SchwarzNodeProbe {
  using array_ = ArrayTag;
  using slot = physgen::Probe<ArrayTag, Object, first + 0, typename Base::slot>;
};

/// Where each field begins in the record of one SchwarzNode [bytes].
template <class Real, class Formats>
struct SchwarzNodeRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::slot, std::int32_t>(),
  }});
  static constexpr int slot = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One SchwarzNode of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class SchwarzNodeRef {
  using Record = SchwarzNodeRecord<Real, Formats>;

 public:
  using Value = SchwarzNode<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit SchwarzNodeRef(const Cursor& cursor) : at_(cursor) {}
  SchwarzNodeRef(const SchwarzNodeRef&) = default;
  SchwarzNodeRef& operator=(const SchwarzNodeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const SchwarzNodeRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// number of its SchwarzSlot; -1: all its components are prescribed
  PHYSGEN_FUNCTION decltype(auto) slot() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::slot, std::int32_t>(Record::slot);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.slot = slot();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { slot() = value.slot; }

 private:
  Cursor at_;
};

/// What the runtime knows of SchwarzNode.
struct SchwarzNodeObject {
  static constexpr std::string_view name = "quasistatic::SchwarzNode";
  template <class Real>
  using Value = SchwarzNode<Real>;
  template <class Real, class Formats>
  using Record = SchwarzNodeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = SchwarzNodeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::slot, std::int32_t>(
        "slot", "", SchwarzNodeRecord<Real, Formats>::slot, 1, 0.0),
  }};
  template <class Space>
  using Formats = SchwarzNodeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = SchwarzNodeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzNodeObject, Space>>
using SchwarzNodeView = physgen::View<SchwarzNodeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzNodeObject, Space>>
using SchwarzNodeArray = physgen::Array<SchwarzNodeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<SchwarzNodeObject, float, SchwarzNodeFormats<physgen::Host>>(4, 4, {0}));
static_assert(physgen::is_sound_record<SchwarzNodeObject, double, SchwarzNodeFormats<physgen::Host>>(4, 4, {0}));

// ---- SchwarzSlot ----------------------------------------------------------------------------------------------------

/// A place in a block: slots 32 b .. 32 b + 31 are those of block b.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct SchwarzSlot {
  /// which node stands here, or behind the first level which supernode; -1: none
  physgen::same_lanes_t<Real, std::int32_t> source;
  /// the supernode of the next level that it belongs to; -1 on the last level
  physgen::same_lanes_t<Real, std::int32_t> parent;
};

/// How the fields of one SchwarzSlot are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of SchwarzSlotArray.
template <class Space>
struct SchwarzSlotFormats {
  using source = physgen::format::Native;
  using parent = physgen::format::Native;
};

struct SchwarzSlotObject;
/// SchwarzSlotFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = SchwarzSlotFormats<physgen::Host>, class Object = SchwarzSlotObject,
          int first = 0>
struct SchwarzSlotProbe {
  using array_ = ArrayTag;
  using source = physgen::Probe<ArrayTag, Object, first + 0, typename Base::source>;
  using parent = physgen::Probe<ArrayTag, Object, first + 1, typename Base::parent>;
};

/// Where each field begins in the record of one SchwarzSlot [bytes].
template <class Real, class Formats>
struct SchwarzSlotRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::source, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::parent, std::int32_t>(),
  }});
  static constexpr int source = plan_.offset[0];
  static constexpr int parent = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One SchwarzSlot of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class SchwarzSlotRef {
  using Record = SchwarzSlotRecord<Real, Formats>;

 public:
  using Value = SchwarzSlot<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit SchwarzSlotRef(const Cursor& cursor) : at_(cursor) {}
  SchwarzSlotRef(const SchwarzSlotRef&) = default;
  SchwarzSlotRef& operator=(const SchwarzSlotRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const SchwarzSlotRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// which node stands here, or behind the first level which supernode; -1: none
  PHYSGEN_FUNCTION decltype(auto) source() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::source, std::int32_t>(Record::source);
  }
  /// the supernode of the next level that it belongs to; -1 on the last level
  PHYSGEN_FUNCTION decltype(auto) parent() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::parent, std::int32_t>(Record::parent);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.source = source();
    value.parent = parent();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    source() = value.source;
    parent() = value.parent;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of SchwarzSlot.
struct SchwarzSlotObject {
  static constexpr std::string_view name = "quasistatic::SchwarzSlot";
  template <class Real>
  using Value = SchwarzSlot<Real>;
  template <class Real, class Formats>
  using Record = SchwarzSlotRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = SchwarzSlotRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::source, std::int32_t>(
        "source", "", SchwarzSlotRecord<Real, Formats>::source, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::parent, std::int32_t>(
        "parent", "", SchwarzSlotRecord<Real, Formats>::parent, 1, 0.0),
  }};
  template <class Space>
  using Formats = SchwarzSlotFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = SchwarzSlotProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzSlotObject, Space>>
using SchwarzSlotView = physgen::View<SchwarzSlotObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzSlotObject, Space>>
using SchwarzSlotArray = physgen::Array<SchwarzSlotObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<SchwarzSlotObject, float, SchwarzSlotFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<SchwarzSlotObject, double, SchwarzSlotFormats<physgen::Host>>(8, 4, {0, 4}));

// ---- SchwarzBlock ---------------------------------------------------------------------------------------------------

/// A block of 32 slots.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct SchwarzBlock {
  /// a power of two, by which the stored factor is smaller than the real one
  Real scale;
  /// the block of the next level that its supernodes belong to; -1 on the last level
  physgen::same_lanes_t<Real, std::int32_t> parent;
  /// how many blocks of the level before have this one as their parent
  physgen::same_lanes_t<Real, std::int32_t> children;
  /// how many of them have handed their forces over; 0 between two applications
  physgen::same_lanes_t<Real, std::int32_t> arrived;
};

/// How the fields of one SchwarzBlock are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of SchwarzBlockArray.
template <class Space>
struct SchwarzBlockFormats {
  using scale = physgen::format::Native;
  using parent = physgen::format::Native;
  using children = physgen::format::Native;
  using arrived = physgen::format::Native;
};

struct SchwarzBlockObject;
/// SchwarzBlockFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = SchwarzBlockFormats<physgen::Host>, class Object = SchwarzBlockObject,
          int first = 0>
struct SchwarzBlockProbe {
  using array_ = ArrayTag;
  using scale = physgen::Probe<ArrayTag, Object, first + 0, typename Base::scale>;
  using parent = physgen::Probe<ArrayTag, Object, first + 1, typename Base::parent>;
  using children = physgen::Probe<ArrayTag, Object, first + 2, typename Base::children>;
  using arrived = physgen::Probe<ArrayTag, Object, first + 3, typename Base::arrived>;
};

/// Where each field begins in the record of one SchwarzBlock [bytes].
template <class Real, class Formats>
struct SchwarzBlockRecord {
  static constexpr auto plan_ = physgen::plan_record<4>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::scale, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::parent, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::children, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::arrived, std::int32_t>(),
  }});
  static constexpr int scale = plan_.offset[0];
  static constexpr int parent = plan_.offset[1];
  static constexpr int children = plan_.offset[2];
  static constexpr int arrived = plan_.offset[3];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One SchwarzBlock of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class SchwarzBlockRef {
  using Record = SchwarzBlockRecord<Real, Formats>;

 public:
  using Value = SchwarzBlock<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit SchwarzBlockRef(const Cursor& cursor) : at_(cursor) {}
  SchwarzBlockRef(const SchwarzBlockRef&) = default;
  SchwarzBlockRef& operator=(const SchwarzBlockRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const SchwarzBlockRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// a power of two, by which the stored factor is smaller than the real one
  PHYSGEN_FUNCTION decltype(auto) scale() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::scale, Real>(Record::scale);
  }
  /// the block of the next level that its supernodes belong to; -1 on the last level
  PHYSGEN_FUNCTION decltype(auto) parent() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::parent, std::int32_t>(Record::parent);
  }
  /// how many blocks of the level before have this one as their parent
  PHYSGEN_FUNCTION decltype(auto) children() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::children, std::int32_t>(Record::children);
  }
  /// how many of them have handed their forces over; 0 between two applications
  PHYSGEN_FUNCTION decltype(auto) arrived() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::arrived, std::int32_t>(Record::arrived);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.scale = scale();
    value.parent = parent();
    value.children = children();
    value.arrived = arrived();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    scale() = value.scale;
    parent() = value.parent;
    children() = value.children;
    arrived() = value.arrived;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of SchwarzBlock.
struct SchwarzBlockObject {
  static constexpr std::string_view name = "quasistatic::SchwarzBlock";
  template <class Real>
  using Value = SchwarzBlock<Real>;
  template <class Real, class Formats>
  using Record = SchwarzBlockRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = SchwarzBlockRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 4> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::scale, Real>(
        "scale", "", SchwarzBlockRecord<Real, Formats>::scale, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::parent, std::int32_t>(
        "parent", "", SchwarzBlockRecord<Real, Formats>::parent, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::children, std::int32_t>(
        "children", "", SchwarzBlockRecord<Real, Formats>::children, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::arrived, std::int32_t>(
        "arrived", "", SchwarzBlockRecord<Real, Formats>::arrived, 1, 0.0),
  }};
  template <class Space>
  using Formats = SchwarzBlockFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = SchwarzBlockProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzBlockObject, Space>>
using SchwarzBlockView = physgen::View<SchwarzBlockObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzBlockObject, Space>>
using SchwarzBlockArray = physgen::Array<SchwarzBlockObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<SchwarzBlockObject, float, SchwarzBlockFormats<physgen::Host>>(
    16, 4, {0, 4, 8, 12}));
static_assert(physgen::is_sound_record<SchwarzBlockObject, double, SchwarzBlockFormats<physgen::Host>>(
    20, 8, {0, 8, 12, 16}));

// ---- Supernode ------------------------------------------------------------------------------------------------------

/// Nodes that are connected within one block, and move as one on the next level.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Supernode {
  /// sum of the stiffness of its nodes and of the edges among them [N/m]. Symmetric, 6 stored.
  Eigen::Matrix<Real, 3, 3> K;
  /// sum of its nodes' |K_kk|: what rounding is measured against [N/m]
  Eigen::Matrix<Real, 3, 1> magnitude;
};

/// How the fields of one Supernode are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of SupernodeArray.
template <class Space>
struct SupernodeFormats {
  using K = physgen::format::Native;
  using magnitude = physgen::format::Native;
};

struct SupernodeObject;
/// SupernodeFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = SupernodeFormats<physgen::Host>, class Object = SupernodeObject, int first = 0>
struct SupernodeProbe {
  using array_ = ArrayTag;
  using K = physgen::Probe<ArrayTag, Object, first + 0, typename Base::K>;
  using magnitude = physgen::Probe<ArrayTag, Object, first + 1, typename Base::magnitude>;
};

/// Where each field begins in the record of one Supernode [bytes].
template <class Real, class Formats>
struct SupernodeRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Symmetric<3>, typename Formats::K, Real>(),
    physgen::slot<physgen::shape::Vector<3>, typename Formats::magnitude, Real>(),
  }});
  static constexpr int K = plan_.offset[0];
  static constexpr int magnitude = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Supernode of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class SupernodeRef {
  using Record = SupernodeRecord<Real, Formats>;

 public:
  using Value = Supernode<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit SupernodeRef(const Cursor& cursor) : at_(cursor) {}
  SupernodeRef(const SupernodeRef&) = default;
  SupernodeRef& operator=(const SupernodeRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const SupernodeRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// sum of the stiffness of its nodes and of the edges among them [N/m]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) K() const {
    return at_.template field<physgen::shape::Symmetric<3>, typename Formats::K, Real>(Record::K);
  }
  /// sum of its nodes' |K_kk|: what rounding is measured against [N/m]
  PHYSGEN_FUNCTION decltype(auto) magnitude() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::magnitude, Real>(Record::magnitude);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.K = K().get();
    value.magnitude = magnitude().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    K() = value.K;
    magnitude() = value.magnitude;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Supernode.
struct SupernodeObject {
  static constexpr std::string_view name = "quasistatic::Supernode";
  template <class Real>
  using Value = Supernode<Real>;
  template <class Real, class Formats>
  using Record = SupernodeRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = SupernodeRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::K, Real>(
        "K", "N/m", SupernodeRecord<Real, Formats>::K, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::magnitude, Real>(
        "magnitude", "N/m", SupernodeRecord<Real, Formats>::magnitude, 1, 0.0),
  }};
  template <class Space>
  using Formats = SupernodeFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = SupernodeProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SupernodeObject, Space>>
using SupernodeView = physgen::View<SupernodeObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SupernodeObject, Space>>
using SupernodeArray = physgen::Array<SupernodeObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<SupernodeObject, float, SupernodeFormats<physgen::Host>>(36, 4, {0, 24}));
static_assert(physgen::is_sound_record<SupernodeObject, double, SupernodeFormats<physgen::Host>>(72, 8, {0, 48}));

// ---- SchwarzTerm ----------------------------------------------------------------------------------------------------

/// What a supernode, or a pair of them, is summed from.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct SchwarzTerm {
  /// a node or an edge of the level before
  physgen::same_lanes_t<Real, std::int32_t> source;
  /// of a supernode: 0 a node, 1 an edge inside; of a pair: 0 an edge, 1 an edge the other way round
  physgen::same_lanes_t<Real, std::int32_t> kind;
};

/// How the fields of one SchwarzTerm are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of SchwarzTermArray.
template <class Space>
struct SchwarzTermFormats {
  using source = physgen::format::Native;
  using kind = physgen::format::Native;
};

struct SchwarzTermObject;
/// SchwarzTermFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = SchwarzTermFormats<physgen::Host>, class Object = SchwarzTermObject,
          int first = 0>
struct SchwarzTermProbe {
  using array_ = ArrayTag;
  using source = physgen::Probe<ArrayTag, Object, first + 0, typename Base::source>;
  using kind = physgen::Probe<ArrayTag, Object, first + 1, typename Base::kind>;
};

/// Where each field begins in the record of one SchwarzTerm [bytes].
template <class Real, class Formats>
struct SchwarzTermRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::source, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::kind, std::int32_t>(),
  }});
  static constexpr int source = plan_.offset[0];
  static constexpr int kind = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One SchwarzTerm of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class SchwarzTermRef {
  using Record = SchwarzTermRecord<Real, Formats>;

 public:
  using Value = SchwarzTerm<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit SchwarzTermRef(const Cursor& cursor) : at_(cursor) {}
  SchwarzTermRef(const SchwarzTermRef&) = default;
  SchwarzTermRef& operator=(const SchwarzTermRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const SchwarzTermRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// a node or an edge of the level before
  PHYSGEN_FUNCTION decltype(auto) source() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::source, std::int32_t>(Record::source);
  }
  /// of a supernode: 0 a node, 1 an edge inside; of a pair: 0 an edge, 1 an edge the other way round
  PHYSGEN_FUNCTION decltype(auto) kind() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::kind, std::int32_t>(Record::kind);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.source = source();
    value.kind = kind();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    source() = value.source;
    kind() = value.kind;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of SchwarzTerm.
struct SchwarzTermObject {
  static constexpr std::string_view name = "quasistatic::SchwarzTerm";
  template <class Real>
  using Value = SchwarzTerm<Real>;
  template <class Real, class Formats>
  using Record = SchwarzTermRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = SchwarzTermRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::source, std::int32_t>(
        "source", "", SchwarzTermRecord<Real, Formats>::source, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::kind, std::int32_t>(
        "kind", "", SchwarzTermRecord<Real, Formats>::kind, 1, 0.0),
  }};
  template <class Space>
  using Formats = SchwarzTermFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = SchwarzTermProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzTermObject, Space>>
using SchwarzTermView = physgen::View<SchwarzTermObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzTermObject, Space>>
using SchwarzTermArray = physgen::Array<SchwarzTermObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<SchwarzTermObject, float, SchwarzTermFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<SchwarzTermObject, double, SchwarzTermFormats<physgen::Host>>(8, 4, {0, 4}));

// ---- SchwarzPair ----------------------------------------------------------------------------------------------------

/// An edge whose two ends stand in one block.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct SchwarzPair {
  /// its number
  physgen::same_lanes_t<Real, std::int32_t> edge;
  /// that of m + 32 that of n
  physgen::same_lanes_t<Real, std::int32_t> places;
};

/// How the fields of one SchwarzPair are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of SchwarzPairArray.
template <class Space>
struct SchwarzPairFormats {
  using edge = physgen::format::Native;
  using places = physgen::format::Native;
};

struct SchwarzPairObject;
/// SchwarzPairFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = SchwarzPairFormats<physgen::Host>, class Object = SchwarzPairObject,
          int first = 0>
struct SchwarzPairProbe {
  using array_ = ArrayTag;
  using edge = physgen::Probe<ArrayTag, Object, first + 0, typename Base::edge>;
  using places = physgen::Probe<ArrayTag, Object, first + 1, typename Base::places>;
};

/// Where each field begins in the record of one SchwarzPair [bytes].
template <class Real, class Formats>
struct SchwarzPairRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::edge, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::places, std::int32_t>(),
  }});
  static constexpr int edge = plan_.offset[0];
  static constexpr int places = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One SchwarzPair of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class SchwarzPairRef {
  using Record = SchwarzPairRecord<Real, Formats>;

 public:
  using Value = SchwarzPair<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit SchwarzPairRef(const Cursor& cursor) : at_(cursor) {}
  SchwarzPairRef(const SchwarzPairRef&) = default;
  SchwarzPairRef& operator=(const SchwarzPairRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const SchwarzPairRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// its number
  PHYSGEN_FUNCTION decltype(auto) edge() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::edge, std::int32_t>(Record::edge);
  }
  /// that of m + 32 that of n
  PHYSGEN_FUNCTION decltype(auto) places() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::places, std::int32_t>(Record::places);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.edge = edge();
    value.places = places();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    edge() = value.edge;
    places() = value.places;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of SchwarzPair.
struct SchwarzPairObject {
  static constexpr std::string_view name = "quasistatic::SchwarzPair";
  template <class Real>
  using Value = SchwarzPair<Real>;
  template <class Real, class Formats>
  using Record = SchwarzPairRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = SchwarzPairRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::edge, std::int32_t>(
        "edge", "", SchwarzPairRecord<Real, Formats>::edge, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::places, std::int32_t>(
        "places", "", SchwarzPairRecord<Real, Formats>::places, 1, 0.0),
  }};
  template <class Space>
  using Formats = SchwarzPairFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = SchwarzPairProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzPairObject, Space>>
using SchwarzPairView = physgen::View<SchwarzPairObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SchwarzPairObject, Space>>
using SchwarzPairArray = physgen::Array<SchwarzPairObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<SchwarzPairObject, float, SchwarzPairFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<SchwarzPairObject, double, SchwarzPairFormats<physgen::Host>>(8, 4, {0, 4}));

// ---- SchwarzFactor --------------------------------------------------------------------------------------------------

/// A part of W, W^T W being the inverse of a block's -K: 3x3 blocks of the lower triangle, diagonal after diagonal.
/// Those i + d below, i and, of a distance of 32 - d, i below, i + d - 32 share the 32 objects of d.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct SchwarzFactor {
  /// of block b in objects 544 b + 32 d + i, d = 0 .. 16
  Eigen::Matrix<Real, 3, 3> W;
};

/// How the fields of one SchwarzFactor are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of SchwarzFactorArray.
template <class Space>
struct SchwarzFactorFormats {
  using W = physgen::format::Native;
};

struct SchwarzFactorObject;
/// SchwarzFactorFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = SchwarzFactorFormats<physgen::Host>, class Object = SchwarzFactorObject,
          int first = 0>
struct SchwarzFactorProbe {
  using array_ = ArrayTag;
  using W = physgen::Probe<ArrayTag, Object, first + 0, typename Base::W>;
};

/// Where each field begins in the record of one SchwarzFactor [bytes].
template <class Real, class Formats>
struct SchwarzFactorRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::W, Real>(),
  }});
  static constexpr int W = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One SchwarzFactor of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class SchwarzFactorRef {
  using Record = SchwarzFactorRecord<Real, Formats>;

 public:
  using Value = SchwarzFactor<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit SchwarzFactorRef(const Cursor& cursor) : at_(cursor) {}
  SchwarzFactorRef(const SchwarzFactorRef&) = default;
  SchwarzFactorRef& operator=(const SchwarzFactorRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const SchwarzFactorRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// of block b in objects 544 b + 32 d + i, d = 0 .. 16
  PHYSGEN_FUNCTION decltype(auto) W() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::W, Real>(Record::W);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.W = W().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { W() = value.W; }

 private:
  Cursor at_;
};

/// What the runtime knows of SchwarzFactor.
struct SchwarzFactorObject {
  static constexpr std::string_view name = "quasistatic::SchwarzFactor";
  template <class Real>
  using Value = SchwarzFactor<Real>;
  template <class Real, class Formats>
  using Record = SchwarzFactorRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = SchwarzFactorRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::W, Real>(
        "W", "", SchwarzFactorRecord<Real, Formats>::W, 1, 0.0),
  }};
  template <class Space>
  using Formats = SchwarzFactorFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = SchwarzFactorProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SchwarzFactorObject, Space>>
using SchwarzFactorView = physgen::View<SchwarzFactorObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<SchwarzFactorObject, Space>>
using SchwarzFactorArray = physgen::Array<SchwarzFactorObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<SchwarzFactorObject, float, SchwarzFactorFormats<physgen::Host>>(36, 4, {0}));
static_assert(physgen::is_sound_record<SchwarzFactorObject, double, SchwarzFactorFormats<physgen::Host>>(72, 8, {0}));

// ---- LinearSolve ----------------------------------------------------------------------------------------------------

/// Conjugate gradients; in double.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct LinearSolve {
  /// r . z of this iteration [N m]
  Real rz;
  /// of the first [N m]
  Real rz_first;
  /// of sqrt(rz / rz_first) [1]
  Real tolerance;
  /// the length of this step, and what the next keeps of its direction [1]
  Real alpha;
  /// the length of this step, and what the next keeps of its direction [1]
  Real beta;
  /// done
  physgen::same_lanes_t<Real, std::int32_t> iterations;
  /// fem::LinearStatus
  physgen::same_lanes_t<Real, std::int32_t> status;
};

/// How the fields of one LinearSolve are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of LinearSolveArray.
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
/// LinearSolveFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
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

/// Where each field begins in the record of one LinearSolve [bytes].
template <class Real, class Formats>
struct LinearSolveRecord {
  static constexpr auto plan_ = physgen::plan_record<7>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::rz, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::rz_first, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::tolerance, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::alpha, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::beta, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::iterations, std::int32_t>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::status, std::int32_t>(),
  }});
  static constexpr int rz = plan_.offset[0];
  static constexpr int rz_first = plan_.offset[1];
  static constexpr int tolerance = plan_.offset[2];
  static constexpr int alpha = plan_.offset[3];
  static constexpr int beta = plan_.offset[4];
  static constexpr int iterations = plan_.offset[5];
  static constexpr int status = plan_.offset[6];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One LinearSolve of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class LinearSolveRef {
  using Record = LinearSolveRecord<Real, Formats>;

 public:
  using Value = LinearSolve<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit LinearSolveRef(const Cursor& cursor) : at_(cursor) {}
  LinearSolveRef(const LinearSolveRef&) = default;
  LinearSolveRef& operator=(const LinearSolveRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const LinearSolveRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// r . z of this iteration [N m]
  PHYSGEN_FUNCTION decltype(auto) rz() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::rz, Real>(Record::rz);
  }
  /// of the first [N m]
  PHYSGEN_FUNCTION decltype(auto) rz_first() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::rz_first, Real>(Record::rz_first);
  }
  /// of sqrt(rz / rz_first) [1]
  PHYSGEN_FUNCTION decltype(auto) tolerance() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::tolerance, Real>(Record::tolerance);
  }
  /// the length of this step, and what the next keeps of its direction [1]
  PHYSGEN_FUNCTION decltype(auto) alpha() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::alpha, Real>(Record::alpha);
  }
  /// the length of this step, and what the next keeps of its direction [1]
  PHYSGEN_FUNCTION decltype(auto) beta() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::beta, Real>(Record::beta);
  }
  /// done
  PHYSGEN_FUNCTION decltype(auto) iterations() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::iterations, std::int32_t>(Record::iterations);
  }
  /// fem::LinearStatus
  PHYSGEN_FUNCTION decltype(auto) status() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::status, std::int32_t>(Record::status);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.rz = rz();
    value.rz_first = rz_first();
    value.tolerance = tolerance();
    value.alpha = alpha();
    value.beta = beta();
    value.iterations = iterations();
    value.status = status();
    return value;
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

 private:
  Cursor at_;
};

/// What the runtime knows of LinearSolve.
struct LinearSolveObject {
  static constexpr std::string_view name = "quasistatic::LinearSolve";
  template <class Real>
  using Value = LinearSolve<Real>;
  template <class Real, class Formats>
  using Record = LinearSolveRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = LinearSolveRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 7> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::rz, Real>(
        "rz", "N m", LinearSolveRecord<Real, Formats>::rz, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::rz_first, Real>(
        "rz_first", "N m", LinearSolveRecord<Real, Formats>::rz_first, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::tolerance, Real>(
        "tolerance", "1", LinearSolveRecord<Real, Formats>::tolerance, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::alpha, Real>(
        "alpha", "1", LinearSolveRecord<Real, Formats>::alpha, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::beta, Real>(
        "beta", "1", LinearSolveRecord<Real, Formats>::beta, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::iterations, std::int32_t>(
        "iterations", "", LinearSolveRecord<Real, Formats>::iterations, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::status, std::int32_t>(
        "status", "", LinearSolveRecord<Real, Formats>::status, 1, 0.0),
  }};
  template <class Space>
  using Formats = LinearSolveFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = LinearSolveProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<LinearSolveObject, Space>>
using LinearSolveView = physgen::View<LinearSolveObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<LinearSolveObject, Space>>
using LinearSolveArray = physgen::Array<LinearSolveObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<LinearSolveObject, float, LinearSolveFormats<physgen::Host>>(
    28, 4, {0, 4, 8, 12, 16, 20, 24}));
static_assert(physgen::is_sound_record<LinearSolveObject, double, LinearSolveFormats<physgen::Host>>(
    48, 8, {0, 8, 16, 24, 32, 40, 44}));

// ---- PackedIncidence ------------------------------------------------------------------------------------------------

/// An element that touches a node or an edge, and where in it, in one number.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PackedIncidence {
  /// element 2^bits + local: each list has bits of its own (fem::PackedEntry)
  physgen::same_lanes_t<Real, std::int32_t> code;
};

/// How the fields of one PackedIncidence are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of PackedIncidenceArray.
template <class Space>
struct PackedIncidenceFormats {
  using code = physgen::format::Native;
};

struct PackedIncidenceObject;
/// PackedIncidenceFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PackedIncidenceFormats<physgen::Host>, class Object = PackedIncidenceObject,
          int first = 0>
struct PackedIncidenceProbe {
  using array_ = ArrayTag;
  using code = physgen::Probe<ArrayTag, Object, first + 0, typename Base::code>;
};

/// Where each field begins in the record of one PackedIncidence [bytes].
template <class Real, class Formats>
struct PackedIncidenceRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::code, std::int32_t>(),
  }});
  static constexpr int code = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PackedIncidence of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PackedIncidenceRef {
  using Record = PackedIncidenceRecord<Real, Formats>;

 public:
  using Value = PackedIncidence<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PackedIncidenceRef(const Cursor& cursor) : at_(cursor) {}
  PackedIncidenceRef(const PackedIncidenceRef&) = default;
  PackedIncidenceRef& operator=(const PackedIncidenceRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PackedIncidenceRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// element 2^bits + local: each list has bits of its own (fem::PackedEntry)
  PHYSGEN_FUNCTION decltype(auto) code() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::code, std::int32_t>(Record::code);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.code = code();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { code() = value.code; }

 private:
  Cursor at_;
};

/// What the runtime knows of PackedIncidence.
struct PackedIncidenceObject {
  static constexpr std::string_view name = "quasistatic::PackedIncidence";
  template <class Real>
  using Value = PackedIncidence<Real>;
  template <class Real, class Formats>
  using Record = PackedIncidenceRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PackedIncidenceRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::code, std::int32_t>(
        "code", "", PackedIncidenceRecord<Real, Formats>::code, 1, 0.0),
  }};
  template <class Space>
  using Formats = PackedIncidenceFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PackedIncidenceProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PackedIncidenceObject, Space>>
using PackedIncidenceView = physgen::View<PackedIncidenceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<PackedIncidenceObject, Space>>
using PackedIncidenceArray = physgen::Array<PackedIncidenceObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PackedIncidenceObject, float, PackedIncidenceFormats<physgen::Host>>(4, 4, {0}));
static_assert(physgen::is_sound_record<PackedIncidenceObject, double, PackedIncidenceFormats<physgen::Host>>(
    4, 4, {0}));

// ---- Smoother -------------------------------------------------------------------------------------------------------

/// How a level is smoothed.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Smoother {
  /// an estimate of the largest eigenvalue of -D K [1]
  Real largest;
  /// of the vector that power iterations began with [1]
  Real length;
};

/// How the fields of one Smoother are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of SmootherArray.
template <class Space>
struct SmootherFormats {
  using largest = physgen::format::Native;
  using length = physgen::format::Native;
};

struct SmootherObject;
/// SmootherFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = SmootherFormats<physgen::Host>, class Object = SmootherObject, int first = 0>
struct SmootherProbe {
  using array_ = ArrayTag;
  using largest = physgen::Probe<ArrayTag, Object, first + 0, typename Base::largest>;
  using length = physgen::Probe<ArrayTag, Object, first + 1, typename Base::length>;
};

/// Where each field begins in the record of one Smoother [bytes].
template <class Real, class Formats>
struct SmootherRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::largest, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::length, Real>(),
  }});
  static constexpr int largest = plan_.offset[0];
  static constexpr int length = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Smoother of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class SmootherRef {
  using Record = SmootherRecord<Real, Formats>;

 public:
  using Value = Smoother<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit SmootherRef(const Cursor& cursor) : at_(cursor) {}
  SmootherRef(const SmootherRef&) = default;
  SmootherRef& operator=(const SmootherRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const SmootherRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// an estimate of the largest eigenvalue of -D K [1]
  PHYSGEN_FUNCTION decltype(auto) largest() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::largest, Real>(Record::largest);
  }
  /// of the vector that power iterations began with [1]
  PHYSGEN_FUNCTION decltype(auto) length() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::length, Real>(Record::length);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.largest = largest();
    value.length = length();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    largest() = value.largest;
    length() = value.length;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Smoother.
struct SmootherObject {
  static constexpr std::string_view name = "quasistatic::Smoother";
  template <class Real>
  using Value = Smoother<Real>;
  template <class Real, class Formats>
  using Record = SmootherRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = SmootherRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::largest, Real>(
        "largest", "1", SmootherRecord<Real, Formats>::largest, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::length, Real>(
        "length", "1", SmootherRecord<Real, Formats>::length, 1, 0.0),
  }};
  template <class Space>
  using Formats = SmootherFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = SmootherProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<SmootherObject, Space>>
using SmootherView = physgen::View<SmootherObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<SmootherObject, Space>>
using SmootherArray = physgen::Array<SmootherObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<SmootherObject, float, SmootherFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<SmootherObject, double, SmootherFormats<physgen::Host>>(16, 8, {0, 8}));

// ---- Equilibrium ----------------------------------------------------------------------------------------------------

/// Energy and residual of a state; in double.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Equilibrium {
  /// energy of the tets [J]
  Real elastic;
  /// energy of the mean volumes [J]
  Real volumetric;
  /// potential of the external forces and of rigid planes [J]
  Real loads;
  /// squared length of the forces in free components [N^2]
  Real free_square;
  /// squared length of reactions: of prescribed components and of planes [N^2]
  Real fixed_square;
  /// of the forces along a step [J]
  Real work;
  /// the smallest J [1]
  Real smallest_ratio;
};

/// How the fields of one Equilibrium are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of EquilibriumArray.
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
/// EquilibriumFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
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

/// Where each field begins in the record of one Equilibrium [bytes].
template <class Real, class Formats>
struct EquilibriumRecord {
  static constexpr auto plan_ = physgen::plan_record<7>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::elastic, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::volumetric, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::loads, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::free_square, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::fixed_square, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::work, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::smallest_ratio, Real>(),
  }});
  static constexpr int elastic = plan_.offset[0];
  static constexpr int volumetric = plan_.offset[1];
  static constexpr int loads = plan_.offset[2];
  static constexpr int free_square = plan_.offset[3];
  static constexpr int fixed_square = plan_.offset[4];
  static constexpr int work = plan_.offset[5];
  static constexpr int smallest_ratio = plan_.offset[6];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Equilibrium of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class EquilibriumRef {
  using Record = EquilibriumRecord<Real, Formats>;

 public:
  using Value = Equilibrium<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit EquilibriumRef(const Cursor& cursor) : at_(cursor) {}
  EquilibriumRef(const EquilibriumRef&) = default;
  EquilibriumRef& operator=(const EquilibriumRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const EquilibriumRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// energy of the tets [J]
  PHYSGEN_FUNCTION decltype(auto) elastic() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::elastic, Real>(Record::elastic);
  }
  /// energy of the mean volumes [J]
  PHYSGEN_FUNCTION decltype(auto) volumetric() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::volumetric, Real>(Record::volumetric);
  }
  /// potential of the external forces and of rigid planes [J]
  PHYSGEN_FUNCTION decltype(auto) loads() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::loads, Real>(Record::loads);
  }
  /// squared length of the forces in free components [N^2]
  PHYSGEN_FUNCTION decltype(auto) free_square() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::free_square, Real>(Record::free_square);
  }
  /// squared length of reactions: of prescribed components and of planes [N^2]
  PHYSGEN_FUNCTION decltype(auto) fixed_square() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::fixed_square, Real>(Record::fixed_square);
  }
  /// of the forces along a step [J]
  PHYSGEN_FUNCTION decltype(auto) work() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::work, Real>(Record::work);
  }
  /// the smallest J [1]
  PHYSGEN_FUNCTION decltype(auto) smallest_ratio() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::smallest_ratio, Real>(Record::smallest_ratio);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.elastic = elastic();
    value.volumetric = volumetric();
    value.loads = loads();
    value.free_square = free_square();
    value.fixed_square = fixed_square();
    value.work = work();
    value.smallest_ratio = smallest_ratio();
    return value;
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

 private:
  Cursor at_;
};

/// What the runtime knows of Equilibrium.
struct EquilibriumObject {
  static constexpr std::string_view name = "quasistatic::Equilibrium";
  template <class Real>
  using Value = Equilibrium<Real>;
  template <class Real, class Formats>
  using Record = EquilibriumRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = EquilibriumRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 7> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::elastic, Real>(
        "elastic", "J", EquilibriumRecord<Real, Formats>::elastic, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::volumetric, Real>(
        "volumetric", "J", EquilibriumRecord<Real, Formats>::volumetric, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::loads, Real>(
        "loads", "J", EquilibriumRecord<Real, Formats>::loads, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::free_square, Real>(
        "free_square", "N^2", EquilibriumRecord<Real, Formats>::free_square, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::fixed_square, Real>(
        "fixed_square", "N^2", EquilibriumRecord<Real, Formats>::fixed_square, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::work, Real>(
        "work", "J", EquilibriumRecord<Real, Formats>::work, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::smallest_ratio, Real>(
        "smallest_ratio", "1", EquilibriumRecord<Real, Formats>::smallest_ratio, 1, 0.0),
  }};
  template <class Space>
  using Formats = EquilibriumFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = EquilibriumProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<EquilibriumObject, Space>>
using EquilibriumView = physgen::View<EquilibriumObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<EquilibriumObject, Space>>
using EquilibriumArray = physgen::Array<EquilibriumObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<EquilibriumObject, float, EquilibriumFormats<physgen::Host>>(
    28, 4, {0, 4, 8, 12, 16, 20, 24}));
static_assert(physgen::is_sound_record<EquilibriumObject, double, EquilibriumFormats<physgen::Host>>(
    56, 8, {0, 8, 16, 24, 32, 40, 48}));

}  // namespace quasistatic

#endif  // PHYSGEN_QUASISTATIC_H_6E3E071CF1659351
