// The arrays of a program on several ranks: its sets, what names what, and the part of them that this rank has.
//
//   DistributedArrays body(ranks, relax_halos);
//   body.add_set("node", mesh.nodes);
//   body.add_set("edge", mesh.edges);
//   body.follow("edge", "node");  // an edge is computed wherever a node of it is owned
//   body.add("body.positions", "node", positions);  // an array without objects, which cut() gives it
//   body.add("body.edges", "edge", edges);
//   body.connect(edges, "nodes", "node", [&](index_t e) { return mesh.edge(e); });  // by global numbers
//   body.cut();
//   body.fill(positions, [&](index_t node) { return mesh.position(node); });
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/detail/array_sets.h>
#include <physgen/detail/host_loop.h>
#include <physgen/detail/scan.h>
#include <physgen/distributed/on_host.h>
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace physgen {

class DistributedArrays : public Partition {
 public:
  using Partition::Partition;

  // ---- Before cut(). Every rank calls these with the same arguments. ----

  /// @param name as in the scene, "body.positions"
  /// @param array outlives this, and is resized by cut() alone
  /// @throw Error when the name or the array is taken, or there is no such set
  template <class Array>
  void add(const std::string& name, std::string_view set, Array& array) {
    add_window(name, set, array, 0);
  }
  /// An array of a window of the set: objects that steps leave for the next, a window at a time, and which never cross.
  /// A rank goes through all that it has, ghosts among them, and all ranks have as many windows: empty ones first.
  /// @param most objects that the window has at once, for reductions a multiple of 2048; 0: all
  template <class Array>
  void add_window(const std::string& name, std::string_view set, Array& array, index_t most) {
    add_array(
        {.name = name,
         .set = number_of(set),
         .array = &array,
         .untyped = [&array] { return array.untyped(); },
         .resize = [&array, this](index_t size) { array = detail::make_array<Array>(size, ranks(), transport()); },
         .window = most});
  }
  /// A field of indices names objects of a set.
  /// @param named named(object) gives a range of as many numbers as the field has elements; -1 names none. It is called
  /// for objects of all ranks that are `known`, by several threads at once, and more than once
  /// @param known which objects this rank can tell of: each object is known to one rank at least, and a rank knows
  /// those that it has, and that name objects of its own; cut() throws where it does not
  /// @throw Error when the array, the field or the set is not known
  template <class Array, class Named>
  void connect(const Array& array, const std::string& field, std::string_view target, const Named& named,
               const KnownObjects& known = {}) {
    const auto visit = [named](const auto& use) {
      use([&](index_t object, const auto& act) {
        for (const auto number : named(object)) act(static_cast<index_t>(number));
      });
    };
    connect_field(&array, field, target, {name_of_field(&array, field), known, visit});
  }
  /// Rows (rows.h) of the objects of the set of `ranges`, whose entries name objects of another set, or of the same.
  /// `entries` is added by this.
  /// @param name of the array of entries, "body.ends"
  /// @param row row(object) gives a range of Entries::Value, with global numbers in the field; called as named() is
  /// @param shift the number is field >> shift, and what is below stays as it is
  template <class Ranges, class Entries, class Row>
  void connect_rows(const Ranges& ranges, const std::string& name, Entries& entries, const std::string& field,
                    std::string_view target, const Row& row, int shift = 0, const KnownObjects& known = {}) {
    connect_rows(ranges, name, entries, field, {target}, row, shift, [](const auto& /*entry*/) { return 0; }, known);
  }
  /// The same where entries name objects of several sets.
  /// @param which which(entry) is the number of its set among `targets`
  template <class Ranges, class Entries, class Row, class Which>
  void connect_rows(const Ranges& ranges, const std::string& name, Entries& entries, const std::string& field,
                    std::initializer_list<std::string_view> targets, const Row& row, int shift, const Which& which,
                    const KnownObjects& known = {});

  // ---- After it. An array is told by its memory, so that programs may move and swap arrays. ----

  /// Which objects of an array this rank has, and their local numbers.
  template <class Array>
  [[nodiscard]] const LocalSet& objects_of(const Array& array) const {
    return set_of(number_of_this(array));
  }
  /// The global numbers of an array's objects, by local ones; null where all ranks have all objects.
  /// @throw Error when they are entries of rows, which have none
  template <class Array>
  [[nodiscard]] const index_t* global_numbers(const Array& array) {
    return Partition::global_numbers(number_of_this(array));
  }
  /// Every object of an array, owned or a ghost: value(global number) gives the array's Value. Connected fields stay as
  /// they are.
  template <class Array, class Value>
    requires std::invocable<const Value&, index_t>
  void fill(Array& array, const Value& value) {
    const LocalSet& objects = objects_of(array);
    fill_on_host(array, [&](auto& here) {
      const auto view = here.view();
      for (index_t i = objects.first(); i < objects.last(); ++i) view.put(i, value(objects.global(i)));
    });
  }
  /// The same from an array of all objects, in any layout, precision and formats.
  /// @throw Error when it has another number of objects
  template <class Array, class Whole>
    requires detail::SameObject<Array, Whole>
  void fill(Array& array, const Whole& whole);
  /// The caller has written objects of an array that this rank owns, outside of the program's steps. All ranks call it.
  /// @throw Error when it has entries of rows
  template <class Array>
  void owned_changed(const Array& array) {
    set_fresh(number_of_this(array), false);
  }
  /// Calls body(first, view) on rank 0, with the objects first .. first + view.size() - 1 of all ranks, in ascending
  /// order; on other ranks, which call this too, it is not called. Connected fields have global numbers.
  /// @param most bytes that rank 0 holds at once, or one block
  /// @throw Error when a connected field has none, as those of rows
  template <class Array, class Body>
  void each_block(const Array& array, const Body& body, index_t most = index_t{64} << 20);
  /// On rank 0 an array of all objects, on other ranks, which call this too, one of none; in the host's memory.
  /// As each_block() gives it.
  template <class Array>
  [[nodiscard]] detail::OnHost<Array> whole(const Array& array) {
    detail::OnHost<Array> all(ranks().is_first() ? objects_of(array).runs().size() : 0);
    each_block(array,
               [&](index_t first, const auto& view) { detail::pick(all.untyped(), first, view.untyped(), nullptr); });
    return all;
  }

 private:
  template <class Array>
  [[nodiscard]] int number_of_this(const Array& array) const {
    return number_by_memory(&array, array.untyped().base);
  }
  template <class Array, class Edit>
  void fill_on_host(Array& array, const Edit& edit) {
    const int number = number_of_this(array);
    detail::edit_on_host(array, [&](auto& here) {
      const std::vector<std::int32_t> kept = index_numbers(number, here.untyped());
      edit(here);
      put_index_numbers(number, here.untyped(), kept);
    });
    set_fresh(number, true);
  }
  [[nodiscard]] std::vector<index_t> local_numbers(const LocalSet& set, index_t begin, index_t end) const {
    std::vector<index_t> numbers(static_cast<std::size_t>(end - begin));
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = set.local(begin + static_cast<index_t>(k));
    return numbers;
  }
};

template <class Array, class Whole>
  requires detail::SameObject<Array, Whole>
void DistributedArrays::fill(Array& array, const Whole& whole) {
  const LocalSet& objects = objects_of(array);
  if (whole.size() != objects.runs().size()) {
    throw Error(std::string(Array::Object::name) + ": an array of " + std::to_string(whole.size()) +
                " objects is given for a set of " + std::to_string(objects.runs().size()) + "; give all objects");
  }
  std::vector<index_t> numbers;
  for (index_t i = objects.first(); i < objects.last(); ++i) numbers.push_back(objects.global(i));
  const auto& same = detail::in_form_of<detail::OnHost<Array>>(whole);
  const detail::Numbers order(numbers, {});
  fill_on_host(array, [&](auto& here) { detail::pick(here.untyped(), objects.first(), same.untyped(), &order); });
}

template <class Ranges, class Entries, class Row, class Which>
void DistributedArrays::connect_rows(const Ranges& ranges, const std::string& name, Entries& entries,
                                     const std::string& field, std::initializer_list<std::string_view> targets,
                                     const Row& row, int shift, const Which& which, const KnownObjects& known) {
  using One = Array<typename Entries::Object, typename Entries::Precision, Host, Aos, typename Entries::Formats>;
  const int rows = number_of_array(&ranges);
  std::vector<int> named_sets;
  for (const std::string_view target : targets) named_sets.push_back(number_of(target));
  add_set(name, 0, DistributedSet::Kind::entries);
  add(name, name, entries);
  using One = Array<typename Entries::Object, typename Entries::Precision, Host, Aos, typename Entries::Formats>;
  std::vector<std::pair<int, detail::NamedObjects>> named;
  for (std::size_t k = 0; k < named_sets.size(); ++k) {
    const auto visit = [=](const auto& use) {
      One one(1);  // in which the field is found by its name
      const std::int32_t* const number = first_index(one.untyped(), field);
      const auto view = one.view();
      use([&](index_t object, const auto& act) {
        for (const auto& entry : row(object)) {
          if (which(entry) != static_cast<int>(k)) continue;
          view.put(index_t{0}, entry);
          act(index_t{*number >> shift});
        }
      });
    };
    named.emplace_back(named_sets[k], detail::NamedObjects(name, known, visit));
  }
  const auto store = [=, this, &entries, of = name + "." + field](std::size_t connection) {
    const int set = arrays()[static_cast<std::size_t>(rows)].set;
    const LocalSet& objects = *sets()[static_cast<std::size_t>(set)].local;
    index_t first = 0, last = objects.size();
    for (const int target : named_sets) {
      const auto [from, to] = complete(set, target);
      first = std::max(first, from), last = std::min(last, to);
    }
    const index_t count = std::max(last - first, index_t{0});
    const std::vector<detail::ObjectPiece> all_rows = pieces(set, first, first + count);
    std::vector<index_t> below(named_sets.size());  // of each set, what numbers of owned objects have more
    for (std::size_t k = 0; k < below.size(); ++k) below[k] = below_local(connection + k);
    std::vector<char> is_owned(all_rows.size(), 1);  // all that is named
    std::vector<std::int32_t> begins(static_cast<std::size_t>(count) + 1, 0);
    detail::host_loop(static_cast<index_t>(all_rows.size()), [&](index_t p) {
      const detail::ObjectPiece& piece = all_rows[static_cast<std::size_t>(p)];
      for (std::size_t k = 0; k < named_sets.size(); ++k) {
        if (!owns_named(connection + k, piece)) is_owned[static_cast<std::size_t>(p)] = 0;
      }
      for (index_t k = 0; k < piece.size(); ++k) {
        const auto& entries_of_row = row(piece.first + k);
        begins[static_cast<std::size_t>(piece.place + k)] =
            static_cast<std::int32_t>(std::ranges::distance(entries_of_row));
      }
    });
    const index_t all = detail::scan<false>(std::span(begins));
    store_rows(rows, first, begins);
    // One at least, as in a set.
    entries = detail::make_array<Entries>(std::max(all, index_t{ranks().count() > 1 ? 1 : 0}), ranks(), transport());
    detail::edit_on_host(entries, [&](auto& here) {
      detail::host_loop(static_cast<index_t>(all_rows.size()), [&](index_t p) {
        const detail::ObjectPiece& piece = all_rows[static_cast<std::size_t>(p)];
        One one(1);
        std::int32_t* const number = first_index(one.untyped(), field);
        const auto view = here.view();
        index_t place = begins[static_cast<std::size_t>(piece.place)];
        for (index_t r = piece.first; r < piece.last; ++r) {
          for (const auto& entry : row(r)) {
            one.view().put(index_t{0}, entry);
            const auto target = static_cast<std::size_t>(which(entry));
            if (is_owned[static_cast<std::size_t>(p)] != 0) {
              *number -= static_cast<std::int32_t>(below[target]) << shift;
            } else {
              const std::int32_t rest = *number & ((std::int32_t{1} << shift) - 1);
              *number = (local_number(named_sets[target], *number >> shift, of) << shift) | rest;
            }
            view.put(place++, one.view().get(index_t{0}));
          }
        }
      });
    });
  };
  connect_entries(&ranges, name, field, std::move(named), store);
}

template <class Array, class Body>
void DistributedArrays::each_block(const Array& array, const Body& body, index_t most) {
  const int number = number_of_this(array);
  require_global_numbers(number);
  const LocalSet& objects = objects_of(array);
  const index_t all = objects.runs().size();
  detail::wait_for_device(Array::Space::kind);
  using There = detail::OnHost<Array>;
  const There& here = detail::in_form_of<There>(array);
  const index_t step = std::max(most / std::max(Array::record_bytes, 1) / Runs::block, index_t{1}) * Runs::block;
  for (index_t first = 0; first < all; first += step) {
    const index_t last = std::min(first + step, all);
    There window(ranks().is_first() ? last - first : 0);
    for (int owner = 0; owner < objects.runs().ranks(); ++owner) {  // one of what all ranks have
      const index_t begin = std::max(first, objects.runs().begin(owner)),
                    end = std::min(last, objects.runs().end(owner));
      if (begin >= end || (owner != ranks().rank() && !ranks().is_first())) continue;
      There piece(end - begin);
      if (owner == ranks().rank()) {
        const std::vector<index_t> numbers = local_numbers(objects, begin, end);
        const detail::Numbers order(numbers, {});
        detail::pick(piece.untyped(), 0, here.untyped(), &order);
        to_global_numbers(number, piece.untyped());
      }
      const UntypedArray memory = piece.untyped();
      to_first(owner, {memory.base, static_cast<std::size_t>(memory.bytes())});
      if (ranks().is_first()) detail::pick(window.untyped(), begin - first, memory, nullptr);
    }
    if (ranks().is_first()) ranks().guard([&] { body(first, window.const_view()); });
  }
}

}  // namespace physgen
