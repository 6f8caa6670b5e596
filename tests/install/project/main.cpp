// Computes the energy of springs through the generated classes, in two layouts, and compares it with the known value.
#include <springs.physgen.h>

#include <cmath>
#include <cstdio>

template <class Layout>
double energy(physgen::index_t count) {
  network::SpringArray<float, physgen::Host, Layout> springs(count);
  auto view = springs.view();
  for (physgen::index_t i = 0; i < count; ++i) {
    auto spring = view.get(i);
    spring.stiffness = 2.0F;
    spring.rest_length = 1.0F;
    spring.vector.setZero();
    spring.vector[1] = static_cast<float>(i % 4);
    view.put(i, spring);
  }
  double sum = 0;
  for (physgen::index_t i = 0; i < count; ++i) {
    const auto spring = view.get(i);
    const double stretch = double{spring.vector.norm()} - double{spring.rest_length};
    sum += 0.5 * double{spring.stiffness} * stretch * stretch;
  }
  return sum;
}

int main() {
  // Stretches -1, 0, 1, 2 in turn: energies 1, 0, 1, 4.
  const double aos = energy<physgen::Aos>(4000);
  const double aosoa = energy<physgen::Aosoa<8>>(4000);
  std::printf("energy %g and %g, expected 6000\n", aos, aosoa);
  return std::abs(aos - 6000) < 1e-9 && std::abs(aosoa - 6000) < 1e-9 ? 0 : 1;
}
