#include "viewers_file.h"

#include <fem/mesh/follow_numbers.h>

#include "own_numbers.h"

namespace physgen::truthcube {

ViewersFile::ViewersFile(const Options& options, const Scene& scene, int steps_done)
    : level_(scene.levels.front()),
      numbers_(scene.numbers),
      strain_(options.scene == SceneKind::linear_elastic ? Strain::small : Strain::finite) {
  const auto open = [&](const ViewedMesh& mesh) {
    const auto path = options.out / viewers_name;
    file_.emplace(steps_done > 0 ? VtkHdfWriter::append_to(path, mesh, steps_done) : VtkHdfWriter(path, mesh));
  };
  const DrawnMesh drawn(scene);
  if (options.output == Output::body) {
    open({drawn.rest, drawn.tets});
    return;
  }
  std::vector<CellGroup> groups;
  if (numbers_.node_order.empty()) {
    surface_ = surface_of(level_.mesh);
    groups = groups_of(*surface_, scene.groups);
  } else {
    const fem::TetMesh own = fem::make_tet_mesh(level_.mesh.nodes, drawn.own_tets);
    const fem::Renumbering back{fem::new_numbers(numbers_.node_order), fem::new_numbers(numbers_.tet_order)};
    std::vector<fem::MeshGroup> own_groups;
    for (const fem::MeshGroup& group : scene.groups) own_groups.push_back(fem::renumbered(group, own, back));
    surface_ = surface_of(own);
    groups = groups_of(*surface_, own_groups);
  }
  const std::vector<fem::Point> points = points_of(*surface_, drawn.rest);
  open({points, surface_->triangles, groups});
}

void ViewersFile::write_step(double time, const std::vector<fem::Point>& positions,
                             const std::vector<std::array<double, 9>>& stresses) {
  Fields fields = in_own_order(make_fields(level_.mesh, level_.rest, positions, stresses, strain_), numbers_);
  if (surface_) fields = fields_of(*surface_, fields);
  const std::vector<Field> of_points{{"displacement", 3, fields.displacement}, {"pressure", 1, fields.pressure}};
  const std::vector<Field> of_cells{
      {"stress", 6, fields.stress}, {"von_mises", 1, fields.von_mises}, {"J", 1, fields.volume_ratio}};
  file_->write_step(time, of_points, of_cells);
}

}  // namespace physgen::truthcube
