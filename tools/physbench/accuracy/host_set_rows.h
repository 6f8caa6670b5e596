// Rows of the sets on the CPU: a kernel in AoSoA and the naive Eigen loop, and the check that rows of all spaces share.
#pragma once

#include <physgen/parallel_for.h>

#include <cstring>
#include <memory>
#include <type_traits>

#include "../errors.h"
#include "../timing.h"
#include "../values.h"
#include "cusolver.h"
#include "derivative_problems.h"
#include "replay.h"
#include "set_rows.h"
#include "svd_problem.h"

namespace physgen::bench {

namespace detail {

/// The distribution of a kernel's errors. @param at at(i) is the result of sample i, in the wider type
template <class Variant, class Real, class At>
Accuracy measure_errors(InputSets& sets, InputSet set, const At& at) {
  using Problem = typename Variant::template Problem<Real>;
  const Samples<Problem>& samples = sets.of<Problem>(set);
  std::vector<InputErrors> each(samples.inputs.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < each.size(); ++i) {
    each[i] = Problem::errors(samples.inputs[i], samples.references[i], at(static_cast<index_t>(i)));
  }
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
  accuracy.worst = replay_command(Variant::name, Problem::write(worst));
  return accuracy;
}

/// What object i of a kernel's output says of its problem.
template <class Variant, class Real, class Outputs>
auto result_of(const Outputs& outputs, index_t i) {
  return std::apply(
      [i](const auto&... output) { return Variant::template result<Wider<Real>>(output.view().get(i)...); }, outputs);
}

template <class Variant, class Real>
class HostSetCase final : public TimedHostCase {
 public:
  HostSetCase(InputSets& sets, InputSet set)
      : TimedHostCase(bytes_moved<Variant, Real>(sets.objects())),
        sets_(sets),
        set_(set),
        inputs_(HostVariant<Variant, Real>::inputs(sets, set)),
        outputs_(make_arrays<Outputs>(sets.objects())) {}
  double run() override {
    const auto kernel = kernel_over<Variant, Real>(inputs_, outputs_);
    const Stopwatch watch;
    parallel_for(Host{}, sets_.objects(), kernel);
    return watch.seconds();
  }
  Accuracy check() override {
    for_each_array(outputs_, [](auto& array) { poison(array.storage()); });
    run();
    return HostVariant<Variant, Real>::check(sets_, set_, outputs_);
  }

 private:
  using Outputs = typename HostVariant<Variant, Real>::Outputs;
  InputSets& sets_;
  InputSet set_;
  typename HostVariant<Variant, Real>::Inputs inputs_;
  Outputs outputs_;
};

/// Vectors of structs of each of Objects<...>.
template <class Real, class... Object>
auto struct_vectors(std::size_t size, Objects<Object...> /*list*/) {
  return std::make_tuple(std::vector<typename Object::template Value<Real>>(size)...);
}

/// The naive kernel over std::vectors of structs.
template <class Variant, class Real>
class EigenSetCase final : public TimedHostCase {
  using Naive = bench::Naive<typename Variant::Naive>;

 public:
  EigenSetCase(InputSets& sets, InputSet set)
      : TimedHostCase(bytes_moved<Variant, Real>(sets.objects())),
        sets_(sets),
        set_(set),
        inputs_(struct_vectors<Real>(static_cast<std::size_t>(sets.objects()), typename Variant::Reads())),
        outputs_(struct_vectors<Real>(static_cast<std::size_t>(sets.objects()), typename Variant::Writes())) {
    const auto arrays = HostVariant<Variant, Real>::inputs(sets, set);
    fill(arrays, std::make_index_sequence<std::tuple_size_v<decltype(inputs_)>>());
  }
  double run() override {
    const index_t n = sets_.objects();
    auto& output = std::get<0>(outputs_);
    const Stopwatch watch;
    std::apply(
        [&](const auto&... input) {
#pragma omp parallel for schedule(static)
          for (index_t i = 0; i < n; ++i) {
            output[static_cast<std::size_t>(i)] = Naive::template value<Real, Real>(i, Values{&input}...);
          }
        },
        inputs_);
    return watch.seconds();
  }
  Accuracy check() override {
    auto& output = std::get<0>(outputs_);
    std::memset(static_cast<void*>(output.data()), 0xff, output.size() * sizeof(output[0]));  // NaN, as poison() does
    run();
    return measure_errors<Variant, Real>(sets_, set_, [this](index_t i) {
      return Variant::template result<Wider<Real>>(std::get<0>(outputs_)[static_cast<std::size_t>(i)]);
    });
  }

 private:
  template <class ArrayTuple, std::size_t... k>
  void fill(const ArrayTuple& arrays, std::index_sequence<k...> /*which*/) {
    for (index_t i = 0; i < sets_.objects(); ++i) {
      ((std::get<k>(inputs_)[static_cast<std::size_t>(i)] = std::get<k>(arrays).view().get(i)), ...);
    }
  }

