// The checks of the program everything.cpp on each row of the catalogue. Numbers of what is expected come from the
// catalogue, as arguments; values come back through generated accessors and through the runtime's copies.
#pragma once

#include <physgen/arrays/array.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

inline constexpr physgen::index_t objects = 100;

inline int failures = 0, checks = 0;

inline void expect(bool good, const char* what, const char* rule) {
  ++checks;
  if (good) return;
  if (++failures <= 20) std::printf("%s: %s\n", what, rule);
}

/// The exit status of main().
inline int report() {
  std::printf("%d checks, %d failures\n", checks, failures);
  return failures == 0 && checks > 1000 ? 0 : 1;
}

/// Some number from -1 to 1, another one for each n.
inline double some(physgen::index_t n) { return std::sin(1.7 * static_cast<double>(n) + 0.3); }

struct Entry {
  int row, column;
};

/// Stores matrices of different entries. What comes back has those that the shape stores, where the catalogue says that
/// they stand, and comes back unchanged when it is stored in turn; where nothing is stored, zeros give zeros.
template <class Real, class View, class Access>
void keeps_shape(const char* name, const View& view, const Access& access, const std::vector<Entry>& entries) {
  using Value = decltype(access(view, physgen::index_t{0}).get());
  using Matrix = std::remove_cv_t<Value>;
  for (physgen::index_t i = 0; i < objects; ++i) {
    Matrix given;
    for (int c = 0; c < given.cols(); ++c)
      for (int r = 0; r < given.rows(); ++r) given(r, c) = static_cast<Real>(some(100 * i + 10 * c + r));
    access(view, i) = given;
    const Matrix kept = access(view, i).get();
    for (std::size_t k = 0; k < entries.size(); ++k) {
      const auto [r, c] = entries[k];
      expect(kept(r, c) == given(r, c), name, "an entry that is stored comes back as it was");
      expect(static_cast<Real>(access(view, i)[static_cast<int>(k)]) == given(r, c), name,
             "element k stands where the catalogue says");
      expect(static_cast<Real>(access(view, i)(r, c)) == given(r, c), name, "entries are read by row and column");
    }
    const physgen::index_t other = (i + 1) % objects;
    access(view, other) = kept;
    expect(access(view, other).get() == kept, name, "a value of the shape comes back as it was");
    access(view, other) = Matrix(Matrix::Zero());
    expect(access(view, other).get() == Matrix::Zero(), name, "zeros come back as zeros");
  }
}

template <class T, class View, class Access>
void keeps_element(const char* name, const View& view, const Access& access) {
  using Element = typename std::remove_cv_t<decltype(access(view, physgen::index_t{0}).get())>::Scalar;
  static_assert(std::is_same_v<Element, T>, "values have the element type that the catalogue names");
  const auto number = [](physgen::index_t i, int k) {
    const double of = 1000 * some(2 * i + k);
    if constexpr (std::is_same_v<T, bool>) return of > 0;
    if constexpr (std::is_integral_v<T> && sizeof(T) == 8)
      return static_cast<T>(static_cast<std::int64_t>(of * 0x1p50) | 1);
    return static_cast<T>(of);
  };
  for (physgen::index_t i = 0; i < objects; ++i)
    for (int k = 0; k < 2; ++k) access(view, i)[k] = number(i, k);
  for (physgen::index_t i = 0; i < objects; ++i)
    for (int k = 0; k < 2; ++k)
      expect(access(view, i).get()(k) == number(i, k), name, "numbers come back as they were");
}

/// Bound of an error: a factor of the value's size, and a difference.
struct Error {
  double relative, absolute;
};

