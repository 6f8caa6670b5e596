// Cursors of locals of fused kernels: those that they stand for, with the local and the field in their types, which
// compilers print where one is used as only an array could be.
#pragma once

#include <physgen/detail/copy_fields.h>
#include <physgen/detail/cursor.h>
#include <physgen/record.h>

namespace physgen {
template <class Object, class Real, class Formats, class Tag>
struct Local;  // fuse.h
}  // namespace physgen

namespace physgen::detail {

template <class Local>
struct ObjectOfLocal;
template <class Object, class Real, class Formats, class Tag>
struct ObjectOfLocal<Local<Object, Real, Formats, Tag>> {
  using type = Object;
};

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
template <class Cursor, class Local, int kFirst = 0>
struct LocalObject : Cursor {
  PHYSGEN_FUNCTION explicit LocalObject(const Cursor& cursor) : Cursor(cursor) {}
};

/// In the place of a cursor: on other objects than those of the index that a fused kernel gives its steps.
template <class Local, class I, int kFirst = 0>
struct NotInLocal {
  template <class T>
  using Lanes = lanes_t<T, I>;
};

/// Refuses a field of theirs, in one message: the type that stands for its value is defined nowhere.
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

}  // namespace physgen::detail

namespace physgen {

/// Fields of a local.
template <class Cursor_, class Local, int kFirst>
class OnCursor<detail::LocalObject<Cursor_, Local, kFirst>> {
 public:
  using Cursor = detail::LocalObject<Cursor_, Local, kFirst>;

 protected:
  PHYSGEN_FUNCTION explicit OnCursor(const Cursor& cursor) : at_(cursor) {}

  template <class Record, int kNumber, class Shape, class Format, class T, int kEntries>
  [[nodiscard]] PHYSGEN_FUNCTION auto field_(StoredField<Record, kNumber, Shape, Format, T, kEntries> /*as*/,
                                             int offset) const {
    constexpr int number = kFirst + detail::count_fields_before(typename Record::fields_(), kNumber);
    using Object = typename detail::ObjectOfLocal<Local>::type;
    using Field = detail::LocalField<Cursor_, Local, detail::field_name<Object, number>()>;
    return Field(at_).template field<Shape, Format, T>(offset);
  }
  template <class Record, int kNumber, class Object, class Formats, class Real, int kEntries>
  [[nodiscard]] PHYSGEN_FUNCTION auto field_(NestedField<Record, kNumber, Object, Formats, Real, kEntries> /*as*/,
                                             int offset) const {
    using Inner =
        detail::LocalObject<Cursor_, Local, kFirst + detail::count_fields_before(typename Record::fields_(), kNumber)>;
    return typename Object::template Ref<Real, Formats, Inner>(Inner(at_.nested(offset)));
  }

 private:
  Cursor at_;
};

/// Fields of objects that a local does not have: none of them compiles.
template <class Local, class I, int kFirst>
class OnCursor<detail::NotInLocal<Local, I, kFirst>> {
 public:
  using Cursor = detail::NotInLocal<Local, I, kFirst>;

 protected:
  PHYSGEN_FUNCTION explicit OnCursor(const Cursor& /*cursor*/) {}

  template <class Record, int kNumber, class Shape, class Format, class T, int kEntries>
  PHYSGEN_FUNCTION auto field_(StoredField<Record, kNumber, Shape, Format, T, kEntries> /*as*/, int /*offset*/) const {
    constexpr int number = kFirst + detail::count_fields_before(typename Record::fields_(), kNumber);
    using Object = typename detail::ObjectOfLocal<Local>::type;
    detail::refuse_other_objects<Local, detail::field_name<Object, number>(), I>();
    return detail::NoField<typename Shape::template Value<lanes_t<T, I>>>();
  }
  template <class Record, int kNumber, class Object, class Formats, class Real, int kEntries>
  PHYSGEN_FUNCTION auto field_(NestedField<Record, kNumber, Object, Formats, Real, kEntries> /*as*/,
                               int /*offset*/) const {
    using Inner =
        detail::NotInLocal<Local, I, kFirst + detail::count_fields_before(typename Record::fields_(), kNumber)>;
    return typename Object::template Ref<Real, Formats, Inner>(Inner());
  }
};

}  // namespace physgen
