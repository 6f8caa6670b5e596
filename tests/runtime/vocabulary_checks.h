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

}  // namespace physgen::test
