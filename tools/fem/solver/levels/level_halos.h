// Rows of the table of kernels (physgen/distributed/halo_uses.h) for steps of levels that the table of a scene lacks:
// those of products, which are performed in the host's own way, and those of kernels between two levels, whose arrays a
// scene has but once, under one name.
#pragma once

#include <physgen/distributed/halo_uses.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace physgen::fem {

namespace detail {

inline constexpr const char *of_child_ranges = "level.child_ranges.begin, level.child_ranges.end",
                            *of_children = "level.child_entries.code", *of_parents = "level.parents.nodes",
                            *of_term_ranges = "level.edge_term_ranges.begin, level.edge_term_ranges.end",
                            *of_terms = "level.edge_term_entries.code", *of_edges = "level.edges.nodes",
                            *of_terms_and_edges = "level.edge_term_entries.code, level.edges.nodes",
                            *of_node_edge_ranges = "level.node_edge_ranges.begin, level.node_edge_ranges.end",
                            *of_node_edges = "level.node_edge_entries.code";
inline constexpr HaloAccess reads_own{.reads_own = true}, reads_others{.reads_others = true},
    reads_all{.reads_own = true, .reads_others = true}, writes_own{.writes_own = true},
    changes_own{.reads_own = true, .writes_own = true};

inline constexpr HaloUse halos_of_levels[] = {
    {"physgen::fem::SymmetricProduct", 0, "K", reads_own},
    {"physgen::fem::SymmetricProduct", 1, "E", reads_others, of_node_edges},
    {"physgen::fem::SymmetricProduct", 2, "nodes", reads_others, of_node_edges},
    {"physgen::fem::SymmetricProduct", 3, "dx", reads_all, of_edges},
    {"physgen::fem::SymmetricProduct", 4, "df", changes_own},

    {"physgen::fem::RestrictResidual", 0, "weights", reads_others, of_children},
    {"physgen::fem::RestrictResidual", 1, "begin", reads_own},
    {"physgen::fem::RestrictResidual", 1, "end", reads_own},
    {"physgen::fem::RestrictResidual", 2, "code", reads_others, of_child_ranges},
    {"physgen::fem::RestrictResidual", 3, "inverse", reads_others, of_children},
    {"physgen::fem::RestrictResidual", 4, "df", reads_others, of_children},
    {"physgen::fem::RestrictResidual", 5, "fixed", reads_own},
    {"physgen::fem::RestrictResidual", 6, "scale", reads_own},
    {"physgen::fem::RestrictResidual", 7, "df", writes_own},

    {"physgen::fem::InterpolateCorrection", 0, "nodes", reads_own},
    {"physgen::fem::InterpolateCorrection", 0, "weights", reads_own},
    {"physgen::fem::InterpolateCorrection", 1, "scale", reads_others, of_parents},
    {"physgen::fem::InterpolateCorrection", 2, "dx", reads_others, of_parents},
    {"physgen::fem::InterpolateCorrection", 3, "fixed", reads_own},
    {"physgen::fem::InterpolateCorrection", 4, "inverse", reads_own},
    {"physgen::fem::InterpolateCorrection", 5, "K", reads_own},
    {"physgen::fem::InterpolateCorrection", 6, "dx", writes_own},
    {"physgen::fem::InterpolateCorrection", 7, "dx", changes_own},
    {"physgen::fem::InterpolateCorrection", 8, "df", changes_own},

    {"physgen::fem::CoarsenEdgeStiffness", 0, "begin", reads_own},
    {"physgen::fem::CoarsenEdgeStiffness", 0, "end", reads_own},
    {"physgen::fem::CoarsenEdgeStiffness", 1, "code", reads_others, of_term_ranges},
    {"physgen::fem::CoarsenEdgeStiffness", 2, "K", reads_others, of_terms},
    {"physgen::fem::CoarsenEdgeStiffness", 3, "E", reads_others, of_terms},
    {"physgen::fem::CoarsenEdgeStiffness", 4, "E", writes_own},

    {"physgen::fem::CoarsenPlaneStiffness", 0, "begin", reads_own},
    {"physgen::fem::CoarsenPlaneStiffness", 0, "end", reads_own},
    {"physgen::fem::CoarsenPlaneStiffness", 1, "code", reads_others, of_child_ranges},
    {"physgen::fem::CoarsenPlaneStiffness", 2, "K", reads_others, of_children},
    {"physgen::fem::CoarsenPlaneStiffness", 3, "K", writes_own},
    {"physgen::fem::CoarsenPlaneStiffness", 4, "K", changes_own},

    // In a background grid, whose nodes' parents are added as level.parents, too.
    {"physgen::fem::CoarsenToGrid", 0, "begin", reads_own},
    {"physgen::fem::CoarsenToGrid", 0, "end", reads_own},
    {"physgen::fem::CoarsenToGrid", 1, "code", reads_others, of_term_ranges},
    {"physgen::fem::CoarsenToGrid", 2, "nodes", reads_others, of_terms_and_edges},
    {"physgen::fem::CoarsenToGrid", 2, "weights", reads_others, of_terms_and_edges},
    {"physgen::fem::CoarsenToGrid", 3, "fixed", reads_others, of_terms_and_edges},
    {"physgen::fem::CoarsenToGrid", 4, "nodes", reads_others, of_terms},
    {"physgen::fem::CoarsenToGrid", 5, "K", reads_others, of_terms},
    {"physgen::fem::CoarsenToGrid", 6, "E", reads_others, of_terms},
    {"physgen::fem::CoarsenToGrid", 7, "nodes", reads_own},
    {"physgen::fem::CoarsenToGrid", 8, "E", writes_own},

    {"physgen::fem::CoarsenTranslationStiffness", 0, "weights", reads_others, of_children},
    {"physgen::fem::CoarsenTranslationStiffness", 1, "begin", reads_own},
    {"physgen::fem::CoarsenTranslationStiffness", 1, "end", reads_own},
    {"physgen::fem::CoarsenTranslationStiffness", 2, "code", reads_others, of_child_ranges},
    {"physgen::fem::CoarsenTranslationStiffness", 3, "T", reads_others, of_children},
    {"physgen::fem::CoarsenTranslationStiffness", 4, "T", writes_own},

    // From a coarser mesh on which equilibrium was found.
    {"physgen::fem::InterpolateMotion", 0, "nodes", reads_own},
    {"physgen::fem::InterpolateMotion", 1, "x", reads_own},
    {"physgen::fem::InterpolateMotion", 2, "x", reads_others, of_parents},
    {"physgen::fem::InterpolateMotion", 3, "x", reads_others, of_parents},
    {"physgen::fem::InterpolateMotion", 4, "x", reads_others, of_parents},
    {"physgen::fem::InterpolateMotion", 5, "x", reads_others, of_parents},
    {"physgen::fem::InterpolateMotion", 6, "f", reads_others, of_parents},
    {"physgen::fem::InterpolateMotion", 7, "dx", reads_others, of_parents},
    {"physgen::fem::InterpolateMotion", 8, "fixed", reads_own},
    {"physgen::fem::InterpolateMotion", 9, "x", changes_own},

    {"physgen::fem::InjectPatchPressures", 0, "patch", reads_own},
    {"physgen::fem::InjectPatchPressures", 1, "linearised", reads_others, "patches.parents.patch"},
    {"physgen::fem::InjectPatchPressures", 2, "linearised", writes_own},

    // Of blocks that are stored in half.
    {"physgen::fem::KeepTranslations", 0, "begin", reads_own},
    {"physgen::fem::KeepTranslations", 0, "end", reads_own},
    {"physgen::fem::KeepTranslations", 1, "code", reads_others, of_node_edge_ranges},
    {"physgen::fem::KeepTranslations", 2, "nodes", reads_others, of_node_edges},
    {"physgen::fem::KeepTranslations", 3, "fixed", reads_all, of_edges},
    {"physgen::fem::KeepTranslations", 4, "scale", reads_all, of_edges},
    {"physgen::fem::KeepTranslations", 4, "inverse", reads_others, of_edges},
    {"physgen::fem::KeepTranslations", 5, "E", reads_others, of_node_edges},
    {"physgen::fem::KeepTranslations", 6, "K", changes_own},

    // Of a level that all ranks have.
    {"physgen::fem::detail::InvertStiffness", 0, "K", reads_others},
    {"physgen::fem::detail::InvertStiffness", 1, "E", reads_others},
    {"physgen::fem::detail::InvertStiffness", 2, "nodes", reads_others},
    {"physgen::fem::detail::InvertStiffness", 3, "fixed", reads_others},
    {"physgen::fem::detail::InvertStiffness", 4, "scale", reads_others},
    {"physgen::fem::detail::InvertStiffness", 5, "G", {.writes_others = true}},
};

}  // namespace detail

/// The table of a scene's program over levels, on several ranks.
/// @param scene its own, of arrays "level.constraints" and so on
[[nodiscard]] inline std::vector<HaloUse> with_halos_of_levels(HaloUses scene) {
  std::vector<HaloUse> rows(std::begin(detail::halos_of_levels), std::end(detail::halos_of_levels));
  std::ranges::copy_if(scene, std::back_inserter(rows), [](const HaloUse& row) {
    return std::ranges::find(detail::halos_of_levels, row.kernel, &HaloUse::kernel) ==
           std::end(detail::halos_of_levels);
  });
  return rows;
}

}  // namespace physgen::fem
