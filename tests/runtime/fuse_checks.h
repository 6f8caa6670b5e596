// Fused kernels against the same kernels run one after the other over arrays: one source for packs, single objects and
// CUDA. Included behind parallel_for.h or cuda/parallel_for.h.
#pragma once

#include <everything.physgen.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>

#include "vocabulary_checks.h"

namespace physgen::test {

using Frames = tissue::model::FrameObject;  // a rotation, a vector and a number, in formats of 16 bits on CUDA

/// Two vectors, and integers: an object that is gathered, and the object's own number.
template <class In, class Integers, class A, class Picks>
struct Prepare {
  using Scalar = typename In::Precision;
  In in;
  Integers indices;
  A a;          ///< written
  Picks picks;  ///< written
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using N = lanes_t<std::int32_t, I>;
    const Eigen::Matrix<S, 3, 1> x = in[i].f();
    a[i].f() = Eigen::Matrix<S, 3, 1>(x * S(Scalar(1.25)));
    a[i].f()[1] = x[2] * x[0] + x[1];
    const N count = indices[i].nodes()[0], other = indices[i].nodes()[1];
    picks[i].nodes()[0] = other;
    picks[i].nodes()[1] = numbers(i);
    picks[i].nodes()[2] = count;
    picks[i].nodes()[3] = count + numbers(i);
  }
};
template <class... Views>
Prepare(Views...) -> Prepare<Views...>;

/// A rotation about the third axis, from a number; and what formats of 16 bits round.
template <class A, class Turned>
struct Turn {
  using Scalar = typename A::Precision;
  A a;
  Turned frames;  ///< written
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Eigen::Matrix<S, 3, 1> x = a[i].f();
    const S one(Scalar(1)), tangent = x[0], scale = one / (one + tangent * tangent);
    Eigen::Matrix<S, 3, 3> turn = Eigen::Matrix<S, 3, 3>::Constant(S(Scalar(0)));
    turn(0, 0) = turn(1, 1) = (one - tangent * tangent) * scale;
    turn(1, 0) = S(Scalar(2)) * tangent * scale;
    turn(0, 1) = -turn(1, 0);
    turn(2, 2) = one;
    frames[i].turn() = turn;
    frames[i].origin() = Eigen::Matrix<S, 3, 1>(x * S(Scalar(0.3)));
    frames[i].weight() = scale;
  }
};
template <class... Views>
Turn(Views...) -> Turn<Views...>;

/// A gather, from an array, by the integers of an object.
template <class In, class Picks, class B>
struct PickOther {
  using Scalar = typename In::Precision;
  In in;
  Picks picks;
  B b;  ///< written
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    const lanes_t<std::int32_t, I> other = picks[i].nodes()[0];
    b.put(i, {in[other].f().get()});
  }
};
template <class... Views>
PickOther(Views...) -> PickOther<Views...>;

/// All words of kernels over what the others left. Returns a term.
template <int kFactor, class A, class B, class Turned, class Picks, class Out>
struct Finish {
  using Scalar = typename Out::Precision;
  A a;
  B b;
  Turned frames;
  Picks picks;
  Out out, sums;  ///< written
  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using namespace math;
    using S = lanes_t<Scalar, I>;
    using N = lanes_t<std::int32_t, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const auto frame = frames.get(i);
    const Vector x = a[i].f(), y = b[i].f();
    const N other = picks[i].nodes()[0], own = picks[i].nodes()[1], count = picks[i].nodes()[2];
    S total(Scalar(0));
    for (int k = 0; k < largest(i, count); ++k) total = select(k < count, total + to_real<S>(own + k), total);
    const bool right = any(i, count == smallest(i, count)) && all(i, count >= smallest(i, count)) &&
                       lane_range(i).last - lane_range(i).first <= index_width(i);
    total = select(wanted<Scalar>(i), total * frame.weight, S(Scalar(-1)));
    const Vector turned = frame.turn * y + frame.origin;
    out[i].f()[0] = right ? total : S(Scalar(-1));
    out[i].f()[1] = turned[0] * x[1] - turned[1] * S(Scalar(kFactor));
    store_where(x[0] < y[1], out[i].f()[2], turned[2]);
    add(i, sums[other].f()[1], S(Scalar(1)));
    return turned[0] + total;
  }
};
template <int kFactor, class A, class B, class Turned, class Picks, class Out>
auto finish(const A& a, const B& b, const Turned& frames, const Picks& picks, const Out& out, const Out& sums) {
  return Finish<kFactor, A, B, Turned, Picks, Out>{a, b, frames, picks, out, sums};
}

/// The kernels one after the other, over arrays. @param run run(begin, end, kernel)
template <class Real, class Space, class Layout, class Run>
void run_separately(Words<Real, Space, Layout>& words, const Run& run) {
  using Vectors = Array<Numbers, Real, Space, Layout>;
  Vectors a(words.n), b(words.n);
  Array<Frames, Real, Space, Layout> frames(words.n);
  Array<Indices, Real, Space, Layout> picks(words.n);
  run(words.begin, words.end, Prepare{words.in.view(), words.indices.view(), a.view(), picks.view()});
  run(words.begin, words.end, Turn{a.view(), frames.view()});
  run(words.begin, words.end, PickOther{words.in.view(), picks.view(), b.view()});
  run(words.begin, words.end,
      finish<3>(a.view(), b.view(), frames.view(), picks.view(), words.out.view(), words.sums.view()));
  synchronize();
}

