// Requirements on the kernels, written once for host and CUDA: type-parameterised tests, instantiated by
// kernels_test.cpp and kernels_gpu_test.cu with the precisions, layouts and spaces there are. parallel_for is included
// by those files.
#pragma once

#include <gtest/gtest.h>

#include "kernel_scene.h"

namespace physgen::fem {

template <class Case>
class Kernels : public testing::Test {
 protected:
  using Real = typename Case::Real;
  using Scene = KernelScene<Case>;
  using Mat = reference::Mat;
  using Vec = reference::Vec;

  void SetUp() override {
    if (Case::Space::kind == SpaceKind::cuda && !cuda_available()) GTEST_SKIP() << "no CUDA device here";
  }

  static constexpr Real eps = Scene::eps;
  const typename Case::Model model = Case::Model::from(1, 0.45);
  const double modulus = double(2 * model.mu + model.lambda);

  static std::vector<Vec> exact(const std::vector<Point>& points) {
    std::vector<Vec> result;
    for (const Point& p : points) result.push_back(Vec(p[0], p[1], p[2]));
    return result;
  }
  template <class Array>
  static std::vector<Vec> vectors(const Array& host, auto&& field) {
    std::vector<Vec> result;
    for (index_t i = 0; i < host.size(); ++i) result.push_back(field(host.view()[i]).template cast<reference::Long>());
    return result;
  }
  static double largest(const std::vector<Vec>& v) {
    double most = 0;
    for (const Vec& x : v) most = std::max(most, double(x.norm()));
    return most;
  }
  // NaN anywhere makes the result NaN, so that EXPECT_LE fails on poison.
  static double largest_difference(const std::vector<Vec>& a, const std::vector<Vec>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double d = double((a[i] - b[i]).norm());
      if (!(d <= most)) most = d;
    }
    return most;
  }
  static Vec total(const std::vector<Vec>& v) {
    Vec sum = Vec::Zero();
    for (const Vec& x : v) sum += x;
    return sum;
  }
  static std::vector<Point> moved(const std::vector<Point>& points, const Eigen::Matrix3d& A,
                                  const Eigen::Vector3d& b) {
    std::vector<Point> result;
    for (const Point& p : points) {
      const Eigen::Vector3d q = A * Eigen::Vector3d(p[0], p[1], p[2]) + b;
      result.push_back({q[0], q[1], q[2]});
    }
    return result;
  }
};
TYPED_TEST_SUITE_P(Kernels);

TYPED_TEST_P(Kernels, deformation_gradient_of_an_affine_motion_is_its_matrix) {
  typename TestFixture::Scene scene(3);
  Eigen::Matrix3d A;
  A << 1.25, 0.5, -0.125, 0.0625, 0.75, 0.25, -0.5, 0.125, 1.5;  // short binary fractions: positions round little
  scene.set_positions(scene.positions, TestFixture::moved(scene.cube.rest, A, {0.5, -0.25, 1}));
  scene.run_all(this->model);
  const auto gradient = scene.download(scene.gradient);
  for (index_t i = 0; i < scene.elements(); ++i) {
    const Eigen::Matrix3d F = gradient.view()[i].F().get().template cast<double>();
    ASSERT_LE((F - A).norm(), 64 * TestFixture::eps * A.norm()) << "tet " << i;
  }
}

