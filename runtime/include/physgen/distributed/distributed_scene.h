// The base of the arrays of a scene on several ranks, which physgen writes of a scene that says what its index fields
// name, as NAME.distributed.h:
//
//   scenes::relax_scene::Distributed<> body(ranks, {.node = mesh.nodes, .edge = mesh.edges, .end = 2 * mesh.edges});
//   body.connect(body.edges, [&](index_t edge) { return mesh.edge(edge); });  // what names others, by global numbers
//   body.connect(body.ranges, body.ends, mesh.node_edges);
//   body.cut();
//   body.fill(body.positions, [&](index_t node) { return mesh.position(node); });
//   DistributedExecutor<HostExecutor> on(ranks, body);
//   scenes::relax_scene::program(on, body, 1000);
//   body.each_block(body.positions, [&](index_t first, auto view) { write(first, view); });
#pragma once

#ifdef __CUDACC__
#include <physgen/distributed/cuda/executor.h>
#else
#include <physgen/distributed/executor.h>
#endif
#include <physgen/distributed/scene_sets.h>

#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>

namespace physgen {

/// The memory in which ranks have the arrays of a scene: where an executor of several ranks runs.
template <class Space>
concept SpaceOfRanks = std::is_same_v<Space, Host> || std::is_same_v<Space, Cuda>;

/// Arrays are given as members of the struct that derives from this; by them it knows sets, fields and names.
class DistributedScene {
 public:
  /// In place of a number of objects.
  static constexpr index_t not_given = detail::SceneNames::not_given;

  DistributedScene(const Ranks& ranks, HaloUses uses) : scene_(ranks, uses) {}

  /// For DistributedExecutor, and for what DistributedArrays has beside these. @throw Error before cut()
  operator DistributedArrays&() {
    scene_.scene_names().require_cut();
    return scene_;
  }

  // ---- Before cut(). Every rank calls these with the same arguments, for each array that names others. ----

  /// @param named named(object) gives a range of as many numbers as the field has elements, the global numbers of the
  /// objects that it names; -1 names none. It is called for objects of all ranks, until cut() returns
  /// @throw Error when the scene says of no field of the array what it names, or of several
  template <class Array, class Named>
    requires std::invocable<const Named&, index_t>
  void connect(const Array& array, const Named& named) {
    connect(array, std::string_view(), named);
  }
  /// The same of one of several fields. @throw Error when the scene does not say what it names
  template <class Array, class Named>
    requires std::invocable<const Named&, index_t>
  void connect(const Array& array, std::string_view field, const Named& named) {
    detail::SceneNames::IndexField& of = scene_.scene_names().to_be_connected(&array, field);
    scene_.connect(array, of.field, of.set, named);
    of.is_connected = true;
  }
  /// Rows: ranges, and the entries that name others.
  /// @param rows rows(object) gives a range of Entries::Value, with global numbers; or RowArrays of all objects, in the
  /// host's memory. It is used until cut() returns; a temporary is kept
  /// @throw Error when the scene has no such rows
  template <class Ranges, class Entries, class RowsOfAll>
    requires requires { typename Entries::Object; }
  void connect(const Ranges& ranges, Entries& entries, RowsOfAll&& rows) {
    detail::SceneNames::RowsOfScene& of = scene_.scene_names().to_be_connected(&ranges, &entries);
    const auto connect = [&](const auto& row) {
      scene_.connect_rows(ranges, of.name, detail::contents_of(entries), of.field, of.set, row, of.shift);
    };
    using Given = std::remove_cvref_t<RowsOfAll>;
    if constexpr (std::invocable<const Given&, index_t>) {
      connect(rows);
    } else {
      const DistributedSet& set = scene_.declared_set(&ranges);
      detail::SceneNames::require_rows(of, rows.size(), set.name, set.size);
      // Views are of memory that a temporary would take along.
      std::shared_ptr<const Given> kept;
      if constexpr (!std::is_lvalue_reference_v<RowsOfAll>) kept = std::make_shared<Given>(std::move(rows));
      connect([kept, view = kept ? kept->const_view() : rows.const_view()](index_t object) {
        std::vector<typename Entries::Value> row;
        view.for_each(object, [&](const auto& entry, bool /*active*/) { row.push_back(entry.get()); });
        return row;
      });
    }
    of.is_connected = true;
  }
  /// Decides what each rank owns, makes what it needs of others present, and gives the arrays their objects.
  /// @throw Error when an array that names others is not connected, a number names no object, or rows have more or
  /// fewer entries than were given
  void cut() { scene_.cut(); }

  // ---- After it: see DistributedArrays. ----

  /// Every object of an array, owned or a ghost: value(global number) gives the array's Value; or an array of all
  /// objects, in any layout, precision and formats. Of a uniform() array it is the one record.
  template <class Array, class Values>
    requires requires(Array& of) { detail::contents_of(of).untyped(); }
  void fill(Array& array, const Values& values) {
    scene_.fill(detail::contents_of(array), values);
  }
  /// The caller has written objects of an array that this rank owns, outside of the program's steps. All ranks call it.
  template <class Array>
  void owned_changed(const Array& array) {
    scene_.owned_changed(array);
  }
  /// Calls body(first, view) on rank 0, with the objects first .. first + view.size() - 1 of all ranks, in ascending
  /// order; on other ranks, which call this too, it is not called.
  /// @param most bytes that rank 0 holds at once, or one block
  template <class Array, class Body>
  void each_block(const Array& array, const Body& body, index_t most = index_t{64} << 20) {
    scene_.each_block(array, body, most);
  }
  /// On rank 0 an array of all objects, on other ranks, which call this too, one of none; in the host's memory.
  template <class Array>
  [[nodiscard]] detail::OnHost<Array> whole(const Array& array) {
    return scene_.whole(array);
  }
  /// Which objects of an array this rank has, and their local numbers.
  template <class Array>
  [[nodiscard]] const LocalSet& objects_of(const Array& array) const {
    return scene_.objects_of(array);
  }

 protected:
  detail::SceneSets scene_;
};

}  // namespace physgen
