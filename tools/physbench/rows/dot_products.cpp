// Rows of the CPU: dot products.
#include "../dot_products.h"

#include <physgen/parallel_reduce.h>

#include "../groups.h"
#include "../timing.h"

namespace physgen::bench {

namespace {

template <class Real, class Layout>
class HostDotCase final : public Case {
 public:
  explicit HostDotCase(index_t n) : operands_(n) {}
  double run() override {
    const Stopwatch watch;
    value_ = sum(Host{}, operands_.a.size(), operands_.kernel());
    return watch.seconds();
  }
  /// Reads both arrays, and adds up what it reads as floats, so that nothing is left out.
  double copy() override {
    const auto* a = reinterpret_cast<const float*>(operands_.a.storage().base);
    const auto* b = reinterpret_cast<const float*>(operands_.b.storage().base);
    constexpr index_t piece = 4096, lanes = 64;
    const index_t count = operands_.bytes() / index_t{sizeof(float)};
    float total = 0;
    const Stopwatch watch;
#pragma omp parallel for schedule(static) reduction(+ : total)
    for (index_t at = 0; at < count / piece; ++at) {
      std::array<float, lanes> sums{};
      for (index_t k = at * piece; k < (at + 1) * piece; k += lanes) {
        for (index_t l = 0; l < lanes; ++l) sums[static_cast<std::size_t>(l)] += a[k + l] + b[k + l];
      }
      for (const float lane : sums) total += lane;
    }
    read_ = total;
    return watch.seconds();
  }
  Accuracy check() override {
    run();
    return operands_.check(value_);
  }

 private:
  DotOperands<Real, Host, Layout> operands_;
  double value_ = 0;
  volatile float read_ = 0;
};

template <class Real, class Layout>
void add(std::vector<Row>& rows, const char* layout) {
  constexpr index_t largest = 1 << 22;
  add_dot_rows<Real>(rows, layout, SpaceKind::host, largest,
                     [](index_t n) { return std::make_unique<HostDotCase<Real, Layout>>(n); });
}

}  // namespace

void add_host_dot_rows(std::vector<Row>& rows) {
  add<float, Soa>(rows, "soa");
  add<float, Aosoa<32>>(rows, "aosoa32");
  add<double, Soa>(rows, "soa");
  add<double, Aosoa<32>>(rows, "aosoa32");
}

}  // namespace physgen::bench
