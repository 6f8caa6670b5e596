// Allocation of buffers; CUDA and pinned memory come from the backend.
#include <physgen/buffer.h>
#include <physgen/error.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "backend.h"

namespace physgen {

namespace {

// Linux grants more than it has and kills the process that then touches it, so more than the machine's memory is refused.
std::byte* allocate_host(index_t bytes, std::string& why) {
  const index_t memory = static_cast<index_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<index_t>(sysconf(_SC_PAGESIZE));
  if (bytes > memory) {
    why = "the machine has " + std::to_string(memory) + " bytes of memory";
    return nullptr;
  }
  void* data = std::aligned_alloc(static_cast<std::size_t>(buffer_alignment), static_cast<std::size_t>(bytes));
  if (data == nullptr) {
    why = "the system has not as much memory free";
    return nullptr;
  }
  std::memset(data, 0, static_cast<std::size_t>(bytes));
  return static_cast<std::byte*>(data);
}

}  // namespace

Buffer::Buffer(SpaceKind space, index_t bytes, const std::string& what) : bytes_(bytes), space_(space) {
  if (bytes == 0) return;
  std::string why;
  const index_t rounded = align_up(bytes, buffer_alignment);
  data_ = space == SpaceKind::host ? allocate_host(rounded, why) : backend::allocate(space, rounded, why);
  if (data_ == nullptr) {
    throw Error(what + ": cannot allocate " + std::to_string(bytes) + " bytes of " + name(space) + " memory: " + why);
  }
}

Buffer::~Buffer() {
  if (data_ == nullptr) return;
  if (space_ == SpaceKind::host) {
    std::free(data_);
  } else {
    backend::deallocate(space_, data_);
  }
}

}  // namespace physgen
