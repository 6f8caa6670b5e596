// Accessor classes of the object types in dynamics.h. Written by physgen: change the schema, not this file.
#ifndef PHYSGEN_DYNAMICS_H_121B0A31F612B5CB
#define PHYSGEN_DYNAMICS_H_121B0A31F612B5CB

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 4
#error "dynamics.physgen.h is for version 4 of the physgen runtime: generate it again with the installed physgen"
#endif

namespace dynamics {

// ---- NodeMass -------------------------------------------------------------------------------------------------------

/// Lumped mass of a node: a quarter of the mass of each of its tets.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeMass {
  /// 0 of a node that is in no tet [kg]
  Real mass;
};

/// How the fields of one NodeMass are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of NodeMassArray.
template <class Space>
struct NodeMassFormats {
  using mass = physgen::format::Native;
};

struct NodeMassObject;
/// NodeMassFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeMassFormats<physgen::Host>, class Object = NodeMassObject, int first = 0>
struct NodeMassProbe {
  using array_ = ArrayTag;
  using mass = physgen::Probe<ArrayTag, Object, first + 0, typename Base::mass>;
};

/// Where each field begins in the record of one NodeMass [bytes].
template <class Real, class Formats>
struct NodeMassRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::mass, Real>(),
  }});
  static constexpr int mass = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeMass of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeMassRef {
  using Record = NodeMassRecord<Real, Formats>;

 public:
  using Value = NodeMass<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeMassRef(const Cursor& cursor) : at_(cursor) {}
  NodeMassRef(const NodeMassRef&) = default;
  NodeMassRef& operator=(const NodeMassRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeMassRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// 0 of a node that is in no tet [kg]
  PHYSGEN_FUNCTION decltype(auto) mass() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::mass, Real>(Record::mass);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.mass = mass();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { mass() = value.mass; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeMass.
struct NodeMassObject {
  static constexpr std::string_view name = "dynamics::NodeMass";
  template <class Real>
  using Value = NodeMass<Real>;
  template <class Real, class Formats>
  using Record = NodeMassRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeMassRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::mass, Real>(
        "mass", "kg", NodeMassRecord<Real, Formats>::mass, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeMassFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeMassProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeMassObject, Space>>
using NodeMassView = physgen::View<NodeMassObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeMassObject, Space>>
using NodeMassArray = physgen::Array<NodeMassObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeMassObject, float, NodeMassFormats<physgen::Host>>(4, 4, {0}));
static_assert(physgen::is_sound_record<NodeMassObject, double, NodeMassFormats<physgen::Host>>(8, 8, {0}));

// ---- NodeVelocity ---------------------------------------------------------------------------------------------------

/// Velocity of a node.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeVelocity {
  /// velocity [m/s]
  Eigen::Matrix<Real, 3, 1> v;
};

/// How the fields of one NodeVelocity are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of NodeVelocityArray.
template <class Space>
struct NodeVelocityFormats {
  using v = physgen::format::Native;
};

struct NodeVelocityObject;
/// NodeVelocityFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeVelocityFormats<physgen::Host>, class Object = NodeVelocityObject,
          int first = 0>
struct NodeVelocityProbe {
  using array_ = ArrayTag;
  using v = physgen::Probe<ArrayTag, Object, first + 0, typename Base::v>;
};

/// Where each field begins in the record of one NodeVelocity [bytes].
template <class Real, class Formats>
struct NodeVelocityRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Vector<3>, typename Formats::v, Real>(),
  }});
  static constexpr int v = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeVelocity of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeVelocityRef {
  using Record = NodeVelocityRecord<Real, Formats>;

 public:
  using Value = NodeVelocity<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeVelocityRef(const Cursor& cursor) : at_(cursor) {}
  NodeVelocityRef(const NodeVelocityRef&) = default;
  NodeVelocityRef& operator=(const NodeVelocityRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeVelocityRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// velocity [m/s]
  PHYSGEN_FUNCTION decltype(auto) v() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::v, Real>(Record::v);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.v = v().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { v() = value.v; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeVelocity.
struct NodeVelocityObject {
  static constexpr std::string_view name = "dynamics::NodeVelocity";
  template <class Real>
  using Value = NodeVelocity<Real>;
  template <class Real, class Formats>
  using Record = NodeVelocityRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeVelocityRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::v, Real>(
        "v", "m/s", NodeVelocityRecord<Real, Formats>::v, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeVelocityFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeVelocityProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeVelocityObject, Space>>
using NodeVelocityView = physgen::View<NodeVelocityObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodeVelocityObject, Space>>
using NodeVelocityArray = physgen::Array<NodeVelocityObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeVelocityObject, float, NodeVelocityFormats<physgen::Host>>(12, 4, {0}));
static_assert(physgen::is_sound_record<NodeVelocityObject, double, NodeVelocityFormats<physgen::Host>>(24, 8, {0}));

// ---- Motion ---------------------------------------------------------------------------------------------------------

/// What the nodes' velocities amount to; one object, which kernels leave for the host.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Motion {
  /// kinetic energy [J]
  Real kinetic;
  /// linear momentum [kg m/s]
  Eigen::Matrix<Real, 3, 1> momentum;
  /// elastic energy of the tets [J]
  Real elastic;
  /// the largest coordinate of a position [m]
  Real farthest;
};

/// How the fields of one Motion are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of MotionArray.
template <class Space>
struct MotionFormats {
  using kinetic = physgen::format::Native;
  using momentum = physgen::format::Native;
  using elastic = physgen::format::Native;
  using farthest = physgen::format::Native;
};

struct MotionObject;
/// MotionFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = MotionFormats<physgen::Host>, class Object = MotionObject, int first = 0>
struct MotionProbe {
  using array_ = ArrayTag;
  using kinetic = physgen::Probe<ArrayTag, Object, first + 0, typename Base::kinetic>;
  using momentum = physgen::Probe<ArrayTag, Object, first + 1, typename Base::momentum>;
  using elastic = physgen::Probe<ArrayTag, Object, first + 2, typename Base::elastic>;
  using farthest = physgen::Probe<ArrayTag, Object, first + 3, typename Base::farthest>;
};

/// Where each field begins in the record of one Motion [bytes].
template <class Real, class Formats>
struct MotionRecord {
  static constexpr auto plan_ = physgen::plan_record<4>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::kinetic, Real>(),
    physgen::slot<physgen::shape::Vector<3>, typename Formats::momentum, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::elastic, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::farthest, Real>(),
  }});
  static constexpr int kinetic = plan_.offset[0];
  static constexpr int momentum = plan_.offset[1];
  static constexpr int elastic = plan_.offset[2];
  static constexpr int farthest = plan_.offset[3];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Motion of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class MotionRef {
  using Record = MotionRecord<Real, Formats>;

 public:
  using Value = Motion<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit MotionRef(const Cursor& cursor) : at_(cursor) {}
  MotionRef(const MotionRef&) = default;
  MotionRef& operator=(const MotionRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const MotionRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// kinetic energy [J]
  PHYSGEN_FUNCTION decltype(auto) kinetic() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::kinetic, Real>(Record::kinetic);
  }
  /// linear momentum [kg m/s]
  PHYSGEN_FUNCTION decltype(auto) momentum() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::momentum, Real>(Record::momentum);
  }
  /// elastic energy of the tets [J]
  PHYSGEN_FUNCTION decltype(auto) elastic() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::elastic, Real>(Record::elastic);
  }
  /// the largest coordinate of a position [m]
  PHYSGEN_FUNCTION decltype(auto) farthest() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::farthest, Real>(Record::farthest);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.kinetic = kinetic();
    value.momentum = momentum().get();
    value.elastic = elastic();
    value.farthest = farthest();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    kinetic() = value.kinetic;
    momentum() = value.momentum;
    elastic() = value.elastic;
    farthest() = value.farthest;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Motion.
struct MotionObject {
  static constexpr std::string_view name = "dynamics::Motion";
  template <class Real>
  using Value = Motion<Real>;
  template <class Real, class Formats>
  using Record = MotionRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = MotionRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 4> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::kinetic, Real>(
        "kinetic", "J", MotionRecord<Real, Formats>::kinetic, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::momentum, Real>(
        "momentum", "kg m/s", MotionRecord<Real, Formats>::momentum, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elastic, Real>(
        "elastic", "J", MotionRecord<Real, Formats>::elastic, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::farthest, Real>(
        "farthest", "m", MotionRecord<Real, Formats>::farthest, 1, 0.0),
  }};
  template <class Space>
  using Formats = MotionFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = MotionProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<MotionObject, Space>>
using MotionView = physgen::View<MotionObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<MotionObject, Space>>
using MotionArray = physgen::Array<MotionObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<MotionObject, float, MotionFormats<physgen::Host>>(24, 4, {0, 4, 16, 20}));
static_assert(physgen::is_sound_record<MotionObject, double, MotionFormats<physgen::Host>>(48, 8, {0, 8, 32, 40}));

}  // namespace dynamics

#endif  // PHYSGEN_DYNAMICS_H_121B0A31F612B5CB
