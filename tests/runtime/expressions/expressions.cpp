// `auto` of any expression of loaded values is right: each expression below is formed from what is loaded, returned by
// the function that formed it, and evaluated after the memory of that function has been overwritten; it must have the
// bits that the same expression of named Eigen matrices has where it stands. expressions.sh compiles this with several
// compilers and settings, of which PHYSGEN_TEST_CASES says what is compiled: bits of the calls in main().
#include <everything.physgen.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>
#include <physgen/rows.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cstdio>
#include <cstring>

// Views over memory of its own: no part of the library is linked, which another compiler has made.
extern "C" {
extern const char physgen_objects_were_compiled_without_PHYSGEN_CHECKED = 0;
}

#ifndef PHYSGEN_TEST_CASES
#define PHYSGEN_TEST_CASES 63
#endif

namespace {

using namespace physgen;
using namespace physgen::math;
using tissue::model::ShapesObject;

int failures = 0, expressions = 0;

/// Twice the value that is stored.
struct Halved {
  static constexpr const char* name = "halved";
  template <class Real>
  using Stored = float;
  template <class Real>
  static constexpr ElementType type = ElementType::float32;
  static constexpr double scale = 2, centre = 0;
  template <class Real>
  static Real decode(float stored) {
    return static_cast<Real>(stored) * Real(2);
  }
  template <class Real>
  static float encode(Real value) {
    return static_cast<float>(value / Real(2));
  }
};
using Native = tissue::model::ShapesFormats<Host>;
template <class Format, class Turn>
struct In : Native {
  using v = Format;
  using F = Format;
  using B = Format;
  using row = Format;
  using K = Format;
  using s = Format;
  using W = Format;
  using U = Turn;
  using V = Turn;
};
using Halves = In<format::Half<>, format::Quaternion<format::Half<>>>;
using OwnFormats = In<Halved, format::Quaternion16>;

/// Overwrites the stack below its caller's frame.
[[gnu::noinline]] void trample() {
  volatile unsigned char bytes[16384];
  for (unsigned k = 0; k < sizeof bytes; ++k) bytes[k] = 0xCD;
}

template <class A, class B>
bool same_bits(const A& a, const B& b) {
  static_assert(std::is_same_v<A, B>);
  return std::memcmp(&a, &b, sizeof(A)) == 0;
}
template <class T>
auto evaluated(const T& value) {
  if constexpr (requires { typename T::PlainObject; }) {
    return typename T::PlainObject(value);
  } else {
    return value;
  }
}
template <class Lazy, class Named>
void expect_equal(const char* text, const Lazy& lazy, const Named& expected) {
  ++expressions;
  bool equal = true;
  const auto found = evaluated(lazy);
  if constexpr (requires { found.rows(); }) {
    for (Eigen::Index c = 0; c < found.cols(); ++c) {
      for (Eigen::Index r = 0; r < found.rows(); ++r)
        equal = equal && same_bits(found.coeff(r, c), expected.coeff(r, c));
    }
  } else {
    equal = same_bits(found, expected);
  }
  if (!equal) {
    std::printf("%s\n", text);
    ++failures;
  }
}

/// What an index loads, as expressions name it. w and G are gathered; s is the diagonal of a matrix, K symmetric, W
/// skew, U a rotation.
template <class View, class I>
struct Loaded {
  View view;
  I i;

  auto x() const { return view[i].v().get(); }
  auto v() const { return view.get(i).s; }
  auto w() const { return view[gathered()].v().get(); }
  auto s() const { return view[i].s().get(); }
  auto F() const { return view[i].F().get(); }
  auto G() const { return view.get(gathered()).F; }
  auto K() const { return view[i].K().get(); }
  auto W() const { return view[i].W().get(); }
  auto U() const { return view[i].U().get(); }
  auto B() const { return view[i].B().get(); }
  auto row() const { return view[i].row().get(); }
  auto all() const { return view.get(i); }
  auto gathered() const {
    if constexpr (std::is_integral_v<I>) {
      return static_cast<std::int32_t>(i + 1);
    } else {
      return numbers(i) + lanes_t<std::int32_t, I>(1);
    }
  }
};
/// The same in named matrices of Eigen.
template <class S, class All>
struct Named {
  using Vector = Eigen::Matrix<S, 3, 1>;
  using Matrix = Eigen::Matrix<S, 3, 3>;
  Vector x_, v_, w_, s_;
  Matrix F_, G_, K_, W_, U_;
  Eigen::Matrix<S, 2, 3> B_;
  Eigen::Matrix<S, 1, 4> row_;
  All all_;

