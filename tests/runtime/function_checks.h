// The functions that kernels call, such as exp() and max(), over ranges of arrays, against long double: one source for
// packs, single objects and CUDA. Included behind parallel_for.h or cuda/parallel_for.h.
#pragma once

#include "vocabulary_checks.h"

namespace physgen::test {

/// Where a function's arguments are drawn from.
enum class From { small, large, positive, unit, special };
struct Function {
  const char* name;
  From from;
  double eps;  ///< of the result's last place; 0: exact, or rounded once
};
// The same order as in function_of().
inline constexpr std::array functions{Function{"exp", From::small, 4},
                                      Function{"log", From::positive, 4},
                                      Function{"log1p", From::positive, 4},
                                      Function{"expm1", From::small, 4},
                                      Function{"sin", From::large, 4},
                                      Function{"cos", From::large, 4},
                                      Function{"tan", From::small, 4},
                                      Function{"asin", From::unit, 4},
                                      Function{"acos", From::unit, 4},
                                      Function{"atan", From::large, 4},
                                      Function{"atan2", From::special, 4},
                                      Function{"sinh", From::small, 4},
                                      Function{"cosh", From::small, 4},
                                      Function{"tanh", From::small, 4},
                                      Function{"pow", From::positive, 8},
                                      Function{"cbrt", From::special, 4},
                                      Function{"hypot", From::special, 4},
                                      Function{"fmod", From::large, 0},
                                      Function{"floor", From::large, 0},
                                      Function{"ceil", From::large, 0},
                                      Function{"round", From::large, 0},
                                      Function{"trunc", From::large, 0},
                                      Function{"abs", From::special, 0},
                                      Function{"sqrt", From::positive, 0},
                                      Function{"copysign", From::small, 0},
                                      Function{"max", From::small, 0},
                                      Function{"min", From::small, 0},
                                      Function{"max(x, 0)", From::small, 0},
                                      Function{"min(x, 0.5)", From::small, 0},
                                      Function{"clamp", From::special, 0},
                                      Function{"isnan", From::special, 0},
                                      Function{"isfinite", From::special, 0},
                                      Function{"isinf", From::special, 0},
                                      Function{"pow(x, 2.5)", From::positive, 8},
                                      Function{"cast", From::small, 0},
                                      Function{"pow of specials", From::special, 8},
                                      Function{"exp of specials", From::special, 4},
                                      Function{"log of specials", From::special, 4}};

template <class S>
PHYSGEN_FUNCTION S function_of(int which, const S& x, const S& y) {
  using namespace math;
  switch (which) {
    case 0:
      return exp(x);
    case 1:
      return log(x);
    case 2:
      return log1p(x);
    case 3:
      return expm1(x);
    case 4:
      return sin(x);
    case 5:
      return cos(x);
    case 6:
      return tan(x);
    case 7:
      return asin(x);
    case 8:
      return acos(x);
    case 9:
      return atan(x);
    case 10:
      return atan2(x, y);
    case 11:
      return sinh(x);
    case 12:
      return cosh(x);
    case 13:
      return tanh(x);
    case 14:
      return pow(x, y);
    case 15:
      return cbrt(x);
    case 16:
      return hypot(x, y);
    case 17:
      return fmod(x, y);
    case 18:
      return floor(x);
    case 19:
      return ceil(x);
    case 20:
      return round(x);
    case 21:
      return trunc(x);
    case 22:
      return abs(x);
    case 23:
      return sqrt(x);
    case 24:
      return copysign(x, y);
    case 25:
      return max(x, y);
    case 26:
      return min(x, y);
    case 27:
      return max(x, 0);
    case 28:
      return min(x, 0.5);
    case 29:
      return clamp(x, -1, 0.5);
    case 30:
      return select(isnan(x), S(1), 0);
    case 31:
      return select(isfinite(x), S(1), 0);
    case 32:
      return select(isinf(x), S(1), 0);
    case 33:
      return pow(x, 2.5);
    case 34:
      if constexpr (std::is_same_v<typename ScalarTraits<S>::Real, double>) return cast<double>(cast<float>(x));
      return x;
    case 35:
      return pow(x, y);
    case 36:
      return exp(x);
    default:
      return log(x);
  }
}
template <class Real>
long double reference_of(int which, long double x, long double y) {
  if (which == 34) return static_cast<long double>(static_cast<float>(static_cast<Real>(x)));
  if (which == 27) return std::max(x, 0.0L);
  if (which == 28) return std::min(x, 0.5L);
  if (which == 29) return std::clamp(x, -1.0L, 0.5L);
  if (which == 30) return std::isnan(x) ? 1 : 0;
  if (which == 31) return std::isfinite(x) ? 1 : 0;
  if (which == 32) return std::isinf(x) ? 1 : 0;
  if (which == 33) return std::pow(x, 2.5L);
  using F = long double (*)(long double, long double);
#define PHYSGEN_TEST_REFERENCE(f) [](long double a, long double) { return std::f(a); }
#define PHYSGEN_TEST_REFERENCE_OF_TWO(f) [](long double a, long double b) { return std::f(a, b); }
  const std::array<F, 27> references{PHYSGEN_TEST_REFERENCE(exp),
                                     PHYSGEN_TEST_REFERENCE(log),
                                     PHYSGEN_TEST_REFERENCE(log1p),
                                     PHYSGEN_TEST_REFERENCE(expm1),
                                     PHYSGEN_TEST_REFERENCE(sin),
                                     PHYSGEN_TEST_REFERENCE(cos),
                                     PHYSGEN_TEST_REFERENCE(tan),
                                     PHYSGEN_TEST_REFERENCE(asin),
                                     PHYSGEN_TEST_REFERENCE(acos),
                                     PHYSGEN_TEST_REFERENCE(atan),
                                     PHYSGEN_TEST_REFERENCE_OF_TWO(atan2),
                                     PHYSGEN_TEST_REFERENCE(sinh),
                                     PHYSGEN_TEST_REFERENCE(cosh),
                                     PHYSGEN_TEST_REFERENCE(tanh),
                                     PHYSGEN_TEST_REFERENCE_OF_TWO(pow),
                                     PHYSGEN_TEST_REFERENCE(cbrt),
                                     PHYSGEN_TEST_REFERENCE_OF_TWO(hypot),
                                     PHYSGEN_TEST_REFERENCE_OF_TWO(fmod),
                                     PHYSGEN_TEST_REFERENCE(floor),
                                     PHYSGEN_TEST_REFERENCE(ceil),
                                     PHYSGEN_TEST_REFERENCE(round),
                                     PHYSGEN_TEST_REFERENCE(trunc),
                                     PHYSGEN_TEST_REFERENCE(abs),
                                     PHYSGEN_TEST_REFERENCE(sqrt),
                                     PHYSGEN_TEST_REFERENCE_OF_TWO(copysign),
                                     PHYSGEN_TEST_REFERENCE_OF_TWO(fmax),
                                     PHYSGEN_TEST_REFERENCE_OF_TWO(fmin)};
#undef PHYSGEN_TEST_REFERENCE
#undef PHYSGEN_TEST_REFERENCE_OF_TWO
  const int f = which == 35 ? 14 : which == 36 ? 0 : which == 37 ? 1 : which;
  return references[static_cast<std::size_t>(f)](x, y);
}

template <class View>
struct Evaluate {
  using Scalar = typename View::Precision;
  View in, out;
  int which;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const S x = in[i].f()[0], y = in[i].f()[1];
    using V = Eigen::Matrix<S, 3, 1>;
    const S value = function_of<S>(which, x, y);
    out[i].f() = math::select(x < y, V(value, S(1), x), V(value, S(0), y));
  }
};

