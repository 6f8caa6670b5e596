// Lists and numbers of edges while graphs are made. For hierarchy.cpp.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace physgen::fem::detail {

using Pair = std::array<Index, 2>;

/// Entries under the objects they belong to, in the order in which they come.
class Lists {
 public:
  explicit Lists(std::size_t objects) : count_(objects + 1, 0) {}
  void add(Index object, Index element, Index local) {
    ++count_[static_cast<std::size_t>(object) + 1];
    objects_.push_back(object);
    entries_.push_back({element, local});
  }
  [[nodiscard]] IncidenceList take() {
    if (entries_.size() > std::size_t{std::numeric_limits<Index>::max()}) {
      throw Error("a list of the solver would have " + std::to_string(entries_.size()) +
                  " entries, but 32-bit numbers only reach 2^31 - 1; use fewer cells");
    }
    IncidenceList list;
    list.first.resize(count_.size());
    std::partial_sum(count_.begin(), count_.end(), list.first.begin());
    list.entries.resize(entries_.size());
    std::vector<Index> next(list.first.begin(), list.first.end() - 1);
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      list.entries[static_cast<std::size_t>(next[static_cast<std::size_t>(objects_[k])]++)] = entries_[k];
    }
    return list;
  }

 private:
  std::vector<Index> count_, objects_;
  std::vector<IncidenceEntry> entries_;
};

/// Numbers of edges by their ends: edges ascend, so those of a first node lie side by side.
class EdgeNumbers {
 public:
  EdgeNumbers(Index nodes, const std::vector<Pair>& edges)
      : edges_(edges), first_(static_cast<std::size_t>(nodes) + 1) {
    for (const auto& [m, n] : edges) ++first_[static_cast<std::size_t>(m) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }
  /// @pre m < n, and the edge exists
  [[nodiscard]] Index of(Index m, Index n) const {
    const auto from = edges_.begin() + first_[static_cast<std::size_t>(m)];
    const auto to = edges_.begin() + first_[static_cast<std::size_t>(m) + 1];
    const auto found = std::lower_bound(from, to, Pair{m, n});
    if (found == to || *found != Pair{m, n}) {
      throw Error("nodes " + std::to_string(m) + " and " + std::to_string(n) +
                  " of the coarser level have no edge: the meshes are not nested");
    }
    return static_cast<Index>(found - edges_.begin());
  }

 private:
  const std::vector<Pair>& edges_;
  std::vector<Index> first_;
};

[[nodiscard]] inline Pair ordered(Index a, Index b) { return a < b ? Pair{a, b} : Pair{b, a}; }

inline void sort_unique(std::vector<Pair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace physgen::fem::detail