  InputSets& sets_;
  InputSet set_;
  decltype(struct_vectors<Real>(0, typename Variant::Reads())) inputs_;
  decltype(struct_vectors<Real>(0, typename Variant::Writes())) outputs_;
};

/// Writes an input into objects i of the arrays of inputs.
template <class Variant, class Real, class Inputs, class Input>
void store(Inputs& arrays, index_t i, const Input& input) {
  const auto values = Variant::template load<Real>(input);
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (std::get<k>(arrays).view().put(i, std::get<k>(values)), ...);
  }(std::make_index_sequence<std::tuple_size_v<Inputs>>());
}

}  // namespace detail

template <class Variant, class Real>
void HostVariant<Variant, Real>::add_rows(std::vector<Row>& rows, InputSets& sets) {
  const auto add = [&]<class MeasuredCase>(const char* layout, std::type_identity<MeasuredCase> /*what*/) {
    for (const InputSet set : input_sets) {
      rows.push_back(describe<Variant, Real>(layout, SpaceKind::host, set, sets.objects()));
      rows.back().make = [&sets, set] { return std::make_unique<MeasuredCase>(sets, set); };
    }
  };
  if constexpr (!std::is_void_v<typename Variant::Naive>) {
    add("eigen", std::type_identity<detail::EigenSetCase<Variant, Real>>());
  }
  add("aosoa16", std::type_identity<detail::HostSetCase<Variant, Real>>());
}

template <class Variant, class Real>
auto HostVariant<Variant, Real>::inputs(InputSets& sets, InputSet set) -> Inputs {
  using Problem = typename Variant::template Problem<Real>;
  const auto& samples = sets.of<Problem>(set).inputs;
  auto arrays = make_arrays<Inputs>(sets.objects());
  const auto count = static_cast<index_t>(samples.size());
#pragma omp parallel for schedule(static)
  for (index_t i = 0; i < sets.objects(); ++i) {
    detail::store<Variant, Real>(arrays, i, samples[static_cast<std::size_t>(i % count)]);
  }
  return arrays;
}

template <class Variant, class Real>
Accuracy HostVariant<Variant, Real>::check(InputSets& sets, InputSet set, const Outputs& outputs) {
  return detail::measure_errors<Variant, Real>(
      sets, set, [&outputs](index_t i) { return detail::result_of<Variant, Real>(outputs, i); });
}

template <class Variant, class Real>
std::string HostVariant<Variant, Real>::replay(const std::vector<std::string>& words) {
  using Problem = typename Variant::template Problem<Real>;
  const std::vector<Real> numbers = read_numbers<Real>(Variant::name, words, Problem::numbers, Problem::words);
  const auto input = Problem::read(numbers.data());
  const auto reference = Problem::reference(input);
  auto inputs = make_arrays<Inputs>(1);
  detail::store<Variant, Real>(inputs, 0, input);

  std::string text;
  const auto tell = [&](const std::string& where, const auto& result, const std::optional<InputErrors>& errors) {
    text += where;
    if (errors) {
      text += ": error " + replay_number(errors->error) + " eps";
      if (errors->orthogonality) text += ", orthogonality " + replay_number(*errors->orthogonality) + " eps";
    }
    text += "\n";
    for (const auto& [name, values] : Problem::name_all(result)) {
      text += replay_line(name, std::vector<Real>(values.begin(), values.end()));
    }
  };
  const auto tell_outputs = [&](const std::string& where, const Outputs& outputs) {
    const auto result = detail::result_of<Variant, Real>(outputs, 0);
    tell(where, result, Problem::errors(input, reference, result));
  };
  const auto run = [&]<int kLanes>(std::integral_constant<int, kLanes>) {
    auto outputs = make_arrays<Outputs>(1);
    for_each_array(outputs, [](auto& array) { poison(array.storage()); });
    parallel_for<kLanes>(Host{}, 1, kernel_over<Variant, Real>(inputs, outputs));
    return outputs;
  };

  text += replay_line("input", numbers);
  tell("reference", Problem::exact(reference), {});
  tell_outputs("host, packs", run(std::integral_constant<int, 0>()));
  tell_outputs("host, one by one", run(std::integral_constant<int, 1>()));
#ifdef PHYSGEN_BENCH_CUDA
  if (cuda_available()) tell_outputs("cuda", CudaVariant<Variant, Real>::run(inputs));
#endif
  if constexpr (!std::is_void_v<typename Variant::Naive>) {
    const auto output = std::apply(
        [](const auto&... value) {
          return Naive<typename Variant::Naive>::template value<Real, Real>(0, std::array{value}...);
        },
        Variant::template load<Real>(input));
    const auto result = Variant::template result<Wider<Real>>(output);
    tell("eigen", result, Problem::errors(input, reference, result));
  }
#ifdef PHYSGEN_BENCH_CUDA
  if constexpr (std::is_same_v<Variant, SvdVariant<4>>) {
    if (cuda_available() && cusolver_missing().empty()) tell_outputs("cusolver", cusolver_svd<Real>(inputs));
  }
#endif
  return text;
}

}  // namespace physgen::bench
