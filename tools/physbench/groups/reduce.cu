// Dot products on the GPU.
#include <physgen/cuda/parallel_reduce.h>

#include "groups/reduce.h"
#include "measure/cuda.h"

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
struct CudaSum {
  DotOperands<Real, Cuda, Layout> operands;

  explicit CudaSum(index_t n)
      : operands(n), workspace_(n), value_(SpaceKind::pinned, sizeof(double), "a dot product") {}
  double add() {
    return CudaDevice::time(
        [&] { parallel_reduce(Cuda{}, operands.a.size(), operands.kernel(), Sum{}, Keep{at()}, workspace_); });
  }
  double read() {
    const auto* a = reinterpret_cast<const float4*>(operands.a.untyped().base);
    const auto* b = reinterpret_cast<const float4*>(operands.b.untyped().base);
    constexpr unsigned blocks = 132 * 8, threads = 256;  // as many as an H200 runs at once
    return CudaDevice::time([&] {
      read_both<<<blocks, threads>>>(a, b, operands.bytes() / index_t{sizeof(float4)}, at());
      cuda::check(cudaGetLastError(), "reading");
    });
  }
  [[nodiscard]] double value() const { return *at(); }

 private:
  [[nodiscard]] double* at() const { return reinterpret_cast<double*>(value_.data()); }
  ReduceWorkspace workspace_;
  Buffer value_;
};

[[maybe_unused]] const bool rows =
    add(Part{"reduce", 0, "dot_product", "cuda", [](std::vector<Row>& rows, const Sizes& /*sizes*/) {
               add_all_dot_rows<CudaSum>(rows, SpaceKind::cuda, 1 << 24);
             }});

}  // namespace

}  // namespace physgen::bench
