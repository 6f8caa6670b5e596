// The parameters of a type-parameterised test of kernels: precision, space, layout and, on the CPU, lanes.
#pragma once

namespace physgen::fem {

/// @tparam kLanes as parallel_for on the CPU takes it: 0 for the widest packs, 1 for single objects; 0 on CUDA
template <class Real_, class Space_, class Layout_, int kLanes = 0>
struct RunCase {
  using Real = Real_;
  using Space = Space_;
  using Layout = Layout_;
  static constexpr int lanes = kLanes;
};

}  // namespace physgen::fem
