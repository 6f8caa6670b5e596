// Records: the places of the fields of one object in memory, and the parts of generated code: the fields of a record,
// and the tag of an object type.
#pragma once

#include <physgen/fields/object_info.h>
#include <physgen/fields/object_ref.h>
#include <physgen/memory/space.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>

namespace physgen {

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

/// The places of a record's fields.
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

/// The fields of a generated record, and where they lie.
template <class... Field>
struct RecordFields {
  static constexpr RecordPlan<int{sizeof...(Field)}> plan = plan_record<int{sizeof...(Field)}>({{Field::slot...}});
  static constexpr int alignment = plan.alignment;  ///< of the record in an array of structs
};
/// The same where the schema asks for an alignment of records.
template <int kAlignment, class... Field>
struct AlignedRecordFields : RecordFields<Field...> {
  static constexpr int alignment = std::max(kAlignment, RecordFields<Field...>::plan.alignment);
};

/// A generated record with its size.
/// @tparam Generated has the fields by name, and `fields_`, the RecordFields of all
template <class Generated>
struct SizedRecord : Generated {
  static constexpr int bytes = Generated::fields_::plan.bytes;
  static constexpr int alignment = Generated::fields_::alignment;
};

/// Field number kNumber of a generated record: where it lies there, and as what.
/// @tparam T the type computed with
/// @tparam kEntries of a fixed array; 1 for others
template <class Record, int kNumber, class Shape, class Format, class T, int kEntries = 1>
struct StoredField : StoredAs<Shape, Format, T> {
  using As = StoredAs<Shape, Format, T>;
  static constexpr Slot slot = physgen::slot<Shape, Format, T>(kEntries);
  static constexpr int offset = Record::fields_::plan.offset[kNumber];  ///< [bytes]
  static constexpr int stride = Record::fields_::plan.stride[kNumber];  ///< from one entry to the next [bytes]
};

/// The same for a nested object, or a fixed array of them.
/// @tparam Object the generated tag of the nested object
template <class Record, int kNumber, class Object, class Formats, class Real, int kEntries = 1>
struct NestedField : NestedAs<Object, Formats, Real> {
  using As = NestedAs<Object, Formats, Real>;
  using Inner = typename Object::template Record<Real, Formats>;
  static constexpr int inner_alignment = Inner::fields_::plan.alignment;
  static constexpr Slot slot = {align_up(Inner::bytes, inner_alignment), inner_alignment, kEntries};
  static constexpr int offset = Record::fields_::plan.offset[kNumber];
  static constexpr int stride = Record::fields_::plan.stride[kNumber];
};

/// The part of a schema's words on a field, or on a field of a nested object, that does not depend on its format.
struct FieldText {
  std::string_view name;  ///< "U", "svd.U", "points[2].x"
  std::string_view unit = {};
  double initial = 0;  ///< value of every element of a new object
};

namespace detail {

/// What the schema says of each field of an object, or nothing where it says nothing of any.
template <class Object>
[[nodiscard]] constexpr std::span<const std::string_view> docs_of() {
  if constexpr (requires { Object::docs; }) {
    return Object::docs;
  } else {
    return {};
  }
}

/// Appends the FieldInfo of fields, with the next texts, to `out`.
struct FieldInfos {
  const FieldText* text;
  FieldInfo* out;

