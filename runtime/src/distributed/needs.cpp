// Which ghosts a step reads, and the plans of those that some read.
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace physgen {

int Partition::need_of(const HaloPath& path) {
  const DistributedSet& origin = sets_[static_cast<std::size_t>(path.origin)];
  if (path.last.empty() || !origin.local) return 0;  // entries of rows are of all objects that are here
  const auto [found, is_new] = needs_.try_emplace(path, 0);
  if (is_new) {
    const int target = connections_[static_cast<std::size_t>(path.last.front())].target;
    found->second = add_need(target, ghosts_of(path));
  }
  return found->second;
}

int Partition::need_of(int set, HaloNeedBits needs) {
  if ((needs & 1) != 0) return 0;
  if (std::has_single_bit(needs)) return std::countr_zero(needs);
  const auto [found, is_new] = joined_.try_emplace({set, needs}, 0);
  if (is_new) {
    const DistributedSet& one = sets_[static_cast<std::size_t>(set)];
    std::vector<char> has(one.local->ghosts().size(), 0);
    for (std::size_t n = 0; n < one.needs.size(); ++n) {
      if ((needs >> n & 1) == 0) continue;
      for (std::size_t g = 0; g < has.size(); ++g) has[g] |= one.needs[n].has[g];
    }
    found->second = add_need(set, std::move(has));
  }
  return found->second;
}

std::vector<char> Partition::ghosts_of(const HaloPath& path) const {
  const auto connection = [&](int c) -> const Connection& { return connections_[static_cast<std::size_t>(c)]; };
  // Objects that the step is called for, or comes to.
  std::vector<std::vector<char>> is_come_to(sets_.size());
  const auto come_to_all = [&](int set) {
    is_come_to[static_cast<std::size_t>(set)].assign(
        static_cast<std::size_t>(sets_[static_cast<std::size_t>(set)].local->size()), 1);
  };
  for (const int c : path.followed) {
    for (const int set : {connection(c).source, connection(c).target}) {
      const DistributedSet& one = sets_[static_cast<std::size_t>(set)];
      is_come_to[static_cast<std::size_t>(set)].assign(static_cast<std::size_t>(one.local->size()), 0);
    }
  }
  std::vector<char> is_led_to(sets_.size(), 0);
  is_led_to[static_cast<std::size_t>(path.origin)] = 1;
  for (std::size_t k = 0; k < path.followed.size(); ++k) {
    for (const int c : path.followed) {
      if (is_led_to[static_cast<std::size_t>(connection(c).source)] != 0) {
        is_led_to[static_cast<std::size_t>(connection(c).target)] = 1;
      }
    }
  }
  for (const int c : path.followed) {  // it is not known how the step comes to these
    if (is_led_to[static_cast<std::size_t>(connection(c).source)] == 0) come_to_all(connection(c).source);
  }
  come_to_all(path.origin);
  const DistributedSet& origin = sets_[static_cast<std::size_t>(path.origin)];
  if (!path.is_of_ghosts && origin.kind == DistributedSet::Kind::owned) {
    for (std::size_t g = 0; g < origin.local->ghosts().size(); ++g) {
      is_come_to[static_cast<std::size_t>(path.origin)][static_cast<std::size_t>(origin.local->ghost(g))] = 0;
    }
  }
  for (bool is_again = true; is_again;) {
    is_again = false;
    for (const int c : path.followed) {
      const std::vector<char>& sources = is_come_to[static_cast<std::size_t>(connection(c).source)];
      std::vector<char>& targets = is_come_to[static_cast<std::size_t>(connection(c).target)];
      for (const auto& [from, to] : connection(c).to_ghosts) {
        char& is_there = targets[static_cast<std::size_t>(to)];
        if (sources[static_cast<std::size_t>(from)] == 0 || is_there != 0) continue;
        is_there = 1;
        is_again = true;
      }
    }
  }
  const LocalSet& target = *sets_[static_cast<std::size_t>(connection(path.last.front()).target)].local;
  std::vector<char> has(target.ghosts().size(), 0);
  for (const int c : path.last) {
    const std::vector<char>& sources = is_come_to[static_cast<std::size_t>(connection(c).source)];
    for (const auto& [from, to] : connection(c).to_ghosts) {
      if (sources[static_cast<std::size_t>(from)] != 0 && target.is_ghost(to)) has[target.ghost_number(to)] = 1;
    }
  }
  return has;
}

int Partition::add_need(int set, std::vector<char> has) {
  std::vector<HaloNeed>& needs = sets_[static_cast<std::size_t>(set)].needs;
  const std::size_t count = needs.size();
  // Of each need two bits are told to all ranks: whether it has all of the new one, and the new one all of it.
  constexpr std::size_t most = 31;
  if (count == most) return 0;
  const auto is_within = [](const std::vector<char>& some, const std::vector<char>& others) {
    return std::ranges::equal(some, others, [](char one, char other) { return one <= other; });
  };
  std::uint64_t mine = 0;
  for (std::size_t n = 0; n < count; ++n) {
    mine |= std::uint64_t{is_within(has, needs[n].has)} << (2 * n);
    mine |= std::uint64_t{is_within(needs[n].has, has)} << (2 * n + 1);
  }
  std::uint64_t of_all = ~std::uint64_t{0};
  const std::vector<index_t> told(static_cast<std::size_t>(ranks_.count()), static_cast<index_t>(mine));
  for (const index_t of_rank : transport_->all_to_all(told)) of_all &= static_cast<std::uint64_t>(of_rank);
  HaloNeedBits around = 0, within = HaloNeedBits{1} << count;
  for (std::size_t n = 0; n < count; ++n) {
    const std::uint64_t both = of_all >> (2 * n) & 3;
    if (both == 3) return static_cast<int>(n);
    if ((both & 1) != 0) around |= HaloNeedBits{1} << n;
    if ((both & 2) != 0) within |= HaloNeedBits{1} << n;
  }
  for (std::size_t n = 1; n < count; ++n) {
    if ((around >> n & 1) != 0) needs[n].within |= HaloNeedBits{1} << count;
  }
  for (DistributedArray& array : arrays_) {
    if (array.set != set) continue;
    for (HaloNeedBits& fresh : array.fresh) {
      if ((fresh & around) != 0) fresh |= HaloNeedBits{1} << count;
    }
  }
  HaloPlan plan = make_halo_plan(*sets_[static_cast<std::size_t>(set)].local, *transport_, needs.front().plan, has);
  needs.push_back({std::move(plan), std::move(has), within});
  return static_cast<int>(count);
}

}  // namespace physgen
