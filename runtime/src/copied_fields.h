// Whether the fields of two arrays let one be copied to the other.
#pragma once

#include <physgen/detail/copy_fields.h>

#include "describe.h"

namespace physgen::detail {

/// @throw Error when `from` lacks a field that `to` stores, or a field is lost that `to` was not told to leave out
inline void require_fields(const UntypedArray& to, const UntypedArray& from) {
  const auto refuse = [&](int f, const std::string& why) {
    refuse_copy(to, from, std::string(to.fields[static_cast<std::size_t>(f)].name) + why);
  };
  if (const int f = first_not_given(to.fields, from.fields); f >= 0) {
    refuse(
        f,
        " is stored in the target of the copy but not in its source (format::Nothing or Pruned); prune it in both, or "
        "in neither");
  }
  if (const int f = first_not_taken(to.fields, from.fields); f >= 0) {
    refuse(
        f,
        " would be lost: the target of the copy does not store it (format::Nothing); if that is intended, give it the "
        "format Pruned<scene, array, field> there");
  }
}

}  // namespace physgen::detail
