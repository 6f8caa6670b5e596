// The SVD of cuSOLVER, as a comparison: gesvdjBatched with its default tolerance and its default limit of 100 sweeps.
// The library is looked for when the program runs, so that the program starts without it; where its header is missing,
// it has no rows.
#if __has_include(<cusolverDn.h>)
#include <cusolverDn.h>
#include <physgen/cuda/check.h>
#include <physgen/memory/buffer.h>

#include <Eigen/LU>
#include <algorithm>
#include <memory>

#include "kernels/svd.h"
#include "measure/cuda.h"
#include "measure/kernel_case.h"
#include "measure/registry.h"
#include "measure/set_data.h"
#include "vendor/library.h"

// clang-format off
#define PHYSGEN_CUSOLVER(USE) \
  USE(cusolverDnCreate) USE(cusolverDnDestroy) USE(cusolverDnCreateGesvdjInfo) \
  USE(cusolverDnDestroyGesvdjInfo) USE(cusolverDnSgesvdjBatched_bufferSize) USE(cusolverDnDgesvdjBatched_bufferSize) \
  USE(cusolverDnSgesvdjBatched) USE(cusolverDnDgesvdjBatched)
// clang-format on

namespace physgen::bench {

namespace {

PHYSGEN_VENDOR_LIBRARY(Cusolver, PHYSGEN_CUSOLVER, "libcusolver.so", {".12", ".11"});

const Cusolver& library() {
  static const Cusolver loaded;
  return loaded;
}

void check(cusolverStatus_t status, const char* asked) {
  if (status != CUSOLVER_STATUS_SUCCESS) {
    throw Error(std::string(asked) + ": cuSOLVER's status is " + std::to_string(static_cast<int>(status)));
  }
}

/// Matrices in device memory, and their SVD.
template <class Real>
class BatchedSvd {
 public:
  using Outputs = typename OnSet<Svd, Real>::Outputs;
  using Inputs = typename OnSet<Svd, Real>::Inputs;

  explicit BatchedSvd(const Inputs& gradients) : size_(std::get<0>(gradients).size()) {
    const auto view = std::get<0>(gradients).view();
    std::vector<Real> all(static_cast<std::size_t>(9 * size_));
    for (index_t i = 0; i < size_; ++i) {
      const Matrix F = view.get(i).F;
      std::copy_n(F.data(), 9, all.begin() + 9 * i);
    }
    copy(kept_.data(), all.data(), kept_.bytes());
    check(library().cusolverDnCreate(&handle_), "starting cuSOLVER");
    check(library().cusolverDnCreateGesvdjInfo(&info_), "setting up cuSOLVER");
    int numbers = 0;
    check(work_size(handle_, CUSOLVER_EIG_MODE_VECTOR, 3, 3, at(a_), 3, at(s_), at(u_), 3, at(v_), 3, &numbers, info_,
                    batch()),
          "asking for cuSOLVER's work space");
    work_ = Buffer(SpaceKind::cuda, static_cast<index_t>(numbers) * index_t{sizeof(Real)}, "cuSOLVER's work space");
    numbers_ = numbers;
  }
  BatchedSvd(const BatchedSvd&) = delete;
  BatchedSvd& operator=(const BatchedSvd&) = delete;
  ~BatchedSvd() {
    if (info_ != nullptr) library().cusolverDnDestroyGesvdjInfo(info_);
    if (handle_ != nullptr) library().cusolverDnDestroy(handle_);
  }

  /// Puts the matrices in place, which run() destroys.
  void prepare() { copy(a_.data(), kept_.data(), a_.bytes()); }
  void run() {
    check(decompose(handle_, CUSOLVER_EIG_MODE_VECTOR, 3, 3, at(a_), 3, at(s_), at(u_), 3, at(v_), 3, at(work_),
                    numbers_, reinterpret_cast<int*>(status_.data()), info_, batch()),
          "cuSOLVER's SVD");
  }
  /// The first `count` results, in our convention.
  Outputs results(index_t count) const {
    const auto n = static_cast<std::size_t>(count);
    std::vector<Real> s(3 * n), u(9 * n), v(9 * n);
    copy(s.data(), s_.data(), bytes(3 * count));
    copy(u.data(), u_.data(), bytes(9 * count));
    copy(v.data(), v_.data(), bytes(9 * count));
    auto outputs = make_arrays<Outputs>([count](std::size_t /*k*/) { return count; });
    const auto view = std::get<0>(outputs).view();
    for (std::size_t i = 0; i < n; ++i) {
      elasticity::DeformationSvd<Real> svd;
      svd.U = Eigen::Map<const Matrix>(&u[9 * i]);
      svd.V = Eigen::Map<const Matrix>(&v[9 * i]);
      svd.s = Eigen::Map<const Eigen::Matrix<Real, 3, 1>>(&s[3 * i]);
      for (auto* rotation : {&svd.U, &svd.V}) {
        if (!(rotation->template cast<long double>().determinant() < 0)) continue;
        rotation->col(2) = -rotation->col(2);
        svd.s[2] = -svd.s[2];
      }
      view.put(static_cast<index_t>(i), svd);
    }
    return outputs;
  }