  template <class Shape, class Format, class T>
  constexpr void add(StoredAs<Shape, Format, T> /*as*/, const Slot& slot, int offset, std::string_view doc) {
    *out = field_info<Shape, Format, T>(text->name, text->unit, offset, slot.entries, text->initial);
    out->doc = doc;
    ++out;
    ++text;
  }
  template <class Object, class Formats, class Real>
  constexpr void add(NestedAs<Object, Formats, Real> /*as*/, const Slot& slot, int offset, std::string_view /*doc*/) {
    for (int entry = 0; entry < slot.entries; ++entry) {
      add_all(typename Object::template Record<Real, Formats>::fields_(), offset + entry * slot.bytes,
              docs_of<Object>());
    }
  }
  template <class... Field>
  constexpr void add_all(RecordFields<Field...> /*fields*/, int offset, std::span<const std::string_view> docs) {
    // One after the other; a fold over more than 256 fields nests too deep for clang.
    auto next = [of_all = docs, k = std::size_t{0}]() mutable {
      return k < of_all.size() ? of_all[k++] : std::string_view();
    };
    const int added[] = {(add(Field(), Field::slot, offset + Field::offset, next()), 0)...};
    (void)added;
  }
};

}  // namespace detail

/// The fields of a record as data, those of nested objects one by one.
/// @param texts of each of them, in order of declaration
/// @param docs of the fields of the record itself, or none
template <class Record, std::size_t N>
[[nodiscard]] constexpr std::array<FieldInfo, N> field_infos(const std::array<FieldText, N>& texts,
                                                             std::span<const std::string_view> docs) {
  std::array<FieldInfo, N> infos{};
  detail::FieldInfos{texts.data(), infos.data()}.add_all(typename Record::fields_(), 0, docs);
  return infos;
}

/// The base of the tags of object types. A tag adds `name` and `texts`.
/// @tparam Object the tag
/// @tparam Formats_ the same in both spaces, so that kernels may name views without saying for which space
template <class Object, template <class> class Value_, template <class> class Formats_,
          template <class, class> class Record_, template <class, class, class> class Accessors_,
          template <class, class, class, int> class Probe_>
struct ObjectTag {
  template <class Real>
  using Value = Value_<Real>;
  template <class /*Space*/>
  using Formats = Formats_<Host>;
  template <class Real, class Formats>
  using Record = SizedRecord<Record_<Real, Formats>>;
  template <class Real, class Formats, class Cursor>
  using Accessors = Accessors_<Real, Formats, Cursor>;
  template <class Real, class Formats, class Cursor>
  using Ref = typename detail::RefOf<Object, Real, Formats, Cursor>::type;
  template <class ArrayTag, class Base>
  using Probe = Probe_<ArrayTag, Base, Object, 0>;
  /// The fields as data.
  template <class Real, class Formats>
  static constexpr auto fields = field_infos<Record<Real, Formats>>(Object::texts, detail::docs_of<Object>());
};
/// The same where the spaces store some field differently.
template <class Object, template <class> class Value_, template <class> class Formats_,
          template <class, class> class Record_, template <class, class, class> class Accessors_,
          template <class, class, class, int> class Probe_>
struct ObjectTagPerSpace : ObjectTag<Object, Value_, Formats_, Record_, Accessors_, Probe_> {
  template <class Space>
  using Formats = Formats_<Space>;
};

namespace detail {

/// is_sound_record() of the fields of a record. No template: there are as many objects as a schema has.
[[nodiscard]] constexpr bool are_sound_fields(FieldInfo* begin, FieldInfo* end, int bytes, int alignment,
                                              std::initializer_list<int> offsets) {
  if (end - begin != static_cast<std::ptrdiff_t>(offsets.size())) return false;
  for (std::size_t f = 0; f < offsets.size(); ++f) {
    if (begin[f].offset != offsets.begin()[f]) return false;
  }
  std::sort(begin, end, [](const FieldInfo& a, const FieldInfo& b) { return a.offset < b.offset; });
  int last = 0;  // byte of the fields so far
  for (const FieldInfo* field = begin; field != end; ++field) {
    const int size = element_bytes(field->type);
    if (size == 0) continue;
    if (field->offset < last || field->offset % size != 0 || alignment % size != 0) return false;
    last = field->offset + field->count * size;
  }
  return last <= bytes;
}

}  // namespace detail

/// Whether the record of `Object`, stored in `Formats`, has these bytes, this alignment and these offsets of `fields`,
/// all its elements lie inside it and are aligned to their size, and no two of them share a byte. Generated code proves
/// this when it is compiled. Offsets of a channel are multiplied by the pitch, so what holds for one record holds for
/// the channels of every layout, whatever the number of objects.
template <class Object, class Real, class Formats>
[[nodiscard]] constexpr bool is_sound_record(int bytes, int alignment, std::initializer_list<int> offsets) {
  using Record = typename Object::template Record<Real, Formats>;
  if (Record::bytes != bytes || Record::alignment != alignment) return false;
  auto fields = Object::template fields<Real, Formats>;
  return detail::are_sound_fields(fields.data(), fields.data() + fields.size(), bytes, alignment, offsets);
}

/// A record as physgen planned it.
struct PlannedRecord {
  int bytes;
  int alignment;
  std::initializer_list<int> offsets;
};
/// Whether the records of Object in the formats of its schema are sound, for both precisions.
template <class Object, class Space>
[[nodiscard]] constexpr bool are_sound_records(const PlannedRecord& with_float, const PlannedRecord& with_double) {
  using Formats = typename Object::template Formats<Space>;
  return is_sound_record<Object, float, Formats>(with_float.bytes, with_float.alignment, with_float.offsets) &&
         is_sound_record<Object, double, Formats>(with_double.bytes, with_double.alignment, with_double.offsets);
}

}  // namespace physgen
