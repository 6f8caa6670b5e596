// Layouts and storage formats that a compiler must refuse, with words that say what is wrong. refused.py compares them
// with what it reports.
#include <elasticity.physgen.h>

using namespace physgen;

namespace {

/// An array of positions with one format for all of them.
template <class Format>
struct Positions : elasticity::NodePositionFormats<Host> {
  using x = Format;
};
template <class Format>
using PositionArray = Array<elasticity::NodePositionObject, float, Host, Soa, Positions<Format>>;

/// A format that says what it stores twice, and not the same.
struct OfAnotherSize : format::Float32 {
  template <class Real>
  static constexpr ElementType type = ElementType::half;
};

struct IndicesInHalf : elasticity::TetFormats<Host> {
  using nodes = format::Half<>;
};

struct scene;
struct array;
struct field;

}  // namespace

/// refused a_tile_of_three: the tile of an Aosoa is a power of two from 2 to 1024
const int a_tile_of_three = Aosoa<3>::tile;
/// refused a_tile_of_2048: the tile of an Aosoa is a power of two from 2 to 1024
const int a_tile_of_2048 = Aosoa<2048>::tile;
/// refused a_vector_stored_as_a_quaternion: only a Rotation can be stored as a quaternion
PositionArray<format::Quaternion16> a_vector_stored_as_a_quaternion(3);
/// refused a_stored_type_of_another_size: sizeof(Stored) must equal the bytes of the format's ElementType
PositionArray<OfAnotherSize> a_stored_type_of_another_size(3);
/// refused indices_in_half: a field of integers is stored as it is
elasticity::TetArray<float, Host, Soa, IndicesInHalf> indices_in_half(1);
/// refused a_half_of_too_large_a_scale: a half is scaled by 2^-100 to 2^100
const double a_half_of_too_large_a_scale = format::Half<101>::scale;
/// refused a_half_of_too_small_a_scale: a half is scaled by 2^-100 to 2^100
const double a_half_of_too_small_a_scale = format::Half<-101>::scale;
/// refused a_range_upside_down: Snorm16: range.low must be less than range.high
const double a_range_upside_down = format::Snorm16<format::Interval{1.0, -1.0}>::scale;
/// refused a_scaled_half_that_is_scaled: Scaled takes Native, Float32, Float64, Half<> or Bfloat16
const double a_scaled_half_that_is_scaled = format::Scaled<format::Half<3>, format::Affine{.scale = 10}>::scale;
/// refused nothing_that_is_scaled: Scaled takes Native, Float32, Float64, Half<> or Bfloat16
const double nothing_that_is_scaled = format::Scaled<format::Nothing, format::Affine{.scale = 10}>::scale;
/// refused too_large_a_scale: numbers are scaled by 2^-100 to 2^100
const double too_large_a_scale = format::Scaled<format::Float32, format::Affine{.scale = 0x1p101}>::scale;
/// refused too_small_a_scale: numbers are scaled by 2^-100 to 2^100
const double too_small_a_scale = format::Scaled<format::Float32, format::Affine{.scale = 0x1p-101}>::scale;
/// refused too_large_a_centre: the centre is a number that float has
const double too_large_a_centre = format::Scaled<format::Float32, format::Affine{.centre = 0x1p127}>::scale;
/// refused a_quaternion_of_nothing: a rotation is pruned as a whole
const format::Quaternion<format::Pruned<scene, array, field>> a_quaternion_of_nothing;

// ---- What is not refused ----
PositionArray<format::Scaled<format::Half<>, format::Affine{.scale = 10}>> accepted(3);
const int accepted_tile = Aosoa<1024>::tile;
