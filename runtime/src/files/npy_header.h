// The header of a .npy file: its numbers' type and the shape of the table that they are.
#pragma once

#include <physgen/fields/object_info.h>

#include <cstdint>
#include <iosfwd>
#include <string>

namespace physgen::files {

/// A table of objects and elements.
struct NpyTable {
  ElementType type = ElementType::float64;
  std::int64_t rows = 0;
  int columns = 1;
  bool flat = true;  ///< of one dimension

  [[nodiscard]] int bytes_of_row() const { return columns * element_bytes(type); }
};

/// Whether NumPy has numbers of a type.
[[nodiscard]] bool is_npy_type(ElementType type);

/// The bytes before the numbers: version 1.0 of the format, a multiple of 64.
[[nodiscard]] std::string npy_header(const NpyTable& table);

/// Reads a header of any version, up to the first number.
/// @param place of the file, for messages
/// @throw Error when it is none, or describes no table of numbers that save_npy() writes
[[nodiscard]] NpyTable read_npy_header(std::istream& in, const std::string& place);

}  // namespace physgen::files
