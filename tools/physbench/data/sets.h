// The three sets of inputs on which errors are measured beside speed. Seeded, so the same in every run.
#pragma once

#include <fem/numerics/scalar.h>
#include <physgen/config.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "data/kept.h"

namespace physgen::bench {

enum class InputSet {
  random,     ///< F = I + 0.3 N(0,1)
  near_rest,  ///< F = Q (I + 1e-4 N(0,1)), Q a rotation
  hard        ///< F from reference::hard_matrices() in turn, those of the storage's precision
};
inline constexpr std::array<InputSet, 3> input_sets{InputSet::random, InputSet::near_rest, InputSet::hard};

/// "random", "near_rest", "hard"
[[nodiscard]] const char* name(InputSet set);

/// Deformation gradients of one set. Members of `hard` whose Frobenius norm is not in the bounds are passed over.
template <class Real>
[[nodiscard]] std::vector<fem::Matrix3<Real>> deformations(InputSet set, index_t count, double smallest_norm,
                                                           double largest_norm);
/// dF for each F: Gaussian, of about its norm.
template <class Real>
[[nodiscard]] std::vector<fem::Matrix3<Real>> differentials(const std::vector<fem::Matrix3<Real>>& deformations);

/// The data that problems make of the sets, kept by name. Rows have `objects` objects, of which the first samples()
/// differ; the others repeat them.
class SampleSets : public Kept {
 public:
  explicit SampleSets(index_t objects) : objects_(objects) {}
  [[nodiscard]] index_t objects() const { return objects_; }
  [[nodiscard]] index_t samples() const { return std::min(objects_, most_samples); }

 private:
  static constexpr index_t most_samples = 65536;  // references are computed one by one in long double

  index_t objects_;
};

/// The sets of so many objects that rows share.
[[nodiscard]] inline std::shared_ptr<SampleSets> sets_of(index_t objects) { return shared<SampleSets>(objects); }

}  // namespace physgen::bench
