#include "vendor/cusparse_product.h"

#include <physgen/cuda/check.h>

namespace physgen::bench {

void CusparseProduct::forget_error() { (void)cudaGetLastError(); }

}  // namespace physgen::bench

#if __has_include(<cusparse.h>)
#include <cusparse.h>

#include <chrono>

#include "vendor/library.h"

// clang-format off
#define PHYSGEN_CUSPARSE(USE) \
  USE(cusparseCreate) USE(cusparseDestroy) USE(cusparseSetStream) USE(cusparseCreateBsr) USE(cusparseDestroySpMat) \
  USE(cusparseCreateDnVec) USE(cusparseDestroyDnVec) USE(cusparseSpMV_bufferSize) USE(cusparseSpMV_preprocess) \
  USE(cusparseSpMV) USE(cusparseCreateMatDescr) USE(cusparseDestroyMatDescr) USE(cusparseSbsrmv)
// clang-format on

namespace physgen::bench {

namespace {

PHYSGEN_VENDOR_LIBRARY(Cusparse, PHYSGEN_CUSPARSE, "libcusparse.so", {".12", ".13"});

const Cusparse& library() {
  static const Cusparse loaded;
  return loaded;
}

void check(cusparseStatus_t status, const char* asked) {
  if (status != CUSPARSE_STATUS_SUCCESS) {
    throw Error(std::string(asked) + ": cuSPARSE's status is " + std::to_string(static_cast<int>(status)));
  }
}

template <class T>
Buffer on_device(const std::vector<T>& values, const char* what) {
  const auto bytes = static_cast<index_t>(values.size() * sizeof(T));
  Buffer buffer(SpaceKind::cuda, bytes, what);
  copy_memory(buffer.data(), SpaceKind::cuda, reinterpret_cast<const std::byte*>(values.data()), SpaceKind::host,
              bytes);
  return buffer;
}

// NOLINTBEGIN(clang-analyzer-core.CallAndMessage): where functions are missing, nobody makes a product

/// The part that all ways share: the matrix in device memory, and cuSPARSE's handle.
class Product : public CusparseProduct {
 public:
  Product(const BlockMatrix& matrix, BlockOrder order, float* x, float* y, cudaStream_t stream)
      : x_(x),
        y_(y),
        order_(order),
        rows_(static_cast<int>(matrix.begin.size()) - 1),
        count_(static_cast<int>(matrix.columns.size())),
        begin_(on_device(matrix.begin, "row begins")),
        columns_(on_device(matrix.columns, "columns")),
        blocks_(on_device(matrix.blocks, "blocks")) {
    check(library().cusparseCreate(&handle_), "starting cuSPARSE");
    // The destructor is not called where a constructor throws.
    if (const auto status = library().cusparseSetStream(handle_, stream); status != CUSPARSE_STATUS_SUCCESS) {
      library().cusparseDestroy(handle_);
      check(status, "setting cuSPARSE's stream");
    }
  }
  Product(const Product&) = delete;
  Product& operator=(const Product&) = delete;
  ~Product() override { library().cusparseDestroy(handle_); }

  [[nodiscard]] index_t bytes() const override {
    return begin_.bytes() + columns_.bytes() + blocks_.bytes() + 2 * index_t{rows_} * 3 * index_t{sizeof(float)};
  }

 protected:
  [[nodiscard]] std::string order_name() const {
    return order_ == BlockOrder::by_rows ? "blocks by rows" : "blocks by columns";
  }

