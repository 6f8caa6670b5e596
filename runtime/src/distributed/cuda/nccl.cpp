// Loads NCCL.
#include <dlfcn.h>
#include <physgen/distributed/cuda/nccl.h>

#include <cstdlib>
#include <vector>

#include "nccl_functions.h"

namespace physgen::cuda {

namespace {

/// The functions that are used are the same in all of one major version, from where the newest of them appeared:
/// ncclGetLastError() in 2.13, ncclSend() and ncclRecv() in 2.7.
constexpr int oldest = 21300;

constexpr int major(int version) { return version / 10000; }

struct Loaded {
  NcclFound found;
  NcclFunctions functions;

  Loaded() {
    const char* const named = std::getenv("PHYSGEN_NCCL");
    std::vector<std::string> names;
    if (named != nullptr && *named != '\0') {
      names.emplace_back(named);
    } else {  // where the loader looks, and beside the header
      names.emplace_back("libnccl.so.2");
      names.emplace_back(PHYSGEN_NCCL_LIBRARY);
    }
    void* library = nullptr;
    for (const std::string& name : names) {
      if (library == nullptr && !name.empty()) library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
      if (library == nullptr && found.why_not.empty()) found.why_not = dlerror();
    }
    if (library == nullptr) return;
    found.why_not.clear();
    const auto take = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
      if (function == nullptr && found.why_not.empty()) found.why_not = std::string("NCCL has no function ") + name;
    };
    take(functions.get_version, "ncclGetVersion");
    take(functions.get_unique_id, "ncclGetUniqueId");
    take(functions.init_rank, "ncclCommInitRank");
    take(functions.destroy, "ncclCommDestroy");
    take(functions.abort, "ncclCommAbort");
    take(functions.error_string, "ncclGetErrorString");
    take(functions.last_error, "ncclGetLastError");
    take(functions.group_start, "ncclGroupStart");
    take(functions.group_end, "ncclGroupEnd");
    take(functions.send, "ncclSend");
    take(functions.receive, "ncclRecv");
    take(functions.all_gather, "ncclAllGather");
    if (!found.why_not.empty()) return;
    if (functions.get_version(&found.version) != ncclSuccess) {
      found.why_not = "NCCL does not say its version";
    } else if (major(found.version) != NCCL_MAJOR || found.version < oldest) {
      found.why_not = "NCCL " + nccl_version_text(found.version) + " was found, and physgen uses one from " +
                      nccl_version_text(oldest) + " on, of version " + std::to_string(NCCL_MAJOR);
    }
  }
};

const Loaded& loaded() {
  static const Loaded once;
  return once;
}

}  // namespace

const NcclFound& find_nccl() { return loaded().found; }

const NcclFunctions& nccl_functions() { return loaded().functions; }

std::string nccl_version_text(int version) {
  return std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
         std::to_string(version % 100);
}

}  // namespace physgen::cuda
