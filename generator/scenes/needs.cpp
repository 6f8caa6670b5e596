// See needs.h.
#include "scenes/needs.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace physgen::scenes {
namespace {

using FieldName = std::pair<std::string, std::string>;  // array, field

FieldName name_of(const usage::FieldUse& use) { return {use.array, use.field}; }
bool reads(const usage::FieldUse& use) { return use.read || use.address_taken; }
bool writes(const usage::FieldUse& use) { return use.written || use.address_taken; }
std::string text_of(const FieldName& field) { return field.first + "." + field.second; }
Location location(const usage::Place& place) { return {place.file, place.line, place.column}; }

/// "a, b and c"; of many, the first few.
std::string listed(const std::vector<std::string>& words) {
  constexpr std::size_t most = 4;
  if (words.size() <= most) return model::joined(words, " and ");
  return model::joined({words.begin(), words.begin() + most}) + " and " + std::to_string(words.size() - most) + " more";
}

class Liveness {
 public:
  Liveness(const Scene& scene, const usage::Usage& usage) : scene_(scene), usage_(usage) {}

  Needs find() {
    known_names();
    roots();
    fixpoint();
    if (errors_.empty()) {
      dead_steps();
      for (const Group& group : scene_.groups)
        for (const Array& array : group.arrays) this->array(group.full_name(array), array);
    }
    needs_.issues = std::move(errors_);
    needs_.issues.insert(needs_.issues.end(), notes_.begin(), notes_.end());
    return std::move(needs_);
  }

 private:
  void error(const Location& place, std::string message) {
    errors_.push_back({Issue::Kind::error, place, std::move(message)});
  }
  void note(const Location& place, std::string message) {
    notes_.push_back({Issue::Kind::note, place, std::move(message)});
  }

  // ---- What is live -----------------------------------------------------------------------------------------------

  void known_names() {
    std::vector<std::string> arrays;
    for (const Group& group : scene_.groups)
      for (const Array& array : group.arrays) arrays.push_back(group.full_name(array));
    const auto known = [&](const usage::FieldUse& use) {
      const Array* array = scenes::find(scene_, use.array);
      if (array == nullptr) return error(scene_.location, unknown("array", use.array, arrays));
      std::vector<std::string> fields;
      for (const Field& field : array->fields) fields.push_back(field.name);
      if (std::find(fields.begin(), fields.end(), use.field) == fields.end())
        error(array->location, "in " + use.array + " " + unknown("field", use.field, fields));
    };
    for (const auto& step : usage_.steps) std::for_each(step.fields.begin(), step.fields.end(), known);
    std::for_each(usage_.unattributed.begin(), usage_.unattributed.end(), known);
  }

  void roots() {
    for (const Group& group : scene_.groups)
      for (const Array& array : group.arrays)
        for (const Field& field : array.fields)
          if (array.is_output(field.name)) wanted_.insert({group.full_name(array), field.name});
    for (const auto& use : usage_.unattributed) {
      if (reads(use)) wanted_.insert(name_of(use));
      if (writes(use)) written_.insert(name_of(use));
    }
    for (const auto& use : usage_.unknown) unknown_use(use);
  }

  /// All of the array may be read and written there.
  void unknown_use(const usage::UnknownUse& use) {
    const Array* array = scenes::find(scene_, use.array);
    if (array != nullptr && array->output && array->output->all) return;  // all of it stays
    error(location(use.place), use.what + " of " + use.array +
                                   " hides which fields are used; write view[i].field(), or declare the array "
                                   "output(), which keeps all its fields");
  }

  [[nodiscard]] bool is_live(const usage::StepUse& step) const {
    return step.root || std::any_of(step.fields.begin(), step.fields.end(), [&](const usage::FieldUse& use) {
             return writes(use) && wanted_.contains(name_of(use));
           });
  }

