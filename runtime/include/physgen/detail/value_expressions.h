// What Eigen has to know of MatrixValue (matrix_value.h): expressions hold it by value, and what they return by value
// is one, too, so that `auto` of any expression refers to nothing that is gone.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/config.h>
#include <physgen/detail/value_views.h>

#include <Eigen/Core>

namespace physgen {

namespace detail {

/// Whether T is an expression of Eigen in which a MatrixValue stands.
template <class T>
inline constexpr bool of_values = false;
template <class T>
inline constexpr bool of_values<const T> = of_values<T>;
template <class S, int R, int C>
inline constexpr bool of_values<MatrixValue<S, R, C>> = true;
template <template <class...> class Expression, class... A>
inline constexpr bool of_values<Expression<A...>> = (of_values<A> || ...);
template <template <class, int, int...> class Expression, class A, int k, int... kMore>
inline constexpr bool of_values<Expression<A, k, kMore...>> = of_values<A>;
template <template <class, unsigned> class View, class A, unsigned k>
inline constexpr bool of_values<View<A, k>> = of_values<A>;
template <template <class, class, int> class Expression, class A, class B, int k>
inline constexpr bool of_values<Expression<A, B, k>> = of_values<A> || of_values<B>;
template <class A, int kRows, int kCols, bool kInner>
inline constexpr bool of_values<Eigen::Block<A, kRows, kCols, kInner>> = of_values<A>;

/// Whether T refers to no vector or matrix that may be gone where a function has returned T: what is no expression of
/// Eigen, and expressions of values alone.
template <class T>
inline constexpr bool stands_alone = !requires { typename T::PlainObject; };
template <class T>
inline constexpr bool stands_alone<const T> = stands_alone<T>;
template <class S, int R, int C>
inline constexpr bool stands_alone<MatrixValue<S, R, C>> = true;
template <class Functor, class Plain>
inline constexpr bool stands_alone<Eigen::CwiseNullaryOp<Functor, Plain>> = true;
template <template <class...> class Expression, class... A>
inline constexpr bool stands_alone<Expression<A...>> = (stands_alone<A> && ...);
template <template <class, int> class Expression, class A, int k>
inline constexpr bool stands_alone<Expression<A, k>> = stands_alone<A>;
template <template <class, class, int> class Expression, class A, class B, int k>
inline constexpr bool stands_alone<Expression<A, B, k>> = stands_alone<A> && stands_alone<B>;
template <class A, int kRows, int kCols, bool kInner>
inline constexpr bool stands_alone<Eigen::Block<A, kRows, kCols, kInner>> = stands_alone<A>;

/// Whether a function that returns T returns all of it: no expression of what is gone with the function.
template <class T>
inline constexpr bool returned_whole = stands_alone<T>;
template <class S, int R, int C, int kOptions, int kMaxRows, int kMaxCols>
inline constexpr bool returned_whole<Eigen::Matrix<S, R, C, kOptions, kMaxRows, kMaxCols>> = true;

/// The base of arrays, as Eigen calls what is calculated with entry by entry, in which values stand.
template <class Derived>
class ValueArrayExpression : public Eigen::ArrayBase<Derived> {
 public:
  using Eigen::ArrayBase<Derived>::operator=;
  an_array_that_is_evaluated_needs_a_type_such_as_Eigen_Array eval() const = delete;
  [[nodiscard]] PHYSGEN_FUNCTION auto matrix() const { return value_of(Eigen::MatrixWrapper(this->derived())); }

 protected:
  ValueArrayExpression() = default;
  ValueArrayExpression(const ValueArrayExpression&) = default;
  ~ValueArrayExpression() = default;
};

/// The same of an expression that array() makes one of.
template <class Derived>
class ValueArray : public Eigen::ArrayWrapper<const Derived> {
 public:
  using Eigen::ArrayWrapper<const Derived>::ArrayWrapper;
  an_array_that_is_evaluated_needs_a_type_such_as_Eigen_Array eval() const = delete;
  [[nodiscard]] PHYSGEN_FUNCTION Derived matrix() const { return this->nestedExpression(); }
};

/// The base of expressions in which values stand. Eigen's own functions return an Eigen::Matrix by value here, to which
/// the next expression would keep a reference.
template <class Derived>
class ValueExpression : public Eigen::MatrixBase<Derived> {
  using Base = Eigen::MatrixBase<Derived>;
  using Refused = a_solution_refers_to_its_decomposition_so_name_that_as_in_Eigen_LDLT;

 public:
  using Base::operator=;

