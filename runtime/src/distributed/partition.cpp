// What arrays of several ranks are made of; cut.cpp decides what each rank has.
#include <physgen/distributed/host_image.h>
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <utility>

#include "../addressing.h"
#include "../index_field.h"
#include "named_batches.h"

namespace physgen {

Partition::Partition(const Ranks& ranks, HaloUses uses)
    : ranks_(ranks), uses_(uses), transport_(make_transport(ranks)) {}

void Partition::add_set(const std::string& name, index_t size, DistributedSet::Kind kind) {
  if (is_cut_) throw Error("set " + name + " is added behind cut(); add all sets before it");
  if (size < 0) {
    throw Error("set " + name + " has " + std::to_string(size) + " objects; give a number that is not negative");
  }
  for (const DistributedSet& other : sets_) {
    if (other.name == name) throw Error("there are two sets " + name + "; give each a name of its own");
  }
  DistributedSet& added = sets_.emplace_back();
  added.name = name;
  added.size = size;
  added.kind = kind;
}

void Partition::follow(std::string_view set, std::string_view target) {
  DistributedSet& one = sets_[static_cast<std::size_t>(number_of(set))];
  const DistributedSet& other = sets_[static_cast<std::size_t>(number_of(target))];
  const auto is_owned = [](const DistributedSet& of) { return of.kind == DistributedSet::Kind::owned; };
  if (!is_owned(one) || !is_owned(other)) {
    throw Error("set " + one.name + " cannot follow " + other.name +
                ", since all ranks have all objects of one of them; remove follow()");
  }
  const int number = number_of(target);
  if (&one == &other || other.follows >= 0 || is_followed(number_of(set))) {
    throw Error("set " + one.name + " follows " + other.name +
                ", and one of them follows another set or is followed; let a set follow one that follows none");
  }
  one.follows = number;
}

bool Partition::is_followed(int set) const {
  return std::ranges::any_of(sets_, [&](const DistributedSet& of) { return of.follows == set; });
}

void Partition::same_set(std::string_view set, std::string_view other) {
  const int from = number_of(set), to = number_of(other);
  DistributedSet& one = sets_[static_cast<std::size_t>(from)];
  DistributedSet& kept = sets_[static_cast<std::size_t>(to)];
  const std::string what = "set " + std::string(set) + " cannot be the same as " + std::string(other) + ", since ";
  if (is_cut_) throw Error(what + "cut() was called; say so before it");
  if (from == to) return;
  const auto is_owned = [](const DistributedSet& of) { return of.kind == DistributedSet::Kind::owned; };
  if (!is_owned(one) || !is_owned(kept)) throw Error(what + "ranks own parts of only one of them; remove same_set()");
  if (one.size != kept.size) {
    throw Error(what + "they have " + std::to_string(one.size) + " and " + std::to_string(kept.size) +
                " objects; give both the same number, or remove same_set()");
  }
  const int follows = kept.follows >= 0 ? kept.follows : one.follows;
  const bool follow_two = one.follows >= 0 && one.follows != follows;
  if (follow_two || (follows >= 0 && (follows == from || follows == to || is_followed(from) || is_followed(to)))) {
    throw Error(what + "together they would follow two sets, or follow one and be followed; correct follow()");
  }
  kept.follows = follows;
  one.follows = -1;
  one.kind = DistributedSet::Kind::same;
  one.same_as = to;
  const auto rename = [&](int& number) { number = number == from ? to : number; };
  for (DistributedSet& each : sets_) rename(each.follows);
  for (DistributedArray& array : arrays_) rename(array.set), rename(array.uniform_of);
  for (Naming& naming : namings_) rename(naming.source), rename(naming.target);
  for (Connection& connection : connections_) rename(connection.source), rename(connection.target);
}

void Partition::add_array(DistributedArray array) {
  if (is_cut_) throw Error("array " + array.name + " is added behind cut(); add all arrays before it");
  for (const DistributedArray& other : arrays_) {
    if (other.name == array.name || other.array == array.array) {
      throw Error("array " + array.name + " is added a second time, before as " + other.name + "; add each array once");
    }
  }
  const std::size_t fields = array.untyped().fields.size();
  array.fresh.assign(fields, all_ghosts);
  array.also.assign(fields, 0);
  array.is_gathered.assign(fields, 0);
  array.is_index.assign(fields, 0);
  arrays_.push_back(std::move(array));
}

int Partition::number_of(std::string_view set) const {
  std::string all;
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    if (sets_[s].name == set) {
      auto found = static_cast<int>(s);
      while (sets_[static_cast<std::size_t>(found)].same_as >= 0) {
        found = sets_[static_cast<std::size_t>(found)].same_as;
      }
      return found;
    }
    all += " " + sets_[s].name;
  }
  throw Error("there is no set " + std::string(set) + "; there are:" + all);
}