template <class Real>
Real draw(From from, std::mt19937& random) {
  using Limits = std::numeric_limits<Real>;
  std::uniform_real_distribution<Real> unit(-1, 1);
  switch (from) {
    case From::small:
      return 3 * unit(random);
    case From::large:
      return std::ldexp(unit(random), static_cast<int>(random() % 40));
    case From::positive:
      return std::ldexp(std::abs(unit(random)) + Real(0.01), static_cast<int>(random() % 60) - 30);
    case From::unit:
      return unit(random);
    case From::special:
      break;
  }
  const std::array<Real, 22> numbers{0,
                                     -Real(0),
                                     1,
                                     -1,
                                     2,
                                     -3,
                                     Real(0.5),
                                     Limits::infinity(),
                                     -Limits::infinity(),
                                     Limits::quiet_NaN(),
                                     Limits::max(),
                                     Limits::lowest(),
                                     Limits::min(),
                                     Limits::denorm_min(),
                                     -Limits::denorm_min(),
                                     Limits::min() / 8,
                                     Real(-95),
                                     Real(-720),
                                     Real(3e-30),
                                     Real(2e30),
                                     Real(-0.7),
                                     Real(1.5)};
  return numbers[random() % numbers.size()];
}

/// Off by how many units in the last place of the exact result. @param signs whether the sign of zero counts
template <class Real>
double error_in_last_places(Real got, long double exact, bool signs) {
  const auto rounded = static_cast<Real>(exact);
  if (rounded != rounded || got != got) return rounded != rounded && got != got ? 0 : 1e30;
  if (got == rounded && signs) return std::signbit(got) == std::signbit(rounded) ? 0 : 1e30;
  if (got == rounded && got == 0) return 0;
  if (std::isinf(got) || std::isinf(rounded)) {
    return std::abs(got) >= std::numeric_limits<Real>::max() && std::abs(rounded) >= std::numeric_limits<Real>::max()
               ? 1
               : 1e30;
  }
  int exponent = 0;
  (void)std::frexp(exact, &exponent);
  exponent = std::max(exponent, std::numeric_limits<Real>::min_exponent) - std::numeric_limits<Real>::digits;
  return static_cast<double>(std::abs(static_cast<long double>(got) - exact) / std::ldexp(1.0L, exponent));
}

