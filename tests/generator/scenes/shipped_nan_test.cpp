// That the digests of shipped scenes are true: NaN in some objects of a field, in arrays that keep all fields,
// reaches the nodes that these objects matter to, and no others.
#include <dynamics.physgen.h>
#include <quasistatic.physgen.h>
#include <scenes/explicit_dynamics.h>

#include <iostream>

#include "force_chain_case.h"
#include "planted_nan.h"

namespace physgen::test {
namespace {

using force_chain::Mesh, force_chain::nodes, force_chain::tets;
using Numbers = std::vector<double>;

/// Nodes of these tets.
Objects nodes_of(const Objects& of_tets) {
  const Mesh mesh;
  Objects result;
  for (const index_t t : of_tets)
    for (int c = 0; c < 4; ++c) result.insert(mesh.corners[static_cast<std::size_t>(t)][c]);
  return result;
}
/// Nodes of the tets that have one of these nodes.
Objects neighbours_of(const Objects& of_nodes) {
  const Mesh mesh;
  Objects of_tets;
  for (const index_t n : of_nodes)
    for (const auto& incidence : mesh.of_node[static_cast<std::size_t>(n)]) of_tets.insert(incidence[0]);
  return nodes_of(of_tets);
}

struct ForceChain {
  static constexpr const char* digest = PHYSGEN_DIGESTS "/force_chain.digest";
  static constexpr std::size_t fields = 10;
  force_chain::Plain<float, Host> body;

  ForceChain() { force_chain::fill<float>(body); }
  template <class On>
  void run(On& on) {
    scenes::force_chain::program(on, body, force_chain::lame);
  }
  /// By node.
  std::vector<Numbers> outputs() {
    std::vector<Numbers> result;
    for (index_t n = 0; n < nodes; ++n) {
      const Eigen::Vector3f f = body.forces.view()[n].f();
      result.push_back({f[0], f[1], f[2]});
    }
    return result;
  }
  UntypedArray named(const std::string& name) {
    const std::map<std::string, UntypedArray> arrays = {
        {"body.positions", body.positions.untyped()}, {"body.rest", body.rest.untyped()},
        {"body.gradients", body.gradients.untyped()}, {"body.svds", body.svds.untyped()},
        {"body.stresses", body.stresses.untyped()},   {"body.corner_forces", body.corner_forces.untyped()},
        {"body.forces", body.forces.untyped()}};
    return arrays.at(name);
  }
  static Objects reached(const std::string& array, const Objects& objects) {
    if (array == "body.forces") return objects;
    return array == "body.positions" ? neighbours_of(objects) : nodes_of(objects);
  }
};

/// A step of a body of which some nodes are held, in one direction or in all.
struct ExplicitDynamics {
  static constexpr const char* digest = PHYSGEN_DIGESTS "/explicit_dynamics.digest";
  static constexpr std::size_t fields = 15;
  struct Body {
    elasticity::TetArray<float> tets{test::tets};
    elasticity::RestShapeArray<float> rest{test::tets};
    elasticity::CornerForcesArray<float> corners{test::tets};
    elasticity::TetPlacesArray<float> places{0};
    elasticity::PlacedForceArray<float> placed{0};
    elasticity::IncidenceRangeArray<float> node_tet_ranges{nodes};
    elasticity::IncidenceArray<float> node_tets{4 * test::tets};
    quasistatic::NodeConstraintArray<float> constraints{nodes};
    dynamics::NodeMassArray<double> masses{nodes};
    elasticity::NodeForceArray<double> loads{nodes};
    elasticity::NodeDisplacementArray<double> motion{nodes}, displacements{nodes};
    elasticity::NodeDisplacementArray<float> rounded{nodes};
    dynamics::NodeVelocityArray<double> velocities{nodes};
    elasticity::NodeForceArray<float> forces{nodes};
    dynamics::MotionArray<double> measured{1};
  };
  Body body;

  static int fixed(index_t node) { return node % 3 == 0 ? 7 : node % 3 == 1 ? 2 : 0; }

