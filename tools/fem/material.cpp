// Material constants and their checks.
#include <fem/material.h>
#include <physgen/error.h>

#include <cmath>
#include <sstream>

namespace physgen::fem {

namespace {

[[noreturn]] void refuse(const char* model, const char* constant, double value, const char* range) {
  std::ostringstream message;
  message.precision(17);
  message << model << ": " << constant << " = " << value << " is out of range; allowed is " << range;
  throw Error(message.str());
}

}  // namespace

LameParameters lame_parameters(double youngs_modulus, double poissons_ratio, const char* model) {
  if (!std::isfinite(youngs_modulus) || youngs_modulus <= 0) {
    refuse(model, "Young's modulus E", youngs_modulus, "0 < E < infinity");
  }
  if (!(poissons_ratio > -1 && poissons_ratio < 0.5)) {
    refuse(model, "Poisson's ratio nu", poissons_ratio, "-1 < nu < 0.5");
  }
  return {youngs_modulus / (2 * (1 + poissons_ratio)),
          youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))};
}

}  // namespace physgen::fem
