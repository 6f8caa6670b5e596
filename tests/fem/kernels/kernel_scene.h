// A small Truth Cube in object arrays of one precision, space and layout, with all kernels run over it in order; and
// the naive reference: textbook formulae per tet on plain Eigen matrices in extended precision, sharing no code with
// them.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/force_differential.h>
#include <fem/kernels/stiffness.h>
#include <fem/kernels/stress.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/materials/fixed_corotated.h>
#include <fem/materials/neo_hookean.h>
#include <fem/mesh/mesh_arrays.h>
#include <fem/mesh/truth_cube.h>

#include <cstring>
#include <vector>

#include "reference.h"

namespace physgen::fem {

/// The parameters of a kernel test.
template <class Real_, class Space_, class Layout_, template <class> class Model_>
struct KernelCase {
  using Real = Real_;
  using Space = Space_;
  using Layout = Layout_;
  using Model = Model_<Real_>;
};

namespace reference {

using Long = long double;
using Mat = Eigen::Matrix<Long, 3, 3>;
using Vec = Eigen::Matrix<Long, 3, 1>;

template <class R>
Mat stress(const NeoHookean<R>& m, const Mat& F) {
  const Mat inverse_transpose = F.inverse().transpose();
  return Long(m.mu) * (F - inverse_transpose) + Long(m.lambda) * std::log(F.determinant()) * inverse_transpose;
}
template <class R>
Mat stress(const FixedCorotated<R>& m, const Mat& F) {
  Mat rotation = F;  // polar decomposition by Newton's iteration
  for (int step = 0; step < 30; ++step) rotation = (rotation + rotation.inverse().transpose().eval()) / 2;
  const Long J = F.determinant();
  return 2 * Long(m.mu) * (F - rotation) + Long(m.lambda) * (J - 1) * J * F.inverse().transpose();
}

/// Nodes' forces from positions at rest and now.
template <class Model>
std::vector<Vec> forces(const Model& model, const TetMesh& mesh, const std::vector<Vec>& rest,
                        const std::vector<Vec>& x) {
  std::vector<Vec> f(rest.size(), Vec::Zero());
  for (const auto& tet : mesh.tets) {
    const auto at = [&tet](const std::vector<Vec>& v, std::size_t c) { return v[static_cast<std::size_t>(tet[c])]; };
    Mat Ds, Dm;
    for (std::size_t c = 1; c < 4; ++c) {
      Ds.col(int(c) - 1) = at(x, c) - at(x, 0);
      Dm.col(int(c) - 1) = at(rest, c) - at(rest, 0);
    }
    const Mat G = -Dm.determinant() / 6 * stress(model, Ds * Dm.inverse()) * Dm.inverse().transpose();
    for (std::size_t c = 1; c < 4; ++c) {
      f[static_cast<std::size_t>(tet[c])] += G.col(int(c) - 1);
      f[static_cast<std::size_t>(tet[0])] -= G.col(int(c) - 1);
    }
  }
  return f;
}

/// d/dh f(h) at 0 by a fourth-order difference; h scales the argument's direction.
template <class Function>
auto derivative(const Function& f, Long h) {
  using Value = decltype(f(h));
  const Value a = f(h), b = f(-h), c = f(2 * h), d = f(-2 * h);
  if constexpr (requires { a.size(), a[0].norm(), a.begin(); } && !requires { a.determinant(); }) {
    Value result = a;
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * h);
    return result;
  } else {
    return Value((8 * (a - b) - (c - d)) / (12 * h));
  }
}

}  // namespace reference

/// All arrays of a scene. Outputs are poisoned with NaN before kernels write them.
template <class Case>
class KernelScene {
 public:
  using Real = typename Case::Real;
  using Space = typename Case::Space;
  using Layout = typename Case::Layout;
  template <class Object>
  using Array = physgen::Array<Object, Real, Space, Layout>;
  template <class Object>
  using HostArray = physgen::Array<Object, Real, Host, Aos>;
  using Incidences = RowArrays<Array<elasticity::IncidenceRangeObject>, Array<elasticity::IncidenceObject>>;
  static constexpr Real eps = std::numeric_limits<Real>::epsilon();

  /// @param cells an odd count makes neither tets nor nodes a multiple of a pack
  explicit KernelScene(Index cells) : KernelScene(make_truth_cube(cells, reference::seed())) {}
  explicit KernelScene(TruthCube given) : cube(std::move(given)) {
    for (auto* points : {&cube.rest, &cube.deformed}) {
      for (Point& p : *points) {
        // To the scene's precision, and to a side of 1, so that tolerances need no units.
        for (double& x : p) x = static_cast<double>(static_cast<Real>(x / TruthCube::side));
      }
    }
    const auto count = [](const auto& list) { return static_cast<index_t>(list.size()); };
    HostArray<elasticity::TetObject> host_tets(count(cube.mesh.tets));
    store_tets(cube.mesh, host_tets.view());
    upload(tets, host_tets);
    HostArray<elasticity::EdgeObject> host_edges(count(cube.mesh.edges));
    store_edges(cube.mesh, host_edges.view());
    upload(edges, host_edges);
    node_tets = incidence_rows<Incidences>(cube.mesh.node_tets, tets.size());
    node_edges = incidence_rows<Incidences>(cube.mesh.node_edges, edges.size());
    edge_tets = incidence_rows<Incidences>(cube.mesh.edge_tets, tets.size());

    reference::Random random(77);
    HostArray<elasticity::NodeDisplacementObject> host_dx(nodes());
    for (index_t n = 0; n < nodes(); ++n) {
      for (int k = 0; k < 3; ++k) host_dx.view()[n].dx()[k] = static_cast<Real>(random.normal());
    }
    upload(displacements, host_dx);
    set_positions(rest_positions, cube.rest);
    set_positions(positions, cube.deformed);
  }

