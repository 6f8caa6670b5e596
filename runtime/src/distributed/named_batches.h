// Loops over what objects name, a piece after the other, on several threads.
#pragma once

#include <physgen/detail/host_loop.h>
#include <physgen/distributed/halo_plan.h>
#include <physgen/distributed/named_objects.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace physgen::detail {

/// The groups of some objects, or of each what there is.
inline std::vector<ObjectPiece> pieces_of(const ObjectRuns& objects) {
  std::vector<ObjectPiece> pieces;
  index_t place = 0;
  for (const ObjectRuns::Run& run : objects.runs) {
    const index_t end = run.first + run.count;
    for (index_t first = run.first, last = 0; first < end; place += last - first, first = last) {
      last = std::min(end, (first / ObjectPiece::group + 1) * ObjectPiece::group);
      pieces.push_back({first, last, place});
    }
  }
  return pieces;
}

/// A piece of a loop, and what its objects name.
struct NamedBatch {
  std::size_t number;  ///< of the piece
  ObjectPiece piece;
  std::vector<NamedNumbers> numbers;  ///< by each of the functions

  [[nodiscard]] index_t object(std::size_t k) const { return piece.first + static_cast<index_t>(k); }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(piece.size()); }
};

/// Calls use(batch) for each piece of which is_left_out(number) does not tell that it need not be asked.
/// @throw what calls throw
template <class IsLeftOut, class Use>
void each_named(const std::vector<const NamedObjects*>& named, const std::vector<ObjectPiece>& pieces,
                const IsLeftOut& is_left_out, const Use& use) {
  RegionFailure failure;
  for_parts<static_cast<int>(ObjectPiece::group)>(static_cast<index_t>(pieces.size()), [&](index_t begin, index_t end) {
    failure.guard([&] {
      NamedBatch batch{static_cast<std::size_t>(begin), {}, std::vector<NamedNumbers>(named.size())};
      for (; batch.number < static_cast<std::size_t>(end); ++batch.number) {
        if (is_left_out(batch.number)) continue;
        batch.piece = pieces[batch.number];
        for (std::size_t n = 0; n < named.size(); ++n) {
          batch.numbers[n].clear();
          (*named[n])(batch.piece, batch.numbers[n]);
        }
        use(static_cast<const NamedBatch&>(batch));
      }
    });
  });
  failure.rethrow();
}

/// Ascending, each once.
inline void sort_once(std::vector<index_t>& numbers) {
  std::ranges::sort(numbers);
  const auto repeated = std::ranges::unique(numbers);
  numbers.erase(repeated.begin(), repeated.end());
}

}  // namespace physgen::detail
