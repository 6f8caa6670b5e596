// Rows of the GPU: dot products.
#include <physgen/cuda/parallel_reduce.h>

#include "../cuda_timing.h"
#include "../dot_products.h"
#include "../groups.h"

namespace physgen::bench {

namespace {

struct Keep {
  double* to;
  PHYSGEN_FUNCTION void operator()(double value) const { *to = value; }
};

/// Reads `count` words of a and of b; stores what no sum of them is, so that nothing is left out.
__global__ void read_both(const float4* a, const float4* b, index_t count, double* to) {
  float total = 0;
  const index_t stride = index_t{gridDim.x} * blockDim.x;
  index_t i = blockIdx.x * index_t{blockDim.x} + threadIdx.x;
#pragma unroll 4
  for (; i < count; i += stride) {
    const float4 x = a[i], y = b[i];
    total += x.x + x.y + x.z + x.w + y.x + y.y + y.z + y.w;
  }
  if (total == 1234.5678F) *to = 0;
}

template <class Real, class Layout>
class CudaDotCase final : public Case {
 public:
  explicit CudaDotCase(index_t n)
      : operands_(n), workspace_(n), value_(SpaceKind::pinned, sizeof(double), "a dot product") {}
  double run() override {
    watch_.start();
    parallel_reduce(Cuda{}, operands_.a.size(), operands_.kernel(), Sum{}, Keep{value()}, workspace_);
    return watch_.stop();
  }
  double copy() override {
    const auto* a = reinterpret_cast<const float4*>(operands_.a.storage().base);
    const auto* b = reinterpret_cast<const float4*>(operands_.b.storage().base);
    constexpr unsigned blocks = 132 * 8, threads = 256;
    watch_.start();
    read_both<<<blocks, threads>>>(a, b, operands_.bytes() / index_t{sizeof(float4)}, value());
    cuda::check(cudaGetLastError(), "reading");
    return watch_.stop();
  }
  Accuracy check() override {
    run();
    return operands_.check(*value());
  }

 private:
  [[nodiscard]] double* value() const { return reinterpret_cast<double*>(value_.data()); }
  DotOperands<Real, Cuda, Layout> operands_;
  ReduceWorkspace workspace_;
  Buffer value_;
  DeviceStopwatch watch_;
};

template <class Real, class Layout>
void add(std::vector<Row>& rows, const char* layout) {
  add_dot_rows<Real>(rows, layout, SpaceKind::cuda, dot_sizes.back(),
                     [](index_t n) { return std::make_unique<CudaDotCase<Real, Layout>>(n); });
}

}  // namespace

void add_cuda_dot_rows(std::vector<Row>& rows) {
  add<float, Soa>(rows, "soa");
  add<float, Aosoa<32>>(rows, "aosoa32");
  add<double, Soa>(rows, "soa");
  add<double, Aosoa<32>>(rows, "aosoa32");
}

}  // namespace physgen::bench
