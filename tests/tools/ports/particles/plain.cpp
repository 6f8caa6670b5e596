// The program as one writes it without a library: loops over an array of structs, and a cell list.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "../report.h"
#include "particles.h"
#include "runs.h"

namespace plain {

using fluid::Point;
using fluid::Water;

namespace {

struct Particle {
  Point x, v, f;
  float rho, p;
};

struct Cells {
  std::array<int, 3> counts{};
  std::vector<std::int32_t> first, members;        // of each cell
  std::vector<std::int32_t> first_neighbour, all;  // of each particle

  [[nodiscard]] int along(const Water& water, const Point& x, std::size_t k) const {
    const auto box = static_cast<double>(water.box[k]);
    return std::min(static_cast<int>(static_cast<double>(x[k]) * (counts[k] / box)), counts[k] - 1);
  }
  [[nodiscard]] std::size_t at(int x, int y, int z) const {
    return static_cast<std::size_t>(x + counts[0] * (y + counts[1] * z));
  }

  void build(const std::vector<Particle>& particles, const Water& water) {
    for (std::size_t k = 0; k < 3; ++k) counts[k] = static_cast<int>(water.box[k] / water.reach);
    first.assign(at(0, 0, counts[2]) + 1, 0);
    members.resize(particles.size());
    const auto cell = [&](const Point& x) { return at(along(water, x, 0), along(water, x, 1), along(water, x, 2)); };
    for (const Particle& one : particles) ++first[cell(one.x) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      members[static_cast<std::size_t>(next[cell(particles[i].x)]++)] = static_cast<std::int32_t>(i);
    }
    first_neighbour.assign(1, 0);
    all.clear();
    const float square = water.reach * water.reach;
    for (const Particle& one : particles) {
      std::array<int, 3> low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::max(along(water, one.x, k) - 1, 0);
        high[k] = std::min(along(water, one.x, k) + 1, counts[k] - 1);
      }
      for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
          const std::int32_t end = first[at(high[0], y, z) + 1];  // cells along x lie one behind the other
          for (std::int32_t m = first[at(low[0], y, z)]; m < end; ++m) {
            const std::int32_t j = members[static_cast<std::size_t>(m)];
            const Point& x = particles[static_cast<std::size_t>(j)].x;
            const float dx = one.x[0] - x[0], dy = one.x[1] - x[1], dz = one.x[2] - x[2];
            if (dx * dx + (dy * dy + dz * dz) < square) all.push_back(j);
          }
        }
      }
      first_neighbour.push_back(static_cast<std::int32_t>(all.size()));
    }
  }
};

void compute_density(std::vector<Particle>& particles, const Cells& cells, const Water& water) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Particle& one = particles[i];
    float sum = 0;
    for (std::int32_t e = cells.first_neighbour[i]; e < cells.first_neighbour[i + 1]; ++e) {
      const Point& x = particles[static_cast<std::size_t>(cells.all[static_cast<std::size_t>(e)])].x;
      const float dx = one.x[0] - x[0], dy = one.x[1] - x[1], dz = one.x[2] - x[2];
      const float left = std::max(water.reach * water.reach - (dx * dx + (dy * dy + dz * dz)), 0.0F);
      sum += left * left * left;
    }
    one.rho = water.mass * water.poly6 * sum;
    one.p = std::max(water.stiffness * (one.rho - water.rest), 0.0F);
  }
}

void compute_forces(std::vector<Particle>& particles, const Cells& cells, const Water& water) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Particle& one = particles[i];
    Point f{};
    for (std::int32_t e = cells.first_neighbour[i]; e < cells.first_neighbour[i + 1]; ++e) {
      const Particle& other = particles[static_cast<std::size_t>(cells.all[static_cast<std::size_t>(e)])];
      const Point d{one.x[0] - other.x[0], one.x[1] - other.x[1], one.x[2] - other.x[2]};
      const float r = std::sqrt(std::max(d[0] * d[0] + (d[1] * d[1] + d[2] * d[2]), 1e-12F));
      const float left = std::max(water.reach - r, 0.0F), factor = water.mass * water.spiky * left / other.rho;
      const float pressure = factor * left * (one.p + other.p) / (2.0F * r), viscosity = water.viscosity * factor;
      for (std::size_t k = 0; k < 3; ++k) f[k] += d[k] * pressure + (other.v[k] - one.v[k]) * viscosity;
    }
    one.f = f;
  }
}

void move(std::vector<Particle>& particles, const Water& water) {
  for (Particle& one : particles) {
    for (std::size_t k = 0; k < 3; ++k) {
      one.v[k] += water.step * (one.f[k] / one.rho + (k == 2 ? water.gravity : 0.0F));
      one.x[k] += water.step * one.v[k];
      const bool below = one.x[k]<0, above = one.x[k]> water.box[k];
      if (below || above) one.v[k] = -0.5F * one.v[k];
      if (below) {
        one.x[k] = -one.x[k];
      } else if (above) {
        one.x[k] = 2.0F * water.box[k] - one.x[k];
      }
    }
  }
}

}  // namespace

}  // namespace plain

namespace fluid {

Result run_plain(int side, int steps) {
  Water water;
  water.box = box_of(side);
  std::vector<plain::Particle> particles;
  for (int i = 0; i < side * side * side; ++i) particles.push_back({position_of(i, side), {}, {}, 0, 0});
  Result result;
  plain::Cells cells;
  for (int step = 0; step < steps; ++step) {
    result.row_seconds += ports::seconds_of([&] {
      if (step % steps_between_orders == 0 && step > 0) {
        std::vector<plain::Particle> ordered;
        ordered.reserve(particles.size());
        for (const std::int32_t i : cells.members) ordered.push_back(particles[static_cast<std::size_t>(i)]);
        particles.swap(ordered);
      }
      cells.build(particles, water);
    });
    result.kernel_seconds += ports::seconds_of([&] {
      plain::compute_density(particles, cells, water);
      plain::compute_forces(particles, cells, water);
      plain::move(particles, water);
    });
  }
  result.neighbours = cells.all.size();
  for (const plain::Particle& one : particles) result.positions.push_back(one.x);
  return result;
}

}  // namespace fluid
