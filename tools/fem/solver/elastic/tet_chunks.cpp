#include <fem/solver/elastic/tet_chunks.h>
#include <physgen/error.h>

#include <algorithm>
#include <string>

namespace physgen::fem {

index_t most_chunk_tets(SpaceKind space) {
  // On CUDA 2^17 take 4 % longer at 1.6 million tets, and 2^21 no less time. On the CPU 2^14 fit its caches.
  return space == SpaceKind::cuda ? index_t{1} << 18 : index_t{1} << 14;
}

std::vector<MaterialRange> material_ranges(const MeshLevel& level) {
  std::vector<MaterialRange> ranges;
  index_t tet = 0, volume = 0;
  for (const Index end : level.material_ends) {
    MaterialRange& range = ranges.emplace_back(MaterialRange{tet, end, volume, volume});
    for (; tet < end && !level.patches.nodes.empty(); ++tet) {
      const index_t patch = level.patches.tet_patch[static_cast<std::size_t>(tet)];
      if (patch < volume) {
        throw Error("patch " + std::to_string(patch) + " has tet " + std::to_string(tet) +
                    " and one of another material; make patches by greedy_patches(mesh, material_ends)");
      }
      range.last_volume = std::max(range.last_volume, patch + 1);
    }
    tet = end;
    volume = range.last_volume;
  }
  return ranges;
}

std::vector<TetChunk> make_tet_chunks(const TetMesh& mesh, std::span<const std::array<Index, 2>> edges, index_t most,
                                      std::span<const Index> material_ends) {
  const auto tets = static_cast<index_t>(mesh.tets.size());
  const auto materials = std::max<index_t>(static_cast<index_t>(material_ends.size()), 1);
  std::vector<TetChunk> chunks;
  MaterialRange own{0, 0, 0, 0};
  for (index_t m = 0; m < materials; ++m) {
    own.first_tet = own.last_tet;
    own.last_tet = material_ends.empty() ? tets : index_t{material_ends[static_cast<std::size_t>(m)]};
    for (index_t first = 0; first < tets; first += most) {
      chunks.push_back(make_tet_chunk(
          own, m, first, std::min(first + most, tets), mesh.nodes, static_cast<index_t>(edges.size()),
          [&](index_t t) { return mesh.tets[static_cast<std::size_t>(t)]; },
          [&](index_t e) { return index_t{edges[static_cast<std::size_t>(e)][0]}; }));
    }
  }
  return chunks;
}

}  // namespace physgen::fem
