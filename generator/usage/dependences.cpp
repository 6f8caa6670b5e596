// See graph.h.
#include <algorithm>
#include <map>
#include <utility>

#include "usage/graph.h"

namespace physgen::usage {
namespace {

/// Instances of one function: those that calls lead to over probes, and those that the same calls lead to over others.
struct Instances {
  std::set<int> over_probes, over_others;
  auto operator<=>(const Instances&) const = default;
};

class Comparison {
 public:
  explicit Comparison(const Graph& graph)
      : graph_(graph), leads_(graph.functions.size(), false), found_(graph.functions.size()) {
    find_what_leads_to_the_program();
  }

  std::vector<Dependence> compare() && {
    for (std::size_t v = 1; v < graph_.variants.size(); ++v) next({{graph_.variants.front()}, {graph_.variants[v]}});
    while (!queue_.empty()) {
      const Instances pair = *queue_.back();
      queue_.pop_back();
      calls(pair, facts(pair));
    }
    std::vector<Dependence> result;  // one for each line is enough
    for (const auto& [place, what] : differences_)
      if (result.empty() || result.back().place.file != place.file || result.back().place.line != place.line)
        result.push_back({place, what});
    return result;
  }

 private:
  [[nodiscard]] const Function& at(int f) const { return graph_.functions[static_cast<std::size_t>(f)]; }

  /// Most functions of libraries call none of the program.
  void find_what_leads_to_the_program() {
    std::vector<std::vector<int>> callers(graph_.functions.size());
    std::vector<int> queue;
    for (std::size_t f = 0; f < graph_.functions.size(); ++f) {
      for (const Call& call : graph_.functions[f].calls)
        callers[static_cast<std::size_t>(call.to)].push_back(static_cast<int>(f));
      if (!graph_.functions[f].of_library) queue.push_back(static_cast<int>(f));
    }
    while (!queue.empty()) {
      const auto f = static_cast<std::size_t>(queue.back());
      queue.pop_back();
      if (leads_[f]) continue;
      leads_[f] = true;
      queue.insert(queue.end(), callers[f].begin(), callers[f].end());
    }
  }

  /// The program's functions that a call of `function` leads to, through libraries' alone.
  const std::vector<int>& of_program(int function) {
    std::vector<int>& result = found_[static_cast<std::size_t>(function)];
    if (!result.empty() || !leads_[static_cast<std::size_t>(function)]) return result;
    std::set<int> seen;
    std::vector<int> queue = {function};
    while (!queue.empty()) {
      const int f = queue.back();
      queue.pop_back();
      if (!leads_[static_cast<std::size_t>(f)] || !seen.insert(f).second) continue;
      if (at(f).of_library)
        for (const Call& call : at(f).calls) queue.push_back(call.to);
      else
        result.push_back(f);
    }
    return result;
  }

  void next(Instances pair) {
    if (const auto [entry, is_new] = seen_.insert(std::move(pair)); is_new) queue_.push_back(&*entry);
  }

  using Lines = std::set<std::pair<std::string, int>>;

  /// @param different lines of the callers: what is called there alone need not be said
  void calls(const Instances& pair, const Lines& different) {
    std::map<std::pair<Place, Place>, Instances> callees;  // by places of the call, and of the function
    const auto add = [&](const std::set<int>& callers, std::set<int> Instances::* which) {
      for (const int f : callers)
        for (const Call& call : at(f).calls)
          for (const int to : of_program(call.to)) (callees[{call.place, at(to).place}].*which).insert(to);
    };
    add(pair.over_probes, &Instances::over_probes);
    add(pair.over_others, &Instances::over_others);
    for (auto& [places, callee] : callees) {
      const auto& [call, function] = places;
      const std::set<int>& called = callee.over_probes.empty() ? callee.over_others : callee.over_probes;
      const bool is_called_by_both = !callee.over_probes.empty() && !callee.over_others.empty();
      if (is_called_by_both || std::ranges::all_of(called, [&](int f) { return at(f).facts.empty(); }))
        next(std::move(callee));
      else if (different.count({call.file, call.line}) == 0)
        differences_.try_emplace(function, callee.over_probes.empty() ? "a call or nothing" : "nothing or a call");
    }
  }

  using Facts = std::map<Place, std::set<std::string>>;
  [[nodiscard]] Facts facts_of(const std::set<int>& functions) const {
    Facts facts;
    for (const int f : functions)
      for (const Fact& fact : at(f).facts) facts[fact.place].insert(fact.what);
    return facts;
  }

  /// @return the lines at which they differ
  Lines facts(const Instances& pair) {
    if (pair.over_probes.size() == 1 && pair.over_others.size() == 1 &&
        at(*pair.over_probes.begin()).facts == at(*pair.over_others.begin()).facts)
      return {};
    Lines lines;
    Facts expected = facts_of(pair.over_probes), found = facts_of(pair.over_others), places = found;
    places.insert(expected.begin(), expected.end());
    const auto text = [](const std::set<std::string>& of, const std::set<std::string>& without) {
      std::string result;
      for (const std::string& what : of)
        if (without.count(what) == 0) result += (result.empty() ? "" : " and ") + what;
      return result.empty() ? std::string("nothing") : result;
    };
    for (const auto& [place, ignored] : places) {
      if (found[place] == expected[place]) continue;
      lines.emplace(place.file, place.line);
      differences_.try_emplace(place,
                               text(found[place], expected[place]) + " or " + text(expected[place], found[place]));
    }
    return lines;
  }

  const Graph& graph_;
  std::vector<bool> leads_;
  std::vector<std::vector<int>> found_;  // of_program(), where it has been asked for
  std::set<Instances> seen_;
  std::vector<const Instances*> queue_;
  std::map<Place, std::string> differences_;
};

}  // namespace

std::vector<Dependence> dependences(const Graph& graph) { return Comparison(graph).compare(); }

}  // namespace physgen::usage
