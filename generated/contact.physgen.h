// Accessor classes of the object types in contact.h. Written by physgen: change the schema, not this file.
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
#ifndef PHYSGEN_CONTACT_H_C445AFD967FC3CEA
#define PHYSGEN_CONTACT_H_C445AFD967FC3CEA

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 7
#error "contact.physgen.h is for version 7 of the physgen runtime: generate it again with the installed physgen"
#endif
#ifdef PHYSGEN_SCHEMA_H
#error "a program includes contact.physgen.h in place of the schema: remove the #include of the schema"
#endif
#define PHYSGEN_GENERATED_HEADER

namespace contact {

// ---- NodeArea -------------------------------------------------------------------------------------------------------

/// The part of the body's surface that a node carries: a third of each boundary face that it is a corner of.
template <class Real>
struct NodeArea {
  /// at rest; 0 inside the body [m^2]
  Real area = {};
};

template <class Space>
struct NodeAreaFormats {
  using area = physgen::format::Native;
};

struct NodeAreaObject;
template <class ArrayTag, class Base = NodeAreaFormats<physgen::Host>, class Object = NodeAreaObject, int first = 0>
struct NodeAreaProbe {
  using array_ = ArrayTag;
  using area = physgen::Probe<ArrayTag, Object, first + 0, typename Base::area>;
};

template <class Real, class Formats>
struct NodeAreaRecord {
  using area = physgen::StoredField<NodeAreaRecord, 0, physgen::shape::Scalar, typename Formats::area, Real>;
  using fields_ = physgen::RecordFields<area>;
};

template <class Real, class Formats, class Cursor>
struct NodeAreaRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NodeAreaRecord<Real, Formats>;
  using Value = NodeArea<typename Cursor::template Lanes<Real>>;

