// Stress and stress derivative in principal axes by differentiation of the energy in quadruple precision, and what the
// errors of a model are measured against. Host only.
#pragma once

#include <fem/reference/energy.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace physgen::fem::reference {

/// The 12 entries in the order of PrincipalDerivative: H11 H21 H31 H22 H32 H33, D21 D31 D32, S21 S31 S32.
template <class T>
using Entries = std::array<T, 12>;

inline constexpr std::array<const char*, 12> entry_names{"H11", "H21", "H31", "H22", "H32", "H33",
                                                         "D21", "D31", "D32", "S21", "S31", "S32"};

template <class S>
Entries<S> entries(const PrincipalDerivative<S>& d) {
  return {d.h11, d.h21, d.h31, d.h22, d.h32, d.h33, d.d21, d.d31, d.d32, d.s21, d.s31, d.s32};
}

/// psi, g and H at s.
template <class Model, class Real>
Jet exact_energy(const Model& model, const Vector3<Real>& s) {
  return energy(model, {Jet::variable(s[0], 0), Jet::variable(s[1], 1), Jet::variable(s[2], 2)});
}

/// The quotients (g_a - g_b) / (s_a - s_b) and (g_a + g_b) / (s_a + s_b) themselves: quadruple precision has the
/// digits. Where a divisor is 0 they are their limits, which exist since psi is even and does not tell stretches apart.
template <class Real>
Entries<Quad> exact_entries(const Jet& psi, const Vector3<Real>& s) {
  const auto& H = psi.hessian;
  const auto& g = psi.gradient;
  const auto at = [&s](std::size_t a) { return Quad(s[static_cast<Eigen::Index>(a)]); };
  const auto D = [&](std::size_t a, std::size_t b) {
    const Quad gap = at(a) - at(b);
    return gap == 0 ? H[a][a] - H[a][b] : (g[a] - g[b]) / gap;
  };
  const auto S = [&](std::size_t a, std::size_t b) {
    const Quad sum = at(a) + at(b);
    return sum == 0 ? H[a][a] + H[a][b] : (g[a] + g[b]) / sum;
  };
  return {H[0][0], H[1][0], H[2][0], H[1][1], H[2][1], H[2][2], D(1, 0), D(2, 0), D(2, 1), S(1, 0), S(2, 0), S(2, 1)};
}

/// The condition of the entries: their change when one stretch changes a little, relative to that change. [Pa]
template <class Model, class Real>
double sensitivity(const Model& model, const Vector3<Real>& s, const Entries<Quad>& expected) {
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    Vector3<double> moved = s.template cast<double>();
    moved[a] *= 1 + 0x1p-24;
    const auto entries = exact_entries(exact_energy(model, moved), moved);
    double most = 0;
    for (std::size_t k = 0; k < 12; ++k) {
      most = std::max(most, static_cast<double>(abs(entries[k] - expected[k])));
    }
    sum += most * 0x1p24;
  }
  return sum;
}

/// Errors of a model at one s, in eps of its precision: of psi relative to |psi| + mu |s - 1|^2 (with nu < 0, psi alone
/// may vanish), of g relative to |H| |s| (a change of s by an eps moves it so far), of the 12 entries relative to the
/// largest of them, and (conditioned) to that or the sensitivity, whichever is larger. What is not a number has the
/// error NaN.
struct PrincipalErrors {
  double energy, stress, entries, conditioned;
};

/// Up to this error of the entries [eps] the sensitivity, which costs most and can only lessen it, is not asked for.
inline constexpr double well_conditioned = 2;

/// @param shear_modulus mu, for the scale of psi [Pa]
template <class Model>
PrincipalErrors principal_errors(const Model& model, double shear_modulus, const Vector3<typename Model::Scalar>& s) {
  using Real = typename Model::Scalar;
  const double eps = std::numeric_limits<Real>::epsilon();
  const Jet psi = exact_energy(model, s);
  const auto expected = exact_entries(psi, s);
  const auto got = entries(model.derivative(s));
  double largest = 0, error = 0;
  const auto raise = [](double& worst, Quad value) {
    const double x = static_cast<double>(abs(value));
    if (!std::isnan(worst) && !(x <= worst)) worst = x;  // NaN, too, and it stays
  };
  for (std::size_t k = 0; k < 12; ++k) {
    raise(largest, expected[k]);
    raise(error, Quad(got[k]) - expected[k]);
  }
  PrincipalErrors e{};
  e.entries = e.conditioned = error / largest / eps;
  if (!(e.entries <= well_conditioned))
    e.conditioned = error / std::max(largest, sensitivity(model, s, expected)) / eps;
  const Vector3<Real> g = model.stress(s);
  double stress = 0;
  for (int a = 0; a < 3; ++a) raise(stress, Quad(g[a]) - psi.gradient[static_cast<std::size_t>(a)]);
  const Vector3<double> s64 = s.template cast<double>();
  e.stress = stress / (largest * s64.norm()) / eps;
  const double scale =
      std::abs(static_cast<double>(psi.value)) + shear_modulus * (s64 - Vector3<double>::Ones()).squaredNorm();
  const double energy = static_cast<double>(abs(Quad(model.energy(s)) - psi.value));
  e.energy = energy == 0 ? 0 : energy / scale / eps;
  return e;
}

}  // namespace physgen::fem::reference
