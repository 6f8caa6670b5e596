// Steps: ranges, exchanges, and what is fresh. step_uses.cpp says what kernels use.
#include <physgen/distributed/halo_steps.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace physgen {

const DistributedSet& HaloSteps::set_of_array(int array) const {
  return arrays_.sets()[static_cast<std::size_t>(arrays_.arrays()[static_cast<std::size_t>(array)].set)];
}

bool HaloSteps::is_fresh(const Field& field) const {
  return arrays_.arrays()[static_cast<std::size_t>(field.array)].is_fresh[static_cast<std::size_t>(field.field)] != 0;
}

HaloSteps::Objects HaloSteps::begin(std::span<const Kernel> kernels, index_t size, Way way) {
  if (open_.name != nullptr) {
    throw Error(*kernels.front().name + " runs between two parts of the reduction of " + *open_.name +
                ", of which ranks may have other numbers; run it behind the last part, or reduce all in one part");
  }
  if (current_ != nullptr) {
    throw Error(*kernels.front().name + " is begun inside of the step of " + current_name_ +
                ", behind which it is not known yet what is fresh; run it behind that step");
  }
  Key key;
  for (const Kernel& kernel : kernels) {
    key.push_back(reinterpret_cast<std::intptr_t>(kernel.name));
    // By numbers, not addresses, so that all ranks find a step, or none does.
    for (const KernelView& view : kernel.views) key.push_back(view.base == nullptr ? -2 : arrays_.find(view.base));
  }
  auto found = steps_.find(key);
  if (found == steps_.end()) found = steps_.emplace(std::move(key), resolve(kernels, size)).first;
  const Step& step = found->second;
  if (step.set < 0) {
    require_size_of_all_ranks(kernels, size, way);
    current_ = &step;
    current_name_ = *kernels.front().name;
    on_ghosts_ = true;
    return {0, size, nullptr};
  }
  const DistributedSet& over = arrays_.sets()[static_cast<std::size_t>(step.set)];
  const index_t expected = over.local ? over.local->size() : size;
  if (size != expected) {
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
  current_ = &step;
  current_name_ = *kernels.front().name;
  std::vector<Field> stale;
  for (const Field& field : step.gathered) {
    if (!is_fresh(field)) stale.push_back(field);
  }
  if (!stale.empty()) begin_exchange(stale);
  // A kernel that gathers what it writes finds there what its calls have left so far.
  const auto is_written = [&](const Field& field) { return step.written.contains(field); };
  const bool is_split = !stale.empty() && way != Way::at_once && step.is_known &&
                        over.kind == DistributedSet::Kind::owned && std::ranges::none_of(step.gathered, is_written);
  std::vector<Range> inner;
  if (is_split) inner = inner_of(over, way);
  if (!stale.empty() && inner.empty()) arrive();
  if (step.is_gathered) {
    const int rank = arrays_.ranks().rank();
    return {over.computed->begin(rank), over.computed->end(rank), nullptr};
  }
  on_ghosts_ = way != Way::at_once && step.reaches_on_ghosts &&
               std::ranges::all_of(step.own, [&](const Field& f) { return is_fresh(f); });
  if (!over.local) return {0, size, nullptr};  // entries, of which there are no ghosts
  const LocalSet& objects = *over.local;
  if (over.kind == DistributedSet::Kind::replicated) return {0, size, nullptr};
  const Range all{objects.first(), objects.last()}, owned{objects.begin(), objects.end()};
  const Range& called = on_ghosts_ && way == Way::run ? all : owned;
  const bool is_also_called = on_ghosts_ && way == Way::reduce && !step.written.empty();
  return {called.begin, called.end, &objects, std::move(inner), is_also_called ? all : Range{0, 0}};
}

std::vector<HaloSteps::Range> HaloSteps::inner_of(const DistributedSet& over, Way way) const {
  if (over.reached.empty()) return {};
  std::uint64_t crossing = 0;
  for (const Field& field : exchange_.fields) {
    crossing |= std::uint64_t{1} << (arrays_.arrays()[static_cast<std::size_t>(field.array)].set % 64);
  }
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
    if ((reached & crossing) != 0) continue;
    if (!inner.empty() && inner.back().end == at) {
      inner.back().end = end;
    } else {
      inner.push_back({at, end});
    }
  }
  std::erase_if(inner, [=](const Range& range) { return range.end - range.begin < least; });
  return inner;
}

void HaloSteps::end() {
  const Step* const step = std::exchange(current_, nullptr);
  if (step == nullptr || step->set < 0) return;
  if (step->is_gathered) return gather_written(*step);
  if (arrays_.sets()[static_cast<std::size_t>(step->set)].kind != DistributedSet::Kind::owned) return;
  for (const Field& field : step->written) {
    // A step may write some objects of the field, or some of its elements: of ghosts the others stay as they were.
    if (on_ghosts_ && is_fresh(field)) continue;
    arrays_.arrays()[static_cast<std::size_t>(field.array)].is_fresh[static_cast<std::size_t>(field.field)] = 0;
    if (poisons_) poison(field);
  }
}

