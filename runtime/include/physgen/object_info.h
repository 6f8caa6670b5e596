// What generated code tells the runtime about an object type beyond its accessors: its fields as data, and where they
// lie in a record.
#pragma once

#include <physgen/format.h>
#include <physgen/shape.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <string_view>

namespace physgen {

/// The functions of a format of a program's own, for what converts on the host.
struct OwnCodec {
  double (*decode)(const std::byte* from);
  void (*encode)(std::byte* to, double value);
};

/// One field of an object type: `count` stored elements of one type that follow each other from byte `offset` of the
/// record on. An element stands for centre + scale * what is stored, or for what the functions of its own format say.
struct FieldInfo {
  std::string_view name;  ///< "svd.U" for a field of a nested object
  std::string_view unit;  ///< empty: none stated
  ElementType type;       ///< none: the field takes no bytes, and its elements cannot be read
  int offset;             ///< [bytes]
  int count;              ///< stored elements, 4 for each rotation that is a quaternion; those that code sees, of none
  double initial;         ///< value of every element of a new object, but of rotations, which begin as the identity
  double scale;
  double centre;
  bool rotation;                  ///< one or an array of them
  bool quaternion;                ///< rotations, stored as w, x, y, z
  const OwnCodec* own = nullptr;  ///< where the format is none of the library's
  bool pruned = false;            ///< of type none, and copies to the array leave it out

  /// Elements that code sees: 9 for a rotation, however it is stored.
  [[nodiscard]] PHYSGEN_FUNCTION constexpr int visible_count() const { return quaternion ? count / 4 * 9 : count; }
  [[nodiscard]] PHYSGEN_FUNCTION constexpr bool is_stored() const { return type != ElementType::none; }
};

/// Elements of a field of this shape and format that are stored.
template <class Shape, class Format>
inline constexpr int stored_count = format::is_quaternion<Format> ? 4 : Shape::count;

namespace detail {

template <class Format, class T>
struct OwnFunctions {
  using Stored = typename Format::template Stored<T>;
  static_assert(std::is_trivially_copyable_v<Stored> &&
                    int{sizeof(Stored)} == element_bytes(Format::template type<T>) &&
                    Format::template type<T> != ElementType::int32,
                "a format's Stored has the bytes of its ElementType, which is one of numbers");

  static double decode(const std::byte* from) {
    Stored stored;
    std::memcpy(&stored, from, sizeof stored);
    return static_cast<double>(Format::template decode<T>(stored));
  }
  static void encode(std::byte* to, double value) {
    const Stored stored = Format::template encode<T>(static_cast<T>(value));
    std::memcpy(to, &stored, sizeof stored);
  }
  static constexpr OwnCodec codec{&decode, &encode};
};

/// The functions of Format where copies do not know it by its numbers, else null.
template <class Format, class T>
[[nodiscard]] constexpr const OwnCodec* own_codec() {
  if constexpr (format::FromLibrary<Format> || format::StoresNothing<Format> || format::is_probe<Format>) {
    return nullptr;
  } else {
    return &OwnFunctions<Format, T>::codec;
  }
}

}  // namespace detail

/// @tparam T the type computed with
/// @param entries of a fixed array; 1 for others
template <class Shape, class Format, class T>
[[nodiscard]] constexpr FieldInfo field_info(std::string_view name, std::string_view unit, int offset, int entries,
                                             double initial) {
  using Element = format::ElementFormat<Format>;
  return {name,
          unit,
          Element::template type<T>,
          offset,
          entries * stored_count<Shape, Format>,
          initial,
          Element::scale,
          Element::centre,
          std::is_same_v<Shape, shape::Rotation>,
          format::is_quaternion<Format>,
          detail::own_codec<Element, T>(),
          format::is_pruned<Element>};
}

/// Number of elements over all fields, as code sees them.
template <std::size_t N>
[[nodiscard]] constexpr int element_count(const std::array<FieldInfo, N>& fields) {
  int count = 0;
  for (const FieldInfo& field : fields) count += field.visible_count();
  return count;
}

/// The room a field takes in a record.
struct Slot {
  int bytes;      ///< of one entry; a fixed array has several. 0: nothing is stored
  int alignment;  ///< a power of two up to 8
  int entries;
};

template <class Shape, class Format, class T>
[[nodiscard]] constexpr Slot slot(int entries = 1) {
  static_assert(!format::is_quaternion<Format> || std::is_same_v<Shape, shape::Rotation>,
                "only a Rotation can be stored as a quaternion");
  static_assert(!std::is_integral_v<T> || format::holds_indices<format::ElementFormat<Format>>,
                "a field of integers is stored as it is, in format::Native: no other format keeps every index");
  using Element = format::ElementFormat<Format>;
  if constexpr (format::StoresNothing<Element>) {
    return {0, 1, entries};
  } else {
    constexpr int size = sizeof(typename Element::template Stored<T>);
    return {stored_count<Shape, Format> * size, size, entries};
  }
}

/// The room of nested objects with this record.
template <class Record>
[[nodiscard]] constexpr Slot nested_slot(int entries = 1) {
  return {align_up(Record::bytes, Record::plan_.alignment), Record::plan_.alignment, entries};
}

/// Where the fields of a record lie.
template <int N>
struct RecordPlan {
  std::array<int, N> offset;  ///< of each field, in order of declaration [bytes]
  std::array<int, N> stride;  ///< from one entry of a fixed array to the next
  int bytes;
  int alignment;  ///< of the largest element
};

/// Fields lie by alignment, largest first, and in order of declaration among equals: that leaves no gaps between them.
/// Those of no bytes are at 0.
template <int N>
[[nodiscard]] constexpr RecordPlan<N> plan_record(const std::array<Slot, N>& slots) {
  RecordPlan<N> plan{};
  plan.alignment = 1;
  for (int alignment = 8; alignment > 0; alignment /= 2) {
    for (std::size_t f = 0; f < N; ++f) {
      if (slots[f].alignment != alignment || slots[f].bytes == 0) continue;
      plan.offset[f] = plan.bytes;
      plan.stride[f] = slots[f].bytes;
      plan.bytes += slots[f].entries * slots[f].bytes;
      if (plan.alignment < alignment) plan.alignment = alignment;
    }
  }
  return plan;
}

/// Whether the record of `Object`, stored in `Formats`, has these bytes, this alignment and these offsets of `fields`,
/// all its elements lie inside it and are aligned to their size, and no two of them share a byte. Generated code proves
/// this when it is compiled. Offsets of a channel are multiplied by the pitch, so what holds for one record holds for
/// the channels of every layout, whatever the number of objects.
template <class Object, class Real, class Formats>
[[nodiscard]] constexpr bool is_sound_record(int bytes, int alignment, std::initializer_list<int> offsets) {
  using Record = typename Object::template Record<Real, Formats>;
  if (Record::bytes != bytes || Record::alignment != alignment) return false;
  auto fields = Object::template fields<Real, Formats>;
  if (fields.size() != offsets.size()) return false;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (fields[f].offset != offsets.begin()[f]) return false;
  }
  std::sort(fields.begin(), fields.end(), [](const FieldInfo& a, const FieldInfo& b) { return a.offset < b.offset; });
  int end = 0;  // of the fields so far
  for (const FieldInfo& field : fields) {
    const int size = element_bytes(field.type);
    if (size == 0) continue;
    if (field.offset < end || field.offset % size != 0 || alignment % size != 0) return false;
    end = field.offset + field.count * size;
  }
  return end <= bytes;
}

}  // namespace physgen
