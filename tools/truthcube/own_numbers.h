// A mesh that the solver has in another order (--order) under its own numbers, which files and messages have.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "scene.h"

namespace physgen::truthcube {

/// The finest mesh under its own numbers. The scene stays alive as long as this.
struct DrawnMesh {
  explicit DrawnMesh(const Scene& scene);
  DrawnMesh(const DrawnMesh&) = delete;
  DrawnMesh& operator=(const DrawnMesh&) = delete;
  ~DrawnMesh() = default;

  std::vector<fem::Point> own_rest;  ///< empty where the solver has the mesh's own numbers
  std::vector<std::array<fem::Index, 4>> own_tets;
  std::span<const fem::Point> rest;
  std::span<const std::array<fem::Index, 4>> tets;
};

}  // namespace physgen::truthcube
