// Loads cuSPARSE and calls its sparse product.
#include "cusparse.h"

#include <physgen/buffer.h>
#include <physgen/error.h>

#if __has_include(<cusparse.h>)
#include <cusparse.h>

#include <limits>

#include "vendor_library.h"

namespace physgen::bench {

namespace {

/// The functions that are called. Null where the library cannot be had.
struct Library {
  decltype(&cusparseCreate) create = nullptr;
  decltype(&cusparseDestroy) destroy = nullptr;
  decltype(&cusparseCreateBsr) create_matrix = nullptr;
  decltype(&cusparseDestroySpMat) destroy_matrix = nullptr;
  decltype(&cusparseCreateDnVec) create_vector = nullptr;
  decltype(&cusparseDestroyDnVec) destroy_vector = nullptr;
  decltype(&cusparseSpMV_bufferSize) work_size = nullptr;
  decltype(&cusparseSpMV) multiply = nullptr;
  VendorLibrary shared{"libcusparse.so", {".13", ".12"}};

  Library() {
    const auto find = [this](const char* name, auto& function) { shared.find(name, function); };
    find("cusparseCreate", create);
    find("cusparseDestroy", destroy);
    find("cusparseCreateBsr", create_matrix);
    find("cusparseDestroySpMat", destroy_matrix);
    find("cusparseCreateDnVec", create_vector);
    find("cusparseDestroyDnVec", destroy_vector);
    find("cusparseSpMV_bufferSize", work_size);
    find("cusparseSpMV", multiply);
  }
};

const Library& library() {
  static const Library loaded;
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

}  // namespace

std::string cusparse_missing() { return library().shared.missing(); }

struct BlockProduct::State {
  Buffer begin, column, blocks, x, y, work;
  index_t scalars;
  cusparseHandle_t handle = nullptr;
  cusparseSpMatDescr_t matrix = nullptr;
  cusparseDnVecDescr_t from = nullptr, to = nullptr;
  float one = 1, zero = 0;
};

BlockProduct::BlockProduct(const BlockMatrix& matrix, const std::vector<float>& x) : state_(std::make_unique<State>()) {
  State& s = *state_;
  if (!library().shared.missing().empty()) throw Error(library().shared.missing());
  const auto rows = static_cast<std::int64_t>(matrix.begin.size()) - 1;
  s.begin = on_device(matrix.begin, "row begins");
  s.column = on_device(matrix.column, "columns");
  s.blocks = on_device(matrix.blocks, "blocks");
  s.x = on_device(x, "x");
  s.y = Buffer(SpaceKind::cuda, s.x.bytes(), "y");
  s.scalars = static_cast<index_t>(x.size());
  check(library().create(&s.handle), "starting cuSPARSE");
  check(library().create_matrix(&s.matrix, rows, rows, static_cast<std::int64_t>(matrix.column.size()), 3, 3,
                                s.begin.data(), s.column.data(), s.blocks.data(), CUSPARSE_INDEX_32I,
                                CUSPARSE_INDEX_32I, CUSPARSE_INDEX_BASE_ZERO, CUDA_R_32F,
                                matrix.order == BlockOrder::rows ? CUSPARSE_ORDER_ROW : CUSPARSE_ORDER_COL),
        "describing a block matrix");
  check(library().create_vector(&s.from, s.scalars, s.x.data(), CUDA_R_32F), "describing a vector");
  check(library().create_vector(&s.to, s.scalars, s.y.data(), CUDA_R_32F), "describing a vector");
  std::size_t bytes = 0;
  check(library().work_size(s.handle, CUSPARSE_OPERATION_NON_TRANSPOSE, &s.one, s.matrix, s.from, &s.zero, s.to,
                            CUDA_R_32F, CUSPARSE_SPMV_ALG_DEFAULT, &bytes),
        "asking for cuSPARSE's work space");
  s.work = Buffer(SpaceKind::cuda, static_cast<index_t>(bytes) + 16, "cuSPARSE's work space");
}

BlockProduct::~BlockProduct() {
  if (state_->from != nullptr) library().destroy_vector(state_->from);
  if (state_->to != nullptr) library().destroy_vector(state_->to);
  if (state_->matrix != nullptr) library().destroy_matrix(state_->matrix);
  if (state_->handle != nullptr) library().destroy(state_->handle);
}

void BlockProduct::run() {
  State& s = *state_;
  check(library().multiply(s.handle, CUSPARSE_OPERATION_NON_TRANSPOSE, &s.one, s.matrix, s.from, &s.zero, s.to,
                           CUDA_R_32F, CUSPARSE_SPMV_ALG_DEFAULT, s.work.data()),
        "cuSPARSE's product");
}

void BlockProduct::poison() {
  const std::vector<float> none(static_cast<std::size_t>(state_->scalars), std::numeric_limits<float>::quiet_NaN());
  copy_memory(state_->y.data(), SpaceKind::cuda, reinterpret_cast<const std::byte*>(none.data()), SpaceKind::host,
              state_->y.bytes());
}

std::vector<float> BlockProduct::result() const {
  std::vector<float> y(static_cast<std::size_t>(state_->scalars));
  copy_memory(reinterpret_cast<std::byte*>(y.data()), SpaceKind::host, state_->y.data(), SpaceKind::cuda,
              state_->y.bytes());
  return y;
}

}  // namespace physgen::bench

#else

namespace physgen::bench {

std::string cusparse_missing() { return "built without cuSPARSE's header: its row is left out"; }
struct BlockProduct::State {};
BlockProduct::BlockProduct(const BlockMatrix& /*matrix*/, const std::vector<float>& /*x*/) {
  throw Error(cusparse_missing());
}
BlockProduct::~BlockProduct() = default;
void BlockProduct::run() {}
void BlockProduct::poison() {}
std::vector<float> BlockProduct::result() const { return {}; }

}  // namespace physgen::bench
#endif
