// Accessor classes of the object types in contact.h. Written by physgen: change the schema, not this file.
#ifndef PHYSGEN_CONTACT_H_AAFCF77993B4B926
#define PHYSGEN_CONTACT_H_AAFCF77993B4B926

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 4
#error "contact.physgen.h is for version 4 of the physgen runtime: generate it again with the installed physgen"
#endif

namespace contact {

// ---- NodeArea -------------------------------------------------------------------------------------------------------

/// What a node carries of the surface of the body: a third of each boundary face that it is a corner of.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct NodeArea {
  /// at rest; 0 inside the body [m^2]
  Real area;
};

/// How the fields of one NodeArea are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of NodeAreaArray.
template <class Space>
struct NodeAreaFormats {
  using area = physgen::format::Native;
};

struct NodeAreaObject;
/// NodeAreaFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NodeAreaFormats<physgen::Host>, class Object = NodeAreaObject, int first = 0>
struct NodeAreaProbe {
  using array_ = ArrayTag;
  using area = physgen::Probe<ArrayTag, Object, first + 0, typename Base::area>;
};

/// Where each field begins in the record of one NodeArea [bytes].
template <class Real, class Formats>
struct NodeAreaRecord {
  static constexpr auto plan_ = physgen::plan_record<1>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::area, Real>(),
  }});
  static constexpr int area = plan_.offset[0];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One NodeArea of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NodeAreaRef {
  using Record = NodeAreaRecord<Real, Formats>;

 public:
  using Value = NodeArea<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NodeAreaRef(const Cursor& cursor) : at_(cursor) {}
  NodeAreaRef(const NodeAreaRef&) = default;
  NodeAreaRef& operator=(const NodeAreaRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NodeAreaRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// at rest; 0 inside the body [m^2]
  PHYSGEN_FUNCTION decltype(auto) area() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::area, Real>(Record::area);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.area = area();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const { area() = value.area; }

 private:
  Cursor at_;
};

/// What the runtime knows of NodeArea.
struct NodeAreaObject {
  static constexpr std::string_view name = "contact::NodeArea";
  template <class Real>
  using Value = NodeArea<Real>;
  template <class Real, class Formats>
  using Record = NodeAreaRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NodeAreaRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 1> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::area, Real>(
        "area", "m^2", NodeAreaRecord<Real, Formats>::area, 1, 0.0),
  }};
  template <class Space>
  using Formats = NodeAreaFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NodeAreaProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<NodeAreaObject, Space>>
using NodeAreaView = physgen::View<NodeAreaObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<NodeAreaObject, Space>>
using NodeAreaArray = physgen::Array<NodeAreaObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NodeAreaObject, float, NodeAreaFormats<physgen::Host>>(4, 4, {0}));
static_assert(physgen::is_sound_record<NodeAreaObject, double, NodeAreaFormats<physgen::Host>>(8, 8, {0}));

// ---- RigidPlane -----------------------------------------------------------------------------------------------------

/// A plane that the body's surface cannot pass without force: the points x with normal . x = offset + load travel.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct RigidPlane {
  /// of length 1, towards the body [1]
  Eigen::Matrix<Real, 3, 1> normal;
  /// normal . x of its points at a load of 0 [m]
  Real offset;
  /// along the normal, at a load of 1 [m]
  Real travel;
};

/// How the fields of one RigidPlane are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of RigidPlaneArray.
template <class Space>
struct RigidPlaneFormats {
  using normal = physgen::format::Native;
  using offset = physgen::format::Native;
  using travel = physgen::format::Native;
};

struct RigidPlaneObject;
/// RigidPlaneFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = RigidPlaneFormats<physgen::Host>, class Object = RigidPlaneObject, int first = 0>
struct RigidPlaneProbe {
  using array_ = ArrayTag;
  using normal = physgen::Probe<ArrayTag, Object, first + 0, typename Base::normal>;
  using offset = physgen::Probe<ArrayTag, Object, first + 1, typename Base::offset>;
  using travel = physgen::Probe<ArrayTag, Object, first + 2, typename Base::travel>;
};

