#include <fem/mesh/stages.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace physgen::fem {

namespace {

thread_local Stages* recorded = nullptr;
thread_local InStage* innermost = nullptr;

}  // namespace

Stages::Recording::Recording(Stages& stages) : before_(std::exchange(recorded, &stages)) {}
Stages::Recording::~Recording() { recorded = before_; }

void Stages::add(const char* name, double seconds, std::int64_t bytes) {
  auto stage = std::ranges::find(stages_, name, &Stage::name);
  if (stage == stages_.end()) stage = stages_.insert(stages_.end(), {name, 0, 0});
  stage->seconds += seconds;
  stage->bytes += bytes;
}

InStage::InStage(const char* name)
    : stages_(recorded), around_(innermost), name_(name), exceptions_(std::uncaught_exceptions()) {
  if (stages_ == nullptr) return;
  if (around_ != nullptr) around_->stop();
  stages_->add(name_, 0, 0);
  innermost = this;
  start_ = Clock::now();
}

InStage::~InStage() {
  if (stages_ == nullptr) return;
  stop();
  stages_->add(name_, seconds_, bytes_);
  if (std::uncaught_exceptions() > exceptions_ && stages_->failed_.empty()) stages_->failed_ = name_;
  innermost = around_;
  if (around_ != nullptr) around_->start_ = Clock::now();
}

void InStage::stop() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

}  // namespace physgen::fem
