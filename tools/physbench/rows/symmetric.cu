// Rows of the GPU: the product with the assembled stiffness, by gathers over incidences, by its symmetric half, and
// cuSPARSE's over full blocks.
#include <fem/symmetric_product_cuda.h>

#include "../cuda_rows.h"
#include "../cusparse.h"
#include "../groups.h"
#include "../symmetric.h"

namespace physgen::bench {

namespace {

template <class Real, fem::SumOrder kOrder>
class CudaSymmetricCase final : public TimedCudaCase {
 public:
  CudaSymmetricCase(Dataset& data, double bytes) : TimedCudaCase(bytes), data_(data), operands_(data) {}
  double run() override {
    const auto product = operands_.product();
    watch().start();
    fem::multiply(Cuda{}, product, operands_.sums, kOrder);
    return watch().stop();
  }
  Accuracy check() override {
    poison_device(operands_.differentials.storage());
    run();
    Result<AddForceDifferential, Real> result(operands_.differentials.size());
    physgen::copy(result, operands_.differentials);
    synchronize();
    return HostKernel<AddForceDifferential>::check(data_, result.storage());
  }

 private:
  Dataset& data_;
  SymmetricOperands<Real, Cuda> operands_;
};

/// Full blocks, rounded to float.
BlockMatrix full_blocks(Dataset& data, BlockOrder order) {
  const auto& ranges = data.incidences(Domain::node_edges).ranges;
  const auto entries = data.incidences(Domain::node_edges).entries.view();
  const auto edges = data.edges().view();
  BlockMatrix matrix;
  matrix.order = order;
  matrix.begin.push_back(0);
  std::vector<std::pair<int, Eigen::Matrix3d>> row;
  for (index_t node = 0; node < ranges.size(); ++node) {
    row.assign(1, {static_cast<int>(node), data.node_stiffness().view().get(node).K});
    const auto range = ranges.view().get(node);
    for (index_t k = range.begin; k < range.end; ++k) {
      const auto entry = entries.get(k);
      const Eigen::Matrix3d E = data.edge_stiffness().view().get(entry.element).E;
      const int other = edges.get(entry.element).nodes[1 - entry.local];
      row.emplace_back(other, entry.local == 0 ? E : Eigen::Matrix3d(E.transpose()));
    }
    std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [column, block] : row) {
      matrix.column.push_back(column);
      for (int k = 0; k < 9; ++k) {
        const double entry = order == BlockOrder::rows ? block(k / 3, k % 3) : block(k % 3, k / 3);
        matrix.blocks.push_back(static_cast<float>(entry));
      }
    }
    matrix.begin.push_back(static_cast<int>(matrix.column.size()));
  }
  return matrix;
}

std::vector<float> vector_of(const Master<elasticity::NodeDisplacementObject>& displacements) {
  std::vector<float> x;
  for (index_t n = 0; n < displacements.size(); ++n) {
    const Eigen::Vector3d dx = displacements.view().get(n).dx;
    for (int k = 0; k < 3; ++k) x.push_back(static_cast<float>(dx[k]));
  }
  return x;
}

template <BlockOrder kOrder>
class CusparseCase final : public TimedCudaCase {
 public:
  CusparseCase(Dataset& data, double bytes)
      : TimedCudaCase(bytes), data_(data), product_(full_blocks(data, kOrder), vector_of(data.displacements())) {}
  double run() override {
    watch().start();
    product_.run();
    return watch().stop();
  }
  Accuracy check() override {
    product_.poison();
    run();
    const std::vector<float> y = product_.result();
    Result<AddForceDifferential, float> result(static_cast<index_t>(y.size() / 3));
    for (index_t n = 0; n < result.size(); ++n) {
      const float* at = y.data() + 3 * n;
      result.view()[n].df() = Eigen::Vector3f(at[0], at[1], at[2]);
    }
    return HostKernel<AddForceDifferential>::check(data_, result.storage());
  }

 private:
  Dataset& data_;
  BlockProduct product_;
};

template <class Real, class MeasuredCase>
void add(std::vector<Row>& rows, Dataset& data, const char* layout) {
  Row row = symmetric_row<Real>(layout, SpaceKind::cuda, data);
  const double bytes = row.bytes_per_object * static_cast<double>(row.objects);
  row.make = [&data, bytes]() -> std::unique_ptr<Case> { return std::make_unique<MeasuredCase>(data, bytes); };
  rows.push_back(std::move(row));
}

}  // namespace

void add_cuda_force_rows(std::vector<Row>& rows, Dataset& data) {
  CudaKernel<AddForceDifferential>::add_rows(rows, data);
  using fem::SumOrder;
  add<float, CudaSymmetricCase<float, SumOrder::any>>(rows, data, "symmetric_fast");
  add<float, CudaSymmetricCase<float, SumOrder::fixed>>(rows, data, "symmetric_deterministic");
  if (cusparse_missing().empty()) {
    add<float, CusparseCase<BlockOrder::columns>>(rows, data, "cusparse_bsr_columns");
    add<float, CusparseCase<BlockOrder::rows>>(rows, data, "cusparse_bsr_rows");
  }
  add<double, CudaSymmetricCase<double, SumOrder::any>>(rows, data, "symmetric_fast");
  add<double, CudaSymmetricCase<double, SumOrder::fixed>>(rows, data, "symmetric_deterministic");
}

}  // namespace physgen::bench
