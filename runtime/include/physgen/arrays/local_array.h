// Arrays of scenes that only the steps of one fused kernel use: they have a size and hold no memory, and their views
// are locals.
#pragma once

#include <physgen/fuse.h>

namespace physgen {

/// In the place of Array. Its view() is given to locals(...) and to the steps of a fused kernel, in which values are
/// rounded as in Array.
/// @tparam Tag tells the locals of one kernel apart
template <class Array, class Tag>
class LocalArray {
 public:
  using Object = typename Array::Object;
  using Formats = typename Array::Formats;
  using View = Local<Object, typename Array::Precision, Formats, Tag, typename Array::Layout>;
  using ConstView = View;
  using Record = Array;

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
