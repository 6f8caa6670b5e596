// Arrays of scenes that only the steps of one fused kernel use: they have a size and hold no memory, and their views
// are locals.
#pragma once

#include <physgen/fuse.h>

namespace physgen {

/// In the place of Array. Its view() is given to locals(...) and to the steps of a fused kernel, in which values are
/// rounded as in Array.
/// @tparam Tag tells the locals of one kernel apart
template <class Array, class Tag>
class LocalArray;
template <class Object_, class Real, class Space, class Layout, class Formats_, class Tag>
class LocalArray<Array<Object_, Real, Space, Layout, Formats_>, Tag> {
 public:
  using Object = Object_;
  using Formats = Formats_;
  using View = Local<Object, Real, Formats, Tag>;
  using ConstView = View;
  using Record = Array<Object, Real, Space, Layout, Formats>;

  LocalArray() = default;
  /// @throw Error when size is negative
  explicit LocalArray(index_t size) { resize(size); }

  [[nodiscard]] index_t size() const { return size_; }
  [[nodiscard]] static constexpr index_t bytes() { return 0; }
  /// The records that hold so many objects: none.
  [[nodiscard]] static constexpr index_t records(index_t /*objects*/) { return 0; }
  [[nodiscard]] View view() const { return {}; }
  [[nodiscard]] ConstView const_view() const { return {}; }

  void resize(index_t size) { size_ = detail::checked_size(Object::name, size); }

 private:
  index_t size_ = 0;
};

}  // namespace physgen
