// The template of object arrays by its name alone: array.h defines it, and scene.h declares arrays by it. It is one
// template, so that `using namespace physgen;` beside `using namespace physgen::scene;` finds one Array.
#pragma once

#include <physgen/memory/space.h>

#include <type_traits>

namespace physgen {

/// One of two types by space: the first on the host, pinned or not, the second on CUDA.
template <class Space, class ForHost, class ForCuda>
using PerSpace = std::conditional_t<Space::kind == SpaceKind::cuda, ForCuda, ForHost>;

/// The formats of an object type in a space, as the schema states them: pinned memory has those of the host.
template <class Object, class Space>
using FormatsOf = typename Object::template Formats<PerSpace<Space, Host, Cuda>>;

namespace detail {
/// What an array of a scene's declaration has in place of what it leaves open: space, layout and formats.
struct Declared {};
template <class Object, class Space>
struct FormatsIfKnown {
  using type = FormatsOf<Object, Space>;
};
template <class Object>
struct FormatsIfKnown<Object, Declared> {
  using type = Declared;
};
}  // namespace detail

template <class Object_, class Real, class Space_ = detail::Declared, class Layout_ = detail::Declared,
          class Formats_ = typename detail::FormatsIfKnown<Object_, Space_>::type>
class Array;

/// An array as a scene declares it: `Array<elasticity::TetObject, Real>`. It holds no objects; programs are given one
/// whose space and layout are known, such as elasticity::TetArray<float>.
/// @tparam Object_ a generated tag such as elasticity::TetObject
/// @tparam Real_ float or double
template <class Object_, class Real_>
class Array<Object_, Real_, detail::Declared, detail::Declared, detail::Declared> {
 public:
  using Object = Object_;
  using Real = Real_;
  /// The fields of its objects, which physgen reads.
  static constexpr auto fields = Object::template fields<Real, typename Object::template Formats<Host>>;
  static_assert(fields.size() > 0);
};

}  // namespace physgen
