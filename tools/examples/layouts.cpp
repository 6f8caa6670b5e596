// What `tools/dev try` runs behind README's example: its kernel, and one that gathers, over its object in three
// layouts; and where the elements of that object lie in each. The example's files are taken from README when they are
// compiled.
#include <elasticity.physgen.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#pragma GCC diagnostic ignored "-Wreturn-type"  // of the function that was main()
#define main main_of_the_example
#include "pressure.cpp"  // README's
#undef main

namespace {

using namespace physgen;

/// The mean pressure at the corners of tets, which is read where the corners' numbers say.
template <class Stress, class Tets, class Means>
struct MeanOfCorners {
  using Scalar = typename Stress::Precision;
  Stress stress;
  Tets tets;
  Means means;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    S sum(0);
    for (int corner = 0; corner < 4; ++corner) {
      const auto value = stress.get(tets[i].nodes()[corner]);
      sum += value.sigma.trace() + value.pressure;
    }
    means[i].pressure() = sum * S(0.25F);
  }
};

constexpr index_t objects = 1'000'000;

/// The shortest of some runs [ms].
template <class Run>
double milliseconds(const Run& run) {
  double shortest = 1e9;
  for (int repetition = 0; repetition < 7; ++repetition) {
    const auto begin = std::chrono::steady_clock::now();
    run();
    shortest =
        std::min(shortest, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  return shortest;
}

struct Times {
  double in_order, gathered;  ///< [ms]
};

template <class Layout>
Times measure(const elasticity::TetArray<float, Host, Layout>& tets) {
  model::StressArray<float, Host, Layout> stress(objects), means(objects);
  const Pressure<typename decltype(stress)::View> pressure{stress.view()};
  const MeanOfCorners mean{stress.const_view(), tets.const_view(), means.view()};
  return {milliseconds([&] { parallel_for(Host{}, objects, pressure); }),
          milliseconds([&] { parallel_for(Host{}, objects, mean); })};
}

template <class Layout>
Times measure(const std::vector<std::int32_t>& corners) {
  elasticity::TetArray<float, Host, Layout> tets(objects);
  const auto view = tets.view();
  for (index_t i = 0; i < objects; ++i) {
    for (int corner = 0; corner < 4; ++corner)
      view[i].nodes()[corner] = corners[static_cast<std::size_t>(4 * i + corner)];
  }
  return measure<Layout>(tets);
}

/// A line of the picture: which element of which object each of the first places of memory holds.
template <class Layout>
void draw(const char* name) {
  constexpr int places = 12;
  std::vector<std::string> drawn(places, ".");
  const model::StressArray<float, Host, Layout> array(40);
  const UntypedArray untyped = array.untyped();
  for (index_t i = 0; i < untyped.size; ++i) {
    for (const FieldInfo& field : untyped.fields) {
      for (int k = 0; k < field.count; ++k) {
        const int size = element_bytes(field.type);
        const index_t place = (untyped.address(i, field.offset + k * size, size) - untyped.base) / size;
        if (place >= places) continue;
        const std::string element = field.name == "sigma" ? std::string{"s"} + std::to_string(k) : std::string{"p"};
        drawn[static_cast<std::size_t>(place)] = std::to_string(i) + "." + element;
      }
    }
  }
  std::printf("  %-17s", name);
  for (const std::string& place : drawn) std::printf(" %5s", place.c_str());
  std::puts("  ...");
}

void print(const char* layout, double time, const char* sentence) {
  std::printf("  %-17s%7.2f ms  %s\n", layout, time, sentence);
}

}  // namespace

int main() {
  std::vector<std::int32_t> corners(4 * objects);
  std::iota(corners.begin(), corners.end(), 0);
  for (std::int32_t& corner : corners) corner %= objects;
  std::shuffle(corners.begin(), corners.end(), std::mt19937(1));  // NOLINT: the same each time
  const Times structs = measure<Aos>(corners), arrays = measure<Soa>(corners), tiles = measure<Aosoa<16>>(corners);

  std::printf("README's kernel, which reads %d objects in order and writes one field of each:\n", int{objects});
  print("array of structs", structs.in_order,
        "Each object lies in 28 bytes of its own, and packs pick its elements apart.");
  print("struct of arrays", arrays.in_order, "Packs load whole registers; seven streams of memory are read at once.");
  print("tiles of 16", tiles.in_order, "Packs load whole registers, and all elements of 16 objects lie in 448 bytes.");
  std::puts("\nA kernel that gathers four objects by numbers in random order:");
  print("array of structs", structs.gathered, "An object comes with one or two lines of cache.");
  print("struct of arrays", arrays.gathered, "An object comes with seven lines, one for each element.");
  print("tiles of 16", tiles.gathered,
        "Seven lines lie side by side; an address takes more steps: tile, channel, lane.");
  std::puts("\nMemory from its beginning: 1.s0 is the first element of sigma of object 1, and p is the pressure.");
  draw<Aos>("array of structs");
  draw<Soa>("struct of arrays");
  draw<Aosoa<2>>("tiles of 2");
  return 0;
}
