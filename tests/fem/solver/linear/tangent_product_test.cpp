// Products from the tangents of tets and patches alone, without blocks of edges.
#include <cstdio>
#include <cstring>

#include "tangent_scene.h"

namespace physgen::fem {

namespace {

/// @param rounding of the sums, as a part of the largest
template <class Real>
void expect_that_tangents_give_the_assembled_product(const std::string& name, bool patches, double rounding) {
  SCOPED_TRACE(name + (patches ? ", patches" : ", tets"));
  const Volume volume = patches ? Volume::patches : Volume::tets;
  TangentScene<Real> assembled(volume), free(volume, TangentLists::of_nodes);
  const auto evaluator = make_evaluator<HostExecutor, typename TangentScene<Real>::Arrays>(name, {{1, 0.49}}, patches);
  for (TangentScene<Real>* scene : {&assembled, &free}) (void)scene->evaluate(*evaluator, scene->at);
  ASSERT_EQ(free.level.edges.size() + free.level.edge_stiffness.size() + free.arrays.edge_tet_entries.size(), 0);
  const Vectors expected = product(assembled, *evaluator, assembled.direction),
                found = product(free, *evaluator, free.direction);
  const double error = largest_difference(found, expected) / largest(expected);
  std::printf("%s, %s, %zu bytes: %.1e\n", name.c_str(), patches ? "patches" : "tets", sizeof(Real), error);
  EXPECT_GT(largest(expected), 0);
  EXPECT_LE(error, rounding);
  // Where the direction is the same everywhere, forces do not change; a power of two is subtracted without rounding.
  const Vectors translation(free.at.size(), Eigen::Vector3d(0.5, -1, 2));
  EXPECT_EQ(largest(product(free, *evaluator, translation)), 0);

  // Blocks of nodes, scaled, of which the inverses precondition.
  PreconditionerSettings settings;
  settings.kind = Preconditioner::block_jacobi;
  assemble(assembled.on, assembled.arrays, assembled.level, *evaluator, TangentFilter::none);
  prepare_level(assembled.on, assembled.level, settings, true);
  prepare_nodes(free.on, free.arrays, free.level, settings);
  for (index_t n = 0; n < free.arrays.nodes(); ++n) {
    EXPECT_EQ(free.level.scales.const_view()[n].scale(), assembled.level.scales.const_view()[n].scale());
    const Eigen::Matrix<Real, 3, 3> a = assembled.level.scaled_nodes.const_view()[n].K();
    const Eigen::Matrix<Real, 3, 3> b = free.level.node_stiffness.const_view()[n].K();
    EXPECT_LE((a - b).norm(), rounding * (1 + a.norm())) << n;
  }
}

TEST(MatrixFree, product_from_tangents_is_that_of_the_assembled_blocks) {
  for (const char* name : {"neo-hookean", "stable-neo-hookean", "mooney-rivlin", "fixed-corotated"}) {
    for (const bool patches : {false, true}) {
      if (patches && !can_average_volume(name)) continue;
      expect_that_tangents_give_the_assembled_product<double>(name, patches, 1e-14);
      expect_that_tangents_give_the_assembled_product<float>(name, patches, 3e-6);
    }
  }
}

/// An irregular block whose top is pushed down and aside.
Body pushed_block(bool patches) {
  Body body;
  body.levels = make_levels(TangentScene<>::tets(), 0, patches, [](const Point& x) -> std::uint8_t {
    return x[2] == 0 ? 7 : (x[2] == tangent_scene_side ? 5 : 0);  // aside along x; along y it may slide
  });
  body.loading.motion = at_nodes(body.levels[0].rest, [](const Point& x) {
    return x[2] == tangent_scene_side ? Point{0.3 * tangent_scene_side, 0, -tangent_scene_side} : Point{};
  });
  return body;
}

TEST(MatrixFree, newtons_method_finds_the_equilibrium_of_the_assembled_product) {
  for (const bool patches : {false, true}) {
    const Body body = pushed_block(patches);
    for (const auto precision : {TangentPrecision::half, TangentPrecision::float32, TangentPrecision::float64}) {
      for (const auto kind : {Preconditioner::none, Preconditioner::block_jacobi}) {
        SolverSettings settings;
        settings.poissons_ratio = patches ? 0.495 : 0.4;
        settings.precision = precision;
        settings.newton.preconditioner.kind = kind;
        settings.newton.tolerance = 1e-10;
        const auto assembled = make_solver(body.levels, body.loading, settings);
        settings.newton.product = Product::matrix_free;
        const auto free = make_solver(body.levels, body.loading, settings);
        // Without preconditioner rounding alone changes some of over 600 by 9 %: sums begin with the large patches.
        const bool is_rounded = patches && kind == Preconditioner::none && precision != TangentPrecision::float64;
        for (const double load : {0.1, 0.2}) {  // the second from an equilibrium: K d of the increment
          const NewtonResult a = assembled->solve_to(load, {}), b = free->solve_to(load, {});
          ASSERT_EQ(a.status, NewtonStatus::converged);
          ASSERT_EQ(b.status, NewtonStatus::converged);
          EXPECT_NEAR(b.steps, a.steps, 1);
          EXPECT_NEAR(b.iterations, a.iterations, (is_rounded ? 0.1 : 0.05) * a.iterations + 3);
          EXPECT_NEAR(b.energy / a.energy, 1, 1e-10);
        }
        EXPECT_LE(largest_distance(free->positions(), assembled->positions()), 1e-7 * tangent_scene_side);
        EXPECT_LT(free->bytes(), assembled->bytes());
      }
    }
  }
}

TEST(MatrixFree, coarser_meshes_are_solved_on_first_without_blocks_too) {
  const Body body = make_truth_cube_body(16, true);
  SolverSettings settings;
  settings.poissons_ratio = 0.45;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.newton.tolerance = 1e-8;
  const auto assembled = make_solver(body.levels, body.loading, settings);
  settings.newton.product = Product::matrix_free;
  const auto free = make_solver(body.levels, body.loading, settings);
  const NewtonResult a = assembled->solve_to(0.05, {}), b = free->solve_to(0.05, {});
  ASSERT_EQ(b.status, NewtonStatus::converged);
  EXPECT_GT(b.coarse_steps, 0);
  EXPECT_EQ(b.coarse_steps, a.coarse_steps);
  EXPECT_LE(largest_distance(free->positions(), assembled->positions()), 1e-7 * tangent_scene_side);
}

TEST(MatrixFree, product_is_refused_where_volumes_are_averaged_at_nodes) {
  Body body = make_truth_cube_body(4, false);
  body.levels = with(Volume::nodes, std::move(body.levels));
  SolverSettings settings;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.newton.product = Product::matrix_free;
  try {
    (void)make_solver(body.levels, body.loading, settings);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("volumes averaged at nodes require the assembled product"),
              std::string::npos)
        << error.what();
  }
}

TEST(MatrixFree, product_is_refused_with_multigrid) {
  const Body body = make_truth_cube_body(4, false);
  SolverSettings settings;
  settings.newton.product = Product::matrix_free;
  try {
    (void)make_solver(body.levels, body.loading, settings);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("requires one of the preconditioners block-jacobi or none"),
              std::string::npos);
  }
}

