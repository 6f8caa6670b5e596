// Material constants and their checks.
#include <fem/materials/material.h>
#include <physgen/error.h>

#include <cmath>
#include <sstream>

namespace physgen::fem {

void refuse_constant(const char* model, const char* constant, double value, const std::string& range) {
  std::ostringstream message;
  message.precision(17);
  message << model << ": " << constant << " = " << value << " is out of range; allowed is " << range;
  throw Error(message.str());
}

void require_constant(const char* model, const char* constant, double value, ConstantSign sign, double smallest,
                      double largest) {
  const double lowest = sign == ConstantSign::Any ? -largest : smallest;
  const bool is_allowed_zero = sign == ConstantSign::PositiveOrZero && value == 0;
  if ((value >= lowest && value <= largest) || is_allowed_zero) return;  // not NaN
  std::ostringstream range;
  range.precision(9);
  if (sign == ConstantSign::PositiveOrZero) range << "0 or ";
  range << lowest << " <= value <= " << largest << " [Pa]";
  refuse_constant(model, constant, value, range.str());
}

LameParameters lame_parameters(double youngs_modulus, double poissons_ratio, const char* model) {
  if (!std::isfinite(youngs_modulus) || youngs_modulus <= 0) {
    refuse_constant(model, "Young's modulus E", youngs_modulus, "0 < E < infinity");
  }
  if (!(poissons_ratio > -1 && poissons_ratio < 0.5)) {
    refuse_constant(model, "Poisson's ratio nu", poissons_ratio, "-1 < nu < 0.5");
  }
  return {youngs_modulus / (2 * (1 + poissons_ratio)),
          youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))};
}

}  // namespace physgen::fem
