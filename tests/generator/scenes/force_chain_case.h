// The scene force_chain over its generated arrays, with its tets' kernels as one step, against the same kernels one by
// one over arrays with every field: for packs, single objects and CUDA, in both precisions.
#pragma once

#include <force_chain.program.h>
#include <gtest/gtest.h>
#include <physgen/arrays/copy.h>
#include <scenes/force_chain.h>

#include <bit>
#include <random>

namespace physgen::test::force_chain {

inline constexpr index_t nodes = 40, tets = 117;
inline constexpr fem::LameParameters lame{1.5, 20};

struct Mesh {
  std::vector<Eigen::Vector4i> corners;
  std::vector<std::vector<Eigen::Vector2i>> of_node;  // tet, corner
  Mesh() : of_node(nodes) {
    std::mt19937 random(20100607);
    for (int t = 0; t < tets; ++t) {
      const int first = static_cast<int>(random() % nodes);
      corners.emplace_back(first, (first + 7) % nodes, (first + 20) % nodes, (first + 31) % nodes);
      for (int c = 0; c < 4; ++c) of_node[static_cast<std::size_t>(corners.back()[c])].emplace_back(t, c);
    }
  }
};

/// Fills what the program is given, whatever arrays hold it.
template <class Real, class Arrays>
void fill(Arrays& to) {
  const Mesh mesh;
  std::mt19937 random(4);
  std::uniform_real_distribution<Real> number(-1, 1);
  index_t entry = 0;
  for (index_t n = 0; n < nodes; ++n) {
    to.positions.view()[n].x() = Eigen::Matrix<Real, 3, 1>(number(random), number(random), number(random));
    const auto range = to.node_ranges.view()[n];
    range.begin() = static_cast<int>(entry);
    for (const auto& incidence : mesh.of_node[static_cast<std::size_t>(n)]) {
      to.node_tets.view()[entry].element() = incidence[0];
      to.node_tets.view()[entry++].local() = incidence[1];
    }
    range.end() = static_cast<int>(entry);
  }
  for (index_t t = 0; t < tets; ++t) {
    to.tets.view()[t].nodes() = mesh.corners[static_cast<std::size_t>(t)];
    Eigen::Matrix<Real, 3, 3> dm_inverse = Eigen::Matrix<Real, 3, 3>::Identity();
    for (int k = 0; k < 9; ++k) dm_inverse(k) += Real(0.3) * number(random);
    to.rest.view()[t].dm_inverse() = dm_inverse;
    to.rest.view()[t].volume() = Real(1) + Real(0.5) * number(random);
  }
}

/// The scene's arrays by their names, all of ordinary ones.
template <class Real_, class Space>
struct Plain {
  using Real = Real_;
  elasticity::NodePositionArray<Real, Space> positions{nodes};
  elasticity::TetArray<Real, Space> tets{force_chain::tets};
  elasticity::RestShapeArray<Real, Space> rest{force_chain::tets};
  elasticity::IncidenceRangeArray<Real, Space> node_ranges{nodes};
  elasticity::IncidenceArray<Real, Space> node_tets{4 * force_chain::tets};
  elasticity::DeformationGradientArray<Real, Space> gradients{force_chain::tets};
  elasticity::DeformationSvdArray<Real, Space> svds{force_chain::tets};
  elasticity::StressArray<Real, Space> stresses{force_chain::tets};
  elasticity::CornerForcesArray<Real, Space> corner_forces{force_chain::tets};
  elasticity::NodeForceArray<Real, Space> forces{nodes};
};

/// Copies to `to` what the program is given. @param contents of one of its arrays, as whoever fills it sees it
template <class To, class From, class Contents>
void give(To& to, From& from, const Contents& contents) {
  copy(contents(to.positions), from.positions);
  copy(contents(to.tets), from.tets);
  copy(contents(to.rest), from.rest);
  copy(contents(to.node_ranges), from.node_ranges);
  copy(contents(to.node_tets), from.node_tets);
}

template <class Real, class On>
void expect_the_same_forces(On& on) {
  using Space = typename On::Space;
  Plain<Real, Host> given;
  fill<Real>(given);
  scenes::force_chain_scene::Body<Space, Real> body;
  body.allocate({.node = nodes, .tet = tets, .corner = 4 * tets});
  give(body, given, [](auto& array) -> auto& { return array.contents(); });
  scenes::force_chain_scene::fused::program(on, body, lame);
  Plain<Real, Space> plain;
  give(plain, given, [](auto& array) -> auto& { return array; });
  scenes::force_chain::program(on, plain, lame);
  on.wait();
  elasticity::NodeForceArray<Real> forces(nodes), separate(nodes);
  copy(forces, body.forces);
  copy(separate, plain.forces);
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), most = sum;
  for (index_t n = 0; n < nodes; ++n) {
    const Eigen::Matrix<Real, 3, 1> f = forces.view()[n].f().get(), expected = separate.view()[n].f().get();
    for (int k = 0; k < 3; ++k) EXPECT_EQ(std::bit_cast<Bits>(f[k]), std::bit_cast<Bits>(expected[k])) << n;
    sum += f.template cast<double>();
    most = most.cwiseMax(f.template cast<double>().cwiseAbs());
  }
  EXPECT_GT(most.minCoeff(), 1.0) << "forces that are all small would show nothing";
  EXPECT_LT((sum.cwiseAbs() - 1e-5 * nodes * most).maxCoeff(), 0.0) << "forces of a free body cancel: " << sum;
}

}  // namespace physgen::test::force_chain
