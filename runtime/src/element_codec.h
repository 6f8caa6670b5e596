// Converts single elements between any two storage formats that are known at run time only, on host and device. Copies
// of whole arrays call it. A new stored type needs a case in decode() and encode(), and for speed, of 16 bits, a codec.
#pragma once

#include <physgen/fields/object_info.h>

#include <bit>
#include <cstring>

namespace physgen::detail {

/// The storage format of one field as data: an element is centre + scale * what memory holds, or what functions of a
/// program's own make of it.
struct FieldFormat {
  ElementType type = ElementType::float32;
  bool scaled = false;     ///< scale is not 1 or centre not 0
  bool has_codec = false;  ///< with_codec() knows it
  bool in_double = false;  ///< kernels compute with it in double
  double scale = 1;
  double centre = 0;
  const OwnCodec* own = nullptr;  ///< called on the host alone

  FieldFormat() = default;
  explicit FieldFormat(const FieldInfo& field)
      : type(field.type),
        scaled(field.scale != 1 || field.centre != 0),
        in_double(field.in_double || element_bytes(field.type) == 8),
        scale(field.scale),
        centre(field.centre),
        own(field.own) {
    has_codec =
        own == nullptr && ((type == ElementType::half && centre == 0) || (type == ElementType::bfloat16 && !scaled) ||
                           (type == ElementType::snorm16 && format::detail::snorm16_is_ordinary<float>(scale, centre)));
  }
  /// Whether memory holds the very numbers, of this type.
  [[nodiscard]] PHYSGEN_FUNCTION bool is_plain(ElementType of) const { return type == of && !scaled && own == nullptr; }
  /// Whether memory holds the same bits for the same value, whatever is computed with.
  [[nodiscard]] PHYSGEN_FUNCTION bool operator==(const FieldFormat& other) const {
    return type == other.type && scale == other.scale && centre == other.centre && own == other.own;
  }
};

// Codecs convert elements of 16 bits to and from S in loops over many elements. There is one for each stored type.
template <class S>
struct HalfCodec {
  S scale, inverse;
  PHYSGEN_FUNCTION explicit HalfCodec(const FieldFormat& stored)
      : scale(static_cast<S>(stored.scale)), inverse(static_cast<S>(1 / stored.scale)) {}
  [[nodiscard]] PHYSGEN_FUNCTION S decode(std::uint16_t bits) const {
    return static_cast<S>(format::detail::half_to_float(bits)) * scale;
  }
  [[nodiscard]] PHYSGEN_FUNCTION std::uint16_t encode(S value) const {
    return format::detail::float_to_half(format::detail::to_odd(value * inverse));
  }
};
template <class S>
struct Bfloat16Codec {
  PHYSGEN_FUNCTION explicit Bfloat16Codec(const FieldFormat& /*format*/) {}
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
  PHYSGEN_FUNCTION explicit Snorm16Codec(const FieldFormat& stored)
      : scale(static_cast<S>(stored.scale)), centre(static_cast<S>(stored.centre)) {}
  [[nodiscard]] PHYSGEN_FUNCTION S decode(std::uint16_t bits) const {
    return format::detail::snorm16_to_real<S>(std::bit_cast<std::int16_t>(bits), scale, centre);
  }
  [[nodiscard]] PHYSGEN_FUNCTION std::uint16_t encode(S value) const {
    return std::bit_cast<std::uint16_t>(format::detail::real_to_snorm16<S>(value, scale, centre));
  }
};

/// Calls visit(codec) with the codec of a format. @pre stored.has_codec
#ifdef __CUDACC__
#pragma nv_exec_check_disable
#endif
template <class S, class Visit>
PHYSGEN_FUNCTION inline void with_codec(const FieldFormat& stored, const Visit& visit) {
  switch (stored.type) {
    case ElementType::half:
      return visit(HalfCodec<S>(stored));
    case ElementType::bfloat16:
      return visit(Bfloat16Codec<S>(stored));
    case ElementType::snorm16:
      return visit(Snorm16Codec<S>(stored));
    case ElementType::float32:
    case ElementType::float64:
    case ElementType::int32:
    case ElementType::int64:
    case ElementType::uint64:
    case ElementType::boolean:
    case ElementType::none:
      break;
  }
}

/// The value of an element. @tparam S float or double. Integers are not converted to float. @pre an element is stored
template <class S>
[[nodiscard]] PHYSGEN_FUNCTION inline S decode(const std::byte* from, const FieldFormat& stored) {
#ifndef __CUDA_ARCH__
  if (stored.own != nullptr) return static_cast<S>(stored.own->decode(from));
#endif
  S value(0);
  switch (stored.type) {
    case ElementType::int32:
      return static_cast<S>(*reinterpret_cast<const std::int32_t*>(from));
    case ElementType::int64:
      return static_cast<S>(*reinterpret_cast<const std::int64_t*>(from));
    case ElementType::uint64:
      return static_cast<S>(*reinterpret_cast<const std::uint64_t*>(from));
    case ElementType::boolean:
      return static_cast<S>(*from != std::byte{0} ? 1 : 0);
    case ElementType::snorm16: {
      const auto steps = *reinterpret_cast<const std::int16_t*>(from);
      if (format::detail::snorm16_is_ordinary<S>(stored.scale, stored.centre))
        return format::detail::snorm16_to_real<S>(steps, static_cast<S>(stored.scale), static_cast<S>(stored.centre));
      return format::detail::snorm16_to_real_exactly<S>(steps, stored.scale, stored.centre);
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
  if (!stored.scaled) return value;
  return format::detail::to_scale<S>(value, static_cast<S>(stored.scale), static_cast<S>(stored.centre));
}

/// Stores a value. @pre an element is stored
template <class S>
PHYSGEN_FUNCTION inline void encode(std::byte* to, const FieldFormat& stored, S value) {
#ifndef __CUDA_ARCH__
  if (stored.own != nullptr) return stored.own->encode(to, static_cast<double>(value));
#endif
  if (stored.type == ElementType::int32) {
    *reinterpret_cast<std::int32_t*>(to) = static_cast<std::int32_t>(value);
    return;
  }
  if (stored.type == ElementType::int64) {
    *reinterpret_cast<std::int64_t*>(to) = static_cast<std::int64_t>(value);
    return;
  }
  if (stored.type == ElementType::uint64) {
    *reinterpret_cast<std::uint64_t*>(to) = static_cast<std::uint64_t>(value);
    return;
  }
  if (stored.type == ElementType::boolean) {
    *to = value != S(0) ? std::byte{1} : std::byte{0};
    return;
  }
  if (stored.type == ElementType::snorm16) {
    *reinterpret_cast<std::int16_t*>(to) =
        format::detail::snorm16_is_ordinary<S>(stored.scale, stored.centre)
            ? format::detail::real_to_snorm16<S>(value, static_cast<S>(stored.scale), static_cast<S>(stored.centre))
            : format::detail::real_to_snorm16_exactly<S>(value, stored.scale, stored.centre);
    return;
  }
  if (stored.scaled) {
    value = format::detail::from_scale<S>(value, stored.scale, static_cast<S>(stored.centre),
                                          element_bytes(stored.type) > 2);
  }
  if (stored.type == ElementType::float32) {
    *reinterpret_cast<float*>(to) = static_cast<float>(value);
  } else if (stored.type == ElementType::float64) {
    *reinterpret_cast<double*>(to) = static_cast<double>(value);
  } else if (stored.type == ElementType::half) {
    *reinterpret_cast<std::uint16_t*>(to) = format::detail::float_to_half(format::detail::to_odd(value));
  } else {
    *reinterpret_cast<std::uint16_t*>(to) = format::detail::float_to_bfloat16(format::detail::to_odd(value));
  }
}

/// Copies kBytes bytes, aligned to as many, as one load and one store.
template <int kBytes>
PHYSGEN_FUNCTION inline void move_word(std::byte* to, const std::byte* from) {
  std::memcpy(__builtin_assume_aligned(to, kBytes), __builtin_assume_aligned(from, kBytes), kBytes);
}
/// Copies an element of 1, 2, 4 or 8 bytes.
PHYSGEN_FUNCTION inline void move_bits(std::byte* to, const std::byte* from, int bytes) {
  if (bytes == 8) return move_word<8>(to, from);
  if (bytes == 4) return move_word<4>(to, from);
  if (bytes == 2) return move_word<2>(to, from);
  move_word<1>(to, from);
}

/// Whether a conversion computes in double: where kernels do so with one of the two.
[[nodiscard]] PHYSGEN_FUNCTION inline bool converts_in_double(const FieldFormat& to, const FieldFormat& from) {
  return to.in_double || from.in_double;
}
/// Whether computing in float gives the bits of the stated precision: in double only where elements are no sums or
/// products, but numbers that float has. @pre neither has 8 bytes
[[nodiscard]] inline bool float_suffices(const FieldFormat& to, const FieldFormat& from) {
  const auto plain = [](const FieldFormat& stored) { return !stored.scaled && stored.type != ElementType::snorm16; };
  return !converts_in_double(to, from) || (plain(to) && plain(from));
}

/// Converts one element from one format to another; keeps the very bits where both are the same.
PHYSGEN_FUNCTION inline void convert_element(std::byte* to, const FieldFormat& to_format, const std::byte* from,
                                             const FieldFormat& from_format) {
  if (to_format == from_format) {
    move_bits(to, from, element_bytes(to_format.type));
  } else if (converts_in_double(to_format, from_format)) {
    encode(to, to_format, decode<double>(from, from_format));
  } else {
    encode(to, to_format, decode<float>(from, from_format));
  }
}

/// The matrix of a rotation, 9 elements by columns or 4 of a quaternion. @param at at(k) is the address of element k
template <class S, class At>
[[nodiscard]] PHYSGEN_FUNCTION inline Eigen::Matrix<S, 3, 3> decode_rotation(const FieldFormat& stored, bool quaternion,
                                                                             const At& at) {
  if (!quaternion) {
    Eigen::Matrix<S, 3, 3> R;
    PHYSGEN_UNROLL
    for (int k = 0; k < 9; ++k) R(k % 3, k / 3) = decode<S>(at(k), stored);
    return R;
  }
  const Quaternion<S> q{decode<S>(at(0), stored), decode<S>(at(1), stored), decode<S>(at(2), stored),
                        decode<S>(at(3), stored)};
  return element_bytes(stored.type) >= int{sizeof(S)} ? rotation_matrix<S>(q) : rotation_matrix_of_direction<S>(q);
}
template <class S, class At>
PHYSGEN_FUNCTION inline void encode_rotation(const FieldFormat& stored, bool quaternion, const At& at,
                                             const Eigen::Matrix<S, 3, 3>& R) {
  if (!quaternion) {
    PHYSGEN_UNROLL
    for (int k = 0; k < 9; ++k) encode<S>(at(k), stored, R(k % 3, k / 3));
    return;
  }
  const Quaternion<S> q = unit_quaternion<S>(R);
  PHYSGEN_UNROLL
  for (int k = 0; k < 4; ++k) encode<S>(at(k), stored, q[k]);
}

}  // namespace physgen::detail
