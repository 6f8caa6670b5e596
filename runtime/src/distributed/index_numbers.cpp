// Index fields of arrays that a program fills and takes: a rank has them by its own numbers.
#include <physgen/distributed/partition.h>

#include "../index_field.h"

namespace physgen {

namespace {

/// Calls use(number) for each element of an index field.
template <class Use>
void each_number(const UntypedArray& memory, const FieldInfo& info, const Use& use) {
  constexpr int size = sizeof(std::int32_t);
  for (index_t i = 0; i < memory.size; ++i) {
    for (int k = 0; k < info.count; ++k) {
      use(*reinterpret_cast<std::int32_t*>(memory.address(i, info.offset + k * size, size)));
    }
  }
}

}  // namespace

std::vector<std::int32_t> Partition::index_numbers(int array, const UntypedArray& memory) const {
  const DistributedArray& of = arrays_[static_cast<std::size_t>(array)];
  std::vector<std::int32_t> numbers;
  for (std::size_t f = 0; f < memory.fields.size(); ++f) {
    if (of.is_index[f] == 0) continue;
    each_number(memory, memory.fields[f], [&](std::int32_t number) { numbers.push_back(number); });
  }
  return numbers;
}

void Partition::put_index_numbers(int array, const UntypedArray& memory,
                                  const std::vector<std::int32_t>& numbers) const {
  const DistributedArray& of = arrays_[static_cast<std::size_t>(array)];
  auto next = numbers.begin();
  for (std::size_t f = 0; f < memory.fields.size(); ++f) {
    if (of.is_index[f] == 0) continue;
    each_number(memory, memory.fields[f], [&](std::int32_t& number) { number = *next++; });
  }
}

void Partition::require_global_numbers(int array) const {
  for (const Naming& naming : namings_) {
    if (naming.array != array) continue;
    const DistributedSet& source = sets_[static_cast<std::size_t>(naming.source)];
    const DistributedSet& target = sets_[static_cast<std::size_t>(naming.target)];
    const bool is_of_rows = target.kind == DistributedSet::Kind::entries;
    const bool is_of_parts =
        source.kind == DistributedSet::Kind::replicated && target.kind == DistributedSet::Kind::owned;
    if (!is_of_rows && !is_of_parts) continue;
    throw Error(naming.field +
                (is_of_rows ? " is a place among the entries of this rank"
                            : " is known of those objects alone that this rank computes") +
                ", so that no array of all objects can have it; take another array, and these from what they were "
                "connected with");
  }
}

void Partition::to_global_numbers(int array, const UntypedArray& memory) const {
  const std::size_t name = arrays_[static_cast<std::size_t>(array)].name.size() + 1;
  for (const Naming& naming : namings_) {
    if (naming.array != array) continue;
    const LocalSet& target = *sets_[static_cast<std::size_t>(naming.target)].local;
    each_number(memory, detail::find_index_field(memory, naming.field.substr(name)), [&](std::int32_t& number) {
      if (number >= 0) number = static_cast<std::int32_t>(target.global(number));
    });
  }
}

}  // namespace physgen
