// Checks and changes of rows without the types of their arrays.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/memory/host_list.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace physgen {
struct RowTargets;  // row_arrays.h
}

namespace physgen::detail {

struct RowFill;  // row_fill.h

/// A row: the entries begin .. end-1.
struct RowRange {
  std::int32_t begin, end;
};

/// Rows that follow each other. @throw Error when a length is negative or there are more entries than an Index can name
[[nodiscard]] HostList<RowRange> rows_of_lengths(std::string_view entries, std::span<const index_t> lengths);

/// @throw Error when offsets do not begin with 0, ascend, and end with the number of entries
[[nodiscard]] HostList<RowRange> rows_of_offsets(std::string_view entries, std::span<const std::int32_t> offsets,
                                                 std::size_t count);

/// @pre `entries` are host records in Aos
/// @throw Error when a row is not a range of the entries, or an entry of a row does not name a target
void check_rows(std::span<const RowRange> rows, const UntypedArray& entries, const RowTargets& targets);

/// @throw Error when new numbers are not given for each target, or one exceeds the new count
void check_new_targets(const UntypedArray& entries, const RowTargets& targets, std::span<const index_t> new_number,
                       index_t count);

/// Rows made of old entries, or of pairs, and which of these each of theirs is.
struct ChosenRows {
  HostList<RowRange> rows;
  HostList<index_t> entries;
};

/// Rows of the pairs, in their order, given the first members of all. @throw Error when one names no row
[[nodiscard]] ChosenRows rows_of_pairs(std::string_view entries, index_t rows, std::span<const index_t> row_of_pair);

/// Row i becomes the old row order[i] (-1: one without entries), less the entries that name a target without a new
/// number. @param new_number of the targets; empty optional: they all keep theirs
[[nodiscard]] ChosenRows choose_rows(std::span<const RowRange> rows, const UntypedArray& entries,
                                     const std::string& field, std::span<const index_t> order,
                                     std::optional<std::span<const index_t>> new_number);

}  // namespace physgen::detail
