// Rows of the GPU: a kernel in every layout and storage, and the device's copy beside it. For CUDA translation units.
#pragma once

#include <physgen/cuda/parallel_for.h>

#include "cuda_timing.h"
#include "kernels.h"

namespace physgen::bench {

namespace detail {

template <class Kernel, class Real, class Layout, class Scheme = SchemaFormats>
class CudaCase final : public TimedCudaCase {
 public:
  explicit CudaCase(Dataset& data, double bytes = 0)
      : TimedCudaCase(bytes > 0 ? bytes : bytes_moved<Kernel, Real>(data)), data_(data), operands_(data) {}
  double run() override {
    const auto kernel = operands_.kernel();
    watch().start();
    parallel_for(Cuda{}, operands_.output().size(), kernel);
    return watch().stop();
  }
  Accuracy check() override {
    poison_device(operands_.output().storage());
    run();
    Result<Kernel, Real> result(operands_.output().size());
    physgen::copy(result, operands_.output());
    synchronize();
    return HostKernel<Kernel>::check(data_, result.storage());
  }

 private:
  Dataset& data_;
  Operands<Kernel, Real, Cuda, Layout, Scheme> operands_;
};

/// The copy alone.
template <class Kernel, class Real>
class CudaCopyCase final : public TimedCudaCase {
 public:
  explicit CudaCopyCase(Dataset& data) : TimedCudaCase(bytes_moved<Kernel, Real>(data)) {}
  double run() override { return copy(); }
  Accuracy check() override { return {}; }
};

template <class Kernel, class Real, class MeasuredCase>
void add_cuda_row(std::vector<Row>& rows, Dataset& data, const char* layout) {
  Row row = describe<Kernel, Real>(layout, SpaceKind::cuda, data);
  row.make = [&data]() -> std::unique_ptr<Case> { return std::make_unique<MeasuredCase>(data); };
  rows.push_back(std::move(row));
}

template <class Kernel, class Real>
void add_cuda_rows(std::vector<Row>& rows, Dataset& data) {
  add_cuda_row<Kernel, Real, CudaCopyCase<Kernel, Real>>(rows, data, "copy");
  add_cuda_row<Kernel, Real, CudaCase<Kernel, Real, Aos>>(rows, data, "aos");
  add_cuda_row<Kernel, Real, CudaCase<Kernel, Real, Soa>>(rows, data, "soa");
  add_cuda_row<Kernel, Real, CudaCase<Kernel, Real, Aosoa<32>>>(rows, data, "aosoa32");
}

}  // namespace detail

template <class Kernel>
void CudaKernel<Kernel>::add_rows(std::vector<Row>& rows, Dataset& data) {
  detail::add_cuda_rows<Kernel, float>(rows, data);
  detail::add_cuda_rows<Kernel, double>(rows, data);
}

}  // namespace physgen::bench
