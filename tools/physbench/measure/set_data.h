// The sets of inputs as provider of a kernel's data, as scene_data.h is for the scene; defined in set_errors.h.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "data/operands.h"
#include "data/sets.h"
#include "measure/row.h"

namespace physgen::bench {

template <class Kernel_, class Real_>
class OnSet {
 public:
  using Kernel = Kernel_;
  using Real = Real_;
  using Inputs = HostArrays<typename Kernel::Reads, Real>;
  using Outputs = HostArrays<typename Kernel::Writes, Real>;
  static constexpr bool errors_in_eps = true;

  OnSet(std::shared_ptr<SampleSets> sets, InputSet set) : sets_(std::move(sets)), set_(set) {}
  [[nodiscard]] index_t objects() const { return sets_->objects(); }
  [[nodiscard]] index_t count(Domain /*domain*/) const { return objects(); }
  [[nodiscard]] index_t results(Domain /*domain*/) const { return sets_->samples(); }
  [[nodiscard]] double bytes() const;  ///< that the kernel must move
  /// Inputs of all objects, and the samples with their references.
  [[nodiscard]] double memory() const { return bytes() + 1024 * static_cast<double>(sets_->samples()); }
  [[nodiscard]] std::string set() const { return name(set_); }

  [[nodiscard]] Inputs inputs() const;
  /// Values that a kernel did not write are failures, when they were poisoned.
  [[nodiscard]] Accuracy check(const Outputs& results) const;
  template <class At>
  [[nodiscard]] Accuracy compare(const At& at) const;

  /// Runs the kernel on the input that the words say. @return what replay prints of it under `where`
  /// @throw Error when the words are not the numbers of an input
  static std::string replay(const std::vector<std::string>& words, const std::string& where,
                            const std::function<Outputs(const Inputs&)>& run);

 private:
  std::shared_ptr<SampleSets> sets_;
  InputSet set_;
};

}  // namespace physgen::bench
