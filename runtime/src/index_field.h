// A field of indices by its name.
#pragma once

#include <physgen/error.h>

#include <string>
#include <string_view>

#include "describe.h"

namespace physgen::detail {

/// @throw Error when the field is pruned; naming the fields of indices that there are, when this is not one
[[nodiscard]] inline const FieldInfo& find_index_field(const UntypedArray& array, std::string_view name) {
  std::string fields_of_indices;
  for (const FieldInfo& field : array.fields) {
    if (field.name == name && !field.is_stored()) refuse_unstored(array, field, "its indices are needed");
    if (field.type != ElementType::int32) continue;
    if (field.name == name) return field;
    fields_of_indices += " " + std::string(field.name);
  }
  throw Error(describe(array) + ": there is no field of indices \"" + std::string(name) + "\"; " +
              (fields_of_indices.empty() ? "the object has none" : "there are:" + fields_of_indices));
}

}  // namespace physgen::detail
