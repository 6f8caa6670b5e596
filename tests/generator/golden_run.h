// Numbers every stored element of an object differently, writes and reads them through generated accessors and values.
// The expected elements are computed here, from the schema's rules alone, not with the runtime's shapes.
#pragma once

#include <gtest/gtest.h>
#include <physgen/runtime.h>
#include <physgen/simd/simd_access.h>

#include <array>
#include <type_traits>

namespace physgen::test {

/// Which stored element stands at (r, c) of a field's value: 1, 2, ... in storage order, negative if it is the negative
/// of that element, 0 if nothing is stored there and the value is 0.
struct Full {
  static constexpr int element(int r, int c, int rows) { return 1 + c * rows + r; }
};
struct Symmetric {
  static constexpr int element(int r, int c, int rows) {
    if (r < c) return element(c, r, rows);
    int before = 0;
    for (int k = 0; k < c; ++k) before += rows - k;
    return 1 + before + (r - c);
  }
};
struct Skew {
  static constexpr int element(int r, int c, int rows) {
    if (r == c) return 0;
    if (r < c) return -element(c, r, rows);
    int before = 0;
    for (int k = 0; k < c; ++k) before += rows - 1 - k;
    return 1 + before + (r - c - 1);
  }
};

/// The type of one lane, and lane l of a value: of a number itself, of a SIMD batch a lane.
template <class T>
struct LaneOf {
  using type = T;
  static constexpr int count = 1;
  static T get(const T& value, int) { return value; }
};
template <class T, class A>
struct LaneOf<xsimd::batch<T, A>> {
  using type = T;
  static constexpr int count = static_cast<int>(xsimd::batch<T, A>::size);
  static T get(const xsimd::batch<T, A>& value, int l) { return value.get(static_cast<std::size_t>(l)); }
};

enum class Action {
  write_accessors,  ///< assign through accessors
  fill_value,       ///< set the members of a value
  check             ///< accessors and the members of a value read as they should
};

/// Walks over the fields of one object, or of those under a pack. `first` is the first object's number, `stride` the
/// elements of one object: element k of object i is 1 + i * stride + k, exact in every element type.
template <Action action>
class Walk {
 public:
  Walk(index_t first, int stride) : first_(first), stride_(stride) {}

  /// A field of one element. `accessor` is T&, or a stand-in for a batch.
  template <class Accessor, class T>
  void one(Accessor&& accessor, T& member) {
    const T number = numbers<T>(1);
    if constexpr (action == Action::write_accessors) std::forward<Accessor>(accessor) = number;
    if constexpr (action == Action::fill_value) member = number;
    if constexpr (action == Action::check) {
      expect_equal(static_cast<T>(std::forward<Accessor>(accessor)), number);
      expect_equal(member, number);
    }
    next_ += 1;
  }

  /// A field of more elements with this structure; `stored` of them are stored. What depends on no accessor is apart,
  /// since accessors are of many types.
  template <class Structure, class Accessor, class Matrix>
  void many(Structure, const Accessor& accessor, Matrix& member, int stored) {
    const Matrix expected = matrix_of<Structure, Matrix>();
    if constexpr (action == Action::write_accessors) accessor = expected;
    if constexpr (action == Action::fill_value) member = expected;
    if constexpr (action == Action::check) {
      const auto rows = static_cast<int>(expected.rows());
      const Matrix read = Accessor(accessor);
      Matrix by_element = expected;
      for (int c = 0; c < expected.cols(); ++c) {
        for (int r = 0; r < rows; ++r) {
          if (Structure::element(r, c, rows) > 0 && (r >= c || stored == expected.size())) {
            by_element(r, c) = static_cast<typename Matrix::Scalar>(accessor(r, c));
          }
        }
      }
      expect_equal_elements(read, expected);
      expect_equal_elements(member, expected);
      expect_equal_elements(by_element, expected);
    }
    next_ += stored;
  }

  /// Elements seen so far.
  [[nodiscard]] int elements() const { return next_; }

 private:
  template <class T>
  [[nodiscard]] T numbers(int element) const {
    using Lane = typename LaneOf<T>::type;
    constexpr int count = LaneOf<T>::count;
    alignas(64) std::array<Lane, static_cast<std::size_t>(count)> lanes{};
    for (int l = 0; l < count; ++l) {
      if (element == 0) continue;
      const index_t number = 1 + (first_ + l) * stride_ + next_ + (element > 0 ? element : -element) - 1;
      lanes[static_cast<std::size_t>(l)] = static_cast<Lane>(element > 0 ? number : -number);
    }
    if constexpr (std::is_arithmetic_v<T>) {
      return lanes[0];
    } else {
      return T::load_aligned(lanes.data());
    }
  }
  template <class Structure, class Matrix>
  [[nodiscard]] Matrix matrix_of() const {
    Matrix numbered;
    for (int c = 0; c < numbered.cols(); ++c) {
      for (int r = 0; r < numbered.rows(); ++r) {
        numbered(r, c) = numbers<typename Matrix::Scalar>(Structure::element(r, c, static_cast<int>(numbered.rows())));
      }
    }
    return numbered;
  }
  template <class Matrix>
  static void expect_equal_elements(const Matrix& a, const Matrix& b) {
    for (int c = 0; c < a.cols(); ++c) {
      for (int r = 0; r < a.rows(); ++r) expect_equal(a(r, c), b(r, c));
    }
  }
  template <class T>
  static void expect_equal(const T& a, const T& b) {
    for (int l = 0; l < LaneOf<T>::count; ++l) EXPECT_EQ(LaneOf<T>::get(a, l), LaneOf<T>::get(b, l)) << "lane " << l;
  }

  index_t first_;
  int stride_;
  int next_ = 0;
};

}  // namespace physgen::test
