// Every kernel once more, for one object at a time, in plain Eigen and straight from the formulas. Computed in T from
// values in any precision, it is the reference of errors (T wider than the kernel's type), makes the inputs (T =
// double), and as a loop over vectors of structs it is the comparison called `eigen`.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <type_traits>

#include "kernels.h"

namespace physgen::bench {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;

/// The type that the reference of a result in Real is computed in.
template <class Real>
using Wider = std::conditional_t<std::is_same_v<Real, float>, double, long double>;

/// Specialised for each kernel: value<T, Real>(i, inputs...) is the output for object i, inputs[j] being the values of
/// object j in Real; observe<T>(value) is what is compared, as an Eigen matrix.
template <class Kernel>
struct Naive;

namespace detail {

/// Lame constants in T, rounded to Real first: a kernel in Real knows no better ones.
template <class T, class Real>
struct Lame {
  T mu = T(Real(youngs_modulus / (2 * (1 + poissons_ratio))));
  T lambda = T(Real(youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))));
};

/// phi'(J) and phi''(J) [Pa] of the Neo-Hookean psi = mu/2 (I1 - 3) + phi(J), phi = -mu ln J + lambda/2 ln^2 J, with
/// phi' continued linearly below J0.
template <class T>
struct VolumeSlopes {
  T first, second;
};
template <class T, class Real>
VolumeSlopes<T> volume_slopes(const Lame<T, Real>& lame, T J) {
  const T J0 = T(fem::NeoHookean<Real>().smallest_volume_ratio), held = J < J0 ? J0 : J, log = std::log(held);
  const T second = (lame.mu + lame.lambda * (1 - log)) / (held * held);
  return {(lame.lambda * log - lame.mu) / held + second * (J - held), second};
}

/// Edge vectors of a tet from corner i, by columns. @param at at(node) is a vector
template <class T, class Nodes, class At>
Matrix3<T> edges(const Nodes& nodes, const At& at) {
  const Vector3<T> origin = at(nodes[0]).template cast<T>();
  Matrix3<T> d;
  for (int c = 0; c < 3; ++c) d.col(c) = at(nodes[c + 1]).template cast<T>() - origin;
  return d;
}

template <class T>
elasticity::DeformationSvd<T> svd(const Matrix3<T>& F) {
  elasticity::DeformationSvd<T> result;
  if (!F.allFinite()) {  // Eigen gives nothing then, not even NaN
    result.U = result.V = Matrix3<T>::Constant(std::numeric_limits<T>::quiet_NaN());
    result.s = result.U.col(0);
    return result;
  }
  const Eigen::JacobiSVD<Matrix3<T>> found(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  result.U = found.matrixU();
  result.V = found.matrixV();
  result.s = found.singularValues();
  for (Matrix3<T>* rotation : {&result.U, &result.V}) {
    if (rotation->determinant() > 0) continue;
    rotation->col(2) = -rotation->col(2);
    result.s[2] = -result.s[2];
  }
  return result;
}

template <class T, class Derivative>
Matrix3<T> dp_from_df(const Matrix3<T>& U, const Matrix3<T>& V, const Derivative& x, const Matrix3<T>& dF) {
  const Matrix3<T> f = U.transpose() * dF * V;
  Matrix3<T> p;
  p(0, 0) = T(x.x1111) * f(0, 0) + T(x.x2211) * f(1, 1) + T(x.x3311) * f(2, 2);
  p(1, 1) = T(x.x2211) * f(0, 0) + T(x.x2222) * f(1, 1) + T(x.x3322) * f(2, 2);
  p(2, 2) = T(x.x3311) * f(0, 0) + T(x.x3322) * f(1, 1) + T(x.x3333) * f(2, 2);
  p(1, 0) = T(x.x2121) * f(1, 0) + T(x.x2112) * f(0, 1);
  p(0, 1) = T(x.x2112) * f(1, 0) + T(x.x2121) * f(0, 1);
  p(2, 0) = T(x.x3131) * f(2, 0) + T(x.x3113) * f(0, 2);
  p(0, 2) = T(x.x3113) * f(2, 0) + T(x.x3131) * f(0, 2);
  p(2, 1) = T(x.x3232) * f(2, 1) + T(x.x3223) * f(1, 2);
  p(1, 2) = T(x.x3223) * f(2, 1) + T(x.x3232) * f(1, 2);
  return U * p * V.transpose();
}

template <class T, class Rest>
Matrix3<T> corner_forces(const Rest& rest, const Matrix3<T>& P) {
  return -T(rest.volume) * P * rest.dm_inverse.template cast<T>().transpose();
}

/// The force on corner c of a tet.
template <class T, class Forces>
Vector3<T> force_on(const Forces& forces, int corner) {
  const Matrix3<T> G = forces.G.template cast<T>();
  return corner == 0 ? Vector3<T>(-G.rowwise().sum()) : Vector3<T>(G.col(corner - 1));
}

}  // namespace detail

template <>
struct Naive<DeformationGradient> {
  template <class T, class Real>
  static elasticity::DeformationGradient<T> value(index_t i, const auto& tets, const auto& positions,
                                                  const auto& rest) {
    const Matrix3<T> ds = detail::edges<T>(tets[i].nodes, [&](index_t node) { return positions[node].x; });
    return {ds * rest[i].dm_inverse.template cast<T>()};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.F.template cast<T>();
  }
};

