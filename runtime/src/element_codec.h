// Single elements between any two storage formats that are known at run time only, on host and device: what copies of
// whole arrays are made of. A new stored type is a case in decode() and encode(), and for speed, of 16 bits, a codec.
#pragma once

#include <physgen/object_info.h>

#include <bit>

namespace physgen::detail {

/// How the elements of one field are stored: centre + scale * what memory holds, or as functions of a program's own
/// say.
struct Encoding {
  ElementType type = ElementType::float32;
  bool scaled = false;     ///< scale is not 1 or centre not 0
  bool has_codec = false;  ///< with_codec() knows it
  double scale = 1;
  double centre = 0;
  const OwnCodec* own = nullptr;  ///< called on the host alone

  Encoding() = default;
  explicit Encoding(const FieldInfo& field)
      : type(field.type),
        scaled(field.scale != 1 || field.centre != 0),
        scale(field.scale),
        centre(field.centre),
        own(field.own) {
    has_codec =
        own == nullptr && ((type == ElementType::half && centre == 0) || (type == ElementType::bfloat16 && !scaled) ||
                           (type == ElementType::snorm16 && format::detail::snorm16_is_ordinary<float>(scale, centre)));
  }
  /// Whether memory holds the very numbers, of this type.
  [[nodiscard]] PHYSGEN_FUNCTION bool is_plain(ElementType of) const { return type == of && !scaled && own == nullptr; }
  bool operator==(const Encoding&) const = default;
};
[[nodiscard]] inline Encoding encoding_of(const FieldInfo& field) { return Encoding(field); }

/// What 16 bits stand for, computed in S, for loops over many elements: one struct for each kind of encoding.
template <class S>
struct HalfCodec {
  S scale, inverse;
  PHYSGEN_FUNCTION explicit HalfCodec(const Encoding& encoding)
      : scale(static_cast<S>(encoding.scale)), inverse(static_cast<S>(1 / encoding.scale)) {}
  [[nodiscard]] PHYSGEN_FUNCTION S decode(std::uint16_t bits) const {
    return static_cast<S>(format::detail::half_to_float(bits)) * scale;
  }
  [[nodiscard]] PHYSGEN_FUNCTION std::uint16_t encode(S value) const {
    return format::detail::float_to_half(format::detail::to_odd(value * inverse));
  }
};
template <class S>
struct Bfloat16Codec {
  PHYSGEN_FUNCTION explicit Bfloat16Codec(const Encoding& /*encoding*/) {}
  [[nodiscard]] PHYSGEN_FUNCTION S decode(std::uint16_t bits) const {
    return static_cast<S>(format::detail::bfloat16_to_float(bits));
  }
  [[nodiscard]] PHYSGEN_FUNCTION std::uint16_t encode(S value) const {
    return format::detail::float_to_bfloat16(format::detail::to_odd(value));
  }
};
template <class S>
struct Snorm16Codec {
  S scale, centre;
  PHYSGEN_FUNCTION explicit Snorm16Codec(const Encoding& encoding)
      : scale(static_cast<S>(encoding.scale)), centre(static_cast<S>(encoding.centre)) {}
  [[nodiscard]] PHYSGEN_FUNCTION S decode(std::uint16_t bits) const {
    return format::detail::snorm16_to_real<S>(std::bit_cast<std::int16_t>(bits), scale, centre);
  }
  [[nodiscard]] PHYSGEN_FUNCTION std::uint16_t encode(S value) const {
    return std::bit_cast<std::uint16_t>(format::detail::real_to_snorm16<S>(value, scale, centre));
  }
};

/// Calls visit(codec) with the codec of an encoding. @pre encoding.has_codec
#ifdef __CUDACC__
#pragma nv_exec_check_disable
#endif
template <class S, class Visit>
PHYSGEN_FUNCTION inline void with_codec(const Encoding& encoding, const Visit& visit) {
  switch (encoding.type) {
    case ElementType::half:
      return visit(HalfCodec<S>(encoding));
    case ElementType::bfloat16:
      return visit(Bfloat16Codec<S>(encoding));
    case ElementType::snorm16:
      return visit(Snorm16Codec<S>(encoding));
    case ElementType::float32:
    case ElementType::float64:
    case ElementType::int32:
    case ElementType::none:
      break;
  }
}

/// The value of an element. @tparam S float or double. Integers are not converted to float. @pre an element is stored
template <class S>
[[nodiscard]] PHYSGEN_FUNCTION inline S decode(const std::byte* from, const Encoding& encoding) {
#ifndef __CUDA_ARCH__
  if (encoding.own != nullptr) return static_cast<S>(encoding.own->decode(from));
#endif
  S value(0);
  switch (encoding.type) {
    case ElementType::int32:
      return static_cast<S>(*reinterpret_cast<const std::int32_t*>(from));
    case ElementType::snorm16: {
      const auto steps = *reinterpret_cast<const std::int16_t*>(from);
      if (format::detail::snorm16_is_ordinary<S>(encoding.scale, encoding.centre))
        return format::detail::snorm16_to_real<S>(steps, static_cast<S>(encoding.scale),
                                                  static_cast<S>(encoding.centre));
      return format::detail::snorm16_to_real_exactly<S>(steps, encoding.scale, encoding.centre);
    }
    case ElementType::float32:
      value = static_cast<S>(*reinterpret_cast<const float*>(from));
      break;
    case ElementType::float64:
      value = static_cast<S>(*reinterpret_cast<const double*>(from));
      break;
    case ElementType::half:
      value = static_cast<S>(format::detail::half_to_float(*reinterpret_cast<const std::uint16_t*>(from)));
      break;
    case ElementType::bfloat16:
      value = static_cast<S>(format::detail::bfloat16_to_float(*reinterpret_cast<const std::uint16_t*>(from)));
      break;
    case ElementType::none:
      break;
  }
  if (!encoding.scaled) return value;
  return format::detail::to_scale<S>(value, static_cast<S>(encoding.scale), static_cast<S>(encoding.centre));
}

/// Stores a value. @pre an element is stored
template <class S>
PHYSGEN_FUNCTION inline void encode(std::byte* to, const Encoding& encoding, S value) {
#ifndef __CUDA_ARCH__
  if (encoding.own != nullptr) return encoding.own->encode(to, static_cast<double>(value));
#endif
  if (encoding.type == ElementType::int32) {
    *reinterpret_cast<std::int32_t*>(to) = static_cast<std::int32_t>(value);
    return;
  }
  if (encoding.type == ElementType::snorm16) {
    *reinterpret_cast<std::int16_t*>(to) =
        format::detail::snorm16_is_ordinary<S>(encoding.scale, encoding.centre)
            ? format::detail::real_to_snorm16<S>(value, static_cast<S>(encoding.scale), static_cast<S>(encoding.centre))
            : format::detail::real_to_snorm16_exactly<S>(value, encoding.scale, encoding.centre);
    return;
  }
  if (encoding.scaled) {
    value = format::detail::from_scale<S>(value, static_cast<S>(1 / encoding.scale), static_cast<S>(encoding.centre));
  }
  if (encoding.type == ElementType::float32) {
    *reinterpret_cast<float*>(to) = static_cast<float>(value);
  } else if (encoding.type == ElementType::float64) {
    *reinterpret_cast<double*>(to) = static_cast<double>(value);
  } else if (encoding.type == ElementType::half) {
    *reinterpret_cast<std::uint16_t*>(to) = format::detail::float_to_half(format::detail::to_odd(value));
  } else {
    *reinterpret_cast<std::uint16_t*>(to) = format::detail::float_to_bfloat16(format::detail::to_odd(value));
  }
}

/// One element from one format to another; the very bits where both are the same.
PHYSGEN_FUNCTION inline void convert_element(std::byte* to, const Encoding& to_encoding, const std::byte* from,
                                             const Encoding& from_encoding) {
  if (to_encoding == from_encoding) {
    const int size = element_bytes(to_encoding.type);
    if (size == 4) {
      *reinterpret_cast<std::uint32_t*>(to) = *reinterpret_cast<const std::uint32_t*>(from);
    } else if (size == 2) {
      *reinterpret_cast<std::uint16_t*>(to) = *reinterpret_cast<const std::uint16_t*>(from);
    } else {
      *reinterpret_cast<std::uint64_t*>(to) = *reinterpret_cast<const std::uint64_t*>(from);
    }
  } else if (element_bytes(to_encoding.type) < 8 && element_bytes(from_encoding.type) < 8) {
    encode(to, to_encoding, decode<float>(from, from_encoding));
  } else {
    encode(to, to_encoding, decode<double>(from, from_encoding));
  }
}

/// The matrix of a rotation, 9 elements by columns or 4 of a quaternion. @param at at(k) is the address of element k
template <class S, class At>
[[nodiscard]] PHYSGEN_FUNCTION inline Eigen::Matrix<S, 3, 3> decode_rotation(const Encoding& encoding, bool quaternion,
                                                                             const At& at) {
  if (!quaternion) {
    Eigen::Matrix<S, 3, 3> R;
    PHYSGEN_UNROLL
    for (int k = 0; k < 9; ++k) R(k % 3, k / 3) = decode<S>(at(k), encoding);
    return R;
  }
  const Quaternion<S> q{decode<S>(at(0), encoding), decode<S>(at(1), encoding), decode<S>(at(2), encoding),
                        decode<S>(at(3), encoding)};
  return element_bytes(encoding.type) >= int{sizeof(S)} ? rotation_matrix<S>(q) : rotation_matrix_of_direction<S>(q);
}
template <class S, class At>
PHYSGEN_FUNCTION inline void encode_rotation(const Encoding& encoding, bool quaternion, const At& at,
                                             const Eigen::Matrix<S, 3, 3>& R) {
  if (!quaternion) {
    PHYSGEN_UNROLL
    for (int k = 0; k < 9; ++k) encode<S>(at(k), encoding, R(k % 3, k / 3));
    return;
  }
  const Quaternion<S> q = unit_quaternion<S>(R);
  PHYSGEN_UNROLL
  for (int k = 0; k < 4; ++k) encode<S>(at(k), encoding, q[k]);
}

}  // namespace physgen::detail