TYPED_TEST_P(Kernels, svd_reproduces_the_deformation_gradient_with_rotations) {
  typename TestFixture::Scene scene(5);
  scene.run_all(this->model);
  const auto gradient = scene.download(scene.gradient);
  const auto svd = scene.download(scene.svd);
  for (index_t i = 0; i < scene.elements(); ++i) {
    const Eigen::Matrix3d F = gradient.view()[i].F().get().template cast<double>();
    const Eigen::Matrix3d U = svd.view()[i].U().get().template cast<double>();
    const Eigen::Matrix3d V = svd.view()[i].V().get().template cast<double>();
    const Eigen::Vector3d s = svd.view()[i].s().get().template cast<double>();
    ASSERT_LE((U * s.asDiagonal() * V.transpose() - F).norm(), 24 * TestFixture::eps * F.norm()) << "tet " << i;
    ASSERT_LE((U.transpose() * U - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 32 * TestFixture::eps);
    ASSERT_LE((V.transpose() * V - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 32 * TestFixture::eps);
    ASSERT_NEAR(U.determinant(), 1, 32 * TestFixture::eps);
    ASSERT_NEAR(V.determinant(), 1, 32 * TestFixture::eps);
  }
}

TYPED_TEST_P(Kernels, stress_and_its_differential_agree_with_the_textbook) {
  using reference::Long;
  typename TestFixture::Scene scene(5);
  scene.run_all(this->model);
  const auto gradient = scene.download(scene.gradient);
  const auto stress = scene.download(scene.stress);
  const auto dF = scene.download(scene.gradient_differential);
  const auto dP = scene.download(scene.stress_differential);
  double worst = 0, worst_differential = 0;
  for (index_t i = 0; i < scene.elements(); ++i) {
    const reference::Mat F = gradient.view()[i].F().get().template cast<Long>();
    const reference::Mat P = stress.view()[i].P().get().template cast<Long>();
    const double error = double((P - reference::stress(this->model, F)).norm()) / this->modulus / TestFixture::eps;
    if (!(error <= worst)) worst = error;
    const reference::Mat direction = dF.view()[i].dF().get().template cast<Long>();
    const reference::Mat expected = reference::derivative(
        [&](Long h) { return reference::stress(this->model, F + h * direction); }, 1e-4L / direction.norm());
    const reference::Mat got = dP.view()[i].dP().get().template cast<Long>();
    const double e = double((got - expected).norm() / direction.norm()) / this->modulus / TestFixture::eps;
    if (!(e <= worst_differential)) worst_differential = e;
  }
  this->RecordProperty("stress_eps", std::to_string(worst));
  this->RecordProperty("differential_eps", std::to_string(worst_differential));
  EXPECT_LE(worst, 64);
  EXPECT_LE(worst_differential, 64);
}

TYPED_TEST_P(Kernels, forces_agree_with_the_textbook_and_sum_to_zero) {
  using reference::Long;
  typename TestFixture::Scene scene(5);
  scene.run_all(this->model);
  const auto got = TestFixture::vectors(scene.download(scene.forces), [](auto node) { return node.f().get(); });
  const auto expected = reference::forces(this->model, scene.cube.mesh, TestFixture::exact(scene.cube.rest),
                                          TestFixture::exact(scene.cube.deformed));
  const double area = 1. / 25;  // of a cell's face
  EXPECT_LE(TestFixture::largest_difference(got, expected), 128 * TestFixture::eps * this->modulus * area);
  EXPECT_GT(TestFixture::largest(expected), 1e-4 * this->modulus * area);
  EXPECT_LE(double(TestFixture::total(got).norm()),
            8 * TestFixture::eps * TestFixture::largest(expected) * double(got.size()));
}

TYPED_TEST_P(Kernels, a_rigid_motion_gives_no_force) {
  typename TestFixture::Scene scene(4);
  // With nu = 0.2, lambda is 2/3 mu: the limit in mu then speaks of the arithmetic, not of lambda / mu.
  const auto soft = TypeParam::Model::from(1, 0.2);
  const double limit = 32 * TestFixture::eps * double(soft.mu) / 16;
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (const Eigen::Matrix3d& R : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), quarter_turn,
                                   reference::Random(3).rotation(), reference::Random(4).rotation()}) {
    // About the middle: positions far from the origin would carry their own rounding.
    const Eigen::Vector3d middle = Eigen::Vector3d::Constant(0.5);
    scene.set_positions(scene.positions, TestFixture::moved(scene.cube.rest, R, -R * middle));
    scene.run_all(soft);
    const auto f = TestFixture::vectors(scene.download(scene.forces), [](auto node) { return node.f().get(); });
    // Positions are rounded where they are stored, and so are moved by a little more than a rigid motion: what forces
    // these call for, in exact arithmetic, is none of the kernels' errors.
    const auto stored = TestFixture::vectors(scene.download(scene.positions), [](auto node) { return node.x().get(); });
    const auto expected = reference::forces(soft, scene.cube.mesh, TestFixture::exact(scene.cube.rest), stored);
    EXPECT_LE(TestFixture::largest_difference(f, expected), limit);
  }
}

