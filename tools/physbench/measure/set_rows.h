// A kernel's rows of the sets on the CPU, and its replay. For the files that CMake writes.
#pragma once

#include <array>

#include "measure/host_rows.h"
#include "measure/set_errors.h"

namespace physgen::bench {

namespace detail {

template <class Kernel, class Real>
void add_set_rows(std::vector<Row>& rows, const std::shared_ptr<SampleSets>& sets) {
  const auto each = [&](const auto& add_one) {
    for (const InputSet set : input_sets) {
      const OnSet<Kernel, Real> provider(sets, set);
      add_one(Adder<HostDevice, OnSet<Kernel, Real>>(rows, provider), provider);
    }
  };
  if constexpr (HasReference<Kernel>) {
    each([](const auto& of, const auto& provider) { of.add("eigen", [provider] { return eigen_case(provider); }); });
  }
  each([](const auto& of, const auto& /*provider*/) { of.template layout<Aosoa<16>>("aosoa16"); });
}

/// The kernel on one object, with packs of kLanes.
template <class Kernel, class Real, int kLanes>
auto run_once(const typename OnSet<Kernel, Real>::Inputs& inputs) {
  auto outputs = make_arrays<typename OnSet<Kernel, Real>::Outputs>([](std::size_t /*k*/) { return index_t{1}; });
  for_each_array(outputs, [](auto& array, auto /*k*/) { poison(array.untyped()); });
  parallel_for(Host{}, 1, lanes<kLanes>(kernel_over<Kernel, Real>(inputs, outputs)));
  return outputs;
}

template <class Kernel, class Real>
void register_replay() {
  using Problem = typename Kernel::template Problem<Real>;
  const auto way = [](int place, std::function<std::string(const std::vector<std::string>&)> run) {
    add(ReplayWay{Kernel::name, storage_name<Real>(), 10 * Kernel::place + place, std::move(run)});
  };
  way(0, [](const std::vector<std::string>& words) {
    const auto numbers = read_numbers<Real>(Kernel::name, words, Problem::numbers, Problem::words);
    const auto reference = Problem::exact(Problem::reference(Problem::read(numbers.data())));
    return replay_line("input", numbers) + tell<Kernel, Real>("reference", reference, {});
  });
  way(1, [](const std::vector<std::string>& words) {
    return OnSet<Kernel, Real>::replay(words, "host, packs", run_once<Kernel, Real, 0>);
  });
  way(2, [](const std::vector<std::string>& words) {
    return OnSet<Kernel, Real>::replay(words, "host, one by one", run_once<Kernel, Real, 1>);
  });
  if constexpr (HasReference<Kernel>) {
    way(4, [](const std::vector<std::string>& words) {
      return OnSet<Kernel, Real>::replay(words, "eigen", [](const auto& inputs) {
        auto outputs = make_arrays<typename OnSet<Kernel, Real>::Outputs>([](std::size_t /*k*/) { return index_t{1}; });
        with_values(inputs, [&outputs](const auto&... input) {
          std::get<0>(outputs).view().put(0, Kernel::template naive<Real, Real>(0, input...));
        });
        return outputs;
      });
    });
  }
}

}  // namespace detail

template <class Kernel>
bool register_set_rows() {
  detail::register_replay<Kernel, float>();
  detail::register_replay<Kernel, double>();
  return add(Part{"errors", Kernel::place, Kernel::name, "host", [](std::vector<Row>& rows, const Sizes& sizes) {
                    detail::add_set_rows<Kernel, float>(rows, sets_of(sizes.sets));
                    detail::add_set_rows<Kernel, double>(rows, sets_of(sizes.sets));
                  }});
}

}  // namespace physgen::bench
