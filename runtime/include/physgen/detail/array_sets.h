// Steps of changes of topology over the arrays of a set without their types: sizes, waiting, objects picked by number.
#pragma once

#include <physgen/arrays/array.h>

#include <array>
#include <concepts>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>

namespace physgen::detail {

/// The one size of all arrays. @throw Error naming all when they differ
[[nodiscard]] index_t common_size(std::span<const UntypedArray> arrays);

/// size + count. @throw Error when count is negative or the sum no number
[[nodiscard]] index_t grown_size(std::span<const UntypedArray> arrays, index_t count);

/// The names of all arrays, for messages.
[[nodiscard]] std::string names(std::span<const UntypedArray> arrays);

/// Waits for the default stream where one of the arrays lies in memory that it may work on.
void wait_for(std::span<const UntypedArray> arrays);

/// Object numbers where the host and, if an array lies there, the device can read them.
struct Numbers {
  std::span<const index_t> on_host;  ///< the caller's
  Buffer on_device;

  Numbers(std::span<const index_t> numbers, std::span<const UntypedArray> arrays);
  /// Those that work on an array of this space reads.
  [[nodiscard]] const index_t* in(SpaceKind space) const;
};

/// Object begin + i of `to` becomes object order[i] of `from`, or without an order (null) object i, as plain bytes. On
/// CUDA ordered in the default stream.
/// @pre both store the same records in the same space, and have these objects
void pick(const UntypedArray& to, index_t begin, const UntypedArray& from, const Numbers* order);

/// Whether both are arrays of one object type.
template <class A, class B>
concept SameObject = std::same_as<typename A::Object, typename B::Object>;

/// `other` in the layout, formats, precision and space of To: itself where it has them, else a converted copy.
template <class To, class Other>
std::conditional_t<std::same_as<To, Other>, const Other&, To> in_form_of(const Other& other) {
  if constexpr (std::same_as<To, Other>) {
    return other;
  } else {
    To converted(other.size());
    copy(converted, other);
    return converted;
  }
}

/// The arrays of a tuple without their types.
template <class Tuple>
[[nodiscard]] auto untyped(const Tuple& arrays) {
  return std::apply([](const auto&... array) { return std::array{array.untyped()...}; }, arrays);
}

}  // namespace physgen::detail
