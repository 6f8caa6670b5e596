// Arrays of NumPy over memory of objects, and the checks of what is assigned to one.
#pragma once

#include <physgen/python/dlpack.h>
#include <physgen/python/object_array.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace physgen::python {

namespace py = pybind11;

/// The type of NumPy for the numbers that memory holds; null: it has none.
[[nodiscard]] inline py::object plain_dtype(ElementType type) {
  switch (type) {
    case ElementType::float32:
      return py::dtype::of<float>();
    case ElementType::float64:
      return py::dtype::of<double>();
    case ElementType::int32:
      return py::dtype::of<std::int32_t>();
    case ElementType::int64:
      return py::dtype::of<std::int64_t>();
    case ElementType::uint64:
      return py::dtype::of<std::uint64_t>();
    case ElementType::boolean:
      return py::dtype::of<bool>();
    case ElementType::half:
      return py::dtype(23);  // NPY_HALF
    case ElementType::bfloat16:
    case ElementType::snorm16:
    case ElementType::none:
      break;
  }
  return {};
}

/// The type by which NumPy can show the stored numbers of a field; null: it knows none.
[[nodiscard]] inline py::object stored_dtype(const FieldInfo& field) {
  const bool plain = field.scale == 1 && field.centre == 0 && field.own == nullptr && !field.quaternion;
  return plain ? plain_dtype(field.type) : py::object();
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

/// What is assigned, as an array of NumPy. @throw a BufferError where it lies in other memory than the host's
[[nodiscard]] inline py::array given_values(const py::object& values, const std::string& name) {
  if (py::isinstance<py::array>(values)) return values;
  if (py::hasattr(values, "__dlpack_device__")) {
    const auto device = values.attr("__dlpack_device__")().cast<py::tuple>();
    const int kind = device[0].cast<int>();
    if (kind != dlpack::host && kind != dlpack::cuda_host) {
      throw py::buffer_error(name + ": the values lie on DLPack's device " + py::repr(device).cast<std::string>() +
                             "; they are taken from host memory, (1, 0), so copy them to the host first");
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
  const auto is_integer = [](const py::array& of) { return of.dtype().kind() == 'i' || of.dtype().kind() == 'u'; };
  const bool integers = is_integer(target) && is_integer(values);  // of which those that fit are taken
  if (!integers && !numpy.attr("can_cast")(values.dtype(), target.dtype(), "same_kind").cast<bool>()) {
    throw py::type_error(name + " holds numbers of type " + text(target.dtype()) + ", to which " +
                         text(values.dtype()) + " does not convert; convert the values by .astype() if that is meant");
  }
  py::object fitting;
  try {
    fitting = numpy.attr("broadcast_to")(values, target.attr("shape"));
  } catch (const py::error_already_set&) {
    throw py::value_error(name + " has the shape " + shape_text(target) + "; values of the shape " +
                          shape_text(values) + " do not fit; give that shape, or one that NumPy broadcasts to it");
  }
  if (integers && values.size() > 0) {
    const py::object limits = numpy.attr("iinfo")(target.dtype());
    const py::object low = values.attr("min")(), high = values.attr("max")();
    const auto number = [](const py::object& of) { return py::int_(of); };  // of Python's, which compare exactly
    if (number(low) < number(limits.attr("min")) || number(high) > number(limits.attr("max"))) {
      throw py::value_error(name + " holds whole numbers from " + text(limits.attr("min")) + " to " +
                            text(limits.attr("max")) + ", and the values go from " + text(low) + " to " + text(high));
    }
  }
  numpy.attr("copyto")(target, fitting, integers ? "unsafe" : "same_kind");
}

}  // namespace physgen::python
