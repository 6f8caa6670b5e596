// Views of expressions in which values stand (matrix_value.h): columns and rows, diagonal and triangular matrices. Of
// Eigen's own, functions return an Eigen::Matrix by value, to which the next expression would keep a reference, or
// assign a copy.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/config.h>

#include <Eigen/Core>

namespace physgen {

template <class S, int R, int C>
class MatrixValue;

namespace detail {

template <class Xpr>
using ValueOf = MatrixValue<typename Xpr::Scalar, Xpr::RowsAtCompileTime, Xpr::ColsAtCompileTime>;

template <class Xpr>
[[nodiscard]] PHYSGEN_FUNCTION ValueOf<Xpr> value_of(const Xpr& expression) {
  return ValueOf<Xpr>(expression);
}

/// Returned by deleted functions: their names are what compilers print.
struct a_solution_refers_to_its_decomposition_so_name_that_as_in_Eigen_LDLT {};
struct an_array_that_is_evaluated_needs_a_type_such_as_Eigen_Array {};

/// The columns or rows of an expression in which values stand, to read: Eigen's own of a value would assign a copy.
template <class Derived, int kDirection>
class ValueVectors : public Eigen::VectorwiseOp<const Derived, kDirection> {
  using Base = Eigen::VectorwiseOp<const Derived, kDirection>;

 public:
  PHYSGEN_FUNCTION explicit ValueVectors(const Derived& of) : Base(of) {}
  template <class Other>
  [[nodiscard]] PHYSGEN_FUNCTION auto cross(const Eigen::MatrixBase<Other>& other) const {
    return value_of(Base::cross(other));
  }
};

/// A vector in which values stand as a diagonal matrix.
template <class Derived>
class ValueDiagonal : public Eigen::DiagonalWrapper<const Derived> {
  using Base = Eigen::DiagonalWrapper<const Derived>;

 public:
  PHYSGEN_FUNCTION explicit ValueDiagonal(const Derived& of) : Base(of) {}
  [[nodiscard]] PHYSGEN_FUNCTION auto toDenseMatrix() const { return value_of(Base::toDenseMatrix()); }
  [[nodiscard]] PHYSGEN_FUNCTION auto inverse() const { return this->diagonal().cwiseInverse().asDiagonal(); }
};

/// A triangle of an expression in which values stand, to read.
template <class Derived, unsigned kMode>
class ValueTriangle : public Eigen::TriangularView<const Derived, kMode> {
  using Base = Eigen::TriangularView<const Derived, kMode>;
  using Refused = a_solution_refers_to_its_decomposition_so_name_that_as_in_Eigen_LDLT;

 public:
  PHYSGEN_FUNCTION explicit ValueTriangle(const Derived& of) : Base(of) {}
  [[nodiscard]] PHYSGEN_FUNCTION auto toDenseMatrix() const { return value_of(Base::toDenseMatrix()); }
  template <class Other>
  [[nodiscard]] PHYSGEN_FUNCTION auto solve(const Eigen::MatrixBase<Other>& right) const {
    return value_of(typename Other::PlainObject(Base::solve(right)));
  }
  template <int kSide, class Other>
  [[nodiscard]] PHYSGEN_FUNCTION auto solve(const Eigen::MatrixBase<Other>& other) const {
    return value_of(typename Other::PlainObject(Base::template solve<kSide>(other)));
  }
  Refused transpose() const = delete;
  Refused adjoint() const = delete;
  Refused conjugate() const = delete;
};

/// A symmetric matrix of which a triangle is read, of an expression in which values stand.
template <class Derived, unsigned kMode>
class ValueSelfAdjoint : public Eigen::SelfAdjointView<const Derived, kMode> {
  using Base = Eigen::SelfAdjointView<const Derived, kMode>;
  using Refused = a_solution_refers_to_its_decomposition_so_name_that_as_in_Eigen_LDLT;

 public:
  PHYSGEN_FUNCTION explicit ValueSelfAdjoint(const Derived& of) : Base(of) {}
  [[nodiscard]] PHYSGEN_FUNCTION auto toDenseMatrix() const { return value_of(Base::toDenseMatrix()); }
  [[nodiscard]] auto eigenvalues() const { return value_of(Base::eigenvalues()); }
  Refused llt() const = delete;
  Refused ldlt() const = delete;
  Refused transpose() const = delete;
  Refused adjoint() const = delete;
  Refused conjugate() const = delete;
};

}  // namespace detail
}  // namespace physgen

#pragma pop_macro("I")
