// Fields as NumPy arrays. A field is shown without a copy where strides can say where its numbers lie and NumPy knows
// their type; else reading gives a copy that cannot be written, so that no value is lost in it. Assigning works for
// all.
#pragma once

#include <physgen/python/object_array.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace physgen::python {

namespace py = pybind11;

namespace detail {

/// The type by which NumPy can show the stored numbers of a field; null: it knows none.
[[nodiscard]] inline py::object stored_dtype(const FieldInfo& field) {
  if (field.scale != 1 || field.centre != 0 || field.own != nullptr || field.quaternion) return {};
  switch (field.type) {
    case ElementType::float32:
      return py::dtype::of<float>();
    case ElementType::float64:
      return py::dtype::of<double>();
    case ElementType::int32:
      return py::dtype::of<std::int32_t>();
    case ElementType::half:
      return py::dtype(23);  // NPY_HALF
    case ElementType::bfloat16:
    case ElementType::snorm16:
    case ElementType::none:
      break;
  }
  return {};
}

/// Shape and strides of an array of NumPy.
struct Extents {
  std::vector<py::ssize_t> shape, strides;
  void add(py::ssize_t count, py::ssize_t stride) {
    shape.push_back(count);
    strides.push_back(stride);
  }
  /// Appends those of one object's field, an element of which is `stride` bytes from the next.
  void add_elements(const FieldShape& of, int elements, py::ssize_t stride) {
    if (of.entries > 1) add(of.entries, elements / of.entries * stride);
    if (of.rows > 0) add(of.rows, stride);  // columns one after the other
    if (of.columns > 0) add(of.columns, of.rows * stride);
  }
};

/// An array of NumPy over memory that it keeps.
[[nodiscard]] inline py::array array_over(const py::object& dtype, Extents extents, const std::byte* first,
                                          const std::shared_ptr<Buffer>& memory) {
  const py::capsule keeper(new std::shared_ptr<Buffer>(memory),
                           [](void* held) { delete static_cast<std::shared_ptr<Buffer>*>(held); });
  return {py::reinterpret_borrow<py::dtype>(dtype), std::move(extents.shape), std::move(extents.strides), first,
          keeper};
}

[[nodiscard]] inline std::string full_name(const ObjectArray& array, std::size_t number) {
  return std::string(array.type().name) + "." + std::string(array.fields()[number].name);
}

inline void require_stored(const ObjectArray& array, std::size_t number) {
  if (!array.fields()[number].is_stored())
    throw Error(full_name(array, number) + ": nothing is stored of this field, so it can be neither read nor set");
}

/// The field of all objects without a copy; null where NumPy cannot express it.
[[nodiscard]] inline py::object direct_view(const ObjectArray& array, std::size_t number) {
  const FieldInfo& field = array.fields()[number];
  const py::object dtype = stored_dtype(field);
  const UntypedArray memory = array.untyped();
  const bool one_stride = memory.pitch == 1 || memory.pitch >= memory.size;
  if (!dtype || !one_stride) return {};
  const int size = element_bytes(field.type);
  Extents extents;
  extents.add(memory.size, memory.pitch == 1 ? memory.record_bytes : size);
  extents.add_elements(array.type().shapes[number], field.count, memory.pitch * size);
  const std::byte* first = memory.size == 0 ? nullptr : memory.address(0, field.offset, size);
  return array_over(dtype, std::move(extents), first, array.memory());
}

/// A packed field as an array of NumPy.
[[nodiscard]] inline py::array values_of(const PackedField& packed, const ObjectArray& array, std::size_t number) {
  const FieldInfo& field = array.fields()[number];
  const int size = element_bytes(packed.type());
  const py::object dtype = packed.type() == ElementType::int32     ? py::dtype::of<std::int32_t>()
                           : packed.type() == ElementType::float64 ? py::dtype::of<double>()
                                                                   : py::dtype::of<float>();
  Extents extents;
  extents.add(array.size(), field.visible_count() * py::ssize_t{size});
  extents.add_elements(array.type().shapes[number], field.visible_count(), size);
  return array_over(dtype, std::move(extents), packed.memory()->data(), packed.memory());
}

/// What is assigned, as an array of NumPy. @throw a BufferError where it lies in other memory than the host's
[[nodiscard]] inline py::array given_values(const py::object& values, const std::string& name) {
  constexpr int host_device = 1, pinned_device = 3;  // kDLCPU, kDLCUDAHost
  if (py::isinstance<py::array>(values)) return values;
  if (py::hasattr(values, "__dlpack_device__")) {
    const auto device = values.attr("__dlpack_device__")().cast<py::tuple>();
    const int kind = device[0].cast<int>();
    if (kind != host_device && kind != pinned_device) {
      throw py::buffer_error(name + ": the values lie on DLPack's device " + py::repr(device).cast<std::string>() +
                             ", and this array on the host, (1, 0); copy them to the host first");
    }
    return py::module_::import("numpy").attr("from_dlpack")(values);
  }
  return py::module_::import("numpy").attr("asarray")(values);
}

[[nodiscard]] inline std::string shape_text(const py::array& values) {
  return py::str(values.attr("shape")).cast<std::string>();
}

/// Writes `values` to all of `target`. @throw a TypeError or ValueError naming the field where they do not fit
inline void assign(const py::array& target, const py::array& values, const std::string& name) {
  const py::module_ numpy = py::module_::import("numpy");
  const auto text = [](const py::object& of) { return py::str(of).cast<std::string>(); };
  if (!numpy.attr("can_cast")(values.dtype(), target.dtype(), "same_kind").cast<bool>()) {
    throw py::type_error(name + " holds numbers of type " + text(target.dtype()) + ", to which " +
                         text(values.dtype()) + " does not convert; convert the values by .astype() if that is meant");
  }
  py::object fitting;
  try {
    fitting = numpy.attr("broadcast_to")(values, target.attr("shape"));
  } catch (const py::error_already_set&) {
    throw py::value_error(name + " has the shape " + shape_text(target) + "; values of the shape " +
                          shape_text(values) + " do not fit");
  }
  if (target.dtype().kind() == 'i' && values.dtype().itemsize() > target.dtype().itemsize() && values.size() > 0) {
    const double low = values.attr("min")().cast<double>(), high = values.attr("max")().cast<double>();
    if (low < std::numeric_limits<std::int32_t>::min() || high > std::numeric_limits<std::int32_t>::max()) {
      throw py::value_error(name + " holds whole numbers from -2147483648 to 2147483647, and the values go from " +
                            text(values.attr("min")()) + " to " + text(values.attr("max")()));
    }
  }
  numpy.attr("copyto")(target, fitting, "same_kind");
}

}  // namespace detail

