// Rows of the GPU: a kernel in every layout and storage. For CUDA files, such as those that CMake writes from
// instantiate.cu.in.
#pragma once

#include <physgen/cuda/parallel_for.h>

#include "measure/cuda.h"
#include "measure/kernel_case.h"
#include "measure/model.h"
#include "measure/registry.h"
#include "measure/scene_data.h"
#include "measure/set_data.h"

namespace physgen::bench {

struct CudaKernels : CudaDevice {
  template <int kLanes, class Kernel>
  static void run(index_t objects, const Kernel& kernel) {
    parallel_for(Cuda{}, objects, kernel);
  }
};

namespace detail {

template <class Provider>
void add_cuda_layouts(std::vector<Row>& rows, const Provider& provider) {
  using Kernel = typename Provider::Kernel;
  const Adder<CudaKernels, Provider> of(rows, provider);
  const std::size_t before = rows.size();
  if constexpr (requires { Kernel::only_aos; }) {
    of.template layout<Aos>(Kernel::only_aos);
  } else {
    of.copy();
    of.template layout<Aos>("aos");
    if constexpr (!requires { Kernel::few_layouts; }) of.template layout<Soa>("soa");
    of.template layout<Aosoa<32>>("aosoa32");
  }
  for (std::size_t k = before; k < rows.size(); ++k) rows[k].model = model_of(rows[k]);
}

template <class Kernel, class Real>
void add_cuda_set_rows(std::vector<Row>& rows, const std::shared_ptr<SampleSets>& sets) {
  for (const InputSet set : input_sets) {
    Adder<CudaKernels, OnSet<Kernel, Real>>(rows, OnSet<Kernel, Real>(sets, set)).template layout<Aosoa<32>>("aosoa32");
  }
}

/// The kernel on the inputs, and its outputs.
template <class Kernel, class Real>
auto run_once_on_cuda(const typename OnSet<Kernel, Real>::Inputs& given) {
  const auto one = [](std::size_t /*k*/) { return index_t{1}; };
  auto inputs = make_arrays<ArraysOf<typename Kernel::Reads, Real, Cuda, Aosoa<32>>>(one);
  auto outputs = make_arrays<ArraysOf<typename Kernel::Writes, Real, Cuda, Aosoa<32>>>(one);
  copy_arrays(inputs, given);
  parallel_for(Cuda{}, 1, kernel_over<Kernel, Real>(inputs, outputs));
  auto results = make_arrays<typename OnSet<Kernel, Real>::Outputs>(one);
  copy_arrays(results, outputs);
  return results;
}

template <class Kernel, class Real>
void register_cuda_replay() {
  add(ReplayWay{Kernel::name, storage_name<Real>(), 10 * Kernel::place + 3, [](const std::vector<std::string>& words) {
                  if (!device_facts().missing.empty()) return std::string();
                  return OnSet<Kernel, Real>::replay(words, "cuda", run_once_on_cuda<Kernel, Real>);
                }});
}

}  // namespace detail

/// @tparam Reals float, double or both
template <class Kernel, class... Reals>
bool register_cuda_scene_rows() {
  return add(Part{"kernels", Kernel::place, Kernel::name, "cuda", [](std::vector<Row>& rows, const Sizes& sizes) {
                    (detail::add_cuda_layouts(rows, OnScene<Kernel, Reals>(scene_of(sizes.cuda))), ...);
                  }});
}

template <class Kernel>
bool register_cuda_set_rows() {
  detail::register_cuda_replay<Kernel, float>();
  detail::register_cuda_replay<Kernel, double>();
  return add(Part{"errors", Kernel::place, Kernel::name, "cuda", [](std::vector<Row>& rows, const Sizes& sizes) {
                    detail::add_cuda_set_rows<Kernel, float>(rows, sets_of(sizes.sets));
                    detail::add_cuda_set_rows<Kernel, double>(rows, sets_of(sizes.sets));
                  }});
}

}  // namespace physgen::bench
