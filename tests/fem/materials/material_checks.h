// The common part of the tests of the material models: the suite over all models, their random input, how errors are
// reported, and the replay of one input.
#pragma once

#include <fem/materials/materials.h>
#include <fem/reference/distribution.h>
#include <fem/reference/principal.h>
#include <gtest/gtest.h>
#include <physgen/simd/simd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "reference.h"
#include "replay.h"

namespace physgen::fem {

using reference::Entries, reference::entries, reference::ErrorDistribution, reference::Jet, reference::Quad,
    reference::Random;

namespace detail {
template <class List>
struct TestTypes;
template <class... Models>
struct TestTypes<MaterialList<Models...>> {
  using type = testing::Types<Models...>;
};
}  // namespace detail

/// All models of one precision, for TYPED_TEST_SUITE.
template <class Real>
using MaterialTypes = typename detail::TestTypes<AllMaterials<Real>>::type;

/// The constants every model is tested with: tissue, nearly incompressible or not; and nu < 0.
struct Elasticity {
  double E, nu;
  [[nodiscard]] LameParameters lame() const { return lame_parameters(E, nu, "test"); }
};
inline constexpr std::array<Elasticity, 4> tested_constants{{{1e4, 0.45}, {1e4, 0.49}, {3e3, 0.3}, {1, -0.2}}};

template <class Model>
Model model_of(const Elasticity& e) {
  return Model::from(e.E, e.nu);
}

inline Vector3<double> sorted(double a, double b, double c) {
  std::array<double, 3> s{a, b, c};
  std::sort(s.begin(), s.end(), [](double x, double y) { return std::abs(x) > std::abs(y); });
  return {std::abs(s[0]), std::abs(s[1]), s[2]};
}

/// Stretches in [0.05, 4], two of five inverted.
inline Vector3<double> random_stretch(Random& r) {
  const double flip = r.uniform(0, 1) < 0.4 ? -1 : 1;
  const double a = r.uniform(0.05, 4), b = r.uniform(0.05, 4), c = r.uniform(0.05, 4);
  const Vector3<double> s = sorted(a, b, c);
  return {s[0], s[1], flip * s[2]};
}

/// Two stretches in [0.05, 4] and one in [0.0025, 0.2]: compressed to almost nothing; two of five inverted.
inline Vector3<double> compressed_stretch(Random& r) {
  const double flip = r.uniform(0, 1) < 0.4 ? -1 : 1;
  const double a = r.uniform(0.05, 4), b = r.uniform(0.05, 4), c = r.uniform(0.0025, 0.2);
  const Vector3<double> s = sorted(a, b, c);
  return {s[0], s[1], flip * s[2]};
}

/// Where the model holds s_a + s_b away from zero (see its header), entries differ from those of the energy by design.
template <class Model, class Real>
bool is_capped(const Model& m, const Vector3<Real>& s) {
  if constexpr (requires { m.smallest_stretch_sum; }) {
    for (const Real sum : {s[0] + s[1], s[0] + s[2], s[1] + s[2]}) {
      if (std::abs(sum) < m.smallest_stretch_sum) return true;
    }
  }
  return false;
}

/// Every digit of s.
template <class Real>
std::string hexadecimal(const Vector3<Real>& s) {
  return hexadecimal(std::array<double, 3>{double(s[0]), double(s[1]), double(s[2])});
}

/// PHYSGEN_TEST_STRETCH="s1 s2 s3", as a failed run prints it: the accuracy tests measure this one alone.
inline std::optional<Vector3<double>> replayed_stretch() {
  const auto s = replayed<3>("PHYSGEN_TEST_STRETCH");
  if (!s) return std::nullopt;
  return Vector3<double>((*s)[0], (*s)[1], (*s)[2]);
}

/// Prints energy, stress and entries of a model at one s beside the oracle's.
template <class Model>
void print_beside_oracle(const Model& m, const Elasticity& e, const Vector3<typename Model::Scalar>& s) {
  const Jet psi = reference::exact_energy(m, s);
  const auto expected = reference::exact_entries(psi, s);
  const auto got = entries(m.derivative(s));
  const auto g = m.stress(s);
  std::printf("%s, E = %g, nu = %g, s = %s\n%6s %24s %24s %12s\n", m.name, e.E, e.nu, hexadecimal(s).c_str(), "",
              "model", "oracle", "difference");
  const auto row = [](const char* name, double value, Quad exact) {
    std::printf("%6s %24.17g %24.17g %12.3g\n", name, value, double(exact), double(Quad(value) - exact));
  };
  row("psi", double(m.energy(s)), psi.value);
  for (std::size_t a = 0; a < 3; ++a) row("g", double(g[Eigen::Index(a)]), psi.gradient[a]);
  for (std::size_t k = 0; k < 12; ++k) row(reference::entry_names[k], double(got[k]), expected[k]);
}

/// Mooney-Rivlin's kappa (1 - ln J) cancels against the other terms of H_aa where J is large and s_a small, whatever
/// the formula: relative to the largest entry alone its errors reach 5.8 eps in 4 million inputs, 7.2 eps once in
/// others. So its measure is the conditioned one, throughout; no other model needs that.
template <class Model>
constexpr bool is_ill_conditioned = std::is_same_v<Model, MooneyRivlin<typename Model::Scalar>>;

/// The four distributions of errors of a model, over the inputs given to add().
template <class Model>
class MaterialErrors {
 public:
  using Real = typename Model::Scalar;

  MaterialErrors(const Model& model, const Elasticity& constants) : model_(model), constants_(constants) {}

  void add(const Vector3<double>& given) {
    const Vector3<Real> s = given.template cast<Real>();
    if (is_capped(model_, s)) return;
    const auto e = reference::principal_errors(model_, constants_.lame().mu, s);
    inputs_.push_back(s);
    energy.add(e.energy);
    stress.add(e.stress);
    derivative.add(e.entries);
    conditioned.add(e.conditioned);
  }

  /// One line per distribution, and how to look into the worst.
  void print() const {
    std::printf("%s, %s, E = %g, nu = %g, %zu inputs: errors in eps\n", model_.name,
                sizeof(Real) == 4 ? "float" : "double", constants_.E, constants_.nu, inputs_.size());
    print("psi", energy);
    print("g", stress);
    print("H D S", derivative);
    print("H D S, conditioned", conditioned);
  }

  /// Errors of the 12 entries, in the measure for which the limit of 8 eps holds.
  [[nodiscard]] const ErrorDistribution& judged() const { return is_ill_conditioned<Model> ? conditioned : derivative; }

  ErrorDistribution energy, stress;
  ErrorDistribution derivative;   ///< relative to the largest entry
  ErrorDistribution conditioned;  ///< or, where that is more, relative to what a relative eps of s changes

 private:
  void print(const char* what, const ErrorDistribution& errors) const {
    const auto e = errors.summary();
    std::printf("  %-18s p50 %5.2f  p99 %5.2f  p99.99 %5.2f  max %5.2f  at PHYSGEN_TEST_STRETCH=\"%s\"\n", what, e.p50,
                e.p99, e.p9999, e.max,
                e.worst_index < 0 ? "" : hexadecimal(inputs_[static_cast<std::size_t>(e.worst_index)]).c_str());
  }

  Model model_;
  Elasticity constants_;
  std::vector<Vector3<Real>> inputs_;
};

}  // namespace physgen::fem
