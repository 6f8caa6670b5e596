// Rows of cuSPARSE's product of a block sparse matrix, for comparison: cusparseSpMV over 3x3 blocks of the whole
// stiffness, rounded to float.
#include <physgen/memory/buffer.h>

#include <limits>
#include <memory>

#include "groups/forces.h"
#include "measure/cuda.h"
#include "vendor/cusparse_product.h"

namespace physgen::bench {

namespace {

/// The stiffness of the scene, of which nothing is prescribed.
BlockMatrix block_matrix_of(Scene& scene, BlockOrder order) {
  const OnScene<SymmetricForceDifferential, float> provider(std::shared_ptr<Scene>(&scene, [](Scene*) {}));
  const auto inputs = provider.inputs();
  const auto diagonal = std::get<0>(inputs).view();
  const auto blocks = std::get<1>(inputs).view();
  const auto edges = std::get<2>(inputs).view();
  const auto block_of = [](const Eigen::Matrix3d& K) {
    fem::AssembledStiffness::Block block{};
    Eigen::Matrix3d::Map(block.data()) = K;
    return block;
  };
  fem::AssembledStiffness stiffness;
  for (index_t n = 0; n < diagonal.size(); ++n) stiffness.nodes.push_back(block_of(diagonal.get(n).K));
  for (index_t e = 0; e < edges.size(); ++e) {
    const auto nodes = edges.get(e).nodes;
    stiffness.edges.push_back({static_cast<fem::Index>(nodes[0]), static_cast<fem::Index>(nodes[1])});
    stiffness.edge_blocks.push_back(block_of(blocks.get(e).E));
  }
  return make_block_matrix(stiffness, std::vector<std::uint8_t>(stiffness.nodes.size()), order);
}

/// The product with vectors of its own.
class ProductOfScene {
 public:
  ProductOfScene(Scene& scene, BlockOrder order) {
    const auto displacements = source::Displacements::of(scene).view();
    std::vector<float> x;
    for (index_t n = 0; n < displacements.size(); ++n) {
      const Eigen::Vector3f dx = displacements.get(n).dx.template cast<float>();
      x.insert(x.end(), dx.begin(), dx.end());
    }
    x_ = Buffer(SpaceKind::cuda, static_cast<index_t>(x.size() * sizeof(float)), "x");
    y_ = Buffer(SpaceKind::cuda, x_.bytes(), "y");
    write(x_, x);
    product_ = CusparseProduct::make(block_matrix_of(scene, order), order, reinterpret_cast<float*>(x_.data()),
                                     reinterpret_cast<float*>(y_.data()), nullptr);
  }
  /// Orders a product in the default stream.
  void run() { product_->run(); }
  /// Fills y with NaN.
  void poison() {
    write(y_, std::vector<float>(static_cast<std::size_t>(y_.bytes()) / sizeof(float),
                                 std::numeric_limits<float>::quiet_NaN()));
  }
  [[nodiscard]] std::vector<float> result() const {
    std::vector<float> y(static_cast<std::size_t>(y_.bytes()) / sizeof(float));
    copy_memory(reinterpret_cast<std::byte*>(y.data()), SpaceKind::host, y_.data(), SpaceKind::cuda, y_.bytes());
    return y;
  }

 private:
  static void write(Buffer& to, const std::vector<float>& from) {
    copy_memory(to.data(), SpaceKind::cuda, reinterpret_cast<const std::byte*>(from.data()), SpaceKind::host,
                to.bytes());
  }

  Buffer x_, y_;
  std::unique_ptr<CusparseProduct> product_;
};

void add_row(std::vector<Row>& rows, index_t tets, const char* layout, BlockOrder order) {
  using Provider = OnScene<SymmetricForceDifferential, float>;
  const Provider provider(scene_of(tets));
  Adder<CudaDevice, Provider>(rows, provider).add(layout, [provider, order] {
    const auto product = std::make_shared<ProductOfScene>(*provider.scene(), order);
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

[[maybe_unused]] const bool known = add_library("cusparse", missing_cusparse);
[[maybe_unused]] const bool rows = add(Part{"forces", 1, "", "cuda", [](std::vector<Row>& rows, const Sizes& given) {
                                              if (!missing_cusparse().empty()) return;
                                              const index_t tets = sizes_of_forces(given).cuda;
                                              add_row(rows, tets, "cusparse_bsr_columns", BlockOrder::by_columns);
                                              add_row(rows, tets, "cusparse_bsr_rows", BlockOrder::by_rows);
                                            }});

}  // namespace

}  // namespace physgen::bench
