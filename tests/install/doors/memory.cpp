// Asks for memory of a GPU: it gets some, or CUDA's reason why not.
#include <physgen/error.h>
#include <physgen/memory/buffer.h>

#include <cstdio>
#include <cstring>

int main() {
  try {
    const physgen::Buffer buffer(physgen::SpaceKind::cuda, 64, "a test");
    std::printf("%lld bytes\n", static_cast<long long>(buffer.bytes()));
  } catch (const physgen::Error& error) {
    std::printf("%s\n", error.what());
    return std::strstr(error.what(), "cudaError") != nullptr ? 0 : 1;
  }
}