int Partition::number_of_array(const void* array) const {
  for (std::size_t a = 0; a < arrays_.size(); ++a) {
    if (arrays_[a].array == array) return static_cast<int>(a);
  }
  throw Error("an array is not one of the distributed arrays; add() it before cut()");
}

int Partition::find(const std::byte* base) const {
  for (std::size_t a = 0; a < arrays_.size(); ++a) {
    if (arrays_[a].memory.base == base) return static_cast<int>(a);
  }
  return -1;
}

const LocalSet& Partition::set(std::string_view name) const {
  const DistributedSet& found = sets_[static_cast<std::size_t>(number_of(name))];
  if (!found.local)
    throw Error("set " + found.name + " has no local numbers; call cut() first, and ask for sets of objects");
  return *found.local;
}

const LocalSet& Partition::set_of(int array) const {
  const DistributedArray& found = arrays_[static_cast<std::size_t>(array)];
  const std::string& of = sets_[static_cast<std::size_t>(found.set)].name;
  if (found.window > 0) {
    throw Error(found.name + " has a window of set " + of +
                ", with other objects from step to step; take an array of all, or fill the window by a kernel");
  }
  return set(of);
}

int Partition::number_by_memory(const void* array, const std::byte* base) const {
  if (!is_cut_ || base == nullptr) return number_of_array(array);
  if (const int found = find(base); found >= 0) return found;
  throw Error(
      "an array has other memory than cut() gave the distributed arrays; fill the array that has this memory, "
      "and resize or assign none behind cut()");
}

const index_t* Partition::global_numbers(int array) {
  DistributedSet& set = sets_[static_cast<std::size_t>(arrays_[static_cast<std::size_t>(array)].set)];
  const LocalSet& objects = set_of(array);
  if (set.kind == DistributedSet::Kind::replicated) return nullptr;
  for (auto i = static_cast<index_t>(set.numbers.size()); i < objects.size(); ++i) {
    set.numbers.push_back(objects.global(i));
  }
  return set.numbers.data();
}

void Partition::set_fresh(int array, bool is_fresh) {
  DistributedArray& found = arrays_[static_cast<std::size_t>(array)];
  if (found.window > 0) (void)set_of(array);  // which says that it has a window
  if (sets_[static_cast<std::size_t>(found.set)].kind == DistributedSet::Kind::entries) {
    throw Error(found.name +
                " has entries of rows, which a rank has of ghosts, too, and which never cross; write them by a kernel "
                "that is run over them, or write an array of objects");
  }
  for (std::size_t f = 0; f < found.fresh.size(); ++f) {
    found.fresh[f] = is_fresh || found.is_index[f] ? all_ghosts : 0;
  }
}

std::int32_t* Partition::first_index(const UntypedArray& array, std::string_view field) {
  return reinterpret_cast<std::int32_t*>(array.address(0, detail::find_index_field(array, field).offset, 4));
}

std::string Partition::name_of_field(const void* array, const std::string& field) const {
  return arrays_[static_cast<std::size_t>(number_of_array(array))].name + "." + field;
}

void Partition::connect_field(const void* array, const std::string& field, std::string_view target,
                              detail::NamedObjects named) {
  const int number = number_of_array(array), to = number_of(target);
  DistributedArray& source = arrays_[static_cast<std::size_t>(number)];
  const UntypedArray untyped = source.untyped();
  source.is_index[static_cast<std::size_t>(&detail::find_index_field(untyped, field) - untyped.fields.data())] = 1;
  namings_.push_back({named.field(), source.set, to, number, static_cast<int>(connections_.size())});
  const auto store = [this, number, to, field](std::size_t connection) {
    store_numbers(number, to, field, connection);
  };
  connections_.push_back({source.set, to, std::move(named), store});
}

