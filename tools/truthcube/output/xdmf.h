// The text of an XDMF file beside a VTKHDF file, for viewers that do not know the steps of the latter: ParaView before
// 5.12, which is Debian 12's. It has no numbers but times: its arrays are parts of the datasets of the VTKHDF file.
// Format: XDMF 3, as ParaView's Xdmf3 readers take it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace physgen::truthcube {

/// A dataset of a VTKHDF file that has the values of all steps one behind the other.
struct XdmfArray {
  std::string what;    ///< "Point" or "Cell"
  std::string name;    ///< of the field
  std::uint64_t rows;  ///< of one step
  int components;
};

/// @param file the VTKHDF file, in the same folder
[[nodiscard]] std::string xdmf_text(const std::filesystem::path& file, std::uint64_t points, std::uint64_t tets,
                                    std::span<const XdmfArray> arrays, std::span<const double> times);

}  // namespace physgen::truthcube
