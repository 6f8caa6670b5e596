// The body between its plates: the cube, or a mesh of the user's, in levels.
#pragma once

#include <fem/mesh/groups.h>
#include <fem/solver/load_case.h>
#include <fem/solver/quasistatic.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "body_state.h"
#include "options.h"
#include "output/order_file.h"
#include "output/window.h"
#include "plates.h"
#include "sizes.h"

namespace physgen::truthcube {

/// A mesh that the user has given.
struct GivenMesh {
  std::vector<fem::MeshLevel> levels;               ///< refined, finest first
  std::vector<std::size_t> tet_tags;                ///< per own tet of the coarsest level: its number in the file
  std::vector<std::vector<fem::MeshGroup>> groups;  ///< of each level
  MeshOrder order;                                  ///< of the coarsest level
  fem::Renumbering numbers;                         ///< of the finest level, as that order gives them; or none
};

/// The mesh in options.mesh, checked and refined.
/// @param notes what a user should know of it is added
/// @throw Error when it cannot be read or is not sound, naming places and remedy, or refined would not fit the memory
[[nodiscard]] GivenMesh read_mesh(const Options& options, std::vector<std::string>& notes);

struct Scene {
  std::vector<fem::MeshLevel> levels;  ///< finest first
  fem::Loading loading;                ///< at a compression of 1; its planes, if any, are the lower and the upper plate
  fem::LoadHistory history;            ///< of a case, in place of it
  PlatesOfBody plates;                 ///< what holds the body
  std::array<fem::Index, 3> grid{};    ///< cells along x, y, z of the background grid; zeros where there is none
  double grading = 1;                  ///< of the cube
  std::vector<std::size_t> tet_tags;   ///< of a mesh of the user's, as GivenMesh has them
  std::vector<fem::MeshGroup> groups;  ///< of the finest level of a case's mesh
  MeshOrder order;                     ///< of that mesh, as the next
  fem::Renumbering numbers;            ///< of the finest level: the solver's numbers, where they are not the mesh's own
  int refinements = 0;                 ///< of that mesh: each tet of it is 8^refinements of the finest level
};

/// The cube of options.cells^3 cells, in levels.
/// @param without_lists so many of the finest levels have tets alone (cube_levels.h)
[[nodiscard]] std::vector<fem::MeshLevel> make_cube(const Options& options, std::size_t without_lists = 0);

/// Levels between plates at their lowest and highest nodes along z. A mesh of the user's that has many nodes gets a
/// background grid for multigrid.
/// @throw Error when fewer than three nodes lie on a plate, or the plates hold every node
[[nodiscard]] Scene make_scene(const Options& options, std::vector<fem::MeshLevel> levels);

/// Levels that a case holds and loads.
/// @throw Error as apply_load_case()
[[nodiscard]] Scene make_case_scene(const Options& options, GivenMesh given);

/// Where the levels do not allow the preconditioner or the way of stepping that is asked for, chooses another.
/// @return what a user should know of it
[[nodiscard]] std::vector<std::string> adapt_solver(Options& options, const Scene& scene,
                                                    const std::vector<LevelCounts>& levels);

/// Where tets are flat (fem::flatness()), which a smoother that goes node by node leaves more in, gives its polynomial
/// a larger degree. Uniform cubes keep theirs.
void adapt_smoother(Options& options, const Scene& scene);

/// "tet 12", under the mesh's own numbers, as cells of cube.vtkhdf are numbered; of a mesh of the user's "tet 12
/// (element 345 of the mesh file)".
[[nodiscard]] std::string name_of_tet(const Scene& scene, fem::Index tet);

/// How far the body reaches past the planes of the plates at a compression [m]; 0 on ranks that get no positions. All
/// ranks call it. @param window bytes
[[nodiscard]] double reach_past_plates(const Scene& scene, double compression, BodyState& state,
                                       std::size_t window = window_bytes);

}  // namespace physgen::truthcube
