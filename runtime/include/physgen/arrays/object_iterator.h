// Loops of the host over the objects of an array or view: `for (auto object : array)`.
#pragma once

#include <physgen/config.h>

#include <compare>
#include <cstddef>
#include <iterator>

namespace physgen {

/// Stands on an object of a view. What it gives is a reference to the object, by value, as view[i] is; so algorithms of
/// the standard library that read take it (std::find_if), and those that move objects (std::sort) do not compile: there
/// permute() of topology.h serves.
/// @tparam View what view() of an array returns; it stays valid as long as the view
template <class View>
class ObjectIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = typename View::template Value<index_t>;
  using difference_type = std::ptrdiff_t;
  using reference = decltype(View()[index_t{0}]);

  ObjectIterator() = default;
  ObjectIterator(const View& view, index_t i) : view_(view), i_(i) {}

  [[nodiscard]] reference operator*() const { return view_[i_]; }
  [[nodiscard]] reference operator[](difference_type n) const { return view_[i_ + n]; }
  /// The number of the object.
  [[nodiscard]] index_t index() const { return i_; }

  ObjectIterator& operator+=(difference_type n) {
    i_ += n;
    return *this;
  }
  ObjectIterator& operator-=(difference_type n) { return *this += -n; }
  ObjectIterator& operator++() { return *this += 1; }
  ObjectIterator& operator--() { return *this += -1; }
  ObjectIterator operator++(int) {
    const ObjectIterator before = *this;
    ++*this;
    return before;
  }
  ObjectIterator operator--(int) {
    const ObjectIterator before = *this;
    --*this;
    return before;
  }
  [[nodiscard]] friend ObjectIterator operator+(ObjectIterator it, difference_type n) { return it += n; }
  [[nodiscard]] friend ObjectIterator operator+(difference_type n, ObjectIterator it) { return it += n; }
  [[nodiscard]] friend ObjectIterator operator-(ObjectIterator it, difference_type n) { return it -= n; }
  [[nodiscard]] friend difference_type operator-(const ObjectIterator& a, const ObjectIterator& b) {
    return a.i_ - b.i_;
  }
  [[nodiscard]] friend bool operator==(const ObjectIterator& a, const ObjectIterator& b) { return a.i_ == b.i_; }
  [[nodiscard]] friend auto operator<=>(const ObjectIterator& a, const ObjectIterator& b) { return a.i_ <=> b.i_; }

 private:
  View view_;
  index_t i_ = 0;
};

}  // namespace physgen
