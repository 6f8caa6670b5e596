#include "setting.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace fluid {

namespace {

constexpr float spacing = 0.02F;  // of particles at rest [m]

struct Cells {
  float reach;
  int side = 0;

  Cells(const std::vector<Point>& positions, float width) : reach(width) {
    float most = 0;
    for (const Point& x : positions) most = std::max({most, x[0], x[1], x[2]});
    side = along(most) + 1;
  }
  [[nodiscard]] int along(float x) const { return std::max(static_cast<int>(x / reach), 0); }
  [[nodiscard]] int at(int x, int y, int z) const { return x + side * (y + side * z); }
  [[nodiscard]] int of(const Point& p) const { return at(along(p[0]), along(p[1]), along(p[2])); }
};

}  // namespace

Water::Water() {
  const float pi = std::numbers::pi_v<float>, squared = reach * reach, cubed = squared * reach;
  poly6 = 315.0F / (64.0F * pi * cubed * cubed * cubed);
  spiky = 45.0F / (pi * cubed * cubed);
  laplacian = spiky;
}

Setting make_setting(int particles) {
  Setting setting;
  const int side = std::max(static_cast<int>(std::lround(std::cbrt(particles))), 2);
  std::uint32_t random = 12345;
  const auto disorder = [&random] {
    random = random * 1664525U + 1013904223U;
    return (static_cast<float>(random >> 8U) / 16777216.0F - 0.5F) * 0.2F * spacing;
  };
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        Point position{};
        for (std::size_t k = 0; k < 3; ++k) {
          const int cell = k == 0 ? x : k == 1 ? y : z;
          position[k] = (static_cast<float>(cell) + 0.5F) * spacing + disorder();
        }
        setting.positions.push_back(position);
      }
    }
  }
  setting.water.side = 2.0F * spacing * static_cast<float>(side);
  return setting;
}

NeighbourLists find_neighbours(const std::vector<Point>& positions, float reach) {
  const Cells cells(positions, reach);
  const auto count = static_cast<std::size_t>(cells.side * cells.side * cells.side);
  std::vector<std::int32_t> first(count + 1, 0), members(positions.size());
  for (const Point& x : positions) ++first[static_cast<std::size_t>(cells.of(x)) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::int32_t> next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    members[static_cast<std::size_t>(next[static_cast<std::size_t>(cells.of(positions[i]))]++)] = static_cast<int>(i);
  }
  NeighbourLists lists;
  lists.first.push_back(0);
  lists.entries.reserve(positions.size() * 32);
  for (const Point& x : positions) {
    std::array<int, 3> low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::max(cells.along(x[k]) - 1, 0);
      high[k] = std::min(cells.along(x[k]) + 1, cells.side - 1);
    }
    for (int cz = low[2]; cz <= high[2]; ++cz) {
      for (int cy = low[1]; cy <= high[1]; ++cy) {
        for (int cx = low[0]; cx <= high[0]; ++cx) {
          const auto cell = static_cast<std::size_t>(cells.at(cx, cy, cz));
          for (std::int32_t m = first[cell]; m < first[cell + 1]; ++m) {
            const std::int32_t j = members[static_cast<std::size_t>(m)];
            const Point& y = positions[static_cast<std::size_t>(j)];
            const float dx = y[0] - x[0], dy = y[1] - x[1], dz = y[2] - x[2];
            if (dx * dx + (dy * dy + dz * dz) < reach * reach) lists.entries.push_back(j);
          }
        }
      }
    }
    lists.first.push_back(static_cast<std::int32_t>(lists.entries.size()));
  }
  return lists;
}

std::vector<std::int64_t> order_by_cell(const std::vector<Point>& positions, float reach) {
  const Cells cells(positions, reach);
  std::vector<std::int64_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::int64_t i) { return cells.of(positions[static_cast<std::size_t>(i)]); });
  return order;
}

}  // namespace fluid
