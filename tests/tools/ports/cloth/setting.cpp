#include "setting.h"

#include <cmath>

namespace sheet {

Setting make_setting(int side) {
  Setting setting;
  const double spacing = 1.0 / (side - 1);
  const auto at = [side](int x, int y) { return x + side * y; };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      setting.positions.push_back({spacing * x, spacing * y, 0.01 * std::sin(7.0 * spacing * x * y)});
      setting.masses.push_back(0.3 / (side * side));
      setting.free.push_back(y == 0 && (x == 0 || x == side - 1) ? 0 : 1);
    }
  }
  struct Kind {
    int dx, dy;
    double stiffness;
  };
  constexpr Kind kinds[]{{1, 0, 200}, {0, 1, 200}, {1, 1, 40}, {-1, 1, 40}, {2, 0, 1}, {0, 2, 1}};
  std::vector<std::vector<std::int32_t>> springs_of(setting.positions.size());
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      for (const Kind& kind : kinds) {
        const int ox = x + kind.dx, oy = y + kind.dy;
        if (ox < 0 || ox >= side || oy >= side) continue;
        for (const int node : {at(x, y), at(ox, oy)}) {
          springs_of[static_cast<std::size_t>(node)].push_back(static_cast<std::int32_t>(setting.springs.size()));
        }
        setting.springs.push_back({{at(x, y), at(ox, oy)}, spacing * std::hypot(kind.dx, kind.dy), kind.stiffness});
      }
    }
  }
  setting.first.push_back(0);
  for (const auto& springs : springs_of) {
    setting.touches.insert(setting.touches.end(), springs.begin(), springs.end());
    setting.first.push_back(static_cast<std::int32_t>(setting.touches.size()));
  }
  return setting;
}

}  // namespace sheet
