// Blocks of objects on their way between arrays and files: small enough to stay in a processor's cache from the file to
// the array, and in order, so that files are read and written from front to back.
#pragma once

#include <physgen/detail/host_loop.h>
#include <physgen/detail/launch.h>
#include <physgen/memory/buffer.h>

#include <algorithm>
#include <atomic>
#include <string>

namespace physgen::files {

/// Objects of a block. Its rows in a file are whole words of a checksum.
[[nodiscard]] inline index_t rows_of_block(int bytes_of_record) {
  constexpr index_t bytes = index_t{1} << 19, fewest = 1024;
  return align_up(bytes / std::max(bytes_of_record, 1), fewest);
}

[[nodiscard]] inline index_t blocks_of(index_t size, index_t rows) { return (size + rows - 1) / rows; }

/// Calls work(b, memory) for each block b, in order, on several threads.
/// @param bytes of memory, which each thread has for itself
/// @param what named in the message of the Error thrown when the memory cannot be had
/// @throw what a call throws (the first to be caught)
template <class Work>
void for_blocks(index_t blocks, index_t bytes, const std::string& what, const Work& work) {
  constexpr int about = 1 << 14;  // objects of a block, for the guess at what it takes
  std::atomic<index_t> next = 0;
  detail::RegionFailure failure;
  detail::for_parts<about>(blocks, [&](index_t begin, index_t end) {
    failure.guard([&] {
      const Buffer memory(SpaceKind::host, bytes, what);
      for (index_t calls = begin; calls < end; ++calls) work(next++, memory.data());
    });
  });
  failure.rethrow();
}

}  // namespace physgen::files
