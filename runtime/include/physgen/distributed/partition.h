// The sets of a program, what names what, and the part that this rank has of them; without the types of its arrays,
// which distributed/arrays.h knows.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/distributed/halo_needs.h>
#include <physgen/distributed/halo_uses.h>
#include <physgen/distributed/local_set.h>
#include <physgen/distributed/named_objects.h>
#include <physgen/distributed/ranks.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace physgen {

/// A set, as all ranks know it.
struct DistributedSet {
  enum class Kind {
    owned,       ///< each object is owned by one rank
    replicated,  ///< all ranks have all objects
    entries,     ///< the entries of rows: those of the rows that a rank has
    same         ///< another name of a set, same_as
  };
  std::string name;
  index_t size;  ///< of all ranks; of entries 0
  Kind kind = Kind::owned;
  int follows = -1;  ///< the set of which an owned object makes objects of this one present
  int same_as = -1;
  /// Behind cut(): whether ranks have parts of it. Entries are such where a rank has some of their rows alone.
  bool has_parts = false;
  std::optional<LocalSet> local;
  /// Of a replicated set whose objects name some of which ranks have parts: those that a rank computes for all, in
  /// steps that read what they name. Steps that read nothing of that compute all objects, on all ranks.
  std::optional<Runs> computed;
  std::vector<HaloNeed> needs = {};   ///< behind cut() that of all ghosts, and as steps ask for them others
  std::vector<index_t> numbers = {};  ///< global ones, by local ones; none before they are asked for
  /// Of each group of local objects: bit s % 64 where one of them names a ghost of set s, by itself or through objects
  /// of sets that follow.
  std::vector<std::uint64_t> reached;
  static constexpr index_t group = detail::ObjectPiece::group;
};

/// An array that has the objects of a set that are here.
struct DistributedArray {
  std::string name;
  int set;
  const void* array;  ///< the caller's
  std::function<UntypedArray()> untyped;
  std::function<void(index_t)> resize;
  int uniform_of = -1;       ///< the set that has this one record for all of its objects
  index_t window = 0;        ///< it has a window of the set, of so many objects at most; 0: all that are here
  UntypedArray memory = {};  ///< behind cut(), wherever a program moves or swaps its arrays to
  /// Of each field: the needs of which all ghosts have their owners' values.
  std::vector<HaloNeedBits> fresh = {};
  /// Of each field: needs for which it crosses, too, whenever it crosses, so that it does not have to cross once more.
  std::vector<HaloNeedBits> also = {};
  std::vector<char> is_gathered = {};  ///< of each field: whether a step so far has read it of others
  std::vector<char> is_index = {};     ///< of each field: local numbers, which never cross
  /// Of each field of a replicated set: whether it names objects of which ranks have parts, itself or by rows. A rank
  /// has it of those objects alone that it computes.
  std::vector<char> names_parts = {};
};

/// The base of DistributedArrays, which has what users call.
class Partition {
 public:
  /// @param uses what kernels use of others; without rows everything counts as used
  Partition(const Ranks& ranks, HaloUses uses);
  Partition(const Partition&) = delete;
  Partition& operator=(const Partition&) = delete;
  ~Partition() = default;

  // ---- Before cut(). Every rank calls these with the same arguments. ----

  /// @throw Error when the name is taken or the size is negative
  void add_set(const std::string& name, index_t size) { add_set(name, size, DistributedSet::Kind::owned); }
  /// Numbers that a program keeps once, small meshes: all ranks have all.
  void add_replicated_set(const std::string& name, index_t size) {
    add_set(name, size, DistributedSet::Kind::replicated);
  }
  /// Objects of `set` are present and computed wherever one of the objects of `target` that they name is owned.
  /// @throw Error when one of the sets is not known or not owned by objects, or one of them follows or is followed
  void follow(std::string_view set, std::string_view target);
  /// The objects of `set` are those of `other`: they have the same numbers, owners and ghosts, and `set` becomes
  /// another name of it. For programs that count arrays of the same objects apart, since some of them may be left out.
  /// @throw Error when one of the sets is not known or not owned by objects, when their numbers of objects differ, or
  /// when they would follow two sets, or follow and be followed
  void same_set(std::string_view set, std::string_view other);

