// A sheet of point masses and springs that hangs at two corners, and an implicit step of it (Baraff and Witkin 1998):
// conjugate gradients without a matrix, over the springs of each node.
#pragma once
#include <physgen/kernel.h>
#include <physgen/parallel_reduce.h>
#include <physgen/row_arrays.h>
#include <sheet.physgen.h>
namespace sheet {
using namespace physgen;
constexpr double h = 0.002, gravity = -9.81, tolerance = 1e-10;  // h: the time step [s]
constexpr int most_iterations = 100;
struct Cloth {
  NodeArray<double> nodes;
  SearchArray<double> search;
  SpringArray<double> springs;
  RowArrays<RangeArray<double>, TouchArray<double>> touches;
  explicit Cloth(int side) : search(side * side) {  // level, 1 m wide, of 0.3 kg
    constexpr int kinds[][3]{{1, 0, 200}, {0, 1, 200}, {1, 1, 40}, {-1, 1, 40}, {2, 0, 1}, {0, 2, 1}};
    std::vector<std::pair<index_t, Touch<double>>> ends;
    const double spacing = 1.0 / (side - 1);
    for (int i = 0; i < side * side; ++i) {
      const int x = i % side, y = i / side;
      const double z = 0.01 * std::sin(7.0 * spacing * x * y), free = y == 0 && (x == 0 || x == side - 1) ? 0 : 1;
      nodes.push_back({{spacing * x, spacing * y, z}, {0, 0, 0}, 0.3 / (side * side), free});
      for (const auto& [dx, dy, stiffness] : kinds) {
        if (x + dx < 0 || x + dx >= side || y + dy >= side) continue;
        const int j = i + dx + side * dy, spring = static_cast<int>(springs.size());
        springs.push_back(
            {{i, j}, spacing * std::hypot(dx, dy), double(stiffness), {0, 0, 0}, Eigen::Matrix3d::Zero()});
        ends.insert(ends.end(), {{i, {spring}}, {j, {spring}}});
      }
    }
    touches = decltype(touches)::from_pairs({"spring", springs.size()}, nodes.size(), ends);
  }
  // Kernels take one object at a time: packs would collect the 13 numbers of each spring lane by lane.
  void compute_springs() {  // forces and their derivatives, less what makes these indefinite under compression
    each(springs.size(), [k = springs.view(), x = nodes.const_view()](index_t i) {
      const auto spring = k.get(i);
      const auto edge = x[spring.ends[1]].x().get() - x[spring.ends[0]].x().get();
      const double length = std::sqrt(edge.squaredNorm()), stretch = spring.stiffness * (length - spring.length);
      const double across = spring.stiffness * std::max(1 - spring.length / length, 0.0);
      const auto d = (edge / length).eval();
      k[i].f() = d * stretch;
      k[i].J() = d * d.transpose() * (spring.stiffness - across) + Eigen::Matrix3d::Identity() * across;
    });
  }
  int solve_and_move() {  // returns the iterations
    const auto [x, s, k, rows] = std::tuple(nodes.view(), search.view(), springs.const_view(), touches.const_view());
    double square = total([=](index_t i) {  // the residual of dv = 0: h (f - h J v), of free nodes
      const auto node = x.get(i);
      auto force = rows.sum(i, Eigen::Vector3d(0, 0, 0), [&](const auto& touch) -> Eigen::Vector3d {
        const auto spring = k.get(touch.spring());
        const auto dv = node.v - x[spring.ends.sum() - i].v().get();
        return spring.f * (spring.ends[0] == i ? 1 : -1) - spring.J * dv * h;
      });
      force[2] += node.m * gravity;
      const auto r = (force * (h * node.free)).eval();
      s.put(i, {{0, 0, 0}, r, r, {0, 0, 0}});
      return r.squaredNorm();
    });
    const double enough = tolerance * tolerance * square;
    int iterations = 0;
    for (; iterations < most_iterations && square > enough; ++iterations) {
      const double product = total([=](index_t i) {  // p . q for q = (M + h^2 J) p, of free nodes
        const auto p = s[i].p().get();
        const auto Jp = rows.sum(i, Eigen::Vector3d(0, 0, 0), [&](const auto& touch) -> Eigen::Vector3d {
          const auto spring = k.get(touch.spring());
          return spring.J * (p - s[spring.ends.sum() - i].p().get());
        });
        s[i].q() = (p * x[i].m() + Jp * (h * h)) * x[i].free();
        return p.dot(s[i].q().get());
      });
      const double next = total([=](index_t i) {  // a step along p
        const auto r = (s[i].r().get() - s[i].q().get() * (square / product)).eval();
        s[i].dv() += s[i].p().get() * (square / product);
        s[i].r() = r;
        return r.squaredNorm();
      });
      each(nodes.size(), [=](index_t i) { s[i].p() = s[i].r().get() + s[i].p().get() * (next / square); });
      square = next;
    }
    each(nodes.size(), [=](index_t i) {
      x[i].v() += s[i].dv().get();
      x[i].x() += x[i].v().get() * h;
    });
    return iterations;
  }
  static void each(index_t n, const auto& kernel) { parallel_for(Host{}, n, lanes<1>(kernel)); }
  double total(const auto& kernel) const { return sum(Host{}, nodes.size(), lanes<1>(kernel)); }
};
}  // namespace sheet
