// cuSPARSE's product of a block sparse matrix, for comparison: cusparseSpMV over 3x3 blocks of the whole stiffness. The
// library is looked for when the program runs; where its header is missing, it has no rows.
#if __has_include(<cusparse.h>)
#include <cusparse.h>
#include <physgen/buffer.h>
#include <physgen/error.h>

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <memory>

#include "groups/forces.h"
#include "measure/cuda.h"
#include "vendor/library.h"

// clang-format off
#define PHYSGEN_CUSPARSE(USE) \
  USE(cusparseCreate) USE(cusparseDestroy) USE(cusparseCreateBsr) \
  USE(cusparseDestroySpMat) USE(cusparseCreateDnVec) USE(cusparseDestroyDnVec) \
  USE(cusparseSpMV_bufferSize) USE(cusparseSpMV)
// clang-format on

namespace physgen::bench {

namespace {

PHYSGEN_VENDOR_LIBRARY(Cusparse, PHYSGEN_CUSPARSE, "libcusparse.so", {".13", ".12"});

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

/// y = A x in device memory over full 3x3 blocks, rounded to float; entries of a block by rows or by columns.
class BlockProduct {
 public:
  BlockProduct(Scene& scene, cusparseOrder_t order) {
    make_blocks(scene, order == CUSPARSE_ORDER_ROW);
    const auto& displacements = source::Displacements::of(scene);
    std::vector<float> x;
    for (index_t n = 0; n < displacements.size(); ++n) {
      const Eigen::Vector3d dx = displacements.view().get(n).dx;
      for (int k = 0; k < 3; ++k) x.push_back(static_cast<float>(dx[k]));
    }
    x_ = on_device(x, "x");
    y_ = Buffer(SpaceKind::cuda, x_.bytes(), "y");
    const auto scalars = static_cast<std::int64_t>(x.size()), rows = scalars / 3;
    check(library().cusparseCreate(&handle_), "starting cuSPARSE");
    check(library().cusparseCreateBsr(&matrix_, rows, rows, column_.bytes() / index_t{sizeof(int)}, 3, 3, begin_.data(),
                                      column_.data(), blocks_.data(), CUSPARSE_INDEX_32I, CUSPARSE_INDEX_32I,
                                      CUSPARSE_INDEX_BASE_ZERO, CUDA_R_32F, order),
          "describing a block matrix");
    check(library().cusparseCreateDnVec(&from_, scalars, x_.data(), CUDA_R_32F), "describing a vector");
    check(library().cusparseCreateDnVec(&to_, scalars, y_.data(), CUDA_R_32F), "describing a vector");
    std::size_t bytes = 0;
    check(library().cusparseSpMV_bufferSize(handle_, CUSPARSE_OPERATION_NON_TRANSPOSE, &one_, matrix_, from_, &zero_,
                                            to_, CUDA_R_32F, CUSPARSE_SPMV_ALG_DEFAULT, &bytes),
          "asking for cuSPARSE's work space");
    work_ = Buffer(SpaceKind::cuda, static_cast<index_t>(bytes) + 16, "cuSPARSE's work space");
  }
  BlockProduct(const BlockProduct&) = delete;
  BlockProduct& operator=(const BlockProduct&) = delete;
  // NOLINTBEGIN(clang-analyzer-core.CallAndMessage): where functions are missing, nobody makes a BlockProduct
  ~BlockProduct() {
    if (from_ != nullptr) library().cusparseDestroyDnVec(from_);
    if (to_ != nullptr) library().cusparseDestroyDnVec(to_);
    if (matrix_ != nullptr) library().cusparseDestroySpMat(matrix_);
    if (handle_ != nullptr) library().cusparseDestroy(handle_);
  }

  /// Orders a product in the default stream.
  void run() {
    check(library().cusparseSpMV(handle_, CUSPARSE_OPERATION_NON_TRANSPOSE, &one_, matrix_, from_, &zero_, to_,
                                 CUDA_R_32F, CUSPARSE_SPMV_ALG_DEFAULT, work_.data()),
          "cuSPARSE's product");
  }
  // NOLINTEND(clang-analyzer-core.CallAndMessage)
  /// Fills y with NaN.
  void poison() {
    const std::vector<float> none(static_cast<std::size_t>(y_.bytes()) / sizeof(float),
                                  std::numeric_limits<float>::quiet_NaN());
    copy_memory(y_.data(), SpaceKind::cuda, reinterpret_cast<const std::byte*>(none.data()), SpaceKind::host,
                y_.bytes());
  }
  [[nodiscard]] std::vector<float> result() const {
    std::vector<float> y(static_cast<std::size_t>(y_.bytes()) / sizeof(float));
    copy_memory(reinterpret_cast<std::byte*>(y.data()), SpaceKind::host, y_.data(), SpaceKind::cuda, y_.bytes());
    return y;
  }

