// Random numbers, vectors, rotations and Gaussian matrices from a seed, for tests and benchmarks.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <Eigen/Geometry>
#include <cstdint>
#include <random>

namespace physgen::fem::reference {

class RandomMatrices {
 public:
  explicit RandomMatrices(std::uint64_t seed) : generator_(seed) {}
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
    const double w = normal(), x = normal(), y = normal(), z = normal();
    return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  }

 private:
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
};

}  // namespace physgen::fem::reference

#pragma pop_macro("I")
