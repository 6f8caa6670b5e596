// Checks of storage formats over arrays, the same for every space: what is copied between formats and layouts, and what
// is read back.
#pragma once

#include <elasticity.physgen.h>

#include <Eigen/Geometry>

#include "test_objects.h"

namespace physgen::test {

/// The SVD with rotations as quaternions and halves for stretches.
template <class Component>
struct CompactSvd : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<Component>;
  using V = format::Quaternion<Component>;
  using s = format::Half<>;
};

/// Elements of every size in one record: 8, 4 and 2 bytes.
struct MixedDerivative : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Half<>;
  using x2211 = format::Float64;
  using x3311 = format::Bfloat16;
  using x2222 = format::Float32;
  using x3322 = format::Snorm16<format::Interval{-2.0, 2.0}>;
  using x3333 = format::Half<3>;
};

/// Worst error of element k of MixedDerivative for values up to 2. Halves below 2^-14, times their scale, are
/// subnormal.
inline double mixed_error(int k, double value) {
  switch (k) {
    case 0:
      return std::max(0x1p-11 * std::abs(value), 0x1p-25);
    case 2:
      return 0x1p-8 * std::abs(value);
    case 4:
      return 4.0 / 131068 + 2 * 0x1p-23;  // half a step, and the rounding of float
    case 5:
      return std::max(0x1p-11 * std::abs(value), 8 * 0x1p-25);
    default:
      return 0x1p-24 * std::abs(value);
  }
}

inline Eigen::Matrix3d random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

/// Objects of the mixed format that come back from `Space` and `Layout` within the formats' errors, and the very bits
/// where they come back in the format they have there.
template <class Space, class Layout>
void check_mixed_round_trip(index_t n) {
  std::mt19937 random(seed());
  std::uniform_real_distribution<float> value(-2.0F, 2.0F);
  elasticity::StressDerivativeArray<float, Host, Soa> source(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) source.putdata(i, k, value(random));
  }
  Array<elasticity::StressDerivativeObject, float, Space, Layout, MixedDerivative> stored(n);
  copy(stored, source);
  elasticity::StressDerivativeArray<double, Host, Aos> back(n);
  poison(back);
  copy(back, stored);
  synchronize();
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) {
      const double expected = source.getdata(i, k);
      ASSERT_NEAR(back.getdata(i, k), expected, mixed_error(k, expected)) << "object " << i << " element " << k;
    }
  }
  Array<elasticity::StressDerivativeObject, float, Host, Aosoa<8>, MixedDerivative> same(n);
  copy(same, stored);
  Array<elasticity::StressDerivativeObject, float, Space, Layout, MixedDerivative> again(n);
  copy(again, same);
  Array<elasticity::StressDerivativeObject, float, Host, Aos, MixedDerivative> first(n), second(n);
  copy(first, stored);
  copy(second, again);
  synchronize();
  EXPECT_EQ(count_different(first, second), 0);
}

/// Rotations that go through quaternions: near the original, and orthogonal to a few eps whatever the components.
template <class Space, class Layout, class Component>
void check_rotations(index_t n, double entry_error) {
  std::mt19937 random(seed());
  elasticity::DeformationSvdArray<float, Host, Aosoa<16>> source(n), back(n);
  for (index_t i = 0; i < n; ++i) {
    elasticity::DeformationSvd<float> svd;
    svd.U = random_rotation(random).cast<float>();
    svd.V = random_rotation(random).cast<float>();
    svd.s = Eigen::Vector3f(1.5F, 1.0F, 0.5F);
    source.view().put(i, svd);
  }
  Array<elasticity::DeformationSvdObject, float, Space, Layout, CompactSvd<Component>> stored(n);
  copy(stored, source);
  copy(back, stored);
  synchronize();
  for (index_t i = 0; i < n; ++i) {
    const auto expected = source.view().get(i), got = back.view().get(i);
    ASSERT_LE((got.U - expected.U).cwiseAbs().maxCoeff(), entry_error) << i << "\n" << got.U << "\n\n" << expected.U;
    ASSERT_LE((got.V - expected.V).cwiseAbs().maxCoeff(), entry_error) << i;
    ASSERT_LE((got.U.transpose() * got.U - Eigen::Matrix3f::Identity()).cwiseAbs().maxCoeff(), 2e-6F) << i;
    ASSERT_EQ(got.s, expected.s) << i;  // halves hold these
  }
}

/// The losses of a copy are counted on the side where the values lie.
template <class Space>
void check_losses() {
  elasticity::StressDerivativeArray<float, Host, Aos> values(100);
  for (index_t i = 0; i < values.size(); ++i) {
    for (int k = 0; k < values.elements; ++k) values.putdata(i, k, 1);
  }
  values.putdata(17, 0, 1e6);                                       // beyond half
  values.putdata(18, 4, 2.5);                                       // beyond the range of Snorm16 over [-2, 2]
  values.putdata(19, 4, std::numeric_limits<double>::quiet_NaN());  // which it keeps, but no solver wants
  values.putdata(20, 2, 1e30);                                      // which bfloat16 holds
  values.putdata(21, 0, 1e-7);                                      // a half with one bit left
  elasticity::StressDerivativeArray<float, Space, Soa> from(values.size());
  copy(from, values);
  const Array<elasticity::StressDerivativeObject, float, Space, Aosoa<32>, MixedDerivative> to(values.size());
  const Losses losses = losses_of_copy(to.untyped(), from.untyped());
  EXPECT_EQ(losses.out_of_range, 2U);
  EXPECT_EQ(losses.not_a_number, 1U);
  EXPECT_EQ(losses.imprecise, 1U);
  EXPECT_EQ(losses.falsified(), 3U);
  const std::string message = message_of([&] { throw_if_falsified(losses, to.untyped()); });
  EXPECT_NE(message.find("3 values (2 out of range, 1 NaN or infinite, 0 not rotations)"), std::string::npos)
      << message;

  elasticity::DeformationSvdArray<float, Host, Aos> svds(3);
  for (index_t i = 0; i < 3; ++i)
    svds.view().put(i, {Eigen::Matrix3f::Identity(), Eigen::Matrix3f::Identity(), {1, 1, 1}});
  svds.view()[1].V() = 1.1F * Eigen::Matrix3f::Identity();
  elasticity::DeformationSvdArray<float, Space, Soa> svds_there(3);
  copy(svds_there, svds);
  const Array<elasticity::DeformationSvdObject, float, Space, Soa, CompactSvd<format::Native>> compact(3);
  const Losses not_rotations = losses_of_copy(compact.untyped(), svds_there.untyped());
  EXPECT_EQ(not_rotations.not_a_rotation, 1U);
  EXPECT_EQ(not_rotations.first.object, 1);
}

}  // namespace physgen::test
