// Accessor classes of the object types in everything.h. Written by physgen: change the schema, not this file.
#ifndef PHYSGEN_EVERYTHING_H_26A5FF71BFE41386
#define PHYSGEN_EVERYTHING_H_26A5FF71BFE41386

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 4
#error "everything.physgen.h is for version 4 of the physgen runtime: generate it again with the installed physgen"
#endif

#include "materials.physgen.h"

namespace tissue {

// ---- Stamp ----------------------------------------------------------------------------------------------------------

/// A moment, of a namespace around those of the others.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Stamp {
  /// [s]
  physgen::same_lanes_t<Real, double> time;
  physgen::same_lanes_t<Real, std::int32_t> step;
};

/// How the fields of one Stamp are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of StampArray.
template <class Space>
struct StampFormats {
  using time = physgen::format::Native;
  using step = physgen::format::Native;
};

struct StampObject;
/// StampFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see <physgen/probe.h>.
/// The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = StampFormats<physgen::Host>, class Object = StampObject, int first = 0>
struct StampProbe {
  using array_ = ArrayTag;
  using time = physgen::Probe<ArrayTag, Object, first + 0, typename Base::time>;
  using step = physgen::Probe<ArrayTag, Object, first + 1, typename Base::step>;
};

/// Where each field begins in the record of one Stamp [bytes].
template <class Real, class Formats>
struct StampRecord {
  static constexpr auto plan_ = physgen::plan_record<2>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::time, double>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::step, std::int32_t>(),
  }});
  static constexpr int time = plan_.offset[0];
  static constexpr int step = plan_.offset[1];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Stamp of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class StampRef {
  using Record = StampRecord<Real, Formats>;

 public:
  using Value = Stamp<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StampRef(const Cursor& cursor) : at_(cursor) {}
  StampRef(const StampRef&) = default;
  StampRef& operator=(const StampRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const StampRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// [s]
  PHYSGEN_FUNCTION decltype(auto) time() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::time, double>(Record::time);
  }
  PHYSGEN_FUNCTION decltype(auto) step() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::step, std::int32_t>(Record::step);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.time = time();
    value.step = step();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    time() = value.time;
    step() = value.step;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Stamp.
struct StampObject {
  static constexpr std::string_view name = "tissue::Stamp";
  template <class Real>
  using Value = Stamp<Real>;
  template <class Real, class Formats>
  using Record = StampRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = StampRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::time, double>(
        "time", "s", StampRecord<Real, Formats>::time, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::step, std::int32_t>(
        "step", "", StampRecord<Real, Formats>::step, 1, 0.0),
  }};
  template <class Space>
  using Formats = StampFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = StampProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<StampObject, Space>>
using StampView = physgen::View<StampObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StampObject, Space>>
using StampArray = physgen::Array<StampObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<StampObject, float, StampFormats<physgen::Host>>(12, 8, {0, 8}));
static_assert(physgen::is_sound_record<StampObject, double, StampFormats<physgen::Host>>(12, 8, {0, 8}));

}  // namespace tissue

namespace tissue::model {

// ---- Shapes ---------------------------------------------------------------------------------------------------------

/// Every structure, with elements of every type.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Shapes {
  /// Scalar.
  Real a;
  Eigen::Matrix<Real, 3, 1> v;
  /// corners i, j, k, l
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> nodes;
  /// deformation gradient [1]
  Eigen::Matrix<Real, 3, 3> F;
  Eigen::Matrix<Real, 2, 3> B;
  Eigen::Matrix<Real, 1, 4> row;
  /// [N/m]. Symmetric, 6 stored.
  Eigen::Matrix<Real, 3, 3> K;
  /// Symmetric, 3 stored.
  Eigen::Matrix<physgen::same_lanes_t<Real, double>, 2, 2> C2;
  /// Diagonal, 3 stored.
  Eigen::Matrix<Real, 3, 1> s;
  /// [1/s]. Skew-symmetric, 3 stored.
  Eigen::Matrix<Real, 3, 3> W;
  /// principal directions. Rotation, 9 stored.
  Eigen::Matrix<Real, 3, 3> U;
  /// Rotation, 9 stored.
  Eigen::Matrix<physgen::same_lanes_t<Real, float>, 3, 3> V;
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> count;
  Eigen::Matrix<physgen::same_lanes_t<Real, double>, 2, 2> M;
};

/// How the fields of one Shapes are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of ShapesArray.
template <class Space>
struct ShapesFormats {
  using a = physgen::format::Native;
  using v = physgen::format::Native;
  using nodes = physgen::format::Native;
  using F = physgen::format::Native;
  using B = physgen::format::Native;
  using row = physgen::format::Native;
  using K = physgen::format::Native;
  using C2 = physgen::format::Native;
  using s = physgen::format::Native;
  using W = physgen::format::Native;
  using U = physgen::format::Native;
  using V = physgen::format::Native;
  using count = physgen::format::Native;
  using M = physgen::format::Native;
};

struct ShapesObject;
/// ShapesFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = ShapesFormats<physgen::Host>, class Object = ShapesObject, int first = 0>
struct ShapesProbe {
  using array_ = ArrayTag;
  using a = physgen::Probe<ArrayTag, Object, first + 0, typename Base::a>;
  using v = physgen::Probe<ArrayTag, Object, first + 1, typename Base::v>;
  using nodes = physgen::Probe<ArrayTag, Object, first + 2, typename Base::nodes>;
  using F = physgen::Probe<ArrayTag, Object, first + 3, typename Base::F>;
  using B = physgen::Probe<ArrayTag, Object, first + 4, typename Base::B>;
  using row = physgen::Probe<ArrayTag, Object, first + 5, typename Base::row>;
  using K = physgen::Probe<ArrayTag, Object, first + 6, typename Base::K>;
  using C2 = physgen::Probe<ArrayTag, Object, first + 7, typename Base::C2>;
  using s = physgen::Probe<ArrayTag, Object, first + 8, typename Base::s>;
  using W = physgen::Probe<ArrayTag, Object, first + 9, typename Base::W>;
  using U = physgen::Probe<ArrayTag, Object, first + 10, typename Base::U>;
  using V = physgen::Probe<ArrayTag, Object, first + 11, typename Base::V>;
  using count = physgen::Probe<ArrayTag, Object, first + 12, typename Base::count>;
  using M = physgen::Probe<ArrayTag, Object, first + 13, typename Base::M>;
};

