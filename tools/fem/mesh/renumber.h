// New numbers for the nodes and tets of a mesh. Kernels over tets gather from nodes: they are fast when the corners of
// tets that follow each other lie close together in memory, which a mesh generator's or a file's order need not give.
#pragma once

#include <fem/mesh/mesh.h>

#include <cstdint>
#include <vector>

namespace physgen::fem {

/// New node i is old node node_order[i], new tet t is old tet tet_order[t]. What belongs to nodes or tets follows by
/// the same rule: new_positions[i] = positions[node_order[i]].
struct Renumbering {
  std::vector<Index> node_order, tet_order;
  bool operator==(const Renumbering&) const = default;
};

/// Numbers that keep neighbours close. Nodes: reverse Cuthill-McKee over the mesh's edges, part by part where the mesh
/// is disconnected, parts in the order of their lowest old nodes. Tets: by their lowest new node, then the next ones.
/// Equal meshes get equal numbers from the same build. Takes O(n log n) time, and some 300 bytes per node for a while.
/// Source: Cuthill and McKee 1969, George 1971.
/// @pre a mesh of make_tet_mesh()
[[nodiscard]] Renumbering renumber_for_locality(const TetMesh& mesh);

/// Numbers drawn at random: the worst case for gathers, which benchmarks compare with. The seed alone decides.
[[nodiscard]] Renumbering random_numbering(const TetMesh& mesh, std::uint64_t seed);

/// The same mesh under new numbers. Tets keep the order of their corners, hence their sign of volume; edges and
/// incidence lists are built anew, ascending in the new numbers.
/// @throws Error when an order does not name each old node, or tet, once
[[nodiscard]] TetMesh renumbered(const TetMesh& mesh, const Renumbering& numbers);

}  // namespace physgen::fem