TYPED_TEST_P(Kernels, both_forms_of_the_force_differential_equal_the_difference_of_forces) {
  using reference::Long;
  typename TestFixture::Scene scene(5);
  scene.run_all(this->model);
  const auto dx = TestFixture::vectors(scene.download(scene.displacements), [](auto node) { return node.dx().get(); });
  const auto rest = TestFixture::exact(scene.cube.rest), x = TestFixture::exact(scene.cube.deformed);
  const auto expected = reference::derivative(
      [&](Long h) {
        std::vector<reference::Vec> there = x;
        for (std::size_t n = 0; n < x.size(); ++n) there[n] += h * dx[n];
        return reference::forces(this->model, scene.cube.mesh, rest, there);
      },
      1e-5L);
  const auto df = [](auto node) { return node.df().get(); };
  const auto assembled = TestFixture::vectors(scene.download(scene.assembled), df);
  const auto matrix_free = TestFixture::vectors(scene.download(scene.matrix_free), df);
  const double scale = TestFixture::largest(expected);
  // The difference of forces itself is good to about 1e-13.
  const double limit = (32 * TestFixture::eps + 1e-12) * scale;
  EXPECT_LE(TestFixture::largest_difference(assembled, expected), limit);
  EXPECT_LE(TestFixture::largest_difference(matrix_free, expected), limit);
  EXPECT_LE(TestFixture::largest_difference(assembled, matrix_free), 32 * TestFixture::eps * scale);
}

TYPED_TEST_P(Kernels, force_differentials_sum_to_zero_and_are_symmetric) {
  typename TestFixture::Scene scene(5);
  scene.run_all(this->model);
  const auto dx_of = [](auto node) { return node.dx().get(); };
  const auto df_of = [](auto node) { return node.df().get(); };
  const auto a = TestFixture::vectors(scene.download(scene.displacements), dx_of);
  const auto Ka = TestFixture::vectors(scene.download(scene.assembled), df_of);
  const double scale = TestFixture::largest(Ka);
  EXPECT_LE(double(TestFixture::total(Ka).norm()), 16 * TestFixture::eps * scale * double(a.size()));

  auto other = scene.download(scene.displacements);
  reference::Random random(8);
  for (index_t n = 0; n < other.size(); ++n) {
    for (int k = 0; k < 3; ++k) other.view()[n].dx()[k] = typename TypeParam::Real(random.normal());
  }
  copy(scene.displacements, other);
  const auto b = TestFixture::vectors(other, dx_of);
  scene.run_all(this->model);
  const auto Kb = TestFixture::vectors(scene.download(scene.assembled), df_of);
  reference::Long ab = 0, ba = 0;
  for (std::size_t n = 0; n < a.size(); ++n) ab += a[n].dot(Kb[n]), ba += b[n].dot(Ka[n]);
  EXPECT_NEAR(double(ab), double(ba), 16 * TestFixture::eps * scale * std::sqrt(double(a.size())) * 3);
}

TYPED_TEST_P(Kernels, flattened_and_inverted_elements_have_finite_forces) {
  typename TestFixture::Scene scene(3);
  for (const double height : {0., -1., -0.3}) {
    scene.set_positions(scene.positions,
                        TestFixture::moved(scene.cube.rest, Eigen::Vector3d(1, 1, height).asDiagonal(), {0, 0, 0}));
    scene.run_all(this->model);
    for (const auto& f : TestFixture::vectors(scene.download(scene.forces), [](auto node) { return node.f().get(); })) {
      ASSERT_TRUE(f.allFinite());
    }
    for (const auto& df : TestFixture::vectors(scene.download(scene.assembled), [](auto n) { return n.df().get(); })) {
      ASSERT_TRUE(df.allFinite());
    }
  }
}

TYPED_TEST_P(Kernels, give_the_same_bits_on_every_run) {
  typename TestFixture::Scene scene(5);
  const auto bits = [&scene](const auto& array) {
    const auto host = scene.download(array);
    const auto* bytes = reinterpret_cast<const char*>(host.view().data());
    return std::vector<char>(bytes, bytes + host.size() * host.record_bytes);
  };
  const auto all = [&] {
    scene.run_all(this->model);
    return std::vector<std::vector<char>>{bits(scene.svd),           bits(scene.stress),    bits(scene.derivative),
                                          bits(scene.forces),        bits(scene.assembled), bits(scene.matrix_free),
                                          bits(scene.edge_stiffness)};
  };
  const auto first = all();
  EXPECT_EQ(first, all());
}

REGISTER_TYPED_TEST_SUITE_P(Kernels, give_the_same_bits_on_every_run,
                            deformation_gradient_of_an_affine_motion_is_its_matrix,
                            svd_reproduces_the_deformation_gradient_with_rotations,
                            stress_and_its_differential_agree_with_the_textbook,
                            forces_agree_with_the_textbook_and_sum_to_zero, a_rigid_motion_gives_no_force,
                            both_forms_of_the_force_differential_equal_the_difference_of_forces,
                            force_differentials_sum_to_zero_and_are_symmetric,
                            flattened_and_inverted_elements_have_finite_forces);

}  // namespace physgen::fem