  float *x_, *y_;
  BlockOrder order_;
  int rows_, count_;
  Buffer begin_, columns_, blocks_;
  cusparseHandle_t handle_ = nullptr;
  float one_ = 1, zero_ = 0;  // cuSPARSE reads them when it is called
};

class SpMV final : public Product {
 public:
  SpMV(const BlockMatrix& matrix, BlockOrder order, float* x, float* y, cudaStream_t stream)
      : Product(matrix, order, x, y, stream) {
    try {
      const auto scalars = std::int64_t{3} * rows_;
      check(library().cusparseCreateBsr(&matrix_, rows_, rows_, count_, 3, 3, begin_.data(), columns_.data(),
                                        blocks_.data(), CUSPARSE_INDEX_32I, CUSPARSE_INDEX_32I,
                                        CUSPARSE_INDEX_BASE_ZERO, CUDA_R_32F,
                                        order == BlockOrder::by_rows ? CUSPARSE_ORDER_ROW : CUSPARSE_ORDER_COL),
            "describing a block matrix");
      check(library().cusparseCreateDnVec(&from_, scalars, x_, CUDA_R_32F), "describing a vector");
      check(library().cusparseCreateDnVec(&to_, scalars, y_, CUDA_R_32F), "describing a vector");
      std::size_t bytes = 0;
      check(library().cusparseSpMV_bufferSize(handle_, CUSPARSE_OPERATION_NON_TRANSPOSE, &one_, matrix_, from_, &zero_,
                                              to_, CUDA_R_32F, CUSPARSE_SPMV_BSR_ALG1, &bytes),
            "asking for cuSPARSE's work space");
      work_ = Buffer(SpaceKind::cuda, static_cast<index_t>(bytes) + 16, "cuSPARSE's work space");
      // Optional; a library that has nothing to prepare for block sparse rows may refuse it.
      (void)library().cusparseSpMV_preprocess(handle_, CUSPARSE_OPERATION_NON_TRANSPOSE, &one_, matrix_, from_, &zero_,
                                              to_, CUDA_R_32F, CUSPARSE_SPMV_BSR_ALG1, work_.data());
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~SpMV() override { destroy(); }

  void run() override {
    check(library().cusparseSpMV(handle_, CUSPARSE_OPERATION_NON_TRANSPOSE, &one_, matrix_, from_, &zero_, to_,
                                 CUDA_R_32F, CUSPARSE_SPMV_BSR_ALG1, work_.data()),
          "cusparseSpMV()");
  }
  [[nodiscard]] std::string name() const override { return "cusparseSpMV, " + order_name(); }

 private:
  void destroy() {
    if (from_ != nullptr) library().cusparseDestroyDnVec(from_);
    if (to_ != nullptr) library().cusparseDestroyDnVec(to_);
    if (matrix_ != nullptr) library().cusparseDestroySpMat(matrix_);
  }

  cusparseSpMatDescr_t matrix_ = nullptr;
  cusparseDnVecDescr_t from_ = nullptr, to_ = nullptr;
  Buffer work_;
};

class Bsrmv final : public Product {
 public:
  Bsrmv(const BlockMatrix& matrix, BlockOrder order, float* x, float* y, cudaStream_t stream)
      : Product(matrix, order, x, y, stream) {
    check(library().cusparseCreateMatDescr(&description_), "describing a block matrix");
  }
  ~Bsrmv() override { library().cusparseDestroyMatDescr(description_); }

  void run() override {
    const auto direction = order_ == BlockOrder::by_rows ? CUSPARSE_DIRECTION_ROW : CUSPARSE_DIRECTION_COLUMN;
    check(library().cusparseSbsrmv(handle_, direction, CUSPARSE_OPERATION_NON_TRANSPOSE, rows_, rows_, count_, &one_,
                                   description_, reinterpret_cast<const float*>(blocks_.data()),
                                   reinterpret_cast<const int*>(begin_.data()),
                                   reinterpret_cast<const int*>(columns_.data()), 3, x_, &zero_, y_),
          "cusparseSbsrmv()");
  }
  [[nodiscard]] std::string name() const override { return "cusparseSbsrmv, " + order_name(); }

 private:
  cusparseMatDescr_t description_ = nullptr;  // a general matrix that counts from 0, as it is made
};
// NOLINTEND(clang-analyzer-core.CallAndMessage)

/// The time of one product, among several in a row.
double seconds_of(CusparseProduct& product, cudaStream_t stream) {
  constexpr int products = 20;
  product.run();
  cuda::check(cudaStreamSynchronize(stream), "waiting for cuSPARSE's first product");
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < products; ++k) product.run();
  cuda::check(cudaStreamSynchronize(stream), "waiting for cuSPARSE's products");
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / products;
}

}  // namespace

std::string missing_cusparse() { return library().shared.missing(); }

std::unique_ptr<CusparseProduct> CusparseProduct::make(const BlockMatrix& matrix, BlockOrder order, float* x, float* y,
                                                       cudaStream_t stream) {
  return std::make_unique<SpMV>(matrix, order, x, y, stream);
}

std::unique_ptr<CusparseProduct> CusparseProduct::fastest(const fem::AssembledStiffness& stiffness,
                                                          std::span<const std::uint8_t> fixed, float* x, float* y,
                                                          cudaStream_t stream) {
  std::unique_ptr<CusparseProduct> best;
  std::string refusals;
  const auto consider = [&](const auto& make) {
    try {
      std::unique_ptr<CusparseProduct> product = make();
      product->seconds = seconds_of(*product, stream);
      if (best == nullptr || product->seconds < best->seconds) best = std::move(product);
    } catch (const Error& error) {  // which another way may not meet
      (void)cudaGetLastError();     // so that the next check does not see it
      refusals += std::string("\n  ") + error.what();
    }
  };
  for (const BlockOrder order : {BlockOrder::by_columns, BlockOrder::by_rows}) {
    const BlockMatrix matrix = make_block_matrix(stiffness, fixed, order);
    consider([&] { return make(matrix, order, x, y, stream); });
    consider([&] { return std::make_unique<Bsrmv>(matrix, order, x, y, stream); });
  }
  if (best == nullptr) throw Error("cuSPARSE cannot multiply by a block matrix here:" + refusals);
  return best;
}

}  // namespace physgen::bench
#else
namespace physgen::bench {

std::string missing_cusparse() { return "this program was built without cusparse.h, so its rows are left out"; }

std::unique_ptr<CusparseProduct> CusparseProduct::fastest(const fem::AssembledStiffness& /*stiffness*/,
                                                          std::span<const std::uint8_t> /*fixed*/, float* /*x*/,
                                                          float* /*y*/, cudaStream_t /*stream*/) {
  throw Error(missing_cusparse());
}

std::unique_ptr<CusparseProduct> CusparseProduct::make(const BlockMatrix& /*matrix*/, BlockOrder /*order*/,
                                                       float* /*x*/, float* /*y*/, cudaStream_t /*stream*/) {
  throw Error(missing_cusparse());
}

}  // namespace physgen::bench
#endif
