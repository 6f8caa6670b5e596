// Solvers of bodies whose components are prescribed along other axes than x, y and z (MeshLevel::axes): the body is
// turned so that these axes become x, y and z, and what its solver finds is turned back. Kernels know nothing of it.
#pragma once

#include <fem/solver/quasistatic.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace physgen::fem {

/// From the coordinates of a body to those along its axes, and back.
class Turn {
 public:
  using Block = std::array<double, 9>;  ///< 3x3, by columns

  /// @throw Error when the axes are not perpendicular, of length 1 and right-handed
  explicit Turn(const std::array<Point, 3>& axes);

  [[nodiscard]] Point along(const Point& x) const;
  [[nodiscard]] std::vector<Point> along(std::span<const Point> vectors) const;
  /// Levels at rest in those coordinates, whose components are along x, y and z.
  [[nodiscard]] std::vector<MeshLevel> along(const std::vector<MeshLevel>& levels) const;
  [[nodiscard]] Loading along(const Loading& loading) const;

  [[nodiscard]] Point back(const Point& x) const;
  [[nodiscard]] std::vector<Point> back(std::vector<Point> vectors) const;
  /// Of a tensor: a stress, or a block of a stiffness.
  [[nodiscard]] Block back(const Block& tensor) const;
  /// A solver in the body's coordinates. @param solver of what along() gives
  [[nodiscard]] std::unique_ptr<QuasistaticSolver> back(std::unique_ptr<QuasistaticSolver> solver) const;
  [[nodiscard]] std::unique_ptr<EquilibriumSolver> back(std::unique_ptr<EquilibriumSolver> solver) const;

 private:
  std::array<Point, 3> axes_;
};

}  // namespace physgen::fem
