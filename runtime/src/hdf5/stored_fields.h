// How a field is stored in a file: its HDF5 type, and the attributes that say what its numbers mean.
#pragma once

#include <physgen/arrays/untyped_array.h>

#include <cstdint>
#include <string>

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

/// Attributes of the dataset of a field.
void write_attributes(File& file, const std::string& dataset, const FieldInfo& form);
/// The form of a dataset by its attributes and type; its name is left empty.
/// @param place for messages
/// @throw Error when they are not those of save()
[[nodiscard]] FieldInfo read_form(const File& file, const std::string& place, const std::string& dataset);
/// The unit of the field of a dataset.
[[nodiscard]] std::string read_unit(const File& file, const std::string& dataset);

}  // namespace physgen::h5
