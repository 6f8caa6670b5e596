// Loops over what objects name, in batches on several threads.
#pragma once

#include <physgen/detail/host_loop.h>
#include <physgen/distributed/named_objects.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

namespace physgen::detail {

/// Some objects of a loop, and what they name.
struct NamedBatch {
  static constexpr index_t most = 512;  ///< objects
  index_t number;                       ///< of the batch
  index_t first;                        ///< object of the loop
  std::vector<index_t> objects;         ///< by global numbers
  std::vector<NamedNumbers> numbers;    ///< by each of the functions
};

/// Calls use(batch) for batches of the objects global(0) .. global(count-1).
/// @throw what calls throw
template <class Global, class Use>
void each_named(const std::vector<const NamedObjects*>& named, index_t count, const Global& global, const Use& use) {
  constexpr index_t most = NamedBatch::most;
  RegionFailure failure;
  for_parts<most>((count + most - 1) / most, [&](index_t begin, index_t end) {
    failure.guard([&] {
      NamedBatch batch{begin, 0, {}, std::vector<NamedNumbers>(named.size())};
      for (; batch.number < end; ++batch.number) {
        batch.first = batch.number * most;
        batch.objects.clear();
        for (index_t i = batch.first; i < std::min(count, batch.first + most); ++i) batch.objects.push_back(global(i));
        for (std::size_t n = 0; n < named.size(); ++n) {
          batch.numbers[n].clear();
          (*named[n])(batch.objects, batch.numbers[n]);
        }
        use(static_cast<const NamedBatch&>(batch));
      }
    });
  });
  failure.rethrow();
}

/// What batches find, in their order.
template <class Found>
class FoundInBatches {
 public:
  explicit FoundInBatches(index_t count)
      : found_(static_cast<std::size_t>((count + NamedBatch::most - 1) / NamedBatch::most)) {}
  [[nodiscard]] std::vector<Found>& of(const NamedBatch& batch) {
    return found_[static_cast<std::size_t>(batch.number)];
  }
  void append_to(std::vector<Found>& all) const {
    for (const std::vector<Found>& found : found_) all.insert(all.end(), found.begin(), found.end());
  }

 private:
  std::vector<std::vector<Found>> found_;
};

/// Ascending, each once.
inline void sort_once(std::vector<index_t>& numbers) {
  std::ranges::sort(numbers);
  const auto repeated = std::ranges::unique(numbers);
  numbers.erase(repeated.begin(), repeated.end());
}

}  // namespace physgen::detail
