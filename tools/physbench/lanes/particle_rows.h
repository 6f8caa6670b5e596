// Particles and cloth: rows of neighbours, and of springs.
#pragma once

#include "bench.h"

namespace physgen::lane_kernels {

template <class Real>
void measure_particles(const Bench& bench) {
  constexpr int side = 36;
  const index_t n = side * side * side;
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> shift(Real(-0.3), Real(0.3));
  o::ParticleArray<Real> array(n);
  randomise(array, random);
  const auto view = array.view();
  for (index_t i = 0; i < n; ++i) {
    view[i].x() = Vector3<Real>(Real(i % side) + shift(random), Real(i / side % side) + shift(random),
                                Real(i / side / side) + shift(random));
  }
  std::vector<std::vector<o::Entry<Real>>> lists(u(n));
  const Real radius = Real(1.8);
  for (index_t i = 0; i < n; ++i) {
    for (int d = 0; d < 125; ++d) {
      const int a = d % 5 - 2, b = d / 5 % 5 - 2, c = d / 25 - 2;
      const index_t x = i % side + a, y = i / side % side + b, z = i / side / side + c;
      if (x < 0 || y < 0 || z < 0 || x >= side || y >= side || z >= side) continue;
      const index_t j = x + side * (y + side * z);
      if (j != i && (view[i].x().get() - view[j].x().get()).norm() < radius)
        lists[u(i)].push_back({static_cast<std::int32_t>(j)});
    }
  }
  const auto rows = RowsOf<Real, o::EntryArray<Real>>::from_lists({"other", n}, lists);
  auto plain = structs(array);
  std::vector<std::int32_t> first{0}, others;
  for (const auto& list : lists) {
    for (const auto& entry : list) others.push_back(entry.other);
    first.push_back(static_cast<std::int32_t>(others.size()));
  }
  const Real radius2 = radius * radius, factor = Real(0.3), viscosity = Real(0.1);
  bench.row<Real>(
      "particle density", n, Density<decltype(rows.view()), decltype(view), Real>{rows.view(), view, radius2, factor},
      [&] {
        for (std::size_t i = 0; i < plain.size(); ++i) {
          Real sum = 0;
          for (std::int32_t k = first[i]; k < first[i + 1]; ++k) {
            const auto& other = plain[u(others[u(k)])];
            const Vector3<Real> d = plain[i].x - other.x;
            const Real w = std::max(radius2 - d.squaredNorm(), Real(0));
            sum += other.m * factor * w * w * w;
          }
          plain[i].rho = sum;
        }
      },
      [&] { return bits(array); });
  bench.row<Real>(
      "particle forces", n,
      ParticleForces<decltype(rows.view()), decltype(view), Real>{rows.view(), view, radius, viscosity},
      [&] {
        for (std::size_t i = 0; i < plain.size(); ++i) {
          Vector3<Real> sum = Vector3<Real>::Zero();
          const auto& own = plain[i];
          for (std::int32_t k = first[i]; k < first[i + 1]; ++k) {
            const auto& other = plain[u(others[u(k)])];
            const Vector3<Real> d = own.x - other.x, v = other.v - own.v;
            const Real r = std::sqrt(d.squaredNorm()) + Real(1e-6), w = std::max(radius - r, Real(0));
            const Real volume = other.m / other.rho;
            sum += d * (volume * (own.p + other.p) * w * w / r) + v * (viscosity * volume * w);
          }
          plain[i].f = sum;
        }
      },
      [&] { return bits(array); });
}

template <class Real>
void measure_cloth(const Bench& bench) {
  constexpr int side = 300;
  const index_t n = side * side;
  std::mt19937 random(2);
  o::ClothNodeArray<Real> nodes(n);
  o::DirectionArray<Real> directions(n);
  randomise(nodes, random);
  randomise(directions, random);
  std::vector<std::array<std::int32_t, 2>> ends;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 0}, {0, 2}}) {
        if (x + a >= 0 && x + a < side && y + b < side) ends.push_back({x + side * y, x + a + side * (y + b)});
      }
    }
  }
  const index_t count = static_cast<index_t>(ends.size());
  o::SpringArray<Real> springs(count);
  randomise(springs, random);
  std::vector<std::vector<o::Entry<Real>>> lists(u(n));
  for (index_t s = 0; s < count; ++s) {
    springs.view()[s].ends() = Eigen::Vector2i(ends[u(s)][0], ends[u(s)][1]);
    for (const std::int32_t end : ends[u(s)]) lists[u(end)].push_back({static_cast<std::int32_t>(s)});
  }
  const auto rows = RowsOf<Real, o::EntryArray<Real>>::from_lists({"other", count}, lists);
  std::vector<std::int32_t> first{0}, touching;
  for (const auto& list : lists) {
    for (const auto& entry : list) touching.push_back(entry.other);
    first.push_back(static_cast<std::int32_t>(touching.size()));
  }
  auto plain_nodes = structs(nodes);
  auto plain_directions = structs(directions);
  auto plain_springs = structs(springs);
  const auto row_view = rows.view();
  const auto spring_view = springs.const_view();
  static volatile double total;  // keeps the sums
  bench.row<Real>(
      "spring product", n,
      SpringProduct<decltype(row_view), decltype(spring_view), decltype(directions.view())>{row_view, spring_view,
                                                                                            directions.view()},
      [&] {
        double sum = 0;
        for (std::size_t i = 0; i < plain_directions.size(); ++i) {
          const Vector3<Real> p = plain_directions[i].p;
          Vector3<Real> q = p;
          for (std::int32_t k = first[i]; k < first[i + 1]; ++k) {
            const auto& spring = plain_springs[u(touching[u(k)])];
            const auto other = spring.ends[0] + spring.ends[1] - static_cast<std::int32_t>(i);
            const Vector3<Real> d = plain_directions[u(other)].p - p;
            q += spring.J * d;
          }
          plain_directions[i].q = q;
          sum += p.dot(q);
        }
        total = sum;
      },
      [&] { return bits(directions); });
  bench.row<Real>(
      "spring forces", n,
      SpringForces<decltype(row_view), decltype(spring_view), decltype(nodes.view())>{row_view, spring_view,
                                                                                      nodes.view()},
      [&] {
        for (std::size_t i = 0; i < plain_nodes.size(); ++i) {
          const Vector3<Real> x = plain_nodes[i].x, v = plain_nodes[i].v;
          Vector3<Real> f = Vector3<Real>::Zero();
          for (std::int32_t k = first[i]; k < first[i + 1]; ++k) {
            const auto& spring = plain_springs[u(touching[u(k)])];
            const auto& other = plain_nodes[u(spring.ends[0] + spring.ends[1] - static_cast<std::int32_t>(i))];
            const Vector3<Real> d = other.x - x, w = other.v - v;
            const Real length = std::sqrt(d.squaredNorm());
            f += d * (spring.stiffness * (length - spring.length) / length) + w * spring.damping;
          }
          plain_nodes[i].f = f;
        }
      },
      [&] { return bits(nodes); });
  bench.row<Real>(
      "spring Jacobians", count,
      SpringJacobians<decltype(springs.view()), decltype(nodes.const_view())>{springs.view(), nodes.const_view()},
      [&] {
        for (auto& spring : plain_springs) {
          const Vector3<Real> d = plain_nodes[u(spring.ends[1])].x - plain_nodes[u(spring.ends[0])].x;
          const Real inverse = 1 / std::sqrt(d.squaredNorm());
          const Vector3<Real> e = d * inverse;
          const Real k = spring.stiffness, ratio = spring.length * inverse;
          for (int c = 0; c < 3; ++c) {
            for (int r = 0; r < 3; ++r) spring.J(r, c) = k * ratio * e[r] * e[c] + (r == c ? k * (1 - ratio) : 0);
          }
        }
      },
      [&] { return bits(springs); });
  bench.row<Real>(
      "spring forces, added", count,
      AddSpringForces<decltype(spring_view), decltype(nodes.view())>{spring_view, nodes.view()},
      [&] {
        for (const auto& spring : plain_springs) {
          auto &a = plain_nodes[u(spring.ends[0])], &b = plain_nodes[u(spring.ends[1])];
          const Vector3<Real> d = b.x - a.x;
          const Real length = std::sqrt(d.squaredNorm());
          const Vector3<Real> f = d * (spring.stiffness * (length - spring.length) / length);
          a.f += f;
          b.f -= f;
        }
      },
      [&] { return 0; });
  bench.row<Real>(
      "advance", n, Advance<decltype(nodes.view()), Real>{nodes.view(), Real(1e-9)},
      [&] {
        for (auto& node : plain_nodes) {
          node.v += node.f * Real(1e-9);
          node.x += node.v * Real(1e-9);
        }
      },
      [&] { return 0; });
  bench.row<Real>(
      "dot product", n, Dot<decltype(directions.const_view())>{directions.const_view()},
      [&] {
        double sum = 0;
        for (const auto& one : plain_directions) sum += one.p.dot(one.q);
        total = sum;
      },
      [&] { return 0; });
}

}  // namespace physgen::lane_kernels
