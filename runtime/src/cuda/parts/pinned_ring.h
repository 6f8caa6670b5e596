// Pinned memory that transfers pass through, in a ring: one piece is worked on while others are on their way.
#pragma once

#include <physgen/config.h>
#include <physgen/memory/space.h>

#include <cstddef>

namespace physgen::cuda {

/// Three pieces of pinned memory. Making pinned memory takes longer than filling it, so pieces of up to 64 MiB are kept
/// for the next ring of the process; these are never given back.
class PinnedRing {
 public:
  /// @param bytes of each piece
  /// @throw Error when the memory cannot be had
  explicit PinnedRing(index_t bytes);
  ~PinnedRing();
  PinnedRing(const PinnedRing&) = delete;
  PinnedRing& operator=(const PinnedRing&) = delete;

  static constexpr int pieces = 3;
  /// Piece k % pieces.
  [[nodiscard]] std::byte* piece(index_t k) const;
  /// Notes that the work now in `stream` uses piece k; wait(k) returns when it is done.
  void used(index_t k, Stream stream);
  void wait(index_t k);

 private:
  struct Pieces;
  Pieces* pieces_ = nullptr;
  int exceptions_;  // in flight when this was made
};

}  // namespace physgen::cuda