  /// Decides what each rank owns, makes what it needs of others present, and gives the arrays their objects, with
  /// initial values, and with local numbers in the fields that name others.
  /// @param behind_names called when what objects name is not asked for any more, and before arrays that name none get
  /// their objects: the lists that connect() was given may go
  /// @throw Error when a number names no object
  void cut(const std::function<void()>& behind_names = {});

  // ---- After it. ----

  [[nodiscard]] const LocalSet& set(std::string_view name) const;
  [[nodiscard]] const Ranks& ranks() const { return ranks_; }
  [[nodiscard]] Transport& transport() const { return *transport_; }
  [[nodiscard]] HaloUses uses() const { return uses_; }
  [[nodiscard]] const std::vector<DistributedSet>& sets() const { return sets_; }
  [[nodiscard]] const std::vector<DistributedArray>& arrays() const { return arrays_; }
  [[nodiscard]] std::vector<DistributedArray>& arrays() { return arrays_; }
  /// The array whose memory begins there, or -1.
  [[nodiscard]] int find(const std::byte* base) const;
  /// An index field, "body.edges.nodes": the array that has it, the set of that, the one that it names, and the number
  /// of the connection; none (-1) of the places of rows.
  struct Naming {
    std::string field;
    int source, target, array, connection = -1;
  };
  [[nodiscard]] const std::vector<Naming>& namings() const { return namings_; }
  /// The need of the set that the last connections name. All ranks ask in the same order; they make the plan together
  /// where it is a new one.
  [[nodiscard]] int need_of(const HaloPath& path);
  /// The need that has the ghosts of some needs of a set, likewise. @param needs one at least
  [[nodiscard]] int need_of(int set, HaloNeedBits needs);

 protected:
  /// Stores local numbers of what objects name by a connection, and by those behind it that were added with it.
  using Store = std::function<void(std::size_t connection)>;

  void add_set(const std::string& name, index_t size, DistributedSet::Kind kind);
  void add_array(DistributedArray array);
  void connect_field(const void* array, const std::string& field, std::string_view target, detail::NamedObjects named);
  /// @param targets the sets that entries name, and which numbers of each
  /// @param store makes rows, behind cut()
  void connect_entries(const void* ranges, const std::string& name, const std::string& field,
                       std::vector<std::pair<int, detail::NamedObjects>> targets, Store store);
  [[nodiscard]] int number_of(std::string_view set) const;
  [[nodiscard]] int number_of_array(const void* array) const;
  /// "body.edges.nodes"
  [[nodiscard]] std::string name_of_field(const void* array, const std::string& field) const;
  [[nodiscard]] const LocalSet& set_of(int array) const;
  /// The number of an array by its memory, which it keeps behind cut() wherever a program moves or swaps it to; by its
  /// address before, and where it has no memory.
  /// @throw Error when it has memory of its own
  [[nodiscard]] int number_by_memory(const void* array, const std::byte* base) const;
  void set_fresh(int array, bool is_fresh);
  [[nodiscard]] const index_t* global_numbers(int array);
  /// The local objects, first and behind the last, of which all that they name of another set is here.
  [[nodiscard]] std::pair<index_t, index_t> complete(int set, int target) const;
  /// Local objects of a set; the place of a piece is the first's distance from `first`. @pre objects are there
  [[nodiscard]] std::vector<detail::ObjectPiece> pieces(int set, index_t first, index_t last) const;
  /// Whether this rank owns all that a piece's objects name by a connection: local numbers are global ones less
  /// below_local(). False does not say that they name something of others.
  [[nodiscard]] bool owns_named(std::size_t connection, const detail::ObjectPiece& piece) const;
  [[nodiscard]] index_t below_local(std::size_t connection) const;
  /// Of a global number; -1 where it is not here. @throw Error when the set has no such object
  [[nodiscard]] std::int32_t local_number(int set, index_t number, const std::string& of) const;
  /// The first element of an index field of the first object.
  [[nodiscard]] static std::int32_t* first_index(const UntypedArray& array, std::string_view field);
  /// The places of rows: row k, of local object first + k, begins with entry begins[k]; other objects have none.
  /// @param begins one more than there are rows
  void store_rows(int ranges, index_t first, std::span<const std::int32_t> begins) const;
  /// How many entries the rows of owned objects have.
  [[nodiscard]] index_t entries_of_owned(int ranges) const;
  /// The numbers in the connected fields of an array, which keep them while others are filled.
  /// @param memory of all that is here, where the host reaches it
  [[nodiscard]] std::vector<std::int32_t> index_numbers(int array, const UntypedArray& memory) const;
  void put_index_numbers(int array, const UntypedArray& memory, const std::vector<std::int32_t>& numbers) const;
  /// @throw Error when connected fields of an array have no numbers that all ranks know
  void require_global_numbers(int array) const;
  /// Those in the connected fields of owned objects become global ones. @param memory of a copy of such objects
  void to_global_numbers(int array, const UntypedArray& memory) const;
  /// Takes an owner's bytes to rank 0.
  void to_first(int owner, std::span<std::byte> bytes) const;

