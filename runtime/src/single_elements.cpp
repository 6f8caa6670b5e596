// Single elements of arrays without their types, by number, as doubles.
#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/single_elements.h>
#include <physgen/detail/count_losses.h>
#include <physgen/device.h>
#include <physgen/error.h>
#include <physgen/memory/buffer.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

#include "convert.h"
#include "describe.h"

namespace physgen {

namespace {

using detail::describe;

// A field and which of its elements, as code counts them.
struct Found {
  const FieldInfo& field;
  int element;
};

Found find_element(const UntypedArray& array, index_t i, int k) {
  if (i < 0 || i >= array.size) {
    throw Error(describe(array) + ": there is no object " + std::to_string(i) + "; numbers go from 0 to " +
                std::to_string(array.size - 1));
  }
  int rest = k;
  for (const FieldInfo& field : array.fields) {
    if (rest >= 0 && rest < field.visible_count()) return {field, rest};
    rest -= field.visible_count();
  }
  int count = 0;
  for (const FieldInfo& field : array.fields) count += field.visible_count();
  throw Error(describe(array) + ": there is no element " + std::to_string(k) + "; numbers go from 0 to " +
              std::to_string(count - 1));
}

// Whether an integer of type T has this value.
template <class T>
bool holds(double value) {
  using Limits = std::numeric_limits<T>;
  const double low = static_cast<double>(Limits::min()), end = std::ldexp(1.0, Limits::digits);
  return value >= low && value < end && value == std::floor(value);
}
template <class T>
std::string numbers_of() {
  return "holds whole numbers from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
         std::to_string(std::numeric_limits<T>::max());
}

// What elements of a type hold where a value is none of them; else empty.
std::string refused_numbers(ElementType type, double value) {
  if (type == ElementType::int32 && !holds<std::int32_t>(value)) return numbers_of<std::int32_t>();
  if (type == ElementType::int64 && !holds<std::int64_t>(value)) return numbers_of<std::int64_t>();
  if (type == ElementType::uint64 && !holds<std::uint64_t>(value)) return numbers_of<std::uint64_t>();
  if (type == ElementType::boolean && value != 0 && value != 1) return "holds 0 or 1";
  return {};
}

// An integer of 64 bits as a double. @throw Error where that would change it
template <class T>
double exactly(const UntypedArray& array, const FieldInfo& field, const std::byte* stored) {
  T number;
  std::memcpy(&number, stored, sizeof number);
  const auto value = static_cast<double>(number);
  if (holds<T>(value) && static_cast<T>(value) == number) return value;
  throw Error(describe(array) + ": " + std::string(field.name) + " holds " + std::to_string(number) +
              ", which no double is; read it through a view");
}

}  // namespace

double getdata(const UntypedArray& array, index_t i, int k) {
  const auto [field, element] = find_element(array, i, k);
  if (!field.is_stored()) detail::refuse_unstored(array, field, "element " + std::to_string(k) + " cannot be read");
  if (array.space != SpaceKind::host) detail::refuse_capture(nullptr, "getdata()");
  const int size = element_bytes(field.type);
  // A single element, or all those of a quaternion.
  alignas(8) std::array<std::byte, 32> bytes{};
  const int first = field.quaternion ? element / 9 * 4 : element, count = field.quaternion ? 4 : 1;
  for (int e = 0; e < count; ++e) {
    copy_memory(bytes.data() + e * size, SpaceKind::host, array.address(i, field.offset + (first + e) * size, size),
                array.space, size);
  }
  if (field.type == ElementType::int64) return exactly<std::int64_t>(array, field, bytes.data());
  if (field.type == ElementType::uint64) return exactly<std::uint64_t>(array, field, bytes.data());
  const detail::FieldFormat format(field);
  if (!field.quaternion) return detail::decode<double>(bytes.data(), format);
  const auto R =
      detail::decode_rotation<double>(format, true, [&bytes, size](int e) { return bytes.data() + e * size; });
  return R(element % 9 % 3, element % 9 / 3);
}

void putdata(const UntypedArray& array, index_t i, int k, double value) {
  const auto [field, element] = find_element(array, i, k);
  if (!field.is_stored()) detail::refuse_unstored(array, field, "element " + std::to_string(k) + " cannot be set");
  if (field.quaternion) {
    throw Error(describe(array) + ": " + std::string(field.name) +
                " is stored as a quaternion, which has no single matrix elements; assign the rotation through a view");
  }
  if (const std::string held = refused_numbers(field.type, value); !held.empty()) {
    std::ostringstream message;
    message << describe(array) << ": " << value
            << (field.type == ElementType::int32 ? " is not an index; " : " does not fit; ") << field.name << ' '
            << held;
    throw Error(message.str());
  }
  const int size = element_bytes(field.type);
  alignas(8) std::array<std::byte, 8> bytes{};
  const detail::FieldFormat format(field);
  detail::encode(bytes.data(), format, value);
  if (checked_build) {
    Losses losses;
    detail::count_loss(losses, format.type, format.scale, value, detail::decode<double>(bytes.data(), format), i,
                       field.offset + element * size);
    throw_if_falsified(losses, array);
  }
  if (array.space != SpaceKind::host) detail::refuse_capture(nullptr, "putdata()");
  copy_memory(array.address(i, field.offset + element * size, size), array.space, bytes.data(), SpaceKind::host, size);
}

}  // namespace physgen
