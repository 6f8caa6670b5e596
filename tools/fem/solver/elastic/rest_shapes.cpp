#include <fem/kernels/deformation_gradient.h>
#include <fem/mesh/mesh_arrays.h>
#include <fem/solver/elastic/rest_shapes.h>
#include <physgen/parallel_for.h>

namespace physgen::fem {

elasticity::TetArray<double> host_tets(const MeshLevel& level) {
  elasticity::TetArray<double> tets(index_t(level.mesh.tets.size()));
  store_tets(level.mesh, tets.view());
  return tets;
}

elasticity::RestShapeArray<double> host_rest_shapes(const MeshLevel& level) {
  elasticity::NodePositionArray<double> positions(level.mesh.nodes);
  store_positions(level.rest, positions.view());
  const auto tets = host_tets(level);
  elasticity::RestShapeArray<double> shapes(tets.size());
  parallel_for(Host{}, shapes.size(), ComputeRestShape{tets.const_view(), positions.const_view(), shapes.view()});
  return shapes;
}

}  // namespace physgen::fem
