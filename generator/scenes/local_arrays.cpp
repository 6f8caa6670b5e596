// See local_arrays.h.
#include "scenes/local_arrays.h"

#include <algorithm>

#include "scenes/issue.h"

namespace physgen::scenes {
namespace {

bool has(const usage::StepUse& step, const std::string& array) {
  return std::find(step.arrays.begin(), step.arrays.end(), array) != step.arrays.end() ||
         std::any_of(step.fields.begin(), step.fields.end(),
                     [&](const usage::FieldUse& use) { return use.array == array; });
}

}  // namespace

std::string short_name(const std::string& step) {
  const std::string kernel = step.substr(0, step.find('('));
  const std::size_t scope = kernel.substr(0, kernel.find('<')).rfind("::");
  return scope == std::string::npos ? kernel : kernel.substr(scope + 2);
}

std::string short_names(const std::vector<std::string>& steps) {
  std::vector<std::string> names;
  for (const std::string& step : steps) names.push_back(short_name(step));
  return model::joined(names, " and ");
}

std::string counted(const Group& group, const Array& array) {
  return array.set.empty() ? set_of(array) : set_of(array) + " of " + group.variable;
}

StepUses::StepUses(const Scene& scene, const usage::Usage& usage) : scene_(scene) {
  for (const usage::StepUse& step : usage.steps) {
    const auto [entry, is_new] = steps_.try_emplace(scenes::name_of(step), &step);
    if (!is_new) entry->second = nullptr;
  }
}

const usage::StepUse* StepUses::of(const std::string& step) const {
  const auto found = steps_.find(step);
  return found == steps_.end() ? nullptr : found->second;
}

bool StepUses::of_others(const usage::FieldUse& use, const std::string& runs) const {
  if (!use.own || use.gathered || use.added || use.address_taken) return true;
  for (const Group& group : scene_.groups)
    for (const Array& array : group.arrays)
      if (group.full_name(array) == use.array && counted(group, array) != runs) return true;
  return false;
}

/// Steps first .. last of a list.
struct LocalArrays::Range {
  const ProgramSteps& list;
  std::size_t first, last;

  [[nodiscard]] bool has(const std::string& step) const {
    return std::any_of(begin(), end(), [&](const ProgramStep& one) { return one.step == step; });
  }
  [[nodiscard]] std::vector<ProgramStep>::const_iterator begin() const {
    return list.steps.begin() + static_cast<long>(first);
  }
  [[nodiscard]] std::vector<ProgramStep>::const_iterator end() const {
    return list.steps.begin() + static_cast<long>(last) + 1;
  }
};

std::vector<Local> LocalArrays::of(const ProgramSteps& list, std::size_t first, std::size_t last) const {
  std::vector<Local> result;
  const Range range{list, first, last};
  for (const Group& group : scene_.groups)
    for (const Array& array : group.arrays) {
      const std::string name = group.full_name(array);
      std::vector<std::size_t> users;
      for (std::size_t k = first; k <= last; ++k)
        if (const auto* use = uses_.of(list.steps[k].step); use != nullptr && has(*use, name)) users.push_back(k);
      if (users.size() < 2 || counted(group, array) != list.steps[first].runs) continue;
      if (why_not(range, name, array).empty()) result.push_back({name, users.front(), users.back()});
    }
  return result;
}

std::vector<std::string> LocalArrays::why_none(const ProgramSteps& list, std::size_t first, std::size_t k,
                                               std::size_t last) const {
  std::vector<std::string> why;
  const Range range{list, first, last};
  const auto *before = uses_.of(list.steps[k].step), *behind = uses_.of(list.steps[k + 1].step);
  for (const Group& group : scene_.groups)
    for (const Array& array : group.arrays) {
      const std::string name = group.full_name(array);
      if (before == nullptr || behind == nullptr || !has(*before, name) || !has(*behind, name)) continue;
      if (needs_.of(name).read_only) continue;
      const std::string reason = why_not(range, name, array);
      why.push_back(name + " is stored: " + (reason.empty() ? "it is not per object of theirs" : reason) +
                    remedy(range, name, array));
    }
  if (why.empty()) why.emplace_back("neither stores what the other reads");
  return why;
}

/// @return why an array cannot be local to these steps; empty: it can
std::string LocalArrays::why_not(const Range& range, const std::string& name, const Array& array) const {
  if (array.input) return "it is an input";
  if (array.output) return "it is an output";
  if (array.uniform) return "it is uniform";
  if (needs_.of(name).left_out()) return "nothing of it is kept";
  if (const auto used = program_.used.find(name); used != program_.used.end())
    return "the program does more than hand its views to kernels" + used->second;
  for (const auto& use : usage_.unattributed)
    if (use.array == name) return "code outside of steps uses it";
  for (const auto& use : usage_.unknown)
    if (use.array == name) return use.what + " of it hides what is used";
  if (std::string reason = why_not_used_here(range, name); !reason.empty()) return reason;
  return why_not_stored(range, name);
}

/// Fields that only these steps use are stored with others that are given or wanted.
std::string LocalArrays::remedy(const Range& range, const std::string& name, const Array& array) const {
  std::vector<std::string> own;
  if (!array.input && !array.output) return {};
  for (const Field& field : array.fields) {
    const auto has_field = [&](const usage::FieldUse& use) { return name_of(use) == FieldName(name, field.name); };
    std::size_t users = 0, others = 0;
    for (const usage::StepUse& step : usage_.steps)
      if (std::ranges::any_of(step.fields, has_field)) ++(range.has(scenes::name_of(step)) ? users : others);
    if (users > 1 && others == 0 && std::ranges::none_of(usage_.unattributed, has_field) &&
        !array.is_input(field.name) && !array.is_output(field.name))
      own.push_back(field.name);
  }
  if (own.empty() || own.size() == array.fields.size()) return {};
  return "; put " + model::joined(own, " and ") + " in an array of its own, which these steps alone use";
}

std::string LocalArrays::why_not_used_here(const Range& range, const std::string& name) const {
  for (const usage::StepUse& step : usage_.steps) {
    if (!has(step, name)) continue;
    const std::string called = scenes::name_of(step);
    if (!range.has(called)) return short_name(called) + " uses it, too";
    if (const auto other = program_.elsewhere.find(called); other != program_.elsewhere.end())
      return short_name(called) + " is also run by " + other->second;
    const auto runs = program_.runs.find(called);
    if (runs == program_.runs.end() || runs->second != 1) return short_name(called) + " is run more than once";
    for (const auto& use : step.fields)
      if (use.array == name && uses_.of_others(use, range.begin()->runs))
        return short_name(called) + " uses " + text_of(name_of(use)) + " of other objects than its own";
  }
  return {};
}

/// A field that is read must have been stored before: a local has no values of its own.
std::string LocalArrays::why_not_stored(const Range& range, const std::string& name) const {
  std::set<FieldName> stored;
  for (const ProgramStep& step : range) {
    const auto* uses = uses_.of(step.step);
    if (uses == nullptr) return short_name(step.step) + " is not told apart from other steps";
    for (const auto& use : uses->fields)
      if (use.array == name && reads(use) && !stored.contains(name_of(use)))
        return "no earlier step of the group is sure to store all of " + text_of(name_of(use)) + ", which " +
               short_name(step.step) + " reads";
    stored.insert(step.stores.begin(), step.stores.end());
  }
  return {};
}

}  // namespace physgen::scenes
