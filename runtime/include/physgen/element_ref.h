// A stand-in for one stored element, or for those of a SIMD pack, where no plain C++ reference exists: it converts
// to the value that code computes with and takes one by assignment.
#pragma once

#include <physgen/config.h>

namespace physgen {

/// @tparam Format of the element (format.h)
/// @tparam T the type computed with
/// @tparam Cursor stands on the object(s)
template <class Format, class T, class Cursor>
class ElementRef {
 public:
  using Value = typename Cursor::template Lanes<T>;

  /// @param offset of the first element of its run in the record [bytes]
  /// @param k which element of the run
  PHYSGEN_FUNCTION ElementRef(const Cursor& at, int offset, int k) : at_(at), offset_(offset), k_(k) {}
  ElementRef(const ElementRef&) = default;
  ~ElementRef() = default;

  [[nodiscard]] PHYSGEN_FUNCTION Value get() const { return at_.template load<Format, T>(offset_, k_); }
  PHYSGEN_FUNCTION operator Value() const { return get(); }  // NOLINT: implicit as a reference's conversion is

  PHYSGEN_FUNCTION const ElementRef& operator=(const Value& value) const {
    at_.template store<Format, T>(offset_, k_, value);
    return *this;
  }
  PHYSGEN_FUNCTION const ElementRef& operator=(const ElementRef& other) const { return *this = other.get(); }
  PHYSGEN_FUNCTION const ElementRef& operator+=(const Value& value) const { return *this = Value(get() + value); }
  PHYSGEN_FUNCTION const ElementRef& operator-=(const Value& value) const { return *this = Value(get() - value); }
  PHYSGEN_FUNCTION const ElementRef& operator*=(const Value& value) const { return *this = Value(get() * value); }
  PHYSGEN_FUNCTION const ElementRef& operator/=(const Value& value) const { return *this = Value(get() / value); }

 private:
  Cursor at_;
  int offset_;
  int k_;
};

}  // namespace physgen
