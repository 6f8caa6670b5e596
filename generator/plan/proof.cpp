// See proof.h.
#include "plan/proof.h"

#include <algorithm>

namespace physgen::plan {
namespace {

struct Interval {
  int begin;
  int end;
  const Run* run;
};

void check(const Record& record, const std::vector<Run>& all, int Bytes::* precision, std::vector<std::string>& found) {
  const std::string in = record.object->qualified_name() +
                         (precision == &Bytes::with_float ? " with Real = float: " : " with Real = double: ");
  const int bytes = record.bytes.*precision;
  std::vector<Interval> intervals;
  for (const Run& run : all) {
    const int size = element_bytes(run.field().element).*precision;
    const int begin = run.offset.*precision;
    const int end = begin + run.count * size;
    const std::string at = run.name() + " at byte " + std::to_string(begin);
    if (begin % size != 0) found.push_back(in + at + " is not aligned to its " + std::to_string(size) + " bytes");
    if (begin < 0 || end > bytes) {
      found.push_back(in + at + " ends at byte " + std::to_string(end) + " of a record of " + std::to_string(bytes));
    }
    if (record.alignment.*precision % size != 0) {
      found.push_back(in + "records are aligned to " + std::to_string(record.alignment.*precision) + " bytes, " +
                      run.name() + " needs " + std::to_string(size));
    }
    intervals.push_back({begin, end, &run});
  }
  // Sorted by their beginnings, intervals are disjoint exactly when each ends before the next one begins.
  std::stable_sort(intervals.begin(), intervals.end(),
                   [](const Interval& a, const Interval& b) { return a.begin < b.begin; });
  for (std::size_t i = 1; i < intervals.size(); ++i) {
    if (intervals[i - 1].end > intervals[i].begin) {
      found.push_back(in + intervals[i - 1].run->name() + " and " + intervals[i].run->name() + " share byte " +
                      std::to_string(intervals[i].begin));
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

}  // namespace physgen::plan
