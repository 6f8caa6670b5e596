// See proof.h.
#include "plan/proof.h"

#include <algorithm>
#include <stdexcept>

namespace physgen::plan {
namespace {

/// The bytes of a channel in every tile.
struct Channel {
  Affine begin;
  Affine end;
  const Run* run;
};

void check(const Record& record, const std::vector<Run>& all, int Bytes::* precision, std::vector<std::string>& found) {
  const std::string in = record.object->qualified_name() + " " + std::string(model::facts(record.space).place) +
                         (precision == &Bytes::with_float ? " with Real = float: " : " with Real = double: ");
  const Affine tile{record.bytes.*precision, 0};
  std::vector<Channel> channels;
  for (const Run& run : all) {
    const int size = element_bytes(run.field(), record.space).*precision;
    const Affine begin{run.offset.*precision, 0};
    const Affine end{begin.times_pitch + run.count * size, 0};
    const std::string at = run.name() + " at byte " + std::to_string(begin.times_pitch);
    if (!always_multiple(begin, size)) {
      found.push_back(in + at + " is not aligned to its " + std::to_string(size) + " bytes");
    }
    if (!never_negative(begin) || !never_negative(tile - end)) {
      found.push_back(in + at + " ends at byte " + std::to_string(end.times_pitch) + " of a record of " +
                      std::to_string(tile.times_pitch));
    }
    if (record.alignment.*precision % size != 0) {
      found.push_back(in + "records are aligned to " + std::to_string(record.alignment.*precision) + " bytes, " +
                      run.name() + " needs " + std::to_string(size));
    }
    channels.push_back({begin, end, &run});
  }
  // Sorted by their beginnings, channels are disjoint exactly when each ends before the next one begins.
  std::stable_sort(channels.begin(), channels.end(),
                   [](const Channel& a, const Channel& b) { return a.begin.times_pitch < b.begin.times_pitch; });
  for (std::size_t i = 1; i < channels.size(); ++i) {
    if (!never_negative(channels[i].begin - channels[i - 1].end)) {
      found.push_back(in + channels[i - 1].run->name() + " and " + channels[i].run->name() + " share byte " +
                      std::to_string(channels[i].begin.times_pitch));
    }
  }
}

}  // namespace

std::vector<std::string> violations(const Record& record) {
  std::vector<std::string> found;
  const std::vector<Run> all = runs(record);
  check(record, all, &Bytes::with_float, found);
  check(record, all, &Bytes::with_double, found);
  return found;
}

void require_sound(const Record& record) {
  if (const auto wrong = violations(record); !wrong.empty()) {
    throw std::logic_error("physgen planned a record that is not sound: " + wrong.front());
  }
}

}  // namespace physgen::plan
