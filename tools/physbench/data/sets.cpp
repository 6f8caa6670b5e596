// Makes the deformation gradients of the sets.
#include "data/sets.h"

#include <fem/reference/matrix_families.h>

namespace physgen::bench {

namespace {

constexpr std::uint64_t seed = 20040827;

std::vector<fem::reference::MatrixFamily> families(InputSet set, const fem::reference::Precision& precision) {
  using fem::reference::RandomMatrices;
  switch (set) {
    case InputSet::random:
      return {{"random", [](RandomMatrices& r) { return fem::reference::random_deformation(r); }}};
    case InputSet::near_rest:
      return {{"near rest", [](RandomMatrices& r) { return fem::reference::deformation_near_rest(r, 1e-4); }}};
    case InputSet::hard:
      break;
  }
  return fem::reference::hard_matrices(precision);
}

}  // namespace

const char* name(InputSet set) {
  return set == InputSet::random ? "random" : set == InputSet::near_rest ? "near_rest" : "hard";
}

template <class Real>
std::vector<fem::Matrix3<Real>> deformations(InputSet set, index_t count, double smallest_norm, double largest_norm) {
  const auto all = families(set, fem::reference::Precision::of<Real>());
  fem::reference::RandomMatrices random(seed + static_cast<std::uint64_t>(set));
  std::vector<fem::Matrix3<Real>> made;
  made.reserve(static_cast<std::size_t>(count));
  for (std::size_t k = 0; made.size() < static_cast<std::size_t>(count); ++k) {
    const fem::Matrix3<Real> F = all[k % all.size()].make(random).template cast<Real>();
    const auto norm = F.template cast<long double>().norm();
    if (set != InputSet::hard || (norm >= smallest_norm && norm <= largest_norm)) made.push_back(F);
  }
  return made;
}

template <class Real>
std::vector<fem::Matrix3<Real>> differentials(const std::vector<fem::Matrix3<Real>>& deformations) {
  fem::reference::RandomMatrices random(seed - 1);
  std::vector<fem::Matrix3<Real>> made;
  made.reserve(deformations.size());
  for (const auto& F : deformations) {
    made.push_back((F.template cast<double>().norm() / 3 * random.gaussian()).template cast<Real>());
  }
  return made;
}

template std::vector<fem::Matrix3<float>> deformations(InputSet, index_t, double, double);
template std::vector<fem::Matrix3<double>> deformations(InputSet, index_t, double, double);
template std::vector<fem::Matrix3<float>> differentials(const std::vector<fem::Matrix3<float>>&);
template std::vector<fem::Matrix3<double>> differentials(const std::vector<fem::Matrix3<double>>&);

}  // namespace physgen::bench
