// `auto` of any expression of loaded values is right: each expression below is formed from what is loaded, returned by
// the function that formed it, and evaluated after the memory of that function has been overwritten; it must have the
// bits that the same expression of named Eigen matrices has where it stands. expressions.sh compiles this with several
// compilers and settings, of which PHYSGEN_TEST_CASES says what is compiled: bits of the calls in main(), each of which
// has fields in all formats.
#include <physgen/parallel_reduce.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "loaded.h"

// Views over memory of its own: no part of the library is linked, which another compiler has made.
extern "C" {
extern const char physgen_objects_were_compiled_without_PHYSGEN_CHECKED = 0;
}

#ifndef PHYSGEN_TEST_CASES
#define PHYSGEN_TEST_CASES 15
#endif

namespace expressions {

// By their types, what sums and reductions return is held by value as well.
struct Positions {
  using Scalar = float;
  Eigen::Matrix<float, 3, 1> operator()(index_t) const;
};
static_assert(std::is_same_v<decltype(sum(Host{}, 1, Positions())), MatrixValue<double, 3, 1>>);

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
  CHECK(o.s().asDiagonal().toDenseMatrix() * two);
  CHECK(o.s().asDiagonal().inverse().toDenseMatrix() * two);
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
    CHECK(o.F().template triangularView<Eigen::UnitUpper>().solve(o.x()) * two);
    CHECK((o.F() - o.G()).template triangularView<Eigen::Lower>().toDenseMatrix() * two);
    CHECK(o.F().template selfadjointView<Eigen::Lower>().toDenseMatrix() * two);
    CHECK(o.K().template selfadjointView<Eigen::Lower>().eigenvalues() * two);
    CHECK(o.U().eulerAngles(0, 1, 2) * two);
    CHECK(o.F().colwise().cross(o.x()) * two);
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

}  // namespace expressions

int main() {
  using namespace expressions;
  constexpr int cases = PHYSGEN_TEST_CASES;
  using Lanes = Pack<native_lanes<double>>;  // of floats, too: the objects have fields of doubles
  using format::Half, format::Quaternion, format::Quaternion16;
  if constexpr ((cases & 1) != 0)
    compare_in<float, In<format::Native, Half<>, Halved, Quaternion<Half<>>>>("floats, one object", index_t{16});
  if constexpr ((cases & 2) != 0)
    compare_in<float, In<Half<>, Halved, format::Native, Quaternion16>>("floats, packs", Lanes{16});
  if constexpr ((cases & 4) != 0)
    compare_in<double, In<Halved, format::Native, Half<>, Quaternion<Half<>>>>("doubles, packs", Lanes{16});
  if constexpr ((cases & 8) != 0)
    compare_in<double, In<Half<>, Halved, format::Native, format::Native>>("doubles, one object", index_t{16});
  std::printf("%d of %d expressions are wrong\n", failures, compared);
  return failures == 0 && compared > 0 ? 0 : 1;
}
