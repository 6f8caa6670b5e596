// truthcube: the paper's silicone cube, or a mesh of your own, compressed quasistatically.
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "parse.h"
#include "program.h"
#include "run.h"

// AddressSanitizer watches its own.
#ifndef __SANITIZE_ADDRESS__

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

/// Where the heap ended when it was last looked at.
std::atomic<char*> end_of_heap{nullptr};

/// Lists of a set-up come and go: the heap grows by many pages at once, and keeps them. Not where addresses are
/// limited, which what it does not use yet would take from others.
const bool heap_keeps_pages = [] {
  struct rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) return false;
  end_of_heap = static_cast<char*>(sbrk(0));
  constexpr int most = std::numeric_limits<int>::max();
  return mallopt(M_MMAP_THRESHOLD, huge_page) != 0 && mallopt(M_TRIM_THRESHOLD, most) != 0 &&
         mallopt(M_TOP_PAD, 32 * huge_page) != 0;
}();

/// What the heap has grown by is in huge pages, too.
void ask_for_huge_pages_of_heap() {
  if (!heap_keeps_pages) return;
  char* const end = static_cast<char*>(sbrk(0));
  char* const before = end_of_heap.exchange(end, std::memory_order_relaxed);
  if (before >= end) return;
  (void)madvise(before, static_cast<std::size_t>(end - before), MADV_HUGEPAGE);
}

/// What operator new throws, with the bytes that there were not.
class NoMemory : public std::bad_alloc {
 public:
  explicit NoMemory(std::size_t bytes) {
    std::snprintf(text_.data(), text_.size(), "%zu bytes more cannot be had", bytes);
  }
  [[nodiscard]] const char* what() const noexcept override { return text_.data(); }

 private:
  std::array<char, 64> text_{};
};

}  // namespace

/// Large blocks, those of std::vector, and the heap are in huge pages: to touch them for the first time in small ones
/// takes longer than to fill them.
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* memory = nullptr;
  if (size >= huge_page) {
    if (posix_memalign(&memory, huge_page, size) != 0) throw NoMemory(size);
    (void)madvise(memory, size, MADV_HUGEPAGE);  // advice: where there are none, the pages are small
    return memory;
  }
  memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw NoMemory(size);
  ask_for_huge_pages_of_heap();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

#endif

int main(int count, char** words) {
  using namespace physgen::truthcube;
  return run_program("truthcube", count, words, parse,
                     [](Options options, const std::string& command, const physgen::Ranks& ranks) {
                       return static_cast<int>(run(std::move(options), command, ranks));
                     });
}
