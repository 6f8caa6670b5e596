// Families of 3x3 matrices on which decompositions are tested and measured: ordinary deformation gradients, and the
// hard ones that break fast methods (rank deficient, nearly equal stretches, extreme magnitudes, inverted elements).
#pragma once

#include <fem/reference/random.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace physgen::fem::reference {

/// A family: each call of make gives another member, in double; rounded to float it is as hard.
struct MatrixFamily {
  std::string name;
  std::function<Eigen::Matrix3d(RandomMatrices&)> make;
};

/// The precision for which a family is to be hard: where the spacing of numbers and the range matter, families follow
/// it.
struct Precision {
  double epsilon, smallest_normal, smallest, largest;
  template <class Real>
  static Precision of() {
    using Limits = std::numeric_limits<Real>;
    return {double(Limits::epsilon()), double(Limits::min()), double(Limits::denorm_min()), double(Limits::max())};
  }
};

/// All hard families, of finite matrices. At least: zero; +-identity; rotations; reflections; scaled rotations; equal
/// and nearly equal stretches; s2 = -s3; ranks 1 and 2; equal, zero columns and rows; condition 1e3 to 1e12; norms
/// 1e-22 to 3e38 (and of double's range); subnormals; slivers; signed permutations; skew-symmetric; compressed,
/// flattened and inverted elements.
[[nodiscard]] std::vector<MatrixFamily> hard_matrices(const Precision& precision);

/// Ordinary input: I + 0.3 N(0,1).
[[nodiscard]] Eigen::Matrix3d random_deformation(RandomMatrices& random);
/// I + strain N(0,1), rotated.
[[nodiscard]] Eigen::Matrix3d deformation_near_rest(RandomMatrices& random, double strain);

}  // namespace physgen::fem::reference