  template <class From>
  explicit Named(const From& from)
      : x_(from.x()),
        v_(from.v()),
        w_(from.w()),
        s_(from.s()),
        F_(from.F()),
        G_(from.G()),
        K_(from.K()),
        W_(from.W()),
        U_(from.U()),
        B_(from.B()),
        row_(from.row()),
        all_(from.all()) {}
  const auto& x() const { return x_; }
  const auto& v() const { return v_; }
  const auto& w() const { return w_; }
  const auto& s() const { return s_; }
  const auto& F() const { return F_; }
  const auto& G() const { return G_; }
  const auto& K() const { return K_; }
  const auto& W() const { return W_; }
  const auto& U() const { return U_; }
  const auto& B() const { return B_; }
  const auto& row() const { return row_; }
  const auto& all() const { return all_; }
};

struct Later {
  template <class T>
  auto operator()(const T& expression) const {
    return expression;
  }
};
struct AtOnce {
  template <class T>
  auto operator()(const T& expression) const {
    return evaluated(expression);
  }
};

/// Compares expressions of what an index of a view loads with those of named copies.
template <class View, class I>
class Expressions {
  using S = lanes_t<typename View::Precision, I>;

 public:
  Expressions(const View& view, I i)
      : o_{view, i}, named_(o_), two_(typename View::Precision(2)), mask_(S(view[i].a()) > S(0)) {}
  void compare_all() const;

 private:
  template <class Body>
  [[gnu::noinline]] auto form(const Body& body) const {
    return body(Later{}, o_, two_, mask_);
  }
  template <class Body>
  void compare(const char* text, const Body& body) const {
    const auto lazy = form(body);
    trample();
    expect_equal(text, lazy, body(AtOnce{}, named_, two_, mask_));
  }

