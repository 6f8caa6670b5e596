// Lists of what belongs to each object of a set, made on several threads, one behind the other: from items that name
// the objects they belong to, or object by object. No entry depends on the number of threads.
#pragma once

#include <physgen/detail/host_loop.h>
#include <physgen/detail/row_lists.h>
#include <physgen/memory/host_list.h>
#include <physgen/memory/space.h>
#include <physgen/scan.h>
#include <physgen/threads.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace physgen {

/// Row r has the entries that items put there, ascending: entries[first[r]] up to, not including, entries[first[r +
/// 1]].
/// @param rows how many there are; `first` has one more
/// @param visit called as visit(i, put) for the items 0 .. items-1, twice each and in any order; calls put(r, entry)
/// for its entries, the same both times, and throws nothing
/// @tparam Entry trivial, with an operator< that tells all entries of a row apart, or only equal ones from others
/// @throw Error when there are more than 2^31 - 1 entries, before memory is allocated for them
template <class Entry, class Visit>
void fill_rows(Host /*space*/, index_t rows, index_t items, const Visit& visit, HostList<std::int32_t>& first,
               HostList<Entry>& entries) {
  first.resize(static_cast<std::size_t>(rows) + 1);
  detail::for_each_index(0, rows + 1, [&](index_t r) { first[static_cast<std::size_t>(r)] = 0; });
  if (threads() == 1) {
    detail::fill_rows<false>(items, visit, first, entries);
  } else {
    detail::fill_rows<true>(items, visit, first, entries);
  }
  detail::for_each_index<8>(0, rows, [&](index_t r) {
    detail::sort_row(entries.data() + first[static_cast<std::size_t>(r)],
                     entries.data() + first[static_cast<std::size_t>(r) + 1]);
  });
}

/// Row r has the entries that visit(r, scratch, row) appends to `row`, in that order. What threads append stays beside
/// the list until it is whole: as much memory again for a while.
/// @throw Error when there are more than 2^31 - 1 entries, after all rows were visited
/// @param make_scratch what it returns is handed to visit() as `scratch`, and belongs to one call at a time: room for
/// lists, which then are allocated once for each thread
/// @param visit called once for each row, in any order. @throw what a call throws
template <class Entry, class MakeScratch, class Visit>
void append_rows(Host /*space*/, index_t rows, const MakeScratch& make_scratch, const Visit& visit,
                 HostList<std::int32_t>& first, HostList<Entry>& entries) {
  constexpr index_t block = 512;
  const index_t blocks = (rows + block - 1) / block;
  struct Own {
    decltype(make_scratch()) scratch;
    std::vector<Entry> entries;
  };
  std::vector<HostList<Entry>> of_blocks(static_cast<std::size_t>(blocks));
  first.resize(static_cast<std::size_t>(rows) + 1);
  first.back() = 0;
  detail::Spares<Own> spares;
  detail::RegionFailure failure;
  detail::for_each_index<64 * block>(0, blocks, [&](index_t b) {
    failure.guard([&] {
      spares.lend([&] { return Own{make_scratch(), {}}; },
                  [&](Own& own) {
                    own.entries.clear();
                    const index_t end = std::min(rows, (b + 1) * block);
                    for (index_t r = b * block; r < end; ++r) {
                      const std::size_t before = own.entries.size();
                      visit(r, own.scratch, own.entries);
                      first[static_cast<std::size_t>(r)] = static_cast<std::int32_t>(own.entries.size() - before);
                    }
                    of_blocks[static_cast<std::size_t>(b)].assign(own.entries.begin(), own.entries.end());
                  });
    });
  });
  failure.rethrow();
  entries.resize(static_cast<std::size_t>(exclusive_scan(Host{}, std::span(first))));
  detail::for_each_index<4 * block>(0, blocks, [&](index_t b) {
    HostList<Entry>& of_block = of_blocks[static_cast<std::size_t>(b)];
    std::copy(of_block.begin(), of_block.end(), entries.begin() + first[static_cast<std::size_t>(b * block)]);
    of_block = {};
  });
}

}  // namespace physgen
