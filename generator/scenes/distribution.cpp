// See distribution.h. What several ranks cannot do with the arrays of a scene is said in one sentence.
#include "scenes/distribution.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace physgen::scenes {
namespace {

/// Members of physgen::DistributedScene, beside which the arrays of a single group stand, or the groups themselves, and
/// what the generated struct names.
constexpr std::array<std::string_view, 13> members = {
    "Counts", "DistributedScene", "allocate",   "connect",       "cut",    "each_block", "fill",
    "halos",  "not_given",        "objects_of", "owned_changed", "scene_", "whole"};

class DistributionFinder {
 public:
  DistributionFinder(const Scene& scene, const Needs& needs) : scene_(scene), needs_(needs) {
    for (const Group& group : scene.groups)
      for (const Array& array : group.arrays) arrays_.push_back({group.full_name(array), &array});
  }

  Distribution find() && {
    for (const auto& [name, array] : arrays_)
      if (!array->set.empty() && set(array->set) == nullptr) found_.sets.push_back({array->set, "", false});
    for (const auto& [ranges, entries] : needs_.halos.rows)
      if (Distribution::Set* of = set(array(entries).set)) of->has_entries = true;
    check_members();
    for (const auto& [name, array] : arrays_) names(name, *array);
    for (const auto& [name, array] : arrays_) follows(*array);
    for (const Distribution::Set& one : found_.sets) check_followed(one);
    if (const std::string& outside = needs_.halos.outside; !outside.empty())
      refuse("the program itself uses " + outside +
             ", of whose objects ranks have parts under other numbers; let a kernel use it, and reduce what the host "
             "needs of it into an array per(1)");
    return std::move(found_);
  }

 private:
  /// The first reason is told.
  void refuse(const std::string& why) {
    if (found_.refused.empty()) found_.refused = why;
  }
  [[nodiscard]] const Array& array(const std::string& name) const { return *scenes::find(scene_, name); }
  [[nodiscard]] Distribution::Set* set(const std::string& name) {
    const auto one = std::ranges::find(found_.sets, name, &Distribution::Set::name);
    return one == found_.sets.end() ? nullptr : &*one;
  }
  [[nodiscard]] bool has_entries(const std::string& name) {
    const Distribution::Set* const one = set(name);
    return one != nullptr && one->has_entries;
  }
  [[nodiscard]] static bool is_replicated(const Array& array) { return array.set.empty() || array.uniform; }

  void check_members() {
    const auto check = [&](const std::string& what, const std::string& name) {
      if (std::ranges::find(members, name) != members.end())
        refuse(what + " has the name of a member that the arrays of ranks have; give it another name");
    };
    for (const Distribution::Set& one : found_.sets)
      if (one.name == "not_given") check("set " + one.name, one.name);
    for (const Group& group : scene_.groups) {
      if (group.name == "Distributed") refuse("group Distributed has the name of its struct; give it another name");
      check("group " + group.name, group.name);
      if (scene_.groups.size() > 1) check("group " + group.name, group.variable);
      if (scene_.groups.size() > 1) continue;
      for (const Array& one : group.arrays) check("array " + group.full_name(one), one.name);
    }
  }