template <class Real, class Space, class Layout, class Run>
void check_functions(const Run& run) {
  std::mt19937 random(seed());
  for (int which = 0; which < static_cast<int>(functions.size()); ++which) {
    const Function& function = functions[static_cast<std::size_t>(which)];
    for (const index_t n : {5, 37, 400}) {
      const index_t begin = n / 7, end = n - n / 9;
      Words<Real, Space, Layout> words(n, begin, end, random);
      for (index_t i = begin; i < end; ++i) {
        words.in_there.view()[i].f()[0] = draw<Real>(function.from, random);
        words.in_there.view()[i].f()[1] =
            draw<Real>(function.from == From::positive ? From::small : function.from, random);
      }
      words.send();
      const auto view = words.out.view();
      run(begin, end, Evaluate<std::remove_const_t<decltype(view)>>{words.in.view(), view, which});
      words.fetch();
      for (index_t i = 0; i < n; ++i) {
        const Real got = words.out_there.view()[i].f()[0];
        if (i < begin || i >= end) {
          ASSERT_EQ(got, static_cast<Real>(-1000 - i)) << function.name << " changed an object outside of its range";
          continue;
        }
        const Real x = words.in_there.view()[i].f()[0], y = words.in_there.view()[i].f()[1];
        const long double exact = reference_of<Real>(which, x, y);
        const Real chosen = words.out_there.view()[i].f()[2];
        ASSERT_EQ(words.out_there.view()[i].f()[1], x < y ? 1 : 0) << x << ", " << y;
        ASSERT_TRUE(x < y ? chosen == x : chosen == y || y != y) << x << ", " << y;
        ASSERT_LE(error_in_last_places(got, exact, function.from == From::special), std::max(function.eps, 0.5))
            << function.name << " of " << x << ", " << y << ": " << got << " instead of " << exact;
      }
    }
  }
}

}  // namespace physgen::test
