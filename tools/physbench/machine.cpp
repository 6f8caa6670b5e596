// CPU, compiler and GPU, as they call themselves.
#include "machine.h"

#include <physgen/parallel_for.h>
#include <physgen/storage.h>

#include <fstream>

#ifdef PHYSGEN_BENCH_CUDA
#include <cuda_runtime_api.h>

#include "accuracy/cusolver.h"
#endif
#include "sources.h"

namespace physgen::bench {

namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

Gpu find_gpu() {
#ifdef PHYSGEN_BENCH_CUDA
  if (!cuda_available()) return {"", "no usable CUDA device: rows of the GPU are left out"};
  cudaDeviceProp properties{};
  int runtime = 0, driver = 0;
  if (cudaGetDeviceProperties(&properties, 0) != cudaSuccess || cudaRuntimeGetVersion(&runtime) != cudaSuccess ||
      cudaDriverGetVersion(&driver) != cudaSuccess) {
    return {"", "the CUDA device does not answer: rows of the GPU are left out"};
  }
  const auto version = [](int number) {
    return std::to_string(number / 1000) + "." + std::to_string(number % 1000 / 10);
  };
  return {std::string(properties.name) + ", " + std::to_string(properties.multiProcessorCount) +
              " multiprocessors, CUDA " + version(runtime) + ", driver for CUDA " + version(driver),
          ""};
#else
  return {"", "built without CUDA: rows of the GPU need the preset `cuda` (tools/dev gpu)"};
#endif
}

Machine describe_machine(const Options& options, const std::string& command) {
  const Gpu gpu = find_gpu();
  Machine machine{{"cpu", cpu_model()},
                  {"threads", std::to_string(options.threads) + ", packs of " + std::to_string(native_lanes<float>) +
                                  " float or " + std::to_string(native_lanes<double>) + " double"},
                  {"gpu", gpu.missing.empty() ? gpu.name : gpu.missing},
                  {"compiler", compiler()},
                  {"physgen", PHYSGEN_BENCH_VERSION},
                  {"results_version", "1"},  // tools/report/rows.py reads this version: names and meanings of counters
                  {"sources", source_hashes()},
                  {"command", command}};
#ifdef PHYSGEN_BENCH_CUDA
  if (gpu.missing.empty() && !cusolver_missing().empty()) machine.emplace_back("cusolver", cusolver_missing());
#endif
  return machine;
}

}  // namespace physgen::bench
