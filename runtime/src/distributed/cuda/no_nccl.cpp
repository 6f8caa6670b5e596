// A build without NCCL's header.
#include <physgen/distributed/cuda/transports.h>

namespace physgen::cuda {

const NcclFound& find_nccl() {
  static const NcclFound none{0, "physgen was built without nccl.h; install NCCL beside CUDA and build it again"};
  return none;
}

std::string nccl_version_text(int version) { return std::to_string(version); }

std::unique_ptr<Transport> make_nccl_transport(Transport& /*host*/, Stream /*stream*/, std::string& why_not) {
  why_not = find_nccl().why_not;
  return nullptr;
}

}  // namespace physgen::cuda
