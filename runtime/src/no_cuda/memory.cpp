// A build without CUDA refuses every use of GPU or pinned memory.
#include "../backend/memory.h"

#include <physgen/error.h>

#include "parts/reason.h"

namespace physgen::backend {

std::byte* allocate(SpaceKind /*space*/, index_t /*bytes*/, std::string& why) {
  why = reason;
  return nullptr;
}
void deallocate(SpaceKind /*space*/, std::byte* /*data*/) noexcept {}
void copy_bytes(std::byte* /*to*/, const std::byte* /*from*/, index_t /*bytes*/, Stream /*stream*/) {
  throw Error(reason);
}
void copy_strips(std::byte* /*to*/, index_t /*to_pitch*/, const std::byte* /*from*/, index_t /*from_pitch*/,
                 index_t /*bytes*/, int /*strips*/, Stream /*stream*/) {
  throw Error(reason);
}
void synchronize_device() {}

}  // namespace physgen::backend
