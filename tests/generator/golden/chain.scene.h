// Arrays of the scene chain, with the fields that its program needs. Written by physgen from scenes/chain.h and the
// kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scene_arrays.h>

#include "scenes/chain.h"

/// Forces from positions.
namespace scenes::chain_scene {

namespace pruned::body {
struct svd {
  struct U;
};
}  // namespace pruned::body

/// How m::Svd is stored in body.svd. Not stored:
/// - U: written by Svd(body.x, body.svd); nothing reads it
template <class Space>
struct BodySvdFormats : physgen::FormatsOf<::m::SvdObject, Space> {
  using U = physgen::format::Pruned<chain, pruned::body::svd, pruned::body::svd::U>;
};

namespace pruned::body {
struct extra {
  struct a;
  struct b;
};
}  // namespace pruned::body

/// How m::Extra is stored in body.extra. Not stored:
/// - a, b: nothing uses it
template <class Space>
struct BodyExtraFormats : physgen::FormatsOf<::m::ExtraObject, Space> {
  using a = physgen::format::Pruned<chain, pruned::body::extra, pruned::body::extra::a>;
  using b = physgen::format::Pruned<chain, pruned::body::extra, pruned::body::extra::b>;
};

/// The body.
template <class Space_ = physgen::Host>
struct Body {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t tet = 0;
  };

  /// m::Position, per node: x
  physgen::ReadOnlyArray<::m::PositionArray<float, Space>> x;
  /// m::Svd, per tet: s; without U
  physgen::WithFormats<::m::SvdArray<float, Space>, BodySvdFormats<Space>> svd;
  /// m::Force, per node: f
  ::m::ForceArray<float, Space> f;
  /// m::Extra, per tet: left out, takes stores
  physgen::WithFormats<::m::ExtraArray<float, Space>, BodyExtraFormats<Space>> extra;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(x, counts.node);
    physgen::allocate(svd, counts.tet, {"s"});
    physgen::allocate(f, counts.node, {"f"});
    physgen::allocate(extra, counts.tet);
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const { return physgen::bytes_of(x, svd, f, extra); }
};

}  // namespace scenes::chain_scene