void Partition::store_numbers(int array, int target, const std::string& field, std::size_t connection) const {
  const DistributedArray& connected = arrays_[static_cast<std::size_t>(array)];
  const detail::NamedObjects& named = connections_[connection].named;
  const LocalSet& objects = *sets_[static_cast<std::size_t>(connected.set)].local;
  const detail::HostImage image(connected.untyped());
  const FieldInfo& info = detail::find_index_field(image.array(), field);
  const detail::Addressing places(image.array());
  const auto elements = static_cast<std::size_t>(info.count);
  const index_t below = below_local(connection);
  detail::each_named(
      {&named}, pieces(connected.set, objects.first(), objects.last()), [](std::size_t) { return false; },
      [&](const detail::NamedBatch& batch) {
        const bool is_owned = owns_named(connection, batch.piece);
        for (std::size_t k = 0; k < batch.size(); ++k) {
          const std::span<const index_t> numbers = batch.numbers.front().of(k);
          if (numbers.size() != elements) {
            throw Error(named.field() + " of object " + std::to_string(batch.object(k)) + " has " +
                        std::to_string(elements) + " elements, and " + std::to_string(numbers.size()) +
                        " numbers were given; give one for each");
          }
          const index_t i = objects.first() + batch.piece.place + static_cast<index_t>(k);
          for (std::size_t e = 0; e < elements; ++e) {
            *reinterpret_cast<std::int32_t*>(places.address(i, info.offset + static_cast<int>(e) * 4, 4)) =
                is_owned ? static_cast<std::int32_t>(numbers[e] - below)
                         : local_number(target, numbers[e], named.field());
          }
        }
      });
  image.store();
}

void Partition::connect_entries(const void* ranges, const std::string& name, const std::string& field,
                                std::vector<std::pair<int, detail::NamedObjects>> targets, Store store) {
  const int rows = number_of_array(ranges), last = static_cast<int>(arrays_.size()) - 1;
  DistributedArray& of_ranges = arrays_[static_cast<std::size_t>(rows)];
  DistributedArray& entries = arrays_.back();
  for (auto& [array, fields] : {std::pair{&of_ranges, std::vector<std::string>{"begin", "end"}}, {&entries, {field}}}) {
    const UntypedArray untyped = array->untyped();
    for (const std::string& one : fields) {
      array->is_index[static_cast<std::size_t>(&detail::find_index_field(untyped, one) - untyped.fields.data())] = 1;
    }
  }
  for (const char* one : {".begin", ".end"}) {
    namings_.push_back({of_ranges.name + one, of_ranges.set, entries.set, rows});
  }
  for (std::size_t t = 0; t < targets.size(); ++t) {
    auto& [target, named] = targets[t];
    namings_.push_back({name + "." + field, entries.set, target, last, static_cast<int>(connections_.size())});
    Connection& added = connections_.emplace_back();
    added.source = of_ranges.set;
    added.target = target;
    added.named = std::move(named);
    if (t == 0) added.store = std::move(store);
  }
}

void Partition::store_rows(int ranges, index_t first, std::span<const std::int32_t> begins) const {
  const detail::HostImage image(arrays_[static_cast<std::size_t>(ranges)].untyped());
  const UntypedArray& memory = image.array();
  const detail::Addressing places(memory);
  const int begin = detail::find_index_field(memory, "begin").offset,
            end = detail::find_index_field(memory, "end").offset;
  const auto rows = static_cast<index_t>(begins.size()) - 1;
  const auto begin_of = [&](index_t row) {
    return begins[static_cast<std::size_t>(std::clamp(row, index_t{0}, rows))];
  };
  for (index_t i = 0; i < memory.size; ++i) {
    *reinterpret_cast<std::int32_t*>(places.address(i, begin, 4)) = begin_of(i - first);
    *reinterpret_cast<std::int32_t*>(places.address(i, end, 4)) = begin_of(i - first + 1);
  }
  image.store();
}

index_t Partition::entries_of_owned(int ranges) const {
  const DistributedArray& array = arrays_[static_cast<std::size_t>(ranges)];
  const LocalSet& objects = *sets_[static_cast<std::size_t>(array.set)].local;
  const detail::HostImage image(array.memory);
  const detail::Addressing places(image.array());
  const int begin = detail::find_index_field(image.array(), "begin").offset,
            end = detail::find_index_field(image.array(), "end").offset;
  const auto number = [&](index_t i, int offset) {
    return *reinterpret_cast<const std::int32_t*>(places.address(i, offset, 4));
  };
  index_t sum = 0;
  for (index_t i = objects.begin(); i < objects.end(); ++i) sum += number(i, end) - number(i, begin);
  return sum;
}

void Partition::to_first(int owner, std::span<std::byte> bytes) const {
  if (owner == 0) return;
  std::vector<Message> messages;
  if (ranks_.is_first()) messages.push_back({owner, {}, bytes});
  if (ranks_.rank() == owner) messages.push_back({0, bytes, {}});
  transport_->begin(messages);
  transport_->end();
}

}  // namespace physgen
