// Cuts a range of objects for transfers into chunks of a few MiB that begin and end with whole tiles.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/layout/pitch.h>

#include <algorithm>

namespace physgen::detail {

inline constexpr index_t longest_tile = 1024;  ///< of an Aosoa [objects]

/// Objects of one tile of the array, or of one that an array of the same layout may have: a range that begins at a
/// multiple of it begins with a tile. One tile that is no longer than an Aosoa's may be is a tile as well: views of a
/// part then have the pitch that their type says.
[[nodiscard]] inline index_t tile_objects(const UntypedArray& array) {
  return array.pitch <= longest_tile ? std::max(array.pitch, padding_objects) : padding_objects;
}

/// Objects that pass through a part at a time: about 8 MiB, whole tiles.
[[nodiscard]] inline index_t chunk_objects(const UntypedArray& array) {
  constexpr index_t bytes = 8 << 20;
  return align_up(bytes / std::max(array.record_bytes, 1) + 1, tile_objects(array));
}

/// The chunks of a range of objects. The objects before the first whole tile are a chunk of their own, so that all
/// others begin with a tile and move at once.
struct Chunks {
  index_t begin, end;
  index_t tile;     ///< objects of a tile
  index_t objects;  ///< of a whole chunk; no chunk has more

  /// @param times larger than usual
  Chunks(const UntypedArray& array, index_t begin_, index_t end_, index_t times = 1)
      : begin(begin_),
        end(end_),
        tile(tile_objects(array)),
        objects(std::min(chunk_objects(array) * times, align_up(std::max(end_ - begin_, index_t{1}), tile))),
        whole_(begin_ % tile == 0 ? begin_ : std::min(end_, align_up(begin_, tile))) {}
  [[nodiscard]] index_t count() const { return before() + (end - whole_ + objects - 1) / objects; }
  [[nodiscard]] index_t first(index_t k) const { return k < before() ? begin : whole_ + (k - before()) * objects; }
  [[nodiscard]] index_t last(index_t k) const {
    return k < before() ? whole_ : std::min(end, whole_ + (k - before() + 1) * objects);
  }
  /// The number of the object that lies at the beginning of a part for chunk k, in step with the array: its objects
  /// have the same places in their tiles.
  [[nodiscard]] index_t aligned(index_t k) const { return first(k) / tile * tile; }

 private:
  [[nodiscard]] index_t before() const { return begin < whole_ ? 1 : 0; }

  index_t whole_;  // the first object that begins a tile, or end
};

}  // namespace physgen::detail
