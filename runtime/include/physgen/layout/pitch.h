// The pitch of a layout: a constant of the type where it can be, a member where it depends on the object count.
#pragma once

#include <physgen/config.h>

namespace physgen {

/// Every array holds real, initialised memory for a multiple of this many objects, so that a SIMD pack may run over the
/// last object. At least as wide as any pack (16 floats).
inline constexpr index_t padding_objects = 32;

/// A pitch known at compile time.
template <index_t kPitch>
struct StaticPitch {
  PHYSGEN_FUNCTION constexpr explicit StaticPitch(index_t /*same*/) {}
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t value() { return kPitch; }
  /// Index of the tile of object i, and its place in the tile. Unsigned: a shift and a mask.
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t tile(index_t i) {
    return static_cast<index_t>(static_cast<std::uint64_t>(i) / kPitch);
  }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t lane(index_t i) {
    return static_cast<index_t>(static_cast<std::uint64_t>(i) % kPitch);
  }
};

/// A pitch that is a number of the running program.
struct AnyPitch {
  index_t pitch;
  [[nodiscard]] PHYSGEN_FUNCTION constexpr index_t value() const { return pitch; }
  [[nodiscard]] PHYSGEN_FUNCTION constexpr index_t tile(index_t i) const { return i / pitch; }
  [[nodiscard]] PHYSGEN_FUNCTION constexpr index_t lane(index_t i) const { return i % pitch; }
};

/// A pitch of the whole array: one tile.
struct WholePitch {
  PHYSGEN_FUNCTION constexpr explicit WholePitch(index_t pitch) : pitch_(pitch) {}
  [[nodiscard]] PHYSGEN_FUNCTION constexpr index_t value() const { return pitch_; }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t tile(index_t /*i*/) { return 0; }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t lane(index_t i) { return i; }

 private:
  index_t pitch_;
};

}  // namespace physgen
