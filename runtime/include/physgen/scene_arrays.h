// What the generated arrays of scenes are made of: arrays with other formats, arrays that programs only read, one
// record for all objects, and fields that begin as signalling NaN in checked builds.
#pragma once

#include <physgen/layout/uniform.h>
#include <physgen/runtime.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

namespace physgen {

namespace detail {
template <class Array, class Formats>
struct WithFormats;
template <class Object, class Real, class Space, class Layout, class Old, class Formats>
struct WithFormats<Array<Object, Real, Space, Layout, Old>, Formats> {
  using type = Array<Object, Real, Space, Layout, Formats>;
};
}  // namespace detail

/// The same array, with its fields stored as Formats says.
template <class Array, class Formats>
using WithFormats = typename detail::WithFormats<Array, Formats>::type;

/// An array that programs read and do not write: its views are read-only. Who fills it copies to it, or takes
/// contents().
template <class Array>
class ReadOnlyArray : public Array {
 public:
  using View = typename Array::ConstView;
  using Array::Array;

  [[nodiscard]] View view() const { return this->const_view(); }
  /// The array as whoever fills it sees it.
  [[nodiscard]] Array& contents() { return *this; }
};

/// `size` objects that are all the same, in one record. Programs read them.
template <class Array>
class UniformArray;
template <class Object_, class Real, class Space, class Layout, class Formats_>
class UniformArray<Array<Object_, Real, Space, Layout, Formats_>> {
 public:
  using Object = Object_;
  using Formats = Formats_;
  using View = physgen::View<Object, const Real, Uniform, Formats, Space>;
  using ConstView = View;
  using Record = Array<Object, Real, Space, Aos, Formats>;

  UniformArray() = default;
  /// @throw Error when size is negative or the memory of the record cannot be had
  explicit UniformArray(index_t size) { resize(size); }

  [[nodiscard]] index_t size() const { return size_; }
  /// Bytes of memory held, padding included.
  [[nodiscard]] index_t bytes() const { return record_.bytes(); }
  [[nodiscard]] View view() const { return {record_.storage().base, size_, 1}; }
  [[nodiscard]] View const_view() const { return view(); }
  /// The record, as an array of one object, or of none before there were objects: for whoever fills it.
  [[nodiscard]] Record& contents() { return record_; }

  /// The record keeps its values, also while there are no objects.
  void resize(index_t size) {
    if (size < 0) {
      throw Error(std::string(Object::name) + ": an array of " + std::to_string(size) +
                  " objects cannot exist; 0 or more can");
    }
    if (size > 0) record_.resize(1);
    size_ = size;
  }

 private:
  Record record_;
  index_t size_ = 0;
};

namespace detail {

/// Whether a field of an array is meant by a name: "points.x" means that of all entries, "points[0].x".
[[nodiscard]] inline bool is_named(std::string_view field, std::string_view name) {
  while (!field.empty() && !name.empty() && field.front() == name.front()) {
    field.remove_prefix(1);
    name.remove_prefix(1);
    if (field.starts_with('[')) field.remove_prefix(field.find(']') + 1);
  }
  return field.empty() && name.empty();
}

}  // namespace detail

/// Gives the elements of these fields, in all objects of an array, bits_of_no_value() in place of their values. What
/// lies behind the last object stays.
/// @param fields by name; that of a fixed array of nested objects, "points.x", means all entries
/// @throw Error when the array has no field of such a name
inline void start_without_values(const Storage& storage, std::initializer_list<std::string_view> fields) {
  std::vector<std::byte> image(static_cast<std::size_t>(storage.bytes()));
  if (image.empty()) return;
  copy_memory(image.data(), SpaceKind::host, storage.base, storage.space, storage.bytes());
  for (const std::string_view name : fields) {
    bool is_there = false;
    for (const FieldInfo& field : storage.fields) {
      if (!detail::is_named(field.name, name)) continue;
      is_there = true;
      const std::uint64_t bits = bits_of_no_value(field.type);
      const int size = element_bytes(field.type);
      for (index_t i = 0; i < storage.size; ++i) {
        for (int k = 0; k < field.count; ++k) {
          const index_t at = i / storage.pitch * storage.pitch * storage.record_bytes +
                             (field.offset + index_t{k} * size) * storage.pitch + i % storage.pitch * size;
          std::memcpy(image.data() + at, &bits, static_cast<std::size_t>(size));
        }
      }
    }
    if (!is_there) {
      throw Error(std::string(storage.object) + ": there is no field " + std::string(name) +
                  " that could start without a value");
    }
  }
  copy_memory(storage.base, storage.space, image.data(), SpaceKind::host, storage.bytes());
}

/// Makes `array` one of `size` objects with their initial values. In checked builds the fields named begin without one
/// instead, as signalling NaN: those that a program writes before it reads them.
/// @throw Error when size is negative or the memory cannot be had
template <class Array>
void allocate(Array& array, index_t size, [[maybe_unused]] std::initializer_list<std::string_view> written_first = {}) {
  array = Array(size);
  if constexpr (checked_build) {
    if (written_first.size() == 0) return;
    if constexpr (requires { array.storage(); }) {
      start_without_values(array.storage(), written_first);
    } else {
      start_without_values(array.contents().storage(), written_first);
    }
  }
}

}  // namespace physgen
