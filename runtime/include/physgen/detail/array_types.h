// The types of arrays that differ from another one in their formats or their layout alone.
#pragma once

#include <physgen/array.h>

namespace physgen::detail {

template <class Array, class Formats>
struct WithFormats;
template <class Object, class Real, class Space, class Layout, class Old, class Formats>
struct WithFormats<Array<Object, Real, Space, Layout, Old>, Formats> {
  using type = Array<Object, Real, Space, Layout, Formats>;
};
template <class Array, class Layout>
struct WithLayout;
template <class Object, class Real, class Space, class Old, class Formats, class Layout>
struct WithLayout<Array<Object, Real, Space, Old, Formats>, Layout> {
  using type = Array<Object, Real, Space, Layout, Formats>;
};

}  // namespace physgen::detail
