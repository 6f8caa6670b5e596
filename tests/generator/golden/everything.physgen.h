// Accessor classes of the object types in everything.h. Written by physgen: change the schema, not this file.
#pragma once

#include <physgen/runtime.h>

#if PHYSGEN_RUNTIME_VERSION != 1
#error "everything.physgen.h is for version 1 of the physgen runtime: generate it again with the installed physgen"
#endif

#include "materials.physgen.h"

// ---- Stamp ----------------------------------------------------------------------------------------------------------

/// A moment; in the global namespace.
/// @tparam Real float, double, or a SIMD batch of one of them
template <class Real>
struct Stamp {
  /// [s]
  physgen::same_lanes_t<Real, double> time;
  physgen::same_lanes_t<Real, std::int32_t> step;
};

/// Where each field begins in the record of one Stamp [bytes].
template <class Real>
struct StampRecord {
  static constexpr int time = 0;
  static constexpr int step = 8;
  static constexpr int bytes = 12;
  static constexpr int alignment = 8;
};

/// One Stamp of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class StampRef {
  using Record = StampRecord<Real>;

 public:
  using Value = Stamp<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit StampRef(const Cursor& cursor) : at_(cursor) {}

  /// [s]
  PHYSGEN_FUNCTION decltype(auto) time() const { return at_.template element<double>(Record::time); }
  PHYSGEN_FUNCTION decltype(auto) step() const { return at_.template element<std::int32_t>(Record::step); }

  PHYSGEN_FUNCTION Value get() const {
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
  static constexpr std::string_view name = "Stamp";
  template <class Real>
  using Value = Stamp<Real>;
  template <class Real>
  using Record = StampRecord<Real>;
  template <class Real, class Cursor>
  using Ref = StampRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 2> fields = {{
      {"time", "s", physgen::ElementType::float64, StampRecord<Real>::time, 1, 0},
      {"step", "", physgen::ElementType::int32, StampRecord<Real>::step, 1, 0},
  }};
};

template <class Real, class Layout>
using StampView = physgen::View<StampObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using StampArray = physgen::Array<StampObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<StampObject, float>(12, 8));
static_assert(physgen::is_sound_record<StampObject, double>(12, 8));

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

/// Where each field begins in the record of one Shapes [bytes].
template <class Real>
struct ShapesRecord {
  static constexpr int C2 = 0;
  static constexpr int M = 24;
  static constexpr int a = 56;
  static constexpr int v = physgen::by_precision<Real>(60, 64);
  static constexpr int F = physgen::by_precision<Real>(72, 88);
  static constexpr int B = physgen::by_precision<Real>(108, 160);
  static constexpr int row = physgen::by_precision<Real>(132, 208);
  static constexpr int K = physgen::by_precision<Real>(148, 240);
  static constexpr int s = physgen::by_precision<Real>(172, 288);
  static constexpr int W = physgen::by_precision<Real>(184, 312);
  static constexpr int U = physgen::by_precision<Real>(196, 336);
  static constexpr int nodes = physgen::by_precision<Real>(232, 408);
  static constexpr int V = physgen::by_precision<Real>(248, 424);
  static constexpr int count = physgen::by_precision<Real>(284, 460);
  static constexpr int bytes = physgen::by_precision<Real>(292, 468);
  static constexpr int alignment = 8;
};

