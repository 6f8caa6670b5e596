// Objects as text, by field and with units, whatever layout and formats they are stored in; for looking and testing:
//   std::cout << stress[3];       // {sigma [Pa] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, pressure [Pa] = 3}
//   std::cout << stress;          // 1000 model::Stress = {{sigma [Pa] = ...}, ...}
#pragma once

#include <physgen/arrays/array.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <type_traits>

namespace physgen {

/// Objects of an array that operator<< writes.
inline constexpr index_t printed_objects = 10;

namespace detail {

/// Writes the fields of one object, as a debugger shows them.
class ObjectPrinter {
 public:
  /// @param texts of the fields, those of nested objects one by one
  ObjectPrinter(std::ostream& out, const FieldText* texts) : out_(out), text_(texts) {}

  template <class Cursor, class... Field>
  void fields(const Cursor& at, int offset, RecordFields<Field...> /*fields*/) {
    const int written[] = {(field(Field(), at, offset + Field::offset, Field::slot.entries), 0)...};
    (void)written;
  }

 private:
  template <class Field, class Cursor>
  void field(Field as, const Cursor& at, int offset, int entries) {
    if constexpr (requires { typename Field::Inner; }) {
      for (int entry = 0; entry < entries; ++entry)
        fields(at, offset + entry * Field::stride, typename Field::Inner::fields_());
    } else {
      out_ << (first_ ? "" : ", ") << text_->name;
      if (!text_->unit.empty()) out_ << " [" << text_->unit << ']';
      out_ << " = ";
      first_ = false;
      ++text_;
      list(entries, entries > 1, [&](int entry) { value(as, at, offset + entry * Field::stride); });
    }
  }
  template <class Shape, class Format, class T, class Cursor>
  void value(StoredAs<Shape, Format, T> /*as*/, const Cursor& at, int offset) {
    if constexpr (format::StoresNothing<format::ElementFormat<Format>>) {
      out_ << "not stored";
    } else if constexpr (Shape::is_scalar) {
      const T value = at.template field<Shape, Format, T>(offset);
      number(value);
    } else {
      const auto matrix = at.template field<Shape, Format, T>(offset).get();
      const int columns = static_cast<int>(matrix.cols());
      list(static_cast<int>(matrix.rows()), true,
           [&](int row) { list(columns, columns > 1, [&](int column) { number(matrix(row, column)); }); });
    }
  }
  template <class T>
  void number(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      out_ << (value ? "true" : "false");
    } else {
      out_ << value;
    }
  }
  template <class Write>
  void list(int count, bool braces, const Write& write) {
    if (braces) out_ << '{';
    for (int k = 0; k < count; ++k) {
      if (k > 0) out_ << ", ";
      write(k);
    }
    if (braces) out_ << '}';
  }

  std::ostream& out_;
  const FieldText* text_;
  bool first_ = true;
};

}  // namespace detail

/// Writes the fields of an object by name. Numbers have the precision of `out`.
template <class Object, class Real, class Index, class Layout, class... Stored>
  requires std::is_arithmetic_v<
      typename ObjectRef<Object, Real, Index, Layout, Stored...>::Cursor::template Lanes<float>>
std::ostream& operator<<(std::ostream& out, const ObjectRef<Object, Real, Index, Layout, Stored...>& object) {
  using Record = typename ObjectRef<Object, Real, Index, Layout, Stored...>::Record;
  out << '{';
  detail::ObjectPrinter(out, Object::texts.data())
      .fields(detail::CursorOf::reference(object), 0, typename Record::fields_());
  return out << '}';
}

/// Writes objects begin .. end-1 of an array on the host, within braces.
/// @throw Error when the array has no such objects
template <class Object, class Real, class Space, class Layout, class Formats>
void print(std::ostream& out, const Array<Object, Real, Space, Layout, Formats>& array, index_t begin, index_t end) {
  if (begin < 0 || begin > end || end > array.size()) {
    throw Error("print(): " + std::string(Object::name) + "[" + std::to_string(array.size()) + "] has no objects " +
                std::to_string(begin) + " up to " + std::to_string(end));
  }
  out << '{';
  for (index_t i = begin; i < end; ++i) out << (i > begin ? ", " : "") << array[i];
  out << '}';
}

/// Writes the number of objects, their type, and the first of them.
template <class Object, class Real, class Space, class Layout, class Formats>
std::ostream& operator<<(std::ostream& out, const Array<Object, Real, Space, Layout, Formats>& array) {
  const index_t shown = std::min(array.size(), printed_objects);
  out << array.size() << ' ' << Object::name << " = ";
  print(out, array, 0, shown);
  return out << (shown < array.size() ? " and more" : "");
}

}  // namespace physgen
