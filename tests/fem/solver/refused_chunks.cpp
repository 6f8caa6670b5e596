// Kernels over a chunk of tets that would count them in float: a compiler must refuse them. refused.py compares what it
// reports.
#include <fem/solver/elastic/tet_chunks.h>

using namespace physgen;

/// refused tets_that_are_counted_in_float: float has no number for each tet of a large chunk
bool tets_that_are_counted_in_float(const fem::TetChunk& chunk) { return chunk.own<float>(index_t{3}); }

// ---- What is not refused ----
bool accepted(const fem::TetChunk& chunk) { return chunk.own<double>(index_t{3}); }
