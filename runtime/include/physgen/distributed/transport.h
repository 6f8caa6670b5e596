// How bytes cross between ranks: by messages to some of them, or from all to all. What crosses, and when, is decided
// above (distributed/halo_steps.h).
#pragma once

#include <physgen/config.h>
#include <physgen/distributed/ranks.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace physgen {

/// What goes to a rank, and what comes from it. Both ranks know the sizes.
struct Message {
  int peer;
  std::span<const std::byte> sent;
  std::span<std::byte> received;
};

/// What has crossed so far, seen from this rank; without what ranks tell each other of their plans.
struct Traffic {
  index_t exchanges = 0;       ///< begin() with a message, or of which others had one
  index_t messages = 0;        ///< sent
  index_t bytes = 0;           ///< sent in them
  index_t gathers = 0;         ///< gather()
  index_t gathered_bytes = 0;  ///< given in them
  index_t overlapped = 0;      ///< exchanges that crossed while a step was called for its inner objects

  Traffic& operator+=(const Traffic& other);
  [[nodiscard]] Traffic operator-(const Traffic& other) const;
  [[nodiscard]] Traffic operator*(index_t times) const;
};

/// All ranks call the same functions in the same order.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int count() const = 0;

  /// Begins to send and to receive. The memory of the messages stays as it is until end().
  /// @param messages at most one for each other rank. One that is empty in both directions is left out
  void begin(std::span<const Message> messages);
  /// Waits until all that was begun is done.
  virtual void end() = 0;
  /// begin() and end() of what ranks tell each other of what will cross, which is not counted.
  void tell(std::span<const Message> messages) {
    begin_messages(messages);
    end();
  }
  /// The bytes of every rank, in the order of ranks. @param sizes of each rank's bytes
  void gather(std::span<const std::byte> mine, std::span<const index_t> sizes, std::span<std::byte> all);
  /// @param given a number for each rank. @return the number that each rank gave this one
  [[nodiscard]] virtual std::vector<index_t> all_to_all(std::span<const index_t> given) = 0;

  [[nodiscard]] const Traffic& traffic() const { return traffic_; }
  /// Kernels were called between begin() and end().
  void count_overlap() { ++traffic_.overlapped; }
  /// As much has crossed, by steps that were recorded (distributed/cuda/recorded_loops.h).
  void count(const Traffic& recorded) { traffic_ += recorded; }
  /// Whether begin(), end() and gather() only order work in a stream, which can be captured in a graph.
  [[nodiscard]] virtual bool can_be_captured() const { return false; }

 protected:
  /// Goes on where another one has counted so far.
  explicit Transport(const Traffic& so_far) : traffic_(so_far) {}

 private:
  virtual void begin_messages(std::span<const Message> messages) = 0;
  virtual void gather_bytes(std::span<const std::byte> mine, std::span<const index_t> sizes,
                            std::span<std::byte> all) = 0;
  Traffic traffic_;
};

/// Of one rank, without MPI.
class SelfTransport final : public Transport {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int count() const override { return 1; }
  void end() override {}
  [[nodiscard]] std::vector<index_t> all_to_all(std::span<const index_t> given) override;

 private:
  void begin_messages(std::span<const Message> messages) override;
  void gather_bytes(std::span<const std::byte> mine, std::span<const index_t> sizes, std::span<std::byte> all) override;
};

/// That of MPI, or with one rank a SelfTransport. @pre `ranks` outlives it
[[nodiscard]] std::unique_ptr<Transport> make_transport(const Ranks& ranks);

}  // namespace physgen