  void fixpoint() {
    live_.assign(usage_.steps.size(), false);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < usage_.steps.size(); ++i) {
        if (live_[i] || !is_live(usage_.steps[i])) continue;
        live_[i] = changed = true;
        for (const auto& use : usage_.steps[i].fields) {
          if (reads(use)) wanted_.insert(name_of(use));
          if (writes(use)) written_.insert(name_of(use));
        }
      }
    }
  }

  /// Their kernels are in the program, so that they would read fields that are not there, or run for nothing.
  void dead_steps() {
    for (std::size_t i = 0; i < usage_.steps.size(); ++i) {
      if (live_[i]) continue;
      const usage::StepUse& step = usage_.steps[i];
      std::vector<std::string> written;
      for (const auto& use : step.fields)
        if (writes(use)) written.push_back(text_of(name_of(use)));
      const std::string what = "the step " + scenes::name_of(step) + " ";
      if (written.empty())
        error(location(step.place), what + "writes no field; take it out of the program");
      else
        error(location(step.place), what + "writes only " + listed(written) +
                                        ", which nothing that is wanted depends on; take the step out of the "
                                        "program, or declare what it writes output(...)");
    }
  }

  // ---- What becomes of each field ----------------------------------------------------------------------------------

  void array(const std::string& name, const Array& array) {
    ArrayNeed need;
    need.array = name;
    need.read_only = true;
    for (const Field& field : array.fields) {
      need.fields.push_back(this->field(name, array, field));
      if (!need.fields.back().writers.empty() || written_.contains({name, field.name})) need.read_only = false;
    }
    if (array.output && array.output->all &&
        std::none_of(array.fields.begin(), array.fields.end(),
                     [&](const Field& field) { return written_.contains({name, field.name}); }))
      error(array.output->location, "the output " + name +
                                        " is written by no step; run the step that computes it, or "
                                        "take output() away");
    for (const auto& [key, fields] : pruned_) {
      std::vector<std::string> names;
      for (const auto& [place, field] : fields) names.push_back(field);
      const bool one = names.size() == 1;
      note(fields.front().first, (one ? "field " : "fields ") + model::joined(names, " and ") + " of " + name +
                                     (one ? " is pruned: " : " are pruned: ") + key.second + " writes " +
                                     (one ? "it" : "them") + ", and nothing reads " + (one ? "it" : "them"));
    }
    pruned_.clear();
    if (need.left_out()) note(array.location, "array " + name + " is left out: no field of it is needed");
    needs_.arrays.push_back(std::move(need));
  }

  FieldNeed field(const std::string& array_name, const Array& array, const Field& field) {
    const FieldName name{array_name, field.name};
    FieldNeed need;
    need.field = field;
    need.kept = wanted_.contains(name);
    for (const auto& step : usage_.steps)
      for (const auto& use : step.fields) uses(use, name, scenes::name_of(step), need);
    for (const auto& use : usage_.unattributed) uses(use, name, "code outside of steps", need);
    problems(name, array, need);
    need.why = why(array, need);
    return need;
  }

  static void uses(const usage::FieldUse& use, const FieldName& name, const std::string& step, FieldNeed& need) {
    if (name_of(use) != name) return;
    if (writes(use)) need.writers.push_back({step, use.places});
    if (reads(use)) need.readers.push_back({step, use.places});
  }

  void problems(const FieldName& name, const Array& array, const FieldNeed& need) {
    const std::string& field = name.second;
    const std::string option = "(\"" + field + "\")";
    const bool is_input = array.is_input(field), is_output = array.is_output(field);
    if (array.uniform && !need.writers.empty()) {
      error(array.location, "array " + name.first + " is uniform(), one record for all objects, and " +
                                need.writers.front().step + " writes its field '" + field +
                                "' of each; take uniform() away");
    } else if (need.kept && !written_.contains(name) && !is_input && !need.field.initial) {
      if (!need.readers.empty())
        error(first_place(need.readers.front(), array),
              "field " + text_of(name) + " is read by " + need.readers.front().step +
                  ", and no step writes it; declare input" + option + " where " + name.first +
                  " is declared, or run the step that computes it");
      else if (is_output && !(array.output->all && nothing_written(name.first, array)))
        error(array.output->location,
              "the output " + text_of(name) +
                  " is written by no step; run the step that computes it, or name it no output");
    } else if (is_output && !array.output->all && !written_.contains(name)) {
      error(array.output->location, "the output " + text_of(name) +
                                        " is written by no step; run the step that computes it, or name it no output");
    } else if (!need.kept && !need.writers.empty()) {
      pruned_[{name.first, need.writers.front().step}].push_back({first_place(need.writers.front(), array), field});
    } else if (!need.kept && is_input && !array.input->all) {
      note(array.input->location, "field " + text_of(name) + " is pruned: it is an input, and nothing reads it");
    }
  }

  /// An output that is written nowhere is one error, not one for each of its fields.
  [[nodiscard]] bool nothing_written(const std::string& name, const Array& array) const {
    return std::none_of(array.fields.begin(), array.fields.end(),
                        [&](const Field& field) { return written_.contains({name, field.name}); });
  }

  static Location first_place(const StepOfField& step, const Array& array) {
    return step.places.empty() ? array.location : location(step.places.front());
  }

  static std::string why(const Array& array, const FieldNeed& need) {
    const auto steps = [](const std::vector<StepOfField>& uses) {
      std::vector<std::string> names;
      for (const StepOfField& use : uses)
        if (std::find(names.begin(), names.end(), use.step) == names.end()) names.push_back(use.step);
      return listed(names);
    };
    std::vector<std::string> parts;
    if (array.is_input(need.field.name)) parts.emplace_back("it is an input");
    if (need.field.initial) parts.emplace_back("it has an initial value");
    if (!need.writers.empty()) parts.push_back("written by " + steps(need.writers));
    if (!need.readers.empty()) parts.push_back("read by " + steps(need.readers));
    if (array.is_output(need.field.name)) parts.emplace_back("wanted as an output");
    if (need.readers.empty() && !need.kept) parts.emplace_back(parts.empty() ? "nothing uses it" : "nothing reads it");
    return text(parts);
  }

  static std::string text(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
    return text;
  }

  const Scene& scene_;
  const usage::Usage& usage_;
  std::set<FieldName> wanted_, written_;  // by live steps
  std::vector<bool> live_;                // beside usage_.steps
  // Of one array: its fields that are written in vain, by their first step.
  std::map<FieldName, std::vector<std::pair<Location, std::string>>> pruned_;
  std::vector<Issue> errors_, notes_;
  Needs needs_;
};

}  // namespace

bool ArrayNeed::left_out() const {
  return std::none_of(fields.begin(), fields.end(), [](const FieldNeed& need) { return need.kept; });
}

bool Needs::sound() const {
  return std::none_of(issues.begin(), issues.end(),
                      [](const Issue& issue) { return issue.kind == Issue::Kind::error; });
}

const ArrayNeed& Needs::of(const std::string& array) const {
  for (const ArrayNeed& need : arrays)
    if (need.array == array) return need;
  throw std::logic_error("no needs of the array " + array);
}

Needs find_needs(const Scene& scene, const usage::Usage& usage) { return Liveness(scene, usage).find(); }

Needs everything(Needs needs) {
  for (ArrayNeed& array : needs.arrays)
    for (FieldNeed& field : array.fields) field.kept = true;
  return needs;
}

std::string name_of(const usage::StepUse& step) {
  return step.arrays.empty() ? step.kernel : step.kernel + "(" + model::joined(step.arrays) + ")";
}

}  // namespace physgen::scenes
