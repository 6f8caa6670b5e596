// What both programs share: the constants of the fluid, where it begins, and who is whose neighbour.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace fluid {

using Point = std::array<float, 3>;

/// The constants of Mueller et al. 2003. Their kernels are those of poly6, spiky and viscosity.
struct Water {
  float reach = 0.038F;  ///< [m]
  float mass = 0.008F;   ///< of a particle [kg]
  float rest = 1000.0F;  ///< density [kg/m^3]
  float stiffness = 3.0F, viscosity = 3.5F, gravity = -9.81F, step = 0.001F;
  float poly6 = 0, spiky = 0, laplacian = 0;  ///< factors of the kernels
  float side = 1.0F;                          ///< of the box [m]

  Water();
};

struct Setting {
  Water water;
  std::vector<Point> positions;
};

/// About `particles` particles at rest, on a cubic grid with a little disorder, in the corner of a box of twice their
/// width.
Setting make_setting(int particles);

struct NeighbourLists {
  std::vector<std::int32_t> first;  ///< of each particle's, and the number of all
  std::vector<std::int32_t> entries;
};

/// For each position those nearer than `reach`, itself too, cell by cell.
NeighbourLists find_neighbours(const std::vector<Point>& positions, float reach);

/// The positions' numbers, ordered by cell.
std::vector<std::int64_t> order_by_cell(const std::vector<Point>& positions, float reach);

}  // namespace fluid