/// One Shapes of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class ShapesRef {
  using Record = ShapesRecord<Real>;

 public:
  using Value = Shapes<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit ShapesRef(const Cursor& cursor) : at_(cursor) {}

  /// Scalar.
  PHYSGEN_FUNCTION decltype(auto) a() const { return at_.template element<Real>(Record::a); }
  PHYSGEN_FUNCTION decltype(auto) v() const { return at_.template field<physgen::shape::Vector<3>, Real>(Record::v); }
  /// corners i, j, k, l
  PHYSGEN_FUNCTION decltype(auto) nodes() const {
    return at_.template field<physgen::shape::Vector<4>, std::int32_t>(Record::nodes);
  }
  /// deformation gradient [1]
  PHYSGEN_FUNCTION decltype(auto) F() const {
    return at_.template field<physgen::shape::Matrix<3, 3>, Real>(Record::F);
  }
  PHYSGEN_FUNCTION decltype(auto) B() const {
    return at_.template field<physgen::shape::Matrix<2, 3>, Real>(Record::B);
  }
  PHYSGEN_FUNCTION decltype(auto) row() const {
    return at_.template field<physgen::shape::Matrix<1, 4>, Real>(Record::row);
  }
  /// [N/m]. Symmetric, 6 stored.
  PHYSGEN_FUNCTION decltype(auto) K() const {
    return at_.template field<physgen::shape::Symmetric<3>, Real>(Record::K);
  }
  /// Symmetric, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) C2() const {
    return at_.template field<physgen::shape::Symmetric<2>, double>(Record::C2);
  }
  /// Diagonal, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) s() const { return at_.template field<physgen::shape::Diagonal<3>, Real>(Record::s); }
  /// [1/s]. Skew-symmetric, 3 stored.
  PHYSGEN_FUNCTION decltype(auto) W() const { return at_.template field<physgen::shape::Skew<3>, Real>(Record::W); }
  /// principal directions. Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) U() const { return at_.template field<physgen::shape::Rotation, Real>(Record::U); }
  /// Rotation, 9 stored.
  PHYSGEN_FUNCTION decltype(auto) V() const { return at_.template field<physgen::shape::Rotation, float>(Record::V); }
  PHYSGEN_FUNCTION decltype(auto) count() const {
    return at_.template field<physgen::shape::Vector<2>, std::int32_t>(Record::count);
  }
  PHYSGEN_FUNCTION decltype(auto) M() const {
    return at_.template field<physgen::shape::Matrix<2, 2>, double>(Record::M);
  }

  PHYSGEN_FUNCTION Value get() const {
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
  template <class Real>
  using Record = ShapesRecord<Real>;
  template <class Real, class Cursor>
  using Ref = ShapesRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 14> fields = {{
      {"a", "", physgen::element_type<Real>, ShapesRecord<Real>::a, 1, 0},
      {"v", "", physgen::element_type<Real>, ShapesRecord<Real>::v, 3, 0},
      {"nodes", "", physgen::ElementType::int32, ShapesRecord<Real>::nodes, 4, 0},
      {"F", "1", physgen::element_type<Real>, ShapesRecord<Real>::F, 9, 0},
      {"B", "", physgen::element_type<Real>, ShapesRecord<Real>::B, 6, 0},
      {"row", "", physgen::element_type<Real>, ShapesRecord<Real>::row, 4, 0},
      {"K", "N/m", physgen::element_type<Real>, ShapesRecord<Real>::K, 6, 0},
      {"C2", "", physgen::ElementType::float64, ShapesRecord<Real>::C2, 3, 0},
      {"s", "", physgen::element_type<Real>, ShapesRecord<Real>::s, 3, 0},
      {"W", "1/s", physgen::element_type<Real>, ShapesRecord<Real>::W, 3, 0},
      {"U", "", physgen::element_type<Real>, ShapesRecord<Real>::U, 9, 0},
      {"V", "", physgen::ElementType::float32, ShapesRecord<Real>::V, 9, 0},
      {"count", "", physgen::ElementType::int32, ShapesRecord<Real>::count, 2, 0},
      {"M", "", physgen::ElementType::float64, ShapesRecord<Real>::M, 4, 0},
  }};
};

template <class Real, class Layout>
using ShapesView = physgen::View<ShapesObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using ShapesArray = physgen::Array<ShapesObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<ShapesObject, float>(292, 8));
static_assert(physgen::is_sound_record<ShapesObject, double>(468, 8));

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
  Real Space;
  Real field;
  Real element;
  Real nested;
  Real self[2];
  Eigen::Matrix<Real, 2, 1> tissue;
};

/// Where each field begins in the record of one Names [bytes].
template <class Real>
struct NamesRecord {
  static constexpr int value = 0;
  static constexpr int entry = sizeof(Real);
  static constexpr int S = 2 * sizeof(Real);
  static constexpr int R = 3 * sizeof(Real);
  static constexpr int at = 4 * sizeof(Real);
  static constexpr int cursor = 5 * sizeof(Real);
  static constexpr int name = 6 * sizeof(Real);
  static constexpr int fields = 7 * sizeof(Real);
  static constexpr int Layout = 8 * sizeof(Real);
  static constexpr int Space = 9 * sizeof(Real);
  static constexpr int field = 10 * sizeof(Real);
  static constexpr int element = 11 * sizeof(Real);
  static constexpr int nested = 12 * sizeof(Real);
  static constexpr int self = 13 * sizeof(Real);
  static constexpr int tissue = 15 * sizeof(Real);
  static constexpr int bytes = 17 * sizeof(Real);
  static constexpr int alignment = sizeof(Real);
};