 private:
  using Matrix = Eigen::Matrix<Real, 3, 3>;
  static constexpr auto functions() {
    if constexpr (sizeof(Real) == sizeof(float)) {
      return std::pair(&Cusolver::cusolverDnSgesvdjBatched_bufferSize, &Cusolver::cusolverDnSgesvdjBatched);
    } else {
      return std::pair(&Cusolver::cusolverDnDgesvdjBatched_bufferSize, &Cusolver::cusolverDnDgesvdjBatched);
    }
  }
  // NOLINTBEGIN(clang-analyzer-core.CallAndMessage): where functions are missing, nobody makes a BatchedSvd
  template <class... Argument>
  static cusolverStatus_t work_size(Argument... arguments) {
    return (library().*functions().first)(arguments...);
  }
  template <class... Argument>
  static cusolverStatus_t decompose(Argument... arguments) {
    return (library().*functions().second)(arguments...);
  }
  // NOLINTEND(clang-analyzer-core.CallAndMessage)
  static index_t bytes(index_t numbers) { return numbers * index_t{sizeof(Real)}; }
  static void copy(void* to, const void* from, index_t bytes) {
    cuda::check(cudaMemcpy(to, from, static_cast<std::size_t>(bytes), cudaMemcpyDefault), "copying matrices");
  }
  static Real* at(Buffer& buffer) { return reinterpret_cast<Real*>(buffer.data()); }
  [[nodiscard]] int batch() const { return static_cast<int>(size_); }

  index_t size_;
  Buffer kept_{SpaceKind::cuda, bytes(9 * size_), "matrices for cuSOLVER"};
  Buffer a_{SpaceKind::cuda, bytes(9 * size_), "matrices for cuSOLVER"};
  Buffer s_{SpaceKind::cuda, bytes(3 * size_), "cuSOLVER's singular values"};
  Buffer u_{SpaceKind::cuda, bytes(9 * size_), "cuSOLVER's U"}, v_{SpaceKind::cuda, bytes(9 * size_), "cuSOLVER's V"};
  Buffer status_{SpaceKind::cuda, size_ * index_t{sizeof(int)}, "cuSOLVER's status"}, work_;
  int numbers_ = 0;
  cusolverDnHandle_t handle_ = nullptr;
  gesvdjInfo_t info_ = nullptr;
};

template <class Real>
void add_rows(std::vector<Row>& rows, const Sizes& sizes) {
  using Provider = OnSet<Svd, Real>;
  for (const InputSet set : input_sets) {
    const Provider provider(sets_of(sizes.sets), set);
    Adder<CudaDevice, Provider>(rows, provider).add("cusolver", [provider] {
      const auto svd = std::make_shared<BatchedSvd<Real>>(provider.inputs());
      Case made;
      made.bytes = provider.bytes();
      made.run = [svd] {
        svd->prepare();
        return CudaDevice::time([&] { svd->run(); });
      };
      made.copy = CudaDevice::copy(made.bytes);
      made.check = [svd, provider, run = made.run] {
        run();
        return provider.check(svd->results(provider.results(Svd::domain)));
      };
      return made;
    });
  }
}

template <class Real>
bool add_replay() {
  return add(ReplayWay{Svd::name, storage_name<Real>(), 10 * Svd::place + 5, [](const std::vector<std::string>& words) {
                         if (!device_facts().missing.empty() || !library().shared.missing().empty())
                           return std::string();
                         return OnSet<Svd, Real>::replay(words, "cusolver",
                                                         [](const typename OnSet<Svd, Real>::Inputs& gradients) {
                                                           BatchedSvd<Real> svd(gradients);
                                                           svd.prepare();
                                                           svd.run();
                                                           cuda::check(cudaDeviceSynchronize(), "waiting for cuSOLVER");
                                                           return svd.results(std::get<0>(gradients).size());
                                                         });
                       }});
}

[[maybe_unused]] const bool known = add_library("cusolver", [] { return library().shared.missing(); });
[[maybe_unused]] const bool replays = add_replay<float>() && add_replay<double>();
[[maybe_unused]] const bool rows =
    add(Part{"errors", -1, Svd::name, "cuda", [](std::vector<Row>& rows, const Sizes& sizes) {
               if (!library().shared.missing().empty()) return;
               add_rows<float>(rows, sizes);
               add_rows<double>(rows, sizes);
             }});

}  // namespace

}  // namespace physgen::bench
#endif
