// What solvers on several ranks hand out of some objects, such as those of a window: the first rank gets it.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/distributed/arrays.h>
#include <physgen/distributed/transport.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace physgen::fem {

/// Who owns objects that are named.
struct NamedOwners {
  std::vector<index_t> own;  ///< local numbers of those that this rank owns, in the order in which they are named
  std::vector<std::size_t> begins;  ///< of each rank among all that are named, by owners, and their number
  bool ascend = true;               ///< whether that is the order in which they are named

  NamedOwners(const LocalSet& objects, const Ranks& ranks, std::span<const Index> named)
      : begins(static_cast<std::size_t>(objects.runs().ranks()) + 1, 0) {
    int owner = 0;
    for (const index_t object : named) {
      const int before = owner;
      owner = of(objects.runs(), object, owner);
      ascend = ascend && before <= owner;
      ++begins[static_cast<std::size_t>(owner) + 1];
      if (owner == ranks.rank()) own.push_back(objects.local(object));
    }
    for (std::size_t r = 1; r < begins.size(); ++r) begins[r] += begins[r - 1];
  }
  /// @param guess one that may be it
  /// @throw Error when there is no such object
  [[nodiscard]] static int of(const Runs& runs, index_t object, int guess) {
    return runs.owns(guess, object) ? guess : runs.owner(object);
  }
};

/// Numbers of some objects of an array that are here. @param own their local numbers
template <std::size_t kCount, class Array, class Element>
[[nodiscard]] std::vector<std::array<double, kCount>> numbers_of_own(const DistributedArrays& arrays,
                                                                     const Array& array, std::span<const index_t> own,
                                                                     const Element& element) {
  std::vector<std::array<double, kCount>> numbers(own.size());
  if (own.empty()) return numbers;
  physgen::detail::wait_for_device(Array::Space::kind);
  auto picked =
      physgen::detail::make_array<Array>(static_cast<index_t>(own.size()), arrays.ranks(), arrays.transport());
  const std::array spaces{array.untyped()};
  const physgen::detail::Numbers order(own, spaces);
  physgen::detail::pick(picked.untyped(), 0, array.untyped(), &order);
  physgen::detail::wait_for_device(Array::Space::kind);
  const auto& here = physgen::detail::in_form_of<physgen::detail::OnHost<Array>>(picked);
  const auto view = here.const_view();
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (std::size_t k = 0; k < kCount; ++k)
      numbers[i][k] = element(view[static_cast<index_t>(i)], static_cast<int>(k));
  }
  return numbers;
}

/// Numbers of objects that are named, in that order, on the first rank; none on others. All ranks call it with the same
/// objects. @pre no step is under way
/// @param named global numbers @param element element(object, k) is number k of an object
/// @throw Error when there is no such object
template <std::size_t kCount, class Array, class Element>
[[nodiscard]] std::vector<std::array<double, kCount>> named_of_ranks(const DistributedArrays& arrays,
                                                                     const Array& array, std::span<const Index> named,
                                                                     const Element& element) {
  using Numbers = std::vector<std::array<double, kCount>>;
  const LocalSet& objects = arrays.objects_of(array);
  const NamedOwners owners(objects, arrays.ranks(), named);
  Numbers own = numbers_of_own<kCount>(arrays, array, owners.own, element);
  Numbers all;
  std::vector<Message> messages;
  if (!arrays.ranks().is_first()) {
    if (!own.empty()) messages.push_back({0, std::as_bytes(std::span(own)), {}});
  } else {
    own.resize(named.size());  // the first rank's own come first
    for (int r = 1; r < objects.runs().ranks(); ++r) {
      const std::size_t begin = owners.begins[static_cast<std::size_t>(r)],
                        end = owners.begins[static_cast<std::size_t>(r) + 1];
      if (begin < end) {
        messages.push_back({r, {}, std::as_writable_bytes(std::span(own).subspan(begin, end - begin))});
      }
    }
  }
  arrays.transport().begin(messages);
  arrays.transport().end();
  if (!arrays.ranks().is_first()) return all;
  if (owners.ascend) return own;
  all.reserve(named.size());
  std::vector<std::size_t> next = owners.begins;
  int owner = 0;
  for (const index_t object : named) {
    owner = NamedOwners::of(objects.runs(), object, owner);
    all.push_back(own[next[static_cast<std::size_t>(owner)]++]);
  }
  return all;
}

}  // namespace physgen::fem
