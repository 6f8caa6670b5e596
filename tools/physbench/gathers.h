// The case of rows that gather nodes, for all spaces: F = Ds Dm^-1 over streamed tets and nodes in a layout of their
// own.
#pragma once

#include <fem/deformation_gradient.h>

#include <array>
#include <map>
#include <memory>

#include "errors.h"
#include "numbered_mesh.h"
#include "row.h"

namespace physgen::bench {

/// The meshes of all rows, made when they are first asked for.
class NumberedMeshes {
 public:
  explicit NumberedMeshes(fem::Index cells) : cells_(cells) {}
  const NumberedMesh& get(const std::string& set) {
    auto& mesh = meshes_[set];
    if (!mesh) mesh = std::make_unique<NumberedMesh>(make_numbered_mesh(cells_, set));
    return *mesh;
  }

 private:
  fem::Index cells_;
  std::map<std::string, std::unique_ptr<NumberedMesh>> meshes_;
};

inline constexpr std::array numberings{"ordered", "random", "renumbered"};

/// Inputs and output of one row.
template <class Space, class NodeLayout>
struct GatherOperands {
  using Streamed = PerSpace<Space, Aosoa<16>, Aosoa<32>>;
  Array<elasticity::TetObject, float, Space, Streamed> tets;
  Array<elasticity::NodePositionObject, float, Space, NodeLayout> positions;
  Array<elasticity::RestShapeObject, float, Space, Streamed> rest_shapes;
  Array<elasticity::DeformationGradientObject, float, Space, Streamed> gradients;

  explicit GatherOperands(const NumberedMesh& mesh)
      : tets(mesh.tets.size()),
        positions(mesh.positions.size()),
        rest_shapes(mesh.tets.size()),
        gradients(mesh.tets.size()) {
    physgen::copy(tets, mesh.tets);
    physgen::copy(positions, mesh.positions);
    physgen::copy(rest_shapes, mesh.rest_shapes);
    if constexpr (!host_accessible(Space::kind)) synchronize();
  }
  [[nodiscard]] auto kernel() {
    return fem::ComputeDeformationGradient{tets.const_view(), positions.const_view(), rest_shapes.const_view(),
                                           gradients.view()};
  }
  /// Bytes that must be moved, whatever the layout: corners, nodes, rest shapes without volume, F.
  [[nodiscard]] double bytes() const {
    return static_cast<double>(tets.size()) * (16 + 36 + 36) + static_cast<double>(positions.size()) * 12;
  }
};

/// A row for each numbering. @param make make(mesh, bytes of the copy beside it) is its case
template <class Make>
void add_gather_rows(std::vector<Row>& rows, const Dataset& data, const char* layout, SpaceKind space,
                     const std::shared_ptr<NumberedMeshes>& meshes, const Make& make) {
  const double c = data.cells(), tets = 6 * c * c * c, nodes = (c + 1) * (c + 1) * (c + 1);
  for (const char* set : numberings) {
    Row row;
    row.kernel = "gather_nodes";
    row.layout = layout;
    row.storage = "float";
    row.space = name(space);
    row.set = set;
    row.objects = static_cast<index_t>(tets);
    row.bytes_per_object = 88 + 12 * nodes / tets;
    row.make = [meshes, set, make]() -> std::unique_ptr<Case> { return make(meshes->get(set)); };
    rows.push_back(std::move(row));
  }
}

}  // namespace physgen::bench
