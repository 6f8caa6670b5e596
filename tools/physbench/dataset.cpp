// Makes the inputs of the kernels: nodes from the Truth Cube, everything else by the naive kernels in double.
#include "dataset.h"

#include <fem/mesh_arrays.h>

#include <Eigen/LU>
#include <numbers>
#include <random>
#include <typeinfo>

#include "naive_stiffness.h"
#include "values.h"

namespace physgen::bench {

namespace {

constexpr std::uint64_t seed = 20100622;

Master<elasticity::RestShapeObject> make_rest_shapes(const fem::TruthCube& cube) {
  Master<elasticity::RestShapeObject> shapes(static_cast<index_t>(cube.mesh.tets.size()));
  const auto view = shapes.view();
#pragma omp parallel for
  for (index_t t = 0; t < view.size(); ++t) {
    const Matrix3<double> dm = detail::edges<double>(cube.mesh.tets[static_cast<std::size_t>(t)], [&cube](auto node) {
      const fem::Point& p = cube.rest[static_cast<std::size_t>(node)];
      return Vector3<double>(p[0], p[1], p[2]);
    });
    view.put(t, {dm.inverse(), dm.determinant() / 6});
  }
  return shapes;
}

Master<elasticity::NodeDisplacementObject> make_displacements(const fem::TruthCube& cube) {
  Master<elasticity::NodeDisplacementObject> displacements(cube.mesh.nodes);
  const auto view = displacements.view();
  std::mt19937_64 random(seed + 1);
  const double spacing = fem::TruthCube::side / std::cbrt(static_cast<double>(cube.mesh.nodes));
  const auto noise = [&random, spacing] {
    return 1e-3 * spacing * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
  };
  for (index_t n = 0; n < view.size(); ++n) {
    const fem::Point& p = cube.rest[static_cast<std::size_t>(n)];
    const double k = 2 * std::numbers::pi / fem::TruthCube::side, a = 1e-3 * fem::TruthCube::side;
    const Vector3<double> dx(a * std::sin(k * p[1]) + noise(), a * std::cos(k * p[2]) + noise(),
                             a * std::sin(k * (p[0] + p[1])) + noise());
    view.put(n, {dx});
  }
  return displacements;
}

}  // namespace

Dataset::Dataset(index_t tets) : wanted_(tets), cells_(1) {
  while (index_t{6} * cells_ * cells_ * cells_ < tets) ++cells_;
}

index_t Dataset::count(Domain domain, Domain kernel_domain) const {
  const index_t c = cells_, tets = 6 * c * c * c, nodes = (c + 1) * (c + 1) * (c + 1);
  const index_t edges = 3 * c * (c + 1) * (c + 1) + 3 * c * c * (c + 1) + c * c * c;  // along axes, faces, cells
  switch (domain) {
    case Domain::tets:
      return kernel_domain == Domain::tets ? wanted_ : tets;
    case Domain::nodes:
      return nodes;
    case Domain::edges:
      return edges;
    case Domain::node_tets:
      return 4 * tets;
    case Domain::node_edges:
      return 2 * edges;
    case Domain::edge_tets:
      return 6 * tets;
  }
  return 0;
}

MeshSizes Dataset::sizes(Domain kernel_domain) const {
  const auto of = [&](Domain domain) { return static_cast<double>(count(domain, kernel_domain)); };
  return {of(Domain::tets), of(Domain::nodes), of(Domain::edges)};
}

template <class T, class Make>
const T& Dataset::once(const Make& make, int key) {
  auto& slot = made_[typeid(T).name() + std::to_string(key)];
  if (!slot) slot = std::make_shared<const T>(make());
  return *static_cast<const T*>(slot.get());
}

template <class Kernel>
const auto& Dataset::output_of() {
  using Object = typename Kernel::Output::Object;
  return once<Master<Object>>([this] {
    Master<Object> output(count(Kernel::Output::domain, Domain::nodes));
    const auto view = output.view();
    with_inputs<Kernel>(*this, [&view](const auto&... inputs) {
#pragma omp parallel for
      for (index_t i = 0; i < view.size(); ++i) {
        view.put(i, Naive<Kernel>::template value<double, double>(i, Values{inputs.view()}...));
      }
    });
    return output;
  });
}

const fem::TruthCube& Dataset::cube() {
  if (!cube_) cube_ = fem::make_truth_cube(cells_, seed);
  return *cube_;
}

const Dataset::Incidences& Dataset::incidences(Domain entries) {
  const fem::TetMesh& mesh = cube().mesh;
  const fem::IncidenceList& list = entries == Domain::node_tets    ? mesh.node_tets
                                   : entries == Domain::node_edges ? mesh.node_edges
                                                                   : mesh.edge_tets;
  return once<Incidences>(
      [&list] {
        Incidences made{Master<elasticity::IncidenceRangeObject>(static_cast<index_t>(list.first.size()) - 1),
                        Master<elasticity::IncidenceObject>(static_cast<index_t>(list.entries.size()))};
        fem::store_incidences(list, made.ranges.view(), made.entries.view());
        return made;
      },
      static_cast<int>(entries));
}

const Master<elasticity::TetObject>& Dataset::tets() {
  return once<Master<elasticity::TetObject>>([this] {
    Master<elasticity::TetObject> made(static_cast<index_t>(cube().mesh.tets.size()));
    fem::store_tets(cube().mesh, made.view());
    return made;
  });
}
const Master<elasticity::EdgeObject>& Dataset::edges() {
  return once<Master<elasticity::EdgeObject>>([this] {
    Master<elasticity::EdgeObject> made(static_cast<index_t>(cube().mesh.edges.size()));
    fem::store_edges(cube().mesh, made.view());
    return made;
  });
}
const Master<elasticity::NodePositionObject>& Dataset::positions() {
  return once<Master<elasticity::NodePositionObject>>([this] {
    Master<elasticity::NodePositionObject> made(cube().mesh.nodes);
    fem::store_positions(cube().deformed, made.view());
    return made;
  });
}
const Master<elasticity::NodeDisplacementObject>& Dataset::displacements() {
  return once<Master<elasticity::NodeDisplacementObject>>([this] { return make_displacements(cube()); });
}
const Master<elasticity::RestShapeObject>& Dataset::rest_shapes() {
  return once<Master<elasticity::RestShapeObject>>([this] { return make_rest_shapes(cube()); });
}
const Master<elasticity::DeformationGradientDifferentialObject>& Dataset::differentials() {
  return once<Master<elasticity::DeformationGradientDifferentialObject>>([this] {
    Master<elasticity::DeformationGradientDifferentialObject> made(tets().size());
    const auto view = made.view();
    const Values corners{tets().view()};
    const Values shapes{rest_shapes().view()};
    const Values dx{displacements().view()};
#pragma omp parallel for
    for (index_t i = 0; i < view.size(); ++i) {
      const Matrix3<double> ds = detail::edges<double>(corners[i].nodes, [&dx](index_t node) { return dx[node].dx; });
      view.put(i, {ds * shapes[i].dm_inverse});
    }
    return made;
  });
}
const Master<elasticity::DeformationGradientObject>& Dataset::deformation_gradients() {
  return output_of<DeformationGradient>();
}
const Master<elasticity::DeformationSvdObject>& Dataset::svds() { return output_of<Svd>(); }
const Master<elasticity::StressDerivativeObject>& Dataset::stress_derivatives() {
  return output_of<StressDerivative>();
}
const Master<elasticity::StressObject>& Dataset::stresses() { return output_of<Stress>(); }
const Master<elasticity::CornerForcesObject>& Dataset::corner_forces() { return output_of<ElasticForce>(); }
const Master<elasticity::TetStiffnessObject>& Dataset::tet_stiffness() { return output_of<TetStiffness>(); }
const Master<elasticity::NodeStiffnessObject>& Dataset::node_stiffness() { return output_of<NodeStiffness>(); }
const Master<elasticity::EdgeStiffnessObject>& Dataset::edge_stiffness() { return output_of<EdgeStiffness>(); }

}  // namespace physgen::bench
