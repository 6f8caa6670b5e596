// Lists in CUDA memory without their types, which the library scans and sorts.
#pragma once

#include <physgen/memory/space.h>

#include <algorithm>
#include <concepts>
#include <span>
#include <type_traits>

namespace physgen::detail {

/// Numbers that an index_t holds.
template <class Number>
concept Countable = std::integral<Number> && (sizeof(Number) < sizeof(index_t) || std::is_signed_v<Number>);

/// Integers of one type.
struct NumberList {
  std::byte* data;
  index_t size;
  int bytes;  ///< of one: 1, 2, 4 or 8
  bool is_signed;

  template <std::integral Number>
  explicit NumberList(std::span<Number> numbers)
      : data(reinterpret_cast<std::byte*>(numbers.data())),
        size(static_cast<index_t>(numbers.size())),
        bytes(sizeof(Number)),
        is_signed(std::is_signed_v<Number>) {}

  /// Number i; of an unsigned one of 64 bits, its bits.
  [[nodiscard]] PHYSGEN_FUNCTION index_t get(index_t i) const {
    switch (bytes) {
      case 1:
        return is_signed ? index_t{at<std::int8_t>(i)} : index_t{at<std::uint8_t>(i)};
      case 2:
        return is_signed ? index_t{at<std::int16_t>(i)} : index_t{at<std::uint16_t>(i)};
      case 4:
        return is_signed ? index_t{at<std::int32_t>(i)} : index_t{at<std::uint32_t>(i)};
      default:
        return at<std::int64_t>(i);
    }
  }
  /// @pre the number is one of the list's type
  PHYSGEN_FUNCTION void put(index_t i, index_t number) const {
    switch (bytes) {
      case 1:
        at<std::int8_t>(i) = static_cast<std::int8_t>(number);
        return;
      case 2:
        at<std::int16_t>(i) = static_cast<std::int16_t>(number);
        return;
      case 4:
        at<std::int32_t>(i) = static_cast<std::int32_t>(number);
        return;
      default:
        at<std::int64_t>(i) = number;
    }
  }
  /// The largest number of the list's type. @pre it is Countable
  [[nodiscard]] index_t most() const {
    return static_cast<index_t>(~std::uint64_t{0} >> (64 - 8 * bytes + (is_signed ? 1 : 0)));
  }
  /// The bit that makes numbers negative, or 0: bits without it ascend as the numbers do.
  [[nodiscard]] std::uint64_t sign() const { return is_signed ? std::uint64_t{1} << (8 * bytes - 1) : 0; }

 private:
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION Number& at(index_t i) const {
    return reinterpret_cast<Number*>(data)[i];
  }
};

/// Values of one type, as bytes.
struct ValueList {
  std::byte* data;
  int bytes;  ///< of one
  int word;   ///< as many bytes at once may be moved: 1, 2, 4, 8 or 16

  template <class Value>
  explicit ValueList(std::span<Value> values)
      : data(reinterpret_cast<std::byte*>(values.data())),
        bytes(sizeof(Value)),
        word(static_cast<int>(std::min(alignof(Value), std::size_t{16}))) {}
};

/// See exclusive_scan() and sort_by_key(). @pre all lists lie in CUDA memory
index_t scan(const NumberList& numbers, Stream stream);
void sort(const NumberList& keys, const ValueList& values, Stream stream);

}  // namespace physgen::detail
