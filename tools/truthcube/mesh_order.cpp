#include "mesh_order.h"

#include <fem/mesh/follow_numbers.h>
#include <fem/mesh/order.h>
#include <fem/mesh/stages.h>
#include <physgen/error.h>

#include <algorithm>
#include <string>
#include <utility>

#include "output/hash.h"
#include "run_files.h"

namespace physgen::truthcube {

namespace {

using fem::Index;
using fem::Renumbering;

void renumber(fem::MeshLevel& level, const Renumbering& numbers, const Renumbering* coarser) {
  level.mesh = fem::renumbered(level.mesh, numbers);
  level.rest = fem::in_order<fem::Point>(level.rest, numbers.node_order);
  if (coarser == nullptr) return;
  const std::vector<Index> parent = fem::new_numbers(coarser->node_order);
  level.parents = fem::in_order<std::array<Index, 2>>(level.parents, numbers.node_order);
  for (auto& [a, b] : level.parents) {
    const Index one = parent[static_cast<std::size_t>(a)], other = parent[static_cast<std::size_t>(b)];
    a = std::min(one, other);
    b = std::max(one, other);
  }
}

/// Patches of all levels, finest first; a patch's parent is among those of the next level.
void renumber_patches(std::vector<fem::MeshLevel>& levels, const std::vector<Renumbering>& numbers) {
  std::vector<Index> new_patch;  // of the coarser level, which comes first
  for (std::size_t l = levels.size(); l-- > 0;) {
    fem::MeshLevel& level = levels[l];
    fem::RenumberedPatches patches = fem::renumbered(level.patches, numbers[l]);
    if (!level.patch_parents.empty()) {
      level.patch_parents = fem::in_order<Index>(level.patch_parents, patches.order);
      for (Index& p : level.patch_parents) p = new_patch[static_cast<std::size_t>(p)];
    }
    new_patch = fem::new_numbers(patches.order);
    level.patches = std::move(patches.patches);
  }
}

}  // namespace

void check_order(const Options& options, bool is_given) {
  if (!is_given) return;
  if (options.is_cube()) throw Error("--order is for a mesh of your own: the cube's order is fixed; remove --order");
  if (options.order == NodeOrder::metis && !fem::has_metis()) {
    throw Error(
        "--order metis: this build has no METIS; install libmetis-dev and configure with -DPHYSGEN_METIS=ON, or take "
        "--order mesh");
  }
}

void bring_into_order(GivenMesh& given, const Options& options) {
  if (options.order == NodeOrder::mesh) return;
  const fem::MeshLevel& coarsest = given.levels.back();
  given.order.mesh_hash = mesh_hash(coarsest.rest, coarsest.mesh.tets);
  if (options.restart) {
    given.order = read_last_order(options, given.order.mesh_hash);
  } else {
    given.order.numbers = fem::order_by_parts(coarsest.mesh, coarsest.material_ends);
  }
  fem::InStage stage("new numbers");
  std::vector<Renumbering> numbers(given.levels.size());  // of each level
  numbers.back() = given.order.numbers;
  for (std::size_t l = given.levels.size() - 1; l-- > 0;) {
    numbers[l] = fem::refined_numbers(numbers[l + 1], given.levels[l].parents);
  }
  for (std::size_t l = 0; l < given.levels.size(); ++l) {
    renumber(given.levels[l], numbers[l], l + 1 < numbers.size() ? &numbers[l + 1] : nullptr);
  }
  if (options.volume == VolumeTreatment::patches) renumber_patches(given.levels, numbers);
  for (std::size_t l = 0; l < given.groups.size() && options.is_case(); ++l) {
    for (fem::MeshGroup& group : given.groups[l]) group = fem::renumbered(group, given.levels[l].mesh, numbers[l]);
  }
  given.numbers = std::move(numbers.front());
}

}  // namespace physgen::truthcube
