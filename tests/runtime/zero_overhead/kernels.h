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

using physgen::Host, physgen::format::Nothing;

/// The fields of an SVD and of a stress derivative that the loop bodies read and write, and no more.
struct Stretches : elasticity::DeformationSvdFormats<Host> {
  using U = Nothing;
  using V = Nothing;
};
struct FourEntries : elasticity::StressDerivativeFormats<Host> {
  using x3311 = Nothing;
  using x2222 = Nothing;
  using x3333 = Nothing;
  using x2121 = Nothing;
  using x2112 = Nothing;
  using x3131 = Nothing;
  using x3113 = Nothing;
  using x3232 = Nothing;
};

template <class Layout, class Svd = elasticity::DeformationSvdFormats<Host>,
          class Derivative = elasticity::StressDerivativeFormats<Host>>
struct Views {
  elasticity::DeformationSvdView<const float, Layout, Space, Svd> svd;
  elasticity::StressDerivativeView<float, Layout, Space, Derivative> h;
};
template <class Layout>
using PrunedViews = Views<Layout, Stretches, FourEntries>;

// Reads s and writes four of the twelve scalars by name.
template <class AnyViews>
PHYSGEN_FUNCTION inline void generated(const AnyViews& views, index_t i) {
  const auto s = views.svd[i].s();
  const auto h = views.h[i];
  h.x1111() = s(0) * s(0);
  h.x2211() = s(0) * s(1);
  h.x3322() = s(1) * s(2);
  h.x3223() = s(2) * 2.0F;
}

// Computes and stores as many that are pruned, too.
template <class Layout>
PHYSGEN_FUNCTION inline void generated_and_pruned(const PrunedViews<Layout>& views, index_t i) {
  const auto s = views.svd[i].s();
  const auto h = views.h[i];
  h.x3311() = s(0) / s(1);
  h.x2222() = s(1) / s(2);
  h.x3333() = s(2) / s(0);
  h.x2121() = s(0) - s(1);
  generated(views, i);
}

/// Channels of the operands, where the stretches begin among them, and which the four entries are, the first being 0.
struct All {
  static constexpr int svd = 21, s = 18, h = 12, second = 1, third = 4, fourth = 11;
};
struct Part {
  static constexpr int svd = 3, s = 0, h = 4, second = 1, third = 2, fourth = 3;
};

// The same as one writes it without physgen.
template <class Channels = All>
PHYSGEN_FUNCTION inline void by_hand_aos(const float* svd, float* h, index_t i) {
  const float* s = svd + i * Channels::svd + Channels::s;
  float* x = h + i * Channels::h;
  x[0] = s[0] * s[0];
  x[Channels::second] = s[0] * s[1];
  x[Channels::third] = s[1] * s[2];
  x[Channels::fourth] = s[2] * 2.0F;
}

template <class Channels = All>
PHYSGEN_FUNCTION inline void by_hand_soa(const float* svd, index_t svd_pitch, float* h, index_t h_pitch, index_t i) {
  const float* s = svd + Channels::s * svd_pitch + i;
  float* x = h + i;
  x[0] = s[0] * s[0];
  x[Channels::second * h_pitch] = s[0] * s[svd_pitch];
  x[Channels::third * h_pitch] = s[svd_pitch] * s[2 * svd_pitch];
  x[Channels::fourth * h_pitch] = s[2 * svd_pitch] * 2.0F;
}

template <int W, class Channels = All>
PHYSGEN_FUNCTION inline void by_hand_aosoa(const float* svd, float* h, index_t i) {
  const auto u = static_cast<std::uint64_t>(i);
  const float* s = svd + u / W * (Channels::svd * W) + Channels::s * W + u % W;
  float* x = h + u / W * (Channels::h * W) + u % W;
  x[0] = s[0] * s[0];
  x[Channels::second * W] = s[0] * s[W];
  x[Channels::third * W] = s[W] * s[2 * W];
  x[Channels::fourth * W] = s[2 * W] * 2.0F;
}

}  // namespace zero_overhead
