#include "fields.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "deformation.h"

namespace physgen::truthcube {

using fem::Index;

namespace {

Eigen::Matrix3d cauchy_stress(const TetState& tet, const Eigen::Matrix3d& F, double J, Strain strain) {
  const Eigen::Matrix3d stress = Eigen::Map<const Eigen::Matrix3d>(tet.stress.data());
  return strain == Strain::finite ? (stress * F.transpose() / J).eval() : stress;
}

/// Calls body(numbers) with what rows are of, a window at a time. @param of_rows as in DrawnRows
template <class Body>
void each_window_of(const std::vector<Index>& of_rows, std::size_t all, std::size_t most, const Body& body) {
  if (of_rows.empty()) return each_window(0, all, most, body);
  const std::span<const Index> rows = of_rows;
  for (std::size_t first = 0; first < rows.size(); first += most) {
    body(rows.subspan(first, std::min(most, rows.size() - first)));
  }
}

}  // namespace

DrawnFields::DrawnFields(const fem::TetMesh& mesh, std::span<const fem::Point> rest, Strain strain, DrawnRows rows,
                         std::size_t window)
    : mesh_(mesh), rest_(rest), strain_(strain), rows_(std::move(rows)), window_(window) {
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (t % tets_of_block == 0) rows_of_blocks_.push_back({mesh.nodes, -1});
    auto& [low, high] = rows_of_blocks_.back();
    for (const Index n : mesh.tets[t]) {
      if (row_of(n) < 0) continue;
      low = std::min(low, row_of(n)), high = std::max(high, row_of(n));
    }
  }
}

void DrawnFields::each_cells(BodyState& state, const std::function<void(const CellFields&)>& visit) const {
  each_window_of(rows_.tets, mesh_.tets.size(), window_.tets(), [&](Numbers tets) {
    CellFields fields;
    if (state.is_here()) {
      fields.stress.resize(6 * tets.size());
      fields.von_mises.resize(tets.size());
      fields.volume_ratio.resize(tets.size());
    }
    each_tet(state, mesh_, rest_, tets, [&](std::size_t i, const TetState& tet) {
      const Eigen::Matrix3d F = deformation_gradient(tet);
      const double J = F.determinant();
      const Eigen::Matrix3d sigma = cauchy_stress(tet, F, J, strain_);
      const std::array components{sigma(0, 0), sigma(1, 1), sigma(2, 2), sigma(0, 1), sigma(1, 2), sigma(0, 2)};
      std::ranges::copy(components, fields.stress.begin() + static_cast<std::ptrdiff_t>(6 * i));
      const Eigen::Matrix3d deviator = sigma - sigma.trace() / 3 * Eigen::Matrix3d::Identity();
      fields.von_mises[i] = std::sqrt(1.5) * deviator.norm();
      fields.volume_ratio[i] = J;
    });
    if (state.is_here()) visit(fields);
  });
}

void DrawnFields::each_points(BodyState& state, const std::function<void(const PointFields&)>& visit) const {
  Index first = 0;
  each_window_of(rows_.nodes, static_cast<std::size_t>(mesh_.nodes), window_.nodes(), [&](Numbers nodes) {
    const auto end = first + static_cast<Index>(nodes.size());
    PointFields fields;
    fields.pressure.assign(state.is_here() ? nodes.size() : 0, 0.0);
    std::vector<double> volume(fields.pressure.size(), 0.0);
    std::vector<Index> tets;  // at these nodes, ascending
    const auto add = [&] {
      add_pressures(state, tets, first, fields.pressure, volume);
      tets.clear();
    };
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      const auto& [low, high] = rows_of_blocks_[t / tets_of_block];
      if (high < first || end <= low) {
        t += tets_of_block - 1 - t % tets_of_block;  // behind the block
        continue;
      }
      const auto is_here = [&](Index n) { return first <= row_of(n) && row_of(n) < end; };
      if (std::ranges::none_of(mesh_.tets[t], is_here)) continue;
      tets.push_back(static_cast<Index>(t));
      if (tets.size() == window_.tets()) add();
    }
    add();
    const std::vector<fem::Point> positions = state.positions(0, nodes);
    first = end;
    if (!state.is_here()) return;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (volume[i] > 0) fields.pressure[i] /= volume[i];
      const fem::Point& rest = rest_[static_cast<std::size_t>(nodes[i])];
      for (std::size_t k = 0; k < 3; ++k) fields.displacement.push_back(positions[i][k] - rest[k]);
    }
    visit(fields);
  });
}

void DrawnFields::add_pressures(BodyState& state, Numbers tets, Index first, std::span<double> pressure,
                                std::span<double> volume) const {
  struct Share {
    double mean, volume;
  };
  std::vector<Share> shares(state.is_here() ? tets.size() : 0);
  each_tet(state, mesh_, rest_, tets, [&](std::size_t i, const TetState& tet) {
    const Eigen::Matrix3d F = deformation_gradient(tet);
    shares[i].mean = cauchy_stress(tet, F, F.determinant(), strain_).trace() / 3;
    shares[i].volume = std::abs(edges_of(strain_ == Strain::finite ? tet.positions : tet.rest).determinant());
  });
  for (std::size_t i = 0; i < shares.size(); ++i) {  // in the order of tets, whatever the windows
    for (const Index n : mesh_.tets[static_cast<std::size_t>(tets[i])]) {
      const Index row = row_of(n) - first;
      if (row < 0 || static_cast<std::size_t>(row) >= pressure.size()) continue;
      pressure[static_cast<std::size_t>(row)] -= shares[i].volume * shares[i].mean;
      volume[static_cast<std::size_t>(row)] += shares[i].volume;
    }
  }
}

}  // namespace physgen::truthcube
