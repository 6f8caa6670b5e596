// The fused groups of fem/kernels/groups.h against the same kernels over arrays: one source for packs, single objects
// and CUDA. Included behind parallel_for.h or cuda/parallel_for.h.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/groups.h>
#include <fem/materials/materials.h>
#include <fem/mesh/mesh_arrays.h>
#include <fem/mesh/truth_cube.h>
#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace physgen::fem {

/// A small Truth Cube, with all that its kernels store when they run one after the other.
/// @tparam Run_ Run_::over(begin, end, kernel)
template <class Real_, class Space, class Layout, class Run_>
struct FusedCase {
  using Real = Real_;
  using Run = Run_;
  template <class Object>
  using Array = physgen::Array<Object, Real, Space, Layout>;
  template <class Object>
  using There = physgen::Array<Object, Real, Host, Aos>;
  using Incidences = RowArrays<Array<elasticity::IncidenceRangeObject>, Array<elasticity::IncidenceObject>>;

  TruthCube cube = make_truth_cube(3, 20100622);
  index_t tet_count = static_cast<index_t>(cube.mesh.tets.size()), node_count = cube.mesh.nodes;
  Array<elasticity::TetObject> tets{tet_count};
  Array<elasticity::NodePositionObject> at_rest{node_count}, positions{node_count};
  Array<elasticity::NodeDisplacementObject> displacements{node_count};
  Array<elasticity::RestShapeObject> rest{tet_count};
  Incidences node_tets = incidence_rows<Incidences>(cube.mesh.node_tets, tet_count);
  Array<elasticity::TetPlacesObject> places{tet_count};
  Array<elasticity::DeformationGradientObject> gradients{tet_count};
  Array<elasticity::DeformationSvdObject> svds{tet_count};
  Array<elasticity::StressObject> stresses{tet_count};
  Array<elasticity::StressDerivativeObject> derivatives{tet_count};
  Array<elasticity::PrincipalDirectionsObject> directions{tet_count};
  Array<elasticity::CornerForcesObject> corners{tet_count};

  FusedCase() {
    There<elasticity::TetObject> host_tets(tet_count);
    store_tets(cube.mesh, host_tets.view());
    copy(tets, host_tets);
    const auto send = [](auto& to, const std::vector<Point>& points, double noise) {
      std::mt19937 random(7);
      std::uniform_real_distribution<double> uniform(-noise, noise);
      There<elasticity::NodePositionObject> host(static_cast<index_t>(points.size()));
      std::vector<Point> moved = points;
      for (Point& p : moved) {
        for (double& x : p) x = x / TruthCube::side + uniform(random);
      }
      store_positions(moved, host.view());
      copy(to, host);
    };
    send(at_rest, cube.rest, 0);
    send(positions, cube.deformed, 0.02);
    There<elasticity::NodeDisplacementObject> host_displacements(node_count);
    for (index_t n = 0; n < node_count; ++n) {
      for (int k = 0; k < 3; ++k) {
        host_displacements.view()[n].dx()[k] = static_cast<Real>(std::sin(static_cast<double>(3 * n + k)));
      }
    }
    copy(displacements, host_displacements);
    Run::over(0, tet_count, ComputeRestShape{tets.const_view(), at_rest.const_view(), rest.view()});
    Run::one_by_one(4 * tet_count, FindPlaces{node_tets.const_view().entries(), places.view()});
  }

  /// The kernels of a Newton update, each of which stores what the next ones read.
  template <class Model>
  void run_separately(const Model& model) {
    const index_t n = tet_count;
    Run::over(
        0, n,
        ComputeDeformationGradient{tets.const_view(), positions.const_view(), rest.const_view(), gradients.view()});
    Run::over(0, n, ComputeSvd{gradients.const_view(), svds.view()});
    Run::over(0, n, KeepDirections{svds.const_view(), directions.view()});
    Run::over(0, n, ComputeStressDerivative{model, svds.const_view(), derivatives.view(), ClampEigenvalues{}});
    Run::over(0, n, ComputeStress{model, svds.const_view(), stresses.view()});
    Run::over(0, n, ComputeCornerForces{rest.const_view(), stresses.const_view(), corners.view()});
  }

  /// An array whose bytes are all ones: NaN.
  template <class Object>
  static Array<Object> poisoned(index_t size) {
    There<Object> host(size);
    std::memset(static_cast<void*>(host.view().data()), 0xff, static_cast<std::size_t>(size * host.record_bytes));
    Array<Object> array(size);
    copy(array, host);
    return array;
  }

  /// Whether objects of the range have the bits of `wanted`, and the others those of poisoned().
  template <class Object>
  static void expect_bits(const Array<Object>& got, const Array<Object>& wanted, index_t begin, index_t end,
                          const std::string& what) {
    There<Object> a(got.size()), b(got.size());
    copy(a, got);
    copy(b, wanted);
    synchronize();
    constexpr int bytes = There<Object>::record_bytes;
    const std::vector<std::byte> poison(bytes, std::byte{0xff});
    for (index_t i = 0; i < got.size(); ++i) {
      const std::byte* expected = begin <= i && i < end ? b.view().data() + i * bytes : poison.data();
      ASSERT_EQ(std::memcmp(a.view().data() + i * bytes, expected, bytes), 0)
          << Object::name << " " << i << " of " << begin << " to " << end << ", " << what;
    }
  }
};

