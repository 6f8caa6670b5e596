// Allocation of buffers; CUDA and pinned memory come from the backend.
#include <physgen/detail/launch.h>
#include <physgen/device.h>
#include <physgen/error.h>
#include <physgen/memory/buffer.h>
#include <physgen/memory/host_list.h>
#include <physgen/memory/memory_error.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

#include "backend/memory.h"

namespace physgen {

namespace {

// A kernel streams several arrays of many channels; on pages of 4 KiB, each is a new page every few packs.
constexpr index_t huge_page = index_t{2} << 20;

// Memory that this process may have: the machine's, or less where a control group (a container) sets a limit.
index_t memory_limit() {
  index_t limit = static_cast<index_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<index_t>(sysconf(_SC_PAGESIZE));
  for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    index_t bytes = 0;
    if (std::ifstream(file) >> bytes) limit = std::min(limit, bytes);  // "max" is not a number and means no limit
  }
  return limit;
}

// Linux grants more than it has and kills the process that then touches it, so more than there can be is refused.
bool can_exist(index_t bytes, std::string& why) {
  static const index_t limit = memory_limit();
  if (bytes > limit) why = "this machine has only " + std::to_string(limit) + " bytes";
  return bytes <= limit;
}

// A wish: nothing is lost where the system does not grant it.
void ask_for_huge_pages(std::byte* data, std::size_t size) { madvise(data, size, MADV_HUGEPAGE); }

// Has the system hand out memory now, to several threads, in huge pages where it grants them: when a thread touches it
// first, it is interrupted for each page, and two that touch one huge page both wait.
void hand_out(std::byte* data, std::size_t size) {
  ask_for_huge_pages(data, size);
#ifdef MADV_POPULATE_WRITE
  constexpr auto part = static_cast<std::size_t>(huge_page);
  detail::for_each_index<8192>(0, static_cast<index_t>((size + part - 1) / part), [=](index_t p) {
    const std::size_t begin = static_cast<std::size_t>(p) * part;
    madvise(data + begin, std::min(part, size - begin), MADV_POPULATE_WRITE);
  });
#endif
}

constexpr const char* none_free = "the system does not have so much free memory";

// Not handed out: a list may have room for more than is ever written.
std::byte* allocate_host(index_t bytes, std::string& why) {
  if (!can_exist(bytes, why)) return nullptr;
  const bool large = bytes >= huge_page;
  const auto size = static_cast<std::size_t>(bytes);
  void* data = nullptr;  // std::aligned_alloc takes multiples of the alignment alone
  if (posix_memalign(&data, static_cast<std::size_t>(large ? huge_page : buffer_alignment), size) != 0) {
    why = none_free;
    return nullptr;
  }
  if (large) ask_for_huge_pages(static_cast<std::byte*>(data), size);
  return static_cast<std::byte*>(data);
}

// On several threads: to touch memory for the first time takes longer than to fill it.
void clear(std::byte* data, index_t bytes) {
  constexpr index_t part = index_t{1} << 16;
  detail::for_each_index<256>(0, (bytes + part - 1) / part, [=](index_t p) {
    std::memset(data + p * part, 0, static_cast<std::size_t>(std::min(part, bytes - p * part)));
  });
}

// A large buffer has pages of its own: the system clears them when it hands them out, and no thread has to do so again.
// AddressSanitizer sees who leaves memory of malloc alone.
bool has_own_pages(index_t bytes) {
#ifdef __SANITIZE_ADDRESS__
  constexpr bool watched = true;
#else
  constexpr bool watched = false;
#endif
  return !watched && bytes >= huge_page;
}

std::size_t size_of_pages(index_t bytes) {
  static const index_t page = sysconf(_SC_PAGESIZE);
  return static_cast<std::size_t>(align_up(bytes, page));
}

// From a huge page on.
std::byte* take_pages(index_t bytes, std::string& why) {
  if (!can_exist(bytes, why)) return nullptr;
  constexpr auto alignment = static_cast<std::size_t>(huge_page);
  const std::size_t size = size_of_pages(bytes);
  void* const all = mmap(nullptr, size + alignment, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (all == MAP_FAILED) {
    why = none_free;
    return nullptr;
  }
  const std::size_t before = (alignment - reinterpret_cast<std::uintptr_t>(all) % alignment) % alignment;
  std::byte* const data = static_cast<std::byte*>(all) + before;
  if (before > 0) munmap(all, before);
  munmap(data + size, alignment - before);
  hand_out(data, size);
  return data;
}

std::byte* allocate_clear(index_t bytes, std::string& why) {
  if (has_own_pages(bytes)) return take_pages(bytes, why);
  std::byte* const data = allocate_host(bytes, why);
  if (data != nullptr) clear(data, bytes);
  return data;
}

}  // namespace

Buffer::Buffer(SpaceKind space, index_t bytes, const std::string& what) : bytes_(bytes), space_(space) {
  if (bytes < 0) throw Error(what + ": cannot allocate " + std::to_string(bytes) + " bytes");
  if (bytes == 0) return;
  std::string why;
  const index_t rounded = align_up(bytes, buffer_alignment);
  data_ = space == SpaceKind::host ? allocate_clear(rounded, why) : backend::allocate(space, rounded, why);
  if (data_ == nullptr) {
    throw MemoryError(what + ": cannot allocate " + std::to_string(bytes) + " bytes of " + name(space) +
                      " memory: " + why);
  }
}

namespace detail {

void* allocate_list(std::size_t count, std::size_t bytes_of_each) {
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<index_t>::max()) / 2;
  std::string why = "so many cannot exist";
  void* memory = nullptr;
  if (count <= most / bytes_of_each) {
    const auto bytes = static_cast<index_t>(count * bytes_of_each);
    memory = allocate_host(align_up(std::max(bytes, index_t{1}), buffer_alignment), why);
  }
  if (memory != nullptr) return memory;
  throw MemoryError("a list of " + std::to_string(count) + " entries of " + std::to_string(bytes_of_each) +
                    " bytes cannot be allocated: " + why);
}

void free_list(void* memory) noexcept { std::free(memory); }

}  // namespace detail

void copy_memory(std::byte* to, SpaceKind to_space, const std::byte* from, SpaceKind from_space, index_t bytes) {
  if (bytes == 0) return;
  detail::wait_for_host_work(to_space);
  detail::wait_for_host_work(from_space);
  if (host_accessible(to_space) && host_accessible(from_space)) {
    std::memcpy(to, from, static_cast<std::size_t>(bytes));
  } else {
    detail::refuse_capture(nullptr, "a copy of bytes");
    backend::copy_bytes(to, from, bytes, nullptr);
    synchronize();
  }
}

Buffer::~Buffer() {
  if (data_ == nullptr) return;
  if (space_ != SpaceKind::host) {
    backend::deallocate(space_, data_);
  } else if (const index_t rounded = align_up(bytes_, buffer_alignment); has_own_pages(rounded)) {
    munmap(data_, size_of_pages(rounded));
  } else {
    std::free(data_);
  }
}

}  // namespace physgen
