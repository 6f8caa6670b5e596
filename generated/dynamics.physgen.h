// Accessor classes of the object types in dynamics.h. Written by physgen: change the schema, not this file.
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
#ifndef PHYSGEN_DYNAMICS_H_DCE1BCF21FB30CFE
#define PHYSGEN_DYNAMICS_H_DCE1BCF21FB30CFE

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 7
#error "dynamics.physgen.h is for version 7 of the physgen runtime: generate it again with the installed physgen"
#endif
#ifdef PHYSGEN_SCHEMA_H
#error "a program includes dynamics.physgen.h in place of the schema: remove the #include of the schema"
#endif
#define PHYSGEN_GENERATED_HEADER

namespace dynamics {

// ---- NodeMass -------------------------------------------------------------------------------------------------------

/// Lumped mass of a node: a quarter of the mass of each of its tets.
template <class Real>
struct NodeMass {
  /// 0 of a node that is in no tet [kg]
  Real mass = {};
};

template <class Space>
struct NodeMassFormats {
  using mass = physgen::format::Native;
};

struct NodeMassObject;
template <class ArrayTag, class Base = NodeMassFormats<physgen::Host>, class Object = NodeMassObject, int first = 0>
struct NodeMassProbe {
  using array_ = ArrayTag;
  using mass = physgen::Probe<ArrayTag, Object, first + 0, typename Base::mass>;
};

template <class Real, class Formats>
struct NodeMassRecord {
  using mass = physgen::StoredField<NodeMassRecord, 0, physgen::shape::Scalar, typename Formats::mass, Real>;
  using fields_ = physgen::RecordFields<mass>;
};

template <class Real, class Formats, class Cursor>
struct NodeMassRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeMassRecord<Real, Formats>;
  using Value = NodeMass<typename Cursor::template Lanes<Real>>;

