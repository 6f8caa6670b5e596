// Without CUDA no rank takes a device.
#include <physgen/distributed/cuda/device.h>
#include <physgen/error.h>

namespace physgen::cuda {

RankDevice take_device(const Ranks& /*ranks*/, Transport& /*transport*/) {
  throw Error(
      "arrays in CUDA memory need a physgen that was built with CUDA; configure it with -DPHYSGEN_CUDA=ON, or run the "
      "program over arrays of the host");
}

}  // namespace physgen::cuda
