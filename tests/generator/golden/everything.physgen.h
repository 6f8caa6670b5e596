// Accessor classes of the object types in everything.h. Written by physgen: change the schema, not this file.
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
#ifndef PHYSGEN_EVERYTHING_H_895ABB68E92A69F6
#define PHYSGEN_EVERYTHING_H_895ABB68E92A69F6

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 7
#error "everything.physgen.h is for version 7 of the physgen runtime: generate it again with the installed physgen"
#endif
#ifdef PHYSGEN_SCHEMA_H
#error "a program includes everything.physgen.h in place of the schema: remove the #include of the schema"
#endif
#define PHYSGEN_GENERATED_HEADER

#include "materials.physgen.h"

namespace tissue {

// ---- Stamp ----------------------------------------------------------------------------------------------------------

/// A moment, of a namespace around those of the others.
template <class Real>
struct Stamp {
  /// [s]
  physgen::same_lanes_t<Real, double> time = {};
  physgen::same_lanes_t<Real, std::int32_t> step = {};
};

template <class Space>
struct StampFormats {
  using time = physgen::format::Native;
  using step = physgen::format::Native;
};

struct StampObject;
template <class ArrayTag, class Base = StampFormats<physgen::Host>, class Object = StampObject, int first = 0>
struct StampProbe {
  using array_ = ArrayTag;
  using time = physgen::Probe<ArrayTag, Object, first + 0, typename Base::time>;
  using step = physgen::Probe<ArrayTag, Object, first + 1, typename Base::step>;
};

template <class Real, class Formats>
struct StampRecord {
  using time = physgen::StoredField<StampRecord, 0, physgen::shape::Scalar, typename Formats::time, double>;
  using step = physgen::StoredField<StampRecord, 1, physgen::shape::Scalar, typename Formats::step, std::int32_t>;
  using fields_ = physgen::RecordFields<time, step>;
};

template <class Real, class Formats, class Cursor>
struct StampRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = StampRecord<Real, Formats>;
  using Value = Stamp<typename Cursor::template Lanes<Real>>;

  /// [s]
  PHYSGEN_FUNCTION decltype(auto) time() const { return this->field_(typename Record::time(), Record::time::offset); }
  PHYSGEN_FUNCTION decltype(auto) step() const { return this->field_(typename Record::step(), Record::step::offset); }

  PHYSGEN_FUNCTION const Value get() const { return {time(), step()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    time() = value.time;
    step() = value.step;
  }
};

struct StampObject : physgen::ObjectTag<StampObject, Stamp, StampFormats, StampRecord, StampRef, StampProbe> {
  static constexpr std::string_view name = "tissue::Stamp";
  static constexpr std::array<physgen::FieldText, 2> texts = {{{"time", "s"}, {"step"}}};
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<StampObject, Space>>
using StampView = physgen::View<StampObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StampObject, Space>>
using StampArray = physgen::Array<StampObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<StampObject, physgen::Host>({12, 8, {0, 8}}, {12, 8, {0, 8}}));

}  // namespace tissue

namespace tissue::model {

// ---- Shapes ---------------------------------------------------------------------------------------------------------

/// Every structure, with elements of every type.
template <class Real>
struct Shapes {
  /// Scalar.
  Real a = {};
  physgen::MatrixValue<Real, 3, 1> v = decltype(v)::Zero();
  /// corners i, j, k, l
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 4, 1> nodes = decltype(nodes)::Zero();
  /// deformation gradient [1]
  physgen::MatrixValue<Real, 3, 3> F = decltype(F)::Zero();
  physgen::MatrixValue<Real, 2, 3> B = decltype(B)::Zero();
  physgen::MatrixValue<Real, 1, 4> row = decltype(row)::Zero();
  /// [N/m]. Symmetric, 6 stored.
  physgen::MatrixValue<Real, 3, 3> K = decltype(K)::Zero();
  /// Symmetric, 3 stored.
  physgen::MatrixValue<physgen::same_lanes_t<Real, double>, 2, 2> C2 = decltype(C2)::Zero();
  /// Diagonal, 3 stored.
  physgen::MatrixValue<Real, 3, 1> s = decltype(s)::Zero();
  /// [1/s]. Skew-symmetric, 3 stored.
  physgen::MatrixValue<Real, 3, 3> W = decltype(W)::Zero();
  /// principal directions. Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> U = decltype(U)::Identity();
  /// Rotation, 9 stored.
  physgen::MatrixValue<Real, 3, 3> V = decltype(V)::Identity();
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> count = decltype(count)::Zero();
  physgen::MatrixValue<physgen::same_lanes_t<Real, double>, 2, 2> M = decltype(M)::Zero();
};

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

template <class Real, class Formats>
struct ShapesRecord {
  using a = physgen::StoredField<ShapesRecord, 0, physgen::shape::Scalar, typename Formats::a, Real>;
  using v = physgen::StoredField<ShapesRecord, 1, physgen::shape::Vector<3>, typename Formats::v, Real>;
  using nodes = physgen::StoredField<ShapesRecord, 2, physgen::shape::Vector<4>, typename Formats::nodes, std::int32_t>;
  using F = physgen::StoredField<ShapesRecord, 3, physgen::shape::Matrix<3, 3>, typename Formats::F, Real>;
  using B = physgen::StoredField<ShapesRecord, 4, physgen::shape::Matrix<2, 3>, typename Formats::B, Real>;
  using row = physgen::StoredField<ShapesRecord, 5, physgen::shape::Matrix<1, 4>, typename Formats::row, Real>;
  using K = physgen::StoredField<ShapesRecord, 6, physgen::shape::Symmetric<3>, typename Formats::K, Real>;
  using C2 = physgen::StoredField<ShapesRecord, 7, physgen::shape::Symmetric<2>, typename Formats::C2, double>;
  using s = physgen::StoredField<ShapesRecord, 8, physgen::shape::Diagonal<3>, typename Formats::s, Real>;
  using W = physgen::StoredField<ShapesRecord, 9, physgen::shape::Skew<3>, typename Formats::W, Real>;
  using U = physgen::StoredField<ShapesRecord, 10, physgen::shape::Rotation, typename Formats::U, Real>;
  using V = physgen::StoredField<ShapesRecord, 11, physgen::shape::Rotation, typename Formats::V, Real>;
  using count = physgen::StoredField<
      ShapesRecord, 12, physgen::shape::Vector<2>, typename Formats::count, std::int32_t>;
  using M = physgen::StoredField<ShapesRecord, 13, physgen::shape::Matrix<2, 2>, typename Formats::M, double>;
  using fields_ = physgen::RecordFields<a, v, nodes, F, B, row, K, C2, s, W, U, V, count, M>;
};

template <class Real, class Formats, class Cursor>
struct ShapesRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = ShapesRecord<Real, Formats>;
  using Value = Shapes<typename Cursor::template Lanes<Real>>;

