// Preparation, timing and counters of rows.
#include "report/session.h"

#include <physgen/error.h>

#include <algorithm>
#include <exception>

#include "measure/errors.h"
#include "report/format.h"

namespace physgen::bench {

namespace {

void require_memory(double needed, double there_is, const char* whose) {
  if (needed <= there_is) return;
  throw Error(format("this row needs about %.1f GB of memory, and %s has %.1f GB; --objects=N asks for fewer objects",
                     needed * 1e-9, whose, there_is * 1e-9));
}

}  // namespace

void Session::register_rows() {
  for (const Row& row : rows_) {
    benchmark::RegisterBenchmark(row.name().c_str(), [this, &row](benchmark::State& state) { run(row, state); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

void Session::prepare(const Row& row) {
  if (prepared_ == &row) return;
  prepared_ = nullptr;
  case_ = {};  // its memory first: rows of one size follow each other
  progress_.begin(row);
  require_memory(row.host_bytes, limits_.host_memory, "this machine");
  require_memory(row.device_bytes, limits_.device_memory, "the GPU");
  case_ = row.make();
  accuracy_ = case_.check();
  times_.clear();
  copies_.clear();
  case_.copy();  // check() has run the kernel; both have touched all their memory now
  prepared_ = &row;
}

void Session::measure() {
  times_.push_back(case_.run());
  copies_.push_back(case_.copy());
}

void Session::run(const Row& row, benchmark::State& state) {
  try {
    prepare(row);
    for ([[maybe_unused]] auto _ : state) {
      measure();
      state.SetIterationTime(times_.back());
    }
    // Google Benchmark is content with one iteration of a slow row; a median is not.
    while (times_.size() < case_.fewest) measure();
    progress_.end();
  } catch (const std::exception& error) {
    progress_.end();
    state.SkipWithError(error.what());
    return;
  }
  const double time = median(times_), copy = median(copies_);
  const double bytes = case_.bytes;
  state.counters[counter::median_ms] = time * 1e3;
  state.counters[counter::min_ms] = *std::ranges::min_element(times_) * 1e3;
  state.counters[counter::copy_ms] = copy * 1e3;
  state.counters[counter::bytes_per_object] = bytes / static_cast<double>(row.objects);
  state.counters[counter::gb_per_second] = bytes / time * 1e-9;
  state.counters[counter::copy_fraction] = copy / time;
  const double cache = row.space == "host" ? limits_.host_cache : limits_.device_cache;
  if (cache > 0) state.counters[counter::over_cache] = bytes / cache;
  if (row.layout == "copy") return;
  for (const auto& [name, value] : row.model()) state.counters[name] = value;
  report(row, state);
}

void Session::report(const Row& row, benchmark::State& state) const {
  const auto put = [&state](const std::string& name, double value) { state.counters[name] = value; };
  const auto put_errors = [&put](const std::string& what, const fem::reference::ErrorSummary& errors) {
    put(what + counter::p50, errors.p50);
    put(what + counter::p99, errors.p99);
    put(what + counter::p9999, errors.p9999);
    put(what + counter::max, errors.max);
  };
  put_errors(row.errors_in_eps ? counter::err_eps : counter::err, accuracy_.errors);
  for (const auto& [name, value] : accuracy_.more) put(name, value);
  state.SetLabel(row.errors_in_eps ? accuracy_.worst : accuracy_.note);
  if (!row.errors_in_eps) return;
  if (accuracy_.orthogonality) put_errors(counter::orth_eps, *accuracy_.orthogonality);
  put(counter::failures, static_cast<double>(accuracy_.failures));
  put(counter::samples, static_cast<double>(accuracy_.errors.count));
  put(counter::worst_index, static_cast<double>(accuracy_.errors.worst_index));
}

}  // namespace physgen::bench
