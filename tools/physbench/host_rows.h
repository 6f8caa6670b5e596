// Rows of the CPU: a kernel in every layout and storage, a plain copy beside it, the naive Eigen loop, and the
// reference that all rows of the kernel are checked against.
#pragma once

#include <physgen/parallel_for.h>

#include <cstring>
#include <vector>

#include "errors.h"
#include "naive.h"
#include "operands.h"
#include "timing.h"
#include "values.h"

namespace physgen::bench {

namespace detail {

/// All inputs of a kernel in Real, as arrays and as vectors of structs.
template <class Kernel, class Real, class... Source>
auto rounded_inputs(Dataset& data, Inputs<Source...> /*list*/) {
  return std::make_tuple(rounded<Real, Source>(data, Kernel::Output::domain)...);
}
template <class Kernel, class Real, class... Source>
auto struct_inputs(Dataset& data, Inputs<Source...> /*list*/) {
  return std::make_tuple(structs<Real, Source>(data, Kernel::Output::domain)...);
}

template <class Kernel, class T>
using Observed =
    decltype(Naive<Kernel>::template observe<T>(std::declval<typename Kernel::Output::Object::template Value<T>>()));

template <class Kernel, class Real>
std::vector<Observed<Kernel, Wider<Real>>> make_reference(Dataset& data) {
  using T = Wider<Real>;
  const auto arrays = rounded_inputs<Kernel, Real>(data, typename Kernel::Reads());
  const index_t n = data.count(Kernel::Output::domain, Kernel::Output::domain);
  std::vector<Observed<Kernel, T>> reference(static_cast<std::size_t>(n));
  std::apply(
      [&](const auto&... array) {
#pragma omp parallel for schedule(static)
        for (index_t i = 0; i < n; ++i) {
          reference[static_cast<std::size_t>(i)] =
              Naive<Kernel>::template observe<T>(Naive<Kernel>::template value<T, Real>(i, Values{array.view()}...));
        }
      },
      arrays);
  return reference;
}

/// Errors of result(i), i = 0 .. n-1.
template <class Kernel, class Real, class At>
Accuracy compare(Dataset& data, const At& result) {
  using T = Wider<Real>;
  using Reference = std::vector<Observed<Kernel, T>>;
  const auto& reference =
      data.reference<Reference>(std::string(Kernel::name) + (sizeof(Real) == 4 ? "/float" : "/double"),
                                [&data] { return make_reference<Kernel, Real>(data); });
  const auto n = static_cast<index_t>(reference.size());
  std::vector<double> errors(reference.size()), norms(reference.size());
#pragma omp parallel for schedule(static)
  for (index_t i = 0; i < n; ++i) {
    const auto& expected = reference[static_cast<std::size_t>(i)];
    errors[static_cast<std::size_t>(i)] =
        static_cast<double>((Naive<Kernel>::template observe<T>(result(i)) - expected).norm());
    norms[static_cast<std::size_t>(i)] = static_cast<double>(expected.norm());
  }
  return relative_errors(std::move(errors), norms);
}

/// A kernel over arrays. kLanes as parallel_for takes it.
template <class Kernel, class Real, class Layout, int kLanes, class Scheme = SchemaFormats>
class HostCase final : public TimedHostCase {
 public:
  explicit HostCase(Dataset& data, double bytes = 0)
      : TimedHostCase(bytes > 0 ? bytes : bytes_moved<Kernel, Real>(data)), data_(data), operands_(data) {}
  double run() override {
    const auto kernel = operands_.kernel();
    const index_t n = operands_.output().size();
    const Stopwatch watch;
    parallel_for<kLanes>(Host{}, n, kernel);
    return watch.seconds();
  }
  Accuracy check() override {
    poison(operands_.output().storage());
    run();
    Result<Kernel, Real> result(operands_.output().size());
    physgen::copy(result, operands_.output());
    return HostKernel<Kernel>::check(data_, result.storage());
  }