/// @pre `lists` are of what `volume` can be averaged with
template <class Real>
void expect_that_chunks_change_no_bit(Volume volume, TangentLists lists) {
  SCOPED_TRACE(std::string(name_of(volume)) + (lists == TangentLists::of_edges ? ", assembled, " : ", by tets, ") +
               std::to_string(sizeof(Real)) + " bytes");
  TangentScene<Real> scene(volume, lists);
  const auto evaluator = make_evaluator<HostExecutor, typename TangentScene<Real>::Arrays>(
      "stable-neo-hookean", {{1, 0.49}}, volume != Volume::tets);
  (void)scene.evaluate(*evaluator, scene.at);
  ASSERT_EQ(scene.arrays.chunks.size(), 1U);
  const Vectors expected = product(scene, *evaluator, scene.direction);
  for (const index_t count : {2, 3, 7}) {
    scene.arrays.chunks =
        make_tet_chunks(scene.levels[0].mesh, scene.graph.edges, (scene.arrays.tet_count() + count - 1) / count);
    ASSERT_EQ(scene.arrays.chunks.size(), std::size_t(count));
    const Vectors found = product(scene, *evaluator, scene.direction);
    for (std::size_t n = 0; n < expected.size(); ++n) {
      EXPECT_EQ(std::memcmp(found[n].data(), expected[n].data(), sizeof found[n]), 0) << count << " chunks, node " << n;
    }
  }
}

TEST(TangentProduct, has_the_same_bits_for_any_number_of_chunks_of_tets) {
  for (const Volume volume : volumes) {
    expect_that_chunks_change_no_bit<double>(volume, TangentLists::of_edges);
    expect_that_chunks_change_no_bit<float>(volume, TangentLists::of_edges);
    if (volume == Volume::nodes) continue;  // refused by tets
    expect_that_chunks_change_no_bit<double>(volume, TangentLists::of_nodes);
    expect_that_chunks_change_no_bit<float>(volume, TangentLists::of_nodes);
  }
}

}  // namespace
}  // namespace physgen::fem
