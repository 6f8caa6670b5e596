// The backend of a build without CUDA: every use of GPU or pinned memory says so.
#include "../backend.h"

#include <physgen/error.h>

#include "reason.h"

namespace physgen {

namespace backend {

std::byte* allocate(SpaceKind /*space*/, index_t /*bytes*/, std::string& why) {
  why = reason;
  return nullptr;
}
void deallocate(SpaceKind /*space*/, std::byte* /*data*/) noexcept {}
void copy_bytes(std::byte* /*to*/, const std::byte* /*from*/, index_t /*bytes*/, Stream /*stream*/) {
  throw Error(reason);
}
void copy_rows(std::byte* /*to*/, index_t /*to_pitch*/, const std::byte* /*from*/, index_t /*from_pitch*/,
               index_t /*bytes*/, int /*rows*/, Stream /*stream*/) {
  throw Error(reason);
}
index_t convert(const UntypedArray& /*to*/, const UntypedArray& /*from*/, index_t /*begin*/, index_t /*end*/,
                Stream /*stream*/) {
  throw Error(reason);
}
void fill(const UntypedArray& /*storage*/, const detail::Fill& /*field*/, index_t /*begin*/, index_t /*end*/) {
  throw Error(reason);
}

Losses count_losses(const UntypedArray& /*to*/, const UntypedArray& /*from*/, index_t /*begin*/, index_t /*end*/,
                    Stream /*stream*/) {
  throw Error(reason);
}
void synchronize_device() {}

}  // namespace backend

void detail::refuse_capture(Stream /*stream*/, const char* /*what*/) {}

void synchronize(Stream /*stream*/) {}
bool cuda_available() { return false; }

}  // namespace physgen