  [[nodiscard]] PHYSGEN_FUNCTION auto eval() const { return value_of(typename Base::PlainObject(this->derived())); }
  [[nodiscard]] PHYSGEN_FUNCTION auto normalized() const { return value_of(Base::normalized()); }
  [[nodiscard]] PHYSGEN_FUNCTION auto stableNormalized() const { return value_of(Base::stableNormalized()); }
  [[nodiscard]] PHYSGEN_FUNCTION auto unitOrthogonal() const { return value_of(Base::unitOrthogonal()); }
  template <class Other>
  [[nodiscard]] PHYSGEN_FUNCTION auto cross(const Eigen::MatrixBase<Other>& other) const {
    return value_of(Base::cross(other));
  }
  template <class Other>
  [[nodiscard]] PHYSGEN_FUNCTION auto cross3(const Eigen::MatrixBase<Other>& other) const {
    return value_of(Base::cross3(other));
  }
  [[nodiscard]] PHYSGEN_FUNCTION auto array() const { return ValueArray<Derived>(this->derived()); }
  [[nodiscard]] PHYSGEN_FUNCTION auto colwise() const {
    return ValueVectors<Derived, Eigen::Vertical>(this->derived());
  }
  [[nodiscard]] PHYSGEN_FUNCTION auto rowwise() const {
    return ValueVectors<Derived, Eigen::Horizontal>(this->derived());
  }
  [[nodiscard]] PHYSGEN_FUNCTION auto asDiagonal() const { return ValueDiagonal<Derived>(this->derived()); }
  template <unsigned kMode>
  [[nodiscard]] PHYSGEN_FUNCTION auto triangularView() const {
    return ValueTriangle<Derived, kMode>(this->derived());
  }
  template <unsigned kMode>
  [[nodiscard]] PHYSGEN_FUNCTION auto selfadjointView() const {
    return ValueSelfAdjoint<Derived, kMode>(this->derived());
  }
  [[nodiscard]] auto eulerAngles(Eigen::Index a, Eigen::Index b, Eigen::Index c) const {
    return value_of(Base::eulerAngles(a, b, c));
  }
  [[nodiscard]] auto eigenvalues() const { return value_of(Base::eigenvalues()); }
  Refused jacobiSvd(unsigned options = 0) const = delete;
  Refused bdcSvd(unsigned options = 0) const = delete;
  Refused lu() const = delete;
  Refused partialPivLu() const = delete;
  Refused fullPivLu() const = delete;
  Refused llt() const = delete;
  Refused ldlt() const = delete;
  Refused householderQr() const = delete;
  Refused colPivHouseholderQr() const = delete;
  Refused fullPivHouseholderQr() const = delete;
  Refused completeOrthogonalDecomposition() const = delete;

 protected:
  ValueExpression() = default;
  ValueExpression(const ValueExpression&) = default;
  ~ValueExpression() = default;
};

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
}  // namespace physgen

namespace Eigen::internal {

template <class Derived>
  requires physgen::detail::of_values<Derived>
struct dense_xpr_base<Derived, MatrixXpr> {
  using type = physgen::detail::ValueExpression<Derived>;
};
template <class Derived>
  requires physgen::detail::of_values<Derived>
struct dense_xpr_base<Derived, ArrayXpr> {
  using type = physgen::detail::ValueArrayExpression<Derived>;
};

// Without NestByRefBit expressions hold it by value; without DirectAccessBit, blocks of it read what they hold and not
// by a pointer to what they were made of; without LvalueBit, nothing writes into such a copy, and entries are returned
// by value.
template <class S, int R, int C>
struct traits<physgen::MatrixValue<S, R, C>> : traits<Matrix<S, R, C>> {
  enum { Flags = int(traits<Matrix<S, R, C>>::Flags) & int(RowMajorBit) };
};

// Without PacketAccessBit sums over the entries of one object have the order that they have in packs and on CUDA,
// 0 + (1 + 2), where Eigen's own vectors add (0 + 1) + 2.
template <class S, int R, int C>
struct evaluator<physgen::MatrixValue<S, R, C>> : evaluator<Matrix<S, R, C>> {
  using XprType = physgen::MatrixValue<S, R, C>;
  enum { Flags = int(evaluator<Matrix<S, R, C>>::Flags) & ~int(DirectAccessBit | PacketAccessBit) };
  EIGEN_DEVICE_FUNC EIGEN_STRONG_INLINE explicit evaluator(const XprType& value)
      : evaluator<Matrix<S, R, C>>(value.plain()) {}
};

// A Matrix takes it as it takes another Matrix.
template <class S, int R, int C>
struct Assignment<Matrix<S, R, C>, physgen::MatrixValue<S, R, C>, assign_op<S, S>, Dense2Dense, void> {
  static EIGEN_DEVICE_FUNC EIGEN_STRONG_INLINE void run(Matrix<S, R, C>& to, const physgen::MatrixValue<S, R, C>& value,
                                                        const assign_op<S, S>& /*assign*/) {
    to = value.plain();
  }
};

// What is read several times, as factors of products, is a value, too: an expression's, once it is evaluated.
template <class Derived>
  requires(physgen::detail::of_values<Derived> && std::is_same_v<typename traits<Derived>::XprKind, MatrixXpr> &&
           size_at_compile_time<traits<Derived>::RowsAtCompileTime, traits<Derived>::ColsAtCompileTime>::ret != Dynamic)
struct plain_object_eval<Derived, Dense> {
  using type = physgen::MatrixValue<typename traits<Derived>::Scalar, traits<Derived>::RowsAtCompileTime,
                                    traits<Derived>::ColsAtCompileTime>;
};
template <class S, int R, int C, int n, class Plain>
struct nested_eval<physgen::MatrixValue<S, R, C>, n, Plain> {
  using type = const physgen::MatrixValue<S, R, C>;
};
template <class S, int R, int C, int n, class Plain>
struct nested_eval<const physgen::MatrixValue<S, R, C>, n, Plain> {
  using type = const physgen::MatrixValue<S, R, C>;
};

// Products of large matrices read it where it lies, as they read a Matrix.
template <class S, int R, int C>
struct blas_traits<physgen::MatrixValue<S, R, C>> : blas_traits<Matrix<S, R, C>> {
  static EIGEN_DEVICE_FUNC const Matrix<S, R, C>& extract(const physgen::MatrixValue<S, R, C>& value) {
    return value.plain();
  }
};

}  // namespace Eigen::internal

#pragma pop_macro("I")
