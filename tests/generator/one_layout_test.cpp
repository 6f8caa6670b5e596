// Headers that physgen_generate(... LAYOUT ...) has written: the arrays of every object have that layout unless their
// program names another, and what is stored is read back. Compiled once for each layout.
#include <gtest/gtest.h>
#include <particles.physgen.h>
#include <physgen/device.h>

#include <type_traits>

namespace physgen {
namespace {

#if defined(PHYSGEN_EXPECTED_aos)
using OnHost = Aos;
using OnCuda = Aos;
#elif defined(PHYSGEN_EXPECTED_aos_padded)
using OnHost = AosPadded;
using OnCuda = AosPadded;
#elif defined(PHYSGEN_EXPECTED_soa)
using OnHost = Soa;
using OnCuda = Soa;
#elif defined(PHYSGEN_EXPECTED_aosoa)
using OnHost = Aosoa<16>;
using OnCuda = Aosoa<32>;
#endif

template <class Array>
using LayoutOf = typename Array::Layout;

TEST(OneLayout, is_that_of_the_arrays_of_every_object) {
  static_assert(std::is_same_v<LayoutOf<particles::SpinArray<float>>, OnHost>);
  static_assert(std::is_same_v<LayoutOf<particles::ParticleArray<double>>, OnHost>);
  static_assert(std::is_same_v<LayoutOf<particles::SpinArray<float, Cuda>>, OnCuda>);
  static_assert(std::is_same_v<LayoutOf<particles::ParticleArray<float, Cuda>>, OnCuda>);
  static_assert(std::is_same_v<LayoutOf<particles::ParticleArray<float, Host, Aosoa<8>>>, Aosoa<8>>);
}

TEST(OneLayout, keeps_what_is_stored) {
  constexpr index_t count = 37;  // no whole tile
  particles::ParticleArray<float> array(count);
  const auto value = [](index_t i, int k) { return static_cast<float>(100 * i + k); };
  for (index_t i = 0; i < count; ++i) {
    const auto particle = array.view()[i];
    particle.kind() = static_cast<int>(i);
    for (int k = 0; k < 3; ++k) {
      particle.x()[k] = value(i, k);
      particle.spins(1).rate()[k] = value(i, 10 + k);
    }
  }
  particles::ParticleArray<float, Host, Aosoa<4>> tiles(count);
  copy(tiles, array);
  synchronize();
  for (index_t i = 0; i < count; ++i) {
    for (const auto& particle : {array.const_view().get(i), tiles.const_view().get(i)}) {
      EXPECT_EQ(particle.kind, i);
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(particle.x[k], value(i, k));
        EXPECT_EQ(particle.spins[1].rate[k], value(i, 10 + k));
      }
    }
  }
}

}  // namespace
}  // namespace physgen