  /// Scalar.
  PHYSGEN_FUNCTION decltype(auto) a() const { return this->field_(typename Record::a(), Record::a::offset); }
  PHYSGEN_FUNCTION decltype(auto) v() const { return this->field_(typename Record::v(), Record::v::offset); }
  /// corners i, j, k, l
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return this->field_(typename Record::nodes(), Record::nodes::offset);
  }
  /// deformation gradient [1]
  PHYSGEN_FUNCTION decltype(auto) F() const { return this->field_(typename Record::F(), Record::F::offset); }
  PHYSGEN_FUNCTION decltype(auto) B() const { return this->field_(typename Record::B(), Record::B::offset); }
  PHYSGEN_FUNCTION decltype(auto) row() const { return this->field_(typename Record::row(), Record::row::offset); }
  /// [N/m]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) K() const { return this->field_(typename Record::K(), Record::K::offset); }
  /// Symmetric, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) C2() const { return this->field_(typename Record::C2(), Record::C2::offset); }
  /// Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const { return this->field_(typename Record::s(), Record::s::offset); }
  /// [1/s]. Skew-symmetric, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) W() const { return this->field_(typename Record::W(), Record::W::offset); }
  /// principal directions. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const { return this->field_(typename Record::U(), Record::U::offset); }
  /// Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const { return this->field_(typename Record::V(), Record::V::offset); }
  PHYSGEN_FUNCTION decltype(auto) count() const {
    return this->field_(typename Record::count(), Record::count::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) M() const { return this->field_(typename Record::M(), Record::M::offset); }

  PHYSGEN_FUNCTION const Value get() const {
    return {
        a(), v().get(), nodes().get(), F().get(), B().get(), row().get(), K().get(), C2().get(), s().get(), W().get(),
        U().get(), V().get(), count().get(), M().get()};
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
};

struct ShapesObject : physgen::ObjectTag<ShapesObject, Shapes, ShapesFormats, ShapesRecord, ShapesRef, ShapesProbe> {
  static constexpr std::string_view name = "tissue::model::Shapes";
  static constexpr std::array<physgen::FieldText, 14> texts = {{
      {"a"}, {"v"}, {"nodes"}, {"F", "1"}, {"B"}, {"row"}, {"K", "N/m"}, {"C2"}, {"s"}, {"W", "1/s"}, {"U"}, {"V"},
      {"count"}, {"M"}}};
  static constexpr std::array<std::string_view, 14> docs = {
    "Scalar.", "", "corners i, j, k, l", "deformation gradient", "", "", "", "", "", "", "principal directions",
    "", "", "",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<ShapesObject, Space>>
using ShapesView = physgen::View<ShapesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<ShapesObject, Space>>
using ShapesArray = physgen::Array<ShapesObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<ShapesObject, physgen::Host>(
    {292, 8, {56, 60, 72, 88, 124, 148, 164, 0, 188, 200, 212, 248, 284, 24}},
    {504, 8, {0, 8, 480, 32, 104, 152, 184, 232, 256, 280, 304, 376, 496, 448}}));

// ---- Names ----------------------------------------------------------------------------------------------------------

/// Names that generated code uses elsewhere.
template <class Real>
struct Names {
  Real value = {};
  Real entry = {};
  Real S = {};
  Real R = {};
  Real at = {};
  Real cursor = {};
  Real name = {};
  Real fields = {};
  Real Layout = {};
  Real host = {};
  Real plan = {};
  Real slot = {};
  Real stride = {};
  Real offset = {};
  Real format = {};
  Real Native = {};
  Real PerSpace = {};
  Real field = {};
  Real element = {};
  Real nested = {};
  Real self[2] = {};
  Real assign = {};
  Real texts = {};
  Real Inner = {};
  physgen::MatrixValue<Real, 2, 1> tissue = decltype(tissue)::Zero();
};

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
  using assign = physgen::format::Native;
  using texts = physgen::format::Native;
  using Inner = physgen::format::Native;
  using tissue = physgen::format::Native;
};

struct NamesObject;
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
  using assign = physgen::Probe<ArrayTag, Object, first + 21, typename Base::assign>;
  using texts = physgen::Probe<ArrayTag, Object, first + 22, typename Base::texts>;
  using Inner = physgen::Probe<ArrayTag, Object, first + 23, typename Base::Inner>;
  using tissue = physgen::Probe<ArrayTag, Object, first + 24, typename Base::tissue>;
};

template <class Real, class Formats>
struct NamesRecord {
  using value = physgen::StoredField<NamesRecord, 0, physgen::shape::Scalar, typename Formats::value, Real>;
  using entry = physgen::StoredField<NamesRecord, 1, physgen::shape::Scalar, typename Formats::entry, Real>;
  using S = physgen::StoredField<NamesRecord, 2, physgen::shape::Scalar, typename Formats::S, Real>;
  using R = physgen::StoredField<NamesRecord, 3, physgen::shape::Scalar, typename Formats::R, Real>;
  using at = physgen::StoredField<NamesRecord, 4, physgen::shape::Scalar, typename Formats::at, Real>;
  using cursor = physgen::StoredField<NamesRecord, 5, physgen::shape::Scalar, typename Formats::cursor, Real>;
  using name = physgen::StoredField<NamesRecord, 6, physgen::shape::Scalar, typename Formats::name, Real>;
  using fields = physgen::StoredField<NamesRecord, 7, physgen::shape::Scalar, typename Formats::fields, Real>;
  using Layout = physgen::StoredField<NamesRecord, 8, physgen::shape::Scalar, typename Formats::Layout, Real>;
  using host = physgen::StoredField<NamesRecord, 9, physgen::shape::Scalar, typename Formats::host, Real>;
  using plan = physgen::StoredField<NamesRecord, 10, physgen::shape::Scalar, typename Formats::plan, Real>;
  using slot = physgen::StoredField<NamesRecord, 11, physgen::shape::Scalar, typename Formats::slot, Real>;
  using stride = physgen::StoredField<NamesRecord, 12, physgen::shape::Scalar, typename Formats::stride, Real>;
  using offset = physgen::StoredField<NamesRecord, 13, physgen::shape::Scalar, typename Formats::offset, Real>;
  using format = physgen::StoredField<NamesRecord, 14, physgen::shape::Scalar, typename Formats::format, Real>;
  using Native = physgen::StoredField<NamesRecord, 15, physgen::shape::Scalar, typename Formats::Native, Real>;
  using PerSpace = physgen::StoredField<NamesRecord, 16, physgen::shape::Scalar, typename Formats::PerSpace, Real>;
  using field = physgen::StoredField<NamesRecord, 17, physgen::shape::Scalar, typename Formats::field, Real>;
  using element = physgen::StoredField<NamesRecord, 18, physgen::shape::Scalar, typename Formats::element, Real>;
  using nested = physgen::StoredField<NamesRecord, 19, physgen::shape::Scalar, typename Formats::nested, Real>;
  using self = physgen::StoredField<NamesRecord, 20, physgen::shape::Scalar, typename Formats::self, Real, 2>;
  using assign = physgen::StoredField<NamesRecord, 21, physgen::shape::Scalar, typename Formats::assign, Real>;
  using texts = physgen::StoredField<NamesRecord, 22, physgen::shape::Scalar, typename Formats::texts, Real>;
  using Inner = physgen::StoredField<NamesRecord, 23, physgen::shape::Scalar, typename Formats::Inner, Real>;
  using tissue = physgen::StoredField<NamesRecord, 24, physgen::shape::Vector<2>, typename Formats::tissue, Real>;
  using fields_ = physgen::RecordFields<
      value, entry, S, R, at, cursor, name, fields, Layout, host, plan, slot, stride, offset, format, Native, PerSpace,
      field, element, nested, self, assign, texts, Inner, tissue>;
};

