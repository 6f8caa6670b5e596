// Steps: ranges, exchanges, and what is fresh. step_uses.cpp says what kernels use.
#include <physgen/distributed/halo_steps.h>

#include <algorithm>
#include <utility>

namespace physgen {

HaloSteps::HaloSteps(Partition& arrays, bool poisons, std::unique_ptr<HaloExchange> exchange)
    : arrays_(arrays),
      poisons_(poisons),
      exchange_(exchange != nullptr ? std::move(exchange) : make_host_exchange(arrays)) {}

const DistributedSet& HaloSteps::set_of_array(int array) const {
  return arrays_.sets()[static_cast<std::size_t>(arrays_.arrays()[static_cast<std::size_t>(array)].set)];
}

std::optional<index_t> HaloSteps::window_of(std::span<const Kernel> kernels) const {
  std::optional<index_t> least;
  for (const Kernel& kernel : kernels) {
    for (const KernelView& view : kernel.views) {
      const int array = view.base == nullptr ? -1 : arrays_.find(view.base);
      if (array < 0 || arrays_.arrays()[static_cast<std::size_t>(array)].window == 0) continue;
      least = std::min(least.value_or(view.size), view.size);
    }
  }
  return least;
}

bool HaloSteps::writes_window(const Step& step) const {
  return std::ranges::any_of(step.written, [&](const Field& field) {
    return arrays_.arrays()[static_cast<std::size_t>(field.array)].window > 0;
  });
}

void HaloSteps::require_of_window(std::span<const Kernel> kernels, const Step& step, index_t size) const {
  const std::string what = *kernels.front().name + " writes a window of set " +
                           arrays_.sets()[static_cast<std::size_t>(step.set)].name + ", ";
  if (!step.reaches_on_ghosts) {
    throw Error(what +
                "and what it reads is not here for ghosts, too; give it rows in the table of kernels, and let "
                "the set follow the one that its objects name");
  }
  if (const index_t window = *window_of(kernels); size > window) {
    throw Error(what + "which has " + std::to_string(window) + " objects, and is run over " + std::to_string(size) +
                "; run it over a window at a time");
  }
}

HaloSteps::Objects HaloSteps::begin(std::span<const Kernel> kernels, index_t size, Way way) {
  const bool is_of_window = window_of(kernels).has_value();
  if (open_.name != nullptr && !(is_of_window && open_.is_of_window)) {
    throw Error(*kernels.front().name + " runs between two parts of the reduction of " + *open_.name +
                ", of which ranks may have other numbers; run it behind the last part, or reduce all in one part");
  }
  if (is_of_window && way != Way::run) {
    throw Error(*kernels.front().name + " has a view of a window of a set, and " +
                (way == Way::reduce ? "is reduced at once; reduce it in parts of a window, reduce_part()"
                                    : "is done by code that is not split; let a kernel be run"));
  }
  return begin_step(kernels, size, way, is_of_window);
}

HaloSteps::Objects HaloSteps::begin_step(std::span<const Kernel> kernels, index_t size, Way way, bool is_of_window) {
  if (current_ != nullptr) {
    throw Error(*kernels.front().name + " is begun inside of the step of " + current_name_ +
                ", behind which it is not known yet what is fresh; run it behind that step");
  }
  Key key;
  for (const Kernel& kernel : kernels) {
    key.push_back(reinterpret_cast<std::intptr_t>(kernel.name));
    // By numbers, not addresses, so that all ranks find a step, or none does. Of what is none of the arrays, a number
    // that all ranks keep is told from an array, which resolve() refuses.
    for (const KernelView& view : kernel.views) {
      const int array = view.base == nullptr ? -2 : arrays_.find(view.base);
      key.push_back(array == -1 && view.size != 1 ? -3 : array);
    }
  }
  auto found = steps_.find(key);
  if (found == steps_.end()) found = steps_.emplace(std::move(key), resolve(kernels, size)).first;
  const Step& step = found->second;
  if (step.set < 0) {
    require_size_of_all_ranks(kernels, size, way, is_of_window);
    current_ = &step;
    current_name_ = *kernels.front().name;
    on_ghosts_ = true;
    return {0, size, nullptr};
  }
  const DistributedSet& over = arrays_.sets()[static_cast<std::size_t>(step.set)];
  const index_t expected = over.local ? over.local->size() : size;
  const bool is_window = is_of_window && way == Way::run;
  if (is_window ? size > expected : size != expected) {
    throw Error(*kernels.front().name + " is run over " + std::to_string(size) + " objects, and set " + over.name +
                " has " + std::to_string(expected) + " here; run it over all, array.size()");
  }
  if (way == Way::reduce && over.kind == DistributedSet::Kind::entries) {
    throw Error(*kernels.front().name + " is reduced over the entries of rows, " + over.name +
                ", which have no blocks that all numbers of ranks have; reduce over the objects that have the rows");
  }
  if (step.is_gathered && way != Way::run) {
    throw Error(
        *kernels.front().name + (way == Way::reduce ? " is reduced" : " is done by code of the program's own") +
        " over set " + over.name +
        ", which all ranks have, and reads others of which ranks have parts; let a kernel that is run write what "
        "it reads of these into an array of the set");
  }
  on_ghosts_ = way != Way::at_once && can_be_of_ghosts(step);
  if (writes_window(step)) {  // whose objects never cross: each rank computes all that it has
    require_of_window(kernels, step, is_window ? size : 0);
    on_ghosts_ = true;
  }
  current_ = &step;
  current_name_ = *kernels.front().name;
  const std::vector<HaloFetch> stale = stale_of(step);
  if (!stale.empty()) begin_exchange(stale);
  // A kernel that gathers what it writes finds there what its calls have left so far.
  const auto is_gathered = [&](const Field& field) { return step.gathered.contains(field); };
  const bool is_split = !stale.empty() && way != Way::at_once && !is_window && step.is_known &&
                        over.kind == DistributedSet::Kind::owned && std::ranges::none_of(step.written, is_gathered);
  std::vector<Range> inner;
  if (is_split) inner = inner_of(over, way);
  if (!stale.empty() && inner.empty()) arrive();
  if (step.is_gathered) {
    const int rank = arrays_.ranks().rank();
    return {over.computed->begin(rank), over.computed->end(rank), nullptr};
  }
  if (!over.local || is_window) return {0, size, nullptr};  // of entries there are no ghosts
  const LocalSet& objects = *over.local;
  if (over.kind == DistributedSet::Kind::replicated) return {0, size, nullptr};
  const Range all{objects.first(), objects.last()}, owned{objects.begin(), objects.end()};
  const Range& called = on_ghosts_ && way == Way::run ? all : owned;
  const bool is_also_called = on_ghosts_ && way == Way::reduce && !step.written.empty();
  return {called.begin, called.end, &objects, std::move(inner), is_also_called ? all : Range{0, 0}};
}

std::vector<HaloSteps::Range> HaloSteps::inner_of(const DistributedSet& over, Way way) const {
  if (over.reached.empty()) return {};
  // A reduction has whole blocks, other steps whole packs. A few long ranges: each is a launch.
  const index_t unit = way == Way::reduce ? Runs::block : DistributedSet::group;
  const index_t least = over.local->owned() / 32;
  std::vector<Range> inner;
  for (index_t at = over.local->begin(); at < over.local->end(); at += unit) {
    const index_t end = std::min(at + unit, over.local->end());
    std::uint64_t reached = 0;
    for (index_t g = at; g < end; g += DistributedSet::group) {
      reached |= over.reached[static_cast<std::size_t>(g / DistributedSet::group)];
    }
    if ((reached & crossing_) != 0) continue;
    if (!inner.empty() && inner.back().end == at) {
      inner.back().end = end;
    } else {
      inner.push_back({at, end});
    }
  }
  std::erase_if(inner, [=](const Range& range) { return range.end - range.begin < least; });
  return inner;
}

HaloSteps::Objects HaloSteps::begin_part(std::span<const Kernel> kernels, const PartOfReduction& part) {
  const std::string* const name = kernels.front().name;
  if (part.first != open_.next || (open_.name != nullptr && (open_.name != name || open_.of != part.of))) {
    const std::string of_open = open_.name == nullptr ? "no reduction" : "one of " + *open_.name;
    throw Error("a part of the reduction of " + *name + " begins at object " + std::to_string(part.first) + " of " +
                std::to_string(part.of) + ", where " + of_open + " is done up to object " + std::to_string(open_.next) +
                "; give all parts, in ascending order, and without others between them");
  }
  const std::optional<index_t> window = window_of(kernels);
  if (window && part.count > *window) {
    throw Error("a part of the reduction of " + *name + " has " + std::to_string(part.count) +
                " objects, and a window " + std::to_string(*window) + "; make parts no larger than the window");
  }
  if (open_.name == nullptr) {
    Objects objects = begin_step(kernels, part.of, Way::reduce, window.has_value());
    if (!objects.inner.empty()) arrive();
    objects.inner.clear();
    open_ = {name, 0, part.of, objects, current_, on_ghosts_, window.has_value()};
  }
  current_ = open_.step;
  current_name_ = *name;
  on_ghosts_ = open_.on_ghosts;
  if (part.first > 0 && open_.is_of_window) {
    const std::vector<HaloFetch> stale = stale_of(*open_.step);
    if (!stale.empty()) {
      throw Error("a step between two parts of the reduction of " + *name + " wrote " + name_of(stale.front().field) +
                  ", which later parts read of other ranks' objects; write it behind the last part");
    }
  }
  open_.next = part.first + part.count;
  return open_.objects;
}

void HaloSteps::end_part(const PartOfReduction& part) {
  if (!part.is_last()) {
    if (open_.is_of_window) current_ = nullptr;  // others may run, before the next part
    return;
  }
  open_ = {};
  end();
}

void HaloSteps::require_replicated(std::span<const KernelView> views, const std::string& of) const {
  for (const KernelView& view : views) {
    const int array = view.base == nullptr ? -1 : arrays_.find(view.base);
    if (array < 0 || set_of_array(array).kind == DistributedSet::Kind::replicated) continue;
    throw Error(of + " uses " + arrays_.arrays()[static_cast<std::size_t>(array)].name +
                ", of which ranks have parts of set " + set_of_array(array).name +
                "; let a kernel reduce what is wanted into an array that all ranks have");
  }
}

std::string HaloSteps::name_of(const Field& field) const {
  const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
  return array.name + "." + std::string(array.memory.fields[static_cast<std::size_t>(field.field)].name);
}

}  // namespace physgen
