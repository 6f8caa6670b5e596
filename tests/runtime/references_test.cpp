// References: expressions over them give the same for one object, a pack and any storage format.
// reference_rules_test.cpp says which expressions compile.
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "in_packs.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

using elasticity::NodePositionArray;

/// A field stored in four times its own size.
struct Halves : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Half<>;
  using x2211 = format::Half<2>;
  using x3311 = format::Float64;
  using x2222 = format::Bfloat16;
  using x2121 = format::Half<>;
  using x2112 = format::Half<>;
};

/// Every operator of an element, on values that all formats here hold exactly.
template <class View>
struct ElementExpressions {
  using Scalar = typename View::Precision;
  View view;

  template <class I>
  void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using std::swap;
    const S m = view[i].x1111();
    view[i].x2211() = view[i].x1111() * S(Scalar(2)) + Scalar(1);
    view[i].x3311() = view[i].x1111() + view[i].x2211() - m / S(Scalar(4));
    view[i].x2222() = -view[i].x1111();
    view[i].x2222() += S(Scalar(3));
    view[i].x2222() -= m;
    view[i].x2222() *= S(Scalar(2));
    view[i].x2222() /= S(Scalar(4));
    swap(view[i].x2121(), view[i].x2112());
    const auto large = view[i].x1111() > S(Scalar(2));
    store_where(large && !(view[i].x1111() >= S(Scalar(4))), view[i].x3232(), S(Scalar(7)));
    view[i].x3131() = view[i].x3311();
  }
};

template <class Formats>
void check_element_expressions(int lanes) {
  for (const index_t n : {1, 5, 16, 33}) {
    Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, Formats> array(n);
    const auto view = array.view();
    for (index_t i = 0; i < n; ++i) {
      view[i].x1111() = static_cast<float>(i % 8);
      view[i].x2121() = 1.0F;
      view[i].x2112() = 2.0F;
    }
    const ElementExpressions<decltype(array.view())> kernel{view};
    if (lanes == 1) {
      parallel_for(Host{}, n, physgen::lanes<1>(kernel));
    } else {
      parallel_for(Host{}, n, in_packs(kernel));
    }
    for (index_t i = 0; i < n; ++i) {
      const auto m = static_cast<float>(i % 8);
      const auto found = array.view().get(i);
      ASSERT_EQ(found.x2211, 2 * m + 1) << "object " << i << " of " << n;
      ASSERT_EQ(found.x3311, m + (2 * m + 1) - m / 4);
      ASSERT_EQ(found.x2222, (3 - 2 * m) / 2);
      ASSERT_EQ(found.x2121, 2.0F);
      ASSERT_EQ(found.x2112, 1.0F);
      ASSERT_EQ(found.x3232, m > 2 && m < 4 ? 7.0F : 0.0F);
      ASSERT_EQ(found.x3131, found.x3311);
    }
  }
}

/// A format of a program's own, exact for the numbers here.
struct Shifted {
  static constexpr const char* name = "shifted";
  template <class Real>
  using Stored = double;
  template <class Real>
  static constexpr ElementType type = ElementType::float64;
  static constexpr double scale = 1, centre = 0;
  template <class Real>
  PHYSGEN_FUNCTION static Real decode(double stored) {
    return static_cast<Real>(stored - 64);
  }
  template <class Real>
  PHYSGEN_FUNCTION static double encode(Real value) {
    return static_cast<double>(value) + 64;
  }
};
struct Own : Halves {
  using x1111 = Shifted;
  using x2222 = Shifted;
  using x3232 = Shifted;
  using x2112 = Shifted;
  using x2121 = Shifted;
};

TEST(ElementReferences, calculate_alike_in_all_formats_for_one_object_and_packs) {
  for (const int lanes : {1, 0}) {
    check_element_expressions<elasticity::StressDerivativeFormats<Host>>(lanes);
    check_element_expressions<Halves>(lanes);
    check_element_expressions<Own>(lanes);
  }
}

struct HalfPositions : elasticity::NodePositionFormats<Host> {
  using x = format::Half<>;
};

struct OwnPositions : elasticity::NodePositionFormats<Host> {
  using x = Shifted;
};

template <class View>
struct FieldExpressions {
  using Scalar = typename View::Precision;
  View to, from;

