// The scene derivative_chain over its generated arrays and over the same with every field: what it is given, how it is
// run, and what is wanted of it, as bits.
#pragma once

#include <derivative_chain.everything.h>
#include <derivative_chain.scene.h>
#include <gtest/gtest.h>
#include <physgen/executor.h>
#include <scenes/derivative_chain.h>

#include <random>

namespace physgen::test {
namespace scene = scenes::derivative_chain_scene;
namespace everything = scenes::derivative_chain_everything;

inline constexpr index_t nodes = 61, tets = 103;  // the last pack is not whole

/// One object at a time.
struct Singles : HostExecutor {
  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    parallel_for(Host{}, n, lanes<1>(kernel));
  }
};

template <class Body>
void set_up(Body& body) {
  std::mt19937 random(20100607);
  body.allocate({.node = nodes, .tet = tets});
  std::uniform_real_distribution<float> coordinate(-1, 1);
  const auto positions = body.positions.contents().view();
  for (index_t i = 0; i < nodes; ++i)
    positions[i].x() = Eigen::Vector3f(coordinate(random), coordinate(random), coordinate(random));
  const auto connectivity = body.tets.contents().view();
  for (index_t i = 0; i < tets; ++i) {
    const auto next = [&](int low, int high) {
      return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
    };
    const int first = next(0, nodes);
    connectivity[i].nodes() = Eigen::Vector4i(first, (first + next(1, 15)) % nodes, (first + next(15, 30)) % nodes,
                                              (first + next(30, 60)) % nodes);
  }
  Eigen::Matrix3f dm_inverse;
  dm_inverse << 1, 0.25F, 0, 0, 2, 0.5F, -0.125F, 0, 1.5F;
  body.rest.contents().view()[index_t{0}].dm_inverse() = dm_inverse;
}

/// All that is wanted of the scene, as bits.
template <class State>
std::vector<std::uint32_t> outputs(State& state) {
  std::vector<std::uint32_t> bits;
  for (index_t i = 0; i < tets; ++i) {
    const Eigen::Vector3f s = state.stretches.view()[i].s().get();
    for (int k = 0; k < 3; ++k) bits.push_back(std::bit_cast<std::uint32_t>(s[k]));
    bits.push_back(std::bit_cast<std::uint32_t>(state.derivatives.view()[i].x1111()));
    bits.push_back(std::bit_cast<std::uint32_t>(state.derivatives.view()[i].x2121()));
  }
  return bits;
}

inline const fem::NeoHookean<float> material{1.5F, 20.F};

template <class Body, class State, class On>
std::vector<std::uint32_t> results(On& on) {
  Body body;
  State state;
  set_up(body);
  state.allocate({.tet = tets});
  scenes::derivative_chain::program(on, body, state, material);
  return outputs(state);
}

}  // namespace physgen::test
