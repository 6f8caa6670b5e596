// The parts of the generated arrays of scenes: arrays in other layouts and formats, arrays that programs only read,
// one record for all objects, and fields that begin as signalling NaN in checked builds.
#pragma once

#include <physgen/detail/array_stored_as.h>
#include <physgen/layout/uniform.h>
#include <physgen/runtime.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

namespace physgen {

/// The same array, with its fields stored as Formats says. A ProbeArray is the same for all formats.
template <class Of, class Formats>
using WithFormats = typename detail::ArrayStoredAs<Of, Formats>::type;

/// The same array, with its objects lying as Layout says.
template <class Of, class Layout>
using WithLayout = Array<typename Of::Object, typename Of::Precision, typename Of::Space, Layout, typename Of::Formats>;

/// Stores the arrays of a scene's group as the schemas of their objects say. A struct of one's own in its place has
/// another array of the same objects for some:
///   struct EdgesInHalf {
///     template <class Tag, class Array>
///     using Of = std::conditional_t<is_named<Tag>("level.edges"), WithFormats<Array, HalfFormats>, Array>;
///   };
struct StoredAsDeclared {
  /// @tparam Tag of the array: Tag::name is its name in the scene, "level.edges"
  /// @tparam Array as the schema says
  template <class Tag, class Array>
  using Of = Array;
};

/// Whether a tag is that of the array of this name: "level.edges".
template <class Tag>
[[nodiscard]] constexpr bool is_named(std::string_view name) {
  return Tag::name == name;
}

/// An array of a scene, as Stored has it.
template <class Stored, class Tag, class Array>
using StoredArray = typename Stored::template Of<Tag, Array>;

/// The same without the fields that Pruning<Formats> takes away.
template <class Array, template <class Formats> class Pruning>
using PrunedArray = WithFormats<Array, Pruning<typename Array::Formats>>;

/// An array that programs read and do not write: its views are read-only. It is filled by copies, or through
/// contents().
template <class Array>
class ReadOnlyArray : public Array {
 public:
  using View = typename Array::ConstView;
  using Array::Array;

  [[nodiscard]] View view() const { return this->const_view(); }
  /// The array, to be filled.
  [[nodiscard]] Array& contents() { return *this; }
};

/// `size` objects that are all the same, in one record. Programs read them.
template <class Array>
class UniformArray {
 public:
  using Object = typename Array::Object;
  using Formats = typename Array::Formats;
  using View = physgen::View<Object, const typename Array::Precision, Uniform, Formats, typename Array::Space>;
  using ConstView = View;
  using Record = WithLayout<Array, Aos>;

  UniformArray() = default;
  /// @throw Error when size is negative or the memory of the record cannot be had
  explicit UniformArray(index_t size) { resize(size); }

  [[nodiscard]] index_t size() const { return size_; }
  /// Bytes of memory held, padding included.
  [[nodiscard]] index_t bytes() const { return record_.bytes(); }
  /// The records that hold so many objects: one, or none of no objects.
  [[nodiscard]] static constexpr index_t records(index_t objects) { return std::min(objects, index_t{1}); }
  [[nodiscard]] View view() const { return {record_.untyped().base, size_, 1}; }
  [[nodiscard]] View const_view() const { return view(); }
  /// The record, to be filled: an array of one object, or of none before there were objects.
  [[nodiscard]] Record& contents() { return record_; }

  /// The record keeps its values, also while there are no objects.
  void resize(index_t size) {
    if (detail::checked_size(Object::name, size) > 0) record_.resize(1);
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

/// Gives the elements of these fields, in all objects of an array, bits_of_no_value() in place of their values.
/// The padding behind the last object stays.
/// @param fields by name; that of a fixed array of nested objects, "points.x", means all entries
/// @throw Error when the array has no field of such a name
inline void start_without_values(const UntypedArray& array, std::initializer_list<std::string_view> fields) {
  std::vector<std::byte> memory(static_cast<std::size_t>(array.bytes()));
  if (memory.empty()) return;
  copy_memory(memory.data(), SpaceKind::host, array.base, array.space, array.bytes());
  UntypedArray image = array;
  image.base = memory.data();
  for (const std::string_view name : fields) {
    bool is_there = false;
    for (const FieldInfo& field : array.fields) {
      if (!detail::is_named(field.name, name)) continue;
      is_there = true;
      const std::uint64_t bits = bits_of_no_value(field.type);
      const int size = element_bytes(field.type);
      for (index_t i = 0; i < array.size; ++i) {
        for (int k = 0; k < field.count; ++k) {
          std::memcpy(image.address(i, field.offset + k * size, size), &bits, static_cast<std::size_t>(size));
        }
      }
    }
    if (!is_there) {
      throw Error(std::string(array.object) + ": there is no field " + std::string(name) +
                  " that could start without a value");
    }
  }
  copy_memory(array.base, array.space, image.base, SpaceKind::host, array.bytes());
}

/// The bytes() that an array of so many objects would have, without making it. @pre objects >= 0
template <class Array>
[[nodiscard]] constexpr index_t bytes_of_array(index_t objects) {
  if constexpr (requires { typename Array::Record; }) {
    return bytes_of_array<typename Array::Record>(Array::records(objects));
  } else {
    if (objects == 0) return 0;
    return Array::Layout::padded(objects) * Array::record_bytes +
           (checked_build ? index_t{sizeof(Losses)} : index_t{0});
  }
}

/// Makes `array` one of `size` objects with their initial values. In checked builds the fields named begin without one
/// instead, as signalling NaN: those that a program writes before it reads them.
/// @throw Error when size is negative or the memory cannot be had
template <class Array>
void allocate(Array& array, index_t size, [[maybe_unused]] std::initializer_list<std::string_view> written_first = {}) {
  array = Array(size);
  if constexpr (checked_build) {
    if (written_first.size() == 0) return;
    if constexpr (requires { array.untyped(); }) {
      start_without_values(array.untyped(), written_first);
    } else if constexpr (requires { array.contents(); }) {
      start_without_values(array.contents().untyped(), written_first);
    }  // a LocalArray holds nothing: each call of the fused kernel begins so
  }
}

}  // namespace physgen