template <class Real, class Formats, class Cursor>
struct NamesRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = NamesRecord<Real, Formats>;
  using Value = Names<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION decltype(auto) value() const {
    return this->field_(typename Record::value(), Record::value::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) entry() const {
    return this->field_(typename Record::entry(), Record::entry::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) S() const { return this->field_(typename Record::S(), Record::S::offset); }
  PHYSGEN_FUNCTION decltype(auto) R() const { return this->field_(typename Record::R(), Record::R::offset); }
  PHYSGEN_FUNCTION decltype(auto) at() const { return this->field_(typename Record::at(), Record::at::offset); }
  PHYSGEN_FUNCTION decltype(auto) cursor() const {
    return this->field_(typename Record::cursor(), Record::cursor::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) name() const { return this->field_(typename Record::name(), Record::name::offset); }
  PHYSGEN_FUNCTION decltype(auto) fields() const {
    return this->field_(typename Record::fields(), Record::fields::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) Layout() const {
    return this->field_(typename Record::Layout(), Record::Layout::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) host() const { return this->field_(typename Record::host(), Record::host::offset); }
  PHYSGEN_FUNCTION decltype(auto) plan() const { return this->field_(typename Record::plan(), Record::plan::offset); }
  PHYSGEN_FUNCTION decltype(auto) slot() const { return this->field_(typename Record::slot(), Record::slot::offset); }
  PHYSGEN_FUNCTION decltype(auto) stride() const {
    return this->field_(typename Record::stride(), Record::stride::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) offset() const {
    return this->field_(typename Record::offset(), Record::offset::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) format() const {
    return this->field_(typename Record::format(), Record::format::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) Native() const {
    return this->field_(typename Record::Native(), Record::Native::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) PerSpace() const {
    return this->field_(typename Record::PerSpace(), Record::PerSpace::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) field() const {
    return this->field_(typename Record::field(), Record::field::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) element() const {
    return this->field_(typename Record::element(), Record::element::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) nested() const {
    return this->field_(typename Record::nested(), Record::nested::offset);
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) self(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Names::self");
    return this->field_(typename Record::self(), Record::self::offset + entry * Record::self::stride);
  }
  PHYSGEN_FUNCTION decltype(auto) assign() const {
    return this->field_(typename Record::assign(), Record::assign::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) texts() const {
    return this->field_(typename Record::texts(), Record::texts::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) Inner() const {
    return this->field_(typename Record::Inner(), Record::Inner::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) tissue() const {
    return this->field_(typename Record::tissue(), Record::tissue::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {
        value(), entry(), S(), R(), at(), cursor(), name(), fields(), Layout(), host(), plan(), slot(), stride(),
        offset(), format(), Native(), PerSpace(), field(), element(), nested(), {self(0), self(1)}, assign(), texts(),
        Inner(), tissue().get()};
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
    assign() = value_.assign;
    texts() = value_.texts;
    Inner() = value_.Inner;
    tissue() = value_.tissue;
  }
};

struct NamesObject : physgen::ObjectTag<NamesObject, Names, NamesFormats, NamesRecord, NamesRef, NamesProbe> {
  static constexpr std::string_view name = "tissue::model::Names";
  static constexpr std::array<physgen::FieldText, 25> texts = {{
      {"value"}, {"entry"}, {"S"}, {"R"}, {"at"}, {"cursor"}, {"name"}, {"fields"}, {"Layout"}, {"host"}, {"plan"},
      {"slot"}, {"stride"}, {"offset"}, {"format"}, {"Native"}, {"PerSpace"}, {"field"}, {"element"}, {"nested"},
      {"self"}, {"assign"}, {"texts"}, {"Inner"}, {"tissue"}}};
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<NamesObject, Space>>
using NamesView = physgen::View<NamesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<NamesObject, Space>>
using NamesArray = physgen::Array<NamesObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<NamesObject, physgen::Host>(
    {108, 4, {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64, 68, 72, 76, 80, 88, 92, 96, 100}},
    {216, 8, {0, 8, 16, 24, 32, 40, 48, 56, 64, 72, 80, 88, 96, 104, 112, 120, 128, 136, 144, 152, 160, 176, 184, 192,
        200}}));

// ---- Entries --------------------------------------------------------------------------------------------------------

/// Fixed arrays.
template <class Real>
struct Entries {
  /// Weights of the five points.
  /// They sum to one. [1] Range [0, 1].
  Real weights[5] = {};
  /// [N/m]. Symmetric, 6 stored.
  physgen::MatrixValue<Real, 3, 3> k[4] = {
      std::remove_extent_t<decltype(k)>::Zero(), std::remove_extent_t<decltype(k)>::Zero(),
      std::remove_extent_t<decltype(k)>::Zero(), std::remove_extent_t<decltype(k)>::Zero()};
  physgen::same_lanes_t<Real, std::int32_t> flags[3] = {};
  /// More entries than are worth unrolling
  physgen::same_lanes_t<Real, double> history[40] = {};
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> edges[6] = {
      std::remove_extent_t<decltype(edges)>::Zero(), std::remove_extent_t<decltype(edges)>::Zero(),
      std::remove_extent_t<decltype(edges)>::Zero(), std::remove_extent_t<decltype(edges)>::Zero(),
      std::remove_extent_t<decltype(edges)>::Zero(), std::remove_extent_t<decltype(edges)>::Zero()};
  Real entry[2] = {};
};

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

template <class Real, class Formats>
struct EntriesRecord {
  using weights = physgen::StoredField<EntriesRecord, 0, physgen::shape::Scalar, typename Formats::weights, Real, 5>;
  using k = physgen::StoredField<EntriesRecord, 1, physgen::shape::Symmetric<3>, typename Formats::k, Real, 4>;
  using flags = physgen::StoredField<
      EntriesRecord, 2, physgen::shape::Scalar, typename Formats::flags, std::int32_t, 3>;
  using history = physgen::StoredField<EntriesRecord, 3, physgen::shape::Scalar, typename Formats::history, double, 40>;
  using edges = physgen::StoredField<
      EntriesRecord, 4, physgen::shape::Vector<2>, typename Formats::edges, std::int32_t, 6>;
  using entry = physgen::StoredField<EntriesRecord, 5, physgen::shape::Scalar, typename Formats::entry, Real, 2>;
  using fields_ = physgen::RecordFields<weights, k, flags, history, edges, entry>;
};

template <class Real, class Formats, class Cursor>
struct EntriesRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = EntriesRecord<Real, Formats>;
  using Value = Entries<typename Cursor::template Lanes<Real>>;

  /// Weights of the five points.
  /// They sum to one. [1] Range [0, 1].
  /// @pre 0 <= entry < 5
  PHYSGEN_FUNCTION decltype(auto) weights(int entry) const {
    physgen::check_inner(entry, 5, "an entry of tissue::model::Entries::weights");
    return this->field_(typename Record::weights(), Record::weights::offset + entry * Record::weights::stride);
  }
  /// [N/m]. Symmetric, 6 stored.
  /// @pre 0 <= entry < 4
  PHYSGEN_FUNCTION decltype(auto) k(int entry) const {
    physgen::check_inner(entry, 4, "an entry of tissue::model::Entries::k");
    return this->field_(typename Record::k(), Record::k::offset + entry * Record::k::stride);
  }
  /// @pre 0 <= entry < 3
  PHYSGEN_FUNCTION decltype(auto) flags(int entry) const {
    physgen::check_inner(entry, 3, "an entry of tissue::model::Entries::flags");
    return this->field_(typename Record::flags(), Record::flags::offset + entry * Record::flags::stride);
  }
  /// More entries than are worth unrolling
  /// @pre 0 <= entry < 40
  PHYSGEN_FUNCTION decltype(auto) history(int entry) const {
    physgen::check_inner(entry, 40, "an entry of tissue::model::Entries::history");
    return this->field_(typename Record::history(), Record::history::offset + entry * Record::history::stride);
  }
  /// @pre 0 <= entry < 6
  PHYSGEN_FUNCTION decltype(auto) edges(int entry) const {
    physgen::check_inner(entry, 6, "an entry of tissue::model::Entries::edges");
    return this->field_(typename Record::edges(), Record::edges::offset + entry * Record::edges::stride);
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) entry(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Entries::entry");
    return this->field_(typename Record::entry(), Record::entry::offset + entry * Record::entry::stride);
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
};

struct EntriesObject : physgen::ObjectTag<
    EntriesObject, Entries, EntriesFormats, EntriesRecord, EntriesRef, EntriesProbe> {
  static constexpr std::string_view name = "tissue::model::Entries";
  static constexpr std::array<physgen::FieldText, 6> texts = {{
      {"weights", "1"}, {"k", "N/m"}, {"flags"}, {"history"}, {"edges"}, {"entry"}}};
  static constexpr std::array<std::string_view, 6> docs = {
    "Weights of the five points.\nThey sum to one.", "", "", "More entries than are worth unrolling", "", "",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<EntriesObject, Space>>
using EntriesView = physgen::View<EntriesObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<EntriesObject, Space>>
using EntriesArray = physgen::Array<EntriesObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<EntriesObject, physgen::Host>(
    {504, 8, {320, 340, 436, 0, 448, 496}}, {628, 8, {0, 40, 568, 232, 580, 552}}));

// ---- Options --------------------------------------------------------------------------------------------------------

/// Units, ranges and initial values. The text of this comment is long enough to need a second line, because it goes on
/// and on without saying anything else.
///
///   An indented line.
/// The last line.
template <class Real>
struct Options {
  /// Mass per volume of the rest shape. [kg/m^3] Range [0, 20000]; initially 1060.
  Real density = physgen::all_lanes<Real>(1060.0);
  /// Range [0, 0.5]; initially 0.45.
  Real nu = physgen::all_lanes<Real>(0.45);
  /// [1]. Initially 0.5.
  physgen::MatrixValue<Real, 3, 1> direction = decltype(direction)::Constant(physgen::all_lanes<Real>(0.5));
  /// Symmetric, 6 stored. Initially 1.
  physgen::MatrixValue<Real, 3, 3> metric = decltype(metric)::Constant(physgen::all_lanes<Real>(1.0));
  /// Initially -1.
  physgen::same_lanes_t<Real, std::int32_t> label = -1;
  /// Initially 7.
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> group = decltype(group)::Constant(7);
  /// Skew-symmetric, 3 stored. Initially 0.25 in a new array.
  physgen::MatrixValue<Real, 3, 3> spin = decltype(spin)::Zero();
  /// Initially 1e-12.
  physgen::same_lanes_t<Real, double> fixed = 1e-12;
};

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

template <class Real, class Formats>
struct OptionsRecord {
  using density = physgen::StoredField<OptionsRecord, 0, physgen::shape::Scalar, typename Formats::density, Real>;
  using nu = physgen::StoredField<OptionsRecord, 1, physgen::shape::Scalar, typename Formats::nu, Real>;
  using direction = physgen::StoredField<
      OptionsRecord, 2, physgen::shape::Vector<3>, typename Formats::direction, Real>;
  using metric = physgen::StoredField<OptionsRecord, 3, physgen::shape::Symmetric<3>, typename Formats::metric, Real>;
  using label = physgen::StoredField<OptionsRecord, 4, physgen::shape::Scalar, typename Formats::label, std::int32_t>;
  using group = physgen::StoredField<
      OptionsRecord, 5, physgen::shape::Vector<2>, typename Formats::group, std::int32_t>;
  using spin = physgen::StoredField<OptionsRecord, 6, physgen::shape::Skew<3>, typename Formats::spin, Real>;
  using fixed = physgen::StoredField<OptionsRecord, 7, physgen::shape::Scalar, typename Formats::fixed, double>;
  using fields_ = physgen::AlignedRecordFields<32, density, nu, direction, metric, label, group, spin, fixed>;
};

template <class Real, class Formats, class Cursor>
struct OptionsRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = OptionsRecord<Real, Formats>;
  using Value = Options<typename Cursor::template Lanes<Real>>;

  /// Mass per volume of the rest shape. [kg/m^3] Range [0, 20000]; initially 1060.
  PHYSGEN_FUNCTION decltype(auto) density() const {
    return this->field_(typename Record::density(), Record::density::offset);
  }
  /// Range [0, 0.5]; initially 0.45.
  PHYSGEN_FUNCTION decltype(auto) nu() const { return this->field_(typename Record::nu(), Record::nu::offset); }
  /// [1]. Initially 0.5.
  PHYSGEN_FUNCTION decltype(auto) direction() const {
    return this->field_(typename Record::direction(), Record::direction::offset);
  }
  /// Symmetric, 6 stored. Initially 1.
  PHYSGEN_FUNCTION decltype(auto) metric() const {
    return this->field_(typename Record::metric(), Record::metric::offset);
  }
  /// Initially -1.
  PHYSGEN_FUNCTION decltype(auto) label() const {
    return this->field_(typename Record::label(), Record::label::offset);
  }
  /// Initially 7.
  PHYSGEN_FUNCTION decltype(auto) group() const {
    return this->field_(typename Record::group(), Record::group::offset);
  }
  /// Skew-symmetric, 3 stored. Initially 0.25 in a new array.
  PHYSGEN_FUNCTION decltype(auto) spin() const { return this->field_(typename Record::spin(), Record::spin::offset); }
  /// Initially 1e-12.
  PHYSGEN_FUNCTION decltype(auto) fixed() const {
    return this->field_(typename Record::fixed(), Record::fixed::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {density(), nu(), direction().get(), metric().get(), label(), group().get(), spin().get(), fixed()};
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
};

struct OptionsObject : physgen::ObjectTag<
    OptionsObject, Options, OptionsFormats, OptionsRecord, OptionsRef, OptionsProbe> {
  static constexpr std::string_view name = "tissue::model::Options";
  static constexpr std::array<physgen::FieldText, 8> texts = {{
      {"density", "kg/m^3", 1060.0}, {"nu", "", 0.45}, {"direction", "1", 0.5}, {"metric", "", 1.0},
      {"label", "", -1.0}, {"group", "", 7.0}, {"spin", "", 0.25}, {"fixed", "", 1e-12}}};
  static constexpr std::array<std::string_view, 8> docs = {
    "Mass per volume of the rest shape.", "", "", "", "", "", "", "",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<OptionsObject, Space>>
using OptionsView = physgen::View<OptionsObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Soa, physgen::AosPadded>,
          class Formats = physgen::FormatsOf<OptionsObject, Space>>
using OptionsArray = physgen::Array<OptionsObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<OptionsObject, physgen::Host>(
    {76, 32, {8, 12, 16, 28, 52, 56, 64, 0}}, {132, 32, {0, 8, 16, 40, 120, 124, 88, 112}}));

// ---- Element --------------------------------------------------------------------------------------------------------

/// Nested objects of every alignment.
template <class Real>
struct Element {
  /// Before the nested objects by name, behind them in the record.
  physgen::same_lanes_t<Real, std::int32_t> flag = {};
  /// Constants of the tissue.
  ::material::Lame<Real> lame;
  ::material::Fibre<Real> fibres[2];
  ::tissue::Stamp<Real> stamp;
  Shapes<Real> shapes;
  /// [m^3]
  Real volume = {};
};

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

template <class Real, class Formats>
struct ElementRecord {
  using flag = physgen::StoredField<ElementRecord, 0, physgen::shape::Scalar, typename Formats::flag, std::int32_t>;
  using lame = physgen::NestedField<ElementRecord, 1, ::material::LameObject, typename Formats::lame, Real>;
  using fibres = physgen::NestedField<ElementRecord, 2, ::material::FibreObject, typename Formats::fibres, Real, 2>;
  using stamp = physgen::NestedField<ElementRecord, 3, ::tissue::StampObject, typename Formats::stamp, Real>;
  using shapes = physgen::NestedField<ElementRecord, 4, ShapesObject, typename Formats::shapes, Real>;
  using volume = physgen::StoredField<ElementRecord, 5, physgen::shape::Scalar, typename Formats::volume, Real>;
  using fields_ = physgen::RecordFields<flag, lame, fibres, stamp, shapes, volume>;
};

template <class Real, class Formats, class Cursor>
struct ElementRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = ElementRecord<Real, Formats>;
  using Value = Element<typename Cursor::template Lanes<Real>>;

  /// Before the nested objects by name, behind them in the record.
  PHYSGEN_FUNCTION decltype(auto) flag() const { return this->field_(typename Record::flag(), Record::flag::offset); }
  /// Constants of the tissue.
  PHYSGEN_FUNCTION decltype(auto) lame() const { return this->field_(typename Record::lame(), Record::lame::offset); }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) fibres(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Element::fibres");
    return this->field_(typename Record::fibres(), Record::fibres::offset + entry * Record::fibres::stride);
  }
  PHYSGEN_FUNCTION decltype(auto) stamp() const {
    return this->field_(typename Record::stamp(), Record::stamp::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) shapes() const {
    return this->field_(typename Record::shapes(), Record::shapes::offset);
  }
  /// [m^3]
  PHYSGEN_FUNCTION decltype(auto) volume() const {
    return this->field_(typename Record::volume(), Record::volume::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {flag(), lame().get(), {fibres(0).get(), fibres(1).get()}, stamp().get(), shapes().get(), volume()};
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
};

struct ElementObject : physgen::ObjectTag<
    ElementObject, Element, ElementFormats, ElementRecord, ElementRef, ElementProbe> {
  static constexpr std::string_view name = "tissue::model::Element";
  static constexpr std::array<physgen::FieldText, 24> texts = {{
      {"flag"}, {"lame.mu", "Pa"}, {"lame.lambda", "Pa"}, {"fibres[0].direction"}, {"fibres[0].strength", "Pa"},
      {"fibres[1].direction"}, {"fibres[1].strength", "Pa"}, {"stamp.time", "s"}, {"stamp.step"}, {"shapes.a"},
      {"shapes.v"}, {"shapes.nodes"}, {"shapes.F", "1"}, {"shapes.B"}, {"shapes.row"}, {"shapes.K", "N/m"},
      {"shapes.C2"}, {"shapes.s"}, {"shapes.W", "1/s"}, {"shapes.U"}, {"shapes.V"}, {"shapes.count"}, {"shapes.M"},
      {"volume", "m^3"}}};
  static constexpr std::array<std::string_view, 6> docs = {
    "Before the nested objects by name, behind them in the record.", "Constants of the tissue.", "", "", "", "",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<ElementObject, Space>>
using ElementView = physgen::View<ElementObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aosoa<64>>,
          class Formats = physgen::FormatsOf<ElementObject, Space>>
using ElementArray = physgen::Array<ElementObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<ElementObject, physgen::Host>(
    {376, 8, {360, 364, 368, 8, 0, 32, 24, 48, 56, 120, 124, 136, 152, 188, 212, 228, 64, 252, 264, 276, 312, 348, 88,
        372}},
    {596, 8, {592, 0, 8, 24, 16, 48, 40, 64, 72, 80, 88, 560, 112, 184, 232, 264, 312, 336, 360, 384, 456, 576, 528,
        584}}));

}  // namespace tissue::model

namespace tissue::other {

// ---- Patch ----------------------------------------------------------------------------------------------------------

/// The value of one Patch.
template <class Real>
struct Patch {
  ::tissue::model::Element<Real> elements[2];
  physgen::same_lanes_t<Real, float> weight = {};
  ::tissue::model::Options<Real> options;
};

template <class Space>
struct PatchFormats {
  using elements = ::tissue::model::ElementFormats<Space>;
  using weight = physgen::format::Native;
  using options = ::tissue::model::OptionsFormats<Space>;
};

struct PatchObject;
template <class ArrayTag, class Base = PatchFormats<physgen::Host>, class Object = PatchObject, int first = 0>
struct PatchProbe {
  using array_ = ArrayTag;
  using elements = ::tissue::model::ElementProbe<ArrayTag, typename Base::elements, Object, first + 0>;
  using weight = physgen::Probe<ArrayTag, Object, first + 48, typename Base::weight>;
  using options = ::tissue::model::OptionsProbe<ArrayTag, typename Base::options, Object, first + 49>;
};

template <class Real, class Formats>
struct PatchRecord {
  using elements = physgen::NestedField<
      PatchRecord, 0, ::tissue::model::ElementObject, typename Formats::elements, Real, 2>;
  using weight = physgen::StoredField<PatchRecord, 1, physgen::shape::Scalar, typename Formats::weight, float>;
  using options = physgen::NestedField<PatchRecord, 2, ::tissue::model::OptionsObject, typename Formats::options, Real>;
  using fields_ = physgen::RecordFields<elements, weight, options>;
};

template <class Real, class Formats, class Cursor>
struct PatchRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = PatchRecord<Real, Formats>;
  using Value = Patch<typename Cursor::template Lanes<Real>>;

  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) elements(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::other::Patch::elements");
    return this->field_(typename Record::elements(), Record::elements::offset + entry * Record::elements::stride);
  }
  PHYSGEN_FUNCTION decltype(auto) weight() const {
    return this->field_(typename Record::weight(), Record::weight::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) options() const {
    return this->field_(typename Record::options(), Record::options::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {{elements(0).get(), elements(1).get()}, weight(), options().get()};
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 2; ++entry) elements(entry).put(value.elements[entry]);
    weight() = value.weight;
    options().put(value.options);
  }
};

struct PatchObject : physgen::ObjectTag<PatchObject, Patch, PatchFormats, PatchRecord, PatchRef, PatchProbe> {
  static constexpr std::string_view name = "tissue::other::Patch";
  static constexpr std::array<physgen::FieldText, 57> texts = {{
      {"elements[0].flag"}, {"elements[0].lame.mu", "Pa"}, {"elements[0].lame.lambda", "Pa"},
      {"elements[0].fibres[0].direction"}, {"elements[0].fibres[0].strength", "Pa"},
      {"elements[0].fibres[1].direction"}, {"elements[0].fibres[1].strength", "Pa"}, {"elements[0].stamp.time", "s"},
      {"elements[0].stamp.step"}, {"elements[0].shapes.a"}, {"elements[0].shapes.v"}, {"elements[0].shapes.nodes"},
      {"elements[0].shapes.F", "1"}, {"elements[0].shapes.B"}, {"elements[0].shapes.row"},
      {"elements[0].shapes.K", "N/m"}, {"elements[0].shapes.C2"}, {"elements[0].shapes.s"},
      {"elements[0].shapes.W", "1/s"}, {"elements[0].shapes.U"}, {"elements[0].shapes.V"}, {"elements[0].shapes.count"},
      {"elements[0].shapes.M"}, {"elements[0].volume", "m^3"}, {"elements[1].flag"}, {"elements[1].lame.mu", "Pa"},
      {"elements[1].lame.lambda", "Pa"}, {"elements[1].fibres[0].direction"}, {"elements[1].fibres[0].strength", "Pa"},
      {"elements[1].fibres[1].direction"}, {"elements[1].fibres[1].strength", "Pa"}, {"elements[1].stamp.time", "s"},
      {"elements[1].stamp.step"}, {"elements[1].shapes.a"}, {"elements[1].shapes.v"}, {"elements[1].shapes.nodes"},
      {"elements[1].shapes.F", "1"}, {"elements[1].shapes.B"}, {"elements[1].shapes.row"},
      {"elements[1].shapes.K", "N/m"}, {"elements[1].shapes.C2"}, {"elements[1].shapes.s"},
      {"elements[1].shapes.W", "1/s"}, {"elements[1].shapes.U"}, {"elements[1].shapes.V"}, {"elements[1].shapes.count"},
      {"elements[1].shapes.M"}, {"elements[1].volume", "m^3"}, {"weight"}, {"options.density", "kg/m^3", 1060.0},
      {"options.nu", "", 0.45}, {"options.direction", "1", 0.5}, {"options.metric", "", 1.0},
      {"options.label", "", -1.0}, {"options.group", "", 7.0}, {"options.spin", "", 0.25},
      {"options.fixed", "", 1e-12}}};
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<PatchObject, Space>>
using PatchView = physgen::View<PatchObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<PatchObject, Space>>
using PatchArray = physgen::Array<PatchObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<PatchObject, physgen::Host>(
    {836, 8, {360, 364, 368, 8, 0, 32, 24, 48, 56, 120, 124, 136, 152, 188, 212, 228, 64, 252, 264, 276, 312, 348, 88,
        372, 736, 740, 744, 384, 376, 408, 400, 424, 432, 496, 500, 512, 528, 564, 588, 604, 440, 628, 640, 652, 688,
            724, 464, 748, 832, 760, 764, 768, 780, 804, 808, 816, 752}},
    {1340, 8, {592, 0, 8, 24, 16, 48, 40, 64, 72, 80, 88, 560, 112, 184, 232, 264, 312, 336, 360, 384, 456, 576, 528,
        584, 1192, 600, 608, 624, 616, 648, 640, 664, 672, 680, 688, 1160, 712, 784, 832, 864, 912, 936, 960, 984, 1056,
            1176, 1128, 1184, 1336, 1200, 1208, 1216, 1240, 1320, 1324, 1288, 1312}}));

}  // namespace tissue::other

namespace tissue::model {

// ---- Frame ----------------------------------------------------------------------------------------------------------

/// A place and a direction, compact on CUDA.
template <class Real>
struct Frame {
  /// Rotation, 9 stored. Stored on the host as unit quaternion, error of an entry up to 10 eps; on CUDA as unit
  /// quaternion of 16-bit steps, error of an entry up to 9e-5.
  physgen::MatrixValue<Real, 3, 3> turn = decltype(turn)::Identity();
  /// [m]. Stored on CUDA as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  physgen::MatrixValue<Real, 3, 1> origin = decltype(origin)::Zero();
  /// Range [0, 1]; initially 0.25. Stored as 16-bit steps over [0, 1], error up to 7.7e-06.
  Real weight = physgen::all_lanes<Real>(0.25);
};

template <class Space>
struct FrameFormats {
  using turn = physgen::PerSpace<Space, physgen::format::Quaternion<>, physgen::format::Quaternion16>;
  using origin = physgen::PerSpace<Space, physgen::format::Native, physgen::format::Half<>>;
  using weight = physgen::format::Snorm16<physgen::format::Interval{0.0, 1.0}>;
};

struct FrameObject;
template <class ArrayTag, class Base = FrameFormats<physgen::Host>, class Object = FrameObject, int first = 0>
struct FrameProbe {
  using array_ = ArrayTag;
  using turn = physgen::Probe<ArrayTag, Object, first + 0, typename Base::turn>;
  using origin = physgen::Probe<ArrayTag, Object, first + 1, typename Base::origin>;
  using weight = physgen::Probe<ArrayTag, Object, first + 2, typename Base::weight>;
};

template <class Real, class Formats>
struct FrameRecord {
  using turn = physgen::StoredField<FrameRecord, 0, physgen::shape::Rotation, typename Formats::turn, Real>;
  using origin = physgen::StoredField<FrameRecord, 1, physgen::shape::Vector<3>, typename Formats::origin, Real>;
  using weight = physgen::StoredField<FrameRecord, 2, physgen::shape::Scalar, typename Formats::weight, Real>;
  using fields_ = physgen::RecordFields<turn, origin, weight>;
};

template <class Real, class Formats, class Cursor>
struct FrameRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = FrameRecord<Real, Formats>;
  using Value = Frame<typename Cursor::template Lanes<Real>>;

  /// Rotation, 9 stored. Stored on the host as unit quaternion, error of an entry up to 10 eps; on CUDA as unit
  /// quaternion of 16-bit steps, error of an entry up to 9e-5.
  PHYSGEN_FUNCTION decltype(auto) turn() const { return this->field_(typename Record::turn(), Record::turn::offset); }
  /// [m]. Stored on CUDA as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) origin() const {
    return this->field_(typename Record::origin(), Record::origin::offset);
  }
  /// Range [0, 1]; initially 0.25. Stored as 16-bit steps over [0, 1], error up to 7.7e-06.
  PHYSGEN_FUNCTION decltype(auto) weight() const {
    return this->field_(typename Record::weight(), Record::weight::offset);
  }

  PHYSGEN_FUNCTION const Value get() const { return {turn().get(), origin().get(), weight()}; }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    turn() = value.turn;
    origin() = value.origin;
    weight() = value.weight;
  }
};

struct FrameObject : physgen::ObjectTagPerSpace<FrameObject, Frame, FrameFormats, FrameRecord, FrameRef, FrameProbe> {
  static constexpr std::string_view name = "tissue::model::Frame";
  static constexpr std::array<physgen::FieldText, 3> texts = {{{"turn"}, {"origin", "m"}, {"weight", "", 0.25}}};
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<FrameObject, Space>>
using FrameView = physgen::View<FrameObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<FrameObject, Space>>
using FrameArray = physgen::Array<FrameObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<FrameObject, physgen::Host>({30, 4, {0, 16, 28}}, {58, 8, {0, 32, 56}}));
static_assert(physgen::are_sound_records<FrameObject, physgen::Cuda>({16, 2, {0, 8, 14}}, {16, 2, {0, 8, 14}}));

// ---- Stored ---------------------------------------------------------------------------------------------------------

/// Every storage format.
template <class Real>
struct Stored {
  /// Stored as float, relative error up to 6e-8.
  Real single = {};
  /// Stored as double, relative error up to 1.2e-16.
  Real twice = {};
  /// Stored as float, relative error up to 6e-8.
  physgen::same_lanes_t<Real, double> narrowed = {};
  /// Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  Real plain_half = {};
  /// External force. [N] Range [0, 1e+06]; initially 1000. Stored as half, relative error up to 4.9e-4 for sizes from
  /// 0.002 to 2.1e+06.
  Real load = physgen::all_lanes<Real>(1000.0);
  /// Stored as bfloat16, relative error up to 3.9e-3.
  Real wide = {};
  /// [rad]. Range [-3.25, 3.25]; initially 0.5. Stored as 16-bit steps over [-3.25, 3.25], error up to 5e-05.
  Real angle = physgen::all_lanes<Real>(0.5);
  /// [K]. Range [273, 373]; initially 310. Stored on CUDA as 16-bit steps over [273, 373], error up to 0.00081.
  Real temperature = physgen::all_lanes<Real>(310.0);
  /// [Pa]. Symmetric, 6 stored. Range [-1e+07, 1e+07]. Stored on the host as half, relative error up to 4.9e-4 for
  /// sizes from 0.031 to 3.4e+07; on CUDA as bfloat16, relative error up to 3.9e-3.
  physgen::MatrixValue<Real, 3, 3> stress = decltype(stress)::Zero();
  /// Stored on CUDA as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  physgen::MatrixValue<Real, 3, 3> F = decltype(F)::Zero();
  /// Diagonal, 3 stored. Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  physgen::MatrixValue<Real, 3, 1> stretch = decltype(stretch)::Zero();
  /// Skew-symmetric, 3 stored. Range [-8, 8]. Stored as 16-bit steps over [-8, 8], error up to 0.00013.
  physgen::MatrixValue<Real, 3, 3> spin = decltype(spin)::Zero();
  /// Rotation, 9 stored. Stored on CUDA as unit quaternion, error of an entry up to 10 eps.
  physgen::MatrixValue<Real, 3, 3> R = decltype(R)::Identity();
  /// Rotation, 9 stored. Stored as unit quaternion of floats, error of an entry up to 1.2e-6.
  physgen::MatrixValue<Real, 3, 3> R32 = decltype(R32)::Identity();
  /// Rotation, 9 stored. Stored as unit quaternion of doubles, error of an entry up to 10 eps.
  physgen::MatrixValue<Real, 3, 3> R64 = decltype(R64)::Identity();
  /// Rotation, 9 stored. Stored as unit quaternion of halves, error of an entry up to 2e-3.
  physgen::MatrixValue<Real, 3, 3> Rhalf = decltype(Rhalf)::Identity();
  /// Rotation, 9 stored. Stored as unit quaternion of bfloat16, error of an entry up to 1.6e-2.
  physgen::MatrixValue<Real, 3, 3> Rbfloat = decltype(Rbfloat)::Identity();
  /// Rotation, 9 stored. Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.
  physgen::MatrixValue<Real, 3, 3> R16 = decltype(R16)::Identity();
  /// Rotation, 9 stored. Stored on the host as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04; on
  /// CUDA as 16-bit steps over [-1, 1], error up to 1.6e-05.
  physgen::MatrixValue<Real, 3, 3> entries = decltype(entries)::Identity();
  /// Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  Real halves[5] = {};
  /// Rotation, 9 stored. Stored as unit quaternion of halves, error of an entry up to 2e-3.
  physgen::MatrixValue<Real, 3, 3> turns[3] = {
      std::remove_extent_t<decltype(turns)>::Identity(), std::remove_extent_t<decltype(turns)>::Identity(),
      std::remove_extent_t<decltype(turns)>::Identity()};
  /// Rotation, 9 stored. Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.
  physgen::MatrixValue<Real, 3, 3> many[33];
  /// Initially 7.
  physgen::same_lanes_t<Real, std::int32_t> count = 7;
  Frame<Real> frame;
  Frame<Real> frames[2];
};

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

template <class Real, class Formats>
struct StoredRecord {
  using single = physgen::StoredField<StoredRecord, 0, physgen::shape::Scalar, typename Formats::single, Real>;
  using twice = physgen::StoredField<StoredRecord, 1, physgen::shape::Scalar, typename Formats::twice, Real>;
  using narrowed = physgen::StoredField<StoredRecord, 2, physgen::shape::Scalar, typename Formats::narrowed, double>;
  using plain_half = physgen::StoredField<StoredRecord, 3, physgen::shape::Scalar, typename Formats::plain_half, Real>;
  using load = physgen::StoredField<StoredRecord, 4, physgen::shape::Scalar, typename Formats::load, Real>;
  using wide = physgen::StoredField<StoredRecord, 5, physgen::shape::Scalar, typename Formats::wide, Real>;
  using angle = physgen::StoredField<StoredRecord, 6, physgen::shape::Scalar, typename Formats::angle, Real>;
  using temperature = physgen::StoredField<
      StoredRecord, 7, physgen::shape::Scalar, typename Formats::temperature, Real>;
  using stress = physgen::StoredField<StoredRecord, 8, physgen::shape::Symmetric<3>, typename Formats::stress, Real>;
  using F = physgen::StoredField<StoredRecord, 9, physgen::shape::Matrix<3, 3>, typename Formats::F, Real>;
  using stretch = physgen::StoredField<StoredRecord, 10, physgen::shape::Diagonal<3>, typename Formats::stretch, Real>;
  using spin = physgen::StoredField<StoredRecord, 11, physgen::shape::Skew<3>, typename Formats::spin, Real>;
  using R = physgen::StoredField<StoredRecord, 12, physgen::shape::Rotation, typename Formats::R, Real>;
  using R32 = physgen::StoredField<StoredRecord, 13, physgen::shape::Rotation, typename Formats::R32, Real>;
  using R64 = physgen::StoredField<StoredRecord, 14, physgen::shape::Rotation, typename Formats::R64, Real>;
  using Rhalf = physgen::StoredField<StoredRecord, 15, physgen::shape::Rotation, typename Formats::Rhalf, Real>;
  using Rbfloat = physgen::StoredField<StoredRecord, 16, physgen::shape::Rotation, typename Formats::Rbfloat, Real>;
  using R16 = physgen::StoredField<StoredRecord, 17, physgen::shape::Rotation, typename Formats::R16, Real>;
  using entries = physgen::StoredField<StoredRecord, 18, physgen::shape::Rotation, typename Formats::entries, Real>;
  using halves = physgen::StoredField<StoredRecord, 19, physgen::shape::Scalar, typename Formats::halves, Real, 5>;
  using turns = physgen::StoredField<StoredRecord, 20, physgen::shape::Rotation, typename Formats::turns, Real, 3>;
  using many = physgen::StoredField<StoredRecord, 21, physgen::shape::Rotation, typename Formats::many, Real, 33>;
  using count = physgen::StoredField<StoredRecord, 22, physgen::shape::Scalar, typename Formats::count, std::int32_t>;
  using frame = physgen::NestedField<StoredRecord, 23, FrameObject, typename Formats::frame, Real>;
  using frames = physgen::NestedField<StoredRecord, 24, FrameObject, typename Formats::frames, Real, 2>;
  using fields_ = physgen::RecordFields<
      single, twice, narrowed, plain_half, load, wide, angle, temperature, stress, F, stretch, spin, R, R32, R64, Rhalf,
      Rbfloat, R16, entries, halves, turns, many, count, frame, frames>;
};

template <class Real, class Formats, class Cursor>
struct StoredRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = StoredRecord<Real, Formats>;
  using Value = Stored<typename Cursor::template Lanes<Real>>;

  /// Stored as float, relative error up to 6e-8.
  PHYSGEN_FUNCTION decltype(auto) single() const {
    return this->field_(typename Record::single(), Record::single::offset);
  }
  /// Stored as double, relative error up to 1.2e-16.
  PHYSGEN_FUNCTION decltype(auto) twice() const {
    return this->field_(typename Record::twice(), Record::twice::offset);
  }
  /// Stored as float, relative error up to 6e-8.
  PHYSGEN_FUNCTION decltype(auto) narrowed() const {
    return this->field_(typename Record::narrowed(), Record::narrowed::offset);
  }
  /// Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) plain_half() const {
    return this->field_(typename Record::plain_half(), Record::plain_half::offset);
  }
  /// External force. [N] Range [0, 1e+06]; initially 1000. Stored as half, relative error up to 4.9e-4 for sizes from
  /// 0.002 to 2.1e+06.
  PHYSGEN_FUNCTION decltype(auto) load() const { return this->field_(typename Record::load(), Record::load::offset); }
  /// Stored as bfloat16, relative error up to 3.9e-3.
  PHYSGEN_FUNCTION decltype(auto) wide() const { return this->field_(typename Record::wide(), Record::wide::offset); }
  /// [rad]. Range [-3.25, 3.25]; initially 0.5. Stored as 16-bit steps over [-3.25, 3.25], error up to 5e-05.
  PHYSGEN_FUNCTION decltype(auto) angle() const {
    return this->field_(typename Record::angle(), Record::angle::offset);
  }
  /// [K]. Range [273, 373]; initially 310. Stored on CUDA as 16-bit steps over [273, 373], error up to 0.00081.
  PHYSGEN_FUNCTION decltype(auto) temperature() const {
    return this->field_(typename Record::temperature(), Record::temperature::offset);
  }
  /// [Pa]. Symmetric, 6 stored. Range [-1e+07, 1e+07]. Stored on the host as half, relative error up to 4.9e-4 for
  /// sizes from 0.031 to 3.4e+07; on CUDA as bfloat16, relative error up to 3.9e-3.
  PHYSGEN_FUNCTION decltype(auto) stress() const {
    return this->field_(typename Record::stress(), Record::stress::offset);
  }
  /// Stored on CUDA as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) F() const { return this->field_(typename Record::F(), Record::F::offset); }
  /// Diagonal, 3 stored. Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) stretch() const {
    return this->field_(typename Record::stretch(), Record::stretch::offset);
  }
  /// Skew-symmetric, 3 stored. Range [-8, 8]. Stored as 16-bit steps over [-8, 8], error up to 0.00013.
  PHYSGEN_FUNCTION decltype(auto) spin() const { return this->field_(typename Record::spin(), Record::spin::offset); }
  /// Rotation, 9 stored. Stored on CUDA as unit quaternion, error of an entry up to 10 eps.
  PHYSGEN_FUNCTION decltype(auto) R() const { return this->field_(typename Record::R(), Record::R::offset); }
  /// Rotation, 9 stored. Stored as unit quaternion of floats, error of an entry up to 1.2e-6.
  PHYSGEN_FUNCTION decltype(auto) R32() const { return this->field_(typename Record::R32(), Record::R32::offset); }
  /// Rotation, 9 stored. Stored as unit quaternion of doubles, error of an entry up to 10 eps.
  PHYSGEN_FUNCTION decltype(auto) R64() const { return this->field_(typename Record::R64(), Record::R64::offset); }
  /// Rotation, 9 stored. Stored as unit quaternion of halves, error of an entry up to 2e-3.
  PHYSGEN_FUNCTION decltype(auto) Rhalf() const {
    return this->field_(typename Record::Rhalf(), Record::Rhalf::offset);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of bfloat16, error of an entry up to 1.6e-2.
  PHYSGEN_FUNCTION decltype(auto) Rbfloat() const {
    return this->field_(typename Record::Rbfloat(), Record::Rbfloat::offset);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.
  PHYSGEN_FUNCTION decltype(auto) R16() const { return this->field_(typename Record::R16(), Record::R16::offset); }
  /// Rotation, 9 stored. Stored on the host as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04; on
  /// CUDA as 16-bit steps over [-1, 1], error up to 1.6e-05.
  PHYSGEN_FUNCTION decltype(auto) entries() const {
    return this->field_(typename Record::entries(), Record::entries::offset);
  }
  /// Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  /// @pre 0 <= entry < 5
  PHYSGEN_FUNCTION decltype(auto) halves(int entry) const {
    physgen::check_inner(entry, 5, "an entry of tissue::model::Stored::halves");
    return this->field_(typename Record::halves(), Record::halves::offset + entry * Record::halves::stride);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of halves, error of an entry up to 2e-3.
  /// @pre 0 <= entry < 3
  PHYSGEN_FUNCTION decltype(auto) turns(int entry) const {
    physgen::check_inner(entry, 3, "an entry of tissue::model::Stored::turns");
    return this->field_(typename Record::turns(), Record::turns::offset + entry * Record::turns::stride);
  }
  /// Rotation, 9 stored. Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.
  /// @pre 0 <= entry < 33
  PHYSGEN_FUNCTION decltype(auto) many(int entry) const {
    physgen::check_inner(entry, 33, "an entry of tissue::model::Stored::many");
    return this->field_(typename Record::many(), Record::many::offset + entry * Record::many::stride);
  }
  /// Initially 7.
  PHYSGEN_FUNCTION decltype(auto) count() const {
    return this->field_(typename Record::count(), Record::count::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) frame() const {
    return this->field_(typename Record::frame(), Record::frame::offset);
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) frames(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Stored::frames");
    return this->field_(typename Record::frames(), Record::frames::offset + entry * Record::frames::stride);
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
};

struct StoredObject : physgen::ObjectTagPerSpace<
    StoredObject, Stored, StoredFormats, StoredRecord, StoredRef, StoredProbe> {
  static constexpr std::string_view name = "tissue::model::Stored";
  static constexpr std::array<physgen::FieldText, 32> texts = {{
      {"single"}, {"twice"}, {"narrowed"}, {"plain_half"}, {"load", "N", 1000.0}, {"wide"}, {"angle", "rad", 0.5},
      {"temperature", "K", 310.0}, {"stress", "Pa"}, {"F"}, {"stretch"}, {"spin"}, {"R"}, {"R32"}, {"R64"}, {"Rhalf"},
      {"Rbfloat"}, {"R16"}, {"entries"}, {"halves"}, {"turns"}, {"many"}, {"count", "", 7.0}, {"frame.turn"},
      {"frame.origin", "m"}, {"frame.weight", "", 0.25}, {"frames[0].turn"}, {"frames[0].origin", "m"},
      {"frames[0].weight", "", 0.25}, {"frames[1].turn"}, {"frames[1].origin", "m"}, {"frames[1].weight", "", 0.25}}};
  static constexpr std::array<std::string_view, 25> docs = {
    "", "", "", "", "External force.", "", "", "", "", "", "", "", "", "", "", "", "", "", "", "", "", "", "", "",
    "",
  };
};

template <class Real, class Layout, class Space = physgen::Host,
          class Formats = physgen::FormatsOf<StoredObject, Space>>
using StoredView = physgen::View<StoredObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<8>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<StoredObject, Space>>
using StoredArray = physgen::Array<StoredObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<StoredObject, physgen::Host>(
    {612, 8, {40, 0, 44, 240, 242, 244, 246, 48, 248, 52, 260, 266, 88, 124, 8, 272, 280, 288, 296, 314, 324, 348, 140,
        144, 160, 172, 176, 192, 204, 208, 224, 236}},
    {784, 8, {384, 0, 388, 412, 414, 416, 418, 8, 420, 16, 432, 438, 88, 392, 160, 444, 452, 460, 468, 486, 496, 520,
        408, 192, 224, 248, 256, 288, 312, 320, 352, 376}}));
static_assert(physgen::are_sound_records<StoredObject, physgen::Cuda>(
    {524, 8, {40, 0, 44, 84, 86, 88, 90, 92, 94, 106, 124, 130, 48, 64, 8, 136, 144, 152, 160, 178, 188, 212, 80, 476,
        484, 490, 492, 500, 506, 508, 516, 522}},
    {540, 8, {72, 0, 76, 100, 102, 104, 106, 108, 110, 122, 140, 146, 8, 80, 40, 152, 160, 168, 176, 194, 204, 228, 96,
        492, 500, 506, 508, 516, 522, 524, 532, 538}}));

// ---- Marks ----------------------------------------------------------------------------------------------------------

/// Integers of 64 bits and bools, in every shape that has them.
template <class Real>
struct Marks {
  /// Initially -9223372036854775808.
  physgen::same_lanes_t<Real, std::int64_t> lowest = -9223372036854775807 - 1;
  /// Initially 18446744073709549568.
  physgen::same_lanes_t<Real, std::uint64_t> key = 18446744073709549568U;
  /// whether it takes part. Initially 1.
  physgen::same_lanes_t<Real, bool> alive = true;
  physgen::MatrixValue<physgen::same_lanes_t<Real, bool>, 3, 1> fixed = decltype(fixed)::Zero();
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int64_t>, 2, 2> counts = decltype(counts)::Zero();
  /// Symmetric, 6 stored.
  physgen::MatrixValue<physgen::same_lanes_t<Real, bool>, 3, 3> touches = decltype(touches)::Zero();
  /// Diagonal, 2 stored.
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::uint64_t>, 2, 1> hashes = decltype(hashes)::Zero();
  /// Skew-symmetric, 3 stored.
  physgen::MatrixValue<physgen::same_lanes_t<Real, std::int64_t>, 3, 3> turns = decltype(turns)::Zero();
  physgen::same_lanes_t<Real, bool> flags[5] = {};
  physgen::same_lanes_t<Real, std::int64_t> history[2] = {};
  /// [kg]. Stored on the host as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  Real weight = {};
};

template <class Space>
struct MarksFormats {
  using lowest = physgen::format::Native;
  using key = physgen::format::Native;
  using alive = physgen::format::Native;
  using fixed = physgen::format::Native;
  using counts = physgen::format::Native;
  using touches = physgen::format::Native;
  using hashes = physgen::format::Native;
  using turns = physgen::format::Native;
  using flags = physgen::format::Native;
  using history = physgen::format::Native;
  using weight = physgen::PerSpace<Space, physgen::format::Half<>, physgen::format::Native>;
};

struct MarksObject;
template <class ArrayTag, class Base = MarksFormats<physgen::Host>, class Object = MarksObject, int first = 0>
struct MarksProbe {
  using array_ = ArrayTag;
  using lowest = physgen::Probe<ArrayTag, Object, first + 0, typename Base::lowest>;
  using key = physgen::Probe<ArrayTag, Object, first + 1, typename Base::key>;
  using alive = physgen::Probe<ArrayTag, Object, first + 2, typename Base::alive>;
  using fixed = physgen::Probe<ArrayTag, Object, first + 3, typename Base::fixed>;
  using counts = physgen::Probe<ArrayTag, Object, first + 4, typename Base::counts>;
  using touches = physgen::Probe<ArrayTag, Object, first + 5, typename Base::touches>;
  using hashes = physgen::Probe<ArrayTag, Object, first + 6, typename Base::hashes>;
  using turns = physgen::Probe<ArrayTag, Object, first + 7, typename Base::turns>;
  using flags = physgen::Probe<ArrayTag, Object, first + 8, typename Base::flags>;
  using history = physgen::Probe<ArrayTag, Object, first + 9, typename Base::history>;
  using weight = physgen::Probe<ArrayTag, Object, first + 10, typename Base::weight>;
};

template <class Real, class Formats>
struct MarksRecord {
  using lowest = physgen::StoredField<MarksRecord, 0, physgen::shape::Scalar, typename Formats::lowest, std::int64_t>;
  using key = physgen::StoredField<MarksRecord, 1, physgen::shape::Scalar, typename Formats::key, std::uint64_t>;
  using alive = physgen::StoredField<MarksRecord, 2, physgen::shape::Scalar, typename Formats::alive, bool>;
  using fixed = physgen::StoredField<MarksRecord, 3, physgen::shape::Vector<3>, typename Formats::fixed, bool>;
  using counts = physgen::StoredField<
      MarksRecord, 4, physgen::shape::Matrix<2, 2>, typename Formats::counts, std::int64_t>;
  using touches = physgen::StoredField<MarksRecord, 5, physgen::shape::Symmetric<3>, typename Formats::touches, bool>;
  using hashes = physgen::StoredField<
      MarksRecord, 6, physgen::shape::Diagonal<2>, typename Formats::hashes, std::uint64_t>;
  using turns = physgen::StoredField<MarksRecord, 7, physgen::shape::Skew<3>, typename Formats::turns, std::int64_t>;
  using flags = physgen::StoredField<MarksRecord, 8, physgen::shape::Scalar, typename Formats::flags, bool, 5>;
  using history = physgen::StoredField<
      MarksRecord, 9, physgen::shape::Scalar, typename Formats::history, std::int64_t, 2>;
  using weight = physgen::StoredField<MarksRecord, 10, physgen::shape::Scalar, typename Formats::weight, Real>;
  using fields_ = physgen::RecordFields<
      lowest, key, alive, fixed, counts, touches, hashes, turns, flags, history, weight>;
};

template <class Real, class Formats, class Cursor>
struct MarksRef : physgen::OnCursor<Cursor> {
  using physgen::OnCursor<Cursor>::OnCursor;
  using Record = MarksRecord<Real, Formats>;
  using Value = Marks<typename Cursor::template Lanes<Real>>;

  /// Initially -9223372036854775808.
  PHYSGEN_FUNCTION decltype(auto) lowest() const {
    return this->field_(typename Record::lowest(), Record::lowest::offset);
  }
  /// Initially 18446744073709549568.
  PHYSGEN_FUNCTION decltype(auto) key() const { return this->field_(typename Record::key(), Record::key::offset); }
  /// whether it takes part. Initially 1.
  PHYSGEN_FUNCTION decltype(auto) alive() const {
    return this->field_(typename Record::alive(), Record::alive::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) fixed() const {
    return this->field_(typename Record::fixed(), Record::fixed::offset);
  }
  PHYSGEN_FUNCTION decltype(auto) counts() const {
    return this->field_(typename Record::counts(), Record::counts::offset);
  }
  /// Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) touches() const {
    return this->field_(typename Record::touches(), Record::touches::offset);
  }
  /// Diagonal, 2 stored.
  PHYSGEN_FUNCTION decltype(auto) hashes() const {
    return this->field_(typename Record::hashes(), Record::hashes::offset);
  }
  /// Skew-symmetric, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) turns() const {
    return this->field_(typename Record::turns(), Record::turns::offset);
  }
  /// @pre 0 <= entry < 5
  PHYSGEN_FUNCTION decltype(auto) flags(int entry) const {
    physgen::check_inner(entry, 5, "an entry of tissue::model::Marks::flags");
    return this->field_(typename Record::flags(), Record::flags::offset + entry * Record::flags::stride);
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) history(int entry) const {
    physgen::check_inner(entry, 2, "an entry of tissue::model::Marks::history");
    return this->field_(typename Record::history(), Record::history::offset + entry * Record::history::stride);
  }
  /// [kg]. Stored on the host as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.
  PHYSGEN_FUNCTION decltype(auto) weight() const {
    return this->field_(typename Record::weight(), Record::weight::offset);
  }

  PHYSGEN_FUNCTION const Value get() const {
    return {
        lowest(), key(), alive(), fixed().get(), counts().get(), touches().get(), hashes().get(), turns().get(),
        {flags(0), flags(1), flags(2), flags(3), flags(4)}, {history(0), history(1)}, weight()};
  }
  PHYSGEN_FUNCTION void put(const Value& value) const {
    lowest() = value.lowest;
    key() = value.key;
    alive() = value.alive;
    fixed() = value.fixed;
    counts() = value.counts;
    touches() = value.touches;
    hashes() = value.hashes;
    turns() = value.turns;
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 5; ++entry) flags(entry) = value.flags[entry];
    PHYSGEN_UNROLL
    for (int entry = 0; entry < 2; ++entry) history(entry) = value.history[entry];
    weight() = value.weight;
  }
};

struct MarksObject : physgen::ObjectTagPerSpace<MarksObject, Marks, MarksFormats, MarksRecord, MarksRef, MarksProbe> {
  static constexpr std::string_view name = "tissue::model::Marks";
  static constexpr std::array<physgen::FieldText, 11> texts = {{
      {"lowest", "", -9223372036854775808.0}, {"key", "", 18446744073709549568.0}, {"alive", "", 1.0}, {"fixed"},
      {"counts"}, {"touches"}, {"hashes"}, {"turns"}, {"flags"}, {"history"}, {"weight", "kg"}}};
  static constexpr std::array<std::string_view, 11> docs = {
    "", "", "whether it takes part", "", "", "", "", "", "", "", "",
  };
};

template <class Real, class Layout, class Space = physgen::Host, class Formats = physgen::FormatsOf<MarksObject, Space>>
using MarksView = physgen::View<MarksObject, Real, Layout, Formats, Space>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,
          class Formats = physgen::FormatsOf<MarksObject, Space>>
using MarksArray = physgen::Array<MarksObject, Real, Space, Layout, Formats>;
static_assert(physgen::are_sound_records<MarksObject, physgen::Host>(
    {121, 8, {0, 8, 106, 107, 16, 110, 48, 64, 116, 88, 104}},
    {121, 8, {0, 8, 106, 107, 16, 110, 48, 64, 116, 88, 104}}));
static_assert(physgen::are_sound_records<MarksObject, physgen::Cuda>(
    {123, 8, {0, 8, 108, 109, 16, 112, 48, 64, 118, 88, 104}},
    {127, 8, {0, 8, 112, 113, 16, 116, 48, 64, 122, 88, 104}}));

}  // namespace tissue::model

#endif  // PHYSGEN_EVERYTHING_H_895ABB68E92A69F6
