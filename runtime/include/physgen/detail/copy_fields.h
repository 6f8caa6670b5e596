// Checks that a copy finds all fields that its target stores, and loses none without the target's saying so, where
// formats of no bytes (format/nothing.h) leave some out: when compiled, where the types of both arrays are known; else
// by an Error.
#pragma once

#include <physgen/fields/object_info.h>
#include <physgen/memory/space.h>

#include <span>

namespace physgen::detail {

/// The number of the first field that array `to` stores and array `from`, of the same object type, does not; else -1.
[[nodiscard]] constexpr int first_not_given(std::span<const FieldInfo> to, std::span<const FieldInfo> from) {
  for (std::size_t f = 0; f < to.size(); ++f) {
    if (to[f].is_stored() && !from[f].is_stored()) return static_cast<int>(f);
  }
  return -1;
}
/// The number of the first field that `from` stores and of which `to` stores nothing, without pruning it; else -1.
[[nodiscard]] constexpr int first_not_taken(std::span<const FieldInfo> to, std::span<const FieldInfo> from) {
  for (std::size_t f = 0; f < to.size(); ++f) {
    if (!to[f].is_stored() && !to[f].pruned && from[f].is_stored()) return static_cast<int>(f);
  }
  return -1;
}

/// A field's name as an argument of templates, which compilers print.
template <std::size_t kLength>
struct FieldName {
  char text[kLength];
};
template <class Object, int kField>
[[nodiscard]] constexpr auto field_name() {
  constexpr std::string_view name =
      Object::template fields<float, typename Object::template Formats<Host>>[kField].name;
  FieldName<name.size() + 1> result{};
  for (std::size_t c = 0; c < name.size(); ++c) result.text[c] = name[c];
  return result;
}

template <class Object, FieldName kField, class To, class From, bool kGiven>
struct GivenField {
  static_assert(kGiven,
                "the array copied from stores nothing of this field, and the array copied to stores it: give the field "
                "the same format Pruned<scene, array, field> in both, or store it in both");
};
template <class Object, FieldName kField, class To, class From, bool kTaken>
struct TakenField {
  static_assert(kTaken,
                "this field would be lost: the array copied to stores Nothing of it. Give it the format Pruned<scene, "
                "array, field> there, which says that this is meant");
};

/// Refuses a copy between arrays of Object whose fields do not suit each other. @tparam To, From the arrays' formats
template <class Object, class To, class From>
constexpr void require_copied_fields() {
  constexpr auto& to = Object::template fields<float, To>;
  constexpr auto& from = Object::template fields<float, From>;
  constexpr int missing = first_not_given(to, from);
  if constexpr (missing >= 0) {
    (void)sizeof(GivenField<Object, field_name<Object, missing>(), To, From, (missing < 0)>);
  }
  constexpr int lost = first_not_taken(to, from);
  if constexpr (lost >= 0) (void)sizeof(TakenField<Object, field_name<Object, lost>(), To, From, (lost < 0)>);
}

}  // namespace physgen::detail
