// See proof.h.
#include "plan/proof.h"

#include <algorithm>
#include <stdexcept>

namespace physgen::plan {
namespace {

/// The bytes of a channel in every tile, in multiples of the pitch.
struct Channel {
  int begin;
  int end;
  const Run* run;
};

void check(const Record& record, const std::vector<Run>& all, Precision real, std::vector<std::string>& found) {
  const std::string in = record.object->qualified_name() + " " + std::string(model::facts(record.space).place) +
                         (real == Precision::with_float ? " with Real = float: " : " with Real = double: ");
  const int bytes = record.bytes.of(real), alignment = record.alignment.of(real);
  std::vector<Channel> channels;
  for (const Run& run : all) {
    const int size = element_bytes(run.field(), record.space).of(real);
    const int begin = run.offset.of(real), end = begin + run.count * size;
    const std::string at = run.name() + " at byte " + std::to_string(begin);
    if (begin % size != 0) found.push_back(in + at + " is not aligned to its " + std::to_string(size) + " bytes");
    if (begin < 0 || end > bytes) {
      found.push_back(in + at + " ends at byte " + std::to_string(end) + " of a record of " + std::to_string(bytes));
    }
    if (alignment % size != 0) {
      found.push_back(in + "records are aligned to " + std::to_string(alignment) + " bytes, " + run.name() + " needs " +
                      std::to_string(size));
    }
    channels.push_back({begin, end, &run});
  }
  // Sorted by their beginnings, channels are disjoint exactly when each ends before the next one begins.
  std::ranges::stable_sort(channels, {}, &Channel::begin);
  for (std::size_t i = 1; i < channels.size(); ++i) {
    if (channels[i].begin < channels[i - 1].end) {
      found.push_back(in + channels[i - 1].run->name() + " and " + channels[i].run->name() + " share byte " +
                      std::to_string(channels[i].begin));
    }
  }
}

}  // namespace

std::vector<std::string> violations(const Record& record) {
  std::vector<std::string> found;
  const std::vector<Run> all = runs(record);
  for (const Precision real : precisions) check(record, all, real, found);
  return found;
}

void require_sound(const Record& record) {
  if (const auto wrong = violations(record); !wrong.empty()) {
    throw std::logic_error("physgen planned a record that is not sound: " + wrong.front());
  }
}

}  // namespace physgen::plan
