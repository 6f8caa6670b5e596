// The Truth Cube against displacements and reactions of another finite element code: see oracle/README.md.
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "bodies.h"

namespace physgen::fem {
namespace {

struct Bead {
  Point rest, displacement;  // [m]
};

std::vector<Bead> read_oracle(const std::string& name) {
  std::ifstream file(std::string(PHYSGEN_ORACLE_FOLDER) + "/" + name);
  std::string line;
  std::getline(file, line);
  std::vector<Bead> beads;
  while (std::getline(file, line)) {
    std::istringstream numbers(line);
    std::array<double, 6> v{};
    char comma = 0;
    for (double& number : v) {
      numbers >> number;
      numbers >> comma;
    }
    beads.push_back({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}});
  }
  EXPECT_EQ(beads.size(), 343) << name;
  return beads;
}

struct Found {
  double rms, max;      // [mm]
  double reaction;      // over E [m^2]
  double extrapolated;  // from half as many cells, with first order
  double estimate;      // of the RMS, from half as many cells [mm]
  double drift;         // to a side, the mean of all beads [mm]
};

/// Beads lie at nodes, where cells are a multiple of 8.
std::vector<Found> compress(Index cells, Volume volume, bool frictionless, double poissons_ratio) {
  const Body body = with(volume, make_truth_cube_body(cells, volume == Volume::patches, frictionless));
  SolverSettings settings;
  settings.material = "neo-hookean";
  settings.poissons_ratio = poissons_ratio;
  settings.newton.tolerance = 1e-6;
  const auto solver = make_solver(body.levels, body.loading, settings);
  std::vector<Found> found;
  for (const char* compression : {"0.05", "0.125", "0.1825"}) {
    EXPECT_EQ(solver->solve_to(std::stod(compression), {}).status, NewtonStatus::converged);
    const auto positions = solver->positions(), forces = solver->forces();
    const auto& rest = body.levels[0].rest;
    Found f{};
    double sum = 0;
    std::array<double, 2> moved{};
    const auto beads =
        read_oracle(std::string("0.49_") + (frictionless ? "frictionless" : "bonded") + "_" + compression + ".csv");
    for (const Bead& bead : beads) {
      const auto at = [&](int k) { return std::lround(bead.rest[std::size_t(k)] / 0.08 * cells); };
      const auto node = static_cast<std::size_t>(at(0) + (cells + 1) * (at(1) + (cells + 1) * at(2)));
      for (std::size_t k = 0; k < 2; ++k) moved[k] += 1e3 * (positions[node][k] - rest[node][k]);
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(rest[node][k], bead.rest[k], 1e-12);
        const double difference = 1e3 * (positions[node][k] - rest[node][k] - bead.displacement[k]);
        square += difference * difference;
      }
      sum += square;
      f.max = std::max(f.max, std::sqrt(square));
    }
    f.rms = std::sqrt(sum / double(beads.size()));
    f.drift = std::hypot(moved[0], moved[1]) / double(beads.size());
    for (std::size_t n = 0; n < forces.size(); ++n) {
      if (rest[n][2] == 0.08) f.reaction -= forces[n][2];
    }
    const auto coarser = solver->coarser_equilibrium();
    found.push_back(f);
    if (!coarser) continue;  // eight cells: the coarser mesh is too coarse for an equilibrium
    f.extrapolated = 2 * f.reaction;
    double squares = 0, common = 0;
    for (std::size_t n = 0; n < forces.size(); ++n) {
      const auto [first, second] = body.levels[0].parents[n];
      if (first != second) continue;
      const auto parent = std::size_t(first);
      const Point& at = body.levels[1].rest[parent];
      if (at[2] == 0.08) f.extrapolated += coarser->forces[parent][2];
      for (std::size_t k = 0; k < 3; ++k) {
        squares += std::pow(1e3 * (positions[n][k] - rest[n][k] - coarser->positions[parent][k] + at[k]), 2);
      }
      ++common;
    }
    f.estimate = std::sqrt(squares / common);
    std::printf(
        "%3d cells, %s, %s, compressed by %s: RMS %.4f mm, max %.4f mm, reaction / E %.6g m^2, extrapolated %.6g m^2, "
        "RMS "
        "estimated %.4f mm\n",
        int(cells), name_of(volume), frictionless ? "frictionless" : "bonded", compression, f.rms, f.max, f.reaction,
        f.extrapolated, f.estimate);
    found.back() = f;
  }
  return found;
}

