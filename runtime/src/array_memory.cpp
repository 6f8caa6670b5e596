// Changes of the size of arrays without their types.
#include <physgen/arrays/array_memory.h>
#include <physgen/arrays/copy.h>
#include <physgen/arrays/initial_values.h>
#include <physgen/error.h>

#include <algorithm>
#include <limits>
#include <string>

namespace physgen::detail {

namespace {

index_t checked_bytes(const MemoryKind& kind, index_t size) {
  const index_t limit = std::numeric_limits<index_t>::max() / std::max(kind.record_bytes, 1) / 4;  // room for padding
  if (size < 0 || size > limit) {
    throw Error(std::string(kind.object) + ": an array of " + std::to_string(size) + " objects of " +
                std::to_string(kind.record_bytes) + " bytes cannot exist; give a size from 0 to " +
                std::to_string(limit));
  }
  return kind.padded(size) * kind.record_bytes;
}

}  // namespace

UntypedArray ArrayMemory::untyped(const MemoryKind& kind) const {
  return {buffer_.data(), size_,      kind.padded(capacity_), kind.pitch(capacity_), kind.record_bytes, kind.space,
          kind.object,    kind.fields};
}

void ArrayMemory::resize(const MemoryKind& kind, index_t size) {
  if (size == size_) return;
  if (size < 0 || size > capacity_) return replace(kind, size, size);
  const index_t changed = std::min(size, size_), end = kind.padded(size);  // packs run over padding, too
  reset(untyped(kind), changed, std::clamp(used_, changed, end));
  used_ = std::max(used_, end);
  set_size(kind, size);
}

void ArrayMemory::replace(const MemoryKind& kind, index_t capacity, index_t size) {
  ArrayMemory other;
  other.buffer_ = Buffer(kind.space, checked_bytes(kind, capacity) + (capacity > 0 ? loss_bytes : 0),
                         std::string(kind.object) + "[" + std::to_string(capacity) + "]");
  other.capacity_ = capacity;
  other.size_ = size;
  const index_t kept = std::min(size, size_);
  copy_range(other.untyped(kind), untyped(kind), 0, kept);
  initialize(other.untyped(kind), kept, kind.padded(capacity));
  other.used_ = std::clamp(used_, kind.padded(size), kind.padded(capacity));  // copies may take padding along
  other.inherit_losses(kind, *this);
  swap(other);
}

void ArrayMemory::copy_of(const MemoryKind& kind, const ArrayMemory& other) {
  resize(kind, other.size_);
  copy_range(untyped(kind), other.untyped(kind), 0, size_);
}

}  // namespace physgen::detail
