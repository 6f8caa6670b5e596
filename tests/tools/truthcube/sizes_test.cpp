// The sizes and bytes that truthcube states before anything is allocated, against those that are allocated then.
#include <fem/dynamics/explicit.h>
#include <fem/mesh/boundary.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <truthcube/arrays.h>
#include <truthcube/output/window.h>
#include <truthcube/run_bytes.h>
#include <truthcube/state_windows.h>

#include <numeric>
#include <string>

namespace physgen::truthcube {
namespace {

std::vector<fem::MeshLevel> levels_of(int cells, VolumeTreatment volume) {
  auto levels = fem::make_cube_levels(cells, 0.08, volume == VolumeTreatment::patches);
  for (fem::MeshLevel& level : levels) level.averages_at_nodes = volume == VolumeTreatment::nodes;
  return levels;
}

std::string name_of(VolumeTreatment volume) {
  if (volume == VolumeTreatment::nodes) return "nodes";
  return volume == VolumeTreatment::patches ? "patches" : "tets";
}

TEST(Sizes, of_cubes_are_those_of_their_meshes) {
  for (const VolumeTreatment volume : {VolumeTreatment::tets, VolumeTreatment::patches, VolumeTreatment::nodes}) {
    for (const int cells : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 18, 23, 24}) {
      EXPECT_EQ(count_cube(cells, volume), count_levels(levels_of(cells, volume)))
          << cells << " cells, " << name_of(volume);
    }
  }
}

struct Case {
  int cells;
  VolumeTreatment volume;
};

class Bytes : public ::testing::TestWithParam<Case> {
 protected:
  // The bottom and the top are held, and planes where there are some; nothing is solved.
  static std::int64_t allocated(const fem::SolverSettings& settings, std::int64_t planes) {
    std::vector<fem::MeshLevel> levels = levels_of(GetParam().cells, GetParam().volume);
    for (fem::MeshLevel& level : levels) {
      for (std::size_t n = 0; n < level.rest.size(); ++n) {
        if (level.rest[n][2] == 0 || level.rest[n][2] == 0.08) level.fixed[n] = 7;
      }
    }
    fem::Loading loading{std::vector<fem::Point>(levels.front().rest.size(), fem::Point{}), {}};
    loading.planes.assign(static_cast<std::size_t>(planes), {{0, 0, 1}, 0, 0});
    return fem::make_solver(levels, loading, settings)->bytes();
  }
  static std::int64_t predicted(const fem::SolverSettings& settings, std::int64_t planes) {
    const RunBytes bytes = bytes_of_run(count_cube(GetParam().cells, GetParam().volume), settings, {.planes = planes});
    EXPECT_EQ(std::accumulate(bytes.levels.begin(), bytes.levels.end(), std::int64_t{0}), bytes.solver);
    return bytes.solver;
  }
  static void expect_equal(const fem::SolverSettings& settings) {
    EXPECT_EQ(predicted(settings, 0), allocated(settings, 0));
    const std::int64_t of_contact = allocated(settings, 2) - allocated(settings, 0);
    EXPECT_GT(of_contact, 0);
    EXPECT_EQ(predicted(settings, 2) - predicted(settings, 0), of_contact);
  }
};

TEST_P(Bytes, of_pressures_that_follow_the_surface_are_those_of_the_solver) {
  const std::vector<fem::MeshLevel> levels = levels_of(GetParam().cells, GetParam().volume);
  fem::Loading loading{std::vector<fem::Point>(levels.front().rest.size(), fem::Point{}), {}};
  loading.pressures.push_back({fem::boundary_faces(levels.front().mesh), 1});
  fem::SolverSettings settings;
  settings.nested = false;
  const auto faces = static_cast<std::int64_t>(loading.pressures[0].faces.size());
  const std::int64_t bytes =
      bytes_of_run(count_cube(GetParam().cells, GetParam().volume), settings, {.faces = faces}).solver;
  EXPECT_EQ(bytes, fem::make_solver(levels, loading, settings)->bytes());
  EXPECT_GT(bytes, predicted(settings, 0));
}

TEST_P(Bytes, of_each_precision_are_those_of_the_solver) {
  for (const auto precision :
       {fem::TangentPrecision::half, fem::TangentPrecision::float32, fem::TangentPrecision::float64}) {
    SCOPED_TRACE(static_cast<int>(precision));
    fem::SolverSettings settings;
    settings.precision = precision;
    expect_equal(settings);
  }
}

TEST_P(Bytes, without_coarser_levels_are_those_of_the_solver) {
  fem::SolverSettings settings;
  settings.nested = false;
  settings.newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
  expect_equal(settings);
  EXPECT_EQ(bytes_of_run(count_cube(GetParam().cells, GetParam().volume), settings).levels.size(), 1U);
}

TEST_P(Bytes, of_products_without_blocks_of_edges_are_those_of_the_solver_and_fewer) {
  for (const bool nested : {false, true}) {
    for (const auto kind : {fem::Preconditioner::none, fem::Preconditioner::block_jacobi}) {
      fem::SolverSettings settings;
      settings.nested = nested;
      settings.newton.preconditioner.kind = kind;
      const std::int64_t assembled = allocated(settings, 0);
      const RunBytes lists = bytes_of_run(count_cube(GetParam().cells, GetParam().volume), settings);
      settings.newton.product = fem::Product::matrix_free;
      if (GetParam().volume == VolumeTreatment::nodes) {
        EXPECT_THROW((void)allocated(settings, 0), Error);
        continue;
      }
      const std::int64_t real = allocated(settings, 0);
      EXPECT_EQ(predicted(settings, 0), real);
      EXPECT_LT(real, assembled);
      EXPECT_LT(bytes_of_run(count_cube(GetParam().cells, GetParam().volume), settings).lists, lists.lists);
    }
  }
}

/// The arrays of a run of a scene, where nothing else is asked for than settings say.
RunArrays arrays_for(SceneKind scene, const fem::SolverSettings& settings, VolumeTreatment volume) {
  Options options;
  options.scene = scene;
  options.solver = settings;
  options.volume = volume;
  return {scene, arrays_of(options)};
}

TEST_P(Bytes, of_other_scenes_are_those_of_their_solvers) {
  const VolumeTreatment volume = GetParam().volume;
  const std::vector<fem::MeshLevel> levels = levels_of(GetParam().cells, volume);
  const auto counts = count_cube(GetParam().cells, volume);
  const fem::Loading loading{std::vector<fem::Point>(levels.front().rest.size(), fem::Point{}), {}};
  for (const auto precision :
       {fem::TangentPrecision::half, fem::TangentPrecision::float32, fem::TangentPrecision::float64}) {
    fem::DynamicSettings settings;
    settings.solver.precision = precision;
    settings.solver.nested = false;
    const auto predicted = [&](SceneKind scene) {
      return bytes_of_run(counts, settings.solver, arrays_for(scene, settings.solver, volume)).solver;
    };
    EXPECT_EQ(predicted(SceneKind::implicit_dynamics), fem::make_implicit_solver(levels, loading, settings)->bytes());
    if (volume != VolumeTreatment::tets) continue;
    EXPECT_EQ(predicted(SceneKind::explicit_dynamics),
              fem::make_explicit_solver(levels.front(), loading, settings)->bytes());
    EXPECT_EQ(predicted(SceneKind::linear_elastic), fem::make_linear_solver(levels, loading, settings.solver)->bytes());
    settings.solver.newton.product = fem::Product::matrix_free;
    settings.solver.newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
    EXPECT_EQ(predicted(SceneKind::linear_elastic), fem::make_linear_solver(levels, loading, settings.solver)->bytes());
  }
}

TEST(Sizes, of_explicit_steps_in_a_fixed_order_on_cuda_have_places_of_forces_besides) {
  const auto counts = count_cube(8, VolumeTreatment::tets);
  fem::SolverSettings settings;
  settings.precision = fem::TangentPrecision::float32;
  const auto bytes = [&](fem::Device device, bool fixed_order) {
    settings.device = device;
    return bytes_of_run(
               counts, settings,
               {.scene = SceneKind::explicit_dynamics, .names = "explicit_dynamics", .fixed_order = fixed_order})
        .solver;
  };
  // Four places and four forces, padded, of a tet; where the row of a node begins and ends, in tiles of 32 nodes.
  EXPECT_EQ(bytes(fem::Device::cuda, true) - bytes(fem::Device::cuda, false),
            counts.front().tets * (4 * 4 + 4 * 16) + (counts.front().nodes + 31) / 32 * 32 * 2 * 4);
  EXPECT_EQ(bytes(fem::Device::cpu, true), bytes(fem::Device::cpu, false));
}

TEST_P(Bytes, of_scenes_are_those_of_the_solvers_that_run_them_alone) {
  const VolumeTreatment volume = GetParam().volume;
  const std::vector<fem::MeshLevel> levels = levels_of(GetParam().cells, volume);
  const auto counts = count_cube(GetParam().cells, volume);
  const fem::Loading loading{std::vector<fem::Point>(levels.front().rest.size(), fem::Point{}), {}};
  fem::SolverSettings settings;
  settings.precision = fem::TangentPrecision::float32;
  const auto expect_bytes = [&](SceneKind scene) {
    const RunArrays arrays = arrays_for(scene, settings, volume);
    EXPECT_EQ(bytes_of_run(counts, settings, arrays).solver,
              fem::make_scene_solver(arrays.names, levels, loading, settings)->bytes())
        << arrays.names;
  };
  for (const bool nested : {false, true}) {
    settings.nested = nested;
    settings.newton.product = fem::Product::assembled;
    settings.newton.preconditioner.kind = fem::Preconditioner::multigrid;
    settings.material = "stable-neo-hookean";
    if (volume != VolumeTreatment::nodes) expect_bytes(SceneKind::quasistatic);
    settings.material = "fixed-corotated";
    if (volume == VolumeTreatment::tets) expect_bytes(SceneKind::quasistatic_fixed_corotated);
    settings.newton.product = fem::Product::matrix_free;
    settings.newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
    settings.material = "stable-neo-hookean";
    if (volume == VolumeTreatment::patches) expect_bytes(SceneKind::quasistatic_matrix_free);
  }
  if (volume == VolumeTreatment::nodes) return;
  settings.nested = false;
  for (const auto kind : {fem::Preconditioner::multigrid, fem::Preconditioner::none}) {
    fem::DynamicSettings motion;
    motion.solver = settings;
    motion.solver.newton.product = fem::Product::assembled;
    motion.solver.newton.preconditioner.kind = kind;
    const RunArrays arrays = arrays_for(SceneKind::implicit_dynamics, motion.solver, volume);
    EXPECT_EQ(arrays.names, "implicit_dynamics");
    EXPECT_EQ(bytes_of_run(counts, motion.solver, arrays).solver,
              fem::make_scene_implicit_solver(levels, loading, motion)->bytes());
  }
}

/// Its blocks take no place for nodes that plates hold, which are many in small cubes and are not known before.
TEST_P(Bytes, with_schwarz_blocks_are_those_of_the_solver_or_a_little_more) {
  for (const auto precision : {fem::TangentPrecision::half, fem::TangentPrecision::float64}) {
    for (const bool nested : {false, true}) {
      fem::SolverSettings settings;
      settings.precision = precision;
      settings.nested = nested;
      settings.newton.preconditioner.kind = fem::Preconditioner::schwarz;
      const auto real = static_cast<double>(allocated(settings, 0)), most = static_cast<double>(predicted(settings, 0));
      EXPECT_GE(most, real);
      EXPECT_LE(most, (GetParam().cells < 12 ? 1.15 : 1.05) * real);
      fem::SolverSettings without = settings;
      without.newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
      EXPECT_GT(real, static_cast<double>(allocated(without, 0)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cubes, Bytes,
                         ::testing::Values(Case{4, VolumeTreatment::tets}, Case{4, VolumeTreatment::patches},
                                           Case{4, VolumeTreatment::nodes}, Case{8, VolumeTreatment::tets},
                                           Case{8, VolumeTreatment::patches}, Case{8, VolumeTreatment::nodes},
                                           Case{9, VolumeTreatment::patches}, Case{9, VolumeTreatment::nodes},
                                           Case{12, VolumeTreatment::tets}, Case{12, VolumeTreatment::patches},
                                           Case{16, VolumeTreatment::tets}, Case{16, VolumeTreatment::patches},
                                           Case{16, VolumeTreatment::nodes}, Case{24, VolumeTreatment::tets},
                                           Case{24, VolumeTreatment::patches}),
                         [](const auto& info) {
                           return std::to_string(info.param.cells) + "_" + name_of(info.param.volume);
                         });

TEST(Sizes, of_a_mesh_on_a_background_grid_are_those_of_the_solver) {
  for (const bool patches : {false, true}) {
    for (const int levels_of_meshes : {1, 2}) {
      std::vector<fem::MeshLevel> levels = fem::make_cube_levels(14, 0.08, patches);
      if (levels_of_meshes == 1) {
        levels.resize(1);
        levels[0].parents.clear();
        levels[0].patch_parents.clear();
      }
      for (fem::MeshLevel& level : levels) {
        for (std::size_t n = 0; n < level.rest.size(); ++n) level.fixed[n] = level.rest[n][2] == 0 ? 7 : 0;
      }
      (void)fem::add_background_grid(levels);
      ASSERT_GT(static_cast<int>(levels.size()), levels_of_meshes);
      const fem::Loading loading{std::vector<fem::Point>(levels.front().rest.size(), fem::Point{}), {}};
      for (const auto precision : {fem::TangentPrecision::half, fem::TangentPrecision::float64}) {
        fem::SolverSettings settings;
        settings.precision = precision;
        settings.coarsest_nested = 0;
        EXPECT_EQ(bytes_of_run(count_levels(levels), settings).solver,
                  fem::make_solver(levels, loading, settings)->bytes());
      }
    }
  }
}

TEST(Sizes, of_lists_contain_the_meshes_of_all_levels) {
  const auto counts = count_cube(8, VolumeTreatment::patches);
  std::int64_t meshes = 0;
  for (const LevelCounts& level : counts) meshes += bytes_of_mesh(level);
  EXPECT_GT(bytes_of_run(counts, {}).lists, meshes);
}

TEST(Sizes, of_windows_fit_the_bytes_of_a_window_and_a_small_mesh) {
  const WindowSizes windows(window_bytes);
  EXPECT_LE(windows.bytes(1'000'000'000, 1'000'000'000), window_bytes);
  EXPECT_GT(windows.bytes(1'000'000'000, 1'000'000'000), window_bytes - 1000);
  EXPECT_EQ(windows.bytes(windows.nodes() + 1, windows.tets() + 1), windows.bytes(windows.nodes(), windows.tets()));
  EXPECT_LT(windows.bytes(windows.nodes() - 1, windows.tets()), windows.bytes(windows.nodes(), windows.tets()));
  EXPECT_LT(windows.bytes(windows.nodes(), windows.tets() - 1), windows.bytes(windows.nodes(), windows.tets()));
  // Of a tet: its number, four nodes that no other has, its stress, twice, six components, von Mises' stress and J.
  constexpr std::size_t of_node = 2 * sizeof(fem::Point) + 2 * sizeof(fem::Index);
  constexpr std::size_t of_tet = sizeof(fem::Index) + 4 * of_node + (2 * 9 + 8) * sizeof(double);
  EXPECT_GE(windows.bytes(0, 1), of_tet);
  // Of a node: its number, its position, twice, displacement and pressure, and a volume.
  EXPECT_GE(windows.bytes(1, 0), sizeof(fem::Index) + 2 * sizeof(fem::Point) + (3 + 1 + 1) * sizeof(double));
}

}  // namespace
}  // namespace physgen::truthcube
