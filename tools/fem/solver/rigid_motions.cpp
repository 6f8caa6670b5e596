// With u(x) = v + w x (x - c) / L, a motion is free where all prescribed components of u are 0: the null space of a
// matrix of 6 x 6. Of a space of motions, those along or about coordinate axes are named first.
#include <fem/solver/rigid_motions.h>
#include <physgen/error.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace physgen::fem {

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double singular = 1e-12;  // of squares: levers of 1e-6 of the body's size still hold
constexpr double aligned = 1e-9;

/// "(0, 0.5, 1)"
std::string text_of(const Vector3d& x, double zero) {
  std::array<char, 96> text{};
  const auto shown = [zero](double value) { return std::abs(value) <= zero ? 0.0 : value; };
  std::snprintf(text.data(), text.size(), "(%.4g, %.4g, %.4g)", shown(x[0]), shown(x[1]), shown(x[2]));
  return text.data();
}

/// "x", or "(0.7071, 0.7071, 0)"
std::string direction(const Vector3d& d) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(d[k]) > 1 - aligned) return std::string(1, "xyz"[k]);
  }
  return text_of(d, aligned);
}

/// The eigenvectors of a symmetric matrix, which becomes diagonal, by Jacobi's rotations: a few small matrices, for
/// which Eigen's solvers would take long to compile.
template <int n>
Eigen::Matrix<double, n, n> eigenvectors(Eigen::Matrix<double, n, n>& a) {
  Eigen::Matrix<double, n, n> vectors = Eigen::Matrix<double, n, n>::Identity();
  const auto rotate = [](double& x, double& y, double c, double s) {
    const double kept = x;
    x = c * x - s * y;
    y = s * kept + c * y;
  };
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (int p = 0; p < n; ++p) {
      for (int q = p + 1; q < n; ++q) {
        if (a(p, q) == 0) continue;
        const double angle = 0.5 * std::atan2(2 * a(p, q), a(q, q) - a(p, p)), c = std::cos(angle), s = std::sin(angle);
        for (int k = 0; k < n; ++k) rotate(a(k, p), a(k, q), c, s);
        for (int k = 0; k < n; ++k) rotate(a(p, k), a(q, k), c, s);
        for (int k = 0; k < n; ++k) rotate(vectors(k, p), vectors(k, q), c, s);
      }
    }
  }
  return vectors;
}

/// Orthonormal directions that span what a projection is onto, coordinate axes first where they lie in it.
std::vector<Vector3d> directions_of(Matrix3d onto) {
  std::vector<Vector3d> found;
  const auto take = [&](const Vector3d& d) {
    found.push_back(d);
    onto -= d * d.transpose();
  };
  for (int k = 0; k < 3; ++k) {
    if (onto(k, k) > 1 - aligned) take(Vector3d::Unit(k));
  }
  while (onto.trace() > 0.5) {
    int most = 0;
    onto.diagonal().maxCoeff(&most);
    take(onto.col(most).normalized());
  }
  return found;
}

}  // namespace

