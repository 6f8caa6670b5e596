// See numbered_mesh.h.
#include "numbered_mesh.h"

#include <fem/mesh_arrays.h>
#include <fem/renumber.h>

#include <Eigen/LU>

#include "errors.h"

namespace physgen::bench {

namespace {

std::vector<fem::Point> reordered(const std::vector<fem::Point>& points, const std::vector<fem::Index>& order) {
  std::vector<fem::Point> result;
  result.reserve(points.size());
  for (const fem::Index old : order) result.push_back(points[static_cast<std::size_t>(old)]);
  return result;
}

void renumber(fem::TruthCube& cube, const fem::Renumbering& numbers) {
  cube.mesh = fem::renumbered(cube.mesh, numbers);
  cube.rest = reordered(cube.rest, numbers.node_order);
  cube.deformed = reordered(cube.deformed, numbers.node_order);
}

Eigen::Matrix3d edge_matrix(const std::array<fem::Index, 4>& tet, const std::vector<fem::Point>& points) {
  Eigen::Matrix3d d;
  const fem::Point& origin = points[static_cast<std::size_t>(tet[0])];
  for (int c = 0; c < 3; ++c) {
    const fem::Point& corner = points[static_cast<std::size_t>(tet[static_cast<std::size_t>(c) + 1])];
    for (int r = 0; r < 3; ++r) d(r, c) = corner[static_cast<std::size_t>(r)] - origin[static_cast<std::size_t>(r)];
  }
  return d;
}

}  // namespace

NumberedMesh make_numbered_mesh(fem::Index cells, const std::string& set) {
  constexpr std::uint64_t seed = 20100622;
  fem::TruthCube cube = fem::make_truth_cube(cells, seed);
  if (set != "ordered") renumber(cube, fem::random_numbering(cube.mesh, seed));
  if (set == "renumbered") renumber(cube, fem::renumber_for_locality(cube.mesh));
  const auto n = static_cast<index_t>(cube.mesh.tets.size());
  NumberedMesh made{Master<elasticity::TetObject>(n), Master<elasticity::NodePositionObject>(cube.mesh.nodes),
                    Master<elasticity::RestShapeObject>(n), Master<elasticity::DeformationGradientObject>(n)};
  fem::store_tets(cube.mesh, made.tets.view());
  fem::store_positions(cube.deformed, made.positions.view());
  const auto shapes = made.rest_shapes.view();
  const auto gradients = made.gradients.view();
#pragma omp parallel for
  for (index_t t = 0; t < n; ++t) {
    const auto& tet = cube.mesh.tets[static_cast<std::size_t>(t)];
    const Eigen::Matrix3d dm = edge_matrix(tet, cube.rest), inverse = dm.inverse();
    shapes.put(t, {inverse, dm.determinant() / 6});
    gradients.put(t, {edge_matrix(tet, cube.deformed) * inverse});
  }
  return made;
}

Accuracy gradient_errors(const elasticity::DeformationGradientArray<float>& result, const NumberedMesh& mesh) {
  check_written(result.storage());
  std::vector<double> errors(static_cast<std::size_t>(result.size())), norms(errors.size());
#pragma omp parallel for
  for (index_t t = 0; t < result.size(); ++t) {
    const Eigen::Matrix3d expected = mesh.gradients.view().get(t).F;
    const Eigen::Matrix3f got = result.view().get(t).F;
    errors[static_cast<std::size_t>(t)] = (got.cast<double>() - expected).norm();
    norms[static_cast<std::size_t>(t)] = expected.norm();
  }
  return relative_errors(std::move(errors), norms);
}

}  // namespace physgen::bench
