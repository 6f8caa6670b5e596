// Bodies that the tests of motion set going, and motions that are known.
#pragma once

#include <fem/mesh/geometry.h>
#include <fem/solver/dynamic_solver.h>
#include <fem/solver/masses.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>

#include "../solver/bodies.h"

namespace physgen::fem {

inline constexpr double density = 1200;  // [kg/m^3]
inline constexpr Point gravity{1.5, -2.5, -9.81};

inline DynamicSettings moving_settings(const std::string& material, double youngs_modulus, double poissons_ratio) {
  DynamicSettings settings;
  settings.solver = exact_settings(material, poissons_ratio);
  settings.solver.youngs_modulus = youngs_modulus;
  settings.density = density;
  return settings;
}

/// Positions and velocities that are not finite are refused with the node, and the solver is as before.
inline void expect_only_finite_vectors(DynamicSolver& solver) {
  const auto refusal = [](const auto& set) -> std::string {
    try {
      set();
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto x = solver.positions(), v = solver.velocities();
  auto bad = x;
  bad[3][2] = NAN;
  EXPECT_NE(refusal([&] { solver.set_positions(bad); }).find("the position of node 3 is ("), std::string::npos);
  bad = v;
  bad[4][0] = INFINITY;
  EXPECT_NE(refusal([&] { solver.set_velocities(bad); }).find("the velocity of node 4 is (inf, 0, 0)"),
            std::string::npos);
  EXPECT_EQ(solver.positions(), x);
  EXPECT_EQ(solver.velocities(), v);
}

/// An irregular cube that nothing holds.
inline Body free_body(Index cells, double side) {
  return make_cube(
      cells, side, false, 0.2, [](const Point&) { return std::uint8_t{0}; }, [](const Point&) { return Point{}; });
}

/// The same, with its weight as load.
inline Body falling_body(Index cells, double side) {
  Body body = free_body(cells, side);
  for (const double mass : lumped_masses(body.levels[0].mesh, body.levels[0].rest, density)) {
    body.loading.forces.push_back({mass * gravity[0], mass * gravity[1], mass * gravity[2]});
  }
  return body;
}

inline std::vector<Point> random_vectors(std::size_t count, double length, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-length, length);
  std::vector<Point> vectors(count);
  for (Point& v : vectors) v = {number(random), number(random), number(random)};
  return vectors;
}

inline std::vector<Point> sum(std::vector<Point> a, const std::vector<Point>& b, double factor = 1) {
  for (std::size_t n = 0; n < a.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) a[n][k] += factor * b[n][k];
  }
  return a;
}

/// Sums of m v and of m x cross v.
struct Momenta {
  Point linear{}, angular{};
};
inline Momenta momenta(const DynamicSolver& solver, const std::vector<double>& masses) {
  Momenta sums;
  const auto x = solver.positions(), v = solver.velocities();
  for (std::size_t n = 0; n < x.size(); ++n) {
    const Point turn = cross(x[n], v[n]);
    for (std::size_t k = 0; k < 3; ++k) {
      sums.linear[k] += masses[n] * v[n][k];
      sums.angular[k] += masses[n] * turn[k];
    }
  }
  return sums;
}

/// A bar that moves along z alone, held at both ends. Its tets between two layers of nodes have one strain, and with
/// all cells cut along one diagonal the nodes of a layer have masses in proportion to what holds them: a chain of
/// masses, whose modes are sines.
struct WaveBar {
  static constexpr double side = 0.08, young = 2e4, nu = 0.3, amplitude = 1e-7 * side;

  Index cells;
  Body body;
  explicit WaveBar(Index count)
      : cells(count),
        body(cut_along_one_diagonal(
            make_cube(
                count, side, false, 0,
                [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] > side * (1 - 1e-9) ? 7 : 3; },
                [](const Point&) { return Point{}; }),
            count)) {}

  /// The speed of pressure waves [m/s].
  [[nodiscard]] static double speed() {
    const double mu = young / (2 * (1 + nu)), lambda = young * nu / ((1 + nu) * (1 - 2 * nu));
    return std::sqrt((lambda + 2 * mu) / density);
  }
  /// The frequency of the first mode: of the bar, and of the chain [rad/s].
  [[nodiscard]] static double exact_frequency() { return std::numbers::pi * speed() / side; }
  [[nodiscard]] double frequency() const {
    return 2 * speed() * cells / side * std::sin(std::numbers::pi / (2 * cells));
  }

  [[nodiscard]] static double shape(const Point& x) { return std::sin(std::numbers::pi * x[2] / side); }
  /// Sets the first mode going from its amplitude.
  void begin(DynamicSolver& solver) const {
    std::vector<Point> x = body.levels[0].rest;
    for (Point& point : x) point[2] += amplitude * shape(point);
    solver.set_positions(x);
  }
  /// How far the first mode is from rest, in amplitudes.
  [[nodiscard]] double part(const DynamicSolver& solver) const {
    const auto& rest = body.levels[0].rest;
    const auto x = solver.positions();
    double sum = 0, square = 0;
    for (std::size_t n = 0; n < x.size(); ++n) {
      sum += (x[n][2] - rest[n][2]) * shape(rest[n]);
      square += shape(rest[n]) * shape(rest[n]);
    }
    return sum / square / amplitude;
  }
};

}  // namespace physgen::fem
