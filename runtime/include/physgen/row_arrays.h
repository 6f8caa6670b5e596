// Rows in arrays of their own: made from lists, pairs or offsets, checked, and changed along with the two sets that
// they connect. Kernels take their view(), a Rows.
#pragma once

#include <physgen/detail/launch.h>
#include <physgen/detail/row_ranges.h>
#include <physgen/memory/host_list.h>
#include <physgen/rows.h>
#include <physgen/topology.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace physgen {

/// The objects that entries of rows name.
struct RowTargets {
  std::string field;  ///< of the entries, which holds the numbers: "element", or "pair.node" of a nested object
  index_t count;      ///< objects of the set: numbers are 0 .. count-1
};

namespace detail {
struct RowFill;
}

/// A row of entries for each object of one set; the entries name objects of another set, or of the same one. Every
/// number has been checked against the size of the set that it indexes. Rows lie one behind the other, in order.
///
/// When one of the two sets changes (topology.h), its rows follow by the function of the same name, with the same
/// numbers: permute(), compact(), erase() and append() for the objects that have the rows, renumber() for the objects
/// that entries name. Where both are one set, call both. All of these work on the host, whatever the space: arrays are
/// copied there and back, on CUDA in the default stream, and the call returns when that is done. When one throws, the
/// rows are as they were. All views end.
/// @tparam Ranges_ array of a generated type with two fields `Index begin, end`, such as elasticity::IncidenceRange
/// @tparam Entries_ array of any generated type, in the same space
template <class Ranges_, class Entries_>
class RowArrays {
 public:
  using Ranges = Ranges_;
  using Entries = Entries_;
  using Space = typename Entries::View::Space;
  static_assert(std::is_same_v<Space, typename Ranges::View::Space>, "ranges and entries lie in one space");
  /// One entry.
  using Value = typename Entries::Value;
  using View = Rows<typename Ranges::ConstView, typename Entries::View>;
  using ConstView = Rows<typename Ranges::ConstView, typename Entries::ConstView>;

  /// No rows, of entries that name nothing.
  RowArrays() = default;

  /// Takes over arrays that were filled elsewhere, such as on the device. Rows may leave out entries, and share some.
  /// @throw Error naming row, entry and number when a row is not a range of the entries, or an entry names no target
  RowArrays(RowTargets targets, Ranges ranges, Entries entries)
      : targets_(std::move(targets)), ranges_(std::move(ranges)), entries_(std::move(entries)) {
    check();
  }
  /// The same rows in other layouts, precisions or another space.
  template <class OtherRanges, class OtherEntries>
    requires(!std::is_same_v<RowArrays<OtherRanges, OtherEntries>, RowArrays>)
  explicit RowArrays(const RowArrays<OtherRanges, OtherEntries>& other)
      : targets_(other.targets()), ranges_(other.ranges().size()), entries_(other.entries().size()) {
    copy(ranges_, other.ranges());
    copy(entries_, other.entries());
    synchronize();
  }

  /// Row i has the entries lists[i].
  /// @throw Error when an entry names no target, or there are more than 2^31 - 1
  [[nodiscard]] static RowArrays from_lists(RowTargets targets, std::span<const std::vector<Value>> lists) {
    const auto size = static_cast<index_t>(lists.size());
    HostList<index_t> lengths(lists.size());
    detail::for_each_index(0, size, [&](index_t i) { lengths[at(i)] = static_cast<index_t>(lists[at(i)].size()); });
    const HostList<detail::RowRange> rows = detail::rows_of_lengths(name, lengths);
    return made(std::move(targets), rows, [&](const auto& entries) {
      detail::for_each_index(0, size, [&](index_t i) {
        index_t k = rows[at(i)].begin;
        for (const Value& entry : lists[at(i)]) entries.put(k++, entry);
      });
    });
  }

  /// Row i has the entries of the pairs (i, entry), in their order.
  /// @throw Error when a pair names none of the rows 0 .. rows-1, an entry no target, or there are more than 2^31 - 1
  [[nodiscard]] static RowArrays from_pairs(RowTargets targets, index_t rows,
                                            std::span<const std::pair<index_t, Value>> pairs) {
    HostList<index_t> row_of_pair(pairs.size());
    detail::for_each_index(0, static_cast<index_t>(pairs.size()),
                           [&](index_t p) { row_of_pair[at(p)] = pairs[at(p)].first; });
    const detail::ChosenRows chosen = detail::rows_of_pairs(name, rows, row_of_pair);
    return made(std::move(targets), chosen.rows, [&](const auto& entries) {
      detail::for_each_index(0, entries.size(),
                             [&](index_t k) { entries.put(k, pairs[at(chosen.entries[at(k)])].second); });
    });
  }

  /// Row i has the entries first[i] up to, not including, first[i + 1].
  /// @throw Error when `first` does not begin with 0, descends, or does not end with the number of entries; or an entry
  /// names no target
  [[nodiscard]] static RowArrays from_offsets(RowTargets targets, std::span<const std::int32_t> first,
                                              std::span<const Value> entries) {
    return made(std::move(targets), detail::rows_of_offsets(name, first, entries.size()), [&](const auto& host) {
      detail::for_each_index(0, host.size(), [&](index_t k) { host.put(k, entries[at(k)]); });
    });
  }

