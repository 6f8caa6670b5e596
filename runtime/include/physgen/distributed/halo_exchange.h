// How fields of ghosts cross between ranks, and what stands in them until they do. Which fields, and when, is decided
// by HaloSteps (halo_steps.h).
#pragma once

#include <physgen/distributed/halo_needs.h>

#include <compare>
#include <memory>
#include <span>

namespace physgen {

struct DistributedSet;
class Partition;
class Runs;

/// A field of an array, by their numbers in a Partition.
struct HaloField {
  int array, field;
  auto operator<=>(const HaloField&) const = default;
};

/// The ghosts of a need of its set (halo_needs.h) get a field.
struct HaloFetch {
  HaloField field;
  int need;
};

/// One exchange ends before the next one begins.
class HaloExchange {
 public:
  HaloExchange() = default;
  HaloExchange(const HaloExchange&) = delete;
  HaloExchange& operator=(const HaloExchange&) = delete;
  virtual ~HaloExchange() = default;
  /// Begins to send these fields of owned objects, and to receive those of ghosts: all in one message to each
  /// neighbour.
  virtual void begin(std::span<const HaloFetch> fetches) = 0;
  /// What is done behind this finds them in the arrays.
  virtual void end() = 0;
  /// Fields of a set that all ranks have: each gives all others those of the objects that it has computed.
  virtual void gather(std::span<const HaloField> fields, const Runs& computed) = 0;
  /// The field of all ghosts but those of the needs `fresh` becomes signalling NaN; an index field the lowest number.
  virtual void poison(const HaloField& field, HaloNeedBits fresh) = 0;
};

/// Of arrays that the host reaches. @pre `arrays` outlives it
[[nodiscard]] std::unique_ptr<HaloExchange> make_host_exchange(Partition& arrays);

/// The ghosts of a set that are in none of some needs.
[[nodiscard]] ObjectRuns stale_ghosts(const DistributedSet& set, HaloNeedBits fresh);

}  // namespace physgen
