// The table of the kernels of random graphs.
#pragma once

#include <physgen/distributed/halo_uses.h>

#include <cstddef>

namespace graphs {
using namespace physgen;

inline constexpr HaloAccess own{.reads_own = true}, others{.reads_others = true}, written{.writes_own = true},
    changed{.reads_own = true, .writes_own = true}, everything{.reads_own = true, .reads_others = true};
inline constexpr const char *of_ends = "b.ranges.begin, b.ranges.end", *of_touches = "b.touched.begin, b.touched.end",
                            *of_members = "b.member_ranges.begin, b.member_ranges.end";
/// Rows without which an exchange or a stale field would be missed come first; the others are needed to know over which
/// set a kernel runs, and that no index is written.
inline constexpr HaloUse table[] = {
    {"graphs::Pull", 1, "x", others, "b.edges.nodes"},
    {"graphs::Pull", 2, "f", written},
    {"graphs::SumPulls", 2, "f", others, "b.ends.element"},
    {"graphs::SumPulls", 3, "f", written},
    {"graphs::Smooth", 3, "x", everything, "b.ends.element, b.edges.nodes"},
    {"graphs::Smooth", 4, "dx", written},
    {"graphs::Move", 0, "f", own},
    {"graphs::Move", 1, "dx", own},
    {"graphs::Move", 2, "x", changed},
    {"graphs::Share", 1, "x", others, "b.quads.nodes"},
    {"graphs::Share", 2, "df", changed},
    {"graphs::AddShares", 2, "df", others, "b.touches.element"},
    {"graphs::AddShares", 3, "f", changed},
    {"graphs::Mix", 0, "f", own},
    {"graphs::Mix", 1, "dx", changed},
    {"graphs::Drift", 0, "dx", own},
    {"graphs::Drift", 1, "x", changed},
    {"graphs::Lengths", 0, "x", others, "b.edges.nodes"},
    {"graphs::PullPart", 1, "x", others, "b.edges.nodes"},
    {"graphs::PullPart", 2, "f", written},
    {"graphs::Collect", 2, "x", others, "b.members.element"},
    {"graphs::Collect", 3, "f", others, "b.members.element"},
    {"graphs::Collect", 6, "f", changed},
    {"graphs::Spread", 2, "dx", changed},
    {"graphs::Pull", 0, "nodes", own},
    {"graphs::SumPulls", 0, "begin", own},
    {"graphs::SumPulls", 0, "end", own},
    {"graphs::SumPulls", 1, "element", others, of_ends},
    {"graphs::SumPulls", 1, "local", others, of_ends},
    {"graphs::Smooth", 0, "begin", own},
    {"graphs::Smooth", 0, "end", own},
    {"graphs::Smooth", 1, "element", others, of_ends},
    {"graphs::Smooth", 1, "local", others, of_ends},
    {"graphs::Smooth", 2, "nodes", others, "b.ends.element"},
    {"graphs::Share", 0, "nodes", own},
    {"graphs::AddShares", 0, "begin", own},
    {"graphs::AddShares", 0, "end", own},
    {"graphs::AddShares", 1, "element", others, of_touches},
    {"graphs::Lengths", 1, "nodes", own},
    {"graphs::PullPart", 0, "nodes", own},
    {"graphs::Clear", 0, "x", own},
    {"graphs::Clear", 1, "f", written},
    {"graphs::Degree", 0, "begin", own},
    {"graphs::Degree", 0, "end", own},
    {"graphs::Degree", 1, "", {}},
    {"graphs::Degree", 2, "x", changed},
    {"graphs::Quarter", 0, "f", own},
    {"graphs::Quarter", 1, "f", written},
    {"graphs::Push", 0, "f", own},
    {"graphs::Push", 1, "x", changed},
    {"graphs::Collect", 0, "begin", own},
    {"graphs::Collect", 0, "end", own},
    {"graphs::Collect", 1, "element", others, of_members},
    {"graphs::Collect", 1, "local", others, of_members},
    {"graphs::Collect", 4, "nodes", own},
    {"graphs::Collect", 5, "dx", others, "b.links.nodes"},
    {"graphs::Spread", 0, "nodes", own},
    {"graphs::Spread", 1, "f", others, "b.homes.nodes"},
    {"graphs::Settle", 0, "nodes", own},
    {"graphs::Settle", 1, "f", others, "b.links.nodes"},
    {"graphs::Settle", 2, "dx", changed},
    {"graphs::Members", 0, "begin", own},
    {"graphs::Members", 0, "end", own},
    {"graphs::Members", 1, "", {}},
    {"graphs::Members", 2, "f", changed},
};
inline constexpr std::size_t rows_that_count = 24;

}  // namespace graphs
