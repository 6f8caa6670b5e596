// The memory of an object array: what changes its size is written once, over arrays without their types, and compiled
// in the library, since programs have arrays of many types.
#pragma once

#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/untyped_array.h>
#include <physgen/config.h>
#include <physgen/memory/buffer.h>

#include <span>
#include <string_view>
#include <utility>

namespace physgen::detail {

/// What the memory of an array depends on of its types.
struct MemoryKind {
  SpaceKind space;
  int record_bytes;
  index_t (*padded)(index_t objects);  ///< the layout's: objects for which memory is held
  index_t (*pitch)(index_t objects);   ///< the layout's, of so many objects
  std::string_view object;             ///< qualified name of the object type, for messages
  std::span<const FieldInfo> fields;
};

/// The base of all arrays. Its functions are given the kind that the array's types are; Array says what they do.
class ArrayMemory {
 protected:
  [[nodiscard]] UntypedArray untyped(const MemoryKind& kind) const;

  /// @throw Error when size is negative, the memory cannot be had, or a format cannot hold the initial value of its
  /// field; the memory is then unchanged
  void resize(const MemoryKind& kind, index_t size);
  /// Moves to memory of another capacity, as an array of `size` objects. @throw Error as resize()
  void replace(const MemoryKind& kind, index_t capacity, index_t size);
  /// Takes the values and the size of another memory of the same kind. @throw Error as resize() @pre size_ == 0
  void copy_of(const MemoryKind& kind, const ArrayMemory& other);

  // In checked builds the counters stand behind the objects, in the same space.
  static constexpr index_t loss_bytes = checked_build ? index_t{sizeof(Losses)} : 0;
  [[nodiscard]] Losses* losses(const MemoryKind& kind) const {
    if (!checked_build || size_ == 0) return nullptr;
    return reinterpret_cast<Losses*>(buffer_.data() + kind.padded(capacity_) * kind.record_bytes);
  }
  void set_size(const MemoryKind& kind, index_t size) {
    const Losses* old = losses(kind);
    size_ = size;
    if (checked_build && size > 0) start_losses(*losses(kind), old, size, kind.space);
  }
  void inherit_losses(const MemoryKind& kind, const ArrayMemory& old) {
    if (checked_build && size_ > 0) start_losses(*losses(kind), old.losses(kind), size_, kind.space);
  }

  void swap(ArrayMemory& other) noexcept {
    buffer_.swap(other.buffer_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    std::swap(used_, other.used_);
  }

  Buffer buffer_;
  index_t size_ = 0;
  index_t capacity_ = 0;
  index_t used_ = 0;  // objects from here to the end of the memory have initial values
};

}  // namespace physgen::detail
