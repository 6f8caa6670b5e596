// See halos.h.
#include "scenes/halos.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace physgen::scenes {
namespace {

using usage::FieldUse;
using usage::KernelUse;

bool is_unknown(const FieldUse& use) {
  return (reads(use) && !use.reads_own && !use.reads_others) || (writes(use) && !use.writes_own && !use.writes_others);
}
bool reads_others(const FieldUse& use) { return use.reads_others || (reads(use) && !use.reads_own); }
bool writes_others(const FieldUse& use) { return use.writes_others || (writes(use) && !use.writes_own); }

class HaloFinder {
 public:
  HaloFinder(const Scene& scene, const usage::Usage& usage, std::vector<Issue>& errors)
      : scene_(scene), usage_(usage), errors_(errors) {
    for (const Group& group : scene.groups)
      for (const Array& array : group.arrays) {
        arrays_.emplace(group.full_name(array), &array);
        if (!array.follows.empty()) follows_.insert({array.set, array.follows});
      }
    follow_what_is_counted_alike();
    for (const usage::StepUse& step : usage.steps)
      for (const KernelUse& kernel : step.kernels)
        for (const auto& row : kernel.views.rows) {
          rows_.insert({row.second, at(row.first).set});
          if (std::ranges::find(halos_.rows, row) == halos_.rows.end()) halos_.rows.emplace_back(row);
        }
  }

  Halos find() && {
    halos_.stated = states_names(scene_);
    if (!halos_.stated) return {};
    for (const usage::StepUse& step : usage_.steps) {
      if (step.root) continue;  // predicates and the host's values are of objects that every rank has
      const std::set<std::string> own = own_sets(step);
      for (const KernelUse& kernel : step.kernels) this->kernel(step, kernel, own);
      if (step.kernels.empty()) uses(step, {step.kernel, {}, step.fields}, {});
    }
    for (const auto& [key, row] : rows_of_table_) {
      const auto next = std::next(rows_of_table_.find(key));  // an empty field comes before all others of its view
      const bool is_used =
          next != rows_of_table_.end() && next->second.kernel == row.kernel && next->second.view == row.view;
      if (!row.field.empty() || !is_used) halos_.table.push_back(row);
    }
    for (const FieldUse& use : usage_.unattributed) outside(use);
    return std::move(halos_);
  }

 private:
  using Through = std::vector<std::string>;

  /// The host finds an object by a number, which is another one on each rank.
  void outside(const FieldUse& use) {
    const auto array = arrays_.find(use.array);
    if (!halos_.outside.empty() || array == arrays_.end() || is_replicated(*array->second)) return;
    halos_.outside = text_of(name_of(use)) + (use.places.empty() ? "" : " at " + text_of(use.places.front()));
  }

  [[nodiscard]] const Array& at(const std::string& name) const { return *arrays_.at(name); }
  /// A field that names the objects of a set which is followed may name those of others, which then are followed, too.
  void follow_what_is_counted_alike() {
    const auto stated = follows_;
    for (const auto& [name, array] : arrays_)
      for (const NamedObjects& one : array->names)
        for (const NamedObjects& other : array->names)
          if (one.field == other.field && !other.set.empty() && stated.contains({array->set, one.set}))
            follows_.insert({array->set, other.set});
  }
  /// Whether every rank has all objects.
  [[nodiscard]] static bool is_replicated(const Array& array) { return array.set.empty() || array.uniform; }

  /// Sets of the objects that are a step's own. Kernels of a fused one run over the same objects.
  [[nodiscard]] std::set<std::string> own_sets(const usage::StepUse& step) const {
    std::set<std::string> sets;
    for (const KernelUse& kernel : step.kernels)
      for (const FieldUse& use : kernel.fields)
        if ((use.reads_own || use.writes_own) && !is_replicated(at(use.array))) sets.insert(at(use.array).set);
    return sets;
  }

  /// The index fields by which a kernel may find objects of this array.
  [[nodiscard]] Through through(const KernelUse& kernel, const std::string& array) const {
    Through named, ranges;
    for (const FieldUse& use : kernel.fields) {
      if (!reads(use)) continue;
      const auto names_it = [&](const NamedObjects& one) { return one.field == use.field && one.set == at(array).set; };
      const auto is_range = [&](const auto& row) { return row.first == use.array && row.second == array; };
      if (std::ranges::any_of(at(use.array).names, names_it)) named.push_back(text_of(name_of(use)));
      if (std::ranges::any_of(kernel.views.rows, is_range)) ranges.push_back(text_of(name_of(use)));
    }
    if (!ranges.empty()) return ranges;
    return kernel.calculated.contains(array) ? Through() : named;
  }

  /// The steps of a kernel: rows of its table, and what it reads of others.
  void kernel(const usage::StepUse& step, const KernelUse& kernel, const std::set<std::string>& own) {
    uses(step, kernel, own);
    for (const FieldUse& use : kernel.fields)
      if (writes_others(use) && !is_replicated(at(use.array)) && !is_unknown(use)) write(step, kernel, use, own);
    if (kernel.name.empty()) return;
    for (std::size_t v = 0; v < kernel.views.arrays.size(); ++v) {
      const std::string& array = kernel.views.arrays[v];
      if (array.empty()) continue;
      bool is_used = false;
      for (const FieldUse& use : kernel.fields) {
        if (use.array != array) continue;
        is_used = true;
        row(kernel.name, static_cast<int>(v), use.field, use, others_through(kernel, use));
      }
      if (!is_used) row(kernel.name, static_cast<int>(v), "", {}, {});
    }
  }
  [[nodiscard]] Through others_through(const KernelUse& kernel, const FieldUse& use) const {
    return reads_others(use) || writes_others(use) ? through(kernel, use.array) : Through();
  }

