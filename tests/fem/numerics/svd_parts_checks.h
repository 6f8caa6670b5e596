// Parts and forms of the SVD: singular values, polar rotation, quaternions, fewer sweeps, and svd(F, U, s, V) over
// whole arrays. Instantiated by svd_test.cpp and svd_gpu_test.cu.
#pragma once

#include <fem/kernels/svd_arrays.h>

#include "svd_checks.h"

namespace physgen::fem {

template <class Case>
class SvdParts : public SvdOf<Case> {
 protected:
  using Real = typename Case::Real;
  using Space = typename Case::Space;
  template <class Object>
  using DeviceArray = typename SvdOf<Case>::template Array<Object, Space>;
  template <class Object>
  using HostArray = typename SvdOf<Case>::template Array<Object, Host>;

  /// Ordinary and hard matrices that are not tiny, so that what is derived from them needs no allowance for underflow.
  static std::vector<Matrix3<Real>> mixed_matrices() {
    reference::Random random(11);
    std::vector<Matrix3<Real>> matrices;
    for (int k = 0; k < 2000; ++k) matrices.push_back(reference::random_deformation(random).template cast<Real>());
    for (const auto& family : reference::hard_matrices(reference::Precision::of<Real>())) {
      const auto members = SvdOf<Case>::members(family, 20, random);
      const double norm = members[0].template cast<double>().norm();
      if (norm > 1e-3 && norm < 1e3) matrices.insert(matrices.end(), members.begin(), members.end());
    }
    return matrices;
  }
  static DeviceArray<elasticity::DeformationGradientObject> upload(const std::vector<Matrix3<Real>>& matrices) {
    HostArray<elasticity::DeformationGradientObject> host(static_cast<index_t>(matrices.size()));
    for (index_t i = 0; i < host.size(); ++i) host.view()[i].F() = matrices[static_cast<std::size_t>(i)];
    DeviceArray<elasticity::DeformationGradientObject> gradients(host.size());
    copy(gradients, host);
    synchronize();
    return gradients;
  }
  template <class Object>
  static HostArray<Object> download(const DeviceArray<Object>& array) {
    HostArray<Object> host(array.size());
    copy(host, array);
    synchronize();
    return host;
  }
};
TYPED_TEST_SUITE_P(SvdParts);

TYPED_TEST_P(SvdParts, singular_values_alone_are_those_of_the_whole_svd) {
  const auto matrices = TestFixture::mixed_matrices();
  const auto gradients = TestFixture::upload(matrices);
  typename TestFixture::template DeviceArray<elasticity::PrincipalStretchesObject> stretches(gradients.size());
  parallel_for(typename TypeParam::Space{}, gradients.size(),
               ComputeSvdParts{gradients.const_view(), skip, stretches.view(), skip});
  const auto expected = TestFixture::decompose(matrices);
  const auto got = TestFixture::download(stretches);
  for (index_t i = 0; i < got.size(); ++i) {
    const auto& s = expected[static_cast<std::size_t>(i)].s;
    ASSERT_LE((got.view()[i].s().get() - s).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>(),
              2 * TestFixture::eps * s[0]);
  }
}

TYPED_TEST_P(SvdParts, polar_rotation_is_a_rotation_and_leaves_a_symmetric_stretch) {
  const auto matrices = TestFixture::mixed_matrices();
  const auto gradients = TestFixture::upload(matrices);
  typename TestFixture::template DeviceArray<elasticity::ElementRotationObject> rotations(gradients.size());
  parallel_for(typename TypeParam::Space{}, gradients.size(),
               ComputePolarRotation{gradients.const_view(), rotations.view()});
  const auto got = TestFixture::download(rotations);
  for (index_t i = 0; i < got.size(); ++i) {
    const Eigen::Matrix3d R = got.view()[i].R().get().template cast<double>();
    const Eigen::Matrix3d A = matrices[static_cast<std::size_t>(i)].template cast<double>();
    ASSERT_LE((R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>(),
              32 * TestFixture::eps);
    ASSERT_NEAR(R.determinant(), 1, 32 * TestFixture::eps);
    const Eigen::Matrix3d stretch = R.transpose() * A;
    ASSERT_LE((stretch - stretch.transpose()).norm(), 48 * TestFixture::eps * A.norm()) << A;
  }
}

TYPED_TEST_P(SvdParts, quaternions_have_unit_length_and_give_the_matrix_back) {
  const auto matrices = TestFixture::mixed_matrices();
  const auto gradients = TestFixture::upload(matrices);
  typename TestFixture::template DeviceArray<elasticity::QuaternionSvdObject> svds(gradients.size());
  parallel_for(typename TypeParam::Space{}, gradients.size(),
               ComputeQuaternionSvd{gradients.const_view(), svds.view()});
  const auto got = TestFixture::download(svds);
  for (index_t i = 0; i < got.size(); ++i) {
    const Quaternion<double> u = got.view()[i].u().get().template cast<double>();
    const Quaternion<double> v = got.view()[i].v().get().template cast<double>();
    const Eigen::Vector3d s = got.view()[i].s().get().template cast<double>();
    const Eigen::Matrix3d A = matrices[static_cast<std::size_t>(i)].template cast<double>();
    ASSERT_NEAR(u.norm(), 1, 4 * TestFixture::eps);
    ASSERT_NEAR(v.norm(), 1, 4 * TestFixture::eps);
    ASSERT_GE(u[0], 0);
    ASSERT_GE(v[0], 0);
    const Eigen::Matrix3d back = rotation_matrix(u) * s.asDiagonal() * rotation_matrix(v).transpose();
    ASSERT_LE((back - A).norm(), 32 * TestFixture::eps * A.norm()) << A;
  }
}

TYPED_TEST_P(SvdParts, quaternions_of_half_turns_are_exact_to_a_few_eps) {
  using Real = typename TypeParam::Real;
  reference::Random random(12);
  for (int k = 0; k < 2000; ++k) {
    const double angle = k % 2 == 0 ? 3.14159265358979323846 : random.uniform(-7, 7);
    const Eigen::Vector3d axis = k < 3 ? Eigen::Vector3d::Unit(k) : random.gaussian().col(0).normalized();
    const Matrix3<Real> R = Eigen::AngleAxisd(angle, axis).toRotationMatrix().template cast<Real>();
    const Quaternion<double> q = unit_quaternion(R).template cast<double>();
    ASSERT_LE((rotation_matrix(q) - R.template cast<double>()).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>(),
              8 * TestFixture::eps);
  }
}

TYPED_TEST_P(SvdParts, arrays_are_decomposed_whole_and_in_part) {
  const auto matrices = TestFixture::mixed_matrices();
  const auto gradients = TestFixture::upload(matrices);
  const index_t n = gradients.size();
  using Rotations = typename TestFixture::template DeviceArray<elasticity::ElementRotationObject>;
  using Stretches = typename TestFixture::template DeviceArray<elasticity::PrincipalStretchesObject>;
  Rotations U(n), V(n), only_u(n), only_v(n);
  Stretches s(n), only_s(n);
  svd(gradients, U, s, V);
  svd(gradients, skip, only_s, skip);
  svd(gradients, only_u, skip, only_v);
  const auto left = TestFixture::download(U), right = TestFixture::download(V);
  const auto left_only = TestFixture::download(only_u), right_only = TestFixture::download(only_v);
  const auto stretches = TestFixture::download(s), stretches_only = TestFixture::download(only_s);
  for (index_t i = 0; i < n; ++i) {
    const auto& A = matrices[static_cast<std::size_t>(i)];
    ASSERT_TRUE(
        TestFixture::accepted(A, {left.view()[i].R().get(), stretches.view()[i].s().get(), right.view()[i].R().get()}));
    ASSERT_TRUE(TestFixture::accepted(
        A, {left_only.view()[i].R().get(), stretches_only.view()[i].s().get(), right_only.view()[i].R().get()}));
  }
}

TYPED_TEST_P(SvdParts, arrays_of_other_sizes_are_refused_and_untouched) {
  const auto gradients = TestFixture::upload(TestFixture::mixed_matrices());
  typename TestFixture::template DeviceArray<elasticity::PrincipalStretchesObject> s(3);
  s.putdata(1, 1, 7);
  try {
    svd(gradients, skip, s, skip);
    FAIL() << "accepted";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("s has 3 objects, F has " + std::to_string(gradients.size())), std::string::npos) << what;
  }
  EXPECT_EQ(s.getdata(1, 1), 7);
}

TYPED_TEST_P(SvdParts, fewer_sweeps_leave_larger_residuals_but_rotations) {
  const auto matrices = TestFixture::mixed_matrices();
  const auto gradients = TestFixture::upload(matrices);
  typename TestFixture::template DeviceArray<elasticity::DeformationSvdObject> svds(gradients.size());
  double worst[2] = {0, 0};
  const auto measure = [&](const auto& kernel, double& residual) {
    parallel_for(typename TypeParam::Space{}, gradients.size(), kernel);
    const auto got = TestFixture::download(svds);
    for (index_t i = 0; i < got.size(); ++i) {
      const auto at = got.view()[i];
      const auto errors = reference::svd_errors<typename TypeParam::Real>(matrices[static_cast<std::size_t>(i)],
                                                                          {at.U(), at.s(), at.V()});
      ASSERT_TRUE(errors.finite);
      ASSERT_LE(errors.orthogonality, 32);
      residual = std::max(residual, errors.residual);
    }
  };
  measure(ComputeSvd{gradients.const_view(), svds.view(), Sweeps<2>{}}, worst[0]);
  measure(ComputeSvd{gradients.const_view(), svds.view(), Sweeps<5>{}}, worst[1]);
  EXPECT_GT(worst[0], 24);
  EXPECT_LE(worst[1], 24);
}

REGISTER_TYPED_TEST_SUITE_P(SvdParts, singular_values_alone_are_those_of_the_whole_svd,
                            polar_rotation_is_a_rotation_and_leaves_a_symmetric_stretch,
                            quaternions_have_unit_length_and_give_the_matrix_back,
                            quaternions_of_half_turns_are_exact_to_a_few_eps, arrays_are_decomposed_whole_and_in_part,
                            arrays_of_other_sizes_are_refused_and_untouched,
                            fewer_sweeps_leave_larger_residuals_but_rotations);

}  // namespace physgen::fem
