// graphs on CUDA: see graphs_run.h. Exit status 77 where there is no CUDA device.
#include <physgen/distributed/cuda/executor.h>

#include "graphs_run.h"

int main(int argc, char** argv) {
  try {
    if (!physgen::cuda_available()) {
      std::printf("skipped: there is no CUDA device\n");
      return 77;
    }
    return graphs::run<physgen::CudaExecutor>(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
