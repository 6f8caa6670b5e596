// Inputs from the sets, and errors of results in eps. For the C++ compiler: instantiated once per kernel.
#pragma once

#include <physgen/detail/host_loop.h>

#include <Eigen/LU>  // the determinants of kernels/svd.h

#include "data/problem.h"
#include "measure/replay.h"
#include "measure/row_bytes.h"
#include "measure/set_data.h"
#include "measure/values.h"

namespace physgen::bench {

/// The input of a problem, and its right result.
template <class Problem>
struct Samples {
  std::vector<typename Problem::Input> inputs;
  std::vector<typename Problem::Reference> references;
};

namespace detail {

template <class Problem>
const Samples<Problem>& samples_of(SampleSets& sets, InputSet set, const char* storage) {
  const std::string key = std::string(Problem::name) + "/" + storage + "/" + name(set);
  return sets.once<Samples<Problem>>(key, [&] {
    Samples<Problem> made;
    made.inputs = Problem::inputs(set, sets.samples());
    made.references.resize(made.inputs.size());
    physgen::detail::host_loop(static_cast<index_t>(made.inputs.size()), [&](index_t k) {
      const auto i = static_cast<std::size_t>(k);
      made.references[i] = Problem::reference(made.inputs[i]);
    });
    return made;
  });
}

/// Writes an input into objects i of the arrays of inputs.
template <class Problem, class Inputs>
void store(Inputs& arrays, index_t i, const typename Problem::Input& input) {
  const auto values = Problem::values(input);
  for_each_array(arrays, [&](auto& array, auto k) { array.view().put(i, std::get<k>(values)); });
}

/// The result that an object's outputs hold.
template <class Kernel, class Real, class Values>
auto result_of(const Values& values) {
  return std::apply([](const auto&... value) { return Kernel::template result<Wider<Real>>(value...); }, values);
}

}  // namespace detail

template <class Kernel, class Real>
auto OnSet<Kernel, Real>::inputs() const -> Inputs {
  using Problem = typename Kernel::template Problem<Real>;
  const auto& samples = detail::samples_of<Problem>(*sets_, set_, storage_name<Real>()).inputs;
  auto arrays = make_arrays<Inputs>([this](std::size_t /*k*/) { return objects(); });
  const auto count = static_cast<index_t>(samples.size());
  physgen::detail::host_loop(
      objects(), [&](index_t i) { detail::store<Problem>(arrays, i, samples[static_cast<std::size_t>(i % count)]); });
  return arrays;
}

template <class Kernel, class Real>
template <class At>
Accuracy OnSet<Kernel, Real>::compare(const At& at) const {
  using Problem = typename Kernel::template Problem<Real>;
  const auto& samples = detail::samples_of<Problem>(*sets_, set_, storage_name<Real>());
  std::vector<InputErrors> each(samples.inputs.size());
  physgen::detail::host_loop(static_cast<index_t>(each.size()), [&](index_t k) {
    const auto i = static_cast<std::size_t>(k);
    const auto result = detail::result_of<Kernel, Real>(at(static_cast<index_t>(i)));
    each[i] = Problem::errors(samples.inputs[i], samples.references[i], result);
  });
  // Errors beyond 100 % say no more than 100 %, and NaN is no better.
  constexpr double all_wrong = 1 / static_cast<double>(std::numeric_limits<Real>::epsilon());
  const auto capped = [](double error) { return error < all_wrong ? error : all_wrong; };
  fem::reference::ErrorDistribution errors, orthogonality;
  Accuracy accuracy;
  for (const InputErrors& one : each) {
    errors.add(capped(one.error));
    if (one.orthogonality) orthogonality.add(capped(*one.orthogonality));
    if (std::max(capped(one.error), capped(one.orthogonality.value_or(0))) > 1e-2 * all_wrong) ++accuracy.failures;
  }
  accuracy.errors = errors.summary();
  if (each.front().orthogonality) accuracy.orthogonality = orthogonality.summary();
  const auto& worst = samples.inputs[static_cast<std::size_t>(accuracy.errors.worst_index)];
  accuracy.worst = replay_command(Kernel::name, Problem::write(worst));
  return accuracy;
}

template <class Kernel, class Real>
Accuracy OnSet<Kernel, Real>::check(const Outputs& results) const {
  return compare([&results](index_t i) { return values_at(results, i); });
}

/// The text that replay prints of a result.
template <class Kernel, class Real>
std::string tell(const std::string& where, const typename Kernel::template Problem<Real>::Result& result,
                 const std::optional<InputErrors>& errors) {
  std::string text = where;
  if (errors) {
    text += ": error " + replay_number(errors->error) + " eps";
    if (errors->orthogonality) text += ", orthogonality " + replay_number(*errors->orthogonality) + " eps";
  }
  text += "\n";
  for (const auto& [name, values] : Kernel::template Problem<Real>::name_all(result)) {
    text += replay_line(name, std::vector<Real>(values.begin(), values.end()));
  }
  return text;
}

template <class Kernel, class Real>
std::string OnSet<Kernel, Real>::replay(const std::vector<std::string>& words, const std::string& where,
                                        const std::function<Outputs(const Inputs&)>& run) {
  using Problem = typename Kernel::template Problem<Real>;
  const auto numbers = read_numbers<Real>(Kernel::name, words, Problem::numbers, Problem::words);
  const auto input = Problem::read(numbers.data());
  auto inputs = make_arrays<Inputs>([](std::size_t /*k*/) { return index_t{1}; });
  detail::store<Problem>(inputs, 0, input);
  const auto result = detail::result_of<Kernel, Real>(values_at(run(inputs), 0));
  return tell<Kernel, Real>(where, result, Problem::errors(input, Problem::reference(input), result));
}

}  // namespace physgen::bench
