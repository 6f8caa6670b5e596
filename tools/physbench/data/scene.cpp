// Makes the scene: mesh and nodes from the Truth Cube, rest shapes and differentials from formulas.
#include "data/scene.h"

#include <fem/mesh/mesh_arrays.h>
#include <fem/mesh/renumber.h>
#include <physgen/detail/host_loop.h>

#include <Eigen/LU>
#include <numbers>
#include <random>

#include "data/formulas.h"

namespace physgen::bench {

namespace {

constexpr std::uint64_t seed = 20100622;

std::vector<fem::Point> reordered(const std::vector<fem::Point>& points, const std::vector<fem::Index>& order) {
  std::vector<fem::Point> result;
  result.reserve(points.size());
  for (const fem::Index old : order) result.push_back(points[static_cast<std::size_t>(old)]);
  return result;
}

void renumber(fem::TruthCube& cube, const fem::Renumbering& numbers) {
  cube.mesh = fem::renumbered(cube.mesh, numbers);
  cube.rest = reordered(cube.rest, numbers.node_order);
  cube.deformed = reordered(cube.deformed, numbers.node_order);
}

Vector3<double> vector_of(const fem::Point& p) { return {p[0], p[1], p[2]}; }

}  // namespace

const char* name(Numbering numbering) {
  return numbering == Numbering::ordered ? "ordered" : numbering == Numbering::random ? "random" : "renumbered";
}

Scene::Scene(index_t tets, Numbering numbering) : wanted_(tets), numbering_(numbering) {
  while (index_t{6} * cells_ * cells_ * cells_ < tets) ++cells_;
}

index_t Scene::count(Domain domain, Domain kernel_domain) const {
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

double Scene::memory() const {
  const auto of = [this](Domain domain) { return static_cast<double>(count(domain, Domain::nodes)); };
  return of(Domain::tets) * (16 + (4 + 6) * 8) + of(Domain::edges) * (8 + 2 * 8 + 4) + of(Domain::nodes) * (6 * 8 + 8);
}

const fem::TruthCube& Scene::cube() {
  if (!cube_) {
    fem::TruthCube cube = fem::make_truth_cube(cells_, seed);
    if (numbering_ != Numbering::ordered) renumber(cube, fem::random_numbering(cube.mesh, seed));
    if (numbering_ == Numbering::renumbered) renumber(cube, fem::renumber_for_locality(cube.mesh));
    cube_ = std::make_unique<const fem::TruthCube>(std::move(cube));
  }
  return *cube_;
}

namespace source {

namespace {

// An array of `count` objects that fill(view) stores.
template <class Source, class Fill>
const Master<typename Source::Object>& filled(Scene& scene, const char* name, const Fill& fill) {
  using Array = Master<typename Source::Object>;
  return scene.once<Array>(name, [&] {
    Array made(scene.count(Source::domain, Domain::nodes));
    fill(made.view());
    return made;
  });
}

}  // namespace

const Master<elasticity::TetObject>& Tets::of(Scene& scene) {
  return filled<Tets>(scene, "tets", [&](const auto& view) { fem::store_tets(scene.cube().mesh, view); });
}

const Master<elasticity::EdgeObject>& Edges::of(Scene& scene) {
  return filled<Edges>(scene, "edges", [&](const auto& view) { fem::store_edges(scene.cube().mesh, view); });
}

const Master<elasticity::NodePositionObject>& Positions::of(Scene& scene) {
  return filled<Positions>(scene, "positions",
                           [&](const auto& view) { fem::store_positions(scene.cube().deformed, view); });
}

const Master<elasticity::RestShapeObject>& RestShapes::of(Scene& scene) {
  return filled<RestShapes>(scene, "rest shapes", [&](const auto& view) {
    const fem::TruthCube& cube = scene.cube();
    physgen::detail::host_loop(view.size(), [&](index_t t) {
      const Matrix3<double> dm = formula::edges<double>(cube.mesh.tets[static_cast<std::size_t>(t)], [&](auto node) {
        return vector_of(cube.rest[static_cast<std::size_t>(node)]);
      });
      view.put(t, {dm.inverse(), dm.determinant() / 6});
    });
  });
}

const Master<elasticity::NodeDisplacementObject>& Displacements::of(Scene& scene) {
  return filled<Displacements>(scene, "displacements", [&](const auto& view) {
    const fem::TruthCube& cube = scene.cube();
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
  });
}

const Master<elasticity::DeformationGradientDifferentialObject>& Differentials::of(Scene& scene) {
  return filled<Differentials>(scene, "differentials", [&](const auto& view) {
    const auto tets = Tets::of(scene).view();
    const auto rest = RestShapes::of(scene).view();
    const auto dx = Displacements::of(scene).view();
    physgen::detail::host_loop(view.size(), [&](index_t i) {
      const Matrix3<double> ds =
          formula::edges<double>(tets.get(i).nodes, [&dx](index_t node) { return dx.get(node).dx; });
      view.put(i, {ds * rest.get(i).dm_inverse});
    });
  });
}

const Incidences& incidences(Scene& scene, Domain entries) {
  const fem::TetMesh& mesh = scene.cube().mesh;
  const fem::IncidenceList& list = entries == Domain::node_tets    ? mesh.node_tets
                                   : entries == Domain::node_edges ? mesh.node_edges
                                                                   : mesh.edge_tets;
  return scene.once<Incidences>("incidences " + std::to_string(static_cast<int>(entries)), [&list] {
    Incidences made{Master<elasticity::IncidenceRangeObject>(static_cast<index_t>(list.first.size()) - 1),
                    Master<elasticity::IncidenceObject>(static_cast<index_t>(list.entries.size()))};
    fem::store_incidences(list, made.ranges.view(), made.entries.view());
    return made;
  });
}

const Master<elasticity::TetPlacesObject>& TetPlaces::of(Scene& scene) {
  return filled<TetPlaces>(scene, "places", [&](const auto& view) {
    const auto entries = incidences(scene, Domain::node_tets).entries.view();
    physgen::detail::host_loop(entries.size(), [&](index_t k) {
      const elasticity::Incidence<double> entry = entries.get(k);
      view[index_t{entry.element}].places()[entry.local] = static_cast<std::int32_t>(k);
    });
  });
}

}  // namespace source

}  // namespace physgen::bench
