// A search for bad cases of the SVD, on the GPU itself: hundreds of millions of random matrices of several kinds, with
// residuals in double precision (so those of double are good to about 1 eps), and the worst matrix, to be replayed.
#include <fem/numerics/svd.h>
#include <fem/reference/svd_errors.h>
#include <gtest/gtest.h>
#include <physgen/cuda/check.h>
#include <physgen/device.h>

#include "reference.h"
#include "replay.h"

namespace physgen::fem {
namespace {

// Numbers from a counter: every matrix has its own stream.
class DeviceRandom {
 public:
  __device__ explicit DeviceRandom(std::uint64_t stream) : state_(mixed(stream)) {}
  __device__ double uniform() {
    state_ += 0x9e3779b97f4a7c15ULL;
    return static_cast<double>(mixed(state_) >> 11) * 0x1p-53 + 0x1p-54;
  }
  __device__ double normal() { return sqrt(-2 * ::log(uniform())) * cospi(2 * uniform()); }
  /// Between 1 and e^-decay, evenly over the orders of magnitude.
  __device__ double small(double decay) { return exp(-decay * uniform()); }

 private:
  __device__ static std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return x ^ (x >> 33);
  }
  std::uint64_t state_;
};

enum Kind { gaussian, deformation, graded, spread_stretches, close_stretches, graded_columns, integers, near_rotation };
constexpr const char* names[] = {"Gaussian",        "I + 0.3 N(0,1)", "graded",   "spread stretches",
                                 "close stretches", "graded columns", "integers", "near a rotation"};

__device__ Matrix3<double> random_rotation(DeviceRandom& r) {
  const double w = r.normal(), x = r.normal(), y = r.normal(), z = r.normal();
  const double k = 2 / (w * w + x * x + y * y + z * z);
  Matrix3<double> R;
  R << 1 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y),  //
      k * (x * y + w * z), 1 - k * (x * x + z * z), k * (y * z - w * x),   //
      k * (x * z - w * y), k * (y * z + w * x), 1 - k * (x * x + y * y);
  return R;
}

__device__ Matrix3<double> random_matrix(DeviceRandom& r, Kind kind) {
  Matrix3<double> m;
  for (int k = 0; k < 9; ++k) m(k % 3, k / 3) = r.normal();
  switch (kind) {
    case gaussian:
      break;
    case deformation:
      m = Matrix3<double>::Identity() + 0.3 * m;
      break;
    case graded:
      for (int k = 0; k < 9; ++k) m(k % 3, k / 3) *= r.small(20);
      break;
    case spread_stretches:
    case close_stretches: {
      const bool close = kind == close_stretches;
      const double second = close ? 1 - r.small(20) : r.small(30);
      const double third = r.uniform() < 0.3 ? second * (1 - r.small(20)) : close ? 1 - r.small(20) : r.small(30);
      const Vector3<double> s(1, second, r.uniform() < 0.5 ? third : -third);
      const Matrix3<double> left = random_rotation(r), right = random_rotation(r);
      m = left * s.asDiagonal() * right;
      break;
    }
    case graded_columns:
      m.col(1) *= r.small(20);
      m.col(2) *= r.small(40);
      break;
    case integers:
      for (int k = 0; k < 9; ++k) m(k % 3, k / 3) = static_cast<int>(5 * r.uniform()) - 2;
      break;
    case near_rotation: {
      const double distance = r.small(20);
      m = random_rotation(r) + distance * m;
      break;
    }
  }
  return m;
}

/// The errors of one matrix; worse ones are larger. A failure (not finite, or not ordered) is infinitely bad.
struct Errors {
  double residual, orthogonality;  // relative, absolute
};

template <class Real>
__device__ Errors errors_of(const Matrix3<Real>& A) {
  const Svd<Real> found = svd(A);
  const Matrix3<double> exact = A.template cast<double>(), U = found.U.template cast<double>(),
                        V = found.V.template cast<double>();
  const Vector3<double> s = found.s.template cast<double>();
  const double norm = sqrt(exact.squaredNorm());
  Errors errors{sqrt((U * s.asDiagonal() * V.transpose() - exact).squaredNorm()) / (norm > 0 ? norm : 1), 0};
  for (const Matrix3<double>& Q : {U, V}) {
    const Matrix3<double> product = Q.transpose() * Q - Matrix3<double>::Identity();
    for (int k = 0; k < 9; ++k) errors.orthogonality = fmax(errors.orthogonality, std::abs(product(k % 3, k / 3)));
  }
  const bool ordered = s[0] >= s[1] && s[1] >= std::abs(s[2]);
  if (!(errors.residual < 1) || !(errors.orthogonality < 1) || !ordered) errors.residual = HUGE_VAL;
  return errors;
}

