// The backend of a build without CUDA: every use of GPU or pinned memory says so.
#include "../backend.h"

#include <physgen/error.h>

namespace physgen {

namespace {
constexpr const char* reason = "this physgen was built without CUDA; configure with -DPHYSGEN_CUDA=ON";
}

namespace backend {

std::byte* allocate(SpaceKind /*space*/, index_t /*bytes*/, std::string& why) {
  why = reason;
  return nullptr;
}
void deallocate(SpaceKind /*space*/, std::byte* /*data*/) noexcept {}
void copy_bytes(std::byte* /*to*/, const std::byte* /*from*/, index_t /*bytes*/, Stream /*stream*/) {
  throw Error(reason);
}
void convert(const Storage& /*to*/, const Storage& /*from*/, index_t /*begin*/, index_t /*end*/, Stream /*stream*/) {
  throw Error(reason);
}
void fill(const Storage& /*storage*/, const FieldInfo& /*field*/, index_t /*begin*/, index_t /*end*/) {
  throw Error(reason);
}

}  // namespace backend

void synchronize(Stream /*stream*/) {}
bool cuda_available() { return false; }

}  // namespace physgen
