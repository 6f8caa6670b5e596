// Fields as NumPy arrays. A field is shown without a copy where strides can say where its numbers lie and NumPy knows
// their type; else reading gives a copy that cannot be written, so that no value is lost in it. Assigning works for
// all.
#pragma once

#include <physgen/python/numpy_arrays.h>  // Python's headers come first
#include <physgen/python/object_array.h>

#include <string>

namespace physgen::python {

[[nodiscard]] inline std::string full_name(const ObjectArray& array, std::size_t number) {
  return std::string(array.type().name) + "." + std::string(array.fields()[number].name);
}

inline void require_stored(const ObjectArray& array, std::size_t number) {
  if (!array.fields()[number].is_stored())
    throw Error(full_name(array, number) + ": nothing is stored of this field, so it can be neither read nor set");
}

/// Where a field lies.
struct Placed {
  Extents extents;
  const std::byte* first;
};
[[nodiscard]] inline const std::byte* first_element(const UntypedArray& memory, const FieldInfo& field) {
  return memory.size == 0 ? nullptr : memory.address(0, field.offset, element_bytes(field.type));
}
/// The field of all objects. @pre the layout has no tiles
[[nodiscard]] inline Placed place_of(const ObjectArray& array, std::size_t number) {
  const FieldInfo& field = array.fields()[number];
  const UntypedArray memory = array.untyped();
  const int size = element_bytes(field.type);
  Extents extents;
  extents.add(memory.size, memory.pitch == 1 ? memory.record_bytes : size);
  extents.add_elements(array.type().shapes[number], field.count, memory.pitch * size);
  return {std::move(extents), first_element(memory, field)};
}
/// The field in tiles: tiles, lanes, and the shape of the field.
[[nodiscard]] inline Placed place_of_tiles(const ObjectArray& array, std::size_t number) {
  const FieldInfo& field = array.fields()[number];
  const UntypedArray memory = array.untyped();
  const index_t pitch = std::max(memory.pitch, index_t{1});
  const int size = element_bytes(field.type);
  Extents extents;
  extents.add((memory.size + pitch - 1) / pitch, law::tile_bytes(pitch, memory.record_bytes));
  extents.add(pitch, size);
  extents.add_elements(array.type().shapes[number], field.count, pitch * size);
  return {std::move(extents), first_element(memory, field)};
}

/// The field of all objects without a copy; null where NumPy cannot express it.
[[nodiscard]] inline py::object direct_view(const ObjectArray& array, std::size_t number) {
  const py::object dtype = stored_dtype(array.fields()[number]);
  if (!dtype || array.storage().layout->tiled || !host_accessible(array.storage().space)) return {};
  Placed placed = place_of(array, number);
  return array_over(dtype, std::move(placed.extents), placed.first, array.memory());
}

/// A packed field as an array of NumPy.
[[nodiscard]] inline py::array values_of(const PackedField& packed, const ObjectArray& array, std::size_t number) {
  const FieldInfo& field = array.fields()[number];
  const int size = element_bytes(packed.type());
  const py::object dtype = plain_dtype(packed.type());
  Extents extents;
  extents.add(array.size(), field.visible_count() * py::ssize_t{size});
  extents.add_elements(array.type().shapes[number], field.visible_count(), size);
  return array_over(dtype, std::move(extents), packed.memory()->data(), packed.memory());
}

/// The field of all objects: a view without a copy, or a copy that cannot be written.
/// @pre the array lies in host memory
[[nodiscard]] inline py::object read_field(const ObjectArray& array, std::size_t number) {
  require_stored(array, number);
  if (py::object view = direct_view(array, number)) return view;
  const PackedField packed(array, number);
  packed.load();
  const py::array values = values_of(packed, array, number);
  values.attr("setflags")(py::arg("write") = false);
  return values;
}

/// Sets the field of all objects to values of its shape, or of one that NumPy broadcasts to it.
/// @throw a TypeError, ValueError or BufferError where they do not fit; the array is then unchanged
inline void write_field(const ObjectArray& array, std::size_t number, const py::object& values) {
  require_stored(array, number);
  const std::string name = full_name(array, number);
  const py::array given = given_values(values, name);
  const py::object view = array.fields()[number].type == ElementType::half ? py::object()  // which checks no range
                                                                           : direct_view(array, number);
  if (view) return assign(view, given, name);
  const PackedField packed(array, number);
  assign(values_of(packed, array, number), given, name);
  try {
    packed.store();
  } catch (const Error& error) {
    throw py::value_error(error.what());
  }
}

/// The field as it lies in memory, without a copy in every layout: tiles, lanes of a tile, and the shape of the field.
/// Lanes behind the last object are padding.
/// @pre the array lies in host memory
/// @throw a TypeError where NumPy does not know the stored type
[[nodiscard]] inline py::object read_tiles(const ObjectArray& array, std::size_t number) {
  require_stored(array, number);
  const FieldInfo& field = array.fields()[number];
  const py::object dtype = stored_dtype(field);
  if (!dtype) {
    throw py::type_error(full_name(array, number) +
                         " is stored in a format that NumPy does not know; read the field itself, which gives a "
                         "decoded copy, and assign to it");
  }
  Placed placed = place_of_tiles(array, number);
  return array_over(dtype, std::move(placed.extents), placed.first, array.memory());
}

}  // namespace physgen::python