/// One Names of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class NamesRef {
  using Record = NamesRecord<Real>;

 public:
  using Value = Names<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit NamesRef(const Cursor& cursor) : at_(cursor) {}

  PHYSGEN_FUNCTION decltype(auto) value() const { return at_.template element<Real>(Record::value); }
  PHYSGEN_FUNCTION decltype(auto) entry() const { return at_.template element<Real>(Record::entry); }
  PHYSGEN_FUNCTION decltype(auto) S() const { return at_.template element<Real>(Record::S); }
  PHYSGEN_FUNCTION decltype(auto) R() const { return at_.template element<Real>(Record::R); }
  PHYSGEN_FUNCTION decltype(auto) at() const { return at_.template element<Real>(Record::at); }
  PHYSGEN_FUNCTION decltype(auto) cursor() const { return at_.template element<Real>(Record::cursor); }
  PHYSGEN_FUNCTION decltype(auto) name() const { return at_.template element<Real>(Record::name); }
  PHYSGEN_FUNCTION decltype(auto) fields() const { return at_.template element<Real>(Record::fields); }
  PHYSGEN_FUNCTION decltype(auto) Layout() const { return at_.template element<Real>(Record::Layout); }
  PHYSGEN_FUNCTION decltype(auto) Space() const { return at_.template element<Real>(Record::Space); }
  PHYSGEN_FUNCTION decltype(auto) field() const { return at_.template element<Real>(Record::field); }
  PHYSGEN_FUNCTION decltype(auto) element() const { return at_.template element<Real>(Record::element); }
  PHYSGEN_FUNCTION decltype(auto) nested() const { return at_.template element<Real>(Record::nested); }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) self(int entry) const {
    return at_.template element<Real>(Record::self + entry * int{sizeof(Real)});
  }
  PHYSGEN_FUNCTION decltype(auto) tissue() const {
    return at_.template field<physgen::shape::Vector<2>, Real>(Record::tissue);
  }

  PHYSGEN_FUNCTION Value get() const {
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
    value_.Space = Space();
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
    Space() = value_.Space;
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
  template <class Real>
  using Record = NamesRecord<Real>;
  template <class Real, class Cursor>
  using Ref = NamesRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 15> fields = {{
      {"value", "", physgen::element_type<Real>, NamesRecord<Real>::value, 1, 0},
      {"entry", "", physgen::element_type<Real>, NamesRecord<Real>::entry, 1, 0},
      {"S", "", physgen::element_type<Real>, NamesRecord<Real>::S, 1, 0},
      {"R", "", physgen::element_type<Real>, NamesRecord<Real>::R, 1, 0},
      {"at", "", physgen::element_type<Real>, NamesRecord<Real>::at, 1, 0},
      {"cursor", "", physgen::element_type<Real>, NamesRecord<Real>::cursor, 1, 0},
      {"name", "", physgen::element_type<Real>, NamesRecord<Real>::name, 1, 0},
      {"fields", "", physgen::element_type<Real>, NamesRecord<Real>::fields, 1, 0},
      {"Layout", "", physgen::element_type<Real>, NamesRecord<Real>::Layout, 1, 0},
      {"Space", "", physgen::element_type<Real>, NamesRecord<Real>::Space, 1, 0},
      {"field", "", physgen::element_type<Real>, NamesRecord<Real>::field, 1, 0},
      {"element", "", physgen::element_type<Real>, NamesRecord<Real>::element, 1, 0},
      {"nested", "", physgen::element_type<Real>, NamesRecord<Real>::nested, 1, 0},
      {"self", "", physgen::element_type<Real>, NamesRecord<Real>::self, 2, 0},
      {"tissue", "", physgen::element_type<Real>, NamesRecord<Real>::tissue, 2, 0},
  }};
};

template <class Real, class Layout>
using NamesView = physgen::View<NamesObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using NamesArray = physgen::Array<NamesObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<NamesObject, float>(68, 4));
static_assert(physgen::is_sound_record<NamesObject, double>(136, 8));

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

/// Where each field begins in the record of one Entries [bytes].
template <class Real>
struct EntriesRecord {
  static constexpr int history = 0;
  static constexpr int weights = 320;
  static constexpr int k = physgen::by_precision<Real>(340, 360);
  static constexpr int entry = physgen::by_precision<Real>(436, 552);
  static constexpr int flags = physgen::by_precision<Real>(444, 568);
  static constexpr int edges = physgen::by_precision<Real>(456, 580);
  static constexpr int bytes = physgen::by_precision<Real>(504, 628);
  static constexpr int alignment = 8;
};

