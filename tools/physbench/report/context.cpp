// CPU, compiler, GPU and libraries, as they call themselves.
#include "report/context.h"

#include <benchmark/benchmark.h>
#include <physgen/simd/simd_lanes.h>
#include <physgen/version.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "measure/registry.h"
#include "report/format.h"

namespace physgen::bench {

namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
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

std::string megabytes(double bytes) { return bytes > 0 ? format("%.1f MB", bytes * 1e-6) : "unknown"; }

}  // namespace

Facts describe_machine(int threads, const std::string& command) {
  const DeviceFacts& gpu = device_facts();
  const Limits limits = find_limits();
  Facts facts{{"cpu", cpu_model()},
              {"threads", std::to_string(threads) + ", packs of " + std::to_string(native_lanes<float>) + " float or " +
                              std::to_string(native_lanes<double>) + " double"},
              {"gpu", gpu.missing.empty() ? gpu.name : gpu.missing},
              {"llc", "last-level cache of the CPU " + megabytes(limits.host_cache) +
                          (gpu.missing.empty() ? ", of the GPU " + megabytes(limits.device_cache) : "") +
                          "; /LLC is a row's bytes over it"},
              {"compiler", compiler()},
              {"physgen", PHYSGEN_VERSION},
              {"results_version", "1"},  // tools/report/rows.py reads this version: names and meanings of counters
              {"command", command}};
  if (gpu.missing.empty()) {
    for (const auto& [name, missing] : registry().libraries) {
      if (!missing().empty()) facts.emplace_back(name, missing());
    }
  }
  return facts;
}

Limits find_limits() {
  Limits limits;
  limits.host_memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  double allowed = 0;  // of a container; "max" is no number
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> allowed) limits.host_memory = std::min(limits.host_memory, allowed);
  rlimit own{};
  if (getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY) {
    limits.host_memory = std::min(limits.host_memory, static_cast<double>(own.rlim_cur));
  }
  for (const auto& cache : benchmark::CPUInfo::Get().caches) {
    if (cache.type != "Instruction") limits.host_cache = std::max(limits.host_cache, double(cache.size));
  }
  limits.device_memory = device_facts().memory;
  limits.device_cache = device_facts().cache;
  return limits;
}

}  // namespace physgen::bench
