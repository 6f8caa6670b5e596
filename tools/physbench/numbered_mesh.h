// The Truth Cube under three numberings of its nodes and tets: as it was made, at random, and renumbered for locality.
#pragma once

#include "dataset.h"
#include "row.h"

namespace physgen::bench {

/// What F = Ds Dm^-1 reads, and F itself, for all tets.
struct NumberedMesh {
  Master<elasticity::TetObject> tets;
  Master<elasticity::NodePositionObject> positions;
  Master<elasticity::RestShapeObject> rest_shapes;
  Master<elasticity::DeformationGradientObject> gradients;
};

/// @param set "ordered", "random", or "renumbered": the random one with the numbers that renumber_for_locality() finds
/// @throw Error when there is not enough memory
[[nodiscard]] NumberedMesh make_numbered_mesh(fem::Index cells, const std::string& set);

/// Relative errors of F.
[[nodiscard]] Accuracy gradient_errors(const elasticity::DeformationGradientArray<float>& result,
                                       const NumberedMesh& mesh);

}  // namespace physgen::bench