/// A Newton update keeps directions, the derivative and corner forces.
template <class Case, class Model>
void check_newton_update(Case& scene, const Model& model, std::mt19937& random) {
  scene.run_separately(model);
  for (index_t i = 0; i < scene.tet_count; ++i) {
    ASSERT_TRUE(std::isfinite(scene.corners.getdata(i, 8)) && std::isfinite(scene.derivatives.getdata(i, 11)));
  }
  for (index_t n = 1; n <= 70; ++n) {
    index_t begin = 0, end = n;
    if (n % 2 == 0) {
      std::tie(begin, end) = std::minmax(
          {static_cast<index_t>(random()) % scene.tet_count, static_cast<index_t>(random()) % scene.tet_count});
    }
    auto directions = Case::template poisoned<elasticity::PrincipalDirectionsObject>(scene.tet_count);
    auto derivatives = Case::template poisoned<elasticity::StressDerivativeObject>(scene.tet_count);
    auto corners = Case::template poisoned<elasticity::CornerForcesObject>(scene.tet_count);
    Case::Run::over(begin, end,
                    fuse_newton_update(model, scene.tets.const_view(), scene.positions.const_view(),
                                       scene.rest.const_view(), directions.view(), derivatives.view(), corners.view()));
    Case::expect_bits(directions, scene.directions, begin, end, Model::name);
    Case::expect_bits(derivatives, scene.derivatives, begin, end, Model::name);
    Case::expect_bits(corners, scene.corners, begin, end, Model::name);
    if (testing::Test::HasFatalFailure()) return;
  }
}

template <class Case>
void check_materials() {
  using Real = typename Case::Real;
  Case scene;
  std::mt19937 random(11);
  [&]<class... Models>(MaterialList<Models...> /*all*/) {
    (check_newton_update(scene, Models::from(1, 0.3), random), ...);
  }(AllMaterials<Real>{});
}

/// Sums of a whole mesh at its nodes.
template <class Case>
void check_sums() {
  using Real = typename Case::Real;
  using Forces = elasticity::NodeForceObject;
  Case scene;
  const auto model = NeoHookean<Real>::from(1, 0.3);
  const index_t n = scene.tet_count, nodes = scene.node_count;
  scene.run_separately(model);
  auto gathered = Case::template poisoned<Forces>(nodes);
  Case::Run::one_by_one(nodes, GatherForces{scene.node_tets.const_view(), scene.corners.const_view(), gathered.view()});

  const auto tets = scene.tets.const_view();
  const auto positions = scene.positions.const_view();
  const auto rest = scene.rest.const_view();
  auto corners = Case::template poisoned<elasticity::CornerForcesObject>(n);
  Case::Run::over(0, n, fuse_corner_forces(model, tets, positions, rest, corners.view()));
  Case::expect_bits(corners, scene.corners, 0, n, "at corners");

  // In the order of the rows: the bits of the gather.
  auto placed = Case::template poisoned<elasticity::PlacedForceObject>(4 * n);
  auto ordered = Case::template poisoned<Forces>(nodes);
  Case::Run::over(0, n, fuse_placed_forces(model, tets, positions, rest, scene.places.const_view(), placed.view()));
  const SumRowForces sum_rows{scene.node_tets.const_view().ranges(), placed.const_view(), ordered.view()};
  Case::Run::one_by_one(sum_rows.size(), sum_rows);
  Case::expect_bits(ordered, gathered, 0, nodes, "in a fixed order");

  // In an order that is open: the same to rounding, of parts of the mesh that follow each other, too.
  auto added = Case::template poisoned<Forces>(nodes);
  Case::Run::over(0, nodes, ClearNodes{added.view()});
  const index_t middle = n / 3;
  const auto add_forces = fuse_added_forces(model, tets, positions, rest, added.view());
  Case::Run::over(0, middle, add_forces);
  Case::Run::over(middle, n, add_forces);

  // The differentials of forces.
  auto gathered_differentials = Case::template poisoned<elasticity::NodeForceDifferentialObject>(nodes);
  auto added_differentials = gathered_differentials;
  auto changes = Case::template poisoned<elasticity::CornerForcesObject>(n);
  const auto displacements = scene.displacements.const_view();
  const auto directions = scene.directions.const_view();
  const auto derivatives = scene.derivatives.const_view();
  Case::Run::over(0, n,
                  ComputeCornerForceDifferentials{tets, displacements, rest, directions, derivatives, changes.view()});
  Case::Run::one_by_one(nodes, GatherForceDifferentials{scene.node_tets.const_view(), changes.const_view(),
                                                        gathered_differentials.view()});
  Case::Run::over(0, nodes, ClearNodes{added_differentials.view()});
  Case::Run::over(
      0, n, fuse_added_differentials(tets, displacements, rest, directions, derivatives, added_differentials.view()));
  synchronize();

  double largest = 0, largest_differential = 0;
  for (index_t i = 0; i < nodes; ++i) {
    for (int k = 0; k < 3; ++k) {
      largest = std::max(largest, std::abs(gathered.getdata(i, k)));
      largest_differential = std::max(largest_differential, std::abs(gathered_differentials.getdata(i, k)));
    }
  }
  EXPECT_GT(largest, 1e-4);
  EXPECT_GT(largest_differential, 1e-4);
  const double eps = std::numeric_limits<Real>::epsilon();
  for (index_t i = 0; i < nodes; ++i) {
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(added.getdata(i, k), gathered.getdata(i, k), 32 * eps * largest) << i;
      ASSERT_NEAR(added_differentials.getdata(i, k), gathered_differentials.getdata(i, k),
                  32 * eps * largest_differential)
          << i;
    }
  }
}

}  // namespace physgen::fem
