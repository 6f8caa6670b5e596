// Saves numbers that a test in Python knows, in six formats, to the file that it is given.
#include <physgen/save.h>

#include <iostream>

#include "format_checks.h"

using namespace physgen;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: saved_numbers FILE\n";
    return 2;
  }
  Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, test::MixedDerivative> numbers(1001);
  for (index_t i = 0; i < numbers.size(); ++i) {
    for (int k = 0; k < numbers.elements; ++k) numbers.putdata(i, k, static_cast<double>((i * 7 + k) % 128 - 64) / 64);
  }
  elasticity::TetArray<float, Host> tets(3);
  for (index_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) tets.putdata(i, k, static_cast<double>(10 * i + k));
  }
  save(argv[1], {{"numbers", numbers}, {"tets", tets}});
}
