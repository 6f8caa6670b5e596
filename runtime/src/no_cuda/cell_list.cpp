// A build without CUDA has no cell lists in CUDA memory.
#include <physgen/detail/cuda_cell_search.h>
#include <physgen/error.h>

#include "parts/reason.h"

namespace physgen::detail {

template <class Real, int kDimensions>
CudaCellSearch<Real, kDimensions>::CudaCellSearch(const CellBox<Real, kDimensions>& box, Real reach)
    : box_(box), reach_(reach) {
  throw Error(backend::reason);
}
template <class Real, int kDimensions>
std::array<index_t, kDimensions> CudaCellSearch<Real, kDimensions>::cells() const {
  return {};
}
template <class Real, int kDimensions>
HostList<index_t> CudaCellSearch<Real, kDimensions>::order() const {
  return {};
}
template <class Real, int kDimensions>
Real* CudaCellSearch<Real, kDimensions>::begin(index_t /*size*/) {
  return nullptr;
}
template <class Real, int kDimensions>
void CudaCellSearch<Real, kDimensions>::sort(Stream /*stream*/) {}
template <class Real, int kDimensions>
index_t CudaCellSearch<Real, kDimensions>::search(bool /*with_itself*/, index_t /*most*/, Stream /*stream*/) {
  return 0;
}
template <class Real, int kDimensions>
void CudaCellSearch<Real, kDimensions>::write_rows(const UntypedArray& /*ranges*/, const UntypedArray& /*entries*/,
                                                   Stream /*stream*/) const {}

template class CudaCellSearch<float, 1>;
template class CudaCellSearch<float, 2>;
template class CudaCellSearch<float, 3>;
template class CudaCellSearch<double, 1>;
template class CudaCellSearch<double, 2>;
template class CudaCellSearch<double, 3>;

}  // namespace physgen::detail
