// Cursors of locals of fused kernels: those that they stand for, with the local and the field in their types, which
// compilers print where one is used as only an array could be.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/copy_fields.h>
#include <physgen/detail/cursor.h>
#include <physgen/fields/record.h>

namespace physgen {
template <class Object, class Real, class Formats, class Tag, class Layout>
struct Local;  // fuse.h
}  // namespace physgen

namespace physgen::detail {

// Fields of a record are counted as Object::fields has them: those of nested objects one by one.
template <class... Field>
[[nodiscard]] constexpr int count_fields(RecordFields<Field...> fields);
template <class Record, int kNumber, class Shape, class Format, class T, int kEntries>
[[nodiscard]] constexpr int count_fields(StoredField<Record, kNumber, Shape, Format, T, kEntries> /*field*/) {
  return 1;
}
template <class Record, int kNumber, class Object, class Formats, class Real, int kEntries>
[[nodiscard]] constexpr int count_fields(NestedField<Record, kNumber, Object, Formats, Real, kEntries> /*field*/) {
  return kEntries * count_fields(typename Object::template Record<Real, Formats>::fields_());
}
/// Those before field `number` of the record.
template <class... Field>
[[nodiscard]] constexpr int count_fields_before(RecordFields<Field...> /*fields*/, int number) {
  const int counts[] = {count_fields(Field())...};
  int before = 0;
  for (int f = 0; f < number; ++f) before += counts[f];
  return before;
}
template <class... Field>
[[nodiscard]] constexpr int count_fields(RecordFields<Field...> fields) {
  return count_fields_before(fields, int{sizeof...(Field)});
}

/// On a field of a local. References to it are those of any other cursor; what they refuse names Local and kField.
template <class Cursor, class Local, FieldName kField>
struct LocalField : Cursor {
  PHYSGEN_FUNCTION explicit LocalField(const Cursor& cursor) : Cursor(cursor) {}

  template <class Shape, class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION auto field(int offset) const {
    if constexpr (Shape::is_scalar) {
      return element<Format, T>(offset);
    } else {
      return FieldRef<Shape, Format, T, LocalField>(LocalField(this->nested(offset)));
    }
  }
  template <class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION auto element(int offset, int k = 0) const {
    return ElementRef<Format, T, LocalField>(*this, offset, k);
  }
};

/// On the object(s) of a local, or on one that is nested in them. @tparam kFirst number of its first field
template <class Cursor, class Local_, int kFirst = 0>
struct LocalObject : Cursor {
  using Local = Local_;
  static constexpr int first_field = kFirst;

  PHYSGEN_FUNCTION explicit LocalObject(const Cursor& cursor) : Cursor(cursor) {}
  template <FieldName kField, class Shape, class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION auto local_field(int offset) const {
    return LocalField<Cursor, Local, kField>(*this).template field<Shape, Format, T>(offset);
  }
  template <int kNumber>
  [[nodiscard]] PHYSGEN_FUNCTION LocalObject<Cursor, Local, kNumber> local_object(int offset) const {
    return LocalObject<Cursor, Local, kNumber>(this->nested(offset));
  }
};

/// In the place of a field that a local does not have: the type that stands for its value is defined nowhere.
template <class Value>
struct NoField {
  PHYSGEN_FUNCTION Value get() const;
  PHYSGEN_FUNCTION operator Value() const;  // NOLINT: implicit as a reference's conversion is
  PHYSGEN_FUNCTION const NoField& operator=(const Value& value) const;
};
template <class Local, FieldName kField, class I>
PHYSGEN_FUNCTION constexpr void refuse_other_objects() {
  static_assert(is_own<I>,
                "a local of fuse() has the objects at the kernel's own index alone, local[i]; what other objects or "
                "other kernels read needs an array");
}

/// In the place of a cursor: on other objects than those of the index that a fused kernel gives its steps. None of
/// their fields compiles.
template <class Local_, class I, int kFirst = 0>
struct NotInLocal {
  using Local = Local_;
  static constexpr int first_field = kFirst;
  template <class T>
  using Lanes = lanes_t<T, I>;

  template <FieldName kField, class Shape, class Format, class T>
  PHYSGEN_FUNCTION auto local_field(int /*offset*/) const {
    refuse_other_objects<Local, kField, I>();
    return NoField<typename Shape::template Value<lanes_t<T, I>>>();
  }
  template <int kNumber>
  [[nodiscard]] PHYSGEN_FUNCTION NotInLocal<Local, I, kNumber> local_object(int /*offset*/) const {
    return {};
  }
};

/// LocalObject and NotInLocal: the cursors of a local.
template <class Cursor>
concept OnLocal = requires { Cursor::first_field; };

}  // namespace physgen::detail

namespace physgen {

/// Fields of a local, by their names.
template <detail::OnLocal Cursor_>
class OnCursor<Cursor_> {
 public:
  using Cursor = Cursor_;

 protected:
  PHYSGEN_FUNCTION explicit OnCursor(const Cursor& cursor) : at_(cursor) {}

  template <class Record, int kNumber, class Shape, class Format, class T, int kEntries>
  [[nodiscard]] PHYSGEN_FUNCTION auto field_(StoredField<Record, kNumber, Shape, Format, T, kEntries> /*as*/,
                                             int offset) const {
    using Object = typename Cursor::Local::Object;
    return at_.template local_field<detail::field_name<Object, number<Record>(kNumber)>(), Shape, Format, T>(offset);
  }
  template <class Record, int kNumber, class Object, class Formats, class Real, int kEntries>
  [[nodiscard]] PHYSGEN_FUNCTION auto field_(NestedField<Record, kNumber, Object, Formats, Real, kEntries> /*as*/,
                                             int offset) const {
    const auto inner = at_.template local_object<number<Record>(kNumber)>(offset);
    return typename Object::template Ref<Real, Formats, std::remove_const_t<decltype(inner)>>(inner);
  }

 private:
  friend detail::CursorOf;
  /// The number of a record's field among all fields of the local.
  template <class Record>
  [[nodiscard]] static constexpr int number(int field) {
    return Cursor::first_field + detail::count_fields_before(typename Record::fields_(), field);
  }

  Cursor at_;
};

}  // namespace physgen

#pragma pop_macro("I")
