#include "grading.h"

#include <fem/mesh/graded_cube.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "names.h"

namespace physgen::truthcube {

void check_grading(int cells, double grading) {
  if (!(grading >= 1) || !std::isfinite(grading)) {
    throw Error("--grading " + number(grading) +
                ": the grading is a number from 1 on, for uniform cells; larger ones narrow those at the faces, "
                "and 1.5 is common");
  }
  const auto fits = [cells](double g) { return fem::graded_flatness(cells, g) <= most_flatness; };
  if (fits(grading)) return;
  int hundredths = 100;
  while (fits((hundredths + 1) / 100.0)) ++hundredths;
  throw Error("--grading " + number(grading) + ": the widest of " + std::to_string(cells) +
              " cells along a side would be more than " + number(most_flatness) +
              " times as wide as the narrowest, too flat for the preconditioner; --grading " +
              number(hundredths / 100.0) + " fits");
}

double order_of_errors(double grading) { return std::min(grading, 2.0); }

}  // namespace physgen::truthcube
