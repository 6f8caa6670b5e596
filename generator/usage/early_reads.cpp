// See graph.h. Each function is followed once, where the program calls it first: what it does to a field for the first
// time, it does there.
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "usage/graph.h"

namespace physgen::usage {
namespace {

class Order {
 public:
  explicit Order(const Graph& graph) : graph_(graph) {
    for (const Step& step : graph.steps) steps_.emplace(step.function, &step);
  }

  std::vector<EarlyRead> early_reads() && {
    if (graph_.program >= 0) follow(graph_.program, {});
    return std::move(reads_);
  }

 private:
  /// On the way to a function.
  struct Way {
    const Step* step = nullptr;
    Place place;             // of the last call in the step's own source, or in the program's
    bool is_certain = true;  // all calls are
    bool whole_object = false;
  };

  void follow(int f, Way way) {
    if (!seen_.emplace(f, way.whole_object).second) return;
    const Function& here = graph_.functions[static_cast<std::size_t>(f)];
    if (here.access != Access::none) return access(here, way);
    if (const auto step = steps_.find(f); way.step == nullptr && step != steps_.end()) way.step = step->second;
    way.whole_object = way.whole_object || here.whole_object;
    const bool is_own = way.step == nullptr ? !here.of_library : way.step->own_files.contains(here.place.file);
    for (const Call& call : here.calls) {
      Way next = way;
      if (is_own) next.place = call.place;
      next.is_certain = way.is_certain && call.is_certain;
      follow(call.to, std::move(next));
    }
  }

  void access(const Function& made, const Way& way) {
    const FieldUse& field = graph_.fields[static_cast<std::size_t>(made.field)].use;
    const auto name = std::pair(field.array, field.field);
    if (made.access != Access::read) written_.insert(name);
    if (written_.contains(name) || !way.is_certain || !known_.emplace(name, way.whole_object).second) return;
    reads_.push_back(
        {field.array, field.field, way.step == nullptr ? StepUse() : way.step->use, way.place, way.whole_object});
  }

  using Name = std::pair<std::string, std::string>;  // array, field

  const Graph& graph_;
  std::map<int, const Step*> steps_;     // by function
  std::set<std::pair<int, bool>> seen_;  // functions, and whether for whole objects
  std::set<Name> written_;
  std::set<std::pair<Name, bool>> known_;
  std::vector<EarlyRead> reads_;
};

}  // namespace

std::vector<EarlyRead> early_reads(const Graph& graph) { return Order(graph).early_reads(); }

}  // namespace physgen::usage