  /// Rows.
  [[nodiscard]] index_t size() const { return ranges_.size(); }
  [[nodiscard]] const RowTargets& targets() const { return targets_; }
  [[nodiscard]] const Ranges& ranges() const { return ranges_; }
  [[nodiscard]] const Entries& entries() const { return entries_; }
  /// The view that kernels are given; they may write the entries' fields. See check().
  [[nodiscard]] View view() { return {ranges_.const_view(), entries_.view(), targets_.count}; }
  [[nodiscard]] ConstView view() const { return const_view(); }
  [[nodiscard]] ConstView const_view() const { return {ranges_.const_view(), entries_.const_view(), targets_.count}; }

  /// Checks all rows again, after a kernel has written entries.
  /// @throw Error naming row, entry and number when a row is not a range of the entries, or an entry names no target
  void check() const { detail::check_rows(rows_on_host(), on_host(entries_).untyped(), targets_); }

  /// Row i becomes the old row order[i]. @throw Error when `order` does not name each row once
  void permute(std::span<const index_t> order) {
    check_permutation(order, size(), title());
    choose(order, {}, targets_.count);
  }
  /// Keeps the listed rows, in this order. @throw Error when `kept` is not ascending
  void compact(std::span<const index_t> kept) {
    check_ascending(kept, size(), title());
    choose(kept, {}, targets_.count);
  }
  /// Removes the listed rows. @throw Error when a number is out of range or listed twice
  void erase(std::span<const index_t> erased) { choose(remaining(size(), erased, title()), {}, targets_.count); }
  /// Adds rows without entries at the end. @throw Error when count is negative
  void append(index_t count) {
    const index_t old = size();
    choose(
        made_of(detail::grown_size(std::array{ranges_.untyped()}, count), [=](index_t i) { return i < old ? i : -1; }),
        {}, targets_.count);
  }

  /// After a change of the set that entries name: target v has become new_number[v], of `count`. Entries of a target
  /// that is gone (-1) are dropped, the others keep their order. See inverse() and new_numbers().
  /// @throw Error when there is not a number for each target, one is not below `count`, or an entry names no target, as
  /// a kernel may have written it
  void renumber(std::span<const index_t> new_number, index_t count) {
    detail::check_new_targets(entries_.untyped(), targets_, new_number, count);
    choose(made_of(size(), [](index_t i) { return i; }), new_number, count);
  }

 private:
  friend detail::RowFill;  // makes rows anew in place

  template <class Given>
  using HostForm = Array<typename Given::Object, typename Given::Precision, Host, Aos, typename Given::Formats>;
  using HostRanges = HostForm<Ranges>;
  using HostEntries = HostForm<Entries>;
  static constexpr std::string_view name = Entries::Object::name;

  [[nodiscard]] static std::size_t at(index_t i) { return static_cast<std::size_t>(i); }
  template <class Number>
  [[nodiscard]] static HostList<index_t> made_of(index_t count, const Number& number) {
    HostList<index_t> list(at(count));
    detail::for_each_index(0, count, [&](index_t i) { list[at(i)] = number(i); });
    return list;
  }

  [[nodiscard]] static std::string title() { return "rows of " + std::string(name); }

  template <class Given>
  [[nodiscard]] static HostForm<Given> on_host(const Given& array) {
    HostForm<Given> host(array.size());
    if constexpr (device_accessible(Space::kind)) synchronize();  // work that was ordered before may still write it
    copy(host, array);
    if constexpr (device_accessible(Space::kind)) synchronize();
    return host;
  }
  [[nodiscard]] HostList<detail::RowRange> rows_on_host() const {
    const HostRanges host = on_host(ranges_);
    HostList<detail::RowRange> rows(at(host.size()));
    detail::for_each_index(0, host.size(),
                           [&, view = host.view()](index_t i) { rows[at(i)] = {view[i].begin(), view[i].end()}; });
    return rows;
  }
  template <class To>
  [[nodiscard]] static To uploaded(const HostForm<To>& from) {
    To to(from.size());
    copy(to, from);
    synchronize();
    return to;
  }
  void replace(std::span<const detail::RowRange> rows, const HostEntries& host_entries) {
    HostRanges host(static_cast<index_t>(rows.size()));
    detail::for_each_index(0, host.size(), [&, view = host.view()](index_t i) {
      view[i].begin() = rows[at(i)].begin;
      view[i].end() = rows[at(i)].end;
    });
    Ranges ranges = uploaded<Ranges>(host);
    Entries entries = uploaded<Entries>(host_entries);
    ranges_.swap(ranges);
    entries_.swap(entries);
  }

  template <class Fill>
  [[nodiscard]] static RowArrays made(RowTargets targets, const HostList<detail::RowRange>& rows, const Fill& fill) {
    HostEntries entries(rows.empty() ? 0 : rows.back().end);
    fill(entries.view());
    detail::check_rows(rows, entries.untyped(), targets);
    RowArrays result;
    result.targets_ = std::move(targets);
    result.replace(rows, entries);
    return result;
  }

  void choose(std::span<const index_t> order, std::optional<std::span<const index_t>> new_number, index_t targets) {
    const HostEntries old = on_host(entries_);
    const detail::ChosenRows chosen =
        detail::choose_rows(rows_on_host(), old.untyped(), targets_.field, order, new_number);
    HostEntries entries(static_cast<index_t>(chosen.entries.size()));
    const detail::Numbers picked(chosen.entries, {});
    detail::pick(entries.untyped(), 0, old.untyped(), &picked);
    if (new_number) physgen::renumber(entries.untyped(), targets_.field, *new_number);
    replace(chosen.rows, entries);
    targets_.count = targets;
  }

  RowTargets targets_{{}, 0};
  Ranges ranges_;
  Entries entries_;
};

}  // namespace physgen
