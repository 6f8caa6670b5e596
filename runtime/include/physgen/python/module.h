// The classes of a Python module, which `physgen generate --python` writes the source of:
//   PYBIND11_MODULE(stress, module) {
//     physgen::python::add_class<model::StressObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(module, "Stress", "...");
//   }
// A function of a program's own takes physgen::python::Objects<model::StressObject>& and calls view() of it.
#pragma once

#include <physgen/python/field_values.h>  // Python's headers come before those of the standard library
#include <physgen/python/parts.h>

#include <algorithm>

namespace physgen::python {

/// The objects of one type that Python holds.
/// @tparam Object a generated tag such as model::StressObject
template <class Object>
class Objects : public ObjectArray {
 public:
  explicit Objects(ObjectArray&& array) : ObjectArray(std::move(array)) {}
};

/// Defined by a program's own sources, SOURCES of physgen_python(): adds their functions to the module.
void add_functions(py::module_& module);

namespace detail {

/// @throw a ValueError naming what there is
[[nodiscard]] inline const LayoutRow& chosen_layout(const std::string& name) {
  if (const LayoutRow* row = find_layout(name)) return *row;
  throw py::value_error("there is no layout '" + name +
                        "'; there are aos, aos_padded, soa, aosoa and aosoa(W), where W is a power of two from 2 to "
                        "1024");
}
[[nodiscard]] inline bool chosen_precision(const std::string& name) {
  if (name == "float" || name == "double") return name == "double";
  throw py::value_error("there is no precision '" + name + "'; there are float and double");
}
[[nodiscard]] inline index_t chosen_count(const ObjectType& type, index_t count) {
  if (count >= 0) return count;
  throw py::value_error(std::string(type.name) + ": an array of " + std::to_string(count) +
                        " objects cannot exist; give 0 or more");
}

[[nodiscard]] inline SpaceKind chosen_space(const std::string& name) {
  if (name == "host" || name == "cuda") return name == "cuda" ? SpaceKind::cuda : SpaceKind::host;
  throw py::value_error("there is no space '" + name + "'; there are host and cuda");
}

[[nodiscard]] inline ObjectArray made(const ObjectType& type, index_t count, const std::string& layout,
                                      const std::string& precision, const std::string& space) {
  const SpaceKind in = chosen_space(space);
  return {type,
          chosen_count(type, count),
          {layout.empty() ? type.in(in).layout : &chosen_layout(layout), chosen_precision(precision), in}};
}

[[nodiscard]] inline ObjectArray converted(const ObjectArray& array, const std::string& layout,
                                           const std::string& precision, const std::string& space) {
  Storage storage = array.storage();
  if (!space.empty()) storage.space = chosen_space(space);
  if (!layout.empty()) storage.layout = &chosen_layout(layout);
  if (!precision.empty()) storage.in_double = chosen_precision(precision);
  ObjectArray result(array.type(), array.size(), storage);
  copy(result.untyped(), array.untyped());
  return result;
}

/// The functions by which Python reads and sets fields by name.
/// @param part_of gives the Part that `self` stands for
template <class Class, class PartOf>
void add_access(Class& python_class, const PartOf& part_of) {
  python_class.def("__getattr__", [part_of](const py::object& self, const std::string& name) {
    if (py::object found = part_of(self).find(name)) return found;
    throw py::attribute_error(part_of(self).unknown(name));
  });
  python_class.def("__setattr__", [part_of](const py::object& self, const std::string& name, const py::object& values) {
    if (part_of(self).set(name, values)) return;
    if (!py::hasattr(py::type::of(self), name.c_str())) throw py::attribute_error(part_of(self).unknown(name));
    throw py::attribute_error(part_of(self).text() + "." + name +
                              " cannot be set; set fields, and let copy() make an array that is stored otherwise");
  });
  python_class.def("__getitem__", [part_of](const py::object& self, const std::string& name) {
    if (py::object found = part_of(self).find(name)) return found;
    throw py::key_error(part_of(self).unknown(name));
  });
  python_class.def("__setitem__", [part_of](const py::object& self, const std::string& name, const py::object& values) {
    if (!part_of(self).set(name, values)) throw py::key_error(part_of(self).unknown(name));
  });
}

/// What all classes share, registered once in each module.
inline void add_base(py::module_& module) {
  if (py::hasattr(module, "ObjectArray")) return;
  py::class_<Part> part(module, "Part", py::module_local(), "The fields of a nested object, for all objects.");
  add_access(part, [](const py::object& self) { return self.cast<Part>(); });
  part.def("__getitem__", &Part::entry).def("__dir__", &Part::names).def("__repr__", [](const Part& self) {
    return "<" + self.text() + ">";
  });

  py::class_<DeviceField>(module, "DeviceField", py::module_local(), "A field in CUDA memory, a tensor of DLPack.")
      .def("__dlpack__", &DeviceField::capsule, py::arg("stream") = py::none())
      .def("__dlpack_device__", &DeviceField::device)
      .def_property_readonly("shape", &DeviceField::shape)
      .def("__repr__", &DeviceField::text);

  py::class_<ObjectArray> array(module, "ObjectArray", py::module_local(), "An array of objects.");
  add_access(array, [](const py::object& self) { return Part(self); });
  array.def("__len__", &ObjectArray::size);
  array.def("__repr__", [](const ObjectArray& self) { return "<" + self.description() + ">"; });
  array.def(
      "resize", [](ObjectArray& self, index_t count) { self.resize(chosen_count(self.type(), count)); },
      py::arg("count"),
      "Changes the number of objects; the first keep their values. While views exist, it raises a BufferError.");
  array.def(
      "tiles",
      [](const py::object& self, const std::string& name) {
        return seen_tiles(self.cast<const ObjectArray&>(), Part(self).number(name));
      },
      py::arg("field"),
      "The field as it lies in memory, without a copy in any layout: (tiles, lanes of a tile, ...). Lanes behind the "
      "last object are padding.");
  array.def_property_readonly("layout", [](const ObjectArray& self) { return self.storage().layout->name; });
  array.def_property_readonly("precision",
                              [](const ObjectArray& self) { return self.storage().in_double ? "double" : "float"; });
  array.def_property_readonly("space", [](const ObjectArray& self) { return name(self.storage().space); });
  array.def_property_readonly("nbytes", &ObjectArray::bytes, "Bytes of memory held, padding included.");
  array.def_property_readonly(
      "units",
      [](const ObjectArray& self) {
        py::dict units;
        for (const FieldInfo& field : self.fields()) units[py::str(std::string(field.name))] = field.unit;
        return units;
      },
      "The unit of each field by its name.");
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InUse& error) {
      PyErr_SetString(PyExc_BufferError, error.what());
    }
  });
}

