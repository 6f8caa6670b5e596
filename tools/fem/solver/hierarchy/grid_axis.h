// An axis of a background grid: where its planes lie, evenly or, along axes on which tets differ in size, as close to
// each other as these are small.
#pragma once

#include <fem/mesh/mesh.h>

#include <utility>
#include <vector>

namespace physgen::fem {

class GridAxis {
 public:
  GridAxis(double low, double high, Index cells) : low_(low), high_(high), cells_(cells) {}

  /// Planes that follow the tets: in their distances tets are as many widths along the axis, on average, everywhere.
  /// They are even where no sixteenth of the axis has tets twice as small as another.
  void follow(const TetMesh& mesh, const std::vector<Point>& rest, std::size_t axis);

  [[nodiscard]] Index cells() const { return cells_; }
  /// Plane k of `cells`, of which each is as many of the axis' own [m].
  [[nodiscard]] double plane(Index k, Index cells) const;
  /// The cell in which x lies, or the nearest one, and how far x is from its lower to its upper plane, 0 to 1.
  [[nodiscard]] std::pair<Index, double> locate(double x) const;

 private:
  double low_, high_;
  Index cells_;
  std::vector<double> planes_;  ///< none where they are even
};

}  // namespace physgen::fem
