// Single elements of arrays without their types, by number, as doubles.
#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/single_elements.h>
#include <physgen/detail/count_losses.h>
#include <physgen/device.h>
#include <physgen/error.h>
#include <physgen/memory/buffer.h>

#include <algorithm>
#include <array>
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

// The nearest number that an int32 may be converted from; 0 for NaN.
double limited(double value) {
  constexpr double low = -2147483648.0, high = 2147483647.0;
  return value != value ? 0 : std::clamp(value, low, high);
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
  if (field.type == ElementType::int32 && static_cast<double>(static_cast<std::int32_t>(limited(value))) != value) {
    std::ostringstream message;
    message << describe(array) << ": " << value << " is not an index; " << field.name
            << " holds whole numbers from -2147483648 to 2147483647";
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