std::vector<std::string> free_rigid_motions(std::span<const Index> nodes, std::span<const Point> rest,
                                            std::span<const std::uint8_t> fixed,
                                            const std::array<Point, 3>& prescribed) {
  const auto place = [&](Index n) { return Vector3d(rest[static_cast<std::size_t>(n)].data()); };
  Vector3d centre = Vector3d::Zero();
  for (const Index n : nodes) centre += place(n) / static_cast<double>(nodes.size());
  double size = 0;
  for (const Index n : nodes) size = std::max(size, (place(n) - centre).norm());
  if (!(size > 0)) size = 1;
  Matrix6 held = Matrix6::Zero();
  for (const Index n : nodes) {
    const Vector3d arm = (place(n) - centre) / size;
    for (int k = 0; k < 3; ++k) {
      if ((fixed[static_cast<std::size_t>(n)] >> k & 1) == 0) continue;
      const Vector3d along(prescribed[static_cast<std::size_t>(k)].data());
      Vector6 row;  // that component of v + w x arm
      row << along, arm.cross(along);
      held += row * row.transpose();
    }
  }
  const Matrix6 vectors = eigenvectors<6>(held);
  const double largest = held.diagonal().maxCoeff();
  Matrix6 motions = Matrix6::Zero();  // those that are free: v, and w below it
  bool any = false;
  for (int k = 0; k < 6; ++k) {
    if (held(k, k) > singular * largest) continue;
    motions.col(k) = vectors.col(k);
    any = true;
  }
  if (!any) return {};
  const Eigen::Matrix<double, 3, 6> v = motions.topRows<3>(), w = motions.bottomRows<3>();
  Matrix3d turns = w * w.transpose();
  const Matrix3d turning = eigenvectors<3>(turns);
  Matrix3d axes = Matrix3d::Zero(), inverse = Matrix3d::Zero();  // the projection onto w, and w w^T's inverse there
  for (int k = 0; k < 3; ++k) {
    if (turns(k, k) <= singular) continue;
    const Matrix3d onto = turning.col(k) * turning.col(k).transpose();
    axes += onto;
    inverse += onto / turns(k, k);
  }
  const Matrix3d along =
      v * w.transpose() * inverse;  // from a direction of w to the v of least norm that comes with it
  // Translations are the combinations without w.
  const Matrix3d shifts = v * v.transpose() - along * w * v.transpose();
  std::vector<std::string> names;
  for (const Vector3d& d : directions_of(shifts)) names.push_back("translation along " + direction(d));
  for (const Vector3d& axis : directions_of(axes)) {
    Vector3d shift = along * axis;
    shift -= shifts * shift;
    const bool is_screw = std::abs(shift.dot(axis)) > 1e-6;
    names.push_back((is_screw ? "screw about " : "rotation about ") + direction(axis));
    // Where it may be shifted across its axis, the axis is anywhere.
    const bool anywhere = (shifts - axis * axis.transpose() * shifts).trace() > 0.5;
    if (anywhere) continue;
    Vector3d point = centre + size * axis.cross(shift);
    point -= axis * axis.dot(point);  // the one nearest to the origin
    names.back() += " through " + text_of(point, 1e-9 * size) + " m";
  }
  return names;
}

void require_held(const TetMesh& mesh, std::span<const Point> rest, std::span<const std::uint8_t> fixed,
                  const std::array<Point, 3>& axes) {
  std::vector<Index> part(static_cast<std::size_t>(mesh.nodes));  // a node of the same part, itself for one of each
  std::iota(part.begin(), part.end(), Index{0});
  const auto root = [&part](Index n) {
    while (part[static_cast<std::size_t>(n)] != n) {
      Index& up = part[static_cast<std::size_t>(n)];
      up = part[static_cast<std::size_t>(up)];
      n = up;
    }
    return n;
  };
  for (const auto& [a, b] : mesh.edges) {
    const Index one = root(a), other = root(b);
    part[static_cast<std::size_t>(std::max(one, other))] = std::min(one, other);
  }
  std::vector<std::vector<Index>> parts;
  std::vector<Index> number(static_cast<std::size_t>(mesh.nodes), -1);
  for (Index n = 0; n < mesh.nodes; ++n) {
    const auto at = static_cast<std::size_t>(root(n));
    if (number[at] < 0) {
      number[at] = static_cast<Index>(parts.size());
      parts.emplace_back();
    }
    parts[static_cast<std::size_t>(number[at])].push_back(n);
  }
  for (const std::vector<Index>& nodes : parts) {
    if (nodes.size() < 4) continue;  // of no tet
    const std::vector<std::string> motions = free_rigid_motions(nodes, rest, fixed, axes);
    if (motions.empty()) continue;
    std::string list;
    for (const std::string& motion : motions) list += (list.empty() ? "" : ", ") + motion;
    throw Error("nothing keeps the " +
                std::string(parts.size() > 1
                                ? "part with the node at " +
                                      text_of(Vector3d(rest[static_cast<std::size_t>(nodes.front())].data()), 0) + " m"
                                : "body") +
                " from moving as a rigid body: " + list + "; add supports that prescribe components against that");
  }
}

}  // namespace physgen::fem
