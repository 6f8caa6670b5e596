#include "viewers_file.h"

#include <fem/mesh/follow_numbers.h>

#include <array>
#include <utility>
#include <vector>

#include "own_numbers.h"
#include "surface.h"

namespace physgen::truthcube {

using fem::Index;

namespace {

const std::vector<FieldKind> of_points{{"displacement", 3}, {"pressure", 1}};
const std::vector<FieldKind> of_cells{{"stress", 6}, {"von_mises", 1}, {"J", 1}};

/// The surface of the finest mesh under its own numbers, and its groups.
std::pair<Surface, std::vector<CellGroup>> drawn_surface(const Scene& scene, const DrawnMesh& drawn) {
  const fem::TetMesh& mesh = scene.levels.front().mesh;
  const auto& [node_order, tet_order] = scene.numbers;
  if (node_order.empty()) {
    Surface surface = surface_of(mesh);
    std::vector<CellGroup> groups = groups_of(surface, scene.groups);
    return {std::move(surface), std::move(groups)};
  }
  const fem::TetMesh own = fem::make_tet_mesh(mesh.nodes, drawn.own_tets);
  const fem::Renumbering back{fem::new_numbers(node_order), fem::new_numbers(tet_order)};
  std::vector<fem::MeshGroup> own_groups;
  for (const fem::MeshGroup& group : scene.groups) own_groups.push_back(fem::renumbered(group, own, back));
  Surface surface = surface_of(own);
  std::vector<CellGroup> groups = groups_of(surface, own_groups);
  return {std::move(surface), std::move(groups)};
}

/// @param surface that is drawn; none where all of the body is
DrawnRows drawn_rows(const fem::Renumbering& numbers, Index nodes, const Surface* surface) {
  DrawnRows rows;
  if (!numbers.node_order.empty()) {
    rows = {fem::new_numbers(numbers.node_order), fem::new_numbers(numbers.tet_order), numbers.node_order};
  }
  if (surface == nullptr) return rows;
  const auto of_solver = [](const std::vector<Index>& own, const std::vector<Index>& rows_of_own) {
    return rows_of_own.empty() ? own : fem::in_order(std::span(rows_of_own), std::span(own));
  };
  rows.nodes = of_solver(surface->nodes, rows.nodes);
  rows.tets = of_solver(surface->tets, rows.tets);
  rows.row_of_node.assign(static_cast<std::size_t>(nodes), -1);
  for (std::size_t r = 0; r < rows.nodes.size(); ++r) {
    rows.row_of_node[static_cast<std::size_t>(rows.nodes[r])] = static_cast<Index>(r);
  }
  return rows;
}

}  // namespace

ViewersFile::ViewersFile(const Options& options, const Scene& scene, int steps_done, bool writes) {
  const fem::MeshLevel& level = scene.levels.front();
  const auto open = [&](const ViewedMesh& mesh) {
    if (!writes) return;
    const auto path = options.out / viewers_name;
    file_.emplace(steps_done > 0 ? VtkHdfWriter::append_to(path, mesh, steps_done) : VtkHdfWriter(path, mesh));
  };
  const DrawnMesh drawn(scene);
  DrawnRows rows;
  if (options.output == Output::body) {
    rows = drawn_rows(scene.numbers, level.mesh.nodes, nullptr);
    open({drawn.rest, drawn.tets});
  } else {
    const auto [surface, groups] = drawn_surface(scene, drawn);
    rows = drawn_rows(scene.numbers, level.mesh.nodes, &surface);
    const std::vector<fem::Point> points = points_of(surface, drawn.rest);
    open({points, surface.triangles, groups});
  }
  const Strain strain = options.scene == SceneKind::linear_elastic ? Strain::small : Strain::finite;
  fields_.emplace(level.mesh, level.rest, strain, std::move(rows), options.window);
}

void ViewersFile::write_step(double time, BodyState& state) {
  std::optional<VtkHdfWriter::Step> step;
  if (file_) step.emplace(file_->begin_step(time, of_points, of_cells));
  fields_->each_points(state, [&](const PointFields& fields) {
    step->add_points(std::array{Field{"displacement", 3, fields.displacement}, Field{"pressure", 1, fields.pressure}});
  });
  fields_->each_cells(state, [&](const CellFields& fields) {
    step->add_cells(std::array{Field{"stress", 6, fields.stress}, Field{"von_mises", 1, fields.von_mises},
                               Field{"J", 1, fields.volume_ratio}});
  });
  if (step) step->end();
}

}  // namespace physgen::truthcube
