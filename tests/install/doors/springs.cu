// Objects of one's own to a GPU and back, all in one CUDA source: gathered, changed by a kernel, appended and
// scattered. Without a device, the part that works on the host.
#include <physgen/cuda/parallel_for.h>
#include <physgen/gather.h>
#include <physgen/topology.h>
#include <springs.physgen.h>

#include <cstdio>
#include <vector>

struct Mine {
  float stiffness;
};

template <class View>
struct Double {
  View springs;
  PHYSGEN_FUNCTION void operator()(physgen::index_t i) const {
    auto spring = springs.get(i);
    spring.stiffness *= 2.0F;
    springs.put(i, spring);
  }
};

// The sum of all stiffnesses after `change` and a round trip through an array in `Space`.
template <class Space, class Change>
double round_trip(std::vector<Mine> mine, const Change& change) {
  std::vector<Mine*> pointers;
  for (Mine& spring : mine) pointers.push_back(&spring);
  network::SpringArray<float, Space> springs;
  physgen::gather(springs, pointers, [](const Mine& spring) {
    network::Spring<float> value{};
    value.stiffness = spring.stiffness;
    return value;
  });
  change(springs);
  physgen::scatter(pointers, springs,
                   [](Mine& spring, const network::Spring<float>& value) { spring.stiffness = value.stiffness; });
  physgen::append(springs, 2);
  double sum = springs.size() == physgen::index_t(mine.size()) + 2 ? 0.0 : 1.0;
  for (const Mine& spring : mine) sum += spring.stiffness;
  return sum;
}

int main() {
  const std::vector<Mine> mine(20000, Mine{3.0F});
  const double on_host = round_trip<physgen::Host>(mine, [](auto& springs) {
    const auto view = springs.view();
    const Double<std::remove_const_t<decltype(view)>> kernel{view};
    for (physgen::index_t i = 0; i < springs.size(); ++i) kernel(i);
  });
  std::printf("host: %g\n", on_host);
  if (on_host != 120000.0) return 1;
  if (!physgen::cuda_available()) {
    std::printf("no device\n");
    return 0;
  }
  const double on_device = round_trip<physgen::Cuda>(mine, [](auto& springs) {
    using View = std::remove_cvref_t<decltype(springs.view())>;
    physgen::parallel_for(physgen::Cuda{}, springs.size(), Double<View>{springs.view()});
  });
  std::printf("device: %g\n", on_device);
  return on_device == 120000.0 ? 0 : 1;
}
