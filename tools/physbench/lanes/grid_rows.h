// Hexahedra and cells of grids.
#pragma once

#include <elasticity.physgen.h>

#include "bench.h"

namespace physgen::lane_kernels {

template <class Real>
void measure_hexahedra(const Bench& bench) {
  constexpr int side = 48;
  constexpr int points = side + 1;
  const index_t n = points * points * points, count = side * side * side;
  std::mt19937 random(3);
  elasticity::NodePositionArray<Real> positions(n);
  elasticity::NodeForceArray<Real> sums(n);
  o::HexahedronArray<Real> hexahedra(count);
  o::CornerForceArray<Real> corner_forces(8 * count);
  randomise(positions, random);
  randomise(corner_forces, random);
  std::vector<std::vector<o::Entry<Real>>> lists(u(n));
  for (index_t e = 0; e < count; ++e) {
    const index_t x = e % side, y = e / side % side, z = e / side / side;
    for (int c = 0; c < 8; ++c) {
      const index_t node = x + (c ^ c >> 1) % 2 + points * (y + c / 2 % 2 + points * (z + c / 4));
      hexahedra.view()[e].nodes()[c] = static_cast<std::int32_t>(node);
      lists[u(node)].push_back({static_cast<std::int32_t>(8 * e + c)});
    }
  }
  const auto rows = RowsOf<Real, o::EntryArray<Real>>::from_lists({"other", 8 * count}, lists);
  auto plain = structs(hexahedra);
  const auto x = structs(positions);
  auto f = structs(sums);
  const auto forces = structs(corner_forces);
  std::vector<std::int32_t> first{0}, corners;
  for (const auto& list : lists) {
    for (const auto& entry : list) corners.push_back(entry.other);
    first.push_back(static_cast<std::int32_t>(corners.size()));
  }
  bench.row<Real>(
      "hexahedron volume", count,
      HexahedronVolume<decltype(hexahedra.view()), decltype(positions.const_view())>{hexahedra.view(),
                                                                                     positions.const_view()},
      [&] {
        for (auto& one : plain) {
          const auto at = [&](int c) -> const auto& { return x[u(one.nodes[c])].x; };
          const Vector3<Real> d = at(6) - at(0), a = at(1) - at(0), b = at(2) - at(5), c = at(3) - at(0),
                              e = at(4) - at(0), g = at(7) - at(2), h = at(6) - at(3);
          one.volume = (d.dot(a.cross(b)) + d.dot(c.cross(g)) + d.dot(e.cross(h))) * Real(1.0 / 6);
        }
      },
      [&] { return bits(hexahedra); });
  const auto row_view = rows.view();
  bench.row<Real>(
      "corner forces to nodes", n,
      GatherCornerForces<decltype(row_view), decltype(corner_forces.const_view()), decltype(sums.view())>{
          row_view, corner_forces.const_view(), sums.view()},
      [&] {
        for (std::size_t i = 0; i < f.size(); ++i) {
          Vector3<Real> sum = Vector3<Real>::Zero();
          for (std::int32_t k = first[i]; k < first[i + 1]; ++k) sum += forces[u(corners[u(k)])].f;
          f[i].f = sum;
        }
      },
      [&] { return bits(sums); });
}

template <class Real>
void measure_cells(const Bench& bench) {
  constexpr int side = 512;
  const index_t n = side * side;
  std::mt19937 random(4);
  o::CellArray<Real> cells(n);
  randomise(cells, random);
  std::vector<std::vector<o::Coefficient<Real>>> lists(u(n));
  for (index_t i = 0; i < n; ++i) {
    for (const index_t j : {i - side, i - 1, i, i + 1, i + side}) {
      if (j >= 0 && j < n) lists[u(i)].push_back({static_cast<std::int32_t>(j), Real(0.2)});
    }
  }
  const auto rows = RowsOf<Real, o::CoefficientArray<Real>>::from_lists({"column", n}, lists);
  auto plain = structs(cells);
  std::vector<std::int32_t> first{0};
  std::vector<o::Coefficient<Real>> entries;
  for (const auto& list : lists) {
    entries.insert(entries.end(), list.begin(), list.end());
    first.push_back(static_cast<std::int32_t>(entries.size()));
  }
  const auto row_view = rows.view();
  bench.row<Real>(
      "sparse product", n, SparseProduct<decltype(row_view), decltype(cells.view())>{row_view, cells.view()},
      [&] {
        for (std::size_t i = 0; i < plain.size(); ++i) {
          Real sum = 0;
          for (std::int32_t k = first[i]; k < first[i + 1]; ++k)
            sum += entries[u(k)].value * plain[u(entries[u(k)].column)].u;
          plain[i].next = sum;
        }
      },
      [&] { return bits(cells); });
  const int last = static_cast<int>(n) - 1;
  bench.row<Real>(
      "stencil", n, Stencil<decltype(cells.view()), Real>{cells.view(), Real(0.1), side, last},
      [&] {
        for (int i = 0; i <= last; ++i) {
          const auto at = [&](int k) { return plain[u(std::clamp(k, 0, last))].u; };
          const Real own = plain[u(i)].u;
          plain[u(i)].next = own + Real(0.1) * (at(i - 1) + at(i + 1) + at(i - side) + at(i + side) - 4 * own);
        }
      },
      [&] { return bits(cells); });
  bench.row<Real>(
      "potential", n, Potential<decltype(cells.view())>{cells.view()},
      [&] {
        for (auto& cell : plain) cell.next = std::exp(-cell.u * cell.u) * std::log(1 + cell.u * cell.u);
      },
      [&] { return bits(cells); });
}

}  // namespace physgen::lane_kernels
