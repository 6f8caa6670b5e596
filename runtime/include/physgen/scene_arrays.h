// What the generated arrays of scenes are made of: arrays in other layouts and formats, arrays that programs only read,
// one record for all objects, and fields that begin as signalling NaN in checked builds.
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
template <class Array, class Layout>
struct WithLayout;
template <class Object, class Real, class Space, class Old, class Formats, class Layout>
struct WithLayout<Array<Object, Real, Space, Old, Formats>, Layout> {
  using type = Array<Object, Real, Space, Layout, Formats>;
};
}  // namespace detail

/// The same array, with its fields stored as Formats says.
template <class Array, class Formats>
using WithFormats = typename detail::WithFormats<Array, Formats>::type;

/// The same array, with its objects lying as Layout says.
template <class Array, class Layout>
using WithLayout = typename detail::WithLayout<Array, Layout>::type;

/// How a group of a scene stores its arrays: as the schemas of their objects say. A struct of one's own in its place
/// has another array of the same objects for some:
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
  /// Of which so many objects are one.
  [[nodiscard]] static constexpr index_t records(index_t objects) { return std::min(objects, index_t{1}); }
  [[nodiscard]] View view() const { return {record_.storage().base, size_, 1}; }
  [[nodiscard]] View const_view() const { return view(); }
  /// The record, as an array of one object, or of none where there are no objects: for whoever fills it.
  [[nodiscard]] Record& contents() { return record_; }

  /// The record keeps its values.
  void resize(index_t size) {
    if (size < 0) {
      throw Error(std::string(Object::name) + ": an array of " + std::to_string(size) +
                  " objects cannot exist; 0 or more can");
    }
    record_.resize(records(size));
    size_ = size;
  }

 private:
  Record record_;
  index_t size_ = 0;
};

namespace detail {

/// The bits of a signalling NaN, for elements of types that have one.
[[nodiscard]] inline bool signalling_nan(ElementType type, std::byte* to) {
  const auto put = [to](const auto& bits) {
    std::memcpy(to, &bits, sizeof bits);
    return true;
  };
  switch (type) {
    case ElementType::float32:
      return put(std::uint32_t{0x7fa00000});
    case ElementType::float64:
      return put(std::uint64_t{0x7ff4000000000000});
    case ElementType::half:
      return put(std::uint16_t{0x7d00});
    case ElementType::bfloat16:
      return put(std::uint16_t{0x7fa0});
    default:
      return false;
  }
}

}  // namespace detail

/// Gives the elements of these fields, in all objects of an array, signalling NaN in place of their values; integers
/// and numbers in equal steps, which have none, stay. What lies behind the last object stays, too.
/// @throw Error when the array has no field of such a name
inline void start_without_values(const Storage& storage, std::initializer_list<std::string_view> fields) {
  std::vector<std::byte> image(static_cast<std::size_t>(storage.bytes()));
  if (image.empty()) return;
  copy_memory(image.data(), SpaceKind::host, storage.base, storage.space, storage.bytes());
  for (const std::string_view name : fields) {
    const auto field = std::find_if(storage.fields.begin(), storage.fields.end(),
                                    [&](const FieldInfo& info) { return info.name == name; });
    if (field == storage.fields.end()) {
      throw Error(std::string(storage.object) + ": there is no field " + std::string(name) +
                  " that could start without a value");
    }
    alignas(8) std::byte nan[8];
    if (!detail::signalling_nan(field->type, nan)) continue;
    const int size = element_bytes(field->type);
    for (index_t i = 0; i < storage.size; ++i) {
      for (int k = 0; k < field->count; ++k) {
        const index_t at = i / storage.pitch * storage.pitch * storage.record_bytes +
                           (field->offset + index_t{k} * size) * storage.pitch + i % storage.pitch * size;
        std::memcpy(image.data() + at, nan, static_cast<std::size_t>(size));
      }
    }
  }
  copy_memory(storage.base, storage.space, image.data(), SpaceKind::host, storage.bytes());
}

/// What an array of so many objects holds: its bytes(), without making it. @pre objects >= 0
template <class Array>
[[nodiscard]] constexpr index_t bytes_of_array(index_t objects) {
  if constexpr (requires { typename Array::Record; }) {
    return bytes_of_array<typename Array::Record>(Array::records(objects));
  } else {
    if (objects == 0) return 0;
    return Array::View::Layout::padded(objects) * Array::record_bytes +
           (checked_build ? index_t{sizeof(Losses)} : index_t{0});
  }
}

/// Makes `array` one of `size` objects with their initial values. In checked builds the fields named begin as
/// signalling NaN instead: those that a program writes before it reads them.
/// @throw Error when size is negative or the memory cannot be had
template <class Array>
void allocate(Array& array, index_t size, [[maybe_unused]] std::initializer_list<std::string_view> written_first = {}) {
  array = Array(size);
  if constexpr (checked_build) {
    if (written_first.size() > 0) start_without_values(array.storage(), written_first);
  }
}

}  // namespace physgen
