// particles [POSITIONS.txt]: a dam breaks. Exit status 1 where the water gained energy, or its density is far from
// rest.
#include <cstdio>

#include "particles.h"
int main(int count, char** words) {
#ifdef __CUDACC__
  using Space = physgen::Cuda;
#else
  using Space = physgen::Host;
#endif
  fluid::ParticleArray<float> particles(4096);
  for (int i = 0; i < 4096; ++i) {
    particles[i].x() = Eigen::Vector3f(Eigen::Array3i(i % 16, i / 16 % 16, i / 256).cast<float>() * 0.02F + 0.01F);
  }
  fluid::Fluid<Space> dam{fluid::ParticleArray<float, Space>(4096)};
  copy(dam.particles, particles);
  for (int step = 0; step < 1000; ++step) {
    dam.find_neighbours(step % 10 == 0);
    dam.move();
  }
  copy(particles, dam.particles);
  physgen::synchronize();
  double kinetic = 0, fallen = 0, density = 0, front = 0;
  std::FILE* file = count > 1 ? std::fopen(words[1], "w") : nullptr;
  for (const auto particle : particles) {
    const auto one = particle.get();
    kinetic += 0.5 * static_cast<double>(dam.w.mass * one.v.squaredNorm());
    fallen += static_cast<double>(dam.w.mass * dam.w.gravity * (one.x[2] - 0.16F));
    density += static_cast<double>(one.rho) / 4096;
    front = std::fmax(front, static_cast<double>(one.x[0]));
    if (file != nullptr) std::fprintf(file, "%g %g %g\n", double(one.x[0]), double(one.x[2]), double(one.v.norm()));
  }
  std::printf("neighbours               %10ld\n", static_cast<long>(dam.neighbours.entries().size()));
  std::printf("kinetic energy           %10.3f J\nwork of gravity          %10.3f J\n", kinetic, fallen);
  std::printf("mean density             %10.1f kg/m^3\nfront of the water       %10.3f m\n", density, front);
  return kinetic > 0 && kinetic < fallen && density > 900 && density < 1100 && front > 0.5 ? 0 : 1;
}