 private:
  Dataset& data_;
  Operands<Kernel, Real, Host, Layout, Scheme> operands_;
};

/// The copy alone.
template <class Kernel, class Real>
class HostCopyCase final : public TimedHostCase {
 public:
  explicit HostCopyCase(Dataset& data) : TimedHostCase(bytes_moved<Kernel, Real>(data)) {}
  double run() override { return copy(); }
  Accuracy check() override { return {}; }
};

/// The naive kernel over std::vectors of structs.
template <class Kernel, class Real>
class EigenCase final : public TimedHostCase {
  using Value = typename Kernel::Output::Object::template Value<Real>;

 public:
  explicit EigenCase(Dataset& data)
      : TimedHostCase(bytes_moved<Kernel, Real>(data)),
        data_(data),
        inputs_(struct_inputs<Kernel, Real>(data, typename Kernel::Reads())),
        output_(static_cast<std::size_t>(data.count(Kernel::Output::domain, Kernel::Output::domain))) {}
  double run() override {
    const auto n = static_cast<index_t>(output_.size());
    const Stopwatch watch;
    std::apply(
        [&](const auto&... input) {
#pragma omp parallel for schedule(static)
          for (index_t i = 0; i < n; ++i) {
            output_[static_cast<std::size_t>(i)] = Naive<Kernel>::template value<Real, Real>(i, Values{&input}...);
          }
        },
        inputs_);
    return watch.seconds();
  }
  Accuracy check() override {
    std::memset(static_cast<void*>(output_.data()), 0xff, output_.size() * sizeof(Value));  // NaN, as poison() does
    run();
    return compare<Kernel, Real>(data_, [this](index_t i) { return output_[static_cast<std::size_t>(i)]; });
  }

 private:
  Dataset& data_;
  decltype(struct_inputs<Kernel, Real>(std::declval<Dataset&>(), typename Kernel::Reads())) inputs_;
  std::vector<Value> output_;
};

/// Adds rows of a kernel in one storage.
template <class Kernel, class Real>
struct HostRows {
  std::vector<Row>& rows;
  Dataset& data;

  template <class MeasuredCase>
  HostRows add(const char* layout) const {
    Row row = describe<Kernel, Real>(layout, SpaceKind::host, data);
    row.make = [&data = data] { return std::make_unique<MeasuredCase>(data); };
    rows.push_back(std::move(row));
    return *this;
  }
  template <class Layout, int kLanes = 0>
  HostRows layout(const char* name) const {
    return add<HostCase<Kernel, Real, Layout, kLanes>>(name);
  }
  /// By packs that collect their lanes, and object by object: which of them is faster differs.
  HostRows aos() const {
    using Function = decltype(std::declval<Operands<Kernel, Real, Host, Aos>&>().kernel());
    if constexpr (physgen::detail::default_lanes<Function>() > 1) layout<Aos, 1>("aos_scalar");
    return layout<Aos>("aos");
  }
};

}  // namespace detail

template <class Kernel>
void HostKernel<Kernel>::add_rows(std::vector<Row>& rows, Dataset& data) {
  detail::HostRows<Kernel, float>{rows, data}
      .template add<detail::HostCopyCase<Kernel, float>>("copy")
      .template add<detail::EigenCase<Kernel, float>>("eigen")
      .aos()
      .template layout<Soa>("soa")
      .template layout<Aosoa<16>>("aosoa16")
      .template layout<Aosoa<32>>("aosoa32");
  detail::HostRows<Kernel, double>{rows, data}
      .template add<detail::HostCopyCase<Kernel, double>>("copy")
      .aos()
      .template layout<Soa>("soa")
      .template layout<Aosoa<16>>("aosoa16");
}

template <class Kernel>
Accuracy HostKernel<Kernel>::check(Dataset& data, const Storage& result) {
  check_written(result);
  const auto compare = [&]<class Real>(Real /*storage*/) {
    const typename Result<Kernel, Real>::ConstView view(result.base, result.size, result.pitch);
    return detail::compare<Kernel, Real>(data, [&view](index_t i) { return view.get(i); });
  };
  return result.fields.front().type == ElementType::float32 ? compare(float()) : compare(double());
}

}  // namespace physgen::bench
