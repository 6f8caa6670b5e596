// What stands in a VTKHDF file, by name.
#pragma once

#include <physgen/error.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace physgen::truthcube::vtkhdf {

inline constexpr const char* root = "/VTKHDF";
inline constexpr const char* steps_group = "/VTKHDF/Steps";
/// Moved to steps_group when the first step is done.
inline constexpr const char* first_steps_group = "/Steps of the first step";
inline constexpr std::array step_offsets{"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"};

/// The name of something in a group.
[[nodiscard]] inline std::string in(std::string group, std::string_view name) {
  group += '/';
  group += name;
  return group;
}
[[nodiscard]] inline std::string data_group(const std::string& what) { return in(root, what + "Data"); }
[[nodiscard]] inline std::string offsets_group(const std::string& steps, const std::string& what) {
  return in(steps, what + "DataOffsets");
}

/// Room on the disk for groups, attributes, indices and values per step, and the same for one field.
inline constexpr std::uint64_t room_for_groups = std::uint64_t{1} << 19U, room_for_array = std::uint64_t{1} << 16U;

/// @param error error(what) is what is thrown where it is not
template <class MakeError>
void require_usable_name(const std::string& name, const MakeError& error) {
  if (name.empty() || name.find_first_of("/.|:") != std::string::npos) {  // | and : part what the XDMF file names
    throw error("has no usable name: a name is not empty and has no '/', '.', '|' and ':'");
  }
}

}  // namespace physgen::truthcube::vtkhdf
