// What the tests of tools/fem compare with: seeded random input, quadruple precision, and differentiation of a scalar
// function to second order (a jet) in that precision. Nothing here is shared with the code under test.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstdlib>
#include <iostream>
#include <random>

namespace physgen::fem::reference {

/// 113 significant bits; from the compiler, so no library is needed.
__extension__ using Quad = __float128;

/// A fresh seed per run, printed; PHYSGEN_TEST_SEED repeats one.
inline std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* given = std::getenv("PHYSGEN_TEST_SEED");
    const std::uint64_t s = given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
    std::cout << "PHYSGEN_TEST_SEED=" << s << "\n";
    return s;
  }();
  return value;
}

class Random {
 public:
  explicit Random(std::uint64_t stream) : generator_(seed() * 1000003 + stream) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  double normal() { return normal_(generator_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }
  Eigen::Matrix3d gaussian() {
    Eigen::Matrix3d m;
    for (int k = 0; k < 9; ++k) m(k % 3, k / 3) = normal();
    return m;
  }
  /// Uniformly distributed rotation, from a unit quaternion.
  Eigen::Matrix3d rotation() {
    Eigen::Quaterniond q(normal(), normal(), normal(), normal());
    return q.normalized().toRotationMatrix();
  }

 private:
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
};

/// Natural logarithm: the double result, then two Newton steps on exp, whose series is summed.
inline Quad exp(Quad x) {
  int halvings = 0;
  for (; x > 0.01 || x < -0.01; ++halvings) x /= 2;
  Quad term = 1, sum = 1;
  for (int n = 1; n < 20; ++n) sum += term *= x / n;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}
inline Quad log(Quad x) {
  Quad y = std::log(static_cast<double>(x));
  for (int step = 0; step < 2; ++step) {
    const Quad e = exp(y);
    y += 2 * (x - e) / (x + e);
  }
  return y;
}

/// A value with its gradient and Hessian with respect to three variables.
struct Jet {
  Quad value = 0;
  std::array<Quad, 3> gradient{};
  std::array<std::array<Quad, 3>, 3> hessian{};

  Jet(Quad constant) : value(constant) {}    // NOLINT: constants mix with jets
  Jet(double constant) : value(constant) {}  // NOLINT
  static Jet variable(double at, std::size_t which) {
    Jet x{Quad(at)};
    x.gradient[which] = 1;
    return x;
  }
  /// f(x) from f and its first two derivatives at x.value.
  [[nodiscard]] Jet chain(Quad f, Quad df, Quad ddf) const {
    Jet r{f};
    for (std::size_t i = 0; i < 3; ++i) {
      r.gradient[i] = df * gradient[i];
      for (std::size_t j = 0; j < 3; ++j) r.hessian[i][j] = df * hessian[i][j] + ddf * gradient[i] * gradient[j];
    }
    return r;
  }
  friend Jet operator+(const Jet& a, const Jet& b) { return combine(a, b, 1); }
  friend Jet operator-(const Jet& a, const Jet& b) { return combine(a, b, -1); }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet r{a.value * b.value};
    for (std::size_t i = 0; i < 3; ++i) {
      r.gradient[i] = a.gradient[i] * b.value + a.value * b.gradient[i];
      for (std::size_t j = 0; j < 3; ++j) {
        r.hessian[i][j] = a.hessian[i][j] * b.value + a.value * b.hessian[i][j] + a.gradient[i] * b.gradient[j] +
                          a.gradient[j] * b.gradient[i];
      }
    }
    return r;
  }
  friend Jet log(const Jet& a) { return a.chain(log(a.value), 1 / a.value, -1 / (a.value * a.value)); }

 private:
  static Jet combine(const Jet& a, const Jet& b, int sign) {
    Jet r{a.value + sign * b.value};
    for (std::size_t i = 0; i < 3; ++i) {
      r.gradient[i] = a.gradient[i] + sign * b.gradient[i];
      for (std::size_t j = 0; j < 3; ++j) r.hessian[i][j] = a.hessian[i][j] + sign * b.hessian[i][j];
    }
    return r;
  }
};

}  // namespace physgen::fem::reference