/// U and V are not unique where stretches meet: compared are s, the rotation U V^T and F itself.
template <>
struct Naive<Svd> {
  template <class T, class Real>
  static elasticity::DeformationSvd<T> value(index_t i, const auto& gradients) {
    return detail::svd<T>(gradients[i].F.template cast<T>());
  }
  template <class T>
  static Eigen::Matrix<T, 3, 7> observe(const auto& value) {
    const Matrix3<T> U = value.U.template cast<T>(), V = value.V.template cast<T>();
    const Vector3<T> s = value.s.template cast<T>();
    Eigen::Matrix<T, 3, 7> all;
    all << s, U * V.transpose(), U * s.asDiagonal() * V.transpose();
    return all;
  }
};

template <>
struct Naive<Stress> {
  template <class T, class Real>
  static elasticity::Stress<T> value(index_t i, const auto& svds) {
    const detail::Lame<T, Real> lame;
    const auto& svd = svds[i];
    const Vector3<T> s = svd.s.template cast<T>();
    const Vector3<T> c(s[1] * s[2], s[0] * s[2], s[0] * s[1]);  // dJ/ds
    const Vector3<T> g = lame.mu * s + detail::volume_slopes(lame, s.prod()).first * c;
    return {svd.U.template cast<T>() * g.asDiagonal() * svd.V.template cast<T>().transpose()};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.P.template cast<T>();
  }
};

template <>
struct Naive<StressDerivative> {
  template <class T, class Real>
  static elasticity::StressDerivative<T> value(index_t i, const auto& svds) {
    const detail::Lame<T, Real> lame;
    const Vector3<T> s = svds[i].s.template cast<T>();
    const auto phi = detail::volume_slopes(lame, s.prod());
    const Vector3<T> c(s[1] * s[2], s[0] * s[2], s[0] * s[1]);  // dJ/ds
    const T mu = lame.mu;
    const auto same = [&](int a) { return mu + phi.second * c[a] * c[a]; };
    const auto mixed = [&](int a, int b) { return phi.second * c[a] * c[b] + phi.first * s[3 - a - b]; };
    const auto swapped = [&](int a, int b) { return -phi.first * s[3 - a - b]; };  // (D - S) / 2; (D + S) / 2 is mu
    return {same(0), mixed(1, 0),   mixed(2, 0), same(1),       mixed(2, 1), same(2),
            mu,      swapped(1, 0), mu,          swapped(2, 0), mu,          swapped(2, 1)};
  }
  template <class T>
  static Eigen::Matrix<T, 12, 1> observe(const auto& x) {
    Eigen::Matrix<T, 12, 1> all;
    all << T(x.x1111), T(x.x2211), T(x.x3311), T(x.x2222), T(x.x3322), T(x.x3333), T(x.x2121), T(x.x2112), T(x.x3131),
        T(x.x3113), T(x.x3232), T(x.x3223);
    return all;
  }
};

template <>
struct Naive<DpFromDf> {
  template <class T, class Real>
  static elasticity::StressDifferential<T> value(index_t i, const auto& svds, const auto& derivatives,
                                                 const auto& differentials) {
    const auto& svd = svds[i];
    return {detail::dp_from_df<T>(svd.U.template cast<T>(), svd.V.template cast<T>(), derivatives[i],
                                  differentials[i].dF.template cast<T>())};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.dP.template cast<T>();
  }
};

template <>
struct Naive<ElasticForce> {
  template <class T, class Real>
  static elasticity::CornerForces<T> value(index_t i, const auto& rest, const auto& stresses) {
    return {detail::corner_forces<T>(rest[i], stresses[i].P.template cast<T>())};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.G.template cast<T>();
  }
};

template <>
struct Naive<GatherForces> {
  template <class T, class Real>
  static elasticity::NodeForce<T> value(index_t i, const auto& ranges, const auto& entries, const auto& forces) {
    Vector3<T> sum = Vector3<T>::Zero();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      sum += detail::force_on<T>(forces[entries[k].element], entries[k].local);
    }
    return {sum};
  }
  template <class T>
  static Vector3<T> observe(const auto& value) {
    return value.f.template cast<T>();
  }
};

template <>
struct Naive<AddForceDifferential> {
  template <class T, class Real>
  static elasticity::NodeForceDifferential<T> value(index_t i, const auto& node_stiffness, const auto& edge_stiffness,
                                                    const auto& edges, const auto& ranges, const auto& entries,
                                                    const auto& displacements) {
    Vector3<T> sum = node_stiffness[i].K.template cast<T>() * displacements[i].dx.template cast<T>();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      const index_t edge = entries[k].element;
      const int side = entries[k].local;
      const Matrix3<T> E = edge_stiffness[edge].E.template cast<T>();
      const Vector3<T> dx = displacements[edges[edge].nodes[1 - side]].dx.template cast<T>();
      sum += side == 0 ? Vector3<T>(E * dx) : Vector3<T>(E.transpose() * dx);
    }
    return {sum};
  }
  template <class T>
  static Vector3<T> observe(const auto& value) {
    return value.df.template cast<T>();
  }
};

template <>
struct Naive<ElementForceDifferential> {
  template <class T, class Real>
  static elasticity::CornerForces<T> value(index_t i, const auto& tets, const auto& displacements, const auto& rest,
                                           const auto& svds, const auto& derivatives) {
    const Matrix3<T> ds = detail::edges<T>(tets[i].nodes, [&](index_t node) { return displacements[node].dx; });
    const auto& svd = svds[i];
    const Matrix3<T> dF = ds * rest[i].dm_inverse.template cast<T>();
    const Matrix3<T> dP = detail::dp_from_df<T>(svd.U.template cast<T>(), svd.V.template cast<T>(), derivatives[i], dF);
    return {detail::corner_forces<T>(rest[i], dP)};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.G.template cast<T>();
  }
};

}  // namespace physgen::bench
