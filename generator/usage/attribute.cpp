// See graph.h.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "usage/graph.h"

namespace physgen::usage {
namespace {

/// A field that functions lead to, and whether by a get() or put() of whole objects.
struct Reached {
  int function = 0;  // that makes the access
  bool whole_object = false;
  auto operator<=>(const Reached&) const = default;
};

class Attribution {
 public:
  explicit Attribution(const Graph& graph)
      : graph_(graph), callers_(graph.functions.size()), leads_(graph.functions.size(), false) {
    find_what_leads_to_accesses();
  }

  Usage usage() {
    Usage result;
    std::set<int> steps_lead_to;
    for (const Step& step : graph_.steps) {
      if (is_part_of_a_step(step.function)) continue;
      StepUse use = step.use;
      const Own own = [&](const Function& f) { return step.own_files.count(f.place.file) != 0; };
      use.fields = accesses({step.function}, own);
      const std::set<int> lead_to = reached_;
      const std::vector<PartUse> parts = this->parts(lead_to, own);
      races(parts, result);
      use.kernels = kernels(step, parts, own);
      steps_lead_to.insert(lead_to.begin(), lead_to.end());
      result.steps.push_back(std::move(use));
    }
    unattributed(steps_lead_to, result);
    result.unknown = graph_.unknown;
    result.early_reads = early_reads(graph_);
    sort(result);
    return result;
  }

 private:
  using Own = std::function<bool(const Function&)>;

  [[nodiscard]] const Function& at(int f) const { return graph_.functions[static_cast<std::size_t>(f)]; }

  /// Whether a function is called by functions of steps alone: of a reduction, the kernel.
  [[nodiscard]] bool is_part_of_a_step(int function) const {
    const auto& callers = callers_[static_cast<std::size_t>(function)];
    return !callers.empty() && std::ranges::all_of(callers, [&](int caller) {
      return std::ranges::any_of(graph_.steps, [&](const Step& step) { return step.function == caller; });
    });
  }

  /// Most functions of a program lead to no access and need not be looked at again.
  void find_what_leads_to_accesses() {
    std::vector<int> next;
    for (std::size_t f = 0; f < graph_.functions.size(); ++f) {
      for (const Call& call : graph_.functions[f].calls)
        callers_[static_cast<std::size_t>(call.to)].push_back(static_cast<int>(f));
      if (graph_.functions[f].access != Access::none) next.push_back(static_cast<int>(f));
    }
    while (!next.empty()) {
      const auto f = static_cast<std::size_t>(next.back());
      next.pop_back();
      if (leads_[f]) continue;
      leads_[f] = true;
      next.insert(next.end(), callers_[f].begin(), callers_[f].end());
    }
  }

  [[nodiscard]] bool leads(int f) const { return leads_[static_cast<std::size_t>(f)]; }

  using Kind = bool Function::*;

  /// @param stop at functions of these kinds, but for those it starts from
  [[nodiscard]] std::set<int> reachable(const std::vector<int>& from, const std::vector<Kind>& stop = {}) const {
    std::set<int> result;
    std::vector<int> next = from;
    while (!next.empty()) {
      const int f = next.back();
      next.pop_back();
      if (!leads(f) || stop_.count(f) != 0 || !result.insert(f).second) continue;
      for (const Call& call : at(f).calls)
        if (std::ranges::none_of(stop, [&](Kind kind) { return at(call.to).*kind; })) next.push_back(call.to);
    }
    return result;
  }

  [[nodiscard]] std::vector<int> of_kind(const std::set<int>& functions, Kind kind) const {
    std::vector<int> result;
    std::ranges::copy_if(functions, std::back_inserter(result), [&](int f) { return at(f).*kind; });
    return result;
  }