  void row(const std::string& kernel, int view, const std::string& field, const FieldUse& use, const Through& through) {
    HaloRow& row = rows_of_table_[{kernel, view, field}];
    row.kernel = kernel;
    row.view = view;
    row.field = field;
    const bool any_read = reads(use) && !use.reads_own && !use.reads_others;
    const bool any_write = writes(use) && !use.writes_own && !use.writes_others;
    row.reads_own = row.reads_own || use.reads_own || any_read;
    row.reads_others = row.reads_others || use.reads_others || any_read;
    row.writes_own = row.writes_own || use.writes_own || any_write;
    row.writes_others = row.writes_others || use.writes_others || any_write;
    for (const std::string& one : through)
      if (std::ranges::find(row.through, one) == row.through.end()) row.through.push_back(one);
  }

  void uses(const usage::StepUse& step, const KernelUse& kernel, const std::set<std::string>& own) {
    UnknownHalo unknown{scenes::name_of(step), {}, ""};
    for (const FieldUse& use : kernel.fields) {
      if (is_unknown(use)) unknown.fields.push_back(text_of(name_of(use)));
      if (!reads(use) || !reads_others(use) || is_replicated(at(use.array))) continue;
      HaloRead read{scenes::name_of(step),
                    kernel.name.empty() ? step.kernel : kernel.name,
                    use.array,
                    use.field,
                    through(kernel, use.array),
                    ""};
      const std::string& set = at(use.array).set;
      for (const std::string& one : own) {
        if (follows_.contains({set, one})) read.local = set + " follows " + one;
        if (rows_.contains({use.array, one})) read.local = "rows of " + one;
      }
      const bool is_named = !read.through.empty() || kernel.calculated.contains(use.array);
      if (!is_named && !is_unknown(use) && !step.kernels.empty()) unnamed(step, kernel, use);
      if (std::ranges::find(halos_.reads, read) == halos_.reads.end()) halos_.reads.push_back(std::move(read));
    }
    if (unknown.fields.empty()) return;
    unknown.reason =
        "the kernel's call operator takes index_t, whose type does not tell its own object from others; "
        "write 'operator()(SingleObject auto i)'";
    halos_.unknown.push_back(std::move(unknown));
  }
  /// A read of others where an index field that the kernel reads does not say whose they are.
  void unnamed(const usage::StepUse& step, const KernelUse& kernel, const FieldUse& use) {
    for (const FieldUse& index : kernel.fields) {
      const Array& array = at(index.array);
      const auto field = std::ranges::find(array.fields, index.field, &Field::name);
      const bool has_names =
          std::ranges::any_of(array.names, [&](const auto& one) { return one.field == index.field; });
      const bool is_range =
          std::ranges::any_of(kernel.views.rows, [&](const auto& row) { return row.first == index.array; });
      if (!reads(index) || is_range || has_names || field == array.fields.end() || field->type != "int32") continue;
      if (!unnamed_.insert({text_of(name_of(index)), at(use.array).set}).second) return;
      return error(array.location, scenes::name_of(step) + " reads " + text_of(name_of(use)) +
                                       " of other objects, and index field " + text_of(name_of(index)) +
                                       " does not say whose they are; write names(\"" + index.field + "\", \"" +
                                       at(use.array).set + "\") at " + index.array + ", or no_index(\"" + index.field +
                                       "\")");
    }
  }

  /// Every object that a kernel writes beside its own must be one that the own ones follow, or in a row of one: then
  /// each rank computes all that is written to the objects that it owns.
  void write(const usage::StepUse& step, const KernelUse& kernel, const FieldUse& use,
             const std::set<std::string>& own) {
    const std::string& set = at(use.array).set;
    for (const std::string& one : own) {
      if (follows_.contains({one, set}) || rows_.contains({use.array, one})) return;
      for (const auto& [entries, ranges] : rows_)
        if (entries == use.array && follows_.contains({one, ranges})) return;
    }
    const Location place = use.written_places.empty() ? location(step.place) : location(use.written_places.front());
    const std::string over = own.empty() ? "whatever it runs over" : "over " + model::joined({own.begin(), own.end()});
    error(place, (kernel.name.empty() ? step.kernel : kernel.name) + " writes " + text_of(name_of(use)) +
                     " of other objects than its own, " + over + ", so that ranks would write each other's; declare " +
                     "follows(\"" + set + "\") of the set that it runs over, or gather at each " + set);
  }

  void error(const Location& place, std::string message) {
    Issue issue{Issue::Kind::error, place, std::move(message)};
    if (std::ranges::find(errors_, issue) == errors_.end()) errors_.push_back(std::move(issue));
  }

  const Scene& scene_;
  const usage::Usage& usage_;
  std::vector<Issue>& errors_;
  std::map<std::string, const Array*> arrays_;
  std::set<std::pair<std::string, std::string>> follows_;  // a set, and the one that it follows
  std::set<std::pair<std::string, std::string>> rows_;     // an array of entries, and the set that has the rows
  std::set<std::pair<std::string, std::string>> unnamed_;  // index fields, and sets, of which that was said
  std::map<std::tuple<std::string, int, std::string>, HaloRow> rows_of_table_;
  Halos halos_;
};

}  // namespace

Halos find_halos(const Scene& scene, const usage::Usage& usage, std::vector<Issue>& errors) {
  return HaloFinder(scene, usage, errors).find();
}

}  // namespace physgen::scenes
