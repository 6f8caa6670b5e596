// The pressure of a million stresses by one kernel, in the schema's layout and in two others; the results must have the
// same bits, and be those of a plain loop. Exit status 1 where they are not.
#include <physgen/parallel_for.h>
#include <stress.physgen.h>

#include <cstdio>
#include <vector>

/// pressure = -trace(sigma) / 3.
template <class View>
struct Pressure {
  using Scalar = typename View::Precision;
  View stress;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {  // I: one object, or a SIMD pack of them
    auto value = stress.get(i);
    stress[i].pressure() = value.sigma.trace() * (-1.0F / 3.0F);
  }
};

/// Water at rest, object i at i / 100000 metres of depth, below air of 101325 Pa.
float pressure_at(physgen::index_t i) { return 101325.0F + 0.0980665F * static_cast<float>(i); }

template <class Layout>
std::vector<float> pressures(physgen::index_t size) {
  model::StressArray<float, physgen::Host, Layout> stress(size);
  for (physgen::index_t i = 0; i < size; ++i) stress[i].sigma() = -pressure_at(i) * Eigen::Matrix3f::Identity();
  const auto view = stress.view();
  physgen::parallel_for(physgen::Host{}, size, Pressure<std::remove_const_t<decltype(view)>>{view});
  std::vector<float> result;
  for (physgen::index_t i = 0; i < size; ++i) result.push_back(stress[i].pressure());
  return result;
}

int main() {
  constexpr physgen::index_t size = 1'000'000;
  const std::vector<float> tiles = pressures<physgen::Aosoa<16>>(size);
  const bool same = tiles == pressures<physgen::Aos>(size) && tiles == pressures<physgen::Soa>(size);
  int wrong = 0;
  for (physgen::index_t i = 0; i < size; ++i) {
    const float p = pressure_at(i), plain = (-p + -p + -p) * (-1.0F / 3.0F);
    if (tiles[static_cast<std::size_t>(i)] != plain) ++wrong;
  }
  std::printf("pressure of the first object  %10.1f Pa\n", static_cast<double>(tiles.front()));
  std::printf("pressure of the last object   %10.1f Pa\n", static_cast<double>(tiles.back()));
  std::printf("objects unlike a plain loop's %10d\n", wrong);
  std::printf("aos, soa, aosoa(16)           %s\n", same ? "have the same bits" : "DIFFER");
  return same && wrong == 0 ? 0 : 1;
}
