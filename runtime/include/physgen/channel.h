// One element of all objects as a std::span, where the layout keeps these numbers side by side: for libraries that take
// plain ranges of numbers.
//   std::span<float> pressures = channel<"pressure">(stress);         // an array in Soa
//   Eigen::Map<Eigen::ArrayXf>(pressures.data(), stress.size()) *= 2;
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/error.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace physgen {

/// The name of a field, as an argument of a template.
template <std::size_t kSize>
struct FieldName {
  char letters[kSize];                                                                   ///< with the zero behind them
  constexpr FieldName(const char (&name)[kSize]) { std::copy_n(name, kSize, letters); }  // NOLINT: written as "name"
  [[nodiscard]] constexpr std::string_view text() const { return {letters, kSize - 1}; }
};

namespace detail {

template <class Array>
inline constexpr auto fields_in = Array::Object::template fields<typename Array::Precision, typename Array::Formats>;

/// The number of a field among those of an array's objects; their count where there is none of this name.
template <class Array>
[[nodiscard]] constexpr std::size_t field_number(std::string_view name) {
  std::size_t number = 0;
  while (number < fields_in<Array>.size() && fields_in<Array>[number].name != name) ++number;
  return number;
}

/// The type of C++ that elements of a type are stored as; void: none.
template <ElementType kType>
[[nodiscard]] constexpr auto stored_number() {
  if constexpr (kType == ElementType::float32) return std::type_identity<float>();
  if constexpr (kType == ElementType::float64) return std::type_identity<double>();
  if constexpr (kType == ElementType::int32) return std::type_identity<std::int32_t>();
  if constexpr (kType == ElementType::int64) return std::type_identity<std::int64_t>();
  if constexpr (kType == ElementType::uint64) return std::type_identity<std::uint64_t>();
  if constexpr (kType == ElementType::boolean) return std::type_identity<bool>();
}
template <ElementType kType>
using StoredNumber = decltype(stored_number<kType>());

template <std::size_t kNumber, class Array>
[[nodiscard]] auto channel_of(const UntypedArray& array, int k) {
  static_assert(
      std::is_same_v<typename Array::Layout, Soa>,
      "channel(): only the layout Soa keeps an element of all objects side by side; copy() to an array in Soa");
  static_assert(host_accessible(Array::Space::kind),
                "channel(): an array in Cuda memory is not reached on the host: copy it to an array in Host");
  static_assert(kNumber < fields_in<Array>.size(), "channel(): the objects have no field of this name");
  constexpr FieldInfo field = fields_in<Array>[std::min(kNumber, fields_in<Array>.size() - 1)];
  using Stored = StoredNumber<field.type>;
  static_assert(!std::is_void_v<Stored> && field.scale == 1 && field.centre == 0 && field.own == nullptr,
                "channel(): this field is not stored as plain numbers; copy() to an array in which it is");
  if (k < 0 || k >= field.count) {
    throw Error("channel(): " + std::string(array.object) + "::" + std::string(field.name) + " has elements 0 to " +
                std::to_string(field.count - 1) + ", not " + std::to_string(k));
  }
  using T = typename Stored::type;
  const int size = element_bytes(field.type);
  auto* const first = array.size == 0 ? nullptr : array.address(0, field.offset + k * size, size);
  return std::span<T>(reinterpret_cast<T*>(first), static_cast<std::size_t>(array.size));
}

}  // namespace detail

/// Element k of the field kName of all objects: of a matrix by columns, of symmetric ones as Symmetric stores them, of
/// a rotation that is a quaternion w, x, y, z; of a fixed array entry after entry. Valid as long as a view of the
/// array. Where the layout, the space or the format of the field does not allow it, or there is no such field, it does
/// not compile.
/// @throw Error when there is no element k
template <FieldName kName, class Object, class Real, class Space, class Layout, class Formats>
[[nodiscard]] auto channel(Array<Object, Real, Space, Layout, Formats>& array, int k = 0) {
  using Given = Array<Object, Real, Space, Layout, Formats>;
  return detail::channel_of<detail::field_number<Given>(kName.text()), Given>(array.untyped(), k);
}
template <FieldName kName, class Object, class Real, class Space, class Layout, class Formats>
[[nodiscard]] auto channel(const Array<Object, Real, Space, Layout, Formats>& array, int k = 0) {
  using Given = Array<Object, Real, Space, Layout, Formats>;
  const auto found = detail::channel_of<detail::field_number<Given>(kName.text()), Given>(array.untyped(), k);
  return std::span<const typename decltype(found)::element_type>(found);
}

}  // namespace physgen
