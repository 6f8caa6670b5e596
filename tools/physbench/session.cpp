// Preparation, timing and counters of rows.
#include "session.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "errors.h"
#include "sector_model.h"

namespace physgen::bench {

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
  case_.reset();  // its memory first: rows of one size follow each other
  if (progress_) {
    const auto number = static_cast<long>(&row - rows_.data()) + 1;
    std::fprintf(stderr, "%3ld/%zu %s\n", number, rows_.size(), row.name().c_str());
  }
  case_ = row.make();
  accuracy_ = case_->check();
  times_.clear();
  copies_.clear();
  case_->copy();  // check() has run the kernel; both have touched all their memory now
  prepared_ = &row;
}

void Session::measure() {
  times_.push_back(case_->run());
  copies_.push_back(case_->copy());
}

void Session::run(const Row& row, benchmark::State& state) {
  try {
    prepare(row);
    for (auto _ : state) {
      measure();
      state.SetIterationTime(times_.back());
    }
    // Google Benchmark is content with one iteration of a slow row; a median is not.
    constexpr std::size_t fewest = 5;
    while (times_.size() < fewest && times_.back() < 0.1) measure();
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
    return;
  }
  const double time = median(times_), copy = median(copies_);
  const double bytes = row.bytes_per_object * static_cast<double>(row.objects);
  state.counters[counter::median_ms] = time * 1e3;
  state.counters[counter::min_ms] = *std::min_element(times_.begin(), times_.end()) * 1e3;
  state.counters[counter::copy_ms] = copy * 1e3;
  state.counters[counter::bytes_per_object] = row.bytes_per_object;
  state.counters[counter::gb_per_second] = bytes / time * 1e-9;
  state.counters[counter::copy_fraction] = copy / time;
  if (row.layout == "copy") return;
#ifdef PHYSGEN_BENCH_CUDA
  if (const auto sectors = model_sectors(row)) {
    state.counters[counter::sectors_per_request] = sectors->per_request;
    state.counters[counter::bytes_per_sector] = sectors->bytes_per_sector;
    state.counters[counter::requests_per_transaction] = 1 / sectors->per_request;
  }
#endif
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
  if (!row.errors_in_eps) return;
  if (accuracy_.orthogonality) put_errors(counter::orth_eps, *accuracy_.orthogonality);
  put(counter::failures, static_cast<double>(accuracy_.failures));
  put(counter::samples, static_cast<double>(accuracy_.errors.count));
  put(counter::worst_index, static_cast<double>(accuracy_.errors.worst_index));
  state.SetLabel(accuracy_.worst);
}

}  // namespace physgen::bench
