// What expressions.cpp needs: formats, what an index loads and the same in named matrices, and the comparison of both.
#pragma once

#include <everything.physgen.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>
#include <physgen/rows.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cstdio>
#include <cstring>

namespace expressions {

using namespace physgen;
using namespace physgen::math;
using tissue::model::ShapesObject;

inline int failures = 0, compared = 0;

/// Twice the value that is stored.
struct Halved {
  static constexpr const char* name = "halved";
  template <class Real>
  using Stored = float;
  template <class Real>
  static constexpr ElementType type = ElementType::float32;
  static constexpr double scale = 2, centre = 0;
  template <class Real>
  static Real decode(float stored) {
    return static_cast<Real>(stored) * Real(2);
  }
  template <class Real>
  static float encode(Real value) {
    return static_cast<float>(value / Real(2));
  }
};
/// Three formats, each of some fields, and one of a rotation.
template <class First, class Second, class Third, class Turn>
struct In : tissue::model::ShapesFormats<Host> {
  using v = First;
  using F = Second;
  using B = Third;
  using row = First;
  using K = Second;
  using s = Third;
  using W = First;
  using U = Turn;
  using V = Turn;
};

/// Overwrites the stack below its caller's frame.
[[gnu::noinline]] inline void trample() {
  volatile unsigned char bytes[16384];
  for (unsigned k = 0; k < sizeof bytes; ++k) bytes[k] = 0xCD;
}

template <class A, class B>
bool same_bits(const A& a, const B& b) {
  static_assert(std::is_same_v<A, B>);
  return std::memcmp(&a, &b, sizeof(A)) == 0;
}
template <class T>
auto evaluated(const T& value) {
  if constexpr (requires { typename T::PlainObject; }) {
    return typename T::PlainObject(value);
  } else {
    return value;
  }
}
template <class Lazy, class Named>
void expect_equal(const char* text, const Lazy& lazy, const Named& expected) {
  ++compared;
  bool equal = true;
  const auto found = evaluated(lazy);
  if constexpr (requires { found.rows(); }) {
    for (Eigen::Index c = 0; c < found.cols(); ++c) {
      for (Eigen::Index r = 0; r < found.rows(); ++r)
        equal = equal && same_bits(found.coeff(r, c), expected.coeff(r, c));
    }
  } else {
    equal = same_bits(found, expected);
  }
  if (!equal) {
    std::printf("%s\n", text);
    ++failures;
  }
}

/// What an index loads, as expressions name it. w and G are gathered; s is the diagonal of a matrix, K symmetric, W
/// skew, U a rotation.
template <class View, class I>
struct Loaded {
  View view;
  I i;

  auto x() const { return view[i].v().get(); }
  auto v() const { return view.get(i).s; }
  auto w() const { return view[gathered()].v().get(); }
  auto s() const { return view[i].s().get(); }
  auto F() const { return view[i].F().get(); }
  auto G() const { return view.get(gathered()).F; }
  auto K() const { return view[i].K().get(); }
  auto W() const { return view[i].W().get(); }
  auto U() const { return view[i].U().get(); }
  auto B() const { return view[i].B().get(); }
  auto row() const { return view[i].row().get(); }
  auto all() const { return view.get(i); }
  auto gathered() const {
    if constexpr (std::is_integral_v<I>) {
      return static_cast<std::int32_t>(i + 1);
    } else {
      return numbers(i) + lanes_t<std::int32_t, I>(1);
    }
  }
};
/// The same in named matrices of Eigen.
template <class S, class All>
struct Named {
  using Vector = Eigen::Matrix<S, 3, 1>;
  using Matrix = Eigen::Matrix<S, 3, 3>;
  Vector x_, v_, w_, s_;
  Matrix F_, G_, K_, W_, U_;
  Eigen::Matrix<S, 2, 3> B_;
  Eigen::Matrix<S, 1, 4> row_;
  All all_;

  template <class From>
  explicit Named(const From& from)
      : x_(from.x()),
        v_(from.v()),
        w_(from.w()),
        s_(from.s()),
        F_(from.F()),
        G_(from.G()),
        K_(from.K()),
        W_(from.W()),
        U_(from.U()),
        B_(from.B()),
        row_(from.row()),
        all_(from.all()) {}
  const auto& x() const { return x_; }
  const auto& v() const { return v_; }
  const auto& w() const { return w_; }
  const auto& s() const { return s_; }
  const auto& F() const { return F_; }
  const auto& G() const { return G_; }
  const auto& K() const { return K_; }
  const auto& W() const { return W_; }
  const auto& U() const { return U_; }
  const auto& B() const { return B_; }
  const auto& row() const { return row_; }
  const auto& all() const { return all_; }
};

struct Later {
  template <class T>
  auto operator()(const T& expression) const {
    return expression;
  }
};
struct AtOnce {
  template <class T>
  auto operator()(const T& expression) const {
    return evaluated(expression);
  }
};

/// Compares expressions of what an index of a view loads with those of named copies.
template <class View, class I>
class Expressions {
  using S = lanes_t<typename View::Precision, I>;

 public:
  Expressions(const View& view, I i)
      : o_{view, i}, named_(o_), two_(typename View::Precision(2)), mask_(S(view[i].a()) > S(0)) {}
  void compare_all() const;

 private:
  template <class Body>
  [[gnu::noinline]] auto form(const Body& body) const {
    return body(Later{}, o_, two_, mask_);
  }
  template <class Body>
  void compare(const char* text, const Body& body) const {
    const auto lazy = form(body);
    trample();
    expect_equal(text, lazy, body(AtOnce{}, named_, two_, mask_));
  }

  Loaded<View, I> o_;
  Named<S, std::remove_cvref_t<decltype(o_.all())>> named_;
  S two_;
  decltype(two_ > two_) mask_;
};

}  // namespace expressions
