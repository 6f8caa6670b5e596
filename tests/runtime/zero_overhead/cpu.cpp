// Pairs of functions whose machine code zero_overhead.sh counts: <layout>_generated against <layout>_by_hand.
#include "kernels.h"

using namespace zero_overhead;
using physgen::Aos, physgen::Soa, physgen::Aosoa;

extern "C" {
void aos_generated(const Views<Aos>& v, index_t i) { generated(v, i); }
void soa_generated(const Views<Soa>& v, index_t i) { generated(v, i); }
void aosoa32_generated(const Views<Aosoa<32>>& v, index_t i) { generated(v, i); }

struct ByHand {
  const float* svd;
  index_t svd_size;
  index_t svd_pitch;
  float* h;
  index_t h_size;
  index_t h_pitch;
};
struct ByHandTiled {
  const float* svd;
  index_t svd_size;
  float* h;
  index_t h_size;
};
void aos_by_hand(const ByHandTiled& v, index_t i) { by_hand_aos(v.svd, v.h, i); }
void soa_by_hand(const ByHand& v, index_t i) { by_hand_soa(v.svd, v.svd_pitch, v.h, v.h_pitch, i); }
void aosoa32_by_hand(const ByHandTiled& v, index_t i) { by_hand_aosoa<32>(v.svd, v.h, i); }

// Over arrays that prune the fields that are not used.
void aos_pruned_generated(const PrunedViews<Aos>& v, index_t i) { generated_and_pruned<Aos>(v, i); }
void soa_pruned_generated(const PrunedViews<Soa>& v, index_t i) { generated_and_pruned<Soa>(v, i); }
void aosoa32_pruned_generated(const PrunedViews<Aosoa<32>>& v, index_t i) { generated_and_pruned<Aosoa<32>>(v, i); }
void aos_pruned_by_hand(const ByHandTiled& v, index_t i) { by_hand_aos<Part>(v.svd, v.h, i); }
void soa_pruned_by_hand(const ByHand& v, index_t i) { by_hand_soa<Part>(v.svd, v.svd_pitch, v.h, v.h_pitch, i); }
void aosoa32_pruned_by_hand(const ByHandTiled& v, index_t i) { by_hand_aosoa<32, Part>(v.svd, v.h, i); }
}