  /// Accesses of other objects than the step's own, and those that add() makes: of code that is called with an index
  /// whose type tells it from all others.
  struct Others {
    std::set<int> gathered, added;
  };
  [[nodiscard]] Others others(std::vector<int> from) const {
    const std::vector<int> fused = of_kind(reached_, &Function::fused);
    from.insert(from.end(), fused.begin(), fused.end());
    const std::set<int> shown = reachable(from, {&Function::single_object});
    return {reachable(from, {&Function::single_object, &Function::adds}), reachable(of_kind(shown, &Function::adds))};
  }

  /// Accesses that `from` leads to through functions that are not the step's own.
  [[nodiscard]] std::set<Reached> through_others(int from, const Own& own) const {
    std::set<Reached> seen, result;
    std::vector<Reached> next = {{from, false}};
    while (!next.empty()) {
      Reached here = next.back();
      next.pop_back();
      if (!leads(here.function) || stop_.count(here.function) != 0 || own(at(here.function))) continue;
      if (!seen.insert(here).second) continue;
      if (at(here.function).access != Access::none) result.insert(here);
      here.whole_object = here.whole_object || at(here.function).whole_object;
      for (const Call& call : at(here.function).calls) next.push_back({call.to, here.whole_object});
    }
    return result;
  }

  [[nodiscard]] FieldUse use_of(int f, const Others& others) const {
    const Function& access = at(f);
    const auto& [field, of_part] = graph_.fields[static_cast<std::size_t>(access.field)];
    FieldUse use = field;
    // Steps that may become one are called for the same number, and those of a part mean another object by it.
    use.gathered = !use.own && (of_part || others.gathered.count(f) != 0);
    use.added = !use.own && others.added.count(f) != 0;
    use.address_taken = access.access == Access::address;
    use.read = access.access == Access::read;
    use.written = access.access == Access::write;
    const bool reads = use.read || use.address_taken, writes = use.written || use.address_taken || use.added;
    const bool is_own = use.own || (of_part && !use.added), is_others = !is_own && (use.gathered || use.added);
    use.reads_own = is_own && reads;
    use.writes_own = is_own && writes;
    use.reads_others = is_others && reads;
    use.writes_others = is_others && writes;
    return use;
  }

  /// All accesses that `from` leads to, with the calls of own functions that lead there; fills reached_.
  std::vector<FieldUse> accesses(const std::vector<int>& from, const Own& own) {
    std::vector<FieldUse> result;
    std::map<int, std::set<Reached>> known;
    reached_ = reachable(from);
    const Others others = this->others(from);
    for (const int f : reached_) {
      if (at(f).access != Access::none) add(result, use_of(f, others));
      if (!own(at(f))) continue;
      for (const Call& call : at(f).calls) {
        if (!leads(call.to)) continue;
        const auto [entry, is_new] = known.try_emplace(call.to);
        if (is_new) entry->second = through_others(call.to, own);
        for (const Reached& reached : entry->second) {
          FieldUse use = use_of(reached.function, others);
          use.places = {call.place};
          use.whole_object = reached.whole_object;
          if (use.read || use.address_taken) use.read_places = use.places;
          if (use.written || use.address_taken) use.written_places = use.places;
          if (use.whole_object) use.whole_places = use.places;
          add(result, use);
        }
      }
    }
    return result;
  }

  /// The uses in functions of the program that no step leads to, and in those that nothing known leads to.
  void unattributed(const std::set<int>& steps_lead_to, Usage& result) {
    std::vector<int> entries;
    for (const int f : graph_.entries)
      if (steps_lead_to.count(f) == 0) entries.push_back(f);
    for (const Step& step : graph_.steps) stop_.insert(step.function);
    result.unattributed = accesses(entries, [](const Function& f) { return !f.of_library; });
    for (std::size_t f = 0; f < graph_.functions.size(); ++f) {
      const bool known = steps_lead_to.count(static_cast<int>(f)) != 0 || reached_.count(static_cast<int>(f)) != 0;
      if (graph_.functions[f].access != Access::none && !known)
        add(result.unattributed, use_of(static_cast<int>(f), {}));
    }
  }

