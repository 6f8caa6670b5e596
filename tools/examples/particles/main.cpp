// particles [FOLDER]: a dam breaks; FOLDER gets x.npy, v.npy and the other fields. Exit status 1 where the water gained
// energy, or its density is far from rest.
#include <physgen/save_npy.h>

#include <cstdio>

#include "particles.h"
int main(int count, char** words) try {
  fluid::ParticleArray<float> particles(4096);
  for (int i = 0; i < 4096; ++i) {
    particles[i].x() = Eigen::Vector3f(Eigen::Array3i(i % 16, i / 16 % 16, i / 256).cast<float>() * 0.02F + 0.01F);
  }
  fluid::Fluid dam{fluid::ParticleArray<float, fluid::Space>(4096)};
  copy(dam.particles, particles);
  for (int step = 0; step < 1000; ++step) {
    dam.find_neighbours(step % 10 == 0);
    dam.move();
  }
  copy(particles, dam.particles);
  double kinetic = 0, fallen = 0, density = 0, front = 0;
  if (count > 1) save_npy(particles, words[1]);
  for (const auto one : particles) {
    kinetic += 0.5 * double(dam.w.mass * one.v().get().squaredNorm());
    fallen += double(dam.w.mass * dam.w.gravity * (one.x()[2] - 0.16F));
    density += double(one.rho()) / 4096;
    front = std::fmax(front, double(one.x()[0]));
  }
  std::printf("neighbours               %10ld\n", static_cast<long>(dam.neighbours.entries().size()));
  std::printf("kinetic energy           %10.3f J\nwork of gravity          %10.3f J\n", kinetic, fallen);
  std::printf("mean density             %10.1f kg/m^3\nfront of the water       %10.3f m\n", density, front);
  return kinetic > 0 && kinetic < fallen && density > 900 && density < 1100 && front > 0.5 ? 0 : 1;
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
