// The scene force_chain, run over its generated arrays with its tets' kernels as one step, against the same kernels one
// by one over arrays with every field.
#include <force_chain.program.h>
#include <gtest/gtest.h>
#include <physgen/executor.h>
#include <scenes/force_chain.h>

#include <random>

namespace physgen::test {
namespace {

constexpr index_t nodes = 40, tets = 117;
const fem::NeoHookean<float> material{1.5F, 20.F};

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
template <class Arrays>
void fill(Arrays& to) {
  const Mesh mesh;
  std::mt19937 random(4);
  std::uniform_real_distribution<float> number(-1, 1);
  index_t entry = 0;
  for (index_t n = 0; n < nodes; ++n) {
    to.positions.view()[n].x() = Eigen::Vector3f(number(random), number(random), number(random));
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
    Eigen::Matrix3f dm_inverse = Eigen::Matrix3f::Identity();
    for (int k = 0; k < 9; ++k) dm_inverse(k) += 0.3F * number(random);
    to.rest.view()[t].dm_inverse() = dm_inverse;
    to.rest.view()[t].volume() = 1.F + 0.5F * number(random);
  }
}

/// The scene's arrays by their names, all of ordinary ones.
struct Plain {
  elasticity::NodePositionArray<float> positions{nodes};
  elasticity::TetArray<float> tets{test::tets};
  elasticity::RestShapeArray<float> rest{test::tets};
  elasticity::IncidenceRangeArray<float> node_ranges{nodes};
  elasticity::IncidenceArray<float> node_tets{4 * test::tets};
  elasticity::DeformationGradientArray<float> gradients{test::tets};
  elasticity::DeformationSvdArray<float> svds{test::tets};
  elasticity::StressArray<float> stresses{test::tets};
  elasticity::CornerForcesArray<float> corner_forces{test::tets};
  elasticity::NodeForceArray<float> forces{nodes};
};

/// What fill() fills of the scene's arrays.
struct Contents {
  explicit Contents(scenes::force_chain_scene::Body<>& body)
      : positions(body.positions.contents()),
        tets(body.tets.contents()),
        rest(body.rest.contents()),
        node_ranges(body.node_ranges.contents()),
        node_tets(body.node_tets.contents()) {}
  elasticity::NodePositionArray<float>& positions;
  elasticity::TetArray<float>& tets;
  elasticity::RestShapeArray<float>& rest;
  elasticity::IncidenceRangeArray<float>& node_ranges;
  elasticity::IncidenceArray<float>& node_tets;
};

/// One object at a time.
struct Singles : HostExecutor {
  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    parallel_for<1>(Host{}, n, kernel);
  }
};

template <class On>
void expect_the_same_forces() {
  scenes::force_chain_scene::Body<> body;
  body.allocate({.node = nodes, .tet = tets, .corner = 4 * tets});
  Contents contents(body);
  fill(contents);
  On on;
  scenes::force_chain_scene::fused::program(on, body, material);
  Plain plain;
  fill(plain);
  scenes::force_chain::program(on, plain, material);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), most = sum;
  for (index_t n = 0; n < nodes; ++n) {
    const Eigen::Vector3f f = body.forces.view()[n].f().get(), expected = plain.forces.view()[n].f().get();
    for (int k = 0; k < 3; ++k) EXPECT_EQ(std::bit_cast<int>(f[k]), std::bit_cast<int>(expected[k])) << n;
    sum += f.cast<double>();
    most = most.cwiseMax(f.cast<double>().cwiseAbs());
  }
  EXPECT_GT(most.minCoeff(), 1.0) << "forces that are all small would show nothing";
  EXPECT_LT((sum.cwiseAbs() - 1e-5 * nodes * most).maxCoeff(), 0.0) << "forces of a free body cancel: " << sum;
}

TEST(ForceChain, gives_as_one_step_the_forces_that_its_kernels_give_one_by_one_over_ordinary_arrays) {
  expect_the_same_forces<HostExecutor>();
  expect_the_same_forces<Singles>();
}

TEST(ForceChain, keeps_nothing_of_what_its_tets_kernels_hand_to_each_other) {
  scenes::force_chain_scene::Body<> body;
  body.allocate({.node = nodes, .tet = tets, .corner = 4 * tets});
  EXPECT_EQ(body.gradients.bytes() + body.svds.bytes() + body.stresses.bytes(), 0);
  EXPECT_EQ(body.svds.size(), tets);
  EXPECT_EQ(body.bytes(), body.positions.bytes() + body.tets.bytes() + body.rest.bytes() + body.node_ranges.bytes() +
                              body.node_tets.bytes() + body.corner_forces.bytes() + body.forces.bytes());
  EXPECT_THROW(body.svds.resize(-1), Error);
}

}  // namespace
}  // namespace physgen::test
