// A build without CUDA has no device.
#include <physgen/device.h>

namespace physgen {

void detail::refuse_capture(Stream /*stream*/, const char* /*what*/) {}

void synchronize(Stream /*stream*/) {}
bool cuda_available() { return false; }

}  // namespace physgen
