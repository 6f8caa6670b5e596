// A smooth displacement is made the solution by the loads that keep it in equilibrium, and refinement must lead to it:
// displacements by second order, their gradients by first.
#include <fem/materials/neo_hookean.h>
#include <fem/numerics/svd.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdio>
#include <numbers>

#include "bodies.h"

namespace physgen::fem {
namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

constexpr double amplitude = 0.1, pi = std::numbers::pi;

/// The displacement [m] in the unit cube; its gradients reach 0.4, and all nine vary.
Vector exact(const Vector& X) {
  const double x = pi * X[0], y = pi * X[1], z = pi * X[2];
  return amplitude * Vector(std::sin(x) * std::cos(y / 2) * (1 + X[2] / 2), std::cos(x / 2) * std::sin(z) + X[1] * X[1],
                            std::sin(y) * std::sin(x / 2) - X[2] * X[2] / 2);
}

/// Its gradient by columns of derivatives.
Matrix exact_gradient(const Vector& X) {
  const double x = pi * X[0], y = pi * X[1], z = pi * X[2], c = 1 + X[2] / 2;
  Matrix G;
  G << pi * std::cos(x) * std::cos(y / 2) * c, -pi / 2 * std::sin(x) * std::sin(y / 2) * c,
      std::sin(x) * std::cos(y / 2) / 2,  //
      -pi / 2 * std::sin(x / 2) * std::sin(z), 2 * X[1], pi * std::cos(x / 2) * std::cos(z),
      pi / 2 * std::sin(y) * std::cos(x / 2), pi * std::cos(y) * std::sin(x / 2), -X[2];
  return amplitude * G;
}

/// Places and weights inside the tet 0 <= a, b, c, a + b + c <= 1, whose volume is 1/6: Gauss's points of a cube,
/// collapsed. Exact to degree 5.
struct Quadrature {
  std::vector<Vector> at;
  std::vector<double> weights;
  Quadrature() {
    std::vector<std::array<double, 2>> line;  // on [0, 1], exact to degree 7
    for (const double sign : {-1.0, 1.0}) {
      const double x = std::sqrt(3.0 / 7 + sign * 2.0 / 7 * std::sqrt(1.2)), w = (18 - sign * std::sqrt(30.0)) / 72;
      line.push_back({(1 - x) / 2, w});
      line.push_back({(1 + x) / 2, w});
    }
    for (const auto& [u, wu] : line) {
      for (const auto& [v, wv] : line) {
        for (const auto& [w, ww] : line) {
          at.emplace_back(u, v * (1 - u), w * (1 - u) * (1 - v));
          weights.push_back(wu * wv * ww * (1 - u) * (1 - u) * (1 - v));
        }
      }
    }
  }
};

/// Calls act(tet, Dm, gradients of the corners by columns, place in the tet, rest position, weight [m^3]).
template <class Act>
void each_point(const MeshLevel& level, const Act& act) {
  static const Quadrature quadrature;
  for (const auto& tet : level.mesh.tets) {
    const auto rest = [&](std::size_t corner) {
      const Point& p = level.rest[static_cast<std::size_t>(tet[corner])];
      return Vector(p[0], p[1], p[2]);
    };
    Matrix dm;
    for (std::size_t c = 1; c < 4; ++c) dm.col(Eigen::Index(c) - 1) = rest(c) - rest(0);
    const double scale = dm.determinant();
    Eigen::Matrix<double, 3, 4> gradients;
    gradients.rightCols<3>() = dm.inverse().transpose();
    gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
    for (std::size_t q = 0; q < quadrature.at.size(); ++q) {
      const Vector& a = quadrature.at[q];
      act(tet, gradients, a, Vector(rest(0) + dm * a), quadrature.weights[q] * scale);
    }
  }
}

/// Nodal forces in the weak form: f_a = integral of P(F) grad N_a, which the forces of the tets must hold.
std::vector<Point> loads(const MeshLevel& level, double poissons_ratio) {
  const auto material = NeoHookean<double>::from(1, poissons_ratio);
  std::vector<Point> forces(level.rest.size(), Point{});
  each_point(level, [&](const auto& tet, const auto& gradients, const Vector& /*a*/, const Vector& X, double weight) {
    const Svd<double> f = svd<4, double>(Matrix(Matrix::Identity() + exact_gradient(X)));
    const Vector g = material.stress(f.s);
    const Eigen::Matrix<double, 3, 4> f_corners = f.U * g.asDiagonal() * f.V.transpose() * gradients * weight;
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        forces[static_cast<std::size_t>(tet[c])][k] += f_corners(Eigen::Index(k), Eigen::Index(c));
      }
    }
  });
  return forces;
}

struct Errors {
  double l2, h1;  ///< of the displacement [m^(5/2)], of its gradient [m^(3/2)]
};

