// Arrays of the scene chain, with the fields that its program needs. Written by physgen from scenes/chain.h and the
// kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scenes/scene_arrays.h>

#include <m.physgen.h>

namespace scenes { struct chain; }

/// Forces from positions.
namespace scenes::chain_scene {

namespace tags::body {
struct x { static constexpr const char* name = "body.x"; };
struct svd { static constexpr const char* name = "body.svd"; struct U; };
struct f { static constexpr const char* name = "body.f"; };
struct extra { static constexpr const char* name = "body.extra"; struct a; struct b; };
}  // namespace tags::body

/// How m::Svd is stored in body.svd. Not stored:
/// - U: written by Svd(body.x, body.svd); nothing reads it
template <class Stored>
struct BodySvdFormats : Stored {
  using U = physgen::format::Pruned<chain, tags::body::svd, tags::body::svd::U>;
};

/// How m::Extra is stored in body.extra. Not stored:
/// - a, b: nothing uses it
template <class Stored>
struct BodyExtraFormats : Stored {
  using a = physgen::format::Pruned<chain, tags::body::extra, tags::body::extra::a>;
  using b = physgen::format::Pruned<chain, tags::body::extra, tags::body::extra::b>;
};

/// The body.
template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Body {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t tet = 0;
  };

  /// m::Position, per node: x
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::x, ::m::PositionArray<Real, Space>>> x;
  /// m::Svd, per tet: s; without U
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::body::svd, ::m::SvdArray<Real, Space>>, BodySvdFormats> svd;
  /// m::Force, per node: f
  physgen::StoredArray<Stored, tags::body::f, ::m::ForceArray<float, Space>> f;
  /// m::Extra, per tet: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::body::extra, ::m::ExtraArray<Real, Space>>,
      BodyExtraFormats> extra;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(x, counts.node);
    physgen::allocate(svd, counts.tet, {"s"});
    physgen::allocate(f, counts.node, {"f"});
    physgen::allocate(extra, counts.tet);
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return x.bytes() + svd.bytes() + f.bytes() + extra.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(x)>(counts.node) + physgen::bytes_of_array<decltype(svd)>(counts.tet) +
           physgen::bytes_of_array<decltype(f)>(counts.node) + physgen::bytes_of_array<decltype(extra)>(counts.tet);
  }
};

}  // namespace scenes::chain_scene