/// Gives a class an attribute for each field, or part, that objects have at their top.
inline void add_attributes(const py::object& python_class, const ObjectType& type) {
  const py::object property = py::module_::import("builtins").attr("property");
  std::string last;
  for (std::size_t f = 0; f < type.host.with_float.fields.size(); ++f) {
    const FieldInfo& field = type.host.with_float.fields[f];
    const std::string name(field.name.substr(0, field.name.find_first_of(".[")));
    if (name == last) continue;
    last = name;
    const std::string unit = field.unit.empty() || name != field.name ? "" : "[" + std::string(field.unit) + "]";
    python_class.attr(name.c_str()) = property(
        py::cpp_function([name](const py::object& self) { return Part(self).find(name); }, py::is_method(python_class)),
        py::none(), py::none(), unit);
  }
}

}  // namespace detail

/// Adds the class of arrays of an object type to a module.
/// @tparam HostLayout, CudaLayout those of the schema
/// @param name of the class
/// @param doc what help() prints
template <class Object, class HostLayout, class CudaLayout>
void add_class(py::module_& module, const char* name, const char* doc) {
  detail::add_base(module);
  const ObjectType& type = object_type<Object, HostLayout, CudaLayout>();
  py::class_<Objects<Object>, ObjectArray> python_class(module, name, py::module_local(), doc);
  python_class.def(
      py::init(
          [&type](index_t count, const std::string& layout, const std::string& precision, const std::string& space) {
            return Objects<Object>(detail::made(type, count, layout, precision, space));
          }),
      py::arg("count"), py::arg("layout") = "", py::arg("precision") = "float", py::arg("space") = "host",
      "Objects with their initial values. Without a layout they have that of the schema for the space, host or cuda.");
  python_class.def(
      "copy",
      [](const ObjectArray& self, const std::string& layout, const std::string& precision, const std::string& space) {
        return Objects<Object>(detail::converted(self, layout, precision, space));
      },
      py::arg("layout") = "", py::arg("precision") = "", py::arg("space") = "",
      "The same objects in memory of their own, in another layout, precision or space where one is given.");
  detail::add_attributes(python_class, type);
}

}  // namespace physgen::python
