// Checks and changes of rows without the types of their arrays.
#include <physgen/error.h>
#include <physgen/row_arrays.h>

#include <limits>

#include "index_field.h"
#include "move_objects.h"

namespace physgen::detail {

namespace {

std::string text(index_t number) { return std::to_string(number); }

[[noreturn]] void refuse(std::string_view entries, const std::string& why) {
  throw Error("rows of " + std::string(entries) + ": " + why);
}

std::string allowed(index_t count, const std::string& what) {
  return count == 0 ? "there are no " + what : "give a number from 0 to " + text(count - 1);
}

}  // namespace

void require_rows(const char* of, index_t rows, index_t row_targets, index_t size, index_t targets) {
  if (rows == size && row_targets == targets) return;
  throw Error(std::string(of) + " has " + text(rows) + " rows of entries that name one of " + text(row_targets) +
              " objects; here there are " + text(size) + " objects with rows and " + text(targets) +
              " to be named. Give the rows that were made for these two sets");
}

std::vector<RowRange> rows_of_lengths(std::string_view entries, std::span<const index_t> lengths) {
  constexpr index_t most = std::numeric_limits<std::int32_t>::max();
  std::vector<RowRange> rows;
  rows.reserve(lengths.size());
  index_t begin = 0;
  for (const index_t length : lengths) {
    if (length > most - begin) {
      refuse(entries, "row " + text(static_cast<index_t>(rows.size())) + " would end at entry " + text(begin + length) +
                          ", and an Index counts to " + text(most) + "; spread the rows over several arrays");
    }
    rows.push_back({static_cast<std::int32_t>(begin), static_cast<std::int32_t>(begin + length)});
    begin += length;
  }
  return rows;
}

std::vector<index_t> lengths_of_pairs(std::string_view entries, index_t rows, std::span<const index_t> row_of_pair) {
  if (rows < 0) refuse(entries, "there cannot be " + text(rows) + " rows");
  std::vector<index_t> lengths(static_cast<std::size_t>(rows), 0);
  for (std::size_t p = 0; p < row_of_pair.size(); ++p) {
    const index_t row = row_of_pair[p];
    if (row < 0 || row >= rows) {
      refuse(entries, "pair " + text(static_cast<index_t>(p)) + " is one of row " + text(row) + ", of " + text(rows) +
                          "; " + allowed(rows, "rows"));
    }
    ++lengths[static_cast<std::size_t>(row)];
  }
  return lengths;
}

std::vector<index_t> lengths_of_offsets(std::string_view entries, std::span<const std::int32_t> offsets,
                                        std::size_t count) {
  const auto at = [&](std::size_t i) { return "offset " + text(static_cast<index_t>(i)) + " is " + text(offsets[i]); };
  if (offsets.empty()) refuse(entries, "there are no offsets; give one more than there are rows, the first being 0");
  if (offsets.front() != 0) refuse(entries, at(0) + "; the first must be 0");
  std::vector<index_t> lengths;
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    if (offsets[i] < offsets[i - 1]) refuse(entries, at(i) + ", less than the one before; they must not descend");
    lengths.push_back(index_t{offsets[i]} - offsets[i - 1]);
  }
  if (std::cmp_not_equal(offsets.back(), count)) {
    refuse(entries, at(offsets.size() - 1) + ", the last; it must be the number of entries, " +
                        text(static_cast<index_t>(count)));
  }
  return lengths;
}

void check_rows(std::span<const RowRange> rows, const UntypedArray& entries, const RowTargets& targets) {
  if (targets.count < 0) refuse(entries.object, "there cannot be " + text(targets.count) + " objects to name");
  const Indices indices(entries, find_index_field(entries, targets.field));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto [begin, end] = rows[i];
    const std::string row = "row " + text(static_cast<index_t>(i));
    if (begin < 0 || begin > end || end > entries.size) {
      refuse(entries.object, row + " has begin " + text(begin) + " and end " + text(end) + ", of " +
                                 text(entries.size) + " entries; give 0 <= begin <= end <= " + text(entries.size));
    }
    for (index_t k = begin; k < end; ++k) {
      for (int e = 0; e < indices.count; ++e) {
        const std::int32_t index = indices(k, e);
        if (index >= 0 && index < targets.count) continue;
        refuse(entries.object, "entry " + text(k - begin) + " of " + row + " has " + targets.field + " = " +
                                   text(index) + ", of " + text(targets.count) + " objects; " +
                                   allowed(targets.count, "objects"));
      }
    }
  }
}

void check_new_targets(const UntypedArray& entries, const RowTargets& targets, std::span<const index_t> new_number,
                       index_t count) {
  if (std::cmp_not_equal(new_number.size(), targets.count)) {
    refuse(entries.object, text(static_cast<index_t>(new_number.size())) + " new numbers are given, and entries name " +
                               text(targets.count) + " objects; give one for each, -1 where it is gone");
  }
  for (std::size_t v = 0; v < new_number.size(); ++v) {
    if (new_number[v] >= -1 && new_number[v] < count) continue;
    refuse(entries.object, "the new number of object " + text(static_cast<index_t>(v)) + " is " + text(new_number[v]) +
                               ", of " + text(count) + " objects; " + allowed(count, "objects") +
                               ", or -1 where it is gone");
  }
}

ChosenRows choose_rows(std::span<const RowRange> rows, const UntypedArray& entries, const std::string& field,
                       std::span<const index_t> order, std::optional<std::span<const index_t>> new_number) {
  std::optional<Indices> indices;
  if (new_number) indices.emplace(entries, find_index_field(entries, field));
  const auto stays = [&](index_t k) {
    for (int e = 0; indices && e < indices->count; ++e) {
      const std::int32_t index = (*indices)(k, e);  // kernels may have written it
      if (index < 0 || std::cmp_greater_equal(index, new_number->size())) {
        refuse(entries.object,
               "entry " + text(k) + " has " + field + " = " + text(index) + ", of " +
                   text(static_cast<index_t>(new_number->size())) +
                   " objects, and so no new number; write numbers of existing objects, and check() them");
      }
      if ((*new_number)[static_cast<std::size_t>(index)] < 0) return false;
    }
    return true;
  };
  ChosenRows chosen;
  std::vector<index_t> lengths;
  for (const index_t old : order) {
    const std::size_t before = chosen.entries.size();
    const RowRange row = old < 0 ? RowRange{0, 0} : rows[static_cast<std::size_t>(old)];
    for (index_t k = row.begin; k < row.end; ++k) {
      if (stays(k)) chosen.entries.push_back(k);
    }
    lengths.push_back(static_cast<index_t>(chosen.entries.size() - before));
  }
  chosen.rows = rows_of_lengths(entries.object, lengths);
  return chosen;
}

}  // namespace physgen::detail
