// Initial values and counts of losses in CUDA memory: a thread takes one object.
#include <physgen/cuda/check.h>
#include <physgen/device.h>

#include "../backend/memory.h"
#include "../backend/objects.h"
#include "parts/moves.h"
#include "parts/stream_memory.h"

namespace physgen {

namespace {

using cuda::check;
using cuda::Moves;
using cuda::threads;
using detail::Addressing;

__global__ void fill_kernel(const Addressing array, const detail::Fill fill, index_t begin, index_t end) {
  const index_t i = begin + blockIdx.x * index_t{blockDim.x} + threadIdx.x;
  if (i < end) fill.apply(array, i);
}

__global__ void count_kernel(const Addressing from, const __grid_constant__ Moves moves, index_t begin, index_t end,
                             Losses* losses) {
  const index_t i = begin + blockIdx.x * index_t{blockDim.x} + threadIdx.x;
  if (i >= end) return;
  for (int e = 0; e < moves.elements; ++e) detail::count_element(*losses, moves.element[e], from, i);
  for (int r = 0; r < moves.rotations; ++r) detail::count_rotation(*losses, moves.rotation[r], from, i);
}

}  // namespace

Losses backend::count_losses(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end,
                             Stream stream) {
  const cuda::StreamMemory memory(sizeof(Losses), stream);
  auto* on_device = reinterpret_cast<Losses*>(memory.data());
  Losses losses;
  copy_bytes(memory.data(), reinterpret_cast<const std::byte*>(&losses), sizeof losses, stream);
  detail::Conversion conversion(to, from);
  conversion.rotations.insert(conversion.rotations.end(), conversion.kept_quaternions.begin(),
                              conversion.kept_quaternions.end());
  cuda::for_each_part(conversion, [&](const Moves& moves) {
    count_kernel<<<cuda::blocks_for(end - begin, threads), threads, 0, stream>>>(Addressing(from), moves, begin, end,
                                                                                 on_device);
    check(cudaGetLastError(), "launching a count of what formats cannot hold");
  });
  copy_bytes(reinterpret_cast<std::byte*>(&losses), memory.data(), sizeof losses, stream);
  synchronize(stream);
  return losses;
}

void backend::fill(const UntypedArray& array, const detail::Fill& field, index_t begin, index_t end) {
  detail::refuse_capture(nullptr, "the initial values of an array");
  fill_kernel<<<cuda::blocks_for(end - begin, threads), threads>>>(Addressing(array), field, begin, end);
  check(cudaGetLastError(), "launching the fill of an array");
  check(cudaDeviceSynchronize(), "filling an array");
}

}  // namespace physgen
