// Numbers that are stored in another unit, or as their distance from a centre.
#include <cmath>

#include "test_objects.h"

namespace physgen::test {
namespace {

TEST(Scaled, keeps_another_unit_in_a_float) {
  using Thousands = format::Scaled<format::Float32, format::Affine{.scale = 1000}>;
  EXPECT_EQ(Thousands::encode<double>(2500.0), 2.5F);
  EXPECT_EQ(Thousands::decode<double>(2.5F), 2500.0);
}

TEST(Scaled, keeps_temperatures_to_a_part_of_their_distance_from_the_centre) {
  using Temperature = format::Scaled<format::Half<>, format::Affine{.centre = 300}>;
  std::mt19937 random(seed());
  std::uniform_real_distribution<double> value(250, 350);
  for (int sample = 0; sample < 10000; ++sample) {
    const double kelvin = value(random);
    const double error = std::abs(Temperature::decode<double>(Temperature::encode<double>(kelvin)) - kelvin);
    ASSERT_LE(error, 0x1p-11 * std::abs(kelvin - 300) + 1e-7) << kelvin;
  }
  EXPECT_EQ(Temperature::decode<double>(Temperature::encode<double>(300)), 300);
}

template <class Base, class Real>
void check_stored_again(Real low, Real high) {
  const auto check = [&]<format::Affine kOf>() {
    using Format = format::Scaled<Base, kOf>;
    std::mt19937 random(seed());
    std::uniform_real_distribution<Real> number(low, high);
    for (int sample = 0; sample < 20000; ++sample) {
      const Real value = number(random);
      const Real stored = Format::template decode<Real>(Format::template encode<Real>(value));
      ASSERT_EQ(Format::template decode<Real>(Format::template encode<Real>(stored)), stored) << value;
      ASSERT_LE(std::abs(stored - value), std::numeric_limits<Real>::epsilon() * std::abs(value));
    }
  };
  check.template operator()<format::Affine{.scale = 1000}>();
  check.template operator()<format::Affine{.scale = 0.3}>();
  check.template operator()<format::Affine{.scale = 1e-6}>();
}

TEST(Scaled, numbers_that_are_read_and_stored_again_stay) {
  check_stored_again<format::Float32>(1.0F, 4000.0F);
  check_stored_again<format::Native>(1.0F, 4000.0F);
  check_stored_again<format::Native>(1.0, 4000.0);
}

using Thousands = format::Scaled<format::Float32, format::Affine{.scale = 1000}>;
struct PositionsInThousands : elasticity::NodePositionFormats<Host> {
  using x = Thousands;
};

TEST(Scaled, copies_store_the_bits_that_accessors_store) {
  constexpr index_t n = 1000;
  elasticity::NodePositionArray<float> plain(n);
  for (index_t i = 0; i < n; ++i) plain.view()[i].x() = Eigen::Vector3f(float(i) * 0.37F, 1.1F, float(i) / 7);
  elasticity::NodePositionArray<float, Host, Soa, PositionsInThousands> copied(n);
  copy(copied, plain);
  for (index_t i = 0; i < n; ++i) {
    const Eigen::Vector3f x = plain.view()[i].x();
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(copied.getdata(i, k), Thousands::decode<double>(Thousands::encode<float>(x[k]))) << i;
    }
  }
}

}  // namespace
}  // namespace physgen::test