/// One Entries of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class EntriesRef {
  using Record = EntriesRecord<Real>;

 public:
  using Value = Entries<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit EntriesRef(const Cursor& cursor) : at_(cursor) {}

  /// Weights of the five points.
  /// They sum to one. [1] Range [0, 1].
  /// @pre 0 <= entry < 5
  PHYSGEN_FUNCTION decltype(auto) weights(int entry) const {
    return at_.template element<Real>(Record::weights + entry * int{sizeof(Real)});
  }
  /// [N/m]. Symmetric, 6 stored.
  /// @pre 0 <= entry < 4
  PHYSGEN_FUNCTION decltype(auto) k(int entry) const {
    return at_.template field<physgen::shape::Symmetric<3>, Real>(Record::k + entry * int{6 * sizeof(Real)});
  }
  /// @pre 0 <= entry < 3
  PHYSGEN_FUNCTION decltype(auto) flags(int entry) const {
    return at_.template element<std::int32_t>(Record::flags + entry * 4);
  }
  /// More entries than are worth unrolling
  /// @pre 0 <= entry < 40
  PHYSGEN_FUNCTION decltype(auto) history(int entry) const {
    return at_.template element<double>(Record::history + entry * 8);
  }
  /// @pre 0 <= entry < 6
  PHYSGEN_FUNCTION decltype(auto) edges(int entry) const {
    return at_.template field<physgen::shape::Vector<2>, std::int32_t>(Record::edges + entry * 8);
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION decltype(auto) entry(int entry) const {
    return at_.template element<Real>(Record::entry + entry * int{sizeof(Real)});
  }

  PHYSGEN_FUNCTION Value get() const {
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
  template <class Real>
  using Record = EntriesRecord<Real>;
  template <class Real, class Cursor>
  using Ref = EntriesRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 6> fields = {{
      {"weights", "1", physgen::element_type<Real>, EntriesRecord<Real>::weights, 5, 0},
      {"k", "N/m", physgen::element_type<Real>, EntriesRecord<Real>::k, 24, 0},
      {"flags", "", physgen::ElementType::int32, EntriesRecord<Real>::flags, 3, 0},
      {"history", "", physgen::ElementType::float64, EntriesRecord<Real>::history, 40, 0},
      {"edges", "", physgen::ElementType::int32, EntriesRecord<Real>::edges, 12, 0},
      {"entry", "", physgen::element_type<Real>, EntriesRecord<Real>::entry, 2, 0},
  }};
};

template <class Real, class Layout>
using EntriesView = physgen::View<EntriesObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using EntriesArray = physgen::Array<EntriesObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<EntriesObject, float>(504, 8));
static_assert(physgen::is_sound_record<EntriesObject, double>(628, 8));

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
  Real density = physgen::all_lanes<Real>(1060);
  /// Range [0, 0.5]; initially 0.45.
  Real nu = physgen::all_lanes<Real>(0.45);
  /// [1]. Initially 0.5.
  Eigen::Matrix<Real, 3, 1> direction = decltype(direction)::Constant(physgen::all_lanes<Real>(0.5));
  /// Symmetric, 6 stored. Initially 1.
  Eigen::Matrix<Real, 3, 3> metric = decltype(metric)::Constant(physgen::all_lanes<Real>(1));
  /// Initially -1.
  physgen::same_lanes_t<Real, std::int32_t> label = -1;
  /// Initially 7.
  Eigen::Matrix<physgen::same_lanes_t<Real, std::int32_t>, 2, 1> group = decltype(group)::Constant(7);
  /// Skew-symmetric, 3 stored. Initially 0.25 in a new array.
  Eigen::Matrix<Real, 3, 3> spin;
  /// Initially 1e-12.
  physgen::same_lanes_t<Real, double> fixed = 1e-12;
};

/// Where each field begins in the record of one Options [bytes].
template <class Real>
struct OptionsRecord {
  static constexpr int fixed = 0;
  static constexpr int density = 8;
  static constexpr int nu = physgen::by_precision<Real>(12, 16);
  static constexpr int direction = physgen::by_precision<Real>(16, 24);
  static constexpr int metric = physgen::by_precision<Real>(28, 48);
  static constexpr int spin = physgen::by_precision<Real>(52, 96);
  static constexpr int label = physgen::by_precision<Real>(64, 120);
  static constexpr int group = physgen::by_precision<Real>(68, 124);
  static constexpr int bytes = physgen::by_precision<Real>(76, 132);
  static constexpr int alignment = 32;
};

