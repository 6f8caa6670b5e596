// The vectors and matrices that the library hands out. Eigen's expressions keep references to an Eigen::Matrix, but
// hold these by value.
#pragma once

#include <physgen/detail/value_expressions.h>

#include <type_traits>
#include <utility>

namespace physgen {

namespace detail {

/// What `value.F.col(0)` is where `value` has a name and is not const: a copy of the part to calculate with, through
/// which the part itself is assigned as long as it has no name of its own.
template <class Read, class Write>
class ValuePart : public Read {
 public:
  PHYSGEN_FUNCTION ValuePart(const Read& read, const Write& write) : Read(read), part_(write) {}
  ValuePart(const ValuePart&) = default;
  ~ValuePart() = default;

  PHYSGEN_FUNCTION void operator=(const ValuePart& other) && { part_ = other.part_; }
  template <class Other>
  PHYSGEN_FUNCTION void operator=(const Eigen::DenseBase<Other>& other) && {
    part_ = other.derived();
  }
  template <class Other>
  PHYSGEN_FUNCTION void operator+=(const Eigen::DenseBase<Other>& other) && {
    part_ += other.derived();
  }
  template <class Other>
  PHYSGEN_FUNCTION void operator-=(const Eigen::DenseBase<Other>& other) && {
    part_ -= other.derived();
  }
  PHYSGEN_FUNCTION void operator*=(const typename Read::Scalar& factor) && { part_ *= factor; }
  PHYSGEN_FUNCTION void operator/=(const typename Read::Scalar& divisor) && { part_ /= divisor; }
  PHYSGEN_FUNCTION void setConstant(const typename Read::Scalar& entry) && { part_.setConstant(entry); }
  PHYSGEN_FUNCTION void setZero() && { part_.setZero(); }
  PHYSGEN_FUNCTION void setOnes() && { part_.setOnes(); }
  PHYSGEN_FUNCTION void setIdentity() && { part_.setIdentity(); }
  PHYSGEN_FUNCTION void swap(ValuePart&& other) && { part_.swap(other.part_); }
  PHYSGEN_FUNCTION auto operator<<(const typename Read::Scalar& first) && { return part_ << first; }

 private:
  Write part_;
};

}  // namespace detail

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
  /// Entries in their order in memory: column by column. Of values with a name only, and range-for takes all.
  PHYSGEN_FUNCTION const S* data() const& { return entries_.data(); }
  PHYSGEN_FUNCTION S* data() & { return entries_.data(); }
  const S* data() const&& = delete;
  PHYSGEN_FUNCTION const S* begin() const& { return entries_.data(); }
  PHYSGEN_FUNCTION S* begin() & { return entries_.data(); }
  const S* begin() const&& = delete;
  PHYSGEN_FUNCTION const S* end() const& { return entries_.data() + entries_.size(); }
  PHYSGEN_FUNCTION S* end() & { return entries_.data() + entries_.size(); }
  const S* end() const&& = delete;

// A part: its value, and where this has a name, what assigns it. PHYSGEN_PART is undefined below.
#define PHYSGEN_PART(function, call)                                                \
  PHYSGEN_FUNCTION auto function const& { return detail::value_of(entries_.call); } \
  PHYSGEN_FUNCTION auto function& { return detail::ValuePart(std::as_const(*this).Base::call, entries_.call); }
#define PHYSGEN_PART_OF_SIZE(function, arguments, call)                                    \
  template <int... kSizes>                                                                 \
  PHYSGEN_FUNCTION auto function arguments const& {                                        \
    return detail::value_of(entries_.template function<kSizes...> call);                   \
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
