// Changes of topology: objects are appended, erased and reordered, when tissue is cut or for locality, in one array or
// in several arrays of one element set at once; and indices follow the objects they name.
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/arrays/object_numbers.h>
#include <physgen/detail/array_sets.h>

#include <span>
#include <string_view>
#include <tuple>
#include <utility>

namespace physgen {

/// Arrays of one element set, such as all arrays over the tets of a mesh, that change together: object i of each
/// describes the same element before and after. Object types, layouts, precisions and spaces may differ.
///
/// All new arrays are built before the first of them replaces an old one. So a change that fails, be it that the last
/// array's memory cannot be had, leaves every array as it was; and while it runs a change needs the memory of the set
/// once more. Each change moves all objects, so collect them into one call; no array has spare capacity afterwards. It
/// ends all views of the arrays. It is ordered in the default stream (device.h) and done when the call returns.
/// @pre work on the arrays in other streams is done (see synchronize())
template <class... Arrays>
class ArraySet {
  static_assert(sizeof...(Arrays) > 0, "an ArraySet has at least one array");

 public:
  /// @param arrays must outlive the set
  /// @throw Error when their sizes differ
  explicit ArraySet(Arrays&... arrays) : arrays_(arrays...) { (void)size(); }

  /// Objects of each array.
  /// @throw Error when the sizes differ, because one array has been resized without the others
  [[nodiscard]] index_t size() const { return detail::common_size(detail::untyped(arrays_)); }

  /// Adds `count` objects with initial values at the end.
  /// @throw Error when count is negative or the memory cannot be had
  void append(index_t count) {
    (void)size();
    replace(detail::grown_size(detail::untyped(arrays_), count),
            [](std::size_t, const UntypedArray& to, const UntypedArray& from) { copy_range(to, from, 0, from.size); });
  }

  /// Adds the objects of one other array for each array at the end, converted to its layout, formats, precision and
  /// space. An array may be its own other.
  /// @throw Error when the sizes of the others differ or the memory cannot be had
  template <class... Others>
    requires(sizeof...(Others) == sizeof...(Arrays) && (detail::SameObject<Arrays, Others> && ...))
  void append(const Others&... others) {
    const index_t old_size = size();
    const auto given = detail::untyped(std::tie(others...));
    const index_t new_size = detail::grown_size(detail::untyped(arrays_), detail::common_size(given));
    detail::wait_for(given);  // those that lie in pinned memory are read at once
    const std::tuple<decltype(detail::in_form_of<Arrays>(others))...> same(detail::in_form_of<Arrays>(others)...);
    const auto added = detail::untyped(same);
    replace(new_size, [&](std::size_t a, const UntypedArray& to, const UntypedArray& from) {
      copy_range(to, from, 0, old_size);
      detail::pick(to, old_size, added[a], nullptr);
    });
  }

  /// Reorders: object i becomes the old object order[i].
  /// @throw Error when `order` does not name each object once (see check_permutation()) or the memory cannot be had
  void permute(std::span<const index_t> order) {
    const index_t old_size = size();
    check_permutation(order, old_size, detail::names(detail::untyped(arrays_)));
    pick(order);
  }

  /// Keeps the listed objects, in this order; the others are gone.
  /// @throw Error when `kept` is not ascending (see check_ascending()) or the memory cannot be had
  void compact(std::span<const index_t> kept) {
    const index_t old_size = size();
    check_ascending(kept, old_size, detail::names(detail::untyped(arrays_)));
    pick(kept);
  }

  /// Removes the listed objects, named in any order; the others keep theirs.
  /// @throw Error when a number is out of range or listed twice, or the memory cannot be had
  void erase(std::span<const index_t> erased) {
    const index_t old_size = size();
    pick(remaining(old_size, erased, detail::names(detail::untyped(arrays_))));
  }

 private:
  void pick(std::span<const index_t> order) {
    const detail::Numbers numbers(order, detail::untyped(arrays_));
    replace(static_cast<index_t>(order.size()), [&](std::size_t, const UntypedArray& to, const UntypedArray& from) {
      detail::pick(to, 0, from, &numbers);
    });
  }

  // Builds an array of `size` objects for each old one with fill(which, new, old), then swaps all of them in.
  template <class Fill>
  void replace(index_t size, const Fill& fill) {
    std::tuple<Arrays...> replacements(Arrays{size}...);
    const auto to = detail::untyped(replacements);
    const auto from = detail::untyped(arrays_);
    detail::wait_for(from);
    for (std::size_t a = 0; a < to.size(); ++a) fill(a, to[a], from[a]);
    detail::wait_for(to);  // failures on the device show here, while the old arrays are still in place
    [&]<std::size_t... a>(std::index_sequence<a...>) {
      (std::get<a>(replacements).inherit_losses(std::get<a>(arrays_)), ...);
      (std::get<a>(arrays_).swap(std::get<a>(replacements)), ...);
    }(std::index_sequence_for<Arrays...>());
  }

  std::tuple<Arrays&...> arrays_;
};

/// Changes of one array, with the contracts of an ArraySet of it alone.
template <class Object, class Real, class Space, class Layout, class Formats>
void append(Array<Object, Real, Space, Layout, Formats>& array, index_t count) {
  ArraySet(array).append(count);
}
template <class Array, class Other>
  requires detail::SameObject<Array, Other>
void append(Array& array, const Other& other) {
  static_assert(!std::is_const_v<Array>,
                "append(array, other): the array that grows comes first, and this one is const");
  ArraySet(array).append(other);
}
template <class Object, class Real, class Space, class Layout, class Formats>
void permute(Array<Object, Real, Space, Layout, Formats>& array, std::span<const index_t> order) {
  ArraySet(array).permute(order);
}
template <class Object, class Real, class Space, class Layout, class Formats>
void compact(Array<Object, Real, Space, Layout, Formats>& array, std::span<const index_t> kept) {
  ArraySet(array).compact(kept);
}
template <class Object, class Real, class Space, class Layout, class Formats>
void erase(Array<Object, Real, Space, Layout, Formats>& array, std::span<const index_t> erased) {
  ArraySet(array).erase(erased);
}

/// Lets the indices of a field follow the objects they name, after these have been changed: every index v of the field
/// becomes new_number[v]. For new_number see inverse() and new_numbers(). On CUDA and in pinned memory as ArraySet.
/// @param field its name in the schema, such as "nodes"; "svd.rank" for one of a nested object
/// @throw Error when there is no such field of indices; or when an index is out of range of new_number, or names an
///        object that is gone (-1): the message names the first such object and its index. Nothing is changed then.
void renumber(const UntypedArray& untyped, std::string_view field, std::span<const index_t> new_number);

template <class Object, class Real, class Space, class Layout, class Formats>
void renumber(Array<Object, Real, Space, Layout, Formats>& array, std::string_view field,
              std::span<const index_t> new_number) {
  renumber(array.untyped(), field, new_number);
}

}  // namespace physgen