  /// at rest; 0 inside the body [m^2]
  PHYSGEN_FUNCTION decltype(auto) area() const { return this->field_(typename Record::area(), Record::area::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {area()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const { area() = value.area; }
};

struct NodeAreaObject : physgen::ObjectTag<
    NodeAreaObject, NodeArea, NodeAreaFormats, NodeAreaRecord, NodeAreaRef, NodeAreaProbe> {
  static constexpr std::string_view name = "contact::NodeArea";
  static constexpr std::array<physgen::FieldText, 1> texts = {{{"area", "m^2"}}};
  static constexpr std::array<std::string_view, 1> docs = {
    "at rest; 0 inside the body",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeAreaObject, Space>>
using NodeAreaView = physgen::View<NodeAreaObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeAreaObject, Space>>
using NodeAreaArray = physgen::Array<NodeAreaObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NodeAreaObject, physgen::Host>({4, 4, {0}}, {8, 8, {0}}));

// ---- RigidPlane -----------------------------------------------------------------------------------------------------

/// A plane that the body's surface cannot pass without force: the points x with normal . x = offset + load travel.
template <class Real>
struct RigidPlane {
  /// of length 1, towards the body [1]
  physgen::MatrixValue<Real, 3, 1> normal = decltype(normal)::Zero();
  /// normal . x of its points at a load of 0 [m]
  Real offset = {};
  /// along the normal, at a load of 1 [m]
  Real travel = {};
};

template <class Space>
struct RigidPlaneFormats {
  using normal = physgen::format::Native;
  using offset = physgen::format::Native;
  using travel = physgen::format::Native;
};

struct RigidPlaneObject;
template <class ArrayTag, class Base = RigidPlaneFormats<physgen::Host>, class Object = RigidPlaneObject, int first = 0>
struct RigidPlaneProbe {
  using array_ = ArrayTag;
  using normal = physgen::Probe<ArrayTag, Object, first + 0, typename Base::normal>;
  using offset = physgen::Probe<ArrayTag, Object, first + 1, typename Base::offset>;
  using travel = physgen::Probe<ArrayTag, Object, first + 2, typename Base::travel>;
};

template <class Real, class Formats>
struct RigidPlaneRecord {
  using normal = physgen::StoredField<RigidPlaneRecord, 0, physgen::shape::Vector<3>, typename Formats::normal, Real>;
  using offset = physgen::StoredField<RigidPlaneRecord, 1, physgen::shape::Scalar, typename Formats::offset, Real>;
  using travel = physgen::StoredField<RigidPlaneRecord, 2, physgen::shape::Scalar, typename Formats::travel, Real>;
  using fields_ = physgen::RecordFields<normal, offset, travel>;
};

template <class Real, class Formats, class Cursor>
struct RigidPlaneRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = RigidPlaneRecord<Real, Formats>;
  using Value = RigidPlane<typename Cursor::template Lanes<Real>>;

  /// of length 1, towards the body [1]
  PHYSGEN_FUNCTION decltype(auto) normal() const {
    return this->field_(typename Record::normal(), Record::normal::offset);
  }
  /// normal . x of its points at a load of 0 [m]
  PHYSGEN_FUNCTION decltype(auto) offset() const {
    return this->field_(typename Record::offset(), Record::offset::offset);
  }
  /// along the normal, at a load of 1 [m]
  PHYSGEN_FUNCTION decltype(auto) travel() const {
    return this->field_(typename Record::travel(), Record::travel::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {normal().get(), offset(), travel()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    normal() = value.normal;
    offset() = value.offset;
    travel() = value.travel;
  }
};

struct RigidPlaneObject : physgen::ObjectTag<
    RigidPlaneObject, RigidPlane, RigidPlaneFormats, RigidPlaneRecord, RigidPlaneRef, RigidPlaneProbe> {
  static constexpr std::string_view name = "contact::RigidPlane";
  static constexpr std::array<physgen::FieldText, 3> texts = {{{"normal", "1"}, {"offset", "m"}, {"travel", "m"}}};
  static constexpr std::array<std::string_view, 3> docs = {
    "of length 1, towards the body", "normal . x of its points at a load of 0",
    "along the normal, at a load of 1",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<RigidPlaneObject, Space>>
using RigidPlaneView = physgen::View<RigidPlaneObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<RigidPlaneObject, Space>>
using RigidPlaneArray = physgen::Array<RigidPlaneObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<RigidPlaneObject, physgen::Host>({20, 4, {0, 12, 16}}, {40, 8, {0, 24, 32}}));

// ---- PressedFace ----------------------------------------------------------------------------------------------------

/// A face of the surface that is pushed by a pressure, which follows it.
template <class Real>
struct PressedFace {
  /// counter-clockwise, seen from outside
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 3, 1> nodes = decltype(nodes)::Zero();
  /// at a load of 1 [Pa]
  Real pressure = {};
};

template <class Space>
struct PressedFaceFormats {
  using nodes = physgen::format::Native;
  using pressure = physgen::format::Native;
};

struct PressedFaceObject;
template <class ArrayTag, class Base = PressedFaceFormats<physgen::Host>, class Object = PressedFaceObject,
          int first = 0>
struct PressedFaceProbe {
  using array_ = ArrayTag;
  using nodes = physgen::Probe<ArrayTag, Object, first + 0, typename Base::nodes>;
  using pressure = physgen::Probe<ArrayTag, Object, first + 1, typename Base::pressure>;
};

template <class Real, class Formats>
struct PressedFaceRecord {
  using nodes = physgen::StoredField<
      PressedFaceRecord, 0, physgen::shape::Vector<3>, typename Formats::nodes, std::int32_t>;
  using pressure = physgen::StoredField<PressedFaceRecord, 1, physgen::shape::Scalar, typename Formats::pressure, Real>;
  using fields_ = physgen::RecordFields<nodes, pressure>;
};

template <class Real, class Formats, class Cursor>
struct PressedFaceRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PressedFaceRecord<Real, Formats>;
  using Value = PressedFace<typename Cursor::template Lanes<Real>>;

  /// counter-clockwise, seen from outside
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return this->field_(typename Record::nodes(), Record::nodes::offset);
  }
  /// at a load of 1 [Pa]
  PHYSGEN_FUNCTION decltype(auto) pressure() const {
    return this->field_(typename Record::pressure(), Record::pressure::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {nodes().get(), pressure()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    nodes() = value.nodes;
    pressure() = value.pressure;
  }
};

struct PressedFaceObject : physgen::ObjectTag<
    PressedFaceObject, PressedFace, PressedFaceFormats, PressedFaceRecord, PressedFaceRef, PressedFaceProbe> {
  static constexpr std::string_view name = "contact::PressedFace";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"nodes"}, {"pressure", "Pa"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "counter-clockwise, seen from outside", "at a load of 1",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PressedFaceObject, Space>>
using PressedFaceView = physgen::View<PressedFaceObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<PressedFaceObject, Space>>
using PressedFaceArray = physgen::Array<PressedFaceObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PressedFaceObject, physgen::Host>({16, 4, {0, 12}}, {20, 8, {8, 0}}));

// ---- PlaneContact ---------------------------------------------------------------------------------------------------

/// How a plane and the body touch; one object, which kernels leave for the host.
template <class Real>
struct PlaneContact {
  /// on the body along the normal [N]
  Real force = {};
  /// of the node that is farthest behind it among those that it touches [m]
  Real depth = {};
};

template <class Space>
struct PlaneContactFormats {
  using force = physgen::format::Native;
  using depth = physgen::format::Native;
};

struct PlaneContactObject;
template <class ArrayTag, class Base = PlaneContactFormats<physgen::Host>, class Object = PlaneContactObject,
          int first = 0>
struct PlaneContactProbe {
  using array_ = ArrayTag;
  using force = physgen::Probe<ArrayTag, Object, first + 0, typename Base::force>;
  using depth = physgen::Probe<ArrayTag, Object, first + 1, typename Base::depth>;
};

template <class Real, class Formats>
struct PlaneContactRecord {
  using force = physgen::StoredField<PlaneContactRecord, 0, physgen::shape::Scalar, typename Formats::force, Real>;
  using depth = physgen::StoredField<PlaneContactRecord, 1, physgen::shape::Scalar, typename Formats::depth, Real>;
  using fields_ = physgen::RecordFields<force, depth>;
};

template <class Real, class Formats, class Cursor>
struct PlaneContactRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PlaneContactRecord<Real, Formats>;
  using Value = PlaneContact<typename Cursor::template Lanes<Real>>;

  /// on the body along the normal [N]
  PHYSGEN_FUNCTION decltype(auto) force() const {
    return this->field_(typename Record::force(), Record::force::offset);
  }
  /// of the node that is farthest behind it among those that it touches [m]
  PHYSGEN_FUNCTION decltype(auto) depth() const {
    return this->field_(typename Record::depth(), Record::depth::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {force(), depth()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    force() = value.force;
    depth() = value.depth;
  }
};

struct PlaneContactObject : physgen::ObjectTag<
    PlaneContactObject, PlaneContact, PlaneContactFormats, PlaneContactRecord, PlaneContactRef, PlaneContactProbe> {
  static constexpr std::string_view name = "contact::PlaneContact";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"force", "N"}, {"depth", "m"}}};
  static constexpr std::array<std::string_view, 2> docs = {
    "on the body along the normal", "of the node that is farthest behind it among those that it touches",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PlaneContactObject, Space>>
using PlaneContactView = physgen::View<PlaneContactObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<PlaneContactObject, Space>>
using PlaneContactArray = physgen::Array<PlaneContactObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PlaneContactObject, physgen::Host>({8, 4, {0, 4}}, {16, 8, {0, 8}}));

}  // namespace contact

#endif  // PHYSGEN_CONTACT_H_C445AFD967FC3CEA