  /// 0 of a node that is in no tet [kg]
  PHYSGEN_FUNCTION decltype(auto) mass() const { return this->field_(typename Record::mass(), Record::mass::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {mass()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { mass() = value.mass; }
};

struct NodeMassObject : physgen::ObjectTag<
    NodeMassObject, NodeMass, NodeMassFormats, NodeMassRecord, NodeMassRef, NodeMassProbe> {
  static constexpr std::string_view name = "dynamics::NodeMass";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"mass", "kg"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "0 of a node that is in no tet",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeMassObject, Space>>
using NodeMassView = physgen::View<NodeMassObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeMassObject, Space>>
using NodeMassArray = physgen::Array<NodeMassObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeMassObject, physgen::Host>({4, 4, {0}}, {8, 8, {0}}));

// ---- NodeVelocity ---------------------------------------------------------------------------------------------------

/// Velocity of a node.
template <class Real>
struct NodeVelocity {
  /// velocity [m/s]
  physgen::MatrixValue<Real, 3, 1> v = decltype(v)::Zero();
};

template <class Space>
struct NodeVelocityFormats {
  using v = physgen::format::Native;
};

struct NodeVelocityObject;
template <class ArrayTag, class Base = NodeVelocityFormats<physgen::Host>, class Object = NodeVelocityObject,
          int first = 0>
struct NodeVelocityProbe {
  using array_ = ArrayTag;
  using v = physgen::Probe<ArrayTag, Object, first + 0, typename Base::v>;
};

template <class Real, class Formats>
struct NodeVelocityRecord {
  using v = physgen::StoredField<NodeVelocityRecord, 0, physgen::shape::Vector<3>, typename Formats::v, Real>;
  using fields_ = physgen::RecordFields<v>;
};

template <class Real, class Formats, class Cursor>
struct NodeVelocityRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeVelocityRecord<Real, Formats>;
  using Value = NodeVelocity<typename Cursor::template Lanes<Real>>;

  /// velocity [m/s]
  PHYSGEN_FUNCTION decltype(auto) v() const { return this->field_(typename Record::v(), Record::v::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {v().get()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { v() = value.v; }
};

struct NodeVelocityObject : physgen::ObjectTag<
    NodeVelocityObject, NodeVelocity, NodeVelocityFormats, NodeVelocityRecord, NodeVelocityRef, NodeVelocityProbe> {
  static constexpr std::string_view name = "dynamics::NodeVelocity";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"v", "m/s"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "velocity",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeVelocityObject, Space>>
using NodeVelocityView = physgen::View<NodeVelocityObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::AosPadded, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<NodeVelocityObject, Space>>
using NodeVelocityArray = physgen::Array<NodeVelocityObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeVelocityObject, physgen::Host>({12, 4, {0}}, {24, 8, {0}}));

// ---- Motion ---------------------------------------------------------------------------------------------------------

/// The sums of the nodes' velocities; one object, which kernels leave for the host.
template <class Real>
struct Motion {
  /// kinetic energy [J]
  Real kinetic = {};
  /// linear momentum [kg m/s]
  physgen::MatrixValue<Real, 3, 1> momentum = decltype(momentum)::Zero();
  /// elastic energy of the tets [J]
  Real elastic = {};
  /// the largest coordinate of a position [m]
  Real farthest = {};
};

template <class Space>
struct MotionFormats {
  using kinetic = physgen::format::Native;
  using momentum = physgen::format::Native;
  using elastic = physgen::format::Native;
  using farthest = physgen::format::Native;
};

struct MotionObject;
template <class ArrayTag, class Base = MotionFormats<physgen::Host>, class Object = MotionObject, int first = 0>
struct MotionProbe {
  using array_ = ArrayTag;
  using kinetic = physgen::Probe<ArrayTag, Object, first + 0, typename Base::kinetic>;
  using momentum = physgen::Probe<ArrayTag, Object, first + 1, typename Base::momentum>;
  using elastic = physgen::Probe<ArrayTag, Object, first + 2, typename Base::elastic>;
  using farthest = physgen::Probe<ArrayTag, Object, first + 3, typename Base::farthest>;
};

template <class Real, class Formats>
struct MotionRecord {
  using kinetic = physgen::StoredField<MotionRecord, 0, physgen::shape::Scalar, typename Formats::kinetic, Real>;
  using momentum = physgen::StoredField<MotionRecord, 1, physgen::shape::Vector<3>, typename Formats::momentum, Real>;
  using elastic = physgen::StoredField<MotionRecord, 2, physgen::shape::Scalar, typename Formats::elastic, Real>;
  using farthest = physgen::StoredField<MotionRecord, 3, physgen::shape::Scalar, typename Formats::farthest, Real>;
  using fields_ = physgen::RecordFields<kinetic, momentum, elastic, farthest>;
};

template <class Real, class Formats, class Cursor>
struct MotionRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = MotionRecord<Real, Formats>;
  using Value = Motion<typename Cursor::template Lanes<Real>>;

  /// kinetic energy [J]
  PHYSGEN_FUNCTION decltype(auto) kinetic() const {
    return this->field_(typename Record::kinetic(), Record::kinetic::offset);
  }
  /// linear momentum [kg m/s]
  PHYSGEN_FUNCTION decltype(auto) momentum() const {
    return this->field_(typename Record::momentum(), Record::momentum::offset);
  }
  /// elastic energy of the tets [J]
  PHYSGEN_FUNCTION decltype(auto) elastic() const {
    return this->field_(typename Record::elastic(), Record::elastic::offset);
  }
  /// the largest coordinate of a position [m]
  PHYSGEN_FUNCTION decltype(auto) farthest() const {
    return this->field_(typename Record::farthest(), Record::farthest::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {kinetic(), momentum().get(), elastic(), farthest()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    kinetic() = value.kinetic;
    momentum() = value.momentum;
    elastic() = value.elastic;
    farthest() = value.farthest;
  }
};

struct MotionObject : physgen::ObjectTag<MotionObject, Motion, MotionFormats, MotionRecord, MotionRef, MotionProbe> {
  static constexpr std::string_view name = "dynamics::Motion";
  static constexpr std::array<physgen::FieldText, 4> texts = {{
      {"kinetic", "J"}, {"momentum", "kg m/s"}, {"elastic", "J"}, {"farthest", "m"}}};
  static constexpr std::array<std::string_view, 4> docs = {
    "kinetic energy", "linear momentum", "elastic energy of the tets", "the largest coordinate of a position",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<MotionObject, Space>>
using MotionView = physgen::View<MotionObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<MotionObject, Space>>
using MotionArray = physgen::Array<MotionObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<MotionObject, physgen::Host>(
    {24, 4, {0, 4, 16, 20}}, {48, 8, {0, 8, 32, 40}}));

}  // namespace dynamics

#endif  // PHYSGEN_DYNAMICS_H_DCE1BCF21FB30CFE
