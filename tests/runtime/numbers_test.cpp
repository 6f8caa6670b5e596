// Plain numbers beside those of objects: what compiles has the same bits for one object and in packs.
#include <elasticity.physgen.h>
#include <gtest/gtest.h>
#include <physgen/parallel_for.h>

#include <bit>

#include "test_objects.h"

namespace physgen::test {
namespace {

#pragma GCC diagnostic ignored "-Wconversion"        // integers that a float rounds
#pragma GCC diagnostic ignored "-Wfloat-conversion"  // doubles that become floats
template <class InView, class OutView>
struct Mix {
  using Scalar = typename InView::Precision;
  InView in;
  OutView out;
  int seven = 7, beyond_floats = 16777217;
  index_t many = 1234567890123;
  float tenth = 0.1F;

  template <class I>
  void operator()(I i) const {
    using namespace math;
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const S r = in[i].x1111(), s = in[i].x2211();
    out[i].x1111() = r * beyond_floats;
    out[i].x2211() = many - r;
    out[i].x3311() = r / 3U;
    out[i].x2222() = select(r > 1, max(r, 0.1), min(s, -0.3));
    out[i].x3322() = select(s < tenth, clamp(r, -0.3, 0.7), 0.1);
    out[i].x3333() = pow(abs(s), 0.3);
    out[i].x2121() = (Vector(r, s, r) * 0.1)[1];
    out[i].x2112() = tenth / in[i].x1111();
    out[i].x3131() = 0.1;
    out[i].x3113() = r;
    out[i].x3113() += beyond_floats;
    out[i].x3223() = s;
    out[i].x3223() *= tenth;
  }
};

template <class Real>
void check_mixes() {
  std::mt19937 random(seed());
  std::uniform_real_distribution<Real> value(-3, 3);
  const index_t n = 1003;
  elasticity::StressDerivativeArray<Real> in(n), one_by_one(n), in_packs(n);
  for (index_t i = 0; i < n; ++i) {
    in.view()[i].x1111() = value(random);
    in.view()[i].x2211() = value(random);
  }
  using Kernel = Mix<decltype(in.const_view()), decltype(in.view())>;
  parallel_for(Host{}, n, lanes<1>(Kernel{in.const_view(), one_by_one.view()}));
  parallel_for(Host{}, n, Kernel{in.const_view(), in_packs.view()});
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  for (index_t i = 0; i < n; ++i) {
    for (int e = 0; e < 12; ++e) {
      ASSERT_EQ(std::bit_cast<Bits>(static_cast<Real>(one_by_one.getdata(i, e))),
                std::bit_cast<Bits>(static_cast<Real>(in_packs.getdata(i, e))))
          << "element " << e << " of object " << i;
    }
  }
}

TEST(PlainNumbers, have_the_same_bits_beside_one_object_and_in_packs) {
  check_mixes<float>();
  check_mixes<double>();
}

}  // namespace
}  // namespace physgen::test
