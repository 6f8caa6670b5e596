// The words that kernels are written in, over ranges of arrays whose other objects and padding hold signalling NaN and
// the index 2^31 - 1, against plain C++: one source for packs, single objects and CUDA. Included behind parallel_for.h
// or cuda/parallel_for.h.
#pragma once

#include <physgen/kernel.h>

#include <algorithm>
#include <limits>

#include "test_objects.h"

namespace physgen::test {

using Numbers = elasticity::NodeForceObject;  // three numbers
using Indices = elasticity::TetObject;        // four integers

/// Arrays of a test in a space, their contents on the host, and what the objects outside of its range must keep.
template <class Real, class Space, class Layout>
struct Words {
  index_t n, begin, end;
  Array<Numbers, Real, Host, Aos> in_there, out_there, sums_there;
  Array<Indices, Real, Host, Aos> indices_there;
  Array<Numbers, Real, Space, Layout> in, out, sums;
  Array<Indices, Real, Space, Layout> indices;

  Words(index_t size, index_t first, index_t last, std::mt19937& random)
      : n(size),
        begin(first),
        end(last),
        in_there(n),
        out_there(n),
        sums_there(n),
        indices_there(n),
        in(n),
        out(n),
        sums(n),
        indices(n) {
    std::uniform_real_distribution<Real> value(-3, 3);
    for (index_t i = 0; i < n; ++i) {
      const bool inside = begin <= i && i < end;
      for (int k = 0; k < 3; ++k) {
        in_there.view()[i].f()[k] = inside ? value(random) : std::numeric_limits<Real>::signaling_NaN();
        out_there.view()[i].f()[k] = static_cast<Real>(-1000 - i);
      }
      const auto any = static_cast<int>(begin + static_cast<index_t>(random()) % std::max(end - begin, index_t{1}));
      indices_there.view()[i].nodes()[0] = inside ? static_cast<int>(random() % 9) : planted;  // a count
      indices_there.view()[i].nodes()[1] = inside ? any : planted;                             // an object of the range
      for (int k = 2; k < 4; ++k) indices_there.view()[i].nodes()[k] = planted;
    }
  }
  void send() {
    copy(in, in_there);
    copy(out, out_there);
    copy(sums, sums_there);
    copy(indices, indices_there);
    if constexpr (host_accessible(Space::kind)) {
      const auto behind = [this](auto& array) {
        const auto view = array.view();
        return typename std::remove_reference_t<decltype(array)>::View(view.data(), Layout::padded(n), view.pitch());
      };
      for (index_t i = n; i < Layout::padded(n); ++i) {
        for (int k = 0; k < 3; ++k) behind(in)[i].f()[k] = std::numeric_limits<Real>::signaling_NaN();
        for (int k = 0; k < 4; ++k) behind(indices)[i].nodes()[k] = planted;
      }
    }
    synchronize();
  }
  void fetch() {
    copy(out_there, out);
    copy(sums_there, sums);
    synchronize();
  }
  static constexpr std::int32_t planted = std::numeric_limits<std::int32_t>::max();
};

// ---- Questions to lanes, masks, integers, gathers, masked stores, sums at indices ----

template <class Real, class View, class IndexView>
struct AskLanes {
  using Scalar = Real;
  View in, out, sums;
  IndexView indices;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using namespace math;
    using S = lanes_t<Scalar, I>;
    using N = lanes_t<std::int32_t, I>;
    const S x = in[i].f()[0], y = in[i].f()[1];
    const N count = indices[i].nodes()[0], other = indices[i].nodes()[1];
    const N own = numbers(i);
    S total = S(0);
    bool missed = false;
    for (int k = 0; k < largest(i, count); ++k) {
      const auto active = k < count;
      missed = missed || !any(i, active);  // never: there is one that has as many
      total = select(active, total + to_real<S>(own + k), total);
    }
    const bool right = !missed && any(i, count == smallest(i, count)) && all(i, count >= smallest(i, count)) &&
                       any(i, count == largest(i, count)) && all(i, count <= largest(i, count)) &&
                       !any(i, x > S(100));  // no x is so large
    const S chosen = select((x > y && !(count == 3)) || own < 20, x, y);
    const S gathered = in[other].f()[2];
    const S integer = to_real<S>(select(x < 0 || !all(i, wanted<Scalar>(i)), own, count));
    out[i].f()[0] = right ? total : S(-1);
    out[i].f()[1] = chosen;
    store_where(count > 4 && x < y, out[i].f()[2], gathered + integer);
    add(i, sums[other].f()[1], S(1));
  }
};

template <class Real, class Space, class Layout, class Run>
void check_lanes(const Run& run) {
  std::mt19937 random(seed());
  for (index_t n = 1; n <= 70; ++n) {
    index_t begin = 0, end = n;
    if (n % 2 == 0) {
      std::tie(begin, end) =
          std::minmax({static_cast<index_t>(random() % 70) % n, static_cast<index_t>(random() % 70) % n});
    }
    Words<Real, Space, Layout> words(n, begin, end, random);
    auto wanted = words.out_there.view().get(0);
    words.send();
    const auto view = words.out.view();
    run(begin, end,
        AskLanes<Real, std::remove_const_t<decltype(view)>, decltype(words.indices.view())>{
            words.in.view(), view, words.sums.view(), words.indices.view()});
    words.fetch();
    std::vector<int> times(static_cast<std::size_t>(n), 0);
    for (index_t i = 0; i < n; ++i) {
      const std::string what = std::to_string(i) + " of " + std::to_string(begin) + " to " + std::to_string(end);
      wanted.f.setConstant(static_cast<Real>(-1000 - i));
      if (begin <= i && i < end) {
        const auto in = words.in_there.const_view()[i];
        const Real x = in.f()[0], y = in.f()[1];
        const int count = words.indices_there.const_view()[i].nodes()[0];
        const int other = words.indices_there.const_view()[i].nodes()[1];
        wanted.f[0] = 0;
        for (int k = 0; k < count; ++k) wanted.f[0] += static_cast<Real>(static_cast<int>(i) + k);
        wanted.f[1] = (x > y && count != 3) || i < 20 ? x : y;
        if (count > 4 && x < y) {
          wanted.f[2] =
              words.in_there.const_view()[other].f()[2] + static_cast<Real>(x < 0 ? static_cast<int>(i) : count);
        }
        ++times[static_cast<std::size_t>(other)];
      }
      ASSERT_EQ(words.out_there.view().get(i).f, wanted.f) << what;
    }
    for (index_t i = 0; i < n; ++i) {
      ASSERT_EQ(words.sums_there.getdata(i, 1), times[static_cast<std::size_t>(i)])
          << "times that " << i << " was named";
    }
  }
}

// ---- Functions ----

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
