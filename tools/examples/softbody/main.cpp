// A soft body on groups of its mesh: held, pulled and hanging sideways, solved, and written for ParaView.
#include <fem/mesh/gmsh_file.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/load_case.h>
#include <truthcube/output/vtkhdf.h>

#include <cstdio>

using namespace physgen;

int main(int count, char** words) try {
  fem::ReadMesh read = fem::read_gmsh(count > 1 ? words[1] : "lobe.msh");
  for (fem::Point& x : read.rest) x = {1e-3 * x[0], 1e-3 * x[1], 1e-3 * x[2]};  // the mesh is in millimetres
  std::vector<fem::MeshLevel> levels(1);
  levels[0].mesh = fem::make_tet_mesh(static_cast<fem::Index>(read.rest.size()), read.tets);
  levels[0].rest = read.rest;
  levels[0].patches = fem::greedy_patches(levels[0].mesh);  // against locking

  const std::vector<std::vector<fem::MeshGroup>> groups{read.groups};
  const fem::LoadCase load_case{
      .supports = {{"base"}}, .forces = {{"tip", {0, 0.1, 0.05}}}, .gravity = {9.81, 0, 0}, .density = 1060};
  const fem::Loading loading = fem::apply_load_case(load_case, levels, groups);
  fem::add_background_grid(levels);  // for multigrid

  fem::SolverSettings settings;
  settings.youngs_modulus = 6e3, settings.poissons_ratio = 0.45, settings.nested = false;
  const auto solver = fem::make_solver(levels, loading, settings);
  truthcube::VtkHdfWriter file("lobe.vtkhdf", {read.rest, levels[0].mesh.tets});
  for (const double load : {0.5, 1.0}) {
    if (solver->solve_to(load, {}).status != fem::NewtonStatus::converged) {
      return std::fprintf(stderr, "softbody: no equilibrium at a load of %g; try smaller steps\n", load), 3;
    }
    const auto positions = solver->positions();
    std::vector<double> moved(3 * positions.size());
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = positions[i / 3][i % 3] - read.rest[i / 3][i % 3];
    file.write_step(load, {{{"displacement", 3, moved}}}, {});
    const fem::Point held = fem::reaction_of(fem::group_named(read.groups, "base").nodes, levels[0], solver->forces());
    std::printf("load %g: reaction of base (%.5g, %.5g, %.5g) N\n", load, held[0], held[1], held[2]);
  }
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
