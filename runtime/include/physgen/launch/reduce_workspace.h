// Memory for reductions on a CUDA device, made once and handed to each, so that none of them allocates.
#pragma once

#include <physgen/error.h>
#include <physgen/launch/reduce.h>
#include <physgen/memory/buffer.h>

namespace physgen {

/// Memory in which parallel_reduce(Cuda{}, ...) keeps its parts. Reductions that use one workspace run one after the
/// other, in one stream; those of different streams need a workspace each. It must outlive them, and graphs that hold
/// them.
class ReduceWorkspace {
 public:
  /// @param objects in the longest range that is reduced
  /// @param value_bytes of the largest result: 8 for each sum, count or double; 16 for an argmax
  /// @throw Error when the memory cannot be had
  explicit ReduceWorkspace(index_t objects, index_t value_bytes = 16)
      : parts_(SpaceKind::cuda, bytes_for(objects, value_bytes), "a workspace for reductions"),
        result_(SpaceKind::pinned, value_bytes, "the result of a reduction") {}

  /// @return the device memory that a reduction takes [bytes]: objects / 2048 for each byte of its result, and some
  /// hundred more
  [[nodiscard]] static index_t bytes_for(index_t objects, index_t value_bytes) {
    constexpr index_t limit = std::numeric_limits<index_t>::max() / 64;
    if (objects < 0 || value_bytes < 1 || value_bytes > limit / (objects / detail::reduce_block + 2)) {
      throw Error("a workspace for reductions of " + std::to_string(objects) + " objects to " +
                  std::to_string(value_bytes) + " bytes cannot exist");
    }
    const index_t blocks = objects / detail::reduce_block + 2;  // a range may begin and end inside of blocks
    return counter_bytes + blocks * value_bytes;
  }
  [[nodiscard]] index_t bytes() const { return parts_.bytes(); }

  // For parallel_reduce(): how many thread blocks have finished (0 before and after each reduction), the values of
  // blocks, and host memory that the device writes a result to.
  [[nodiscard]] unsigned* finished() const { return reinterpret_cast<unsigned*>(parts_.data()); }
  [[nodiscard]] std::byte* values() const { return parts_.data() + counter_bytes; }
  [[nodiscard]] std::byte* result() const { return result_.data(); }
  /// @throw Error when a reduction of so many objects to so many bytes needs a larger workspace
  void require(index_t objects, index_t value_bytes) const {
    if (bytes() >= bytes_for(objects, value_bytes) && result_.bytes() >= value_bytes) return;
    const std::string sizes = std::to_string(objects) + ", " + std::to_string(value_bytes);
    throw Error("a reduction of " + std::to_string(objects) + " objects to " + std::to_string(value_bytes) +
                " bytes needs a workspace of " + std::to_string(bytes_for(objects, value_bytes)) +
                " bytes, and this one has " + std::to_string(bytes()) + "; make it ReduceWorkspace(" + sizes + ")");
  }

 private:
  static constexpr index_t counter_bytes = 256;
  Buffer parts_, result_;
};

}  // namespace physgen
