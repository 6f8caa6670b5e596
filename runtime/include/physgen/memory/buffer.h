// Owned memory of one space: the lowest of the three levels (buffer, object array, generated classes).
#pragma once

#include <physgen/memory/space.h>

#include <string>
#include <utility>

namespace physgen {

/// Bytes every buffer's address is a multiple of: a CPU cache line and a GPU memory transaction fit whole.
inline constexpr index_t buffer_alignment = 256;

/// Zero-initialised, aligned memory of one space. Move-only.
class Buffer {
 public:
  Buffer() = default;
  /// @param bytes size; 0 allocates nothing
  /// @param what named in the message of the Error thrown when the memory cannot be had
  Buffer(SpaceKind space, index_t bytes, const std::string& what);
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer();

  [[nodiscard]] std::byte* data() const { return data_; }
  [[nodiscard]] index_t bytes() const { return bytes_; }

  void swap(Buffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(bytes_, other.bytes_);
    std::swap(space_, other.space_);
  }

 private:
  std::byte* data_ = nullptr;
  index_t bytes_ = 0;
  SpaceKind space_ = SpaceKind::host;
};

/// Copies bytes between memory of any two spaces, ordered in the default stream; done when this returns.
/// @throw Error with CUDA's message when it fails
void copy_memory(std::byte* to, SpaceKind to_space, const std::byte* from, SpaceKind from_space, index_t bytes);

}  // namespace physgen
