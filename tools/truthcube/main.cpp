// truthcube: the paper's silicone cube, or a mesh of your own, compressed quasistatically.
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <string>
#include <utility>

#include "parse.h"
#include "program.h"
#include "run.h"

// AddressSanitizer watches its own.
#ifndef __SANITIZE_ADDRESS__

/// Large blocks, those of std::vector, are in huge pages: to touch them for the first time in small ones takes longer
/// than to fill them.
[[gnu::noinline]] void* operator new(std::size_t size) {
  constexpr std::size_t huge_page = std::size_t{2} << 20;
  void* memory = nullptr;
  if (size >= huge_page) {
    if (posix_memalign(&memory, huge_page, size) != 0) throw std::bad_alloc();
    (void)madvise(memory, size, MADV_HUGEPAGE);  // advice: where there are none, the pages are small
    return memory;
  }
  memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
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