  /// What the index fields of an array name that the program reads.
  void names(const std::string& name, const Array& of) {
    const ArrayNeed& need = needs_.of(name);
    std::vector<const NamedObjects*> names;
    for (const NamedObjects& one : of.names) {
      const auto field = std::ranges::find_if(need.fields, [&](const auto& f) { return f.field.name == one.field; });
      if (one.set.empty() || field == need.fields.end() || !field->kept) continue;
      names.push_back(&one);
      if (is_replicated(of))
        refuse("field " + one.field + " of " + name + ", of which all ranks have all objects, names objects of " +
               one.set + ", of which they have parts; let an array per(\"...\") of a set name them");
      if (has_entries(one.set))
        refuse("field " + one.field + " of " + name + " names objects of " + one.set +
               ", which are entries of rows and have no numbers that all ranks know; name what the entries name");
    }
    check_one_set(name, names);
    std::vector<std::string> of_ranges;
    for (const auto& [ranges, entries] : needs_.halos.rows)
      if (entries == name) of_ranges.push_back(ranges);
    if (!of_ranges.empty()) return rows(name, of, of_ranges, names);
    for (const auto& [ranges, entries] : needs_.halos.rows)
      if (!of.set.empty() && array(entries).set == of.set)
        refuse(name + " is per " + of.set + ", as the entries " + entries +
               " of rows are, of which a rank has those of its rows alone; give the entries a set of their own");
    for (const NamedObjects* one : names) {
      if (one->shift != 0)
        refuse("field " + one->field + " of " + name + " has the numbers of " + one->set +
               " above other bits, which several ranks know of entries of rows alone; give the numbers a field of "
               "their own");
      found_.names.push_back({name, one->field, one->set});
    }
  }
  void check_one_set(const std::string& name, const std::vector<const NamedObjects*>& names) {
    for (const NamedObjects* one : names) {
      std::vector<std::string> sets;
      for (const NamedObjects* other : names)
        if (other->field == one->field) sets.push_back(other->set);
      if (sets.size() > 1)
        refuse("field " + one->field + " of " + name + " names objects of " + model::joined(sets, " and ") +
               ", and ranks number each set by itself; let it name objects of one set");
    }
  }
  void rows(const std::string& name, const Array& of, const std::vector<std::string>& ranges,
            const std::vector<const NamedObjects*>& names) {
    const auto of_ranges = [&](const auto& row) { return row.first == ranges.front(); };
    if (ranges.size() > 1 || std::ranges::count_if(needs_.halos.rows, of_ranges) > 1)
      refuse("the rows of " + model::joined(ranges, " and ") + " and the entries " + name +
             " are not one to one; give each array of ranges entries of its own");
    if (names.size() != 1)
      refuse("the entries " + name + " name objects by " + (names.empty() ? "no field" : "several fields") +
             " that the program reads, and rows of several ranks have one; write names(...) of one field");
    if (of.set.empty() || is_replicated(array(ranges.front())))
      refuse("the rows of " + ranges.front() + " are the same on all ranks; let it be per(\"...\") of a set, and " +
             name + " of another");
    if (!names.empty())
      found_.rows.push_back({ranges.front(), name, names.front()->field, names.front()->set, names.front()->shift});
  }

  void follows(const Array& of) {
    Distribution::Set* const one = of.follows.empty() ? nullptr : set(of.set);
    if (one == nullptr) return;
    if (!one->follows.empty() && one->follows != of.follows)
      refuse("set " + of.set + " follows " + one->follows + " and " + of.follows + "; let it follow one of them");
    one->follows = of.follows;
  }
  void check_followed(const Distribution::Set& one) {
    if (one.follows.empty()) return;
    const std::string says = "set " + one.name + " follows " + one.follows;
    if (one.has_entries)
      refuse(says + ", and its objects are entries, which are where their rows are; remove follows(...)");
    if (const Distribution::Set* const other = set(one.follows); other != nullptr) {
      if (other->has_entries) refuse(says + ", whose objects are entries of rows; let it follow a set of objects");
      if (!other->follows.empty())
        refuse(says + ", which follows " + other->follows + "; let a set follow one that follows none");
    }
    const auto names_it = [&](const auto& naming, const std::string& of) {
      return array(of).set == one.name && naming.set == one.follows;
    };
    if (std::ranges::none_of(found_.names, [&](const auto& naming) { return names_it(naming, naming.array); }) &&
        std::ranges::none_of(found_.rows, [&](const auto& rows) { return names_it(rows, rows.ranges); }))
      refuse(says + ", and no index field that the program reads names objects of " + one.follows + " for each " +
             one.name + "; let one name them, names(\"...\", \"" + one.follows + "\")");
  }

  const Scene& scene_;
  const Needs& needs_;
  std::vector<std::pair<std::string, const Array*>> arrays_;  // by full names
  Distribution found_;
};

}  // namespace

Distribution find_distribution(const Scene& scene, const Needs& needs) {
  return DistributionFinder(scene, needs).find();
}

}  // namespace physgen::scenes