  ExplicitDynamics() {
    force_chain::Plain<float, Host> chain;
    force_chain::fill<float>(chain);
    copy(body.tets, chain.tets);
    copy(body.rest, chain.rest);
    copy(body.node_tet_ranges, chain.node_ranges);
    copy(body.node_tets, chain.node_tets);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0.01, 0.1);
    const auto vector = [&] { return Eigen::Vector3d(number(random), -number(random), number(random)); };
    for (index_t n = 0; n < nodes; ++n) {
      body.constraints.view()[n].fixed() = fixed(n);
      body.masses.view()[n].mass() = number(random);
      body.loads.view()[n].f() = vector();
      body.motion.view()[n].dx() = vector();
      const Eigen::Vector3d u = vector();
      body.displacements.view()[n].dx() = u;
      body.rounded.view()[n].dx() = u.cast<float>();
      body.velocities.view()[n].v() = vector();
    }
    body.measured.view()[index_t{0}].farthest() = 3;
  }
  template <class On>
  void run(On& on) {
    fem::TimeStep step;
    step.length = 1e-3;
    step.load = 0.5;
    step.damping = 0.1;
    scenes::explicit_dynamics::program(on, body, fem::NeoHookean<float>{1.5F, 20.F}, step);
  }
  /// By node, and what is measured of all behind them.
  std::vector<Numbers> outputs() {
    std::vector<Numbers> result;
    for (index_t n = 0; n < nodes; ++n) {
      const Eigen::Vector3d u = body.displacements.view()[n].dx(), v = body.velocities.view()[n].v();
      const Eigen::Vector3f rounded = body.rounded.view()[n].dx();
      result.push_back({u[0], u[1], u[2], v[0], v[1], v[2], rounded[0], rounded[1], rounded[2]});
    }
    const auto all = body.measured.view().get(index_t{0});
    result.push_back({all.kinetic, all.elastic, all.farthest, all.momentum[0], all.momentum[1], all.momentum[2]});
    return result;
  }
  UntypedArray named(const std::string& name) {
    const std::map<std::string, UntypedArray> arrays = {{"body.rest", body.rest.untyped()},
                                                        {"body.corners", body.corners.untyped()},
                                                        {"body.placed", body.placed.untyped()},
                                                        {"body.masses", body.masses.untyped()},
                                                        {"body.loads", body.loads.untyped()},
                                                        {"body.motion", body.motion.untyped()},
                                                        {"body.displacements", body.displacements.untyped()},
                                                        {"body.rounded", body.rounded.untyped()},
                                                        {"body.velocities", body.velocities.untyped()},
                                                        {"body.forces", body.forces.untyped()},
                                                        {"body.measured", body.measured.untyped()}};
    return arrays.at(name);
  }
  static Objects reached(const std::string& array, const Objects& objects) {
    if (array == "body.measured") return {};
    if (array == "body.displacements" || array == "body.velocities") return objects;
    Objects result = objects;
    if (array == "body.rest" || array == "body.corners") result = nodes_of(objects);
    if (array == "body.rounded") result = neighbours_of(objects);
    std::erase_if(result, [&](index_t n) { return array == "body.motion" ? fixed(n) == 0 : fixed(n) == 7; });
    if (array == "body.rounded") result.insert(objects.begin(), objects.end());
    return result;
  }
};

/// The nodes whose outputs are other bits; behind the last one, what is not of a node.
Objects changed(const std::vector<Numbers>& found, const std::vector<Numbers>& expected) {
  Objects result;
  for (std::size_t n = 0; n < expected.size(); ++n)
    if (std::memcmp(found[n].data(), expected[n].data(), expected[n].size() * sizeof(double)) != 0)
      result.insert(static_cast<index_t>(n));
  return result;
}

/// @return fields that are said to be read, and never changed an output
template <class Scene>
std::vector<std::string> read_in_vain() {
  const auto expected = [] {
    HostExecutor plain;
    Scene scene;
    scene.run(plain);
    return scene.outputs();
  }();
  std::vector<std::string> result;
  const auto fields = reads_of(Scene::digest);
  EXPECT_EQ(fields.size(), Scene::fields);
  for (const auto& [name, is_read] : fields) {
    const auto& [array, field] = name;
    bool reached = false;
    for (unsigned seed = 20100607; seed < 20100607 + 6; ++seed) {
      Scene scene;
      const UntypedArray planted = scene.named(array);
      if (planted.size == 0) continue;  // of the other side
      const Objects objects = planted.size == 1 ? Objects{0} : some_of(planted.size, seed);
      Interrupted on;
      on.after = [&, field_name = field] { plant_nan(planted, field_name, objects); };
      on.after();
      scene.run(on);
      Objects other = changed(scene.outputs(), expected);
      reached = reached || !other.empty();
      other.erase(nodes);
      EXPECT_EQ(listed(other), listed(is_read ? Scene::reached(array, objects) : Objects()))
          << array << "." << field << (is_read ? " is read" : " is said to be unread") << ", seed " << seed;
    }
    if (is_read && !reached) result.push_back(array + "." + field);
  }
  return result;
}

TEST(DigestOfForceChain, is_true_of_each_field_and_object_that_nan_is_planted_in) {
  EXPECT_EQ(read_in_vain<ForceChain>(), std::vector<std::string>());
}

TEST(DigestOfExplicitDynamics, is_true_of_each_field_and_object_that_nan_is_planted_in) {
  EXPECT_EQ(read_in_vain<ExplicitDynamics>(),
            (std::vector<std::string>{"body.measured.elastic", "body.measured.kinetic", "body.measured.momentum",
                                      "body.placed.f"}))
      << "what is measured is stored behind the last step, and forces are placed on CUDA alone";
}

}  // namespace
}  // namespace physgen::test
