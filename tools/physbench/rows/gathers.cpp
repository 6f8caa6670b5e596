// Rows of the CPU: nodes gathered under three numberings.
#include "../gathers.h"

#include <physgen/parallel_for.h>

#include "../groups.h"
#include "../timing.h"

namespace physgen::bench {

namespace {

template <class NodeLayout>
class HostGatherCase final : public TimedHostCase {
 public:
  explicit HostGatherCase(const NumberedMesh& mesh) : HostGatherCase(mesh, GatherOperands<Host, NodeLayout>(mesh)) {}
  double run() override {
    const auto kernel = operands_.kernel();
    const Stopwatch watch;
    parallel_for(Host{}, operands_.tets.size(), kernel);
    return watch.seconds();
  }
  Accuracy check() override {
    poison(operands_.gradients.storage());
    run();
    return gradient_errors(operands_.gradients, mesh_);
  }

 private:
  HostGatherCase(const NumberedMesh& mesh, GatherOperands<Host, NodeLayout> operands)
      : TimedHostCase(operands.bytes()), mesh_(mesh), operands_(std::move(operands)) {}
  const NumberedMesh& mesh_;
  GatherOperands<Host, NodeLayout> operands_;
};

template <class NodeLayout>
void add(std::vector<Row>& rows, const Dataset& data, const char* layout,
         const std::shared_ptr<NumberedMeshes>& meshes) {
  add_gather_rows(rows, data, layout, SpaceKind::host, meshes,
                  [](const NumberedMesh& mesh) { return std::make_unique<HostGatherCase<NodeLayout>>(mesh); });
}

}  // namespace

void add_host_gather_rows(std::vector<Row>& rows, Dataset& data) {
  const auto meshes = std::make_shared<NumberedMeshes>(data.cells());
  add<Aos>(rows, data, "aos", meshes);
  add<AosPadded>(rows, data, "aos_padded", meshes);
  add<Soa>(rows, data, "soa", meshes);
  add<Aosoa<16>>(rows, data, "aosoa16", meshes);
}

}  // namespace physgen::bench