HaloSteps::Objects HaloSteps::begin_part(std::span<const Kernel> kernels, const PartOfReduction& part) {
  const std::string* const name = kernels.front().name;
  if (part.first != open_.next || (open_.name != nullptr && (open_.name != name || open_.of != part.of))) {
    const std::string of_open = open_.name == nullptr ? "no reduction" : "one of " + *open_.name;
    throw Error("a part of the reduction of " + *name + " begins at object " + std::to_string(part.first) + " of " +
                std::to_string(part.of) + ", where " + of_open + " is done up to object " + std::to_string(open_.next) +
                "; give all parts, in ascending order, and without others between them");
  }
  if (open_.name == nullptr) {
    Objects objects = begin(kernels, part.of, Way::reduce);
    if (!objects.inner.empty()) arrive();
    objects.inner.clear();
    open_ = {name, 0, part.of, objects, current_};
  }
  open_.next = part.first + part.count;
  return open_.objects;
}

void HaloSteps::end_part(const PartOfReduction& part) {
  if (!part.is_last()) return;
  open_ = {};
  end();
}

void HaloSteps::poison(const Field& field) {
  const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
  const LocalSet& objects = *set_of_array(field.array).local;
  const UntypedArray& memory = array.memory;
  const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
  const int size = element_bytes(info.type);
  const std::uint64_t bits = bits_of_no_value(info.type);
  for (std::size_t g = 0; g < objects.ghosts().size(); ++g) {
    for (int k = 0; k < info.count && size > 0; ++k) {
      std::memcpy(memory.address(objects.ghost(g), info.offset + k * size, size), &bits,
                  static_cast<std::size_t>(size));
    }
  }
}

namespace {

/// Calls use(address, bytes) for the elements of a field of an object.
template <class Use>
void each_element(const UntypedArray& memory, const FieldInfo& info, index_t object, const Use& use) {
  const int size = element_bytes(info.type);
  for (int k = 0; k < info.count && size > 0; ++k) {
    use(memory.address(object, info.offset + k * size, size), static_cast<std::size_t>(size));
  }
}

}  // namespace

void HaloSteps::gather_written(const Step& step) {
  const Runs& runs = *arrays_.sets()[static_cast<std::size_t>(step.set)].computed;
  const int mine = arrays_.ranks().rank();
  const auto each = [&](int rank, const auto& use) {
    for (const Field& field : step.written) {
      const UntypedArray& memory = arrays_.arrays()[static_cast<std::size_t>(field.array)].memory;
      const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
      for (index_t i = runs.begin(rank); i < runs.end(rank); ++i) each_element(memory, info, i, use);
    }
  };
  index_t bytes_of_object = 0;
  for (const Field& field : step.written) {
    const UntypedArray& memory = arrays_.arrays()[static_cast<std::size_t>(field.array)].memory;
    const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
    bytes_of_object += info.count * element_bytes(info.type);
  }
  std::vector<index_t> sizes;
  for (int r = 0; r < runs.ranks(); ++r) sizes.push_back((runs.end(r) - runs.begin(r)) * bytes_of_object);
  std::vector<std::byte> given, all(static_cast<std::size_t>(runs.size() * bytes_of_object));
  each(mine, [&](const std::byte* at, std::size_t size) { given.insert(given.end(), at, at + size); });
  arrays_.transport().gather(given, sizes, all);
  const std::byte* from = all.data();
  for (int r = 0; r < runs.ranks(); ++r) {
    each(r, [&](std::byte* at, std::size_t size) {
      std::memcpy(at, from, size);
      from += size;
    });
  }
}

void HaloSteps::begin_exchange(const std::vector<Field>& fields) {
  const auto ranks = static_cast<std::size_t>(arrays_.ranks().count());
  exchange_ = {fields, std::vector<std::vector<std::byte>>(ranks), std::vector<std::vector<std::byte>>(ranks)};
  std::vector<std::size_t> to_come(ranks, 0);
  // All fields of a step go in one message to each rank: field by field, object by object, element by element.
  for (const Field& field : fields) {
    DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
    const UntypedArray& memory = array.memory;
    const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
    for (const HaloPlan::Peer& peer : set_of_array(field.array).plan.peers) {
      const auto r = static_cast<std::size_t>(peer.rank);
      std::vector<std::byte>& sent = exchange_.sent[r];
      for (const index_t object : peer.sent) {
        each_element(memory, info, object,
                     [&](const std::byte* at, std::size_t size) { sent.insert(sent.end(), at, at + size); });
      }
      to_come[r] += static_cast<std::size_t>((peer.last - peer.first) * info.count * element_bytes(info.type));
    }
    array.is_fresh[static_cast<std::size_t>(field.field)] = 1;
  }
  std::vector<Message> messages;
  for (std::size_t r = 0; r < ranks; ++r) {
    exchange_.received[r].resize(to_come[r]);
    if (exchange_.sent[r].empty() && to_come[r] == 0) continue;
    messages.push_back({static_cast<int>(r), exchange_.sent[r], exchange_.received[r]});
  }
  arrays_.transport().begin(messages);
}

void HaloSteps::arrive() {
  arrays_.transport().end();
  std::vector<std::size_t> taken(exchange_.received.size(), 0);
  for (const Field& field : exchange_.fields) {
    const UntypedArray& memory = arrays_.arrays()[static_cast<std::size_t>(field.array)].memory;
    const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
    for (const HaloPlan::Peer& peer : set_of_array(field.array).plan.peers) {
      const auto r = static_cast<std::size_t>(peer.rank);
      for (index_t object = peer.first; object < peer.last; ++object) {
        each_element(memory, info, object, [&](std::byte* at, std::size_t size) {
          std::memcpy(at, exchange_.received[r].data() + taken[r], size);
          taken[r] += size;
        });
      }
    }
  }
  exchange_ = {};
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