/// Where each field begins in the record of one Shapes [bytes].
template <class Real, class Formats>
struct ShapesRecord {
  static constexpr auto plan_ = physgen::plan_record<14>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::a, Real>(),
    physgen::slot<physgen::shape::Vector<3>, typename Formats::v, Real>(),
    physgen::slot<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(),
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(),
    physgen::slot<physgen::shape::Matrix<2, 3>, typename Formats::B, Real>(),
    physgen::slot<physgen::shape::Matrix<1, 4>, typename Formats::row, Real>(),
    physgen::slot<physgen::shape::Symmetric<3>, typename Formats::K, Real>(),
    physgen::slot<physgen::shape::Symmetric<2>, typename Formats::C2, double>(),
    physgen::slot<physgen::shape::Diagonal<3>, typename Formats::s, Real>(),
    physgen::slot<physgen::shape::Skew<3>, typename Formats::W, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::U, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::V, float>(),
    physgen::slot<physgen::shape::Vector<2>, typename Formats::count, std::int32_t>(),
    physgen::slot<physgen::shape::Matrix<2, 2>, typename Formats::M, double>(),
  }});
  static constexpr int a = plan_.offset[0];
  static constexpr int v = plan_.offset[1];
  static constexpr int nodes = plan_.offset[2];
  static constexpr int F = plan_.offset[3];
  static constexpr int B = plan_.offset[4];
  static constexpr int row = plan_.offset[5];
  static constexpr int K = plan_.offset[6];
  static constexpr int C2 = plan_.offset[7];
  static constexpr int s = plan_.offset[8];
  static constexpr int W = plan_.offset[9];
  static constexpr int U = plan_.offset[10];
  static constexpr int V = plan_.offset[11];
  static constexpr int count = plan_.offset[12];
  static constexpr int M = plan_.offset[13];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Shapes of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class ShapesRef {
  using Record = ShapesRecord<Real, Formats>;

 public:
  using Value = Shapes<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit ShapesRef(const Cursor& cursor) : at_(cursor) {}
  ShapesRef(const ShapesRef&) = default;
  ShapesRef& operator=(const ShapesRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const ShapesRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Scalar.
  PHYSGEN_FUNCTION decltype(auto) a() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::a, Real>(Record::a);
  }
  PHYSGEN_FUNCTION decltype(auto) v() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::v, Real>(Record::v);
  }
  /// corners i, j, k, l
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return at_.template field<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(Record::nodes);
  }
  /// deformation gradient [1]
  PHYSGEN_FUNCTION decltype(auto) F() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(Record::F);
  }
  PHYSGEN_FUNCTION decltype(auto) B() const {
    return at_.template field<physgen::shape::Matrix<2, 3>, typename Formats::B, Real>(Record::B);
  }
  PHYSGEN_FUNCTION decltype(auto) row() const {
    return at_.template field<physgen::shape::Matrix<1, 4>, typename Formats::row, Real>(Record::row);
  }
  /// [N/m]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) K() const {
    return at_.template field<physgen::shape::Symmetric<3>, typename Formats::K, Real>(Record::K);
  }
  /// Symmetric, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) C2() const {
    return at_.template field<physgen::shape::Symmetric<2>, typename Formats::C2, double>(Record::C2);
  }
  /// Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const {
    return at_.template field<physgen::shape::Diagonal<3>, typename Formats::s, Real>(Record::s);
  }
  /// [1/s]. Skew-symmetric, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) W() const {
    return at_.template field<physgen::shape::Skew<3>, typename Formats::W, Real>(Record::W);
  }
  /// principal directions. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::U, Real>(Record::U);
  }
  /// Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::V, float>(Record::V);
  }
  PHYSGEN_FUNCTION decltype(auto) count() const {
    return at_.template field<physgen::shape::Vector<2>, typename Formats::count, std::int32_t>(Record::count);
  }
  PHYSGEN_FUNCTION decltype(auto) M() const {
    return at_.template field<physgen::shape::Matrix<2, 2>, typename Formats::M, double>(Record::M);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.a = a();
    value.v = v().get();
    value.nodes = nodes().get();
    value.F = F().get();
    value.B = B().get();
    value.row = row().get();
    value.K = K().get();
    value.C2 = C2().get();
    value.s = s().get();
    value.W = W().get();
    value.U = U().get();
    value.V = V().get();
    value.count = count().get();
    value.M = M().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    a() = value.a;
    v() = value.v;
    nodes() = value.nodes;
    F() = value.F;
    B() = value.B;
    row() = value.row;
    K() = value.K;
    C2() = value.C2;
    s() = value.s;
    W() = value.W;
    U() = value.U;
    V() = value.V;
    count() = value.count;
    M() = value.M;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Shapes.
struct ShapesObject {
  static constexpr std::string_view name = "tissue::model::Shapes";
  template <class Real>
  using Value = Shapes<Real>;
  template <class Real, class Formats>
  using Record = ShapesRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = ShapesRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 14> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::a, Real>(
        "a", "", ShapesRecord<Real, Formats>::a, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::v, Real>(
        "v", "", ShapesRecord<Real, Formats>::v, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>(
        "nodes", "", ShapesRecord<Real, Formats>::nodes, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(
        "F", "1", ShapesRecord<Real, Formats>::F, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<2, 3>, typename Formats::B, Real>(
        "B", "", ShapesRecord<Real, Formats>::B, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<1, 4>, typename Formats::row, Real>(
        "row", "", ShapesRecord<Real, Formats>::row, 1, 0.0),
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::K, Real>(
        "K", "N/m", ShapesRecord<Real, Formats>::K, 1, 0.0),
    physgen::field_info<physgen::shape::Symmetric<2>, typename Formats::C2, double>(
        "C2", "", ShapesRecord<Real, Formats>::C2, 1, 0.0),
    physgen::field_info<physgen::shape::Diagonal<3>, typename Formats::s, Real>(
        "s", "", ShapesRecord<Real, Formats>::s, 1, 0.0),
    physgen::field_info<physgen::shape::Skew<3>, typename Formats::W, Real>(
        "W", "1/s", ShapesRecord<Real, Formats>::W, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::U, Real>(
        "U", "", ShapesRecord<Real, Formats>::U, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::V, float>(
        "V", "", ShapesRecord<Real, Formats>::V, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::count, std::int32_t>(
        "count", "", ShapesRecord<Real, Formats>::count, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<2, 2>, typename Formats::M, double>(
        "M", "", ShapesRecord<Real, Formats>::M, 1, 0.0),
  }};
  template <class Space>
  using Formats = ShapesFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = ShapesProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<ShapesObject, Space>>
using ShapesView = physgen::View<ShapesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<ShapesObject, Space>>
using ShapesArray = physgen::Array<ShapesObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<ShapesObject, float, ShapesFormats<physgen::Host>>(
    292, 8, {56, 60, 72, 88, 124, 148, 164, 0, 188, 200, 212, 248, 284, 24}));
static_assert(physgen::is_sound_record<ShapesObject, double, ShapesFormats<physgen::Host>>(
    468, 8, {0, 8, 408, 32, 104, 152, 184, 232, 256, 280, 304, 424, 460, 376}));

// ---- Names ----------------------------------------------------------------------------------------------------------

/// Names that generated code uses elsewhere.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Names {
  Real value;
  Real entry;
  Real S;
  Real R;
  Real at;
  Real cursor;
  Real name;
  Real fields;
  Real Layout;
  Real host;
  Real plan;
  Real slot;
  Real stride;
  Real offset;
  Real format;
  Real Native;
  Real PerSpace;
  Real field;
  Real element;
  Real nested;
  Real self[2];
  Eigen::Matrix<Real, 2, 1> tissue;
};

/// How the fields of one Names are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of NamesArray.
template <class Space>
struct NamesFormats {
  using value = physgen::format::Native;
  using entry = physgen::format::Native;
  using S = physgen::format::Native;
  using R = physgen::format::Native;
  using at = physgen::format::Native;
  using cursor = physgen::format::Native;
  using name = physgen::format::Native;
  using fields = physgen::format::Native;
  using Layout = physgen::format::Native;
  using host = physgen::format::Native;
  using plan = physgen::format::Native;
  using slot = physgen::format::Native;
  using stride = physgen::format::Native;
  using offset = physgen::format::Native;
  using format = physgen::format::Native;
  using Native = physgen::format::Native;
  using PerSpace = physgen::format::Native;
  using field = physgen::format::Native;
  using element = physgen::format::Native;
  using nested = physgen::format::Native;
  using self = physgen::format::Native;
  using tissue = physgen::format::Native;
};

struct NamesObject;
/// NamesFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see <physgen/probe.h>.
/// The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = NamesFormats<physgen::Host>, class Object = NamesObject, int first = 0>
struct NamesProbe {
  using array_ = ArrayTag;
  using value = physgen::Probe<ArrayTag, Object, first + 0, typename Base::value>;
  using entry = physgen::Probe<ArrayTag, Object, first + 1, typename Base::entry>;
  using S = physgen::Probe<ArrayTag, Object, first + 2, typename Base::S>;
  using R = physgen::Probe<ArrayTag, Object, first + 3, typename Base::R>;
  using at = physgen::Probe<ArrayTag, Object, first + 4, typename Base::at>;
  using cursor = physgen::Probe<ArrayTag, Object, first + 5, typename Base::cursor>;
  using name = physgen::Probe<ArrayTag, Object, first + 6, typename Base::name>;
  using fields = physgen::Probe<ArrayTag, Object, first + 7, typename Base::fields>;
  using Layout = physgen::Probe<ArrayTag, Object, first + 8, typename Base::Layout>;
  using host = physgen::Probe<ArrayTag, Object, first + 9, typename Base::host>;
  using plan = physgen::Probe<ArrayTag, Object, first + 10, typename Base::plan>;
  using slot = physgen::Probe<ArrayTag, Object, first + 11, typename Base::slot>;
  using stride = physgen::Probe<ArrayTag, Object, first + 12, typename Base::stride>;
  using offset = physgen::Probe<ArrayTag, Object, first + 13, typename Base::offset>;
  using format = physgen::Probe<ArrayTag, Object, first + 14, typename Base::format>;
  using Native = physgen::Probe<ArrayTag, Object, first + 15, typename Base::Native>;
  using PerSpace = physgen::Probe<ArrayTag, Object, first + 16, typename Base::PerSpace>;
  using field = physgen::Probe<ArrayTag, Object, first + 17, typename Base::field>;
  using element = physgen::Probe<ArrayTag, Object, first + 18, typename Base::element>;
  using nested = physgen::Probe<ArrayTag, Object, first + 19, typename Base::nested>;
  using self = physgen::Probe<ArrayTag, Object, first + 20, typename Base::self>;
  using tissue = physgen::Probe<ArrayTag, Object, first + 21, typename Base::tissue>;
};

/// Where each field begins in the record of one Names [bytes].
template <class Real, class Formats>
struct NamesRecord {
  static constexpr auto plan_ = physgen::plan_record<22>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::value, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::entry, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::S, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::R, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::at, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::cursor, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::name, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::fields, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::Layout, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::host, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::plan, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::slot, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::stride, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::offset, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::format, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::Native, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::PerSpace, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::field, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::element, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::nested, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::self, Real>(2),
    physgen::slot<physgen::shape::Vector<2>, typename Formats::tissue, Real>(),
  }});
  static constexpr int value = plan_.offset[0];
  static constexpr int entry = plan_.offset[1];
  static constexpr int S = plan_.offset[2];
  static constexpr int R = plan_.offset[3];
  static constexpr int at = plan_.offset[4];
  static constexpr int cursor = plan_.offset[5];
  static constexpr int name = plan_.offset[6];
  static constexpr int fields = plan_.offset[7];
  static constexpr int Layout = plan_.offset[8];
  static constexpr int host = plan_.offset[9];
  static constexpr int plan = plan_.offset[10];
  static constexpr int slot = plan_.offset[11];
  static constexpr int stride = plan_.offset[12];
  static constexpr int offset = plan_.offset[13];
  static constexpr int format = plan_.offset[14];
  static constexpr int Native = plan_.offset[15];
  static constexpr int PerSpace = plan_.offset[16];
  static constexpr int field = plan_.offset[17];
  static constexpr int element = plan_.offset[18];
  static constexpr int nested = plan_.offset[19];
  static constexpr int self = plan_.offset[20];
  static constexpr int tissue = plan_.offset[21];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Names of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class NamesRef {
  using Record = NamesRecord<Real, Formats>;

 public:
  using Value = Names<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NamesRef(const Cursor& cursor) : at_(cursor) {}
  NamesRef(const NamesRef&) = default;
  NamesRef& operator=(const NamesRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const NamesRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  PHYSGEN_FUNCTION decltype(auto) value() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::value, Real>(Record::value);
  }
  PHYSGEN_FUNCTION decltype(auto) entry() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::entry, Real>(Record::entry);
  }
  PHYSGEN_FUNCTION decltype(auto) S() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::S, Real>(Record::S);
  }
  PHYSGEN_FUNCTION decltype(auto) R() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::R, Real>(Record::R);
  }
  PHYSGEN_FUNCTION decltype(auto) at() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::at, Real>(Record::at);
  }
  PHYSGEN_FUNCTION decltype(auto) cursor() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::cursor, Real>(Record::cursor);
  }
  PHYSGEN_FUNCTION decltype(auto) name() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::name, Real>(Record::name);
  }
  PHYSGEN_FUNCTION decltype(auto) fields() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::fields, Real>(Record::fields);
  }
  PHYSGEN_FUNCTION decltype(auto) Layout() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::Layout, Real>(Record::Layout);
  }
  PHYSGEN_FUNCTION decltype(auto) host() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::host, Real>(Record::host);
  }
  PHYSGEN_FUNCTION decltype(auto) plan() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::plan, Real>(Record::plan);
  }
  PHYSGEN_FUNCTION decltype(auto) slot() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::slot, Real>(Record::slot);
  }
  PHYSGEN_FUNCTION decltype(auto) stride() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::stride, Real>(Record::stride);
  }
  PHYSGEN_FUNCTION decltype(auto) offset() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::offset, Real>(Record::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) format() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::format, Real>(Record::format);
  }
  PHYSGEN_FUNCTION decltype(auto) Native() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::Native, Real>(Record::Native);
  }
  PHYSGEN_FUNCTION decltype(auto) PerSpace() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::PerSpace, Real>(Record::PerSpace);
  }
  PHYSGEN_FUNCTION decltype(auto) field() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::field, Real>(Record::field);
  }
  PHYSGEN_FUNCTION decltype(auto) element() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::element, Real>(Record::element);
  }
  PHYSGEN_FUNCTION decltype(auto) nested() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::nested, Real>(Record::nested);
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) self(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Names::self");
    return at_.template field<physgen::shape::Scalar, typename Formats::self, Real>(
        Record::self + entry * Record::plan_.stride[20]);
  }
  PHYSGEN_FUNCTION decltype(auto) tissue() const {
    return at_.template field<physgen::shape::Vector<2>, typename Formats::tissue, Real>(Record::tissue);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value_;
    value_.value = value();
    value_.entry = entry();
    value_.S = S();
    value_.R = R();
    value_.at = at();
    value_.cursor = cursor();
    value_.name = name();
    value_.fields = fields();
    value_.Layout = Layout();
    value_.host = host();
    value_.plan = plan();
    value_.slot = slot();
    value_.stride = stride();
    value_.offset = offset();
    value_.format = format();
    value_.Native = Native();
    value_.PerSpace = PerSpace();
    value_.field = field();
    value_.element = element();
    value_.nested = nested();
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 2; ++entry_) value_.self[entry_] = self(entry_);
    value_.tissue = tissue().get();
    return value_;
  }
  PHYSGEN_FUNCTION void put(const Value& value_) const {
    value() = value_.value;
    entry() = value_.entry;
    S() = value_.S;
    R() = value_.R;
    at() = value_.at;
    cursor() = value_.cursor;
    name() = value_.name;
    fields() = value_.fields;
    Layout() = value_.Layout;
    host() = value_.host;
    plan() = value_.plan;
    slot() = value_.slot;
    stride() = value_.stride;
    offset() = value_.offset;
    format() = value_.format;
    Native() = value_.Native;
    PerSpace() = value_.PerSpace;
    field() = value_.field;
    element() = value_.element;
    nested() = value_.nested;
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 2; ++entry_) self(entry_) = value_.self[entry_];
    tissue() = value_.tissue;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Names.
