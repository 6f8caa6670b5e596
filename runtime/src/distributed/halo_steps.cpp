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

HaloSteps::Objects HaloSteps::begin(std::span<const Kernel> kernels, index_t size, bool owned_only) {
  Key key;
  for (const Kernel& kernel : kernels) {
    key.push_back(reinterpret_cast<std::intptr_t>(kernel.name));
    // By numbers, not addresses, so that all ranks find a step, or none does.
    for (const KernelView& view : kernel.views) key.push_back(view.base == nullptr ? -2 : arrays_.find(view.base));
  }
  auto found = steps_.find(key);
  if (found == steps_.end()) found = steps_.emplace(std::move(key), resolve(kernels, size)).first;
  const Step& step = found->second;
  current_ = &step;
  if (step.set < 0) {
    on_ghosts_ = true;
    return {0, size, nullptr};
  }
  const DistributedSet& over = arrays_.sets()[static_cast<std::size_t>(step.set)];
  const index_t expected = over.local ? over.local->size() : size;
  if (size != expected) {
    throw Error(*kernels.front().name + " is run over " + std::to_string(size) + " objects, and set " + over.name +
                " has " + std::to_string(expected) + " here; run it over all, array.size()");
  }
  if (owned_only && over.kind == DistributedSet::Kind::entries) {
    throw Error(*kernels.front().name + " is reduced over the entries of rows, " + over.name +
                ", which have no blocks that all numbers of ranks have; reduce over the objects that have the rows");
  }
  std::vector<Field> stale;
  for (const Field& field : step.gathered) {
    if (!is_fresh(field)) stale.push_back(field);
  }
  if (!stale.empty()) exchange(stale);
  on_ghosts_ = !owned_only && step.reaches_on_ghosts &&
               std::ranges::all_of(step.own, [&](const Field& f) { return is_fresh(f); });
  if (!over.local) return {0, size, nullptr};  // entries, of which there are no ghosts
  const LocalSet& objects = *over.local;
  if (over.kind == DistributedSet::Kind::replicated) return {0, size, nullptr};
  if (on_ghosts_) return {objects.first(), objects.last(), &objects};
  return {objects.begin(), objects.end(), &objects};
}

void HaloSteps::end() {
  const Step* const step = std::exchange(current_, nullptr);
  if (step == nullptr || step->set < 0) return;
  if (arrays_.sets()[static_cast<std::size_t>(step->set)].kind != DistributedSet::Kind::owned) return;
  for (const Field& field : step->written) {
    arrays_.arrays()[static_cast<std::size_t>(field.array)].is_fresh[static_cast<std::size_t>(field.field)] =
        on_ghosts_ ? 1 : 0;
    if (!on_ghosts_ && poisons_) poison(field);
  }
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

void HaloSteps::exchange(const std::vector<Field>& fields) {
  const auto ranks = static_cast<std::size_t>(arrays_.ranks().count());
  std::vector<std::vector<std::byte>> sent(ranks), received(ranks);
  std::vector<std::size_t> to_come(ranks, 0);
  // All fields of a step go in one message to each rank: field by field, object by object, element by element.
  const auto each_element = [](const UntypedArray& memory, const FieldInfo& info, index_t object, const auto& use) {
    const int size = element_bytes(info.type);
    for (int k = 0; k < info.count && size > 0; ++k) {
      use(memory.address(object, info.offset + k * size, size), static_cast<std::size_t>(size));
    }
  };
  for (const Field& field : fields) {
    const UntypedArray& memory = arrays_.arrays()[static_cast<std::size_t>(field.array)].memory;
    const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
    for (const HaloPlan::Peer& peer : set_of_array(field.array).plan.peers) {
      const auto r = static_cast<std::size_t>(peer.rank);
      for (const index_t object : peer.sent) {
        each_element(memory, info, object,
                     [&](const std::byte* at, std::size_t size) { sent[r].insert(sent[r].end(), at, at + size); });
      }
      to_come[r] += static_cast<std::size_t>((peer.last - peer.first) * info.count * element_bytes(info.type));
    }
  }
  std::vector<Message> messages;
  for (std::size_t r = 0; r < ranks; ++r) {
    received[r].resize(to_come[r]);
    if (!sent[r].empty() || to_come[r] > 0) messages.push_back({static_cast<int>(r), sent[r], received[r]});
  }
  arrays_.transport().begin(messages);
  arrays_.transport().end();
  std::vector<std::size_t> taken(ranks, 0);
  for (const Field& field : fields) {
    DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
    const UntypedArray& memory = array.memory;
    const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
    for (const HaloPlan::Peer& peer : set_of_array(field.array).plan.peers) {
      const auto r = static_cast<std::size_t>(peer.rank);
      for (index_t object = peer.first; object < peer.last; ++object) {
        each_element(memory, info, object, [&](std::byte* at, std::size_t size) {
          std::memcpy(at, received[r].data() + taken[r], size);
          taken[r] += size;
        });
      }
    }
    array.is_fresh[static_cast<std::size_t>(field.field)] = 1;
  }
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
