// The three sets of inputs on which errors are measured beside speed, and what kernels make of them: inputs with their
// references. Seeded, so the same in every run.
#pragma once

#include <fem/scalar.h>
#include <physgen/config.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <typeinfo>
#include <vector>

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

/// What a problem (see problems.h) has to be solved for, and what is right.
template <class Problem>
struct Samples {
  std::vector<typename Problem::Input> inputs;
  std::vector<typename Problem::Reference> references;
};

/// The samples of all problems, made on first use. Rows have `objects` objects, of which the first samples() differ;
/// the others repeat them.
class InputSets {
 public:
  explicit InputSets(index_t objects) : objects_(objects) {}
  [[nodiscard]] index_t objects() const { return objects_; }
  [[nodiscard]] index_t samples() const { return std::min(objects_, most_samples); }

  template <class Problem>
  const Samples<Problem>& of(InputSet set) {
    auto& slot = made_[typeid(Problem).name() + std::string(name(set))];
    if (!slot) slot = std::make_shared<const Samples<Problem>>(make<Problem>(set));
    return *static_cast<const Samples<Problem>*>(slot.get());
  }

 private:
  static constexpr index_t most_samples = 65536;  // references are computed one by one in long double

  /// Defined in problem.h.
  template <class Problem>
  Samples<Problem> make(InputSet set) const;

  index_t objects_;
  std::map<std::string, std::shared_ptr<const void>> made_;
};

}  // namespace physgen::bench