struct Second;  ///< the tag of a second local of vectors

/// The same at once.
template <class Real, class Space, class Layout>
auto fused_over(Words<Real, Space, Layout>& words) {
  const auto a = local<Numbers, Real>();
  const auto b = local<Numbers, Real, FormatsOfSpace, Second>();
  const auto frames = local<Frames, Real>();
  const auto picks = local<Indices, Real>();
  return fuse(locals(a, b, frames, picks), Prepare{words.in.view(), words.indices.view(), a, picks}, Turn{a, frames},
              PickOther{words.in.view(), picks, b},
              finish<3>(a, b, frames, picks, words.out.view(), words.sums.view()));
}

/// The same, a fused kernel being a step of another one.
template <class Real, class Space, class Layout>
auto nested_over(Words<Real, Space, Layout>& words) {
  const auto a = local<Numbers, Real>();
  const auto b = local<Numbers, Real, FormatsOfSpace, Second>();
  const auto frames = local<Frames, Real>();
  const auto picks = local<Indices, Real>();
  const auto inner = fuse(locals(b, frames), Turn{a, frames}, PickOther{words.in.view(), picks, b},
                          finish<3>(a, b, frames, picks, words.out.view(), words.sums.view()));
  return fuse(locals(picks, a), Prepare{words.in.view(), words.indices.view(), a, picks}, inner);
}

/// Words for `n` objects and, for even n, a part of them.
template <class Real, class Space, class Layout>
Words<Real, Space, Layout> words_of(index_t n, std::mt19937& random) {
  index_t begin = 0, end = n;
  if (n % 2 == 0) {
    std::tie(begin, end) =
        std::minmax({static_cast<index_t>(random() % 70) % n, static_cast<index_t>(random() % 70) % n});
  }
  return Words<Real, Space, Layout>(n, begin, end, random);
}

template <class Vectors>
bool same_bits(Vectors& first, Vectors& second, index_t i) {
  const auto a = first.view().get(i).f, b = second.view().get(i).f;
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

/// @param run run(begin, end, kernel)
template <class Real, class Space, class Layout, class Run>
void check_fused(const Run& run) {
  std::mt19937 random(seed());
  for (index_t n = 1; n <= 70; ++n) {
    auto words = words_of<Real, Space, Layout>(n, random);
    words.send();
    run_separately(words, run);
    words.fetch();
    auto out = words.out_there, sums = words.sums_there;
    for (const bool nested : {false, true}) {
      for (index_t i = 0; i < n; ++i) {
        words.out_there.view()[i].f().setZero();
        for (int k = 0; k < 3; ++k) words.out_there.view()[i].f()[k] = static_cast<Real>(-1000 - i);
        words.sums_there.view()[i].f().setZero();
      }
      words.send();
      if (nested) {
        run(words.begin, words.end, nested_over(words));
      } else {
        run(words.begin, words.end, fused_over(words));
      }
      synchronize();
      words.fetch();
      for (index_t i = 0; i < n; ++i) {
        const bool inside = words.begin <= i && i < words.end;
        const std::string what = std::to_string(i) + " of " + std::to_string(words.begin) + " to " +
                                 std::to_string(words.end) + (nested ? ", nested" : "");
        ASSERT_TRUE(same_bits(words.out_there, out, i)) << what;
        ASSERT_TRUE(same_bits(words.sums_there, sums, i)) << what;
        for (int k = 0; k < 2; ++k) {  // of the third some are not stored
          const Real value = words.out_there.view()[i].f()[k];
          ASSERT_EQ(value == static_cast<Real>(-1000 - i), !inside) << what;
          ASSERT_TRUE(std::isfinite(value)) << what;
        }
      }
    }
  }
}

/// Stores a sum where it was formed.
template <class View>
struct KeepSum {
  View to;
  PHYSGEN_FUNCTION void operator()(double sum) const { to[index_t{0}].f()[0] = sum; }
};

/// The result of the last step is folded, by executors too.
template <class Space, class On>
void check_fused_on(On& on) {
  std::mt19937 random(seed());
  auto words = words_of<double, Space, Soa>(69, random);
  words.send();
  Array<Numbers, double, Space, Soa> result(1), second(1);
  const auto keep = [](const auto& view) { return KeepSum<std::remove_cvref_t<decltype(view)>>{view}; };
  const auto fused = fused_over(words);
  on.reduce(words.n, fused, Sum{}, keep(result.view()));
  on.run(words.n, fused);
  on.wait();
  words.fetch();
  auto out = words.out_there;
  double sum = 0;
  {
    Array<Numbers, double, Space, Soa> a(words.n), b(words.n);
    Array<Frames, double, Space, Soa> frames(words.n);
    Array<Indices, double, Space, Soa> picks(words.n);
    on.run(words.n, Prepare{words.in.view(), words.indices.view(), a.view(), picks.view()});
    on.run(words.n, Turn{a.view(), frames.view()});
    on.run(words.n, PickOther{words.in.view(), picks.view(), b.view()});
    on.reduce(words.n, finish<3>(a.view(), b.view(), frames.view(), picks.view(), words.out.view(), words.sums.view()),
              Sum{}, keep(second.view()));
    sum = on.value(second).f[0];
    words.fetch();
  }
  EXPECT_EQ(on.value(result).f[0], sum);
  EXPECT_NE(sum, 0);
  for (index_t i = 0; i < words.n; ++i) EXPECT_TRUE(same_bits(words.out_there, out, i)) << i;
}

}  // namespace physgen::test
