// The functions of formats that are not the library's, as pointers: copies on the host convert by them.
#pragma once

#include <physgen/format.h>

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace physgen {

/// The functions of a format of a program's own, for what converts on the host.
struct OwnCodec {
  double (*decode)(const std::byte* from);
  void (*encode)(std::byte* to, double value);
};

namespace detail {

template <class Format, class T>
struct OwnFunctions {
  using Stored = typename Format::template Stored<T>;
  static_assert(std::is_trivially_copyable_v<Stored> &&
                    int{sizeof(Stored)} == element_bytes(Format::template type<T>) &&
                    !is_whole(Format::template type<T>),
                "sizeof(Stored) must equal the bytes of the format's ElementType, and that type must be numeric");

  static double decode(const std::byte* from) {
    Stored stored;
    std::memcpy(&stored, from, sizeof stored);
    return static_cast<double>(Format::template decode<T>(stored));
  }
  static void encode(std::byte* to, double value) {
    const Stored stored = Format::template encode<T>(static_cast<T>(value));
    std::memcpy(to, &stored, sizeof stored);
  }
  static constexpr OwnCodec codec{&decode, &encode};
};

/// The functions of Format where copies do not know it by its numbers, else null.
template <class Format, class T>
[[nodiscard]] constexpr const OwnCodec* own_codec() {
  if constexpr (format::FromLibrary<Format> || format::StoresNothing<Format> || format::is_probe<Format>) {
    return nullptr;
  } else {
    return &OwnFunctions<Format, T>::codec;
  }
}

}  // namespace detail

}  // namespace physgen