/// One Options of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class OptionsRef {
  using Record = OptionsRecord<Real>;

 public:
  using Value = Options<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit OptionsRef(const Cursor& cursor) : at_(cursor) {}

  /// Mass per volume of the rest shape. [kg/m^3] Range [0, 20000]; initially 1060.
  PHYSGEN_FUNCTION decltype(auto) density() const { return at_.template element<Real>(Record::density); }
  /// Range [0, 0.5]; initially 0.45.
  PHYSGEN_FUNCTION decltype(auto) nu() const { return at_.template element<Real>(Record::nu); }
  /// [1]. Initially 0.5.
  PHYSGEN_FUNCTION decltype(auto) direction() const {
    return at_.template field<physgen::shape::Vector<3>, Real>(Record::direction);
  }
  /// Symmetric, 6 stored. Initially 1.
  PHYSGEN_FUNCTION decltype(auto) metric() const {
    return at_.template field<physgen::shape::Symmetric<3>, Real>(Record::metric);
  }
  /// Initially -1.
  PHYSGEN_FUNCTION decltype(auto) label() const { return at_.template element<std::int32_t>(Record::label); }
  /// Initially 7.
  PHYSGEN_FUNCTION decltype(auto) group() const {
    return at_.template field<physgen::shape::Vector<2>, std::int32_t>(Record::group);
  }
  /// Skew-symmetric, 3 stored. Initially 0.25 in a new array.
  PHYSGEN_FUNCTION decltype(auto) spin() const {
    return at_.template field<physgen::shape::Skew<3>, Real>(Record::spin);
  }
  /// Initially 1e-12.
  PHYSGEN_FUNCTION decltype(auto) fixed() const { return at_.template element<double>(Record::fixed); }

  PHYSGEN_FUNCTION Value get() const {
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
  template <class Real>
  using Record = OptionsRecord<Real>;
  template <class Real, class Cursor>
  using Ref = OptionsRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 8> fields = {{
      {"density", "kg/m^3", physgen::element_type<Real>, OptionsRecord<Real>::density, 1, 1060},
      {"nu", "", physgen::element_type<Real>, OptionsRecord<Real>::nu, 1, 0.45},
      {"direction", "1", physgen::element_type<Real>, OptionsRecord<Real>::direction, 3, 0.5},
      {"metric", "", physgen::element_type<Real>, OptionsRecord<Real>::metric, 6, 1},
      {"label", "", physgen::ElementType::int32, OptionsRecord<Real>::label, 1, -1},
      {"group", "", physgen::ElementType::int32, OptionsRecord<Real>::group, 2, 7},
      {"spin", "", physgen::element_type<Real>, OptionsRecord<Real>::spin, 3, 0.25},
      {"fixed", "", physgen::ElementType::float64, OptionsRecord<Real>::fixed, 1, 1e-12},
  }};
};

template <class Real, class Layout>
using OptionsView = physgen::View<OptionsObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Soa, physgen::AosPadded>>
using OptionsArray = physgen::Array<OptionsObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<OptionsObject, float>(76, 32));
static_assert(physgen::is_sound_record<OptionsObject, double>(132, 32));

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
  ::Stamp<Real> stamp;
  Shapes<Real> shapes;
  /// [m^3]
  Real volume;
};

/// Where each field begins in the record of one Element [bytes].
template <class Real>
struct ElementRecord {
  static constexpr int fibres = 0;
  static constexpr int stamp = 48;
  static constexpr int shapes = 64;
  static constexpr int lame = physgen::by_precision<Real>(360, 536);
  static constexpr int volume = physgen::by_precision<Real>(368, 552);
  static constexpr int flag = physgen::by_precision<Real>(372, 560);
  static constexpr int bytes = physgen::by_precision<Real>(376, 564);
  static constexpr int alignment = 8;
};

