// Sets of arrays and arrays of scenes that a compiler must refuse, with words that say what is wrong. refused.py
// compares them with what it reports.
#include <dynamics.physgen.h>
#include <elasticity.physgen.h>
#include <physgen/cell_list.h>
#include <physgen/channel.h>
#include <physgen/gather.h>
#include <physgen/random.h>
#include <physgen/row_arrays.h>
#include <physgen/scene.h>
#include <physgen/topology.h>
#include <quasistatic.physgen.h>

#include <array>
#include <utility>
#include <vector>

using namespace physgen;

namespace {

using Range = elasticity::IncidenceRange<float>;
using Ranges = elasticity::IncidenceRangeArray<float>;
using Entries = elasticity::IncidenceArray<float>;
using PinnedEntries = elasticity::IncidenceArray<float, PinnedHost>;
using PinnedNeighbours =
    RowArrays<elasticity::IncidenceRangeArray<float, PinnedHost>, quasistatic::TetPatchArray<float, PinnedHost>>;

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
/// refused a_copy_to_a_const_array: copy(to, from): the array that is written comes first, and this one is const
void a_copy_to_a_const_array(const Ranges& from, Ranges& to) { copy(from, to); }
/// refused a_copy_to_a_read_only_view: copy(to, from): what is written comes first, and it is an array, not a view
void a_copy_to_a_read_only_view(const Ranges& from, Ranges& to) { copy(from.const_view(), to); }
/// refused objects_appended_to_a_const_array: append(array, other): the array that grows comes first
void objects_appended_to_a_const_array(const Ranges& from, Ranges& to) { append(from, to); }
/// refused gathering_to_pointers: gather(array, pointers, to_value): the array, which is written, comes first
void gathering_to_pointers(const std::vector<Range*>& from, Ranges& to) {
  gather(from, to, [](const Range& range) { return range; });
}
/// refused scattering_to_an_array: scatter(pointers, array, from_value): the pointers to what is written come first
void scattering_to_an_array(const Ranges& from, const std::vector<Range*>& to) {
  scatter(from, to, [](Range& range, const Range& value) { range = value; });
}

/// refused brackets_on_an_array_of_the_device: an array in Cuda memory is not reached on the host: copy it to an array
void brackets_on_an_array_of_the_device(elasticity::IncidenceArray<float, Cuda>& entries) { entries[3].local() = 1; }
/// refused a_loop_over_an_array_of_the_device: an array in Cuda memory is not reached on the host: copy it to an array
void a_loop_over_an_array_of_the_device(const elasticity::IncidenceArray<float, Cuda>& entries) {
  for (const auto& entry : entries) (void)entry;
}
/// refused an_object_added_on_the_device: an array in Cuda memory is not reached on the host: copy it to an array
void an_object_added_on_the_device(elasticity::EdgeArray<float, Cuda>& edges) { edges.push_back({}); }

template <class Layout, class Space = Host, class Formats = FormatsOf<elasticity::NodePositionObject, Space>>
using Nodes = elasticity::NodePositionArray<float, Space, Layout, Formats>;
struct HalfNodes : elasticity::NodePositionFormats<Host> {
  using x = format::Half<>;
};
/// refused a_channel_of_tiles: channel(): only the layout Soa keeps an element of all objects side by side
void a_channel_of_tiles(Nodes<Aosoa<16>>& nodes) { (void)channel<"x">(nodes); }
/// refused a_channel_of_the_device: channel(): an array in Cuda memory is not reached on the host
void a_channel_of_the_device(Nodes<Soa, Cuda>& nodes) { (void)channel<"x">(nodes); }
/// refused a_channel_of_no_field: channel(): the objects have no field of this name
void a_channel_of_no_field(Nodes<Soa>& nodes) { (void)channel<"y">(nodes); }
/// refused a_channel_of_halves: channel(): this field is not stored as plain numbers
void a_channel_of_halves(Nodes<Soa, Host, HalfNodes>& nodes) { (void)channel<"x">(nodes); }

/// refused a_random_long_double: random numbers are float or double
void a_random_long_double(RandomNumbers& random) { (void)random.uniform<long double>(); }

// ---- What is not refused ----
void accepted_order(const Ranges& from, Ranges& to, const std::vector<Range*>& pointers) {
  copy(to, from);
  copy(to, from.const_view());
  copy(to, to.const_view());
  append(to, from);
  gather(to, pointers, [](const Range& range) { return range; });
  scatter(pointers, from, [](Range& range, const Range& value) { range = value; });
}
const RowArrays<Ranges, Entries> accepted_rows;
const auto accepted_names = named(std::make_index_sequence<32>());

/// refused a_list_of_floats_of_positions_in_double: positions in double lose digits in a CellList<float>
void a_list_of_floats_of_positions_in_double(CellList<float>& cells, const std::vector<std::array<double, 3>>& x) {
  cells.build(Host{}, 8, [&](index_t i) { return x[static_cast<std::size_t>(i)]; });
}
/// refused neighbours_of_two_fields: the entries of neighbours have one field, an Index
void neighbours_of_two_fields(CellList<float>& cells, RowArrays<Ranges, Entries>& rows) { cells.find_neighbours(rows); }
/// refused neighbours_of_a_float: the field of an entry that names an object is an Index
void neighbours_of_a_float(CellList<float>& cells, RowArrays<Ranges, dynamics::NodeMassArray<float>>& rows) {
  cells.find_neighbours(rows);
}
/// refused a_list_of_a_device_without_its_header: a CellList in Cuda memory is that of <physgen/cuda/cell_list.h>
void a_list_of_a_device_without_its_header() { (void)CellList<float, 3, Cuda>({.lower = {}, .upper = {1, 1, 1}}, 1); }
/// refused neighbours_in_pinned_memory: rows are made in place in the memory of the list: Host, or Cuda
void neighbours_in_pinned_memory(CellList<float>& cells, PinnedNeighbours& rows) { cells.find_neighbours(rows); }
