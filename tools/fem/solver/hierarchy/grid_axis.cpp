// Sizes of tets are averaged over thin slices of the axis; planes lie at equal parts of the integral of widths per
// length.
#include <fem/solver/hierarchy/grid_axis.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace physgen::fem {

namespace {

constexpr std::size_t slices = 1024, slices_of_part = 64;

/// For each slice the mean of 1/width of the tets whose middles lie there; 0 where there are none.
std::vector<double> widths_per_length(const TetMesh& mesh, const std::vector<Point>& rest, std::size_t axis, double low,
                                      double high) {
  std::vector<double> sums(slices, 0), counts(slices, 0);
  for (const auto& tet : mesh.tets) {
    std::array<double, 4> x{};
    for (std::size_t c = 0; c < 4; ++c) x[c] = rest[static_cast<std::size_t>(tet[c])][axis];
    const auto [least, most] = std::ranges::minmax(x);
    const double part = (0.25 * (x[0] + x[1] + x[2] + x[3]) - low) / (high - low);
    const auto slice = static_cast<std::size_t>(std::clamp(part * slices, 0.0, slices - 1.0));
    sums[slice] += 1 / (most - least);
    ++counts[slice];
  }
  for (std::size_t s = 0; s < slices; ++s) sums[s] = counts[s] > 0 ? sums[s] / counts[s] : 0;
  return sums;
}

bool is_even(const std::vector<double>& density) {
  double least = 0, most = 0;
  for (std::size_t s = 0; s < slices; s += slices_of_part) {
    double sum = 0, count = 0;
    for (std::size_t k = s; k < s + slices_of_part; ++k) {
      sum += density[k];
      count += density[k] > 0 ? 1 : 0;
    }
    if (count == 0) continue;
    most = std::max(most, sum / count);
    least = least == 0 ? sum / count : std::min(least, sum / count);
  }
  return most <= 2 * least;
}

}  // namespace

void GridAxis::follow(const TetMesh& mesh, const std::vector<Point>& rest, std::size_t axis) {
  std::vector<double> density = widths_per_length(mesh, rest, axis, low_, high_);
  planes_.clear();
  if (is_even(density)) return;
  double last = *std::ranges::find_if(density, [](double d) { return d > 0; });
  double total = 0;
  for (double& d : density) {  // slices without tets have the density of those before
    if (d > 0) last = d;
    d = last;
    total += d;
  }
  planes_.push_back(low_);
  double before = 0;
  std::size_t slice = 0;
  for (Index k = 1; k < cells_; ++k) {
    const double wanted = total * k / cells_;
    while (slice + 1 < slices && before + density[slice] < wanted) before += density[slice++];
    const double part = (static_cast<double>(slice) + (wanted - before) / density[slice]) / slices;
    planes_.push_back(std::lerp(low_, high_, part));
  }
  planes_.push_back(high_);
}

double GridAxis::plane(Index k, Index cells) const {
  if (planes_.empty()) return std::lerp(low_, high_, double(k) / cells);
  return planes_[static_cast<std::size_t>(k) * static_cast<std::size_t>(cells_ / cells)];
}

std::pair<Index, double> GridAxis::locate(double x) const {
  if (planes_.empty()) {
    const double t = (x - low_) / (high_ - low_) * cells_;
    const Index cell = std::clamp(static_cast<Index>(t), Index{0}, cells_ - 1);
    return {cell, t - cell};
  }
  const auto above = std::ranges::upper_bound(planes_, x) - planes_.begin();
  const auto cell = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, cells_ - 1));
  return {static_cast<Index>(cell), (x - planes_[cell]) / (planes_[cell + 1] - planes_[cell])};
}

}  // namespace physgen::fem
