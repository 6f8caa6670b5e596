// Sets of arrays and arrays of scenes that a compiler must refuse, with words that say what is wrong. refused.py
// compares them with what it reports.
#include <elasticity.physgen.h>
#include <physgen/row_arrays.h>
#include <physgen/scene.h>
#include <physgen/topology.h>

#include <array>
#include <utility>

using namespace physgen;

namespace {

using Ranges = elasticity::IncidenceRangeArray<float>;
using Entries = elasticity::IncidenceArray<float>;
using PinnedEntries = elasticity::IncidenceArray<float, PinnedHost>;

/// An input of a scene that names as many fields as there are numbers.
template <std::size_t... k>
constexpr auto named(std::index_sequence<k...> /*numbers*/) {
  return scene::detail::names((static_cast<void>(k), "field")...);
}

}  // namespace

/// refused rows_in_two_spaces: ranges and entries lie in one space
const RowArrays<Ranges, PinnedEntries> rows_in_two_spaces;
/// refused a_set_of_no_arrays: an ArraySet has at least one array
const ArraySet<> a_set_of_no_arrays;
/// refused more_names_than_an_input_has: no array has more than 32 fields named one by one
const auto more_names_than_an_input_has = named(std::make_index_sequence<33>());

/// refused at once brackets_on_an_array: an_array_is_indexed_by_its_view_so_write_array_view_of_i
void brackets_on_an_array(Entries& entries) { entries[3].local() = 1; }
/// refused at once a_loop_over_an_array: an_array_is_indexed_by_its_view_so_write_array_view_of_i
void a_loop_over_an_array(const Entries& entries) {
  for (const auto& entry : entries) (void)entry;
}

// ---- What is not refused ----
const RowArrays<Ranges, Entries> accepted_rows;
const auto accepted_names = named(std::make_index_sequence<32>());
