// The vectors and matrices that the library hands out. Eigen's expressions keep references to an Eigen::Matrix, but
// hold these by value.
#pragma once

#include <physgen/detail/value_expressions.h>

#include <type_traits>
#include <utility>

namespace physgen {

/// An R x C matrix by value: what get() of a field returns, the members of the structs that view.get(i) returns, and
/// what select(), cast(), rows.sum() and reductions return. It calculates as an Eigen::Matrix does and converts to one.
/// Where it has a name, its entries, parts and itself are assigned. All expressions of it are right under `auto`, also
/// where a function returns them; what could refer to a value that is gone does not compile.
template <class S, int R, int C>
class MatrixValue : public detail::ValueExpression<MatrixValue<S, R, C>> {
  using Base = detail::ValueExpression<MatrixValue>;
  using Index = Eigen::Index;
  using Entry = std::conditional_t<std::is_class_v<S>, const S, S>;  // of temporaries: nothing is assigned to it

 public:
  using Plain = Eigen::Matrix<S, R, C>;
  using Nested = const MatrixValue;
  using NestedExpression = MatrixValue;
  using iterator = S*;
  using const_iterator = const S*;

  MatrixValue() = default;  ///< undefined entries, as those of an Eigen::Matrix
  MatrixValue(const MatrixValue&) = default;
  ~MatrixValue() = default;
  PHYSGEN_FUNCTION MatrixValue(const Plain& entries) : entries_(entries) {}  // NOLINT: the same number
  template <class Other>
  PHYSGEN_FUNCTION MatrixValue(const Eigen::EigenBase<Other>& other)  // NOLINT: as Eigen's own
      : entries_(other.derived()) {}
  PHYSGEN_FUNCTION MatrixValue(const S& x, const S& y) : entries_(x, y) {}
  PHYSGEN_FUNCTION MatrixValue(const S& x, const S& y, const S& z) : entries_(x, y, z) {}
  PHYSGEN_FUNCTION MatrixValue(const S& x, const S& y, const S& z, const S& w) : entries_(x, y, z, w) {}

  PHYSGEN_FUNCTION MatrixValue& operator=(const MatrixValue& other) & {
    entries_ = other.entries_;
    return *this;
  }
  template <class Other>
  PHYSGEN_FUNCTION MatrixValue& operator=(const Eigen::EigenBase<Other>& other) & {
    entries_ = other.derived();
    return *this;
  }
  template <class Other>
  PHYSGEN_FUNCTION MatrixValue& operator+=(const Eigen::MatrixBase<Other>& other) & {
    entries_ += other.derived();
    return *this;
  }
  template <class Other>
  PHYSGEN_FUNCTION MatrixValue& operator-=(const Eigen::MatrixBase<Other>& other) & {
    entries_ -= other.derived();
    return *this;
  }
  template <class Other>
  PHYSGEN_FUNCTION MatrixValue& operator*=(const Eigen::EigenBase<Other>& other) & {
    entries_ *= other.derived();
    return *this;
  }
  PHYSGEN_FUNCTION MatrixValue& operator*=(const S& factor) & {
    entries_ *= factor;
    return *this;
  }
  PHYSGEN_FUNCTION MatrixValue& operator/=(const S& divisor) & {
    entries_ /= divisor;
    return *this;
  }
  PHYSGEN_FUNCTION auto noalias() & { return entries_.noalias(); }
  PHYSGEN_FUNCTION void swap(MatrixValue& other) & { entries_.swap(other.entries_); }
  PHYSGEN_FUNCTION void transposeInPlace() & { entries_.transposeInPlace(); }
  PHYSGEN_FUNCTION S& coeffRef(Index r, Index c) & { return entries_.coeffRef(r, c); }
  PHYSGEN_FUNCTION S& coeffRef(Index k) & { return entries_.coeffRef(k); }
  /// Entries row by row, as Eigen takes them: `value.F << 1, 2, 3, 4;`
  PHYSGEN_FUNCTION auto operator<<(const S& first) & { return entries_ << first; }
  template <class First>
  PHYSGEN_FUNCTION auto operator<<(const Eigen::DenseBase<First>& first) & {
    return entries_ << first.derived();
  }

  /// The entries as an Eigen::Matrix, where it lives as long as this has a name.
  PHYSGEN_FUNCTION const Plain& plain() const& { return entries_; }
  PHYSGEN_FUNCTION Plain& plain() & { return entries_; }
  const Plain& plain() const&& = delete;

  PHYSGEN_FUNCTION Index rows() const { return entries_.rows(); }
  PHYSGEN_FUNCTION Index cols() const { return entries_.cols(); }

