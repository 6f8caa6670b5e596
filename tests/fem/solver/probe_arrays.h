// The arrays of the solver as probes: structs with the members of EquilibriumArrays, LinearLevel and KrylovVectors,
// which the solver's programs take in their place.
#pragma once

#include <fem/solver/conjugate_gradients.h>
#include <fem/solver/equilibrium_arrays.h>
#include <fem/solver/linear_level.h>
#include <physgen/probe.h>

#include <memory>
#include <vector>

namespace physgen::fem::test {

template <class Arrays>
struct PartsOf;
template <class Ranges_, class Entries_>
struct PartsOf<RowArrays<Ranges_, Entries_>> {
  using Ranges = Ranges_;
  using Entries = Entries_;
};
/// A probe of rows, with a tag for the ranges and one for the entries.
template <class Arrays, class RangesTag, class EntriesTag>
using RowsOf = ProbeRows<ProbeOf<typename PartsOf<Arrays>::Ranges, RangesTag>,
                         ProbeOf<typename PartsOf<Arrays>::Entries, EntriesTag>>;

// A member as that of the same name of Owner, whose array is called `label.member`. They are undefined below.
#define PHYSGEN_TEST_TAG(Tag, text)                            \
  struct Tag {                                                 \
    [[maybe_unused]] static constexpr const char* name = text; \
  };
#define PHYSGEN_TEST_PROBE(label, member)           \
  PHYSGEN_TEST_TAG(member##_tag, label "." #member) \
  ProbeOf<decltype(Owner::member), member##_tag> member;
#define PHYSGEN_TEST_ROWS(label, member)                               \
  PHYSGEN_TEST_TAG(member##_ranges_tag, label "." #member ".ranges")   \
  PHYSGEN_TEST_TAG(member##_entries_tag, label "." #member ".entries") \
  RowsOf<decltype(Owner::member), member##_ranges_tag, member##_entries_tag> member;

template <class Real, class Space>
struct ProbePatches {
  using Owner = PatchArrays<Real, Space>;
  PHYSGEN_TEST_PROBE("patches", tet_patches)
  PHYSGEN_TEST_PROBE("patches", nodes)
  PHYSGEN_TEST_PROBE("patches", parents)
  PHYSGEN_TEST_ROWS("patches", patch_tets)
  PHYSGEN_TEST_ROWS("patches", edge_patches)
  PHYSGEN_TEST_ROWS("patches", node_patches)
  PHYSGEN_TEST_PROBE("patches", tangent)
  PHYSGEN_TEST_PROBE("patches", changes)
};

template <class Real, class Space>
struct ProbeRings {
  using Owner = RingArrays<Real, Space>;
  PHYSGEN_TEST_ROWS("rings", nodes)
  PHYSGEN_TEST_PROBE("rings", tangent)
};

template <class Real, class Space>
struct ProbeChunk {
  using Owner = ChunkArrays<Real, Space>;
  PHYSGEN_TEST_PROBE("chunk", corners)
  PHYSGEN_TEST_PROBE("chunk", tangent)
};

template <class Real_, class Space_>
struct ProbeEquilibrium {
  using Real = Real_;
  using Space = Space_;
  using Owner = EquilibriumArrays<Real, Space>;
  PHYSGEN_TEST_PROBE("body", tets)
  PHYSGEN_TEST_ROWS("body", node_tets)
  PHYSGEN_TEST_ROWS("body", edge_tets)
  std::vector<TetChunk> chunks{{0, 1, 0, 1, 0, 1}};
  std::unique_ptr<ProbePatches<Real, Space>> patches;
  std::unique_ptr<ProbeRings<Real, Space>> rings;
  PHYSGEN_TEST_PROBE("body", volumes)
  std::shared_ptr<ProbeChunk<Real, Space>> chunk_arrays = std::make_shared<ProbeChunk<Real, Space>>();
  PHYSGEN_TEST_PROBE("body", rest)
  PHYSGEN_TEST_PROBE("body", positions)
  PHYSGEN_TEST_PROBE("body", trial)
  PHYSGEN_TEST_PROBE("body", kept)
  PHYSGEN_TEST_PROBE("body", loads)
  PHYSGEN_TEST_PROBE("body", motion)
  PHYSGEN_TEST_PROBE("body", forces)
  PHYSGEN_TEST_PROBE("body", trial_forces)
  PHYSGEN_TEST_PROBE("body", increment)
  PHYSGEN_TEST_PROBE("body", state)

  [[nodiscard]] index_t nodes() const { return 1; }
  [[nodiscard]] index_t tet_count() const { return 1; }
  [[nodiscard]] TetChunk all_tets() const { return chunks.front(); }
};

template <class Real_, class Space_, class FactorFormats>
struct ProbeSchwarz {
  using Real = Real_;
  using Space = Space_;
  using Owner = SchwarzArrays<Real, Space, FactorFormats>;
  std::vector<Index> first_block{0, 1, 2}, first_pair{0, 1, 2};
  PHYSGEN_TEST_PROBE("schwarz", nodes)
  PHYSGEN_TEST_PROBE("schwarz", slots)
  PHYSGEN_TEST_PROBE("schwarz", blocks)
  PHYSGEN_TEST_ROWS("schwarz", supernode_terms)
  PHYSGEN_TEST_ROWS("schwarz", pair_terms)
  PHYSGEN_TEST_ROWS("schwarz", block_edges)
  PHYSGEN_TEST_PROBE("schwarz", supernodes)
  PHYSGEN_TEST_PROBE("schwarz", pair_stiffness)
  PHYSGEN_TEST_PROBE("schwarz", residual)
  PHYSGEN_TEST_PROBE("schwarz", correction)
  PHYSGEN_TEST_PROBE("schwarz", factors)

  [[nodiscard]] index_t node_blocks() const { return first_block[1]; }
  [[nodiscard]] index_t block_count() const { return first_block.back(); }
};

template <class Real, class Space>
struct ProbePlanes {
  using Owner = PlaneArrays<Real, Space>;
  PHYSGEN_TEST_PROBE("planes", planes)
  PHYSGEN_TEST_PROBE("planes", areas)
  PHYSGEN_TEST_PROBE("planes", stiffness)
  [[nodiscard]] auto at(const AtLoad& load) const {
    return RigidPlanes{1.0, load, planes.const_view(), areas.const_view()};
  }
};

template <class Space>
struct ProbeInertia {
  using Owner = InertiaArrays<Space>;
  double per_mass = 0;
  PHYSGEN_TEST_PROBE("inertia", masses)
  PHYSGEN_TEST_PROBE("inertia", centres)
  PHYSGEN_TEST_PROBE("inertia", velocities)
  PHYSGEN_TEST_PROBE("inertia", measured)
  [[nodiscard]] auto at_step() const { return Inertia{per_mass, masses.const_view(), centres.const_view()}; }
};

template <class Real_, class Space_, class Stored_>
struct ProbeLevel {
  using Real = Real_;
  using Space = Space_;
  using Stored = Stored_;
  using Choices = AnyChoice;
  using Owner = LinearLevel<Real, Space, Stored>;
  bool assembled = true;
  bool is_grid = false;
  EdgeSums sums;
  PHYSGEN_TEST_PROBE("level", constraints)
  PHYSGEN_TEST_PROBE("level", edges)
  PHYSGEN_TEST_ROWS("level", node_edges)
  PHYSGEN_TEST_PROBE("level", node_stiffness)
  PHYSGEN_TEST_PROBE("level", edge_stiffness)
  PHYSGEN_TEST_PROBE("level", scales)
  PHYSGEN_TEST_PROBE("level", scaled_nodes)
  PHYSGEN_TEST_PROBE("level", scaled_edges)
  PHYSGEN_TEST_PROBE("level", inverse)
  PHYSGEN_TEST_PROBE("level", smoother)
  PHYSGEN_TEST_PROBE("level", residual)
  PHYSGEN_TEST_PROBE("level", correction)
  PHYSGEN_TEST_PROBE("level", direction)
  PHYSGEN_TEST_PROBE("level", power)
  PHYSGEN_TEST_PROBE("level", parents)
  PHYSGEN_TEST_PROBE("level", grid_parents)
  PHYSGEN_TEST_ROWS("level", children)
  PHYSGEN_TEST_ROWS("level", edge_terms)
  PHYSGEN_TEST_PROBE("level", translations)
  PHYSGEN_TEST_PROBE("level", coarse_inverse)
  std::unique_ptr<ProbeSchwarz<Real, Space, typename Stored::template Factors<Space>>> schwarz;
  std::unique_ptr<ProbePlanes<Real, Space>> planes;
  std::unique_ptr<ProbeInertia<Space>> inertia;

  [[nodiscard]] index_t nodes() const { return 1; }
  [[nodiscard]] index_t edge_count() const { return 1; }
};

template <class Real, class Space>
struct ProbeVectors {
  using Owner = KrylovVectors<Real, Space>;
  PHYSGEN_TEST_PROBE("krylov", step)
  PHYSGEN_TEST_PROBE("krylov", residual)
  PHYSGEN_TEST_PROBE("krylov", direction)
  PHYSGEN_TEST_PROBE("krylov", product)
  PHYSGEN_TEST_PROBE("krylov", state)
};
#undef PHYSGEN_TEST_ROWS
#undef PHYSGEN_TEST_PROBE
#undef PHYSGEN_TEST_TAG

}  // namespace physgen::fem::test