/// Where each field begins in the record of one RigidPlane [bytes].
template <class Real, class Formats>
struct RigidPlaneRecord {
  static constexpr auto plan_ = physgen::plan_record<3>({{
    physgen::slot<physgen::shape::Vector<3>, typename Formats::normal, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::offset, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::travel, Real>(),
  }});
  static constexpr int normal = plan_.offset[0];
  static constexpr int offset = plan_.offset[1];
  static constexpr int travel = plan_.offset[2];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One RigidPlane of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class RigidPlaneRef {
  using Record = RigidPlaneRecord<Real, Formats>;

 public:
  using Value = RigidPlane<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit RigidPlaneRef(const Cursor& cursor) : at_(cursor) {}
  RigidPlaneRef(const RigidPlaneRef&) = default;
  RigidPlaneRef& operator=(const RigidPlaneRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const RigidPlaneRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// of length 1, towards the body [1]
  PHYSGEN_FUNCTION decltype(auto) normal() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::normal, Real>(Record::normal);
  }
  /// normal . x of its points at a load of 0 [m]
  PHYSGEN_FUNCTION decltype(auto) offset() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::offset, Real>(Record::offset);
  }
  /// along the normal, at a load of 1 [m]
  PHYSGEN_FUNCTION decltype(auto) travel() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::travel, Real>(Record::travel);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.normal = normal().get();
    value.offset = offset();
    value.travel = travel();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    normal() = value.normal;
    offset() = value.offset;
    travel() = value.travel;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of RigidPlane.
struct RigidPlaneObject {
  static constexpr std::string_view name = "contact::RigidPlane";
  template <class Real>
  using Value = RigidPlane<Real>;
  template <class Real, class Formats>
  using Record = RigidPlaneRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = RigidPlaneRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 3> fields = {{
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::normal, Real>(
        "normal", "1", RigidPlaneRecord<Real, Formats>::normal, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::offset, Real>(
        "offset", "m", RigidPlaneRecord<Real, Formats>::offset, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::travel, Real>(
        "travel", "m", RigidPlaneRecord<Real, Formats>::travel, 1, 0.0),
  }};
  template <class Space>
  using Formats = RigidPlaneFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = RigidPlaneProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<RigidPlaneObject, Space>>
using RigidPlaneView = physgen::View<RigidPlaneObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<RigidPlaneObject, Space>>
using RigidPlaneArray = physgen::Array<RigidPlaneObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<RigidPlaneObject, float, RigidPlaneFormats<physgen::Host>>(20, 4, {0, 12, 16}));
static_assert(physgen::is_sound_record<RigidPlaneObject, double, RigidPlaneFormats<physgen::Host>>(40, 8, {0, 24, 32}));

// ---- PlaneContact ---------------------------------------------------------------------------------------------------

/// How a plane and the body touch; one object, which kernels leave for the host.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct PlaneContact {
  /// on the body along the normal [N]
  Real force;
  /// of the node that is farthest behind it among those that it touches [m]
  Real depth;
};

/// How the fields of one PlaneContact are stored in a memory space. To store some otherwise, derive from it, declare
/// those anew, and name the derived struct as the last argument of PlaneContactArray.
template <class Space>
struct PlaneContactFormats {
  using force = physgen::format::Native;
  using depth = physgen::format::Native;
};

struct PlaneContactObject;
/// PlaneContactFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PlaneContactFormats<physgen::Host>, class Object = PlaneContactObject,
          int first = 0>
struct PlaneContactProbe {
  using array_ = ArrayTag;
  using force = physgen::Probe<ArrayTag, Object, first + 0, typename Base::force>;
  using depth = physgen::Probe<ArrayTag, Object, first + 1, typename Base::depth>;
};

/// Where each field begins in the record of one PlaneContact [bytes].
template <class Real, class Formats>
struct PlaneContactRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::force, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::depth, Real>(),
  }});
  static constexpr int force = plan_.offset[0];
  static constexpr int depth = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One PlaneContact of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PlaneContactRef {
  using Record = PlaneContactRecord<Real, Formats>;

 public:
  using Value = PlaneContact<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PlaneContactRef(const Cursor& cursor) : at_(cursor) {}
  PlaneContactRef(const PlaneContactRef&) = default;
  PlaneContactRef& operator=(const PlaneContactRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PlaneContactRef&& other) const& {
    return physgen::assign(*this, other);
  }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// on the body along the normal [N]
  PHYSGEN_FUNCTION decltype(auto) force() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::force, Real>(Record::force);
  }
  /// of the node that is farthest behind it among those that it touches [m]
  PHYSGEN_FUNCTION decltype(auto) depth() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::depth, Real>(Record::depth);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.force = force();
    value.depth = depth();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    force() = value.force;
    depth() = value.depth;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of PlaneContact.
struct PlaneContactObject {
  static constexpr std::string_view name = "contact::PlaneContact";
  template <class Real>
  using Value = PlaneContact<Real>;
  template <class Real, class Formats>
  using Record = PlaneContactRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PlaneContactRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::force, Real>(
        "force", "N", PlaneContactRecord<Real, Formats>::force, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::depth, Real>(
        "depth", "m", PlaneContactRecord<Real, Formats>::depth, 1, 0.0),
  }};
  template <class Space>
  using Formats = PlaneContactFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PlaneContactProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<PlaneContactObject, Space>>
using PlaneContactView = physgen::View<PlaneContactObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host, class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aos>,
          class Formats = physgen::FormatsOf<PlaneContactObject, Space>>
using PlaneContactArray = physgen::Array<PlaneContactObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PlaneContactObject, float, PlaneContactFormats<physgen::Host>>(8, 4, {0, 4}));
static_assert(physgen::is_sound_record<PlaneContactObject, double, PlaneContactFormats<physgen::Host>>(16, 8, {0, 8}));

}  // namespace contact

#endif  // PHYSGEN_CONTACT_H_AAFCF77993B4B926
