// For a test in Python: saves numbers that it knows as .npy files, or loads a folder's and saves them to another one.
#include <everything.physgen.h>
#include <physgen/save_npy.h>

#include <iostream>
#include <string_view>

#include "format_checks.h"

using namespace physgen;

namespace {

using Numbers = Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, test::MixedDerivative>;
using Marks = tissue::model::MarksArray<float, Host, Aosoa<4>>;

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "";
  if (argc == 2) {
    Numbers numbers(1001);
    for (index_t i = 0; i < numbers.size(); ++i) {
      for (int k = 0; k < numbers.elements; ++k)
        numbers.putdata(i, k, static_cast<double>((i * 7 + k) % 128 - 64) / 64);
    }
    Marks marks(70);
    for (index_t i = 0; i < marks.size(); ++i) {
      marks[i].key() = (std::uint64_t{1} << 63) + static_cast<std::uint64_t>(i);
      marks[i].alive() = i % 3 == 0;
      marks[i].counts()(1, 0) = -i;
    }
    elasticity::DeformationSvdArray<float> turns(5);
    turns[2].U() = Eigen::Vector3f(1, -1, -1).asDiagonal();
    save_npy(numbers, folder / "numbers");
    save_npy(marks, folder / "marks");
    save_npy(turns, folder / "turns");
  } else if (argc == 3) {
    Marks marks;
    Numbers numbers(3);
    std::cout << load_npy(folder / "marks", marks).text() << '\n';
    load_npy(folder / "numbers", numbers, {"x1111"});
    save_npy(marks, std::filesystem::path(argv[2]) / "marks");
    save_npy(numbers, std::filesystem::path(argv[2]) / "numbers");
  } else {
    std::cerr << "usage: npy_numbers FOLDER [FOLDER]\n";
    return 2;
  }
}
