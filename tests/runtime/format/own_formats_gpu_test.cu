// Formats of a program's own and scaled ones on the device: in kernels, in copies to and from it, and on it.
#include <physgen/cuda/parallel_for.h>

#include "gpu_fixture.h"
#include "own_formats.h"

namespace physgen::test {
namespace {

class CudaOwnFormats : public GpuTest {};

TEST_F(CudaOwnFormats, are_copied_to_the_device_and_from_it_as_on_the_host) {
  for (const index_t n : {1, 33, 5000}) {
    check_own_formats_elsewhere<Cuda, Soa, OwnDerivative>(n);
    check_own_formats_elsewhere<Cuda, Aosoa<32>, OwnDerivative>(n);
    check_own_formats_elsewhere<Cuda, AosPadded, ScaledDerivative>(n);
    check_own_formats_elsewhere<PinnedHost, Aos, OwnDerivative>(n);
  }
  check_own_formats_elsewhere<Cuda, Aosoa<64>, OwnDerivative>(600000);
  check_own_formats_elsewhere<Cuda, Soa, ScaledDerivative>(600000);
}

/// Twice every element.
template <class View>
struct Twice {
  View values;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    auto value = values.get(i);
    value.x1111 *= 2;
    value.x2211 *= 2;
    value.x3311 *= 2;
    value.x2222 *= 2;
    value.x3322 *= 2;
    value.x3333 *= 2;
    value.x2121 *= 2;
    value.x2112 *= 2;
    value.x3131 *= 2;
    value.x3113 *= 2;
    value.x3232 /= 2;
    values.put(i, value);
  }
};

TEST_F(CudaOwnFormats, mean_in_kernels_on_the_device_what_they_mean_on_the_host) {
  std::mt19937 random(seed());
  constexpr index_t n = 3000;
  elasticity::StressDerivativeArray<float, Host, Aos> source(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) source.putdata(i, k, own_value(k, random));
  }
  Array<OwnObject, float, Host, Aos, OwnDerivative> here(n);
  Array<OwnObject, float, Cuda, Aosoa<32>, OwnDerivative> there(n);
  copy(here, source);
  copy(there, source);
  const Twice<decltype(here)::View> twice{here.view()};
  for (index_t i = 0; i < n; ++i) twice(i);
  parallel_for(Cuda{}, n, Twice<decltype(there)::View>{there.view()});
  synchronize();
  EXPECT_EQ(stored_elements(there), stored_elements(here));
}

TEST_F(CudaOwnFormats, change_on_the_device_where_they_are_the_librarys_and_are_refused_else) {
  std::mt19937 random(seed());
  constexpr index_t n = 3000;
  elasticity::StressDerivativeArray<float, Host, Aos> source(n), back(n), wanted(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) source.putdata(i, k, own_value(k, random));
  }
  elasticity::StressDerivativeArray<float, Cuda, Soa> native(n);
  Array<OwnObject, float, Cuda, Aosoa<32>, ScaledDerivative> scaled(n);
  Array<OwnObject, float, Host, Aos, ScaledDerivative> expected(n);
  copy(native, source);
  copy(scaled, native);
  copy(expected, source);
  EXPECT_EQ(stored_elements(scaled), stored_elements(expected));
  copy(native, scaled);
  copy(back, native);
  copy(wanted, expected);
  synchronize();
  EXPECT_EQ(count_different(back, wanted), 0);
  EXPECT_EQ(losses_of_copy(scaled.untyped(), native.untyped()).falsified(), 0U);

  Array<OwnObject, float, Cuda, Soa, OwnDerivative> own(n);
  Array<OwnObject, float, Cuda, Aosoa<32>, OwnDerivative> same(n);
  copy(own, source);
  copy(same, own);  // another layout changes no element
  EXPECT_EQ(stored_elements(same), stored_elements(own));
  const std::string message = message_of([&] { copy(own, native); });
  EXPECT_NE(message.find("x1111 is stored in a format of the program's own"), std::string::npos) << message;
  EXPECT_EQ(losses_of_copy(own.untyped(), native.untyped()).falsified(), 0U);
}

}  // namespace
}  // namespace physgen::test