/// The field of all objects: a view without a copy, or a copy that cannot be written.
[[nodiscard]] inline py::object read_field(const ObjectArray& array, std::size_t number) {
  detail::require_stored(array, number);
  if (py::object view = detail::direct_view(array, number)) return view;
  const PackedField packed(array, number);
  packed.load();
  const py::array values = detail::values_of(packed, array, number);
  values.attr("setflags")(py::arg("write") = false);
  return values;
}

/// Sets the field of all objects to values of its shape, or of one that NumPy broadcasts to it.
/// @throw a TypeError, ValueError or BufferError where they do not fit; the array is then unchanged
inline void write_field(const ObjectArray& array, std::size_t number, const py::object& values) {
  detail::require_stored(array, number);
  const std::string name = detail::full_name(array, number);
  const py::array given = detail::given_values(values, name);
  const py::object view = array.fields()[number].type == ElementType::half ? py::object()  // which checks no range
                                                                           : detail::direct_view(array, number);
  if (view) return detail::assign(view, given, name);
  const PackedField packed(array, number);
  detail::assign(detail::values_of(packed, array, number), given, name);
  try {
    packed.store();
  } catch (const Error& error) {
    throw py::value_error(error.what());
  }
}

/// The field as it lies in memory, without a copy in every layout: tiles, lanes of a tile, and the shape of the field.
/// Lanes behind the last object are padding.
/// @throw a TypeError where NumPy does not know the stored type
[[nodiscard]] inline py::object read_tiles(const ObjectArray& array, std::size_t number) {
  detail::require_stored(array, number);
  const FieldInfo& field = array.fields()[number];
  const py::object dtype = detail::stored_dtype(field);
  if (!dtype) {
    throw py::type_error(detail::full_name(array, number) +
                         " is stored in a format that NumPy does not know; read the field itself, which gives a "
                         "decoded copy, and assign to it");
  }
  const UntypedArray memory = array.untyped();
  const index_t pitch = std::max(memory.pitch, index_t{1});
  const int size = element_bytes(field.type);
  detail::Extents extents;
  extents.add((memory.size + pitch - 1) / pitch, law::tile_bytes(pitch, memory.record_bytes));
  extents.add(pitch, size);
  extents.add_elements(array.type().shapes[number], field.count, pitch * size);
  const std::byte* first = memory.size == 0 ? nullptr : memory.address(0, field.offset, size);
  return detail::array_over(dtype, std::move(extents), first, array.memory());
}

}  // namespace physgen::python
