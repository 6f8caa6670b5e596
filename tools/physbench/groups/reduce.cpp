// Dot products on the CPU.
#include "groups/reduce.h"

#include <physgen/parallel_reduce.h>

#include <array>
#include <numeric>
#include <vector>

#include "measure/host.h"

namespace physgen::bench {

namespace {

template <class Real, class Layout>
struct HostSum {
  DotOperands<Real, Host, Layout> operands;

  explicit HostSum(index_t n) : operands(n) {}
  double add() {
    return HostDevice::time([&] { value_ = sum(Host{}, operands.a.size(), operands.kernel()); });
  }
  /// Reads both arrays, and adds up what it reads as floats, so that nothing is left out.
  double read() {
    const auto* a = reinterpret_cast<const float*>(operands.a.untyped().base);
    const auto* b = reinterpret_cast<const float*>(operands.b.untyped().base);
    constexpr index_t piece = 4096, lanes = 64;
    const index_t count = operands.bytes() / index_t{sizeof(float)};
    std::vector<float> totals(static_cast<std::size_t>(count / piece));
    const double time = HostDevice::time([&] {
      physgen::detail::for_each_index<piece>(0, count / piece, [&](index_t at) {
        std::array<float, lanes> sums{};
        for (index_t k = at * piece; k < (at + 1) * piece; k += lanes) {
          for (index_t l = 0; l < lanes; ++l) sums[static_cast<std::size_t>(l)] += a[k + l] + b[k + l];
        }
        totals[static_cast<std::size_t>(at)] = std::accumulate(sums.begin(), sums.end(), 0.0F);
      });
    });
    read_ = std::accumulate(totals.begin(), totals.end(), 0.0F);
    return time;
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  double value_ = 0;
  volatile float read_ = 0;
};

[[maybe_unused]] const bool group = add(Group{
    "reduce", "dot products of 2^18 to 2^24 vectors (to 2^22 on the CPU), beside a pass that only reads as much", 7});
[[maybe_unused]] const bool rows =
    add(Part{"reduce", 0, "dot_product", "host", [](std::vector<Row>& rows, const Sizes& /*sizes*/) {
               add_all_dot_rows<HostSum>(rows, SpaceKind::host, 1 << 22);
             }});

}  // namespace

}  // namespace physgen::bench
