// See physgen/detail/changed_objects.h.
#include <physgen/detail/changed_objects.h>
#include <physgen/error.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "element_codec.h"

namespace physgen::detail {

namespace {

const char* name(Side side) { return side == Side::host ? "host" : "device"; }

}  // namespace

std::optional<ObjectRange> ObjectSet::first_in(index_t begin, index_t end) const {
  if (begin >= end) return std::nullopt;
  auto range = ends_.upper_bound(begin);
  if (range != ends_.begin() && std::prev(range)->second > begin) --range;
  if (range == ends_.end() || range->first >= end) return std::nullopt;
  return ObjectRange{std::max(range->first, begin), std::min(range->second, end)};
}

std::vector<ObjectRange> ObjectSet::in(index_t begin, index_t end) const {
  std::vector<ObjectRange> ranges;
  for (auto range = first_in(begin, end); range; range = first_in(range->end, end)) ranges.push_back(*range);
  return ranges;
}

void ObjectSet::add(index_t begin, index_t end) {
  auto first = ends_.upper_bound(begin);
  if (first != ends_.begin() && std::prev(first)->second >= begin) --first;  // which touches or overlaps
  if (first == ends_.end() || first->first > end) {
    ends_.emplace_hint(first, begin, end);  // all that can fail
    return;
  }
  auto last = first;
  for (; last != ends_.end() && last->first <= end; ++last) end = std::max(end, last->second);
  ends_.erase(std::next(first), last);
  first->second = end;
  if (begin < first->first) {
    auto node = ends_.extract(first);
    node.key() = begin;
    ends_.insert(std::move(node));
  }
}

void ObjectSet::remove(index_t begin, index_t end) {
  auto range = ends_.upper_bound(begin);
  if (range != ends_.begin() && std::prev(range)->second > begin) --range;
  if (range == ends_.end() || range->first >= end) return;
  if (range->first < begin) {
    if (range->second > end) ends_.emplace(end, range->second);  // what is left behind; all that can fail
    range->second = begin;
    ++range;
  }
  while (range != ends_.end() && range->second <= end) range = ends_.erase(range);
  if (range == ends_.end() || range->first >= end) return;
  auto node = ends_.extract(range);
  node.key() = end;
  ends_.insert(std::move(node));
}

void ChangedObjects::mark(Side side, index_t begin, index_t end) {
  check_range(begin, end);
  if (begin == end) return;
  const Side other = side == Side::host ? Side::device : Side::host;
  if (const auto newer = newer_on(other).first_in(begin, end)) {
    throw Error(std::string(object_) + "[" + std::to_string(size_) + "]: objects " + std::to_string(newer->begin) +
                " to " + std::to_string(newer->end - 1) + " were changed on the " + name(other) +
                " and cannot be changed on the " + name(side) + " as well; read_" + name(side) + "() first");
  }
  (side == Side::host ? on_host_ : on_device_).add(begin, end);
}

std::vector<ObjectRange> ChangedObjects::newer(Side side, index_t begin, index_t end) const {
  check_range(begin, end);
  return newer_on(side).in(begin, end);
}

std::vector<ObjectRange> ChangedObjects::widened(Side side, const std::vector<ObjectRange>& ranges) const {
  const ObjectSet& kept = newer_on(side == Side::host ? Side::device : Side::host);
  std::vector<ObjectRange> result;
  for (ObjectRange range : ranges) {
    const ObjectRange blocks{range.begin / mirror_block * mirror_block,
                             std::min(align_up(range.end, mirror_block), size_)};
    if (!kept.first_in(blocks.begin, range.begin)) range.begin = blocks.begin;
    if (!kept.first_in(range.end, blocks.end)) range.end = blocks.end;
    if (!result.empty() && range.begin <= result.back().end) {
      result.back().end = std::max(result.back().end, range.end);
    } else {
      result.push_back(range);
    }
  }
  return result;
}

void ChangedObjects::settle(const ObjectRange& range) {
  on_host_.remove(range.begin, range.end);
  on_device_.remove(range.begin, range.end);
}

void ChangedObjects::check_range(index_t begin, index_t end) const {
  if (begin < 0 || begin > end || end > size_) {
    throw Error(std::string(object_) + "[" + std::to_string(size_) + "]: there are no objects " +
                std::to_string(begin) + " up to " + std::to_string(end));
  }
}

bool same_formats(const UntypedArray& a, const UntypedArray& b) {
  return std::ranges::equal(a.fields, b.fields, [](const FieldInfo& x, const FieldInfo& y) {
    return FieldFormat(x) == FieldFormat(y) && x.quaternion == y.quaternion;
  });
}

}  // namespace physgen::detail
