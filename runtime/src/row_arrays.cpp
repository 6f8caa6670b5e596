// Checks and changes of rows without the types of their arrays.
#include <physgen/error.h>
#include <physgen/fill_rows.h>
#include <physgen/row_arrays.h>

#include <limits>

#include "first_where.h"
#include "index_field.h"
#include "move_objects.h"

namespace physgen::detail {

namespace {

std::string text(index_t number) { return std::to_string(number); }
std::size_t at(index_t i) { return static_cast<std::size_t>(i); }

[[noreturn]] void refuse(std::string_view entries, const std::string& why) {
  throw Error("rows of " + std::string(entries) + ": " + why);
}

std::string allowed(index_t count, const std::string& what) {
  return count == 0 ? "there are no " + what : "give a number from 0 to " + text(count - 1);
}

HostList<RowRange> ranges_of(std::span<const std::int32_t> first) {
  HostList<RowRange> rows(first.size() - 1);
  for_each_index(0, static_cast<index_t>(rows.size()),
                 [&](index_t i) { rows[at(i)] = {first[at(i)], first[at(i + 1)]}; });
  return rows;
}

}  // namespace

void require_rows(const char* of, index_t rows, index_t row_targets, index_t size, index_t targets) {
  if (rows == size && row_targets == targets) return;
  throw Error(std::string(of) + " has " + text(rows) + " rows of entries that name one of " + text(row_targets) +
              " objects; here there are " + text(size) + " objects with rows and " + text(targets) +
              " to be named. Give the rows that were made for these two sets");
}

HostList<RowRange> rows_of_lengths(std::string_view entries, std::span<const index_t> lengths) {
  constexpr index_t most = std::numeric_limits<std::int32_t>::max();
  const auto size = static_cast<index_t>(lengths.size());
  HostList<index_t> ends(lengths.size());
  for_each_index(0, size, [&](index_t i) { ends[at(i)] = lengths[at(i)]; });
  scan<true>(std::span(ends));
  const index_t wrong = first_where(size, [&](index_t i) { return ends[at(i)] > most; });
  if (wrong < size) {
    refuse(entries, "row " + text(wrong) + " would end at entry " + text(ends[at(wrong)]) +
                        ", and an Index counts to " + text(most) + "; spread the rows over several arrays");
  }
  HostList<RowRange> rows(lengths.size());
  for_each_index(0, size, [&](index_t i) {
    rows[at(i)] = {static_cast<std::int32_t>(ends[at(i)] - lengths[at(i)]), static_cast<std::int32_t>(ends[at(i)])};
  });
  return rows;
}

ChosenRows rows_of_pairs(std::string_view entries, index_t rows, std::span<const index_t> row_of_pair) {
  if (rows < 0) refuse(entries, "there cannot be " + text(rows) + " rows");
  const auto pairs = static_cast<index_t>(row_of_pair.size());
  const index_t wrong =
      first_where(pairs, [&](index_t p) { return row_of_pair[at(p)] < 0 || row_of_pair[at(p)] >= rows; });
  if (wrong < pairs) {
    refuse(entries, "pair " + text(wrong) + " is one of row " + text(row_of_pair[at(wrong)]) + ", of " + text(rows) +
                        "; " + allowed(rows, "rows"));
  }
  ChosenRows chosen;
  HostList<std::int32_t> first;
  fill_rows(
      Host{}, rows, pairs, [&](index_t p, const auto& put) { put(row_of_pair[at(p)], p); }, first, chosen.entries);
  chosen.rows = ranges_of(first);
  return chosen;
}

HostList<RowRange> rows_of_offsets(std::string_view entries, std::span<const std::int32_t> offsets, std::size_t count) {
  const auto is = [&](index_t i) { return "offset " + text(i) + " is " + text(offsets[at(i)]); };
  if (offsets.empty()) refuse(entries, "there are no offsets; give one more than there are rows, the first being 0");
  if (offsets.front() != 0) refuse(entries, is(0) + "; the first must be 0");
  const auto rows = static_cast<index_t>(offsets.size()) - 1;
  const index_t wrong = first_where(rows, [&](index_t i) { return offsets[at(i + 1)] < offsets[at(i)]; });
  if (wrong < rows) refuse(entries, is(wrong + 1) + ", less than the one before; they must not descend");
  if (std::cmp_not_equal(offsets.back(), count)) {
    refuse(entries, is(rows) + ", the last; it must be the number of entries, " + text(static_cast<index_t>(count)));
  }
  return ranges_of(offsets);
}

void check_rows(std::span<const RowRange> rows, const UntypedArray& entries, const RowTargets& targets) {
  if (targets.count < 0) refuse(entries.object, "there cannot be " + text(targets.count) + " objects to name");
  const Indices indices(entries, find_index_field(entries, targets.field));
  const auto is_range = [&](RowRange row) { return row.begin >= 0 && row.begin <= row.end && row.end <= entries.size; };
  const auto is_number = [&](std::int32_t index) { return index >= 0 && index < targets.count; };
  const auto size = static_cast<index_t>(rows.size());
  const index_t wrong = first_where(size, [&](index_t i) {
    const RowRange row = rows[at(i)];
    bool right = is_range(row);
    for (index_t k = row.begin; right && k < row.end; ++k) {
      for (int e = 0; e < indices.count; ++e) right = right && is_number(indices(k, e));
    }
    return !right;
  });
  if (wrong == size) return;
  const auto [begin, end] = rows[at(wrong)];
  const std::string row = "row " + text(wrong);
  if (!is_range({begin, end})) {
    refuse(entries.object, row + " has begin " + text(begin) + " and end " + text(end) + ", of " + text(entries.size) +
                               " entries; give 0 <= begin <= end <= " + text(entries.size));
  }
  for (index_t k = begin; k < end; ++k) {
    for (int e = 0; e < indices.count; ++e) {
      const std::int32_t index = indices(k, e);
      if (is_number(index)) continue;
      refuse(entries.object, "entry " + text(k - begin) + " of " + row + " has " + targets.field + " = " + text(index) +
                                 ", of " + text(targets.count) + " objects; " + allowed(targets.count, "objects"));
    }
  }
}

void check_new_targets(const UntypedArray& entries, const RowTargets& targets, std::span<const index_t> new_number,
                       index_t count) {
  if (std::cmp_not_equal(new_number.size(), targets.count)) {
    refuse(entries.object, text(static_cast<index_t>(new_number.size())) + " new numbers are given, and entries name " +
                               text(targets.count) + " objects; give one for each, -1 where it is gone");
  }
  const index_t wrong =
      first_where(targets.count, [&](index_t v) { return new_number[at(v)] < -1 || new_number[at(v)] >= count; });
  if (wrong == targets.count) return;
  refuse(entries.object, "the new number of object " + text(wrong) + " is " + text(new_number[at(wrong)]) + ", of " +
                             text(count) + " objects; " + allowed(count, "objects") + ", or -1 where it is gone");
}

ChosenRows choose_rows(std::span<const RowRange> rows, const UntypedArray& entries, const std::string& field,
                       std::span<const index_t> order, std::optional<std::span<const index_t>> new_number) {
  std::optional<Indices> indices;
  if (new_number) indices.emplace(entries, find_index_field(entries, field));
  const auto exists = [&](std::int32_t index) { return index >= 0 && std::cmp_less(index, new_number->size()); };
  const auto all_of = [&](index_t k, const auto& holds) {
    for (int e = 0; indices && e < indices->count; ++e) {
      if (!holds((*indices)(k, e))) return false;
    }
    return true;
  };
  const auto stays = [&](index_t k) {
    return all_of(k, [&](std::int32_t index) { return (*new_number)[at(index)] >= 0; });
  };
  const auto old_row = [&](index_t i) { return order[at(i)] < 0 ? RowRange{0, 0} : rows[at(order[at(i)])]; };
  const auto size = static_cast<index_t>(order.size());
  HostList<index_t> lengths(order.size());
  const index_t wrong = first_where(size, [&](index_t i) {
    const RowRange row = old_row(i);
    lengths[at(i)] = 0;
    for (index_t k = row.begin; k < row.end; ++k) {
      if (!all_of(k, exists)) return true;  // kernels may have written it
      lengths[at(i)] += stays(k) ? 1 : 0;
    }
    return false;
  });
  if (wrong < size) {
    index_t k = old_row(wrong).begin;
    while (all_of(k, exists)) ++k;
    (void)all_of(k, [&](std::int32_t index) {
      if (exists(index)) return true;
      refuse(entries.object, "entry " + text(k) + " has " + field + " = " + text(index) + ", of " +
                                 text(static_cast<index_t>(new_number->size())) +
                                 " objects, and so no new number; write numbers of existing objects, and check() them");
    });
  }
  ChosenRows chosen{rows_of_lengths(entries.object, lengths), {}};
  chosen.entries.resize(size == 0 ? 0 : at(chosen.rows.back().end));
  for_each_index<8>(0, size, [&](index_t i) {
    const RowRange row = old_row(i);
    const bool whole = lengths[at(i)] == row.end - row.begin;
    index_t next = chosen.rows[at(i)].begin;
    for (index_t k = row.begin; k < row.end; ++k) {
      if (whole || stays(k)) chosen.entries[at(next++)] = k;
    }
  });
  return chosen;
}

}  // namespace physgen::detail
