// Rows of the sets on the GPU: a kernel in AoSoA. For CUDA translation units.
#pragma once

#include <physgen/cuda/parallel_for.h>

#include <memory>

#include "../cuda_timing.h"
#include "set_rows.h"

namespace physgen::bench {

namespace detail {

template <class Variant, class Real>
class CudaSetCase final : public TimedCudaCase {
 public:
  CudaSetCase(InputSets& sets, InputSet set)
      : TimedCudaCase(bytes_moved<Variant, Real>(sets.objects())),
        sets_(sets),
        set_(set),
        inputs_(make_arrays<Inputs>(sets.objects())),
        outputs_(make_arrays<Outputs>(sets.objects())) {
    copy_arrays(inputs_, HostVariant<Variant, Real>::inputs(sets, set), sets.objects());
  }
  double run() override {
    const auto kernel = kernel_over<Variant, Real>(inputs_, outputs_);
    watch().start();
    parallel_for(Cuda{}, sets_.objects(), kernel);
    return watch().stop();
  }
  Accuracy check() override {
    for_each_array(outputs_, [](auto& array) { poison_device(array.storage()); });
    run();
    auto results = make_arrays<typename HostVariant<Variant, Real>::Outputs>(sets_.samples());
    copy_arrays(results, outputs_, sets_.samples());
    return HostVariant<Variant, Real>::check(sets_, set_, results);
  }

 private:
  using Inputs = Arrays<typename Variant::Reads, Real, Cuda, Aosoa<32>>;
  using Outputs = Arrays<typename Variant::Writes, Real, Cuda, Aosoa<32>>;
  InputSets& sets_;
  InputSet set_;
  Inputs inputs_;
  Outputs outputs_;
};

}  // namespace detail

template <class Variant, class Real>
void CudaVariant<Variant, Real>::add_rows(std::vector<Row>& rows, InputSets& sets) {
  for (const InputSet set : input_sets) {
    rows.push_back(describe<Variant, Real>("aosoa32", SpaceKind::cuda, set, sets.objects()));
    rows.back().make = [&sets, set]() -> std::unique_ptr<Case> {
      return std::make_unique<detail::CudaSetCase<Variant, Real>>(sets, set);
    };
  }
}

template <class Variant, class Real>
auto CudaVariant<Variant, Real>::run(const typename HostVariant<Variant, Real>::Inputs& inputs) ->
    typename HostVariant<Variant, Real>::Outputs {
  auto device_inputs = make_arrays<Arrays<typename Variant::Reads, Real, Cuda, Aosoa<32>>>(1);
  auto device_outputs = make_arrays<Arrays<typename Variant::Writes, Real, Cuda, Aosoa<32>>>(1);
  copy_arrays(device_inputs, inputs, 1);
  parallel_for(Cuda{}, 1, kernel_over<Variant, Real>(device_inputs, device_outputs));
  auto outputs = make_arrays<typename HostVariant<Variant, Real>::Outputs>(1);
  copy_arrays(outputs, device_outputs, 1);
  return outputs;
}

}  // namespace physgen::bench
