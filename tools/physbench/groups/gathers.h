// Nodes gathered by tets under three numberings of the mesh: F = Ds Dm^-1 with streamed tets, and nodes in the layout
// that is measured.
#pragma once

#include "kernels/deformation_gradient.h"
#include "measure/kernel_case.h"
#include "measure/scene_data.h"

namespace physgen::bench {

struct GatherNodes : DeformationGradient {
  static constexpr const char* name = "gather_nodes";
  using Reads = Operands<Tiled<source::Tets>, Streamed<source::Positions>, Tiled<source::RestShapes>>;
  using Writes = Operands<Tiled<source::Of<Output, Domain::tets>>>;
};

/// The rows of a layout of the nodes, one for each numbering. @param tets at least so many; all of the mesh take part
template <class Device, class NodeLayout>
void add_gather_rows(std::vector<Row>& rows, index_t tets, const char* layout) {
  const index_t all = Scene(tets).count(Domain::tets, Domain::nodes);
  for (const Numbering numbering : {Numbering::ordered, Numbering::random, Numbering::renumbered}) {
    const OnScene<GatherNodes, float> provider(scene_of(all, numbering), name(numbering));
    Adder<Device, OnScene<GatherNodes, float>>(rows, provider).template layout<NodeLayout>(layout);
  }
}

}  // namespace physgen::bench