/// One Element of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class ElementRef {
  using Record = ElementRecord<Real>;

 public:
  using Value = Element<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit ElementRef(const Cursor& cursor) : at_(cursor) {}

  /// Before the nested objects by name, behind them in the record.
  PHYSGEN_FUNCTION decltype(auto) flag() const { return at_.template element<std::int32_t>(Record::flag); }
  /// Constants of the tissue.
  PHYSGEN_FUNCTION ::material::LameRef<Real, Cursor> lame() const {
    return ::material::LameRef<Real, Cursor>(at_.nested(Record::lame));
  }
  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION ::material::FibreRef<Real, Cursor> fibres(int entry) const {
    return ::material::FibreRef<Real, Cursor>(at_.nested(Record::fibres + entry * 24));
  }
  PHYSGEN_FUNCTION ::StampRef<Real, Cursor> stamp() const {
    return ::StampRef<Real, Cursor>(at_.nested(Record::stamp));
  }
  PHYSGEN_FUNCTION ShapesRef<Real, Cursor> shapes() const {
    return ShapesRef<Real, Cursor>(at_.nested(Record::shapes));
  }
  /// [m^3]
  PHYSGEN_FUNCTION decltype(auto) volume() const { return at_.template element<Real>(Record::volume); }

  PHYSGEN_FUNCTION Value get() const {
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
  template <class Real>
  using Record = ElementRecord<Real>;
  template <class Real, class Cursor>
  using Ref = ElementRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 24> fields = {{
      {"flag", "", physgen::ElementType::int32, ElementRecord<Real>::flag, 1, 0},
      {"lame.mu", "Pa", physgen::element_type<Real>, ElementRecord<Real>::lame + ::material::LameRecord<Real>::mu, 1,
       0},
      {"lame.lambda", "Pa", physgen::element_type<Real>,
       ElementRecord<Real>::lame + ::material::LameRecord<Real>::lambda, 1, 0},
      {"fibres[0].direction", "", physgen::ElementType::float32,
       ElementRecord<Real>::fibres + ::material::FibreRecord<Real>::direction, 3, 0},
      {"fibres[0].strength", "Pa", physgen::ElementType::float64,
       ElementRecord<Real>::fibres + ::material::FibreRecord<Real>::strength, 1, 0},
      {"fibres[1].direction", "", physgen::ElementType::float32,
       ElementRecord<Real>::fibres + 1 * 24 + ::material::FibreRecord<Real>::direction, 3, 0},
      {"fibres[1].strength", "Pa", physgen::ElementType::float64,
       ElementRecord<Real>::fibres + 1 * 24 + ::material::FibreRecord<Real>::strength, 1, 0},
      {"stamp.time", "s", physgen::ElementType::float64, ElementRecord<Real>::stamp + ::StampRecord<Real>::time, 1, 0},
      {"stamp.step", "", physgen::ElementType::int32, ElementRecord<Real>::stamp + ::StampRecord<Real>::step, 1, 0},
      {"shapes.a", "", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::a, 1, 0},
      {"shapes.v", "", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::v, 3, 0},
      {"shapes.nodes", "", physgen::ElementType::int32, ElementRecord<Real>::shapes + ShapesRecord<Real>::nodes, 4, 0},
      {"shapes.F", "1", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::F, 9, 0},
      {"shapes.B", "", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::B, 6, 0},
      {"shapes.row", "", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::row, 4, 0},
      {"shapes.K", "N/m", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::K, 6, 0},
      {"shapes.C2", "", physgen::ElementType::float64, ElementRecord<Real>::shapes + ShapesRecord<Real>::C2, 3, 0},
      {"shapes.s", "", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::s, 3, 0},
      {"shapes.W", "1/s", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::W, 3, 0},
      {"shapes.U", "", physgen::element_type<Real>, ElementRecord<Real>::shapes + ShapesRecord<Real>::U, 9, 0},
      {"shapes.V", "", physgen::ElementType::float32, ElementRecord<Real>::shapes + ShapesRecord<Real>::V, 9, 0},
      {"shapes.count", "", physgen::ElementType::int32, ElementRecord<Real>::shapes + ShapesRecord<Real>::count, 2, 0},
      {"shapes.M", "", physgen::ElementType::float64, ElementRecord<Real>::shapes + ShapesRecord<Real>::M, 4, 0},
      {"volume", "m^3", physgen::element_type<Real>, ElementRecord<Real>::volume, 1, 0},
  }};
};

template <class Real, class Layout>
using ElementView = physgen::View<ElementObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aos, physgen::Aosoa<64>>>
using ElementArray = physgen::Array<ElementObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<ElementObject, float>(376, 8));
static_assert(physgen::is_sound_record<ElementObject, double>(564, 8));

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

/// Where each field begins in the record of one Patch [bytes].
template <class Real>
struct PatchRecord {
  static constexpr int elements = 0;
  static constexpr int options = physgen::by_precision<Real>(752, 1136);
  static constexpr int weight = physgen::by_precision<Real>(832, 1272);
  static constexpr int bytes = physgen::by_precision<Real>(836, 1276);
  static constexpr int alignment = 8;
};

