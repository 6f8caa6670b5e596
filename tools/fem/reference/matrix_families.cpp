// The families.
#include <fem/reference/matrix_families.h>

#include <array>
#include <cmath>
#include <sstream>

namespace physgen::fem::reference {

namespace {

using M = Eigen::Matrix3d;
using V = Eigen::Vector3d;
using Families = std::vector<MatrixFamily>;

std::string number(double x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

// Draws that depend on each other's order stand in statements of their own: a seed means the same with every compiler.

// Q1 diag(s) Q2^T with random rotations: singular values s, up to rounding.
M turned(RandomMatrices& r, const V& s) {
  const M left = r.rotation(), right = r.rotation();
  return left * s.asDiagonal() * right.transpose();
}

// 1, 0.1, ... 10^-most.
double decade(RandomMatrices& r, int most) { return std::pow(10., -r.integer(0, most)); }

void add_special(Families& f) {
  f.push_back({"zero", [](RandomMatrices&) -> M { return M::Zero(); }});
  f.push_back({"identity", [](RandomMatrices&) -> M { return M::Identity(); }});
  f.push_back({"minus identity", [](RandomMatrices&) -> M { return -M::Identity(); }});
  f.push_back({"rotation", [](RandomMatrices& r) -> M { return r.rotation(); }});
  f.push_back({"reflection", [](RandomMatrices& r) -> M { return -r.rotation(); }});
  f.push_back({"scaled rotation", [](RandomMatrices& r) -> M {
                 const M rotation = r.rotation();
                 return std::exp(r.uniform(-30, 30)) * rotation;
               }});
  f.push_back({"rotation about one axis", [](RandomMatrices& r) -> M {
                 const int axis = r.integer(0, 2);
                 return Eigen::AngleAxisd(r.uniform(-4, 4), V::Unit(axis)).toRotationMatrix();
               }});
  f.push_back({"signed permutation", [](RandomMatrices& r) -> M {
                 M m = M::Zero();
                 std::array<int, 3> p{0, 1, 2};
                 for (std::size_t k = 2; k > 0; --k) {
                   std::swap(p[k], p[static_cast<std::size_t>(r.integer(0, static_cast<int>(k)))]);
                 }
                 for (int k = 0; k < 3; ++k) m(k, p[static_cast<std::size_t>(k)]) = r.integer(0, 1) * 2 - 1;
                 return m;
               }});
  f.push_back({"scaled signed permutation", [](RandomMatrices& r) -> M {
                 const int shift = r.integer(0, 2);
                 M m = M::Zero();
                 for (int k = 0; k < 3; ++k) m(k, (k + shift) % 3) = r.normal();
                 return m;
               }});
  f.push_back({"-1, 0, 1", [](RandomMatrices& r) -> M {
                 M m;
                 for (int k = 0; k < 9; ++k) m(k % 3, k / 3) = r.integer(-1, 1);
                 return m;
               }});
  f.push_back({"skew-symmetric", [](RandomMatrices& r) -> M {
                 const M m = r.gaussian();
                 return m - m.transpose();
               }});
  f.push_back({"symmetric", [](RandomMatrices& r) -> M {
                 const M m = r.gaussian();
                 return m + m.transpose();
               }});
}

void add_rank_deficient(Families& f) {
  f.push_back({"rank 1", [](RandomMatrices& r) -> M {
                 const M a = r.gaussian(), b = r.gaussian();
                 return a.col(0) * b.row(0);
               }});
  f.push_back({"rank 1 of integers", [](RandomMatrices& r) -> M {
                 V a, b;
                 for (int k = 0; k < 3; ++k) a[k] = r.integer(-3, 3), b[k] = r.integer(-3, 3);
                 return a * b.transpose();
               }});
  f.push_back({"rank 2", [](RandomMatrices& r) -> M {
                 const M a = r.gaussian(), b = r.gaussian();
                 return a.leftCols<2>() * b.topRows<2>();
               }});
  f.push_back({"equal columns", [](RandomMatrices& r) -> M {
                 M m = r.gaussian();
                 const int kept = r.integer(0, 2);
                 m.col((kept + 1) % 3) = m.col(kept);
                 if (r.integer(0, 1) == 1) m.col((kept + 2) % 3) = -m.col(kept);
                 return m;
               }});
  f.push_back({"zero column", [](RandomMatrices& r) -> M {
                 M m = r.gaussian();
                 m.col(r.integer(0, 2)).setZero();
                 return m;
               }});
  f.push_back({"zero row", [](RandomMatrices& r) -> M {
                 M m = r.gaussian();
                 m.row(r.integer(0, 2)).setZero();
                 return m;
               }});
  f.push_back({"one entry", [](RandomMatrices& r) -> M {
                 M m = M::Zero();
                 const int entry = r.integer(0, 8);
                 m(entry % 3, entry / 3) = r.normal();
                 return m;
               }});
}

void add_stretches(Families& f, const Precision& p) {
  std::vector<std::pair<std::string, V>> stretches{{"2, 1, 1", V(2, 1, 1)},
                                                   {"2, 2, 1", V(2, 2, 1)},
                                                   {"2, 1, -1", V(2, 1, -1)},
                                                   {"1, 0, 0", V(1, 0, 0)},
                                                   {"1, 1, 0", V(1, 1, 0)},
                                                   {"1, 0.5, 0", V(1, 0.5, 0)},
                                                   {"1, 1e-3, 1e-3", V(1, 1e-3, 1e-3)},
                                                   {"1, 1e-3, 1e-6", V(1, 1e-3, 1e-6)},
                                                   {"1, 1e-6, 1e-12", V(1, 1e-6, 1e-12)},
                                                   {"1, 1, 1e-12", V(1, 1, 1e-12)},
                                                   {"1, 1, 1e-3", V(1, 1, 1e-3)},
                                                   {"1, 1, 1e-6", V(1, 1, 1e-6)},
                                                   {"1, 1e-12, 1e-12", V(1, 1e-12, 1e-12)},
                                                   {"1, 1e-10, 1e-20", V(1, 1e-10, 1e-20)}};
  // Numbers from 0.5 to 1 are half an epsilon apart, from 0.25 to 0.5 a quarter.
  for (const double ulps : {1., 2., 10., 1000.}) {
    const double below_1 = ulps * p.epsilon / 2, below_half = ulps * p.epsilon / 4;
    stretches.emplace_back("2, 1, 1 - " + number(ulps) + " ulp", V(2, 1, 1 - below_1));
    stretches.emplace_back("1, 1 - " + number(ulps) + " ulp, 0.5", V(1, 1 - below_1, 0.5));
    stretches.emplace_back("all within " + number(ulps) + " ulp", V(1, 1 - below_1, 1 - 2 * below_1));
    stretches.emplace_back("1, 0.5, -0.5 + " + number(ulps) + " ulp", V(1, 0.5, -0.5 + below_half));
    stretches.emplace_back("1, 1, " + number(ulps) + " epsilon", V(1, 1, ulps * p.epsilon));
    stretches.emplace_back("1, 1, -" + number(ulps) + " epsilon", V(1, 1, -ulps * p.epsilon));
  }
  for (const auto& [name, s] : stretches) {
    f.push_back({"s = " + name, [s = s](RandomMatrices& r) -> M { return turned(r, s); }});
    f.push_back({"diagonal " + name, [s = s](RandomMatrices&) -> M { return s.asDiagonal(); }});
  }
}

// Magnitudes: norms, subnormals, and entries of very different size.
void add_magnitudes(Families& f, const Precision& p) {
  const auto clamped = [](RandomMatrices& r) -> M { return r.gaussian().cwiseMax(-1.5).cwiseMin(1.5); };
  std::vector<double> factors{1e-6,
                              1e-8,
                              1e-20,
                              1e-22,
                              1e19,
                              1e20,
                              1e30,
                              5e37,
                              p.largest / 8,
                              p.smallest_normal,
                              p.smallest_normal / 16,
                              p.smallest * 1000,
                              p.smallest * 4};
  for (const double factor : factors) {
    f.push_back({"Gaussian times " + number(factor), [=](RandomMatrices& r) -> M { return factor * clamped(r); }});
    f.push_back({"rotation times " + number(factor), [=](RandomMatrices& r) -> M { return factor * r.rotation(); }});
  }
  f.push_back({"rotation times 3e38", [](RandomMatrices& r) -> M { return 3e38 * r.rotation(); }});
  f.push_back({"all entries a quarter of the largest number", [p](RandomMatrices& r) -> M {
                 M m;
                 for (int k = 0; k < 9; ++k)
                   m(k % 3, k / 3) = p.largest / 4 * (r.integer(0, 1) * 2 - 1);  // s1 <= 3/4 of it
                 return m;
               }});
  f.push_back({"graded", [](RandomMatrices& r) -> M {
                 M m;
                 for (int k = 0; k < 9; ++k) m(k % 3, k / 3) = r.normal();
                 for (int k = 0; k < 9; ++k) m(k % 3, k / 3) *= decade(r, 30);
                 return m;
               }});
  f.push_back({"graded columns", [](RandomMatrices& r) -> M {
                 M m = r.gaussian();
                 m.col(1) *= decade(r, 9);
                 m.col(2) *= decade(r, 18);
                 return m;
               }});
  f.push_back({"graded rows", [](RandomMatrices& r) -> M {
                 M m = r.gaussian();
                 m.row(0) *= decade(r, 18);
                 m.row(1) *= decade(r, 9);
                 return m;
               }});
}

// Elements as scenes deform them, to beyond what they should.
void add_elements(Families& f) {
  f.push_back({"sliver", [](RandomMatrices& r) -> M {
                 M m = r.gaussian().triangularView<Eigen::Upper>();
                 m(1, 1) *= 1e-3, m(2, 2) *= 1e-6;
                 return m;
               }});
  for (const double strain : {1e-2, 1e-4, 1e-6, 1e-8}) {
    f.push_back({"near rest, strain " + number(strain),
                 [strain](RandomMatrices& r) -> M { return deformation_near_rest(r, strain); }});
  }
  f.push_back({"compressed", [](RandomMatrices& r) -> M { return turned(r, V(1.4, 1.3, r.uniform(0.01, 0.3))); }});
  f.push_back({"flattened", [](RandomMatrices& r) -> M {
                 M m = random_deformation(r);
                 const int row = r.integer(0, 2);
                 m.row(row) *= 0.1 * decade(r, 11);
                 return m;
               }});
  f.push_back({"inverted", [](RandomMatrices& r) -> M {
                 const double second = r.uniform(0.5, 1.4);
                 return turned(r, V(1.5, second, -r.uniform(0, 0.5)));
               }});
  f.push_back({"turned inside out", [](RandomMatrices& r) -> M { return -random_deformation(r); }});
  f.push_back({"sheared far", [](RandomMatrices& r) -> M {
                 M m = M::Identity();
                 const int row = r.integer(0, 1);
                 m(row, 2) = 1e6 * decade(r, 6);
                 m(row, 2) *= r.normal();
                 return m;
               }});
}

}  // namespace

Families hard_matrices(const Precision& precision) {
  Families families;
  add_special(families);
  add_rank_deficient(families);
  add_stretches(families, precision);
  add_magnitudes(families, precision);
  add_elements(families);
  return families;
}

Eigen::Matrix3d random_deformation(RandomMatrices& random) { return M::Identity() + 0.3 * random.gaussian(); }

Eigen::Matrix3d deformation_near_rest(RandomMatrices& random, double strain) {
  const M rotation = random.rotation();
  return rotation * (M::Identity() + strain * random.gaussian());
}

}  // namespace physgen::fem::reference
