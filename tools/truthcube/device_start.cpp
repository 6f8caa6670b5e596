#include "device_start.h"

#include "memory.h"

namespace physgen::truthcube {

// Asking for its memory makes the context; all threads of the process then have it.
DeviceStart::DeviceStart(bool wanted) {
  if (wanted) free_ = std::async(std::launch::async, cuda_memory).share();
}

}  // namespace physgen::truthcube