TEST(Oracle, beads_of_16_cells_with_patches_lie_where_the_oracle_has_them_between_bonded_plates) {
  const auto found = compress(16, Volume::patches, false, 0.49);
  EXPECT_LE(found[0].rms, 0.14 * 0.05 / 0.1825);
  EXPECT_LE(found[1].rms, 0.14 * 0.125 / 0.1825);
  EXPECT_LE(found[2].rms, 0.14);
  const double reactions[] = {-4.1053e-4, -11.087e-4, -17.108e-4};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found[k].reaction / reactions[k], 1, 0.055) << k;
    EXPECT_NEAR(found[k].extrapolated / reactions[k], 1, 0.015) << k;
    // It is of all nodes, and no bead lies at the plates' edges, where errors are largest.
    EXPECT_GE(found[k].estimate, found[k].rms) << k;
    EXPECT_LE(found[k].estimate, 3 * found[k].rms) << k;
  }
}

TEST(Oracle, beads_of_16_cells_with_patches_lie_where_the_oracle_has_them_under_a_frictionless_plate) {
  const auto found = compress(16, Volume::patches, true, 0.49);
  EXPECT_LE(found[0].rms, 0.18 * 0.05 / 0.1825);
  EXPECT_LE(found[1].rms, 0.18 * 0.125 / 0.1825);
  EXPECT_LE(found[2].rms, 0.18);
  const double reactions[] = {-3.6939e-4, -10.025e-4, -15.637e-4};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found[k].reaction / reactions[k], 1, 0.05) << k;
    EXPECT_NEAR(found[k].extrapolated / reactions[k], 1, 0.015) << k;
    EXPECT_LE(found[k].drift, 1e-3) << "nothing but the mesh could move the beads to a side";
  }
}

TEST(Oracle, tets_without_patches_lock_and_patches_halve_their_error) {
  const auto tets = compress(16, Volume::tets, false, 0.49), patches = compress(16, Volume::patches, false, 0.49);
  EXPECT_GE(tets[2].rms, 2 * patches[2].rms);
  EXPECT_LE(tets[2].rms, 0.5);
  EXPECT_LT(tets[2].reaction, 1.02 * patches[2].reaction);  // stiffer: a larger force, which is negative
}

TEST(Oracle, beads_of_16_cells_with_volumes_averaged_at_nodes_lie_where_the_oracle_has_them) {
  const auto found = compress(16, Volume::nodes, false, 0.49);
  EXPECT_LE(found[0].rms, 0.13 * 0.05 / 0.1825);
  EXPECT_LE(found[1].rms, 0.13 * 0.125 / 0.1825);
  EXPECT_LE(found[2].rms, 0.13);
  const double reactions[] = {-4.1053e-4, -11.087e-4, -17.108e-4};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k].reaction / reactions[k], 1, 0.08) << k;
}

TEST(Oracle, errors_fall_by_refinement) {
  const auto coarse = compress(8, Volume::patches, false, 0.49), fine = compress(16, Volume::patches, false, 0.49);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_LE(fine[k].rms, 0.65 * coarse[k].rms) << k;
}

/// Beads of the cube compressed by 18.25 % at a Poisson's ratio of .499, which are nodes of all meshes with a multiple
/// of 8 cells; there is no oracle.
std::vector<Point> beads_near_a_half(Index cells, Volume volume) {
  const Body body = with(volume, make_truth_cube_body(cells, volume == Volume::patches));
  SolverSettings settings;
  settings.poissons_ratio = 0.499;
  const auto solver = make_solver(body.levels, body.loading, settings);
  EXPECT_EQ(solver->solve_to(0.1825, {}).status, NewtonStatus::converged);
  const auto positions = solver->positions();
  std::vector<Point> beads;
  const Index step = cells / 8;
  for (Index z = step; z < cells; z += step) {
    for (Index y = step; y < cells; y += step) {
      for (Index x = step; x < cells; x += step) {
        beads.push_back(positions[static_cast<std::size_t>(x + (cells + 1) * (y + (cells + 1) * z))]);
      }
    }
  }
  return beads;
}

TEST(NearAHalf, tets_lock_where_volumes_averaged_at_nodes_or_over_patches_agree) {
  const auto reference = beads_near_a_half(16, Volume::patches);
  std::array<double, 3> rms{};  // [mm]
  for (const Volume volume : volumes) {
    const auto beads = beads_near_a_half(8, volume);
    ASSERT_EQ(beads.size(), reference.size());
    double sum = 0;
    for (std::size_t n = 0; n < beads.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) sum += std::pow(1e3 * (beads[n][k] - reference[n][k]), 2);
    }
    rms[static_cast<std::size_t>(volume)] = std::sqrt(sum / static_cast<double>(beads.size()));
    std::printf("nu .499, 8 cells, %s: beads %.3f mm from those of 16 cells with patches\n", name_of(volume),
                rms[static_cast<std::size_t>(volume)]);
  }
  EXPECT_LE(rms[1], 0.3);
  EXPECT_LE(rms[2], 0.4);
  EXPECT_GE(rms[0], 3 * rms[2]);
  EXPECT_GE(rms[0], 8 * rms[1]);
}

}  // namespace
}  // namespace physgen::fem
