// Rows of the GPU: nodes gathered under three numberings.
#include <physgen/cuda/parallel_for.h>

#include "../cuda_timing.h"
#include "../gathers.h"
#include "../groups.h"

namespace physgen::bench {

namespace {

template <class NodeLayout>
class CudaGatherCase final : public TimedCudaCase {
 public:
  explicit CudaGatherCase(const NumberedMesh& mesh) : CudaGatherCase(mesh, GatherOperands<Cuda, NodeLayout>(mesh)) {}
  double run() override {
    const auto kernel = operands_.kernel();
    watch().start();
    parallel_for(Cuda{}, operands_.tets.size(), kernel);
    return watch().stop();
  }
  Accuracy check() override {
    poison_device(operands_.gradients.storage());
    run();
    elasticity::DeformationGradientArray<float> result(operands_.gradients.size());
    physgen::copy(result, operands_.gradients);
    synchronize();
    return gradient_errors(result, mesh_);
  }

 private:
  CudaGatherCase(const NumberedMesh& mesh, GatherOperands<Cuda, NodeLayout> operands)
      : TimedCudaCase(operands.bytes()), mesh_(mesh), operands_(std::move(operands)) {}
  const NumberedMesh& mesh_;
  GatherOperands<Cuda, NodeLayout> operands_;
};

template <class NodeLayout>
void add(std::vector<Row>& rows, const Dataset& data, const char* layout,
         const std::shared_ptr<NumberedMeshes>& meshes) {
  add_gather_rows(rows, data, layout, SpaceKind::cuda, meshes,
                  [](const NumberedMesh& mesh) { return std::make_unique<CudaGatherCase<NodeLayout>>(mesh); });
}

}  // namespace

void add_cuda_gather_rows(std::vector<Row>& rows, Dataset& data) {
  const auto meshes = std::make_shared<NumberedMeshes>(data.cells());
  add<Aos>(rows, data, "aos", meshes);
  add<AosPadded>(rows, data, "aos_padded", meshes);
  add<Soa>(rows, data, "soa", meshes);
  add<Aosoa<32>>(rows, data, "aosoa32", meshes);
}

}  // namespace physgen::bench
