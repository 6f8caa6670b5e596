// The points, not the tets, are sorted into a grid of boxes: there are usually fewer of them. Each tet then looks at
// the points in the boxes that it overlaps.
#include <fem/mesh/locate.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace physgen::fem {

namespace {

struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity()};
  Point high{-low[0], -low[1], -low[2]};

  void include(const Point& x) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  [[nodiscard]] bool contains(const Point& x) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(x[k] >= low[k] && x[k] <= high[k])) return false;
    }
    return true;
  }
};

// Numbers of points by boxes of one size, about as many boxes as points.
class Grid {
 public:
  explicit Grid(std::span<const Point> points) {
    for (const Point& x : points) bounds_.include(x);
    const auto most = static_cast<std::size_t>(std::cbrt(static_cast<double>(points.size()))) + 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = bounds_.high[k] - bounds_.low[k];
      if (length > 0 && static_cast<double>(most) / length < std::numeric_limits<double>::infinity()) {
        boxes_[k] = most;
        per_length_[k] = static_cast<double>(most) / length;
      }
    }
    first_.assign(boxes_[0] * boxes_[1] * boxes_[2] + 1, 0);
    const auto box_of = [this](const Point& x) { return box(index(0, x[0]), index(1, x[1]), index(2, x[2])); };
    for (const Point& x : points) ++first_[box_of(x) + 1];
    for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    members_.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) members_[next[box_of(points[p])]++] = p;
  }

  template <class Visit>
  void visit_points_near(const Box& region, const Visit& visit) const {
    std::array<std::size_t, 3> from{};
    std::array<std::size_t, 3> to{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(region.high[k] >= bounds_.low[k] && region.low[k] <= bounds_.high[k])) return;
      from[k] = index(k, region.low[k]);
      to[k] = index(k, region.high[k]);
    }
    for (std::size_t z = from[2]; z <= to[2]; ++z) {
      for (std::size_t y = from[1]; y <= to[1]; ++y) {
        for (std::size_t m = first_[box(from[0], y, z)]; m < first_[box(to[0], y, z) + 1]; ++m) visit(members_[m]);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t index(std::size_t k, double x) const {
    const double i = (x - bounds_.low[k]) * per_length_[k];
    return i > 0 ? static_cast<std::size_t>(std::min(i, static_cast<double>(boxes_[k] - 1))) : 0;
  }
  [[nodiscard]] std::size_t box(std::size_t x, std::size_t y, std::size_t z) const {
    return x + boxes_[0] * (y + boxes_[1] * z);
  }

  Box bounds_;
  std::array<std::size_t, 3> boxes_{1, 1, 1};
  Point per_length_{0, 0, 0};
  std::vector<std::size_t> first_, members_;
};

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double det(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// The weights of the corners, as quotients of volumes; not finite where the tet has no volume.
std::array<double, 4> weights(const std::array<Point, 4>& corners, const Point& x) {
  const Point a = minus(corners[1], corners[0]);
  const Point b = minus(corners[2], corners[0]);
  const Point c = minus(corners[3], corners[0]);
  const Point d = minus(x, corners[0]);
  const double volume = det(a, b, c);
  std::array<double, 4> w{0, det(d, b, c) / volume, det(a, d, c) / volume, det(a, b, d) / volume};
  w[0] = 1 - w[1] - w[2] - w[3];
  return w;
}

// The box of a tet, and of all points within the tolerance of it.
Box box_of(const std::array<Point, 4>& corners) {
  Box box;
  for (const Point& x : corners) box.include(x);
  for (std::size_t k = 0; k < 3; ++k) {
    const double margin = 8 * locate_tolerance * (box.high[k] - box.low[k]);  // 4 weights, twice over for rounding
    box.low[k] -= margin;
    box.high[k] += margin;
  }
  return box;
}

std::string text(const Point& x) {
  std::ostringstream text;
  text.precision(10);
  text << "(" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  return text.str();
}

}  // namespace

std::vector<Location> locate(std::span<const Point> rest, const TetMesh& mesh, std::span<const Point> points) {
  if (rest.size() != static_cast<std::size_t>(mesh.nodes)) {
    throw Error("locate: " + std::to_string(rest.size()) + " positions for " + std::to_string(mesh.nodes) + " nodes");
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::all_of(points[p].begin(), points[p].end(), finite)) {
      throw OutsideMesh(p, "locate: point " + std::to_string(p) + " " + text(points[p]) + " is not finite");
    }
  }
  std::vector<Location> found(points.size(), {-1, {}});
  std::vector<double> depth(points.size(), -std::numeric_limits<double>::infinity());  // smallest weight
  Box bounds;
  const Grid grid(points);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    std::array<Point, 4> corners{};
    for (std::size_t c = 0; c < 4; ++c) corners[c] = rest[static_cast<std::size_t>(mesh.tets[t][c])];
    const Box box = box_of(corners);
    for (const Point& corner : corners) bounds.include(corner);
    grid.visit_points_near(box, [&](std::size_t p) {
      if (!box.contains(points[p])) return;
      const std::array<double, 4> w = weights(corners, points[p]);
      const double smallest = std::min({w[0], w[1], w[2], w[3]});
      if (std::isfinite(w[0]) && smallest >= -locate_tolerance && smallest > depth[p]) {
        depth[p] = smallest;
        found[p] = {static_cast<Index>(t), w};
      }
    });
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (found[p].tet < 0) {
      throw OutsideMesh(p, "locate: point " + std::to_string(p) + " " + text(points[p]) +
                               " m lies in no tet; the mesh lies between " + text(bounds.low) + " and " +
                               text(bounds.high));
    }
  }
  return found;
}

}  // namespace physgen::fem
