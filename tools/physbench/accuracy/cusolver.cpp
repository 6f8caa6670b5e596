// Loads cuSOLVER and calls its batched Jacobi SVD.
#include "cusolver.h"

#if __has_include(<cusolverDn.h>)
#include <cusolverDn.h>
#include <physgen/cuda/check.h>

#include <Eigen/LU>
#include <algorithm>
#include <memory>

#include "../cuda_timing.h"
#include "../vendor_library.h"

namespace physgen::bench {

namespace {

/// The functions of the library that are called. Null where the library cannot be had.
struct Library {
  decltype(&cusolverDnCreate) create = nullptr;
  decltype(&cusolverDnDestroy) destroy = nullptr;
  decltype(&cusolverDnCreateGesvdjInfo) create_info = nullptr;
  decltype(&cusolverDnDestroyGesvdjInfo) destroy_info = nullptr;
  decltype(&cusolverDnSgesvdjBatched_bufferSize) float_work = nullptr;
  decltype(&cusolverDnDgesvdjBatched_bufferSize) double_work = nullptr;
  decltype(&cusolverDnSgesvdjBatched) float_svd = nullptr;
  decltype(&cusolverDnDgesvdjBatched) double_svd = nullptr;
  VendorLibrary shared{"libcusolver.so", {".12", ".11"}};

  Library() {
    const auto find = [this](const char* name, auto& function) { shared.find(name, function); };
    find("cusolverDnCreate", create);
    find("cusolverDnDestroy", destroy);
    find("cusolverDnCreateGesvdjInfo", create_info);
    find("cusolverDnDestroyGesvdjInfo", destroy_info);
    find("cusolverDnSgesvdjBatched_bufferSize", float_work);
    find("cusolverDnDgesvdjBatched_bufferSize", double_work);
    find("cusolverDnSgesvdjBatched", float_svd);
    find("cusolverDnDgesvdjBatched", double_svd);
  }
};

const Library& library() {
  static const Library loaded;
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
  using Outputs = typename HostVariant<SvdVariant<4>, Real>::Outputs;
  using Inputs = typename HostVariant<SvdVariant<4>, Real>::Inputs;

  explicit BatchedSvd(const Inputs& gradients) : size_(std::get<0>(gradients).size()) {
    const auto view = std::get<0>(gradients).view();
    std::vector<Real> all(static_cast<std::size_t>(9 * size_));
    for (index_t i = 0; i < size_; ++i) {
      const Matrix F = view.get(i).F;
      std::copy_n(F.data(), 9, all.begin() + 9 * i);
    }
    copy(kept_.data(), all.data(), kept_.bytes());
    check(library().create(&handle_), "starting cuSOLVER");
    check(library().create_info(&info_), "setting up cuSOLVER");
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
    if (info_ != nullptr) library().destroy_info(info_);
    if (handle_ != nullptr) library().destroy(handle_);
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
    auto outputs = make_arrays<Outputs>(count);
    const auto view = std::get<0>(outputs).view();
    for (std::size_t i = 0; i < n; ++i) {
      elasticity::DeformationSvd<Real> svd;
      svd.U = Eigen::Map<const Matrix>(&u[9 * i]);
      svd.V = Eigen::Map<const Matrix>(&v[9 * i]);
      svd.s = Eigen::Map<const Eigen::Matrix<Real, 3, 1>>(&s[3 * i]);
      for (Matrix* rotation : {&svd.U, &svd.V}) {
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
      return std::pair(&Library::float_work, &Library::float_svd);
    } else {
      return std::pair(&Library::double_work, &Library::double_svd);
    }
  }
  template <class... Argument>
  static cusolverStatus_t work_size(Argument... arguments) {
    return (library().*functions().first)(arguments...);
  }
  template <class... Argument>
  static cusolverStatus_t decompose(Argument... arguments) {
    return (library().*functions().second)(arguments...);
  }
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
class CusolverCase final : public TimedCudaCase {
  using Variant = HostVariant<SvdVariant<4>, Real>;

 public:
  CusolverCase(InputSets& sets, InputSet set)
      : TimedCudaCase(bytes_moved<SvdVariant<4>, Real>(sets.objects())),
        sets_(sets),
        set_(set),
        svd_(Variant::inputs(sets, set)) {}
  double run() override {
    svd_.prepare();
    watch().start();
    svd_.run();
    return watch().stop();
  }
  Accuracy check() override {
    run();
    return Variant::check(sets_, set_, svd_.results(sets_.samples()));
  }

 private:
  InputSets& sets_;
  InputSet set_;
  BatchedSvd<Real> svd_;
};

template <class Real>
void add_rows(std::vector<Row>& rows, InputSets& sets) {
  for (const InputSet set : input_sets) {
    rows.push_back(describe<SvdVariant<4>, Real>("cusolver", SpaceKind::cuda, set, sets.objects()));
    rows.back().make = [&sets, set] { return std::make_unique<CusolverCase<Real>>(sets, set); };
  }
}

}  // namespace

const std::string& cusolver_missing() { return library().shared.missing(); }

void add_cusolver_rows(std::vector<Row>& rows, InputSets& sets) {
  add_rows<float>(rows, sets);
  add_rows<double>(rows, sets);
}

template <class Real>
typename HostVariant<SvdVariant<4>, Real>::Outputs cusolver_svd(
    const typename HostVariant<SvdVariant<4>, Real>::Inputs& gradients) {
  BatchedSvd<Real> svd(gradients);
  svd.prepare();
  svd.run();
  cuda::check(cudaDeviceSynchronize(), "waiting for cuSOLVER");
  return svd.results(std::get<0>(gradients).size());
}

template HostVariant<SvdVariant<4>, float>::Outputs cusolver_svd<float>(
    const HostVariant<SvdVariant<4>, float>::Inputs&);
template HostVariant<SvdVariant<4>, double>::Outputs cusolver_svd<double>(
    const HostVariant<SvdVariant<4>, double>::Inputs&);

}  // namespace physgen::bench

#else

namespace physgen::bench {

const std::string& cusolver_missing() {
  static const std::string missing = "built without cuSOLVER's header: its rows are left out";
  return missing;
}
void add_cusolver_rows(std::vector<Row>& /*rows*/, InputSets& /*sets*/) {}

template <class Real>
typename HostVariant<SvdVariant<4>, Real>::Outputs cusolver_svd(
    const typename HostVariant<SvdVariant<4>, Real>::Inputs& /*gradients*/) {
  throw Error(cusolver_missing());
}
template HostVariant<SvdVariant<4>, float>::Outputs cusolver_svd<float>(
    const HostVariant<SvdVariant<4>, float>::Inputs&);
template HostVariant<SvdVariant<4>, double>::Outputs cusolver_svd<double>(
    const HostVariant<SvdVariant<4>, double>::Inputs&);

}  // namespace physgen::bench
#endif
