// Fields of arrays in CUDA memory: tensors that other libraries take by DLPack, without a copy.
#pragma once

#include <dlfcn.h>
#include <physgen/device.h>
#include <physgen/python/dlpack.h>
#include <physgen/python/field_values.h>

#include <optional>

namespace physgen::python {

/// A field in CUDA memory, which it keeps.
class DeviceField {
 public:
  /// @throw a TypeError where no DLPack type says what is stored
  DeviceField(const ObjectArray& array, std::size_t number, Placed placed)
      : name_(full_name(array, number)),
        type_(tensor_type(array.fields()[number])),
        placed_(std::move(placed)),
        memory_(array.memory()) {
    if (!type_) {
      throw py::type_error(name_ + " is stored in a format that DLPack does not know; copy(space=\"host\") decodes it");
    }
  }

  /// (2, number of the device that holds the memory)
  [[nodiscard]] py::tuple device() const { return py::make_tuple(static_cast<int>(dlpack::cuda), ordinal()); }
  [[nodiscard]] const std::vector<py::ssize_t>& extents() const { return placed_.extents.shape; }

  /// A capsule over the memory, after work in the default stream is done.
  [[nodiscard]] py::object capsule(const py::object& /*stream*/) const {
    synchronize();
    auto held = std::make_unique<Exported>();
    held->memory = memory_;
    for (const py::ssize_t count : placed_.extents.shape) held->shape.push_back(count);
    for (const py::ssize_t stride : placed_.extents.strides) held->strides.push_back(stride / (type_->bits / 8));
    dlpack::Tensor& tensor = held->managed.tensor;
    tensor.data = const_cast<std::byte*>(placed_.first);
    tensor.device = {dlpack::cuda, ordinal()};
    tensor.dimensions = static_cast<int>(held->shape.size());
    tensor.type = *type_;
    tensor.shape = held->shape.data();
    tensor.strides = held->strides.data();
    held->managed.context = held.get();
    held->managed.deleter = [](dlpack::ManagedTensor* managed) { delete static_cast<Exported*>(managed->context); };
    const py::capsule made(&held->managed, dlpack::unused, [](PyObject* capsule) {
      if (PyCapsule_IsValid(capsule, dlpack::unused) == 0) return;  // somebody took it, and deletes it
      auto* managed = static_cast<dlpack::ManagedTensor*>(PyCapsule_GetPointer(capsule, dlpack::unused));
      managed->deleter(managed);
    });
    (void)held.release();
    return made;
  }

  [[nodiscard]] std::string text() const {
    return "<" + name_ + " in cuda memory, " + py::repr(py::tuple(shape())).cast<std::string>() + ">";
  }
  [[nodiscard]] py::tuple shape() const {
    py::list list;
    for (const py::ssize_t count : placed_.extents.shape) list.append(count);
    return py::tuple(list);
  }

 private:
  struct Exported {
    dlpack::ManagedTensor managed;
    std::vector<std::int64_t> shape, strides;
    std::shared_ptr<Buffer> memory;
  };

  [[nodiscard]] static std::optional<dlpack::Type> tensor_type(const FieldInfo& field) {
    if (field.scale != 1 || field.centre != 0 || field.own != nullptr || field.quaternion) return {};
    switch (field.type) {
      case ElementType::float32:
        return dlpack::Type{dlpack::floating, 32, 1};
      case ElementType::float64:
        return dlpack::Type{dlpack::floating, 64, 1};
      case ElementType::int32:
        return dlpack::Type{dlpack::integer, 32, 1};
      case ElementType::int64:
        return dlpack::Type{dlpack::integer, 64, 1};
      case ElementType::uint64:
        return dlpack::Type{dlpack::unsigned_integer, 64, 1};
      case ElementType::boolean:
        return dlpack::Type{dlpack::boolean, 8, 1};
      case ElementType::half:
        return dlpack::Type{dlpack::floating, 16, 1};
      case ElementType::bfloat16:
        return dlpack::Type{dlpack::bfloat, 16, 1};
      case ElementType::snorm16:
      case ElementType::none:
        break;
    }
    return {};
  }
  // The driver knows on which device memory lies; it is loaded where there is such memory.
  [[nodiscard]] int ordinal() const {
    int device = 0;
    constexpr int attribute = 9;  // CU_POINTER_ATTRIBUTE_DEVICE_ORDINAL
    using Ask = int (*)(void* data, int attribute, unsigned long long pointer);
    void* driver = dlopen("libcuda.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (driver == nullptr) return device;
    const auto ask = reinterpret_cast<Ask>(dlsym(driver, "cuPointerGetAttribute"));
    if (ask != nullptr && placed_.first != nullptr)
      (void)ask(&device, attribute, reinterpret_cast<unsigned long long>(placed_.first));
    (void)dlclose(driver);
    return device;
  }

  std::string name_;
  std::optional<dlpack::Type> type_;
  Placed placed_;
  std::shared_ptr<Buffer> memory_;
};

/// The field as Python sees it, wherever the array lies.
/// @throw a TypeError where a field in CUDA memory cannot be a tensor
[[nodiscard]] inline py::object seen_field(const ObjectArray& array, std::size_t number) {
  if (host_accessible(array.storage().space)) return read_field(array, number);
  require_stored(array, number);
  if (array.storage().layout->tiled) {
    throw py::type_error(full_name(array, number) + " lies in tiles of CUDA memory, which are no tensor of " +
                         std::to_string(array.size()) +
                         " objects; take tiles() of it, or copy(layout=\"soa\"), or copy(space=\"host\")");
  }
  return py::cast(DeviceField(array, number, place_of(array, number)));
}
[[nodiscard]] inline py::object seen_tiles(const ObjectArray& array, std::size_t number) {
  if (host_accessible(array.storage().space)) return read_tiles(array, number);
  require_stored(array, number);
  return py::cast(DeviceField(array, number, place_of_tiles(array, number)));
}

}  // namespace physgen::python
