// The program as one writes it without a library: loops over arrays of structs.
#include <algorithm>
#include <cmath>

#include "../report.h"
#include "runs.h"

namespace sheet {

namespace {

struct Node {
  Point x, v;
  double m, free;
};
struct Search {
  Point dv, r, p, q;
};
struct Spring {
  std::array<std::int32_t, 2> ends;
  double length, stiffness;
  Point f;
  std::array<double, 6> J;  // xx yx zx yy zy zz
};

double dot(const Point& a, const Point& b) { return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]); }

Point times(const std::array<double, 6>& J, const Point& p) {
  return {dot({J[0], J[1], J[2]}, p), dot({J[1], J[3], J[4]}, p), dot({J[2], J[4], J[5]}, p)};
}

struct PlainSheet {
  std::vector<Node> nodes;
  std::vector<Search> search;
  std::vector<Spring> springs;
  const std::vector<std::int32_t>&first, &touches;
  double h, gravity;

  explicit PlainSheet(const Setting& setting)
      : search(setting.positions.size()),
        first(setting.first),
        touches(setting.touches),
        h(setting.step),
        gravity(setting.gravity) {
    for (std::size_t i = 0; i < setting.positions.size(); ++i) {
      nodes.push_back({setting.positions[i], {}, setting.masses[i], setting.free[i]});
    }
    for (const Link& link : setting.springs) springs.push_back({link.ends, link.length, link.stiffness, {}, {}});
  }

  void compute_springs() {
    for (Spring& spring : springs) {
      const Point &a = nodes[static_cast<std::size_t>(spring.ends[0])].x,
                  &b = nodes[static_cast<std::size_t>(spring.ends[1])].x;
      const Point edge{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
      const double length = std::sqrt(dot(edge, edge));
      const Point d{edge[0] / length, edge[1] / length, edge[2] / length};
      const double across = spring.stiffness * std::max(1 - spring.length / length, 0.0);
      const double along = spring.stiffness - across, pull = spring.stiffness * (length - spring.length);
      spring.f = {d[0] * pull, d[1] * pull, d[2] * pull};
      spring.J = {d[0] * d[0] * along + across, d[1] * d[0] * along, d[2] * d[0] * along,
                  d[1] * d[1] * along + across, d[2] * d[1] * along, d[2] * d[2] * along + across};
    }
  }

  double begin_search() {
    double square = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Node& node = nodes[i];
      Point force{};
      for (auto e = static_cast<std::size_t>(first[i]); e < static_cast<std::size_t>(first[i + 1]); ++e) {
        const Spring& spring = springs[static_cast<std::size_t>(touches[e])];
        const auto [a, b] = spring.ends;
        const Point& v = nodes[static_cast<std::size_t>(a + b) - i].v;
        const Point change = times(spring.J, {node.v[0] - v[0], node.v[1] - v[1], node.v[2] - v[2]});
        const double sign = static_cast<std::size_t>(a) == i ? 1 : -1;
        for (std::size_t k = 0; k < 3; ++k) force[k] += spring.f[k] * sign - change[k] * h;
      }
      force[2] += node.m * gravity;
      Search& s = search[i];
      s.dv = {};
      for (std::size_t k = 0; k < 3; ++k) s.p[k] = s.r[k] = force[k] * (h * node.free);
      square += dot(s.r, s.r);
    }
    return square;
  }

  double multiply() {
    double product = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Search& s = search[i];
      Point sum{};
      for (auto e = static_cast<std::size_t>(first[i]); e < static_cast<std::size_t>(first[i + 1]); ++e) {
        const Spring& spring = springs[static_cast<std::size_t>(touches[e])];
        const auto [a, b] = spring.ends;
        const Point& p = search[static_cast<std::size_t>(a + b) - i].p;
        const Point change = times(spring.J, {s.p[0] - p[0], s.p[1] - p[1], s.p[2] - p[2]});
        for (std::size_t k = 0; k < 3; ++k) sum[k] += change[k];
      }
      for (std::size_t k = 0; k < 3; ++k) s.q[k] = (s.p[k] * nodes[i].m + sum[k] * (h * h)) * nodes[i].free;
      product += dot(s.p, s.q);
    }
    return product;
  }

  double step(double alpha) {
    double square = 0;
    for (Search& s : search) {
      for (std::size_t k = 0; k < 3; ++k) {
        s.dv[k] += s.p[k] * alpha;
        s.r[k] -= s.q[k] * alpha;
      }
      square += dot(s.r, s.r);
    }
    return square;
  }

  void turn(double beta) {
    for (Search& s : search) {
      for (std::size_t k = 0; k < 3; ++k) s.p[k] = s.r[k] + s.p[k] * beta;
    }
  }

  void move() {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        nodes[i].v[k] += search[i].dv[k];
        nodes[i].x[k] += nodes[i].v[k] * h;
      }
    }
  }
};

}  // namespace

Result run_plain(const Setting& setting, int steps) {
  PlainSheet sheet(setting);
  Result result;
  for (int step = 0; step < steps; ++step) {
    result.spring_seconds += ports::seconds_of([&] { sheet.compute_springs(); });
    result.search_seconds += ports::seconds_of([&] {
      double square = sheet.begin_search();
      const double enough = setting.tolerance * setting.tolerance * square;
      for (int k = 0; k < setting.most_iterations && square > enough; ++k) {
        const double next = sheet.step(square / sheet.multiply());
        sheet.turn(next / square);
        square = next;
        ++result.iterations;
      }
      sheet.move();
    });
  }
  for (const Node& node : sheet.nodes) result.positions.push_back(node.x);
  return result;
}

}  // namespace sheet
