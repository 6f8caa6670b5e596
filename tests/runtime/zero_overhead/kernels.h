// The same loop bodies twice: over generated accessors, and by hand over pointers.
#pragma once

#include <elasticity.physgen.h>

namespace zero_overhead {

using physgen::index_t;

#ifdef __CUDACC__
using Space = physgen::Cuda;
#else
using Space = physgen::Host;
#endif

template <class Layout>
struct Views {
  elasticity::DeformationSvdView<const float, Layout, Space> svd;
  elasticity::StressDerivativeView<float, Layout, Space> h;
};

// Reads s and writes four of the twelve scalars by name.
template <class Layout>
PHYSGEN_FUNCTION inline void generated(const Views<Layout>& views, index_t i) {
  const auto s = views.svd[i].s();
  const auto h = views.h[i];
  h.x1111() = s(0) * s(0);
  h.x2211() = s(0) * s(1);
  h.x3322() = s(1) * s(2);
  h.x3223() = s(2) * 2.0F;
}

// What one writes without physgen. `svd` has 21 and `h` 12 channels.
PHYSGEN_FUNCTION inline void by_hand_aos(const float* svd, float* h, index_t i) {
  const float* s = svd + i * 21 + 18;
  float* x = h + i * 12;
  x[0] = s[0] * s[0];
  x[1] = s[0] * s[1];
  x[4] = s[1] * s[2];
  x[11] = s[2] * 2.0F;
}

PHYSGEN_FUNCTION inline void by_hand_soa(const float* svd, index_t svd_pitch, float* h, index_t h_pitch, index_t i) {
  const float* s = svd + 18 * svd_pitch + i;
  float* x = h + i;
  x[0] = s[0] * s[0];
  x[h_pitch] = s[0] * s[svd_pitch];
  x[4 * h_pitch] = s[svd_pitch] * s[2 * svd_pitch];
  x[11 * h_pitch] = s[2 * svd_pitch] * 2.0F;
}

template <int W>
PHYSGEN_FUNCTION inline void by_hand_aosoa(const float* svd, float* h, index_t i) {
  const auto u = static_cast<std::uint64_t>(i);
  const float* s = svd + u / W * (21 * W) + 18 * W + u % W;
  float* x = h + u / W * (12 * W) + u % W;
  x[0] = s[0] * s[0];
  x[W] = s[0] * s[W];
  x[4 * W] = s[W] * s[2 * W];
  x[11 * W] = s[2 * W] * 2.0F;
}

}  // namespace zero_overhead