  /// The kernels of a fused kernel, and what each does.
  struct PartUse {
    std::string kernel;
    int behind = 0;
    std::string class_name;
    KernelViews views;
    std::vector<int> call_operators;
    std::vector<FieldUse> fields;
    std::set<std::string> calculated;
  };

  /// Of the last call of accesses().
  [[nodiscard]] std::set<std::string> calculated() const {
    std::set<std::string> arrays;
    for (const int f : reached_) arrays.insert(at(f).calculated.begin(), at(f).calculated.end());
    return arrays;
  }

  /// @param lead_to functions of a step, whose own ones have places
  std::vector<PartUse> parts(const std::set<int>& lead_to, const Own& own) {
    std::vector<PartUse> parts;
    for (const Part& part : graph_.parts) {
      if (lead_to.count(part.call_operator) == 0) continue;
      auto same = std::ranges::find_if(
          parts, [&](const PartUse& known) { return known.kernel == part.kernel && known.behind == part.behind; });
      if (same == parts.end())
        same = parts.insert(same, {part.kernel, part.behind, part.class_name, part.views, {}, {}, {}});
      same->call_operators.push_back(part.call_operator);
    }
    for (PartUse& part : parts) {
      part.fields = accesses(part.call_operators, own);
      part.calculated = calculated();
      if (makes_index(part.call_operators))
        for (FieldUse& use : part.fields) forget_own(use);
    }
    return parts;
  }
  /// Any object may be meant.
  static void forget_own(FieldUse& use) {
    use.own = false;
    use.reads_others = use.reads_others || use.read || use.address_taken;
    use.writes_others = use.writes_others || use.written || use.address_taken;
  }

  /// The kernels of a step: of a fused one its parts, of a reduction what is folded.
  std::vector<KernelUse> kernels(const Step& step, const std::vector<PartUse>& parts, const Own& own) {
    std::vector<KernelUse> result;
    for (const PartUse& part : parts) result.push_back({part.class_name, part.views, part.fields, part.calculated});
    if (!result.empty() || !step.views) return result;
    int function = step.function;
    for (const Call& call : at(function).calls)
      if (std::ranges::any_of(graph_.steps, [&](const Step& one) { return one.function == call.to; }))
        function = call.to;
    KernelUse kernel = {step.kernel, *step.views, accesses({function}, own), {}};
    kernel.calculated = calculated();
    if (makes_index({function}))
      for (FieldUse& use : kernel.fields) forget_own(use);
    result.push_back(std::move(kernel));
    return result;
  }

  static void races(const std::vector<PartUse>& parts, Usage& result) {
    for (const PartUse& one : parts)
      for (const PartUse& other : parts)
        if (&one != &other) races(one, other, result);
  }

  /// Whether types do not tell a kernel's own objects from others, since it, or what it calls, makes an index.
  [[nodiscard]] bool makes_index(std::vector<int> next) const {
    std::set<int> seen;
    while (!next.empty()) {
      const int f = next.back();
      next.pop_back();
      if (!seen.insert(f).second) continue;
      if (at(f).makes_index) return true;
      for (const Call& call : at(f).calls) next.push_back(call.to);
    }
    return false;
  }

  static void races(const PartUse& one, const PartUse& other, Usage& result) {
    const auto place = [](const FieldUse& use) { return use.places.empty() ? Place() : use.places.front(); };
    for (const FieldUse& writing : one.fields) {
      if (!writing.written && !writing.address_taken) continue;
      for (const FieldUse& use : other.fields) {
        if (use.array != writing.array || use.field != writing.field || may_be_fused(writing, use)) continue;
        result.races.push_back({use.array, use.field, one.kernel, other.kernel, place(writing), place(use)});
      }
    }
  }

  const Graph& graph_;
  std::vector<std::vector<int>> callers_;
  std::vector<bool> leads_;
  std::set<int> reached_;  // functions on the way to accesses, of the last call of accesses()
  std::set<int> stop_;     // not followed
};

}  // namespace

Usage attribute(const Graph& graph) { return Attribution(graph).usage(); }

}  // namespace physgen::usage