 private:
  struct Connection {
    int source, target;
    detail::NamedObjects named;
    Store store;  ///< behind cut(); or none, where another connection does it
    /// Local numbers of an object that is computed here and of one that it names, where that is a ghost or leads to
    /// one.
    std::vector<std::array<std::int32_t, 2>> to_ghosts = {};
  };
  /// @return of each set that follows: the objects that name one that this rank owns
  [[nodiscard]] std::vector<ObjectRuns> decide_runs();
  [[nodiscard]] ObjectRuns decide_runs_of(int following);
  void decide_computed();
  void decide_computed_of(int replicated);
  void store_numbers(int array, int target, const std::string& field, std::size_t connection) const;
  void find_ghosts(const std::vector<ObjectRuns>& touching);
  /// Appends what some objects name that other ranks own.
  void add_named_of_others(std::size_t connection, const ObjectRuns& objects, std::vector<index_t>& others) const;
  void find_fields_that_name_parts();
  /// DistributedSet::reached of each local object of a set, and of each group. Where objects of a set name each other,
  /// a thread reads what another adds.
  struct Reached {
    std::vector<std::uint64_t> objects, groups;

    Reached() = default;
    /// @param first, last objects that are computed here: of others all bits are set
    Reached(index_t size, index_t first, index_t last);
    /// Whether one of the objects first .. last-1 may have a bit.
    [[nodiscard]] bool any(index_t first, index_t last);
    /// @return whether the object had less
    bool add(index_t object, std::uint64_t bits);
    [[nodiscard]] std::uint64_t of(index_t object);
  };
  void find_reached();
  /// What objects reach by a connection. @return whether it is more than before
  [[nodiscard]] bool add_reached(std::size_t connection, std::vector<Reached>& reached) const;
  /// Whether a piece's objects may name ghosts by a connection, or what reaches some.
  [[nodiscard]] bool may_reach(std::size_t connection, const detail::ObjectPiece& piece, Reached& target) const;
  void keep_what_leads_to_ghosts(std::vector<Reached>& reached);
  [[nodiscard]] std::vector<char> ghosts_of(const HaloPath& path) const;
  [[nodiscard]] int add_need(int set, std::vector<char> has);
  [[nodiscard]] bool is_followed(int set) const;

  const Ranks& ranks_;
  HaloUses uses_;
  std::unique_ptr<Transport> transport_;
  std::vector<DistributedSet> sets_;
  std::vector<DistributedArray> arrays_;
  std::vector<Connection> connections_;
  std::vector<Naming> namings_;
  std::map<HaloPath, int> needs_;
  std::map<std::pair<int, HaloNeedBits>, int> joined_;  ///< needs, by set and those that each has
  bool is_cut_ = false;
};

}  // namespace physgen
