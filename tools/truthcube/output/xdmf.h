// The text of an XDMF file beside a VTKHDF file, for viewers that do not know the steps of the latter: ParaView before
// 5.12, which is Debian 12's. It has no numbers but times: its arrays are parts of the datasets of the VTKHDF file.
// Format: XDMF 3, as ParaView's Xdmf3 readers take it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace physgen::truthcube {

/// What a VTKHDF file has once for all steps.
struct XdmfMesh {
  std::uint64_t points, cells;
  std::size_t corners_of_cell;          ///< 4 of tets, 3 of triangles
  std::span<const std::string> groups;  ///< names of fields of cells, which have one byte of each cell
};

/// A dataset of a VTKHDF file that has the values of all steps one behind the other.
struct XdmfArray {
  std::string what;    ///< "Point" or "Cell"
  std::string name;    ///< of the field
  std::uint64_t rows;  ///< of one step
  int components;
};

/// @param file the VTKHDF file, in the same folder
[[nodiscard]] std::string xdmf_text(const std::filesystem::path& file, const XdmfMesh& mesh,
                                    std::span<const XdmfArray> arrays, std::span<const double> times);

/// @throws Error when there is an XDMF file that names no datasets of this VTKHDF file, as each of xdmf_text() does
void require_none_of_others(const std::filesystem::path& xdmf, const std::filesystem::path& file);

}  // namespace physgen::truthcube