/// One Patch of an array, or those under a SIMD index: fields by name, all of them by get and put.
template <class Real, class Cursor>
class PatchRef {
  using Record = PatchRecord<Real>;

 public:
  using Value = Patch<typename Cursor::template Lanes<Real>>;

  PHYSGEN_FUNCTION explicit PatchRef(const Cursor& cursor) : at_(cursor) {}

  /// @pre 0 <= entry < 2
  PHYSGEN_FUNCTION ::tissue::model::ElementRef<Real, Cursor> elements(int entry) const {
    return ::tissue::model::ElementRef<Real, Cursor>(
        at_.nested(Record::elements + entry * physgen::by_precision<Real>(376, 568)));
  }
  PHYSGEN_FUNCTION decltype(auto) weight() const { return at_.template element<float>(Record::weight); }
  PHYSGEN_FUNCTION ::tissue::model::OptionsRef<Real, Cursor> options() const {
    return ::tissue::model::OptionsRef<Real, Cursor>(at_.nested(Record::options));
  }

  PHYSGEN_FUNCTION Value get() const {
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
  template <class Real>
  using Record = PatchRecord<Real>;
  template <class Real, class Cursor>
  using Ref = PatchRef<Real, Cursor>;
  template <class Real>
  static constexpr std::array<physgen::FieldInfo, 57> fields = {{
      {"elements[0].flag", "", physgen::ElementType::int32,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::flag, 1, 0},
      {"elements[0].lame.mu", "Pa", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::lame + ::material::LameRecord<Real>::mu, 1,
       0},
      {"elements[0].lame.lambda", "Pa", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::lame + ::material::LameRecord<Real>::lambda,
       1, 0},
      {"elements[0].fibres[0].direction", "", physgen::ElementType::float32,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::fibres +
           ::material::FibreRecord<Real>::direction,
       3, 0},
      {"elements[0].fibres[0].strength", "Pa", physgen::ElementType::float64,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::fibres +
           ::material::FibreRecord<Real>::strength,
       1, 0},
      {"elements[0].fibres[1].direction", "", physgen::ElementType::float32,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::fibres + 1 * 24 +
           ::material::FibreRecord<Real>::direction,
       3, 0},
      {"elements[0].fibres[1].strength", "Pa", physgen::ElementType::float64,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::fibres + 1 * 24 +
           ::material::FibreRecord<Real>::strength,
       1, 0},
      {"elements[0].stamp.time", "s", physgen::ElementType::float64,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::stamp + ::StampRecord<Real>::time, 1, 0},
      {"elements[0].stamp.step", "", physgen::ElementType::int32,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::stamp + ::StampRecord<Real>::step, 1, 0},
      {"elements[0].shapes.a", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::a,
       1, 0},
      {"elements[0].shapes.v", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::v,
       3, 0},
      {"elements[0].shapes.nodes", "", physgen::ElementType::int32,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::nodes,
       4, 0},
      {"elements[0].shapes.F", "1", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::F,
       9, 0},
      {"elements[0].shapes.B", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::B,
       6, 0},
      {"elements[0].shapes.row", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::row,
       4, 0},
      {"elements[0].shapes.K", "N/m", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::K,
       6, 0},
      {"elements[0].shapes.C2", "", physgen::ElementType::float64,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::C2,
       3, 0},
      {"elements[0].shapes.s", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::s,
       3, 0},
      {"elements[0].shapes.W", "1/s", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::W,
       3, 0},
      {"elements[0].shapes.U", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::U,
       9, 0},
      {"elements[0].shapes.V", "", physgen::ElementType::float32,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::V,
       9, 0},
      {"elements[0].shapes.count", "", physgen::ElementType::int32,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::count,
       2, 0},
      {"elements[0].shapes.M", "", physgen::ElementType::float64,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::shapes +
           ::tissue::model::ShapesRecord<Real>::M,
       4, 0},
      {"elements[0].volume", "m^3", physgen::element_type<Real>,
       PatchRecord<Real>::elements + ::tissue::model::ElementRecord<Real>::volume, 1, 0},
      {"elements[1].flag", "", physgen::ElementType::int32,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::flag,
       1, 0},
      {"elements[1].lame.mu", "Pa", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::lame + ::material::LameRecord<Real>::mu,
       1, 0},
      {"elements[1].lame.lambda", "Pa", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::lame + ::material::LameRecord<Real>::lambda,
       1, 0},
      {"elements[1].fibres[0].direction", "", physgen::ElementType::float32,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::fibres + ::material::FibreRecord<Real>::direction,
       3, 0},
      {"elements[1].fibres[0].strength", "Pa", physgen::ElementType::float64,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::fibres + ::material::FibreRecord<Real>::strength,
       1, 0},
      {"elements[1].fibres[1].direction", "", physgen::ElementType::float32,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::fibres + 1 * 24 + ::material::FibreRecord<Real>::direction,
       3, 0},
      {"elements[1].fibres[1].strength", "Pa", physgen::ElementType::float64,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::fibres + 1 * 24 + ::material::FibreRecord<Real>::strength,
       1, 0},
      {"elements[1].stamp.time", "s", physgen::ElementType::float64,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::stamp + ::StampRecord<Real>::time,
       1, 0},
      {"elements[1].stamp.step", "", physgen::ElementType::int32,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::stamp + ::StampRecord<Real>::step,
       1, 0},
      {"elements[1].shapes.a", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::a,
       1, 0},
      {"elements[1].shapes.v", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::v,
       3, 0},
      {"elements[1].shapes.nodes", "", physgen::ElementType::int32,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::nodes,
       4, 0},
      {"elements[1].shapes.F", "1", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::F,
       9, 0},
      {"elements[1].shapes.B", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::B,
       6, 0},
      {"elements[1].shapes.row", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::row,
       4, 0},
      {"elements[1].shapes.K", "N/m", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::K,
       6, 0},
      {"elements[1].shapes.C2", "", physgen::ElementType::float64,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::C2,
       3, 0},
      {"elements[1].shapes.s", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::s,
       3, 0},
      {"elements[1].shapes.W", "1/s", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::W,
       3, 0},
      {"elements[1].shapes.U", "", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::U,
       9, 0},
      {"elements[1].shapes.V", "", physgen::ElementType::float32,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::V,
       9, 0},
      {"elements[1].shapes.count", "", physgen::ElementType::int32,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::count,
       2, 0},
      {"elements[1].shapes.M", "", physgen::ElementType::float64,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::shapes + ::tissue::model::ShapesRecord<Real>::M,
       4, 0},
      {"elements[1].volume", "m^3", physgen::element_type<Real>,
       PatchRecord<Real>::elements + 1 * physgen::by_precision<Real>(376, 568) +
           ::tissue::model::ElementRecord<Real>::volume,
       1, 0},
      {"weight", "", physgen::ElementType::float32, PatchRecord<Real>::weight, 1, 0},
      {"options.density", "kg/m^3", physgen::element_type<Real>,
       PatchRecord<Real>::options + ::tissue::model::OptionsRecord<Real>::density, 1, 1060},
      {"options.nu", "", physgen::element_type<Real>,
       PatchRecord<Real>::options + ::tissue::model::OptionsRecord<Real>::nu, 1, 0.45},
      {"options.direction", "1", physgen::element_type<Real>,
       PatchRecord<Real>::options + ::tissue::model::OptionsRecord<Real>::direction, 3, 0.5},
      {"options.metric", "", physgen::element_type<Real>,
       PatchRecord<Real>::options + ::tissue::model::OptionsRecord<Real>::metric, 6, 1},
      {"options.label", "", physgen::ElementType::int32,
       PatchRecord<Real>::options + ::tissue::model::OptionsRecord<Real>::label, 1, -1},
      {"options.group", "", physgen::ElementType::int32,
       PatchRecord<Real>::options + ::tissue::model::OptionsRecord<Real>::group, 2, 7},
      {"options.spin", "", physgen::element_type<Real>,
       PatchRecord<Real>::options + ::tissue::model::OptionsRecord<Real>::spin, 3, 0.25},
      {"options.fixed", "", physgen::ElementType::float64,
       PatchRecord<Real>::options + ::tissue::model::OptionsRecord<Real>::fixed, 1, 1e-12},
  }};
};

template <class Real, class Layout>
using PatchView = physgen::View<PatchObject, Real, Layout>;
template <class Real, class Space = physgen::Host,
          class Layout = physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>>
using PatchArray = physgen::Array<PatchObject, Real, Space, Layout>;

// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds all.
static_assert(physgen::is_sound_record<PatchObject, float>(836, 8));
static_assert(physgen::is_sound_record<PatchObject, double>(1276, 8));

}  // namespace tissue::other