  Loaded<View, I> o_;
  Named<S, std::remove_cvref_t<decltype(o_.all())>> named_;
  S two_;
  decltype(two_ > two_) mask_;
};

#define PARAMETERS const auto &give, const auto &o, [[maybe_unused]] const auto &two, [[maybe_unused]] const auto &mask
#define CHECK(...) compare(#__VA_ARGS__, [](PARAMETERS) { return give(__VA_ARGS__); })
#define CHECK_LINES(name, ...) compare(name, [](PARAMETERS) { __VA_ARGS__ })

template <class View, class I>
void Expressions<View, I>::compare_all() const {
  // Sums and multiples.
  CHECK(o.x() - o.v());
  CHECK(o.x() + o.w() - o.v());
  CHECK(-o.x());
  CHECK(o.x() * two);
  CHECK(two * o.x());
  CHECK(o.x() / two - o.w());
  CHECK((o.x() - o.v()) * two + (o.w() - o.x()) / two);
  CHECK(o.F() - o.G());
  CHECK(o.F() + o.G() * two - o.K());
  CHECK(o.W() + o.W().transpose());
  CHECK(o.K() - o.F().transpose());
  CHECK(o.row() + o.row() * two);
  CHECK(o.B() * two - o.B());
  // Products.
  CHECK(o.F() * o.x());
  CHECK(o.F() * o.G());
  CHECK(o.F().transpose() * o.G());
  CHECK(o.U() * o.F() * o.U().transpose());
  CHECK(o.F() * o.x() - o.G() * o.w());
  CHECK(o.F() * (o.x() - o.v()));
  CHECK((o.F() - o.G()) * (o.F() + o.G()));
  CHECK(o.x() * o.v().transpose());
  CHECK(o.x().transpose() * o.F());
  CHECK(o.B() * o.F());
  CHECK(o.B().transpose() * o.B());
  CHECK(o.F().lazyProduct(o.G()));
  CHECK(o.U() * o.s().asDiagonal());
  CHECK(o.U() * o.s().asDiagonal() * o.U().transpose());
  CHECK(o.s().asDiagonal() * o.F());
  CHECK(two * o.F() * o.x());
  CHECK((o.F() * o.G()).transpose() - o.W());
  CHECK(o.W() * o.x());
  // Transposes and parts.
  CHECK(o.F().transpose());
  CHECK(o.F().transpose().transpose() - o.F());
  CHECK(o.x().transpose() + o.v().transpose());
  CHECK(o.row().transpose());
  CHECK(o.F().col(0));
  CHECK(o.F().row(1));
  CHECK(o.F().col(0) - o.F().col(1));
  CHECK(o.F().col(2) - o.x());
  CHECK((o.F() - o.G()).col(1));
  CHECK((o.F() * o.G()).row(0));
  CHECK(o.F().template block<2, 2>(1, 0));
  CHECK((o.F() - o.G()).template block<2, 2>(0, 1));
  CHECK(o.x().template head<2>() - o.v().template tail<2>());
  CHECK(o.row().template segment<2>(1));
  CHECK((o.x() - o.v()).template head<2>());
  CHECK(o.F().diagonal());
  CHECK(o.F().diagonal() - o.K().diagonal());
  CHECK((o.F() + o.G()).diagonal());
  CHECK(o.F().template topRows<2>());
  CHECK(o.F().template leftCols<2>() * two);
  CHECK(o.F().reverse());
  CHECK(o.F().colwise() + o.x());
  CHECK(o.F().rowwise().sum());
  CHECK(o.F().colwise().squaredNorm());
  CHECK(o.x().template replicate<1, 2>());
  CHECK(o.F().reshaped());
  // Numbers.
  CHECK(o.x().dot(o.v()));
  CHECK(o.x().squaredNorm());
  CHECK(o.x().norm());
  CHECK((o.x() - o.v()).norm());
  CHECK((o.F() * o.x()).squaredNorm());
  CHECK(o.F().trace());
  CHECK((o.F() - o.G()).determinant());
  CHECK((o.F() - o.G())(1, 2));
  CHECK(o.x()(1));
  CHECK(o.x()[2] * o.F()(1, 2) + o.x().y());
  CHECK(o.F().sum());
  CHECK((o.x() - o.v()).cwiseAbs().sum());
  // Entry by entry.
  CHECK(o.x().cwiseProduct(o.v()));
  CHECK(o.x().array() * o.v().array());
  CHECK((o.x().array() + o.v().array()).matrix());
  CHECK(o.x().cwiseAbs2() - o.v());
  CHECK((o.F().array() - o.G().array()).matrix() * o.x());
  CHECK(o.x().cwiseInverse());
  CHECK(o.x().unaryExpr([](const S& entry) { return S(entry + entry); }));
  CHECK(o.x().binaryExpr(o.v(), [](const S& a, const S& b) { return S(a * b); }));
  // What Eigen evaluates on its way.
  CHECK(o.x().cross(o.v()));
  CHECK(o.x().cross(o.v()) - o.w());
  CHECK((o.x() - o.v()).cross(o.w()) * two);
  CHECK(o.x().cross(o.v()).cross(o.w()) + o.x());
  CHECK((o.x() - o.v()).eval() * two);
  CHECK((o.F() * o.G()).eval().col(0) - o.x());
  CHECK(o.F().transpose().eval() - o.G());
  CHECK(o.F().inverse());
  CHECK(o.F().inverse() * o.x() - o.v());
  CHECK((o.F() - o.G()).inverse() * two);
  // Members of values, and words of the library.
  CHECK(o.all().v - o.all().s);
  CHECK(o.all().F * o.all().v - o.all().s);
  CHECK(o.all().F.col(1) + o.all().W.transpose() * o.all().v);
  CHECK(select(mask, o.x(), o.v()) - o.w());
  CHECK(select(mask, o.F(), o.G()) * two);
  CHECK(select(mask, o.x() - o.v(), o.x() + o.v()) - o.w());
  CHECK(math::cast<double>(o.x()) - math::cast<double>(o.v()));
  CHECK(math::cast<double>(o.F() - o.G()) * math::cast<double>(o.x()));
  // Names on the way.
  CHECK_LINES("differences with names", const auto d = o.x() - o.v(); const auto twice = d * two;
              const auto more = twice + d; return give(more - o.w()););
  CHECK_LINES("products with names", const auto A = o.F() - o.G(); const auto y = A * o.x();
              const auto z = A.transpose() * y; return give(z + y););
  CHECK_LINES("parts with names", const auto A = o.F() * two; const auto a = A.col(0);
              const auto b = A.row(1).transpose(); return give(a - b + o.x()););
  CHECK_LINES("parts of an object with a name", auto all = o.all(); const auto a = all.F.col(0);
              const auto b = all.F.row(2).transpose(); return give(a - b););
  CHECK_LINES("an object with a name", const auto all = o.all(); return give(all.F * all.v - all.s.cross(all.v)););
  CHECK_LINES(
      "a lambda in a lambda", const auto edge = [&] { return o.x() - o.v(); };
      const auto normal = [&] { return edge().cross(o.w() - o.v()); }; return give(normal() * edge().squaredNorm()););
  CHECK_LINES(
      "a lambda with arguments", const auto lift = [](const auto& a, const auto& b) { return a * b + a; };
      return give(lift(o.F(), o.G()) - lift(o.W(), o.K())););
  CHECK_LINES(
      "an expression chosen by a condition", const auto of = [&](const auto& a, const auto& b) { return a - b; };
      return give(select(mask, of(o.x(), o.v()), of(o.v(), o.x()))););
  CHECK_LINES("references to entries", const auto& a = o.x()(0); const auto& b = o.F()(2, 1);
              const auto& c = (o.x() - o.v())[1]; trample(); return give(S(a + b * c)););
  CHECK_LINES("a loop over entries", S sum = S(0); for (const auto& entry : o.x()) sum = sum + entry;
              for (const auto& entry : o.all().v) sum = sum + entry; return give(sum););
  if constexpr (!std::is_class_v<S>) {  // what branches
    CHECK((o.x().array() + o.v().array()).matrix().normalized() * two);
    CHECK(o.x().normalized());
    CHECK(o.x().normalized() - o.v().normalized());
    CHECK((o.x() - o.v()).normalized() * two);
    CHECK(o.x().template cast<double>() - o.v().template cast<double>());
    CHECK(o.F().template cast<double>() * o.x().template cast<double>());
    CHECK(o.x().head(2) - o.v().tail(2));
    CHECK(o.F().block(0, 1, 2, 2) * two);
    CHECK(o.F()(Eigen::all, 1) - o.x());
    CHECK(o.F().template triangularView<Eigen::Upper>() * o.x());
    CHECK(o.F().template selfadjointView<Eigen::Lower>() * o.x());
    CHECK((o.F() - o.G()).maxCoeff());
  }
}

/// Compares at an index of a view of objects in these formats.
template <class Real, class Formats, class I>
void compare_in(const char* name, I i) {
  constexpr index_t n = 64;
  using Objects = View<ShapesObject, Real, Aosoa<16>, Formats, Host>;
  alignas(64) static std::byte memory[n * 1024];
  const Objects view(memory, n, 16);
  unsigned state = 12345;
  const auto next = [&state] {
    state = state * 1664525U + 1013904223U;
    return static_cast<Real>(static_cast<int>(state >> 24) - 128) / Real(64);
  };
  for (index_t k = 0; k < n; ++k) {
    auto object = view.get(k);
    object.a = next();
    for (Real& entry : object.v) entry = next();
    for (Real& entry : object.s) entry = next();
    for (Real& entry : object.row) entry = next();
    object.K.setConstant(next());
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) object.F(r, c) = next();
      for (int c = 0; c < r; ++c) object.K(r, c) = object.K(c, r) = next();
      for (int c = 0; c < r; ++c) object.W(r, c) = next();
      for (int c = 0; c < 2; ++c) object.B(c, r) = next();
    }
    object.U = object.V =
        Eigen::AngleAxis<Real>(next(), Eigen::Matrix<Real, 3, 1>(next(), next(), 3).normalized()).toRotationMatrix();
    view.put(k, object);
  }
  const int before = failures;
  Expressions<Objects, I>(view, i).compare_all();
  if (failures > before) std::printf("%d expressions are wrong in %s\n", failures - before, name);
}

}  // namespace

int main() {
  constexpr int cases = PHYSGEN_TEST_CASES;
  using Lanes = Pack<native_lanes<double>>;  // of floats, too: the objects have fields of doubles
  if constexpr ((cases & 1) != 0) compare_in<float, Native>("floats, native, one object", index_t{16});
  if constexpr ((cases & 2) != 0) compare_in<double, Halves>("doubles, halves, one object", index_t{16});
  if constexpr ((cases & 4) != 0) compare_in<float, OwnFormats>("floats, own format, one object", index_t{16});
  if constexpr ((cases & 8) != 0) compare_in<double, Native>("doubles, native, packs", Lanes{16});
  if constexpr ((cases & 16) != 0) compare_in<float, Halves>("floats, halves, packs", Lanes{16});
  if constexpr ((cases & 32) != 0) compare_in<double, OwnFormats>("doubles, own format, packs", Lanes{16});
  std::printf("%d of %d expressions are wrong\n", failures, expressions);
  return failures == 0 && expressions > 0 ? 0 : 1;
}