Errors solve(Index cells, Volume volume, double poissons_ratio, bool loaded = true) {
  Body body = make_cube(
      cells, 1, volume == Volume::patches, 0,
      [](const Point& x) -> std::uint8_t {
        const bool outside = x[0] == 0 || x[1] == 0 || x[2] == 0 || x[0] == 1 || x[1] == 1 || x[2] == 1;
        return outside ? 7 : 0;
      },
      [](const Point& x) {
        const Vector u = exact({x[0], x[1], x[2]});
        return Point{u[0], u[1], u[2]};
      });
  body = with(volume, std::move(body));
  const MeshLevel& level = body.levels[0];
  if (loaded) body.loading.forces = loads(level, poissons_ratio);
  SolverSettings settings;
  settings.material = "neo-hookean";
  settings.poissons_ratio = poissons_ratio;
  settings.newton.tolerance = 1e-8;
  const auto solver = make_solver(body.levels, body.loading, settings);
  EXPECT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
  const auto positions = solver->positions();
  Errors errors{};
  each_point(level, [&](const auto& tet, const auto& gradients, const Vector& a, const Vector& X, double weight) {
    Eigen::Matrix<double, 3, 4> u;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto n = static_cast<std::size_t>(tet[c]);
      for (std::size_t k = 0; k < 3; ++k) u(Eigen::Index(k), Eigen::Index(c)) = positions[n][k] - level.rest[n][k];
    }
    const Eigen::Vector4d N(1 - a.sum(), a[0], a[1], a[2]);
    errors.l2 += weight * (u * N - exact(X)).squaredNorm();
    errors.h1 += weight * (u * gradients.transpose() - exact_gradient(X)).squaredNorm();
  });
  return {std::sqrt(errors.l2), std::sqrt(errors.h1)};
}

TEST(Manufactured, gradient_of_the_exact_solution_is_its_derivative_and_turns_no_volume_over) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(0, 1);
  double smallest = 1, largest = 1;
  for (int k = 0; k < 1000; ++k) {
    const Vector X(number(random), number(random), number(random));
    const Matrix G = exact_gradient(X);
    for (int c = 0; c < 3; ++c) {
      const Vector h = 1e-5 * Vector::Unit(c);
      EXPECT_LE(((exact(X + h) - exact(X - h)) / 2e-5 - G.col(c)).norm(), 1e-9);
    }
    const double J = (Matrix::Identity() + G).determinant();
    smallest = std::min(smallest, J);
    largest = std::max(largest, J);
  }
  EXPECT_GT(smallest, 0.3);  // nowhere does the material go on linearly
  EXPECT_GT(largest, smallest + 0.5);
}

TEST(Manufactured, quadrature_is_exact_to_degree_5) {
  const Quadrature quadrature;
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  for (int i = 0; i <= 5; ++i) {
    for (int j = 0; i + j <= 5; ++j) {
      for (int k = 0; i + j + k <= 5; ++k) {
        double sum = 0;
        for (std::size_t q = 0; q < quadrature.at.size(); ++q) {
          const Vector& a = quadrature.at[q];
          sum += quadrature.weights[q] * std::pow(a[0], i) * std::pow(a[1], j) * std::pow(a[2], k);
        }
        EXPECT_NEAR(sum, factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3), 1e-15);
      }
    }
  }
}

void expect_slopes(Volume volume, double poissons_ratio) {
  Errors before{};
  for (const Index cells : {4, 8, 16}) {
    const Errors errors = solve(cells, volume, poissons_ratio);
    std::printf("nu %g, %s, %2d cells: L2 %.3e, H1 %.3e", poissons_ratio, name_of(volume), int(cells), errors.l2,
                errors.h1);
    if (before.l2 > 0) {
      const double l2 = std::log2(before.l2 / errors.l2), h1 = std::log2(before.h1 / errors.h1);
      std::printf(", slopes %.2f and %.2f", l2, h1);
      EXPECT_GE(l2, cells == 8 ? 1.7 : 1.85) << cells;  // it rises to 2
      EXPECT_GE(h1, 0.9) << cells;
    }
    std::printf("\n");
    before = errors;
  }
}

TEST(Manufactured, tets_converge_to_a_smooth_solution_by_second_order_and_their_gradients_by_first) {
  expect_slopes(Volume::tets, 0.3);
}

TEST(Manufactured, patches_converge_to_a_smooth_solution_by_second_order_and_their_gradients_by_first) {
  expect_slopes(Volume::patches, 0.45);
}

TEST(Manufactured, volumes_averaged_at_nodes_converge_by_second_order_and_their_gradients_by_first) {
  expect_slopes(Volume::nodes, 0.45);
}

TEST(Manufactured, without_its_loads_the_solution_is_another_one) {
  const Errors with = solve(8, Volume::tets, 0.3), without = solve(8, Volume::tets, 0.3, false);
  EXPECT_GE(without.l2, 10 * with.l2);
}

}  // namespace
}  // namespace physgen::fem