 private:
  /// 3x3 blocks by rows: row r has the blocks begin[r] .. begin[r + 1] - 1 with ascending columns.
  void make_blocks(Scene& scene, bool by_rows) {
    const OnScene<AddForceDifferential, float> provider(std::shared_ptr<Scene>(&scene, [](Scene*) {}));
    const auto inputs = provider.inputs();
    const auto diagonal = std::get<0>(inputs).view();
    const auto stiffness = std::get<1>(inputs).view();
    const auto edges = std::get<2>(inputs).view();
    const auto ranges = std::get<3>(inputs).view();
    const auto entries = std::get<4>(inputs).view();
    std::vector<int> begin{0}, columns;
    std::vector<float> blocks;
    std::vector<std::pair<int, Eigen::Matrix3d>> row;
    for (index_t node = 0; node < ranges.size(); ++node) {
      row.assign(1, {static_cast<int>(node), diagonal.get(node).K});
      const auto range = ranges.get(node);
      for (index_t k = range.begin; k < range.end; ++k) {
        const auto entry = entries.get(k);
        const Eigen::Matrix3d E = stiffness.get(entry.element).E;
        const int other = edges.get(entry.element).nodes[1 - entry.local];
        row.emplace_back(other, entry.local == 0 ? E : Eigen::Matrix3d(E.transpose()));
      }
      std::ranges::sort(row, {}, [](const auto& entry) { return entry.first; });
      for (const auto& [column, block] : row) {
        columns.push_back(column);
        for (int k = 0; k < 9; ++k) {
          blocks.push_back(static_cast<float>(by_rows ? block(k / 3, k % 3) : block(k % 3, k / 3)));
        }
      }
      begin.push_back(static_cast<int>(columns.size()));
    }
    begin_ = on_device(begin, "row begins");
    column_ = on_device(columns, "columns");
    blocks_ = on_device(blocks, "blocks");
  }

  Buffer begin_, column_, blocks_, x_, y_, work_;
  cusparseHandle_t handle_ = nullptr;
  cusparseSpMatDescr_t matrix_ = nullptr;
  cusparseDnVecDescr_t from_ = nullptr, to_ = nullptr;
  float one_ = 1, zero_ = 0;
};

void add_row(std::vector<Row>& rows, index_t tets, const char* layout, cusparseOrder_t order) {
  using Provider = OnScene<SymmetricForceDifferential, float>;
  const Provider provider(scene_of(tets));
  Adder<CudaDevice, Provider>(rows, provider).add(layout, [provider, order] {
    const auto product = std::make_shared<BlockProduct>(*provider.scene(), order);
    Case made;
    made.bytes = provider.bytes();
    made.run = [product] { return CudaDevice::time([&] { product->run(); }); };
    made.copy = CudaDevice::copy(made.bytes);
    made.check = [product, provider, run = made.run] {
      product->poison();
      run();
      const std::vector<float> y = product->result();
      auto results = make_arrays<HostArrays<AddForceDifferential::Writes, float>>(
          [&y](std::size_t /*k*/) { return static_cast<index_t>(y.size() / 3); });
      const auto view = std::get<0>(results).view();
      for (index_t n = 0; n < view.size(); ++n) {
        const float* at = y.data() + 3 * n;
        view[n].df() = Eigen::Vector3f(at[0], at[1], at[2]);
      }
      return provider.check(results);
    };
    return made;
  });
}

[[maybe_unused]] const bool known = add_library("cusparse", [] { return library().shared.missing(); });
[[maybe_unused]] const bool rows = add(Part{"forces", 1, "", "cuda", [](std::vector<Row>& rows, const Sizes& given) {
                                              if (!library().shared.missing().empty()) return;
                                              const index_t tets = sizes_of_forces(given).cuda;
                                              add_row(rows, tets, "cusparse_bsr_columns", CUSPARSE_ORDER_COL);
                                              add_row(rows, tets, "cusparse_bsr_rows", CUSPARSE_ORDER_ROW);
                                            }});

}  // namespace

}  // namespace physgen::bench
#endif