/// Numbers from -2 to 6 come back to the error that comments state, which is not much more than the largest there is.
template <class Real, class Array, class Access>
void keeps_numbers(const char* name, Array& array, int element, const Access& access, Error error, int bytes) {
  const auto view = array.view();
  const double eps = std::numeric_limits<Real>::epsilon();
  const auto number = [](physgen::index_t i, int k) { return static_cast<Real>(2 + 4 * some(3 * i + k)); };
  for (physgen::index_t i = 0; i < objects; ++i)
    access(view, i) = Eigen::Matrix<Real, 3, 1>(number(i, 0), number(i, 1), number(i, 2));
  double largest = 0;  // error over its bound
  for (physgen::index_t i = 0; i < objects; ++i) {
    const Eigen::Matrix<Real, 3, 1> kept = access(view, i).get();
    for (int k = 0; k < 3; ++k) {
      const double value = number(i, k), found = kept(k);
      const double bound = error.relative * std::abs(value) + error.absolute;
      const bool as_computed = bytes == 0 || bytes >= int{sizeof(Real)};
      expect(std::abs(found - value) <= (as_computed && bytes != 2 ? 0 : bound + 8 * eps), name,
             "numbers come back to the error that the catalogue states");
      expect(std::abs(array.getdata(i, element + k) - found) <= 8 * eps, name, "copies read what accessors read");
      if (bound > 0) largest = std::max(largest, std::abs(found - value) / bound);
    }
  }
  if (bytes != 0 && bytes < int{sizeof(Real)}) expect(largest > 0.2, name, "no error near the one that is stated");
}

template <class Real, class View, class Access>
void keeps_rotations(const char* name, const View& view, const Access& access, double error) {
  for (physgen::index_t i = 0; i < objects; ++i) {
    const Real a = static_cast<Real>(3 * some(i)), b = static_cast<Real>(3 * some(i + 1000));
    Eigen::Matrix<Real, 3, 3> about_z, about_x;
    about_z << std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a), 0, 0, 0, 1;
    about_x << 1, 0, 0, 0, std::cos(b), -std::sin(b), 0, std::sin(b), std::cos(b);
    const Eigen::Matrix<Real, 3, 3> given = about_z * about_x;
    access(view, i) = given;
    const Eigen::Matrix<Real, 3, 3> kept = access(view, i).get();
    for (int k = 0; k < 9; ++k)
      expect(std::abs(static_cast<double>(kept(k % 3, k / 3) - given(k % 3, k / 3))) <= error, name,
             "rotations come back from quaternions to the error that the catalogue states");
  }
}

/// The law of addresses with the catalogue's pitch and record, and values that lie there.
template <class Real, class Array, class PitchOf>
void lies_as(const char* name, const PitchOf& pitch_of, int record_bytes, int one_offset, int n_offset) {
  for (const physgen::index_t count : {objects, physgen::index_t{512}}) {
    Array array(count);
    const auto view = array.view();
    const physgen::index_t pitch = pitch_of(count);
    expect(array.record_bytes == record_bytes, name, "records have the bytes that the catalogue says");
    const auto law = [&](int offset, physgen::index_t i, int size) {
      return view.data() + i / pitch * pitch * record_bytes + offset * pitch + i % pitch * size;
    };
    for (physgen::index_t i = 0; i < count; ++i) {
      const double value = some(i);
      view[i].one() = static_cast<Real>(value);
      view[i].x() = Eigen::Vector3d(value, 2 * value, 3 * value);
      view[i].h() = Real(0.5);
      view[i].n() = static_cast<std::int32_t>(i);
      expect(reinterpret_cast<const std::byte*>(&view[i].one()) == law(one_offset, i, int{sizeof(Real)}), name,
             "scalars stand at the addresses of the catalogue's pitch and record");
      expect(reinterpret_cast<const std::byte*>(&view[i].n()) == law(n_offset, i, 4), name,
             "integers stand at the addresses of the catalogue's pitch and record");
    }
    for (physgen::index_t i = 0; i < count; ++i) {
      const double value = some(i);
      expect(view[i].one() == static_cast<Real>(value) &&
                 view[i].x().get() == Eigen::Vector3d(value, 2 * value, 3 * value),
             name, "values come back as they were");
      expect(static_cast<Real>(view[i].h()) == Real(0.5) && view[i].n() == i, name,
             "small values come back as they were");
    }
  }
}
