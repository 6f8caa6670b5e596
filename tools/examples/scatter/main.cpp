// A program that allocates its objects one by one, as codes of long standing do: they are gathered into an array, a
// kernel computes there in SIMD packs, and what it computed is scattered back to the objects. Exit status 1 where an
// object has another force than the plain loop over pointers gives.
#include <physgen/gather.h>
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>
#include <spring.physgen.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

using namespace physgen;  // where kernels stand: their words are found for one object and for packs
using namespace physgen::math;

/// The object of the old code. It has more than the kernel wants, and stays as it is.
struct LegacySpring {
  virtual ~LegacySpring() = default;
  const char* name = "spring";
  double edge[3] = {}, length = 1, stiffness = 0, force[3] = {}, energy = 0;

  void update() {  // what the old code called for each
    const double now = std::sqrt(edge[0] * edge[0] + (edge[1] * edge[1] + edge[2] * edge[2])), stretch = now - length;
    for (int k = 0; k < 3; ++k) force[k] = edge[k] * (stiffness * stretch / now);
    energy = 0.5 * stiffness * stretch * stretch;
  }
};

/// The same as a kernel.
template <class View>
struct Update {
  using Scalar = typename View::Precision;
  View springs;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const auto edge = springs[i].edge().get();
    const S now = sqrt(edge.squaredNorm()), stretch = now - springs[i].length();
    const S stiffness = springs[i].stiffness();
    springs[i].f() = edge * S(stiffness * stretch / now);
    springs[i].energy() = S(0.5) * stiffness * stretch * stretch;
  }
};

int main() {
  std::vector<std::unique_ptr<LegacySpring>> owners;
  std::vector<LegacySpring*> springs;
  for (int i = 0; i < 200'000; ++i) {
    auto spring = std::make_unique<LegacySpring>();
    for (int k = 0; k < 3; ++k) spring->edge[k] = 1 + 0.5 * std::sin(0.37 * i + k);
    spring->stiffness = 100 + i % 7;
    springs.push_back(spring.get());
    owners.push_back(std::move(spring));
  }

  using Springs = model::SpringArray<double>;
  Springs array;
  gather(array, springs, [](const LegacySpring& from) {
    Springs::Value value{};
    value.edge = Eigen::Vector3d(from.edge);
    value.length = from.length;
    value.stiffness = from.stiffness;
    return value;
  });
  parallel_for(Host{}, array.size(), Update<Springs::View>{array.view()});
  scatter(springs, array, [](LegacySpring& to, const Springs::Value& value) {
    for (int k = 0; k < 3; ++k) to.force[k] = value.f[k];
    to.energy = value.energy;
  });

  double energy = 0, force = 0, difference = 0;
  for (LegacySpring* spring : springs) {
    const LegacySpring computed = *spring;
    spring->update();
    energy += computed.energy;
    force = std::fmax(force, std::fabs(computed.force[0]));
    for (int k = 0; k < 3; ++k) difference = std::fmax(difference, std::fabs(computed.force[k] - spring->force[k]));
    difference = std::fmax(difference, std::fabs(computed.energy - spring->energy));
  }
  std::printf("objects                        %12zu\n", springs.size());
  std::printf("energy of all                  %12.3f J\n", energy);
  std::printf("largest force along x          %12.4f N\n", force);
  std::printf("largest difference from plain  %12.2e\n", difference);
  return difference <= 1e-12 * force && energy > 0 ? 0 : 1;
}
