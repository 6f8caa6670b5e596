// Fields one by one, as files hold them.
#pragma once

#include <physgen/fields/object_info.h>

#include <span>
#include <vector>

namespace physgen::files {

/// The fields of an array of which the one of this number is stored in `form`, and nothing of the others.
[[nodiscard]] inline std::vector<FieldInfo> only(std::span<const FieldInfo> fields, std::size_t number,
                                                 const FieldInfo& form) {
  std::vector<FieldInfo> result(fields.begin(), fields.end());
  for (FieldInfo& field : result) field.type = ElementType::none;
  result[number] = form;
  return result;
}

/// What elements of a type are, for messages.
[[nodiscard]] inline const char* kind_of(ElementType type) {
  return type == ElementType::int32     ? "integers"
         : type == ElementType::int64   ? "integers of 64 bits"
         : type == ElementType::uint64  ? "unsigned integers of 64 bits"
         : type == ElementType::boolean ? "bool"
                                        : "real numbers";
}

/// Whether elements of a file may be loaded as those of a field: integers as they were, or into wider ones, which hold
/// all of them.
[[nodiscard]] inline bool loads_into(ElementType stored, ElementType field) {
  if (stored == ElementType::int32 && field == ElementType::int64) return true;
  return is_whole(stored) || is_whole(field) ? stored == field : true;
}

/// Rows of a .npy file that are written and read at once, by one thread, and converted on all.
[[nodiscard]] inline index_t rows_at_once(int bytes_of_row) {
  constexpr index_t bytes = index_t{1} << 23;
  return bytes_of_row >= bytes / 1024 ? 1024 : align_up(bytes / bytes_of_row, index_t{1024});
}

}  // namespace physgen::files
