// Differentiation of a scalar function of three variables to second order, exactly, in quadruple precision: the
// function is evaluated on jets. Host only.
#pragma once

#include <fem/reference/quad.h>

#include <array>
#include <cstddef>

namespace physgen::fem::reference {

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
  friend Jet log(const Jet& a) { return a.chain(reference::log(a.value), 1 / a.value, -1 / (a.value * a.value)); }
  /// a^power, a > 0
  friend Jet pow(const Jet& a, Quad power) {
    const Quad f = reference::pow(a.value, power), df = power * f / a.value;
    return a.chain(f, df, (power - 1) * df / a.value);
  }

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
