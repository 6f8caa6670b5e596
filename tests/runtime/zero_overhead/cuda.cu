// Pairs of kernels whose PTX and registers zero_overhead.sh counts: <layout>_generated against <layout>_by_hand.
#include "kernels.h"

using namespace zero_overhead;
using physgen::Aos, physgen::Soa, physgen::Aosoa;

__device__ inline index_t thread() { return blockIdx.x * index_t{blockDim.x} + threadIdx.x; }

extern "C" {
__global__ void aos_generated(Views<Aos> v) { generated(v, thread()); }
__global__ void soa_generated(Views<Soa> v) { generated(v, thread()); }
__global__ void aosoa32_generated(Views<Aosoa<32>> v) { generated(v, thread()); }

__global__ void aos_by_hand(const float* svd, float* h) { by_hand_aos(svd, h, thread()); }
__global__ void soa_by_hand(const float* svd, index_t svd_pitch, float* h, index_t h_pitch) {
  by_hand_soa(svd, svd_pitch, h, h_pitch, thread());
}
__global__ void aosoa32_by_hand(const float* svd, float* h) { by_hand_aosoa<32>(svd, h, thread()); }

// Over arrays that prune the fields that are not used.
__global__ void aos_pruned_generated(PrunedViews<Aos> v) { generated_and_pruned<Aos>(v, thread()); }
__global__ void soa_pruned_generated(PrunedViews<Soa> v) { generated_and_pruned<Soa>(v, thread()); }
__global__ void aosoa32_pruned_generated(PrunedViews<Aosoa<32>> v) { generated_and_pruned<Aosoa<32>>(v, thread()); }
__global__ void aos_pruned_by_hand(const float* svd, float* h) { by_hand_aos<Part>(svd, h, thread()); }
__global__ void soa_pruned_by_hand(const float* svd, index_t svd_pitch, float* h, index_t h_pitch) {
  by_hand_soa<Part>(svd, svd_pitch, h, h_pitch, thread());
}
__global__ void aosoa32_pruned_by_hand(const float* svd, float* h) { by_hand_aosoa<32, Part>(svd, h, thread()); }
}
