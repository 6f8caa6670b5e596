// How a field is stored in a file: its HDF5 type, and the attributes that say what its numbers mean.
#pragma once

#include <physgen/arrays/untyped_array.h>

#include <cstdint>
#include <string>
#include <vector>

#include "h5.h"

namespace physgen::h5 {

/// The version of what stands in a file; larger ones are refused.
inline constexpr std::int32_t file_version = 1;

/// The HDF5 type of elements, in files and in memory.
[[nodiscard]] Handle type_of(ElementType type);
[[nodiscard]] const char* name_of(ElementType type);

/// The form that a field has in a file, at the beginning of a record of its own: its own, or, where its format is one
/// of a program's own, the numbers that kernels see.
[[nodiscard]] FieldInfo form_in_file(const FieldInfo& field);

/// The fields of an array of which the one of this number is stored in `form`, and nothing of the others.
[[nodiscard]] std::vector<FieldInfo> only(std::span<const FieldInfo> fields, std::size_t number, const FieldInfo& form);

/// Attributes of the dataset of a field.
void write_attributes(File& file, const std::string& dataset, const FieldInfo& form);
/// The form of a dataset by its attributes and type; its name is left empty.
/// @param place for messages
/// @throw Error when they are not those of save()
[[nodiscard]] FieldInfo read_form(const File& file, const std::string& place, const std::string& dataset);
/// The unit of the field of a dataset.
[[nodiscard]] std::string read_unit(const File& file, const std::string& dataset);

/// Rows that are written and read at once.
[[nodiscard]] inline index_t rows_at_once(int bytes_of_row) {
  constexpr index_t bytes = index_t{1} << 23;
  return bytes_of_row >= bytes / 1024 ? 1024 : align_up(bytes / bytes_of_row, index_t{1024});
}

}  // namespace physgen::h5
