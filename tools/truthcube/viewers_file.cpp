#include "viewers_file.h"

namespace physgen::truthcube {

ViewersFile::ViewersFile(const Options& options, const Scene& scene, int steps_done)
    : level_(scene.levels.front()),
      strain_(options.scene == SceneKind::linear_elastic ? Strain::small : Strain::finite) {
  const auto open = [&](const ViewedMesh& mesh) {
    const auto path = options.out / viewers_name;
    file_.emplace(steps_done > 0 ? VtkHdfWriter::append_to(path, mesh, steps_done) : VtkHdfWriter(path, mesh));
  };
  if (options.output == Output::body) {
    open({level_.rest, level_.mesh.tets});
    return;
  }
  surface_ = surface_of(level_.mesh);
  const std::vector<fem::Point> points = points_of(*surface_, level_.rest);
  const std::vector<CellGroup> groups = groups_of(*surface_, scene.groups);
  open({points, surface_->triangles, groups});
}

void ViewersFile::write_step(double time, const std::vector<fem::Point>& positions,
                             const std::vector<std::array<double, 9>>& stresses) {
  Fields fields = make_fields(level_.mesh, level_.rest, positions, stresses, strain_);
  if (surface_) fields = fields_of(*surface_, fields);
  const std::vector<Field> of_points{{"displacement", 3, fields.displacement}, {"pressure", 1, fields.pressure}};
  const std::vector<Field> of_cells{
      {"stress", 6, fields.stress}, {"von_mises", 1, fields.von_mises}, {"J", 1, fields.volume_ratio}};
  file_->write_step(time, of_points, of_cells);
}

}  // namespace physgen::truthcube