struct NamesObject {
  static constexpr std::string_view name = "tissue::model::Names";
  template <class Real>
  using Value = Names<Real>;
  template <class Real, class Formats>
  using Record = NamesRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = NamesRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 22> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::value, Real>(
        "value", "", NamesRecord<Real, Formats>::value, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::entry, Real>(
        "entry", "", NamesRecord<Real, Formats>::entry, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::S, Real>(
        "S", "", NamesRecord<Real, Formats>::S, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::R, Real>(
        "R", "", NamesRecord<Real, Formats>::R, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::at, Real>(
        "at", "", NamesRecord<Real, Formats>::at, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::cursor, Real>(
        "cursor", "", NamesRecord<Real, Formats>::cursor, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::name, Real>(
        "name", "", NamesRecord<Real, Formats>::name, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::fields, Real>(
        "fields", "", NamesRecord<Real, Formats>::fields, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::Layout, Real>(
        "Layout", "", NamesRecord<Real, Formats>::Layout, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::host, Real>(
        "host", "", NamesRecord<Real, Formats>::host, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::plan, Real>(
        "plan", "", NamesRecord<Real, Formats>::plan, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::slot, Real>(
        "slot", "", NamesRecord<Real, Formats>::slot, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::stride, Real>(
        "stride", "", NamesRecord<Real, Formats>::stride, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::offset, Real>(
        "offset", "", NamesRecord<Real, Formats>::offset, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::format, Real>(
        "format", "", NamesRecord<Real, Formats>::format, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::Native, Real>(
        "Native", "", NamesRecord<Real, Formats>::Native, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::PerSpace, Real>(
        "PerSpace", "", NamesRecord<Real, Formats>::PerSpace, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::field, Real>(
        "field", "", NamesRecord<Real, Formats>::field, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::element, Real>(
        "element", "", NamesRecord<Real, Formats>::element, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::nested, Real>(
        "nested", "", NamesRecord<Real, Formats>::nested, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::self, Real>(
        "self", "", NamesRecord<Real, Formats>::self, 2, 0.0),
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::tissue, Real>(
        "tissue", "", NamesRecord<Real, Formats>::tissue, 1, 0.0),
  }};
  template <class Space>
  using Formats = NamesFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = NamesProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<NamesObject, Space>>
using NamesView = physgen::View<NamesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<NamesObject, Space>>
using NamesArray = physgen::Array<NamesObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<NamesObject, float, NamesFormats<physgen::Host>>(
    96, 4, {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64, 68, 72, 76, 80, 88}));
static_assert(physgen::is_sound_record<NamesObject, double, NamesFormats<physgen::Host>>(
    192, 8, {0, 8, 16, 24, 32, 40, 48, 56, 64, 72, 80, 88, 96, 104, 112, 120, 128, 136, 144, 152, 160, 176}));

// ---- Entries --------------------------------------------------------------------------------------------------------

/// Fixed arrays.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Entries {
  /// Weights of the five points.
  /// They sum to one. [1] Range [0, 1].
  Real weights[5];
  /// [N/m]. Symmetric, 6 stored.
  Eigen::Matrix<Real, 3, 3> k[4];
  physgen::same_lanes_t<Real, std::int32_t> flags[3];
  /// More entries than are worth unrolling
  physgen::same_lanes_t<Real, double> history[40];
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> edges[6];
  Real entry[2];
};

/// How the fields of one Entries are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of EntriesArray.
template <class Space>
struct EntriesFormats {
  using weights = physgen::format::Native;
  using k = physgen::format::Native;
  using flags = physgen::format::Native;
  using history = physgen::format::Native;
  using edges = physgen::format::Native;
  using entry = physgen::format::Native;
};

struct EntriesObject;
/// EntriesFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = EntriesFormats<physgen::Host>, class Object = EntriesObject, int first = 0>
struct EntriesProbe {
  using array_ = ArrayTag;
  using weights = physgen::Probe<ArrayTag, Object, first + 0, typename Base::weights>;
  using k = physgen::Probe<ArrayTag, Object, first + 1, typename Base::k>;
  using flags = physgen::Probe<ArrayTag, Object, first + 2, typename Base::flags>;
  using history = physgen::Probe<ArrayTag, Object, first + 3, typename Base::history>;
  using edges = physgen::Probe<ArrayTag, Object, first + 4, typename Base::edges>;
  using entry = physgen::Probe<ArrayTag, Object, first + 5, typename Base::entry>;
};

/// Where each field begins in the record of one Entries [bytes].
template <class Real, class Formats>
struct EntriesRecord {
  static constexpr auto plan_ = physgen::plan_record<6>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::weights, Real>(5),
    physgen::slot<physgen::shape::Symmetric<3>, typename Formats::k, Real>(4),
    physgen::slot<physgen::shape::Scalar, typename Formats::flags, std::int32_t>(3),
    physgen::slot<physgen::shape::Scalar, typename Formats::history, double>(40),
    physgen::slot<physgen::shape::Vector<2>, typename Formats::edges, std::int32_t>(6),
    physgen::slot<physgen::shape::Scalar, typename Formats::entry, Real>(2),
  }});
  static constexpr int weights = plan_.offset[0];
  static constexpr int k = plan_.offset[1];
  static constexpr int flags = plan_.offset[2];
  static constexpr int history = plan_.offset[3];
  static constexpr int edges = plan_.offset[4];
  static constexpr int entry = plan_.offset[5];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Entries of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class EntriesRef {
  using Record = EntriesRecord<Real, Formats>;

 public:
  using Value = Entries<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit EntriesRef(const Cursor& cursor) : at_(cursor) {}
  EntriesRef(const EntriesRef&) = default;
  EntriesRef& operator=(const EntriesRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const EntriesRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Weights of the five points.
  /// They sum to one. [1] Range [0, 1].
  /// @pre 0 <= entry < 5
  PHYSGEN_FUNCTION decltype(auto) weights(int entry) const {
    physgen::check_inner(entry, 5, "an entry of tissue::model::Entries::weights");
    return at_.template field<physgen::shape::Scalar, typename Formats::weights, Real>(
        Record::weights + entry * Record::plan_.stride[0]);
  }
  /// [N/m]. Symmetric, 6 stored.
  /// @pre 0 <= entry < 4
  PHYSGEN_FUNCTION decltype(auto) k(int entry) const {
    physgen::check_inner(entry, 4, "an entry of tissue::model::Entries::k");
    return at_.template field<physgen::shape::Symmetric<3>, typename Formats::k, Real>(
        Record::k + entry * Record::plan_.stride[1]);
  }
  /// @pre 0 <= entry < 3
  PHYSGEN_FUNCTION decltype(auto) flags(int entry) const {
    physgen::check_inner(entry, 3, "an entry of tissue::model::Entries::flags");
    return at_.template field<physgen::shape::Scalar, typename Formats::flags, std::int32_t>(
        Record::flags + entry * Record::plan_.stride[2]);
  }
  /// More entries than are worth unrolling
  /// @pre 0 <= entry < 40
  PHYSGEN_FUNCTION decltype(auto) history(int entry) const {
    physgen::check_inner(entry, 40, "an entry of tissue::model::Entries::history");
    return at_.template field<physgen::shape::Scalar, typename Formats::history, double>(
        Record::history + entry * Record::plan_.stride[3]);
  }
  /// @pre 0 <= entry < 6
  PHYSGEN_FUNCTION decltype(auto) edges(int entry) const {
    physgen::check_inner(entry, 6, "an entry of tissue::model::Entries::edges");
    return at_.template field<physgen::shape::Vector<2>, typename Formats::edges, std::int32_t>(
        Record::edges + entry * Record::plan_.stride[4]);
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) entry(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Entries::entry");
    return at_.template field<physgen::shape::Scalar, typename Formats::entry, Real>(
        Record::entry + entry * Record::plan_.stride[5]);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 5; ++entry_) value.weights[entry_] = weights(entry_);
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 4; ++entry_) value.k[entry_] = k(entry_).get();
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 3; ++entry_) value.flags[entry_] = flags(entry_);
    for (int entry_ = 0; entry_ < 40; ++entry_) value.history[entry_] = history(entry_);
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 6; ++entry_) value.edges[entry_] = edges(entry_).get();
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 2; ++entry_) value.entry[entry_] = entry(entry_);
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 5; ++entry_) weights(entry_) = value.weights[entry_];
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 4; ++entry_) k(entry_) = value.k[entry_];
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 3; ++entry_) flags(entry_) = value.flags[entry_];
    for (int entry_ = 0; entry_ < 40; ++entry_) history(entry_) = value.history[entry_];
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 6; ++entry_) edges(entry_) = value.edges[entry_];
    PHYSGEN_UNROLL
    for (int entry_ = 0; entry_ < 2; ++entry_) entry(entry_) = value.entry[entry_];
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Entries.
struct EntriesObject {
  static constexpr std::string_view name = "tissue::model::Entries";
  template <class Real>
  using Value = Entries<Real>;
  template <class Real, class Formats>
  using Record = EntriesRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = EntriesRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 6> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::weights, Real>(
        "weights", "1", EntriesRecord<Real, Formats>::weights, 5, 0.0),
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::k, Real>(
        "k", "N/m", EntriesRecord<Real, Formats>::k, 4, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::flags, std::int32_t>(
        "flags", "", EntriesRecord<Real, Formats>::flags, 3, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::history, double>(
        "history", "", EntriesRecord<Real, Formats>::history, 40, 0.0),
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::edges, std::int32_t>(
        "edges", "", EntriesRecord<Real, Formats>::edges, 6, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::entry, Real>(
        "entry", "", EntriesRecord<Real, Formats>::entry, 2, 0.0),
  }};
  template <class Space>
  using Formats = EntriesFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = EntriesProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<EntriesObject, Space>>
using EntriesView = physgen::View<EntriesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<EntriesObject, Space>>
using EntriesArray = physgen::Array<EntriesObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<EntriesObject, float, EntriesFormats<physgen::Host>>(
    504, 8, {320, 340, 436, 0, 448, 496}));
static_assert(physgen::is_sound_record<EntriesObject, double, EntriesFormats<physgen::Host>>(
    628, 8, {0, 40, 568, 232, 580, 552}));

// ---- Options --------------------------------------------------------------------------------------------------------

/// Units, ranges and initial values. The text of this comment is long enough to need a second line, because it goes on
/// and on without saying anything else.
///
///   An indented line, and one that ends with a backslash:
/// The last line.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Options {
  /// Mass per volume of the rest shape. [kg/m^3] Range [0, 20000]; initially 1060.
  Real density = physgen::all_lanes<Real>(1060.0);
  /// Range [0, 0.5]; initially 0.45.
  Real nu = physgen::all_lanes<Real>(0.45);
  /// [1]. Initially 0.5.
  Eigen::Matrix<Real, 3, 1> direction = decltype(direction)::Constant(physgen::all_lanes<Real>(0.5));
  /// Symmetric, 6 stored. Initially 1.
  Eigen::Matrix<Real, 3, 3> metric = decltype(metric)::Constant(physgen::all_lanes<Real>(1.0));
  /// Initially -1.
  physgen::same_lanes_t<Real, std::int32_t> label = -1;
  /// Initially 7.
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> group = decltype(group)::Constant(7);
  /// Skew-symmetric, 3 stored. Initially 0.25 in a new array.
  Eigen::Matrix<Real, 3, 3> spin;
  /// Initially 1e-12.
  physgen::same_lanes_t<Real, double> fixed = 1e-12;
};

/// How the fields of one Options are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of OptionsArray.
template <class Space>
struct OptionsFormats {
  using density = physgen::format::Native;
  using nu = physgen::format::Native;
  using direction = physgen::format::Native;
  using metric = physgen::format::Native;
  using label = physgen::format::Native;
  using group = physgen::format::Native;
  using spin = physgen::format::Native;
  using fixed = physgen::format::Native;
};

struct OptionsObject;
/// OptionsFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = OptionsFormats<physgen::Host>, class Object = OptionsObject, int first = 0>
struct OptionsProbe {
  using array_ = ArrayTag;
  using density = physgen::Probe<ArrayTag, Object, first + 0, typename Base::density>;
  using nu = physgen::Probe<ArrayTag, Object, first + 1, typename Base::nu>;
  using direction = physgen::Probe<ArrayTag, Object, first + 2, typename Base::direction>;
  using metric = physgen::Probe<ArrayTag, Object, first + 3, typename Base::metric>;
  using label = physgen::Probe<ArrayTag, Object, first + 4, typename Base::label>;
  using group = physgen::Probe<ArrayTag, Object, first + 5, typename Base::group>;
  using spin = physgen::Probe<ArrayTag, Object, first + 6, typename Base::spin>;
  using fixed = physgen::Probe<ArrayTag, Object, first + 7, typename Base::fixed>;
};

/// Where each field begins in the record of one Options [bytes].
template <class Real, class Formats>
struct OptionsRecord {
  static constexpr auto plan_ = physgen::plan_record<8>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::density, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::nu, Real>(),
    physgen::slot<physgen::shape::Vector<3>, typename Formats::direction, Real>(),
    physgen::slot<physgen::shape::Symmetric<3>, typename Formats::metric, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::label, std::int32_t>(),
    physgen::slot<physgen::shape::Vector<2>, typename Formats::group, std::int32_t>(),
    physgen::slot<physgen::shape::Skew<3>, typename Formats::spin, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::fixed, double>(),
  }});
  static constexpr int density = plan_.offset[0];
  static constexpr int nu = plan_.offset[1];
  static constexpr int direction = plan_.offset[2];
  static constexpr int metric = plan_.offset[3];
  static constexpr int label = plan_.offset[4];
  static constexpr int group = plan_.offset[5];
  static constexpr int spin = plan_.offset[6];
  static constexpr int fixed = plan_.offset[7];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment > 32 ? plan_.alignment : 32;
};

/// One Options of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class OptionsRef {
  using Record = OptionsRecord<Real, Formats>;

 public:
  using Value = Options<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit OptionsRef(const Cursor& cursor) : at_(cursor) {}
  OptionsRef(const OptionsRef&) = default;
  OptionsRef& operator=(const OptionsRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const OptionsRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Mass per volume of the rest shape. [kg/m^3] Range [0, 20000]; initially 1060.
  PHYSGEN_FUNCTION decltype(auto) density() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::density, Real>(Record::density);
  }
  /// Range [0, 0.5]; initially 0.45.
  PHYSGEN_FUNCTION decltype(auto) nu() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::nu, Real>(Record::nu);
  }
  /// [1]. Initially 0.5.
  PHYSGEN_FUNCTION decltype(auto) direction() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::direction, Real>(Record::direction);
  }
  /// Symmetric, 6 stored. Initially 1.
  PHYSGEN_FUNCTION decltype(auto) metric() const {
    return at_.template field<physgen::shape::Symmetric<3>, typename Formats::metric, Real>(Record::metric);
  }
  /// Initially -1.
  PHYSGEN_FUNCTION decltype(auto) label() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::label, std::int32_t>(Record::label);
  }
  /// Initially 7.
  PHYSGEN_FUNCTION decltype(auto) group() const {
    return at_.template field<physgen::shape::Vector<2>, typename Formats::group, std::int32_t>(Record::group);
  }
  /// Skew-symmetric, 3 stored. Initially 0.25 in a new array.
  PHYSGEN_FUNCTION decltype(auto) spin() const {
    return at_.template field<physgen::shape::Skew<3>, typename Formats::spin, Real>(Record::spin);
  }
  /// Initially 1e-12.
  PHYSGEN_FUNCTION decltype(auto) fixed() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::fixed, double>(Record::fixed);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.density = density();
    value.nu = nu();
    value.direction = direction().get();
    value.metric = metric().get();
    value.label = label();
    value.group = group().get();
    value.spin = spin().get();
    value.fixed = fixed();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    density() = value.density;
    nu() = value.nu;
    direction() = value.direction;
    metric() = value.metric;
    label() = value.label;
    group() = value.group;
    spin() = value.spin;
    fixed() = value.fixed;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Options.
struct OptionsObject {
  static constexpr std::string_view name = "tissue::model::Options";
  template <class Real>
  using Value = Options<Real>;
  template <class Real, class Formats>
  using Record = OptionsRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = OptionsRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 8> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::density, Real>(
        "density", "kg/m^3", OptionsRecord<Real, Formats>::density, 1, 1060.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::nu, Real>(
        "nu", "", OptionsRecord<Real, Formats>::nu, 1, 0.45),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::direction, Real>(
        "direction", "1", OptionsRecord<Real, Formats>::direction, 1, 0.5),
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::metric, Real>(
        "metric", "", OptionsRecord<Real, Formats>::metric, 1, 1.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::label, std::int32_t>(
        "label", "", OptionsRecord<Real, Formats>::label, 1, -1.0),
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::group, std::int32_t>(
        "group", "", OptionsRecord<Real, Formats>::group, 1, 7.0),
    physgen::field_info<physgen::shape::Skew<3>, typename Formats::spin, Real>(
        "spin", "", OptionsRecord<Real, Formats>::spin, 1, 0.25),
    physgen::field_info<physgen::shape::Scalar, typename Formats::fixed, double>(
        "fixed", "", OptionsRecord<Real, Formats>::fixed, 1, 1e-12),
  }};
  template <class Space>
  using Formats = OptionsFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = OptionsProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<OptionsObject, Space>>
using OptionsView = physgen::View<OptionsObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Soa, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<OptionsObject, Space>>
using OptionsArray = physgen::Array<OptionsObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<OptionsObject, float, OptionsFormats<physgen::Host>>(
    76, 32, {8, 12, 16, 28, 52, 56, 64, 0}));
static_assert(physgen::is_sound_record<OptionsObject, double, OptionsFormats<physgen::Host>>(
    132, 32, {0, 8, 16, 40, 120, 124, 88, 112}));

// ---- Element --------------------------------------------------------------------------------------------------------

/// Nested objects of every alignment.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Element {
  /// Before the nested objects by name, behind them in the record.
  physgen::same_lanes_t<Real, std::int32_t> flag;
  /// Constants of the tissue.
  ::material::Lame<Real> lame;
  ::material::Fibre<Real> fibres[2];
  ::tissue::Stamp<Real> stamp;
  Shapes<Real> shapes;
  /// [m^3]
  Real volume;
};

/// How the fields of one Element are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of ElementArray.
template <class Space>
struct ElementFormats {
  using flag = physgen::format::Native;
  using lame = ::material::LameFormats<Space>;
  using fibres = ::material::FibreFormats<Space>;
  using stamp = ::tissue::StampFormats<Space>;
  using shapes = ShapesFormats<Space>;
  using volume = physgen::format::Native;
};

struct ElementObject;
/// ElementFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = ElementFormats<physgen::Host>, class Object = ElementObject, int first = 0>
struct ElementProbe {
  using array_ = ArrayTag;
  using flag = physgen::Probe<ArrayTag, Object, first + 0, typename Base::flag>;
  using lame = ::material::LameProbe<ArrayTag, typename Base::lame, Object, first + 1>;
  using fibres = ::material::FibreProbe<ArrayTag, typename Base::fibres, Object, first + 3>;
  using stamp = ::tissue::StampProbe<ArrayTag, typename Base::stamp, Object, first + 7>;
  using shapes = ShapesProbe<ArrayTag, typename Base::shapes, Object, first + 9>;
  using volume = physgen::Probe<ArrayTag, Object, first + 23, typename Base::volume>;
};

/// Where each field begins in the record of one Element [bytes].
template <class Real, class Formats>
struct ElementRecord {
  static constexpr auto plan_ = physgen::plan_record<6>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::flag, std::int32_t>(),
    physgen::nested_slot<::material::LameRecord<Real, typename Formats::lame>>(),
    physgen::nested_slot<::material::FibreRecord<Real, typename Formats::fibres>>(2),
    physgen::nested_slot<::tissue::StampRecord<Real, typename Formats::stamp>>(),
    physgen::nested_slot<ShapesRecord<Real, typename Formats::shapes>>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::volume, Real>(),
  }});
  static constexpr int flag = plan_.offset[0];
  static constexpr int lame = plan_.offset[1];
  static constexpr int fibres = plan_.offset[2];
  static constexpr int stamp = plan_.offset[3];
  static constexpr int shapes = plan_.offset[4];
  static constexpr int volume = plan_.offset[5];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Element of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class ElementRef {
  using Record = ElementRecord<Real, Formats>;

 public:
  using Value = Element<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit ElementRef(const Cursor& cursor) : at_(cursor) {}
  ElementRef(const ElementRef&) = default;
  ElementRef& operator=(const ElementRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const ElementRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Before the nested objects by name, behind them in the record.
  PHYSGEN_FUNCTION decltype(auto) flag() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::flag, std::int32_t>(Record::flag);
  }
  /// Constants of the tissue.
  PHYSGEN_FUNCTION ::material::LameRef<Real, typename Formats::lame, Cursor> lame() const {
    return ::material::LameRef<Real, typename Formats::lame, Cursor>(at_.nested(Record::lame));
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION ::material::FibreRef<Real, typename Formats::fibres, Cursor> fibres(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Element::fibres");
    return ::material::FibreRef<Real, typename Formats::fibres, Cursor>(
        at_.nested(Record::fibres + entry * Record::plan_.stride[2]));
  }
  PHYSGEN_FUNCTION ::tissue::StampRef<Real, typename Formats::stamp, Cursor> stamp() const {
    return ::tissue::StampRef<Real, typename Formats::stamp, Cursor>(at_.nested(Record::stamp));
  }
  PHYSGEN_FUNCTION ShapesRef<Real, typename Formats::shapes, Cursor> shapes() const {
    return ShapesRef<Real, typename Formats::shapes, Cursor>(at_.nested(Record::shapes));
  }
  /// [m^3]
  PHYSGEN_FUNCTION decltype(auto) volume() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::volume, Real>(Record::volume);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.flag = flag();
    value.lame = lame().get();
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 2; ++entry) value.fibres[entry] = fibres(entry).get();
    value.stamp = stamp().get();
    value.shapes = shapes().get();
    value.volume = volume();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    flag() = value.flag;
    lame().put(value.lame);
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 2; ++entry) fibres(entry).put(value.fibres[entry]);
    stamp().put(value.stamp);
    shapes().put(value.shapes);
    volume() = value.volume;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Element.
