// The structs by which DLPack passes tensors between libraries, as its specification lays them out:
// https://dmlc.github.io/dlpack/latest/c_api.html, without versions.
#pragma once

#include <cstdint>

namespace physgen::python::dlpack {

/// Of a capsule that nobody has taken yet.
inline constexpr const char* unused = "dltensor";

enum DeviceKind : std::int32_t { host = 1, cuda = 2, cuda_host = 3 };
enum TypeCode : std::uint8_t { integer = 0, unsigned_integer = 1, floating = 2, bfloat = 4, boolean = 6 };

struct Device {
  DeviceKind kind;
  std::int32_t number;
};
struct Type {
  TypeCode code;
  std::uint8_t bits;
  std::uint16_t lanes;
};
struct Tensor {
  void* data;
  Device device;
  std::int32_t dimensions;
  Type type;
  std::int64_t* shape;
  std::int64_t* strides;  ///< in elements
  std::uint64_t byte_offset;
};
struct ManagedTensor {
  Tensor tensor;
  void* context;
  void (*deleter)(ManagedTensor* self);
};

}  // namespace physgen::python::dlpack
