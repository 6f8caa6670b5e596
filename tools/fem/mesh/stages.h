// The times of the parts of a set-up, and the bytes that each must move at least.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace physgen::fem {

class InStage;

/// What the stages of a thread have taken while a Stages::Recording lived.
class Stages {
 public:
  struct Stage {
    std::string name;
    double seconds = 0;      ///< without those of stages within it
    std::int64_t bytes = 0;  ///< of what it reads and writes, each once
    bool operator==(const Stage&) const = default;
  };
  /// While it lives, stages of this thread are recorded here.
  class Recording {
   public:
    explicit Recording(Stages& stages);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

   private:
    Stages* before_;
  };

  /// In the order in which they began first; those of one name are one.
  [[nodiscard]] const std::vector<Stage>& all() const { return stages_; }
  /// The name of the stage that an exception has ended; empty where none has.
  [[nodiscard]] const std::string& failed() const { return failed_; }

 private:
  friend class InStage;
  void add(const char* name, double seconds, std::int64_t bytes);

  std::vector<Stage> stages_;
  std::string failed_;
};

/// A stage is from here to the end of the block; where nothing is recorded, nothing happens.
class InStage {
 public:
  explicit InStage(const char* name);
  ~InStage();
  InStage(const InStage&) = delete;
  InStage& operator=(const InStage&) = delete;

  /// Adds bytes that the stage reads or writes: those of lists.
  template <class... Lists>
  void moves(const Lists&... lists) {
    bytes_ += (... + static_cast<std::int64_t>(lists.size() * sizeof(typename Lists::value_type)));
  }
  void moves_bytes(std::int64_t bytes) { bytes_ += bytes; }

 private:
  using Clock = std::chrono::steady_clock;
  void stop();

  Stages* stages_;
  InStage* around_;
  const char* name_;
  int exceptions_;
  std::int64_t bytes_ = 0;
  double seconds_ = 0;
  Clock::time_point start_;
};

}  // namespace physgen::fem
