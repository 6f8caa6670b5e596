// The program as one writes it without a library: loops over an array of structs.
#include <algorithm>
#include <cmath>

#include "../report.h"
#include "runs.h"

namespace fluid {

namespace {

struct Particle {
  Point x, v, f;
  float rho, p;
};

void compute_density(std::vector<Particle>& particles, const NeighbourLists& lists, const Water& water) {
  const float square = water.reach * water.reach;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Point& x = particles[i].x;
    float sum = 0;
    for (auto e = static_cast<std::size_t>(lists.first[i]); e < static_cast<std::size_t>(lists.first[i + 1]); ++e) {
      const Particle& other = particles[static_cast<std::size_t>(lists.entries[e])];
      const float dx = x[0] - other.x[0], dy = x[1] - other.x[1], dz = x[2] - other.x[2];
      const float left = std::max(square - (dx * dx + (dy * dy + dz * dz)), 0.0F);
      sum += left * left * left;
    }
    particles[i].rho = water.mass * water.poly6 * sum;
    particles[i].p = water.stiffness * (particles[i].rho - water.rest);
  }
}

void compute_forces(std::vector<Particle>& particles, const NeighbourLists& lists, const Water& water) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Particle& one = particles[i];
    Point f{};
    for (auto e = static_cast<std::size_t>(lists.first[i]); e < static_cast<std::size_t>(lists.first[i + 1]); ++e) {
      const Particle& other = particles[static_cast<std::size_t>(lists.entries[e])];
      const Point d{one.x[0] - other.x[0], one.x[1] - other.x[1], one.x[2] - other.x[2]};
      const float r = std::sqrt(std::max(d[0] * d[0] + (d[1] * d[1] + d[2] * d[2]), 1e-12F));
      const float left = std::max(water.reach - r, 0.0F);
      const float pressure = water.mass * water.spiky * (one.p + other.p) / (2.0F * other.rho) * (left * left) / r;
      const float viscosity = water.viscosity * water.mass * water.laplacian * left / other.rho;
      for (std::size_t k = 0; k < 3; ++k) f[k] += d[k] * pressure + (other.v[k] - one.v[k]) * viscosity;
    }
    particles[i].f = f;
  }
}

void move(std::vector<Particle>& particles, const Water& water) {
  for (Particle& one : particles) {
    for (std::size_t k = 0; k < 3; ++k) {
      one.v[k] += water.step * (one.f[k] / one.rho + (k == 2 ? water.gravity : 0.0F));
      one.x[k] += water.step * one.v[k];
      const bool below = one.x[k]<0, above = one.x[k]> water.side;
      if (below || above) one.v[k] = -0.5F * one.v[k];
      if (below) {
        one.x[k] = -one.x[k];
      } else if (above) {
        one.x[k] = 2.0F * water.side - one.x[k];
      }
    }
  }
}

std::vector<Point> positions_of(const std::vector<Particle>& particles) {
  std::vector<Point> positions;
  positions.reserve(particles.size());
  for (const Particle& one : particles) positions.push_back(one.x);
  return positions;
}

}  // namespace

Result run_plain(const Setting& setting, int steps) {
  const Water& water = setting.water;
  std::vector<Particle> particles;
  for (const Point& x : setting.positions) particles.push_back({x, {}, {}, 0, 0});
  Result result;
  for (int step = 0; step < steps; ++step) {
    NeighbourLists lists;
    result.row_seconds += ports::seconds_of([&] {
      if (step % steps_between_orders == 0) {
        std::vector<Particle> ordered;
        ordered.reserve(particles.size());
        for (const std::int64_t i : order_by_cell(positions_of(particles), water.reach)) {
          ordered.push_back(particles[static_cast<std::size_t>(i)]);
        }
        particles.swap(ordered);
      }
      lists = find_neighbours(positions_of(particles), water.reach);
    });
    result.kernel_seconds += ports::seconds_of([&] {
      compute_density(particles, lists, water);
      compute_forces(particles, lists, water);
      move(particles, water);
    });
    result.neighbours = lists.entries.size();
  }
  result.positions = positions_of(particles);
  return result;
}

}  // namespace fluid
