// The values of a rank's blocks in a reduction, and the value of all ranks' blocks: joined in the order of one process
// (launch/reduce.h), whatever the number of ranks.
#pragma once

#include <physgen/detail/host_blocks.h>
#include <physgen/distributed/gather_blocks.h>
#include <physgen/distributed/local_set.h>

#include <cstddef>
#include <vector>

namespace physgen::detail {

/// Of one reduction after another.
class BlockValues {
 public:
  /// Begins a reduction over the objects that a rank owns.
  /// @param set outlives the reduction
  template <class Types>
  void begin(const LocalSet& set) {
    set_ = &set;
    blocks_ = blocks_of(set.runs().begin(set.rank()), set.runs().end(set.rank()));
    bytes_.resize(static_cast<std::size_t>(blocks_ * Types::count) * sizeof(typename Types::Value));
  }

  /// Calls the kernel for the local objects begin .. end-1 of those that are owned: whole blocks, or up to the last.
  /// @param shift the kernel is called with an object's number less this, which is a multiple of a block
  template <class Fold, class Kernel>
  void add(index_t begin, index_t end, index_t shift, const Kernel& kernel) {
    const index_t block = (begin - set_->begin()) / reduce_block;
    const index_t first = set_->runs().begin(set_->rank()) + begin - set_->begin();
    using Value = typename HostReduction<Kernel, Fold>::Value;
    reduce_blocks<Fold>(begin - shift, end - shift, kernel, reinterpret_cast<Value*>(bytes_.data()) + block, blocks_,
                        first);
  }
  /// Calls the kernel for objects whose terms do not count.
  template <class Fold, class Kernel>
  static void drop(index_t begin, index_t end, index_t shift, const Kernel& kernel) {
    using Types = HostReduction<Kernel, Fold>;
    if (begin >= end) return;
    const index_t blocks = blocks_of(begin - shift, end - shift);
    std::vector<std::byte> values(static_cast<std::size_t>(blocks * Types::count) * sizeof(typename Types::Value));
    reduce_blocks<Fold>(begin - shift, end - shift, kernel, reinterpret_cast<typename Types::Value*>(values.data()),
                        blocks, begin - shift);
  }

  /// The value of all ranks' objects, which every rank gets.
  template <class Fold, class Kernel>
  [[nodiscard]] auto of_all_ranks(Transport& transport) const {
    using Types = HostReduction<Kernel, Fold>;
    using Value = typename Types::Value;
    const std::vector<std::byte> ordered = gather_blocks(transport, set_->runs(), bytes_, Types::count, sizeof(Value));
    return join_entries<Fold, Types>(reinterpret_cast<const Value*>(ordered.data()), blocks_of(0, set_->runs().size()));
  }

 private:
  const LocalSet* set_ = nullptr;
  index_t blocks_ = 0;  ///< of this rank
  std::vector<std::byte> bytes_;
};

}  // namespace physgen::detail