  [[nodiscard]] index_t nodes() const { return cube.mesh.nodes; }
  [[nodiscard]] index_t elements() const { return static_cast<index_t>(cube.mesh.tets.size()); }

  template <class Kernel>
  void run(index_t size, const Kernel& kernel) {
    parallel_for(Space{}, size, kernel);
  }

  template <class Object>
  void set_positions(Array<Object>& to, const std::vector<Point>& points) {
    HostArray<Object> host(static_cast<index_t>(points.size()));
    store_positions(points, host.view());
    upload(to, host);
  }

  /// From positions to forces and both forms of the force differential.
  void run_all(const typename Case::Model& model) {
    const index_t n = elements();
    for_all_outputs([this](auto& array, index_t size) { poison(array, size); });
    run(n, ComputeRestShape{tets.const_view(), rest_positions.const_view(), rest.view()});
    run(n, ComputeDeformationGradient{tets.const_view(), positions.const_view(), rest.const_view(), gradient.view()});
    run(n, ComputeSvd{gradient.const_view(), svd.view()});
    run(n, ComputeStress{model, svd.const_view(), stress.view()});
    run(n, ComputeStressDerivative{model, svd.const_view(), derivative.view()});
    run(n, ComputeDeformationGradientDifferential{tets.const_view(), displacements.const_view(), rest.const_view(),
                                                  gradient_differential.view()});
    run(n, ComputeStressDifferential{svd.const_view(), derivative.const_view(), gradient_differential.const_view(),
                                     stress_differential.view()});
    run(n, ComputeCornerForces{rest.const_view(), stress.const_view(), corner_forces.view()});
    run(nodes(), GatherForces{node_tets.const_view(), corner_forces.const_view(), forces.view()});
    run(n, ComputeTetStiffness{rest.const_view(), svd.const_view(), derivative.const_view(), tet_stiffness.view()});
    run(nodes(), GatherNodeStiffness{node_tets.const_view(), tet_stiffness.const_view(), node_stiffness.view()});
    run(edges.size(), GatherEdgeStiffness{edge_tets.const_view(), tet_stiffness.const_view(), edge_stiffness.view()});
    run(nodes(), ComputeForceDifferentials{node_stiffness.const_view(), edge_stiffness.const_view(), edges.const_view(),
                                           node_edges.const_view(), displacements.const_view(), assembled.view()});
    run(n, ComputeCornerForceDifferentials{tets.const_view(), displacements.const_view(), rest.const_view(),
                                           svd.const_view(), derivative.const_view(), corner_differentials.view()});
    run(nodes(),
        GatherForceDifferentials{node_tets.const_view(), corner_differentials.const_view(), matrix_free.view()});
  }

  /// A host copy to look into: download(array).view()[i].
  template <class Object>
  [[nodiscard]] HostArray<Object> download(const Array<Object>& array) const {
    HostArray<Object> host(array.size());
    copy(host, array);
    return host;
  }

  TruthCube cube;  ///< scaled to a side of 1 and rounded to Real
  Array<elasticity::TetObject> tets;
  Array<elasticity::EdgeObject> edges;
  Incidences node_tets, node_edges, edge_tets;
  Array<elasticity::NodePositionObject> rest_positions, positions;
  Array<elasticity::NodeDisplacementObject> displacements;
  Array<elasticity::RestShapeObject> rest;
  Array<elasticity::DeformationGradientObject> gradient;
  Array<elasticity::DeformationSvdObject> svd;
  Array<elasticity::StressObject> stress;
  Array<elasticity::StressDerivativeObject> derivative;
  Array<elasticity::DeformationGradientDifferentialObject> gradient_differential;
  Array<elasticity::StressDifferentialObject> stress_differential;
  Array<elasticity::CornerForcesObject> corner_forces, corner_differentials;
  Array<elasticity::TetStiffnessObject> tet_stiffness;
  Array<elasticity::NodeForceObject> forces;
  Array<elasticity::NodeStiffnessObject> node_stiffness;
  Array<elasticity::EdgeStiffnessObject> edge_stiffness;
  Array<elasticity::NodeForceDifferentialObject> assembled, matrix_free;

 private:
  template <class Object>
  static void upload(Array<Object>& to, const HostArray<Object>& from) {
    to.resize(from.size());
    copy(to, from);
  }

  template <class Object>
  static void poison(Array<Object>& array, index_t size) {
    HostArray<Object> host(size);
    std::memset(static_cast<void*>(host.view().data()), 0xff, static_cast<std::size_t>(size * host.record_bytes));
    upload(array, host);
  }

  template <class Function>
  void for_all_outputs(const Function& f) {
    const auto each = [&f](index_t size, auto&... arrays) { (f(arrays, size), ...); };
    each(elements(), rest, gradient, svd, stress, derivative, gradient_differential, stress_differential, corner_forces,
         corner_differentials, tet_stiffness);
    each(nodes(), forces, node_stiffness, assembled, matrix_free);
    each(edges.size(), edge_stiffness);
  }
};

}  // namespace physgen::fem