  PHYSGEN_FUNCTION const S& operator()(Index r, Index c) const& { return entries_(r, c); }
  PHYSGEN_FUNCTION S& operator()(Index r, Index c) & { return entries_(r, c); }
  PHYSGEN_FUNCTION Entry operator()(Index r, Index c) const&& { return entries_(r, c); }
  template <class Rows, class Cols>
    requires(!std::is_convertible_v<Rows, Index> || !std::is_convertible_v<Cols, Index>)
  PHYSGEN_FUNCTION auto operator()(const Rows& rows, const Cols& cols) const {
    return Base::operator()(rows, cols);
  }
  PHYSGEN_FUNCTION const S& operator()(Index k) const& { return entries_(k); }
  PHYSGEN_FUNCTION S& operator()(Index k) & { return entries_(k); }
  PHYSGEN_FUNCTION Entry operator()(Index k) const&& { return entries_(k); }
  PHYSGEN_FUNCTION const S& operator[](Index k) const& { return entries_[k]; }
  PHYSGEN_FUNCTION S& operator[](Index k) & { return entries_[k]; }
  PHYSGEN_FUNCTION Entry operator[](Index k) const&& { return entries_[k]; }
  PHYSGEN_FUNCTION const S& x() const& { return entries_.x(); }
  PHYSGEN_FUNCTION S& x() & { return entries_.x(); }
  PHYSGEN_FUNCTION Entry x() const&& { return entries_.x(); }
  PHYSGEN_FUNCTION const S& y() const& { return entries_.y(); }
  PHYSGEN_FUNCTION S& y() & { return entries_.y(); }
  PHYSGEN_FUNCTION Entry y() const&& { return entries_.y(); }
  PHYSGEN_FUNCTION const S& z() const& { return entries_.z(); }
  PHYSGEN_FUNCTION S& z() & { return entries_.z(); }
  PHYSGEN_FUNCTION Entry z() const&& { return entries_.z(); }
  PHYSGEN_FUNCTION const S& w() const& { return entries_.w(); }
  PHYSGEN_FUNCTION S& w() & { return entries_.w(); }
  PHYSGEN_FUNCTION Entry w() const&& { return entries_.w(); }
  /// Entries in their order in memory: column by column. Of values with a name only; range-for over a
  /// vector takes others, too.
  PHYSGEN_FUNCTION const S* data() const& { return entries_.data(); }
  PHYSGEN_FUNCTION S* data() & { return entries_.data(); }
  const S* data() const&& = delete;
  PHYSGEN_FUNCTION const S* begin() const&
    requires(R == 1 || C == 1)
  {
    return entries_.data();
  }
  PHYSGEN_FUNCTION S* begin() &
    requires(R == 1 || C == 1)
  {
    return entries_.data();
  }
  const S* begin() const&& = delete;
  PHYSGEN_FUNCTION const S* end() const&
    requires(R == 1 || C == 1)
  {
    return entries_.data() + entries_.size();
  }
  PHYSGEN_FUNCTION S* end() &
    requires(R == 1 || C == 1)
  {
    return entries_.data() + entries_.size();
  }
  const S* end() const&& = delete;

// A part: a block that holds this by value, and where this has a name, what assigns it, too. The macros are undefined
// below.
#define PHYSGEN_PART(function, call)                           \
  PHYSGEN_FUNCTION auto function const& { return Base::call; } \
  PHYSGEN_FUNCTION auto function& { return detail::ValuePart(std::as_const(*this).Base::call, entries_.call); }
#define PHYSGEN_PART_OF_SIZE(function, arguments, call)                                    \
  template <int... kSizes>                                                                 \
  PHYSGEN_FUNCTION auto function arguments const& {                                        \
    return Base::template function<kSizes...> call;                                        \
  }                                                                                        \
  template <int... kSizes>                                                                 \
  PHYSGEN_FUNCTION auto function arguments& {                                              \
    return detail::ValuePart(std::as_const(*this).Base::template function<kSizes...> call, \
                             entries_.template function<kSizes...> call);                  \
  }
  PHYSGEN_PART(row(Index r), row(r))
  PHYSGEN_PART(col(Index c), col(c))
  PHYSGEN_PART(diagonal(), diagonal())
  PHYSGEN_PART_OF_SIZE(block, (Index r, Index c), (r, c))
  PHYSGEN_PART_OF_SIZE(segment, (Index begin), (begin))
  PHYSGEN_PART_OF_SIZE(head, (), ())
  PHYSGEN_PART_OF_SIZE(tail, (), ())
#undef PHYSGEN_PART
#undef PHYSGEN_PART_OF_SIZE
  [[nodiscard]] PHYSGEN_FUNCTION auto block(Index r, Index c, Index rows, Index cols) const {
    return Base::block(r, c, rows, cols);
  }
  [[nodiscard]] PHYSGEN_FUNCTION auto segment(Index begin, Index size) const { return Base::segment(begin, size); }
  [[nodiscard]] PHYSGEN_FUNCTION auto head(Index size) const { return Base::head(size); }
  [[nodiscard]] PHYSGEN_FUNCTION auto tail(Index size) const { return Base::tail(size); }

 private:
  Plain entries_;
};

}  // namespace physgen