  template <class I>
  void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector x = from[i].x();
    to[i].x() = from[i].x();
    to[i].x() += x;
    to[i].x() *= S(Scalar(4));
    to[i].x() -= Vector(x * Scalar(2));
    to[i].x() /= S(Scalar(2));
    to[i].x()[1] += from[i].x()[0];
    swap(to[i].x(), from[i].x());
  }
};

template <class Formats, int kLanes>
void check_field_expressions() {
  using Positions = Array<elasticity::NodePositionObject, float, Host, Aos, Formats>;
  Positions to(21), from(21);
  for (index_t i = 0; i < 21; ++i) {
    const auto k = static_cast<float>(i % 4);
    from.view()[i].x() = Eigen::Vector3f(k, k + 1, -k);
  }
  constexpr int width = kLanes == 0 ? detail::pack_lanes<float>() : kLanes;
  parallel_for(Host{}, 21, lanes<width>(FieldExpressions<typename Positions::View>{to.view(), from.view()}));
  for (index_t i = 0; i < 21; ++i) {
    const auto k = static_cast<float>(i % 4);
    const Eigen::Vector3f start(k, k + 1, -k), kept = to.view()[i].x(), made = from.view()[i].x();
    ASSERT_EQ(kept, start) << i;
    ASSERT_EQ(made, Eigen::Vector3f(3 * k, 3 * (k + 1) + k, -3 * k)) << i;
  }
}

TEST(FieldReferences, calculate_alike_in_all_formats_for_one_object_and_packs) {
  check_field_expressions<elasticity::NodePositionFormats<Host>, 0>();
  check_field_expressions<elasticity::NodePositionFormats<Host>, 1>();
  check_field_expressions<HalfPositions, 0>();
  check_field_expressions<HalfPositions, 1>();
  check_field_expressions<OwnPositions, 0>();
  check_field_expressions<OwnPositions, 1>();
}

TEST(FieldReferences, are_set_to_zero_and_to_the_identity) {
  NodePositionArray<double> positions(2);
  elasticity::DeformationSvdArray<double> svd(2);
  positions.view()[1].x() = Eigen::Vector3d(1, 2, 3);
  svd.view()[1].U() = Eigen::Matrix3d(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()));
  positions.view()[1].x().setZero();
  svd.view()[1].U().setIdentity();
  EXPECT_EQ(positions.view()[1].x().get(), Eigen::Vector3d::Zero());
  EXPECT_EQ(svd.view()[1].U().get(), Eigen::Matrix3d::Identity());
}

TEST(ObjectReferences, assignment_copies_and_swap_exchanges_objects) {
  elasticity::DeformationSvdArray<float> array(5);
  elasticity::DeformationSvdArray<float, Host, Soa> other(5);
  const auto view = array.view();
  for (index_t i = 0; i < 5; ++i) {
    view[i].s() = Eigen::Vector3f::Constant(static_cast<float>(i));
    other.view()[i].s() = Eigen::Vector3f::Constant(static_cast<float>(10 + i));
  }
  view[3] = view[4];
  EXPECT_EQ(view[3].s()[1], 4.0F);
  const auto first = view[0];
  first = view[2];
  EXPECT_EQ(view[0].s()[2], 2.0F);
  view[1] = other.const_view()[1];
  EXPECT_EQ(view[1].s()[0], 11.0F);
  swap(view[1], view[4]);
  EXPECT_EQ(view[4].s()[0], 11.0F);
  EXPECT_EQ(view[1].s()[0], 4.0F);
  swap(view[1].s(), view[2].s());
  EXPECT_EQ(view[2].s()[0], 4.0F);
  EXPECT_EQ(view[1].s()[0], 2.0F);
}

TEST(ObjectReferences, values_of_them_are_taken_apart_by_structured_bindings) {
  elasticity::DeformationSvdArray<float, Host, Soa> array(3);
  array[1].s() = Eigen::Vector3f(1, 2, 3);
  auto [U, V, s] = array[1].get();
  const auto& [of_view, ignored, kept] = array.view().get(1);
  array[1].s() = Eigen::Vector3f::Zero();
  s *= 2;
  EXPECT_EQ(s, Eigen::Vector3f(2, 4, 6));
  EXPECT_EQ(kept, Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(U, V);
  EXPECT_EQ(of_view, ignored);
  float sum = 0;
  for (auto object : array) {
    const auto [turn, other, stretch] = object.get();
    sum += turn.trace() + other.trace() + stretch.sum();
  }
  EXPECT_EQ(sum, 18);
}

}  // namespace
}  // namespace physgen::test