struct ElementObject {
  static constexpr std::string_view name = "tissue::model::Element";
  template <class Real>
  using Value = Element<Real>;
  template <class Real, class Formats>
  using Record = ElementRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = ElementRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 24> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::flag, std::int32_t>(
        "flag", "", ElementRecord<Real, Formats>::flag, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::lame::mu, Real>(
        "lame.mu", "Pa", ElementRecord<Real, Formats>::lame + ::material::LameRecord<Real, typename Formats::lame>::mu,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::lame::lambda, Real>(
        "lame.lambda", "Pa",
        ElementRecord<Real, Formats>::lame + ::material::LameRecord<Real, typename Formats::lame>::lambda, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::fibres::direction, float>(
        "fibres[0].direction", "",
        ElementRecord<Real, Formats>::fibres + ::material::FibreRecord<Real, typename Formats::fibres>::direction, 1,
        0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::fibres::strength, double>(
        "fibres[0].strength", "Pa",
        ElementRecord<Real, Formats>::fibres + ::material::FibreRecord<Real, typename Formats::fibres>::strength, 1,
        0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::fibres::direction, float>(
        "fibres[1].direction", "",
        ElementRecord<Real, Formats>::fibres + 1 * ElementRecord<Real, Formats>::plan_.stride[2] +
            ::material::FibreRecord<Real, typename Formats::fibres>::direction,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::fibres::strength, double>(
        "fibres[1].strength", "Pa",
        ElementRecord<Real, Formats>::fibres + 1 * ElementRecord<Real, Formats>::plan_.stride[2] +
            ::material::FibreRecord<Real, typename Formats::fibres>::strength,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::stamp::time, double>(
        "stamp.time", "s",
        ElementRecord<Real, Formats>::stamp + ::tissue::StampRecord<Real, typename Formats::stamp>::time, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::stamp::step, std::int32_t>(
        "stamp.step", "",
        ElementRecord<Real, Formats>::stamp + ::tissue::StampRecord<Real, typename Formats::stamp>::step, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::shapes::a, Real>(
        "shapes.a", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::a, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::shapes::v, Real>(
        "shapes.v", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::v, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::shapes::nodes, std::int32_t>(
        "shapes.nodes", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::nodes,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::shapes::F, Real>(
        "shapes.F", "1", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::F, 1,
        0.0),
    physgen::field_info<physgen::shape::Matrix<2, 3>, typename Formats::shapes::B, Real>(
        "shapes.B", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::B, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<1, 4>, typename Formats::shapes::row, Real>(
        "shapes.row", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::row, 1,
        0.0),
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::shapes::K, Real>(
        "shapes.K", "N/m", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::K, 1,
        0.0),
    physgen::field_info<physgen::shape::Symmetric<2>, typename Formats::shapes::C2, double>(
        "shapes.C2", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::C2, 1,
        0.0),
    physgen::field_info<physgen::shape::Diagonal<3>, typename Formats::shapes::s, Real>(
        "shapes.s", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::s, 1, 0.0),
    physgen::field_info<physgen::shape::Skew<3>, typename Formats::shapes::W, Real>(
        "shapes.W", "1/s", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::W, 1,
        0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::shapes::U, Real>(
        "shapes.U", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::U, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::shapes::V, float>(
        "shapes.V", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::V, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::shapes::count, std::int32_t>(
        "shapes.count", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::count,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<2, 2>, typename Formats::shapes::M, double>(
        "shapes.M", "", ElementRecord<Real, Formats>::shapes + ShapesRecord<Real, typename Formats::shapes>::M, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::volume, Real>(
        "volume", "m^3", ElementRecord<Real, Formats>::volume, 1, 0.0),
  }};
  template <class Space>
  using Formats = ElementFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = ElementProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<ElementObject, Space>>
using ElementView = physgen::View<ElementObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aosoa<64>>,
          class Formats = physgen::FormatsOf<ElementObject, Space>>
using ElementArray = physgen::Array<ElementObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<ElementObject, float, ElementFormats<physgen::Host>>(
    376, 8, {360, 364, 368, 8, 0, 32, 24, 48, 56, 120, 124, 136, 152, 188, 212, 228, 64, 252, 264, 276, 312, 348, 88,
    372}));
static_assert(physgen::is_sound_record<ElementObject, double, ElementFormats<physgen::Host>>(
    564, 8, {560, 0, 8, 24, 16, 48, 40, 64, 72, 80, 88, 488, 112, 184, 232, 264, 312, 336, 360, 384, 504, 540, 456,
    552}));

}  // namespace tissue::model

namespace tissue::other {

// ---- Patch ----------------------------------------------------------------------------------------------------------

/// The value of one Patch.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Patch {
  ::tissue::model::Element<Real> elements[2];
  physgen::same_lanes_t<Real, float> weight;
  ::tissue::model::Options<Real> options;
};

/// How the fields of one Patch are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of PatchArray.
template <class Space>
struct PatchFormats {
  using elements = ::tissue::model::ElementFormats<Space>;
  using weight = physgen::format::Native;
  using options = ::tissue::model::OptionsFormats<Space>;
};

struct PatchObject;
/// PatchFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see <physgen/probe.h>.
/// The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = PatchFormats<physgen::Host>, class Object = PatchObject, int first = 0>
struct PatchProbe {
  using array_ = ArrayTag;
  using elements = ::tissue::model::ElementProbe<ArrayTag, typename Base::elements, Object, first + 0>;
  using weight = physgen::Probe<ArrayTag, Object, first + 48, typename Base::weight>;
  using options = ::tissue::model::OptionsProbe<ArrayTag, typename Base::options, Object, first + 49>;
};

/// Where each field begins in the record of one Patch [bytes].
template <class Real, class Formats>
struct PatchRecord {
  static constexpr auto plan_ = physgen::plan_record<3>({{
    physgen::nested_slot<::tissue::model::ElementRecord<Real, typename Formats::elements>>(2),
    physgen::slot<physgen::shape::Scalar, typename Formats::weight, float>(),
    physgen::nested_slot<::tissue::model::OptionsRecord<Real, typename Formats::options>>(),
  }});
  static constexpr int elements = plan_.offset[0];
  static constexpr int weight = plan_.offset[1];
  static constexpr int options = plan_.offset[2];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Patch of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class PatchRef {
  using Record = PatchRecord<Real, Formats>;

 public:
  using Value = Patch<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PatchRef(const Cursor& cursor) : at_(cursor) {}
  PatchRef(const PatchRef&) = default;
  PatchRef& operator=(const PatchRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const PatchRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION ::tissue::model::ElementRef<Real, typename Formats::elements, Cursor> elements(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::other::Patch::elements");
    return ::tissue::model::ElementRef<Real, typename Formats::elements, Cursor>(
        at_.nested(Record::elements + entry * Record::plan_.stride[0]));
  }
  PHYSGEN_FUNCTION decltype(auto) weight() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::weight, float>(Record::weight);
  }
  PHYSGEN_FUNCTION ::tissue::model::OptionsRef<Real, typename Formats::options, Cursor> options() const {
    return ::tissue::model::OptionsRef<Real, typename Formats::options, Cursor>(at_.nested(Record::options));
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 2; ++entry) value.elements[entry] = elements(entry).get();
    value.weight = weight();
    value.options = options().get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 2; ++entry) elements(entry).put(value.elements[entry]);
    weight() = value.weight;
    options().put(value.options);
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Patch.
struct PatchObject {
  static constexpr std::string_view name = "tissue::other::Patch";
  template <class Real>
  using Value = Patch<Real>;
  template <class Real, class Formats>
  using Record = PatchRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = PatchRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 57> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::flag, std::int32_t>(
        "elements[0].flag", "",
        PatchRecord<Real, Formats>::elements + ::tissue::model::ElementRecord<Real, typename Formats::elements>::flag,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::lame::mu, Real>(
        "elements[0].lame.mu", "Pa",
        PatchRecord<Real, Formats>::elements + ::tissue::model::ElementRecord<Real, typename Formats::elements>::lame +
            ::material::LameRecord<Real, typename Formats::elements::lame>::mu,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::lame::lambda, Real>(
        "elements[0].lame.lambda", "Pa",
        PatchRecord<Real, Formats>::elements + ::tissue::model::ElementRecord<Real, typename Formats::elements>::lame +
            ::material::LameRecord<Real, typename Formats::elements::lame>::lambda,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::elements::fibres::direction, float>(
        "elements[0].fibres[0].direction", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::fibres +
                ::material::FibreRecord<Real, typename Formats::elements::fibres>::direction,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::fibres::strength, double>(
        "elements[0].fibres[0].strength", "Pa",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::fibres +
                ::material::FibreRecord<Real, typename Formats::elements::fibres>::strength,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::elements::fibres::direction, float>(
        "elements[0].fibres[1].direction", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::fibres +
                1 * ::tissue::model::ElementRecord<Real, typename Formats::elements>::plan_.stride[2] +
                    ::material::FibreRecord<Real, typename Formats::elements::fibres>::direction,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::fibres::strength, double>(
        "elements[0].fibres[1].strength", "Pa",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::fibres +
                1 * ::tissue::model::ElementRecord<Real, typename Formats::elements>::plan_.stride[2] +
                    ::material::FibreRecord<Real, typename Formats::elements::fibres>::strength,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::stamp::time, double>(
        "elements[0].stamp.time", "s",
        PatchRecord<Real, Formats>::elements + ::tissue::model::ElementRecord<Real, typename Formats::elements>::stamp +
            ::tissue::StampRecord<Real, typename Formats::elements::stamp>::time,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::stamp::step, std::int32_t>(
        "elements[0].stamp.step", "",
        PatchRecord<Real, Formats>::elements + ::tissue::model::ElementRecord<Real, typename Formats::elements>::stamp +
            ::tissue::StampRecord<Real, typename Formats::elements::stamp>::step,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::shapes::a, Real>(
        "elements[0].shapes.a", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::a,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::elements::shapes::v, Real>(
        "elements[0].shapes.v", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::v,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::elements::shapes::nodes, std::int32_t>(
        "elements[0].shapes.nodes", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::nodes,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::elements::shapes::F, Real>(
        "elements[0].shapes.F", "1",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::F,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<2, 3>, typename Formats::elements::shapes::B, Real>(
        "elements[0].shapes.B", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::B,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<1, 4>, typename Formats::elements::shapes::row, Real>(
        "elements[0].shapes.row", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::row,
        1, 0.0),
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::elements::shapes::K, Real>(
        "elements[0].shapes.K", "N/m",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::K,
        1, 0.0),
    physgen::field_info<physgen::shape::Symmetric<2>, typename Formats::elements::shapes::C2, double>(
        "elements[0].shapes.C2", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::C2,
        1, 0.0),
    physgen::field_info<physgen::shape::Diagonal<3>, typename Formats::elements::shapes::s, Real>(
        "elements[0].shapes.s", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::s,
        1, 0.0),
    physgen::field_info<physgen::shape::Skew<3>, typename Formats::elements::shapes::W, Real>(
        "elements[0].shapes.W", "1/s",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::W,
        1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::elements::shapes::U, Real>(
        "elements[0].shapes.U", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::U,
        1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::elements::shapes::V, float>(
        "elements[0].shapes.V", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::V,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::elements::shapes::count, std::int32_t>(
        "elements[0].shapes.count", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::count,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<2, 2>, typename Formats::elements::shapes::M, double>(
        "elements[0].shapes.M", "",
        PatchRecord<Real, Formats>::elements +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::M,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::volume, Real>(
        "elements[0].volume", "m^3",
        PatchRecord<Real, Formats>::elements + ::tissue::model::ElementRecord<Real, typename Formats::elements>::volume,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::flag, std::int32_t>(
        "elements[1].flag", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::flag,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::lame::mu, Real>(
        "elements[1].lame.mu", "Pa",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::lame +
                ::material::LameRecord<Real, typename Formats::elements::lame>::mu,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::lame::lambda, Real>(
        "elements[1].lame.lambda", "Pa",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::lame +
                ::material::LameRecord<Real, typename Formats::elements::lame>::lambda,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::elements::fibres::direction, float>(
        "elements[1].fibres[0].direction", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::fibres +
                ::material::FibreRecord<Real, typename Formats::elements::fibres>::direction,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::fibres::strength, double>(
        "elements[1].fibres[0].strength", "Pa",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::fibres +
                ::material::FibreRecord<Real, typename Formats::elements::fibres>::strength,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::elements::fibres::direction, float>(
        "elements[1].fibres[1].direction", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::fibres +
                1 * ::tissue::model::ElementRecord<Real, typename Formats::elements>::plan_.stride[2] +
                    ::material::FibreRecord<Real, typename Formats::elements::fibres>::direction,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::fibres::strength, double>(
        "elements[1].fibres[1].strength", "Pa",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::fibres +
                1 * ::tissue::model::ElementRecord<Real, typename Formats::elements>::plan_.stride[2] +
                    ::material::FibreRecord<Real, typename Formats::elements::fibres>::strength,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::stamp::time, double>(
        "elements[1].stamp.time", "s",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::stamp +
                ::tissue::StampRecord<Real, typename Formats::elements::stamp>::time,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::stamp::step, std::int32_t>(
        "elements[1].stamp.step", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::stamp +
                ::tissue::StampRecord<Real, typename Formats::elements::stamp>::step,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::shapes::a, Real>(
        "elements[1].shapes.a", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::a,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::elements::shapes::v, Real>(
        "elements[1].shapes.v", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::v,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<4>, typename Formats::elements::shapes::nodes, std::int32_t>(
        "elements[1].shapes.nodes", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::nodes,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::elements::shapes::F, Real>(
        "elements[1].shapes.F", "1",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::F,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<2, 3>, typename Formats::elements::shapes::B, Real>(
        "elements[1].shapes.B", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::B,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<1, 4>, typename Formats::elements::shapes::row, Real>(
        "elements[1].shapes.row", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::row,
        1, 0.0),
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::elements::shapes::K, Real>(
        "elements[1].shapes.K", "N/m",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::K,
        1, 0.0),
    physgen::field_info<physgen::shape::Symmetric<2>, typename Formats::elements::shapes::C2, double>(
        "elements[1].shapes.C2", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::C2,
        1, 0.0),
    physgen::field_info<physgen::shape::Diagonal<3>, typename Formats::elements::shapes::s, Real>(
        "elements[1].shapes.s", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::s,
        1, 0.0),
    physgen::field_info<physgen::shape::Skew<3>, typename Formats::elements::shapes::W, Real>(
        "elements[1].shapes.W", "1/s",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::W,
        1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::elements::shapes::U, Real>(
        "elements[1].shapes.U", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::U,
        1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::elements::shapes::V, float>(
        "elements[1].shapes.V", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::V,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::elements::shapes::count, std::int32_t>(
        "elements[1].shapes.count", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::count,
        1, 0.0),
    physgen::field_info<physgen::shape::Matrix<2, 2>, typename Formats::elements::shapes::M, double>(
        "elements[1].shapes.M", "",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::shapes +
                ::tissue::model::ShapesRecord<Real, typename Formats::elements::shapes>::M,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::elements::volume, Real>(
        "elements[1].volume", "m^3",
        PatchRecord<Real, Formats>::elements + 1 * PatchRecord<Real, Formats>::plan_.stride[0] +
            ::tissue::model::ElementRecord<Real, typename Formats::elements>::volume,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::weight, float>(
        "weight", "", PatchRecord<Real, Formats>::weight, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::options::density, Real>(
        "options.density", "kg/m^3",
        PatchRecord<Real, Formats>::options + ::tissue::model::OptionsRecord<Real, typename Formats::options>::density,
        1, 1060.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::options::nu, Real>(
        "options.nu", "",
        PatchRecord<Real, Formats>::options + ::tissue::model::OptionsRecord<Real, typename Formats::options>::nu, 1,
        0.45),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::options::direction, Real>(
        "options.direction", "1",
        PatchRecord<Real, Formats>::options +
            ::tissue::model::OptionsRecord<Real, typename Formats::options>::direction,
        1, 0.5),
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::options::metric, Real>(
        "options.metric", "",
        PatchRecord<Real, Formats>::options + ::tissue::model::OptionsRecord<Real, typename Formats::options>::metric,
        1, 1.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::options::label, std::int32_t>(
        "options.label", "",
        PatchRecord<Real, Formats>::options + ::tissue::model::OptionsRecord<Real, typename Formats::options>::label, 1,
        -1.0),
    physgen::field_info<physgen::shape::Vector<2>, typename Formats::options::group, std::int32_t>(
        "options.group", "",
        PatchRecord<Real, Formats>::options + ::tissue::model::OptionsRecord<Real, typename Formats::options>::group, 1,
        7.0),
    physgen::field_info<physgen::shape::Skew<3>, typename Formats::options::spin, Real>(
        "options.spin", "",
        PatchRecord<Real, Formats>::options + ::tissue::model::OptionsRecord<Real, typename Formats::options>::spin, 1,
        0.25),
    physgen::field_info<physgen::shape::Scalar, typename Formats::options::fixed, double>(
        "options.fixed", "",
        PatchRecord<Real, Formats>::options + ::tissue::model::OptionsRecord<Real, typename Formats::options>::fixed, 1,
        1e-12),
  }};
  template <class Space>
  using Formats = PatchFormats<physgen::Host>;
  template <class ArrayTag, class Base>
  using Probe = PatchProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<PatchObject, Space>>
using PatchView = physgen::View<PatchObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchObject, Space>>
using PatchArray = physgen::Array<PatchObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<PatchObject, float, PatchFormats<physgen::Host>>(
    836, 8, {360, 364, 368, 8, 0, 32, 24, 48, 56, 120, 124, 136, 152, 188, 212, 228, 64, 252, 264, 276, 312, 348, 88,
    372, 736, 740, 744, 384, 376, 408, 400, 424, 432, 496, 500, 512, 528, 564, 588, 604, 440, 628, 640, 652, 688, 724,
    464, 748, 832, 760, 764, 768, 780, 804, 808, 816, 752}));
static_assert(physgen::is_sound_record<PatchObject, double, PatchFormats<physgen::Host>>(
    1276, 8, {560, 0, 8, 24, 16, 48, 40, 64, 72, 80, 88, 488, 112, 184, 232, 264, 312, 336, 360, 384, 504, 540, 456,
    552, 1128, 568, 576, 592, 584, 616, 608, 632, 640, 648, 656, 1056, 680, 752, 800, 832, 880, 904, 928, 952, 1072,
    1108, 1024, 1120, 1272, 1136, 1144, 1152, 1176, 1256, 1260, 1224, 1248}));

}  // namespace tissue::other

namespace tissue::model {

// ---- Frame ----------------------------------------------------------------------------------------------------------

/// A place and a direction, compact on CUDA.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Frame {
  /// Rotation, 9 stored. Stored on the host as unit quaternion, error of an entry up to 10 eps; on CUDA as unit
  /// quaternion of 16-bit steps, error of an entry up to 9e-5.
  Eigen::Matrix<Real, 3, 3> turn;
  /// [m]. Stored on CUDA as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  Eigen::Matrix<Real, 3, 1> origin;
  /// Range [0, 1]; initially 0.25. Stored as 16-bit steps over [0, 1], error up to 7.7e-06.
  Real weight = physgen::all_lanes<Real>(0.25);
};

/// How the fields of one Frame are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of FrameArray.
template <class Space>
struct FrameFormats {
  using turn = physgen::PerSpace<Space, physgen::format::Quaternion<>, physgen::format::Quaternion16>;
  using origin = physgen::PerSpace<Space, physgen::format::Native, physgen::format::Half<>>;
  using weight = physgen::format::Snorm16<physgen::format::Interval{0.0, 1.0}>;
};

struct FrameObject;
/// FrameFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see <physgen/probe.h>.
/// The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = FrameFormats<physgen::Host>, class Object = FrameObject, int first = 0>
struct FrameProbe {
  using array_ = ArrayTag;
  using turn = physgen::Probe<ArrayTag, Object, first + 0, typename Base::turn>;
  using origin = physgen::Probe<ArrayTag, Object, first + 1, typename Base::origin>;
  using weight = physgen::Probe<ArrayTag, Object, first + 2, typename Base::weight>;
};

/// Where each field begins in the record of one Frame [bytes].
template <class Real, class Formats>
struct FrameRecord {
  static constexpr auto plan_ = physgen::plan_record<3>({{
    physgen::slot<physgen::shape::Rotation, typename Formats::turn, Real>(),
    physgen::slot<physgen::shape::Vector<3>, typename Formats::origin, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::weight, Real>(),
  }});
  static constexpr int turn = plan_.offset[0];
  static constexpr int origin = plan_.offset[1];
  static constexpr int weight = plan_.offset[2];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Frame of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class FrameRef {
  using Record = FrameRecord<Real, Formats>;

 public:
  using Value = Frame<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit FrameRef(const Cursor& cursor) : at_(cursor) {}
  FrameRef(const FrameRef&) = default;
  FrameRef& operator=(const FrameRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const FrameRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Rotation, 9 stored. Stored on the host as unit quaternion, error of an entry up to 10 eps; on CUDA as unit
  /// quaternion of 16-bit steps, error of an entry up to 9e-5.
  PHYSGEN_FUNCTION decltype(auto) turn() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::turn, Real>(Record::turn);
  }
  /// [m]. Stored on CUDA as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) origin() const {
    return at_.template field<physgen::shape::Vector<3>, typename Formats::origin, Real>(Record::origin);
  }
  /// Range [0, 1]; initially 0.25. Stored as 16-bit steps over [0, 1], error up to 7.7e-06.
  PHYSGEN_FUNCTION decltype(auto) weight() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::weight, Real>(Record::weight);
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.turn = turn().get();
    value.origin = origin().get();
    value.weight = weight();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    turn() = value.turn;
    origin() = value.origin;
    weight() = value.weight;
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Frame.
struct FrameObject {
  static constexpr std::string_view name = "tissue::model::Frame";
  template <class Real>
  using Value = Frame<Real>;
  template <class Real, class Formats>
  using Record = FrameRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = FrameRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 3> fields = {{
    physgen::field_info<physgen::shape::Rotation, typename Formats::turn, Real>(
        "turn", "", FrameRecord<Real, Formats>::turn, 1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::origin, Real>(
        "origin", "m", FrameRecord<Real, Formats>::origin, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::weight, Real>(
        "weight", "", FrameRecord<Real, Formats>::weight, 1, 0.25),
  }};
  template <class Space>
  using Formats = FrameFormats<Space>;
  template <class ArrayTag, class Base>
  using Probe = FrameProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<FrameObject, Space>>
using FrameView = physgen::View<FrameObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<FrameObject, Space>>
using FrameArray = physgen::Array<FrameObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<FrameObject, float, FrameFormats<physgen::Host>>(30, 4, {0, 16, 28}));
static_assert(physgen::is_sound_record<FrameObject, double, FrameFormats<physgen::Host>>(58, 8, {0, 32, 56}));
static_assert(physgen::is_sound_record<FrameObject, float, FrameFormats<physgen::Cuda>>(16, 2, {0, 8, 14}));
static_assert(physgen::is_sound_record<FrameObject, double, FrameFormats<physgen::Cuda>>(16, 2, {0, 8, 14}));

// ---- Stored ---------------------------------------------------------------------------------------------------------

/// Every storage format.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Stored {
  /// Stored as float, relative error up to 6e-8.
  Real single;
  /// Stored as double, relative error up to 1.2e-16.
  Real twice;
  /// Stored as float, relative error up to 6e-8.
  physgen::same_lanes_t<Real, double> narrowed;
  /// Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  Real plain_half;
  /// External force. [N] Range [0, 1e+06]; initially 1000. Stored as half, relative error up to 4.9e-4 for sizes from
  /// 0.002 to 2.1e+06.
  Real load = physgen::all_lanes<Real>(1000.0);
  /// Stored as bfloat16, relative error up to 3.9e-3.
  Real wide;
  /// [rad]. Range [-3.25, 3.25]; initially 0.5. Stored as 16-bit steps over [-3.25, 3.25], error up to 5e-05.
  Real angle = physgen::all_lanes<Real>(0.5);
  /// [K]. Range [273, 373]; initially 310. Stored on CUDA as 16-bit steps over [273, 373], error up to 0.00081.
  Real temperature = physgen::all_lanes<Real>(310.0);
  /// [Pa]. Symmetric, 6 stored. Range [-1e+07, 1e+07]. Stored on the host as half, relative error up to 4.9e-4 for
  /// sizes from 0.031 to 3.4e+07; on CUDA as bfloat16, relative error up to 3.9e-3.
  Eigen::Matrix<Real, 3, 3> stress;
  /// Stored on CUDA as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  Eigen::Matrix<Real, 3, 3> F;
  /// Diagonal, 3 stored. Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  Eigen::Matrix<Real, 3, 1> stretch;
  /// Skew-symmetric, 3 stored. Range [-8, 8]. Stored as 16-bit steps over [-8, 8], error up to 0.00013.
  Eigen::Matrix<Real, 3, 3> spin;
  /// Rotation, 9 stored. Stored on CUDA as unit quaternion, error of an entry up to 10 eps.
  Eigen::Matrix<Real, 3, 3> R;
  /// Rotation, 9 stored. Stored as unit quaternion of floats, error of an entry up to 1.2e-6.
  Eigen::Matrix<Real, 3, 3> R32;
  /// Rotation, 9 stored. Stored as unit quaternion of doubles, error of an entry up to 10 eps.
  Eigen::Matrix<Real, 3, 3> R64;
  /// Rotation, 9 stored. Stored as unit quaternion of halves, error of an entry up to 2e-3.
  Eigen::Matrix<Real, 3, 3> Rhalf;
  /// Rotation, 9 stored. Stored as unit quaternion of bfloat16, error of an entry up to 1.6e-2.
  Eigen::Matrix<Real, 3, 3> Rbfloat;
  /// Rotation, 9 stored. Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.
  Eigen::Matrix<Real, 3, 3> R16;
  /// Rotation, 9 stored. Stored on the host as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04; on
  /// CUDA as 16-bit steps over [-1, 1], error up to 1.6e-05.
  Eigen::Matrix<Real, 3, 3> entries;
  /// Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  Real halves[5];
  /// Rotation, 9 stored. Stored as unit quaternion of halves, error of an entry up to 2e-3.
  Eigen::Matrix<Real, 3, 3> turns[3];
  /// Rotation, 9 stored. Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.
  Eigen::Matrix<Real, 3, 3> many[33];
  /// Initially 7.
  physgen::same_lanes_t<Real, std::int32_t> count = 7;
  Frame<Real> frame;
  Frame<Real> frames[2];
};

/// How the fields of one Stored are stored in a memory space. To store some otherwise, derive from it, declare those
/// anew, and name the derived struct as the last argument of StoredArray.
template <class Space>
struct StoredFormats {
  using single = physgen::format::Float32;
  using twice = physgen::format::Float64;
  using narrowed = physgen::format::Float32;
  using plain_half = physgen::format::Half<>;
  using load = physgen::format::Half<5>;
  using wide = physgen::format::Bfloat16;
  using angle = physgen::format::Snorm16<physgen::format::Interval{-3.25, 3.25}>;
  using temperature = physgen::PerSpace<Space, physgen::format::Native,
                                               physgen::format::Snorm16<physgen::format::Interval{273.0, 373.0}>>;
  using stress = physgen::PerSpace<Space, physgen::format::Half<9>, physgen::format::Bfloat16>;
  using F = physgen::PerSpace<Space, physgen::format::Native, physgen::format::Half<>>;
  using stretch = physgen::format::Half<>;
  using spin = physgen::format::Snorm16<physgen::format::Interval{-8.0, 8.0}>;
  using R = physgen::PerSpace<Space, physgen::format::Native, physgen::format::Quaternion<>>;
  using R32 = physgen::format::Quaternion<physgen::format::Float32>;
  using R64 = physgen::format::Quaternion<physgen::format::Float64>;
  using Rhalf = physgen::format::Quaternion<physgen::format::Half<>>;
  using Rbfloat = physgen::format::Quaternion<physgen::format::Bfloat16>;
  using R16 = physgen::format::Quaternion16;
  using entries = physgen::PerSpace<Space, physgen::format::Half<>,
                                           physgen::format::Snorm16<physgen::format::Interval{-1.0, 1.0}>>;
  using halves = physgen::format::Half<>;
  using turns = physgen::format::Quaternion<physgen::format::Half<>>;
  using many = physgen::format::Quaternion16;
  using count = physgen::format::Native;
  using frame = FrameFormats<Space>;
  using frames = FrameFormats<Space>;
};

struct StoredObject;
/// StoredFormats whose reads and writes are told apart for the array that the tag ArrayTag names; see
/// <physgen/probe.h>. The list of fields of Object has the first of these as number first.
template <class ArrayTag, class Base = StoredFormats<physgen::Host>, class Object = StoredObject, int first = 0>
struct StoredProbe {
  using array_ = ArrayTag;
  using single = physgen::Probe<ArrayTag, Object, first + 0, typename Base::single>;
  using twice = physgen::Probe<ArrayTag, Object, first + 1, typename Base::twice>;
  using narrowed = physgen::Probe<ArrayTag, Object, first + 2, typename Base::narrowed>;
  using plain_half = physgen::Probe<ArrayTag, Object, first + 3, typename Base::plain_half>;
  using load = physgen::Probe<ArrayTag, Object, first + 4, typename Base::load>;
  using wide = physgen::Probe<ArrayTag, Object, first + 5, typename Base::wide>;
  using angle = physgen::Probe<ArrayTag, Object, first + 6, typename Base::angle>;
  using temperature = physgen::Probe<ArrayTag, Object, first + 7, typename Base::temperature>;
  using stress = physgen::Probe<ArrayTag, Object, first + 8, typename Base::stress>;
  using F = physgen::Probe<ArrayTag, Object, first + 9, typename Base::F>;
  using stretch = physgen::Probe<ArrayTag, Object, first + 10, typename Base::stretch>;
  using spin = physgen::Probe<ArrayTag, Object, first + 11, typename Base::spin>;
  using R = physgen::Probe<ArrayTag, Object, first + 12, typename Base::R>;
  using R32 = physgen::Probe<ArrayTag, Object, first + 13, typename Base::R32>;
  using R64 = physgen::Probe<ArrayTag, Object, first + 14, typename Base::R64>;
  using Rhalf = physgen::Probe<ArrayTag, Object, first + 15, typename Base::Rhalf>;
  using Rbfloat = physgen::Probe<ArrayTag, Object, first + 16, typename Base::Rbfloat>;
  using R16 = physgen::Probe<ArrayTag, Object, first + 17, typename Base::R16>;
  using entries = physgen::Probe<ArrayTag, Object, first + 18, typename Base::entries>;
  using halves = physgen::Probe<ArrayTag, Object, first + 19, typename Base::halves>;
  using turns = physgen::Probe<ArrayTag, Object, first + 20, typename Base::turns>;
  using many = physgen::Probe<ArrayTag, Object, first + 21, typename Base::many>;
  using count = physgen::Probe<ArrayTag, Object, first + 22, typename Base::count>;
  using frame = FrameProbe<ArrayTag, typename Base::frame, Object, first + 23>;
  using frames = FrameProbe<ArrayTag, typename Base::frames, Object, first + 26>;
};

/// Where each field begins in the record of one Stored [bytes].
template <class Real, class Formats>
struct StoredRecord {
  static constexpr auto plan_ = physgen::plan_record<25>({{
    physgen::slot<physgen::shape::Scalar, typename Formats::single, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::twice, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::narrowed, double>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::plain_half, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::load, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::wide, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::angle, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::temperature, Real>(),
    physgen::slot<physgen::shape::Symmetric<3>, typename Formats::stress, Real>(),
    physgen::slot<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(),
    physgen::slot<physgen::shape::Diagonal<3>, typename Formats::stretch, Real>(),
    physgen::slot<physgen::shape::Skew<3>, typename Formats::spin, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::R, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::R32, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::R64, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::Rhalf, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::Rbfloat, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::R16, Real>(),
    physgen::slot<physgen::shape::Rotation, typename Formats::entries, Real>(),
    physgen::slot<physgen::shape::Scalar, typename Formats::halves, Real>(5),
    physgen::slot<physgen::shape::Rotation, typename Formats::turns, Real>(3),
    physgen::slot<physgen::shape::Rotation, typename Formats::many, Real>(33),
    physgen::slot<physgen::shape::Scalar, typename Formats::count, std::int32_t>(),
    physgen::nested_slot<FrameRecord<Real, typename Formats::frame>>(),
    physgen::nested_slot<FrameRecord<Real, typename Formats::frames>>(2),
  }});
  static constexpr int single = plan_.offset[0];
  static constexpr int twice = plan_.offset[1];
  static constexpr int narrowed = plan_.offset[2];
  static constexpr int plain_half = plan_.offset[3];
  static constexpr int load = plan_.offset[4];
  static constexpr int wide = plan_.offset[5];
  static constexpr int angle = plan_.offset[6];
  static constexpr int temperature = plan_.offset[7];
  static constexpr int stress = plan_.offset[8];
  static constexpr int F = plan_.offset[9];
  static constexpr int stretch = plan_.offset[10];
  static constexpr int spin = plan_.offset[11];
  static constexpr int R = plan_.offset[12];
  static constexpr int R32 = plan_.offset[13];
  static constexpr int R64 = plan_.offset[14];
  static constexpr int Rhalf = plan_.offset[15];
  static constexpr int Rbfloat = plan_.offset[16];
  static constexpr int R16 = plan_.offset[17];
  static constexpr int entries = plan_.offset[18];
  static constexpr int halves = plan_.offset[19];
  static constexpr int turns = plan_.offset[20];
  static constexpr int many = plan_.offset[21];
  static constexpr int count = plan_.offset[22];
  static constexpr int frame = plan_.offset[23];
  static constexpr int frames = plan_.offset[24];
  static constexpr int bytes = plan_.bytes;
  static constexpr int alignment = plan_.alignment;
};

/// One Stored of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Formats, class Cursor>
class StoredRef {
  using Record = StoredRecord<Real, Formats>;

 public:
  using Value = Stored<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StoredRef(const Cursor& cursor) : at_(cursor) {}
  StoredRef(const StoredRef&) = default;
  StoredRef& operator=(const StoredRef&) & = delete;
  PHYSGEN_FUNCTION decltype(auto) operator=(const StoredRef&& other) const& { return physgen::assign(*this, other); }
  template <physgen::ReadsAs<Value> Other>
  PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& other) const& { return physgen::assign(*this, other); }

  /// Stored as float, relative error up to 6e-8.
  PHYSGEN_FUNCTION decltype(auto) single() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::single, Real>(Record::single);
  }
  /// Stored as double, relative error up to 1.2e-16.
  PHYSGEN_FUNCTION decltype(auto) twice() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::twice, Real>(Record::twice);
  }
  /// Stored as float, relative error up to 6e-8.
  PHYSGEN_FUNCTION decltype(auto) narrowed() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::narrowed, double>(Record::narrowed);
  }
  /// Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) plain_half() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::plain_half, Real>(Record::plain_half);
  }
  /// External force. [N] Range [0, 1e+06]; initially 1000. Stored as half, relative error up to 4.9e-4 for sizes from
  /// 0.002 to 2.1e+06.
  PHYSGEN_FUNCTION decltype(auto) load() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::load, Real>(Record::load);
  }
  /// Stored as bfloat16, relative error up to 3.9e-3.
  PHYSGEN_FUNCTION decltype(auto) wide() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::wide, Real>(Record::wide);
  }
  /// [rad]. Range [-3.25, 3.25]; initially 0.5. Stored as 16-bit steps over [-3.25, 3.25], error up to 5e-05.
  PHYSGEN_FUNCTION decltype(auto) angle() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::angle, Real>(Record::angle);
  }
  /// [K]. Range [273, 373]; initially 310. Stored on CUDA as 16-bit steps over [273, 373], error up to 0.00081.
  PHYSGEN_FUNCTION decltype(auto) temperature() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::temperature, Real>(Record::temperature);
  }
  /// [Pa]. Symmetric, 6 stored. Range [-1e+07, 1e+07]. Stored on the host as half, relative error up to 4.9e-4 for
  /// sizes from 0.031 to 3.4e+07; on CUDA as bfloat16, relative error up to 3.9e-3.
  PHYSGEN_FUNCTION decltype(auto) stress() const {
    return at_.template field<physgen::shape::Symmetric<3>, typename Formats::stress, Real>(Record::stress);
  }
  /// Stored on CUDA as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) F() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(Record::F);
  }
  /// Diagonal, 3 stored. Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) stretch() const {
    return at_.template field<physgen::shape::Diagonal<3>, typename Formats::stretch, Real>(Record::stretch);
  }
  /// Skew-symmetric, 3 stored. Range [-8, 8]. Stored as 16-bit steps over [-8, 8], error up to 0.00013.
  PHYSGEN_FUNCTION decltype(auto) spin() const {
    return at_.template field<physgen::shape::Skew<3>, typename Formats::spin, Real>(Record::spin);
  }
  /// Rotation, 9 stored. Stored on CUDA as unit quaternion, error of an entry up to 10 eps.
  PHYSGEN_FUNCTION decltype(auto) R() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::R, Real>(Record::R);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of floats, error of an entry up to 1.2e-6.
  PHYSGEN_FUNCTION decltype(auto) R32() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::R32, Real>(Record::R32);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of doubles, error of an entry up to 10 eps.
  PHYSGEN_FUNCTION decltype(auto) R64() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::R64, Real>(Record::R64);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of halves, error of an entry up to 2e-3.
  PHYSGEN_FUNCTION decltype(auto) Rhalf() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::Rhalf, Real>(Record::Rhalf);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of bfloat16, error of an entry up to 1.6e-2.
  PHYSGEN_FUNCTION decltype(auto) Rbfloat() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::Rbfloat, Real>(Record::Rbfloat);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.
  PHYSGEN_FUNCTION decltype(auto) R16() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::R16, Real>(Record::R16);
  }
  /// Rotation, 9 stored. Stored on the host as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04; on
  /// CUDA as 16-bit steps over [-1, 1], error up to 1.6e-05.
  PHYSGEN_FUNCTION decltype(auto) entries() const {
    return at_.template field<physgen::shape::Rotation, typename Formats::entries, Real>(Record::entries);
  }
  /// Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  /// @pre 0 <= entry < 5
  PHYSGEN_FUNCTION decltype(auto) halves(int entry) const {
    physgen::check_inner(entry, 5, "an entry of tissue::model::Stored::halves");
    return at_.template field<physgen::shape::Scalar, typename Formats::halves, Real>(
        Record::halves + entry * Record::plan_.stride[19]);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of halves, error of an entry up to 2e-3.
  /// @pre 0 <= entry < 3
  PHYSGEN_FUNCTION decltype(auto) turns(int entry) const {
    physgen::check_inner(entry, 3, "an entry of tissue::model::Stored::turns");
    return at_.template field<physgen::shape::Rotation, typename Formats::turns, Real>(
        Record::turns + entry * Record::plan_.stride[20]);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.
  /// @pre 0 <= entry < 33
  PHYSGEN_FUNCTION decltype(auto) many(int entry) const {
    physgen::check_inner(entry, 33, "an entry of tissue::model::Stored::many");
    return at_.template field<physgen::shape::Rotation, typename Formats::many, Real>(
        Record::many + entry * Record::plan_.stride[21]);
  }
  /// Initially 7.
  PHYSGEN_FUNCTION decltype(auto) count() const {
    return at_.template field<physgen::shape::Scalar, typename Formats::count, std::int32_t>(Record::count);
  }
  PHYSGEN_FUNCTION FrameRef<Real, typename Formats::frame, Cursor> frame() const {
    return FrameRef<Real, typename Formats::frame, Cursor>(at_.nested(Record::frame));
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION FrameRef<Real, typename Formats::frames, Cursor> frames(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Stored::frames");
    return FrameRef<Real, typename Formats::frames, Cursor>(
        at_.nested(Record::frames + entry * Record::plan_.stride[24]));
  }

  PHYSGEN_FUNCTION const Value get() const {
    Value value;
    value.single = single();
    value.twice = twice();
    value.narrowed = narrowed();
    value.plain_half = plain_half();
    value.load = load();
    value.wide = wide();
    value.angle = angle();
    value.temperature = temperature();
    value.stress = stress().get();
    value.F = F().get();
    value.stretch = stretch().get();
    value.spin = spin().get();
    value.R = R().get();
    value.R32 = R32().get();
    value.R64 = R64().get();
    value.Rhalf = Rhalf().get();
    value.Rbfloat = Rbfloat().get();
    value.R16 = R16().get();
    value.entries = entries().get();
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 5; ++entry) value.halves[entry] = halves(entry);
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 3; ++entry) value.turns[entry] = turns(entry).get();
    for (int entry = 0; entry < 33; ++entry) value.many[entry] = many(entry).get();
    value.count = count();
    value.frame = frame().get();
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 2; ++entry) value.frames[entry] = frames(entry).get();
    return value;
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    single() = value.single;
    twice() = value.twice;
    narrowed() = value.narrowed;
    plain_half() = value.plain_half;
    load() = value.load;
    wide() = value.wide;
    angle() = value.angle;
    temperature() = value.temperature;
    stress() = value.stress;
    F() = value.F;
    stretch() = value.stretch;
    spin() = value.spin;
    R() = value.R;
    R32() = value.R32;
    R64() = value.R64;
    Rhalf() = value.Rhalf;
    Rbfloat() = value.Rbfloat;
    R16() = value.R16;
    entries() = value.entries;
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 5; ++entry) halves(entry) = value.halves[entry];
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 3; ++entry) turns(entry) = value.turns[entry];
    for (int entry = 0; entry < 33; ++entry) many(entry) = value.many[entry];
    count() = value.count;
    frame().put(value.frame);
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 2; ++entry) frames(entry).put(value.frames[entry]);
  }

 private:
  Cursor at_;
};

/// What the runtime knows of Stored.
struct StoredObject {
  static constexpr std::string_view name = "tissue::model::Stored";
  template <class Real>
  using Value = Stored<Real>;
  template <class Real, class Formats>
  using Record = StoredRecord<Real, Formats>;
  template <class Real, class Formats, class Cursor>
  using Ref = StoredRef<Real, Formats, Cursor>;
  template <class Real, class Formats>
  static constexpr std::array<physgen::FieldInfo, 32> fields = {{
    physgen::field_info<physgen::shape::Scalar, typename Formats::single, Real>(
        "single", "", StoredRecord<Real, Formats>::single, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::twice, Real>(
        "twice", "", StoredRecord<Real, Formats>::twice, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::narrowed, double>(
        "narrowed", "", StoredRecord<Real, Formats>::narrowed, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::plain_half, Real>(
        "plain_half", "", StoredRecord<Real, Formats>::plain_half, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::load, Real>(
        "load", "N", StoredRecord<Real, Formats>::load, 1, 1000.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::wide, Real>(
        "wide", "", StoredRecord<Real, Formats>::wide, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::angle, Real>(
        "angle", "rad", StoredRecord<Real, Formats>::angle, 1, 0.5),
    physgen::field_info<physgen::shape::Scalar, typename Formats::temperature, Real>(
        "temperature", "K", StoredRecord<Real, Formats>::temperature, 1, 310.0),
    physgen::field_info<physgen::shape::Symmetric<3>, typename Formats::stress, Real>(
        "stress", "Pa", StoredRecord<Real, Formats>::stress, 1, 0.0),
    physgen::field_info<physgen::shape::Matrix<3, 3>, typename Formats::F, Real>(
        "F", "", StoredRecord<Real, Formats>::F, 1, 0.0),
    physgen::field_info<physgen::shape::Diagonal<3>, typename Formats::stretch, Real>(
        "stretch", "", StoredRecord<Real, Formats>::stretch, 1, 0.0),
    physgen::field_info<physgen::shape::Skew<3>, typename Formats::spin, Real>(
        "spin", "", StoredRecord<Real, Formats>::spin, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::R, Real>(
        "R", "", StoredRecord<Real, Formats>::R, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::R32, Real>(
        "R32", "", StoredRecord<Real, Formats>::R32, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::R64, Real>(
        "R64", "", StoredRecord<Real, Formats>::R64, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::Rhalf, Real>(
        "Rhalf", "", StoredRecord<Real, Formats>::Rhalf, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::Rbfloat, Real>(
        "Rbfloat", "", StoredRecord<Real, Formats>::Rbfloat, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::R16, Real>(
        "R16", "", StoredRecord<Real, Formats>::R16, 1, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::entries, Real>(
        "entries", "", StoredRecord<Real, Formats>::entries, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::halves, Real>(
        "halves", "", StoredRecord<Real, Formats>::halves, 5, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::turns, Real>(
        "turns", "", StoredRecord<Real, Formats>::turns, 3, 0.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::many, Real>(
        "many", "", StoredRecord<Real, Formats>::many, 33, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::count, std::int32_t>(
        "count", "", StoredRecord<Real, Formats>::count, 1, 7.0),
    physgen::field_info<physgen::shape::Rotation, typename Formats::frame::turn, Real>(
        "frame.turn", "", StoredRecord<Real, Formats>::frame + FrameRecord<Real, typename Formats::frame>::turn, 1,
        0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::frame::origin, Real>(
        "frame.origin", "m", StoredRecord<Real, Formats>::frame + FrameRecord<Real, typename Formats::frame>::origin, 1,
        0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::frame::weight, Real>(
        "frame.weight", "", StoredRecord<Real, Formats>::frame + FrameRecord<Real, typename Formats::frame>::weight, 1,
        0.25),
    physgen::field_info<physgen::shape::Rotation, typename Formats::frames::turn, Real>(
        "frames[0].turn", "", StoredRecord<Real, Formats>::frames + FrameRecord<Real, typename Formats::frames>::turn,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::frames::origin, Real>(
        "frames[0].origin", "m",
        StoredRecord<Real, Formats>::frames + FrameRecord<Real, typename Formats::frames>::origin, 1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::frames::weight, Real>(
        "frames[0].weight", "",
        StoredRecord<Real, Formats>::frames + FrameRecord<Real, typename Formats::frames>::weight, 1, 0.25),
    physgen::field_info<physgen::shape::Rotation, typename Formats::frames::turn, Real>(
        "frames[1].turn", "",
        StoredRecord<Real, Formats>::frames + 1 * StoredRecord<Real, Formats>::plan_.stride[24] +
            FrameRecord<Real, typename Formats::frames>::turn,
        1, 0.0),
    physgen::field_info<physgen::shape::Vector<3>, typename Formats::frames::origin, Real>(
        "frames[1].origin", "m",
        StoredRecord<Real, Formats>::frames + 1 * StoredRecord<Real, Formats>::plan_.stride[24] +
            FrameRecord<Real, typename Formats::frames>::origin,
        1, 0.0),
    physgen::field_info<physgen::shape::Scalar, typename Formats::frames::weight, Real>(
        "frames[1].weight", "",
        StoredRecord<Real, Formats>::frames + 1 * StoredRecord<Real, Formats>::plan_.stride[24] +
            FrameRecord<Real, typename Formats::frames>::weight,
        1, 0.25),
  }};
  template <class Space>
  using Formats = StoredFormats<Space>;
  template <class ArrayTag, class Base>
  using Probe = StoredProbe<ArrayTag, Base>;
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StoredObject, Space>>
using StoredView = physgen::View<StoredObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<8>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StoredObject, Space>>
using StoredArray = physgen::Array<StoredObject, Real, Space, Layout, Formats>;

// Proved by physgen for every layout and every number of objects, and compared with what the compiler finds: bytes and
// alignment of the record, offsets of the fields; no two channels share a byte, each is aligned to its elements and
// lies inside its tile.
static_assert(physgen::is_sound_record<StoredObject, float, StoredFormats<physgen::Host>>(
    612, 8, {40, 0, 44, 240, 242, 244, 246, 48, 248, 52, 260, 266, 88, 124, 8, 272, 280, 288, 296, 314, 324, 348, 140,
    144, 160, 172, 176, 192, 204, 208, 224, 236}));
static_assert(physgen::is_sound_record<StoredObject, double, StoredFormats<physgen::Host>>(
    784, 8, {384, 0, 388, 412, 414, 416, 418, 8, 420, 16, 432, 438, 88, 392, 160, 444, 452, 460, 468, 486, 496, 520,
    408, 192, 224, 248, 256, 288, 312, 320, 352, 376}));
static_assert(physgen::is_sound_record<StoredObject, float, StoredFormats<physgen::Cuda>>(
    524, 8, {40, 0, 44, 84, 86, 88, 90, 92, 94, 106, 124, 130, 48, 64, 8, 136, 144, 152, 160, 178, 188, 212, 80, 476,
    484, 490, 492, 500, 506, 508, 516, 522}));
static_assert(physgen::is_sound_record<StoredObject, double, StoredFormats<physgen::Cuda>>(
    540, 8, {72, 0, 76, 100, 102, 104, 106, 108, 110, 122, 140, 146, 8, 80, 40, 152, 160, 168, 176, 194, 204, 228, 96,
    492, 500, 506, 508, 516, 522, 524, 532, 538}));

}  // namespace tissue::model

#endif  // PHYSGEN_EVERYTHING_H_26A5FF71BFE41386
