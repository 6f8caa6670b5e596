// An order of a mesh by parts that METIS finds: nodes and tets that follow each other lie in one compact body. It costs
// an analysis of the mesh's graph, and shortens the way from a tet to its nodes in memory where the mesh's own numbers
// jump; and whoever cuts the list of nodes into a few runs cuts the body along small surfaces.
#pragma once

#include <fem/mesh/renumber.h>

#include <span>

namespace physgen::fem {

/// Whether this build has METIS.
[[nodiscard]] bool has_metis();

/// METIS halves the graph of the mesh's nodes and edges again and again, into 64 parts, or a smaller power of two where
/// they would have fewer than 8 nodes. Nodes: by part, and within a part by their old numbers. Tets: by material, then
/// by the part of their lowest new node, then by their old numbers. The same mesh gets the same order in the same
/// build: the number of parts and METIS's seed are fixed. Another version of METIS may give another order, so that
/// whoever goes on later keeps it. METIS draws from the C library's rand(), whose state is lost; calls wait for each
/// other.
/// @param material_ends where the tets have several materials, in whose order they lie: for each the number behind its
/// last tet
/// @throw Error in a build without METIS, or when METIS has too little memory
/// @pre a mesh of make_tet_mesh()
[[nodiscard]] Renumbering order_by_parts(const TetMesh& mesh, std::span<const Index> material_ends = {});

}  // namespace physgen::fem
