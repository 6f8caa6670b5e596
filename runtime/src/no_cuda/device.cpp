// The device in a build without CUDA: there is none.
#include <physgen/device.h>

namespace physgen {

void detail::refuse_capture(Stream /*stream*/, const char* /*what*/) {}

void synchronize(Stream /*stream*/) {}
bool cuda_available() { return false; }

}  // namespace physgen