struct Search {
  std::uint64_t seed;
  Kind kind;
  std::int64_t count;

  template <class Real>
  __device__ Matrix3<Real> matrix(std::int64_t i) const {
    DeviceRandom random((seed + static_cast<std::uint64_t>(kind)) * 0x100000001b3ULL + static_cast<std::uint64_t>(i));
    return random_matrix(random, kind).template cast<Real>();
  }
};

/// Bits of doubles that are not negative order as the numbers do. The index is found by a second pass.
struct Worst {
  unsigned long long residual, orthogonality, index;
  double matrix[9];
};

template <class Real>
__global__ void find_errors(Search search, Worst* worst) {
  double residual = 0, orthogonality = 0;
  const std::int64_t stride = std::int64_t{gridDim.x} * blockDim.x;
  for (std::int64_t i = blockIdx.x * std::int64_t{blockDim.x} + threadIdx.x; i < search.count; i += stride) {
    const Errors errors = errors_of(search.matrix<Real>(i));
    residual = fmax(residual, errors.residual);
    orthogonality = fmax(orthogonality, errors.orthogonality);
  }
  atomicMax(&worst->residual, static_cast<unsigned long long>(__double_as_longlong(residual)));
  atomicMax(&worst->orthogonality, static_cast<unsigned long long>(__double_as_longlong(orthogonality)));
}

template <class Real>
__global__ void find_index(Search search, Worst* worst) {
  const std::int64_t stride = std::int64_t{gridDim.x} * blockDim.x;
  for (std::int64_t i = blockIdx.x * std::int64_t{blockDim.x} + threadIdx.x; i < search.count; i += stride) {
    const double residual = errors_of(search.matrix<Real>(i)).residual;
    if (static_cast<unsigned long long>(__double_as_longlong(residual)) == worst->residual) {
      atomicMin(&worst->index, static_cast<unsigned long long>(i));
    }
  }
}

template <class Real>
__global__ void store_matrix(Search search, Worst* worst) {
  const Matrix3<Real> matrix = search.matrix<Real>(static_cast<std::int64_t>(worst->index));
  for (int k = 0; k < 9; ++k) worst->matrix[k] = static_cast<double>(matrix(k % 3, k / 3));
}

template <class Real>
Worst worst_of(const Search& search) {
  Worst worst{0, 0, ~0ULL, {}}, *device = nullptr;
  cuda::check(cudaMalloc(&device, sizeof worst), "allocating the result");
  cuda::check(cudaMemcpy(device, &worst, sizeof worst, cudaMemcpyHostToDevice), "clearing the result");
  find_errors<Real><<<2048, 256>>>(search, device);
  find_index<Real><<<2048, 256>>>(search, device);
  store_matrix<Real><<<1, 1>>>(search, device);
  cuda::check(cudaGetLastError(), "searching");
  cuda::check(cudaMemcpy(&worst, device, sizeof worst, cudaMemcpyDeviceToHost), "reading the result");
  cuda::check(cudaFree(device), "freeing the result");
  return worst;
}

template <class Real>
void expect_no_bad_case(std::int64_t count) {
  if (!cuda_available()) GTEST_SKIP() << "no CUDA device here";
  for (const Kind kind :
       {gaussian, deformation, graded, spread_stretches, close_stretches, graded_columns, integers, near_rotation}) {
    const Worst worst = worst_of<Real>({reference::seed(), kind, count});
    const double eps = std::numeric_limits<Real>::epsilon();
    const double residual = std::bit_cast<double>(worst.residual) / eps;
    const double orthogonality = std::bit_cast<double>(worst.orthogonality) / eps;
    Matrix3<Real> matrix;
    for (int k = 0; k < 9; ++k) matrix(k % 3, k / 3) = static_cast<Real>(worst.matrix[k]);
    std::cout << names[kind] << ", " << count << ": residual " << residual << " eps, orthogonality " << orthogonality
              << " eps\n  " << replay_command(matrix) << "\n";
    EXPECT_GT(residual, 0.5) << names[kind];  // measured something
    EXPECT_LE(residual, 9) << names[kind];
    EXPECT_LE(orthogonality, 16) << names[kind];
  }
}

TEST(SvdSearch, finds_no_bad_case_among_two_billion_random_matrices_of_float) {
  expect_no_bad_case<float>(250'000'000);
}
TEST(SvdSearch, finds_no_bad_case_among_eighty_million_random_matrices_of_double) {
  expect_no_bad_case<double>(10'000'000);
}

}  // namespace
}  // namespace physgen::fem
