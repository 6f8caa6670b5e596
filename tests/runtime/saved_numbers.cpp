// Saves numbers that a test in Python knows, in six formats, to the file that it is given.
#include <everything.physgen.h>
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
  tissue::model::MarksArray<float> marks(70);
  for (index_t i = 0; i < marks.size(); ++i) {
    marks[i].key() = (std::uint64_t{1} << 63) + static_cast<std::uint64_t>(i);
    marks[i].alive() = i % 3 == 0;
    marks[i].counts()(1, 0) = -i;
  }
  save(argv[1], {{"numbers", numbers}, {"tets", tets}, {"marks", marks}});
}
