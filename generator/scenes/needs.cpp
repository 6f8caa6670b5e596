// See needs.h.
#include "scenes/needs.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "scenes/liveness.h"

namespace physgen::scenes {
namespace {

/// "fields U and V of body.svds are"
std::string these(const std::string& array, const std::vector<std::string>& fields) {
  return (fields.size() == 1 ? "field " : "fields ") + model::joined(fields, " and ") + " of " + array +
         (fields.size() == 1 ? " is" : " are");
}

std::string in_quotes(std::vector<std::string> fields) {
  for (std::string& field : fields) field = '"' + field + '"';
  return model::joined(fields);
}

/// Decides the fate of each field, and collects what is to be said about it.
class NeedsFinder {
 public:
  NeedsFinder(const Scene& scene, const usage::Usage& usage)
      : scene_(scene), usage_(usage), live_(find_liveness(scene, usage)), errors_(live_.errors) {}

  Needs find() && {
    if (live_.complete)
      for (const Group& group : scene_.groups)
        for (const Array& array : group.arrays) this->array(group.full_name(array), array);
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

  void array(const std::string& name, const Array& array) {
    ArrayNeed need;
    need.array = name;
    need.read_only = true;
    for (const Field& field : array.fields) {
      need.fields.push_back(this->field(name, array, field));
      if (!need.fields.back().writers.empty() || live_.written.contains({name, field.name})) need.read_only = false;
    }
    if (array.output && array.output->all &&
        std::none_of(array.fields.begin(), array.fields.end(),
                     [&](const Field& field) { return live_.written.contains({name, field.name}); }))
      error(array.output->location, "the output " + name +
                                        " is written by no step; run the step that computes it, or "
                                        "take output() away");
    say_of_fields();
    note_early_reads(name, array, need);
    if (need.left_out()) note(array.location, "array " + name + " is left out: no field of it is needed");
    needs_.arrays.push_back(std::move(need));
  }

  /// Fields of one step are one issue.
  void say_of_fields() {
    for (const auto& [key, fields] : unwritten_) {
      const char* them = fields.size() == 1 ? "it" : "them";
      error(fields.front().first, these(key.first, names_of(fields)) + " read by " + key.second +
                                      ", and no step writes " + them + "; declare input(" +
                                      in_quotes(names_of(fields)) + ") where " + key.first +
                                      " is declared, or run the step that computes " + them);
    }
    for (const auto& [key, fields] : pruned_) {
      const char* them = fields.size() == 1 ? "it" : "them";
      note(fields.front().first, these(key.first, names_of(fields)) + " pruned: " + key.second + " writes " + them +
                                     ", and nothing reads " + them);
    }
    unwritten_.clear();
    pruned_.clear();
  }

  /// Notes fields that a step reads before any step has written them. Not of arrays with uses that cannot be followed,
  /// nor of uniform ones, which the caller fills.
  void note_early_reads(const std::string& name, const Array& array, const ArrayNeed& need) {
    if (array.uniform || std::ranges::any_of(usage_.unknown, [&](const auto& use) { return use.array == name; }))
      return;
    std::vector<ReadTooEarly> found;
    for (const usage::EarlyRead& early : usage_.early_reads) {
      // A get() of all fields tells what is needed where there is but one.
      if (early.array != name || (early.whole_object && array.fields.size() > 1)) continue;
      const auto of = std::ranges::find(need.fields, early.field, [](const auto& one) { return one.field.name; });
      if (of == need.fields.end() || !of->kept || !live_.written.contains({name, early.field}) ||
          array.is_input(early.field) || of->field.initial)
        continue;
      const std::string step = early.step.kernel.empty() ? "code outside of steps" : scenes::name_of(early.step);
      auto same = std::ranges::find(found, step, &ReadTooEarly::step);
      if (same == found.end()) same = found.insert(same, {name, {}, step, early.place});
      if (std::ranges::find(same->fields, early.field) == same->fields.end()) same->fields.push_back(early.field);
    }
    for (const ReadTooEarly& read : found) {
      note(read.place == usage::Place() ? array.location : location(read.place), text_of(read));
      needs_.read_too_early.push_back(read);
    }
  }

  using Places = std::vector<std::pair<Location, std::string>>;  // of fields

  static std::vector<std::string> names_of(const Places& fields) {
    std::vector<std::string> names;
    for (const auto& [place, field] : fields) names.push_back(field);
    return names;
  }

  FieldNeed field(const std::string& array_name, const Array& array, const Field& field) {
    const FieldName name{array_name, field.name};
    FieldNeed need;
    need.field = field;
    need.kept = live_.wanted.contains(name);
    for (const auto& step : usage_.steps)
      for (const auto& use : step.fields) uses(use, name, scenes::name_of(step), need);
    for (const auto& use : usage_.unattributed) uses(use, name, "code outside of steps", need);
    problems(name, array, need);
    need.why = why(array, need);
    return need;
  }

  static void uses(const usage::FieldUse& use, const FieldName& name, const std::string& step, FieldNeed& need) {
    if (name_of(use) != name) return;
    if (writes(use)) need.writers.push_back({step, use.written_places});
    if (reads(use)) need.readers.push_back({step, use.read_places});
  }

  void problems(const FieldName& name, const Array& array, const FieldNeed& need) {
    const std::string& field = name.second;
    const bool is_input = array.is_input(field), is_output = array.is_output(field);
    if (array.uniform && !need.writers.empty()) {
      error(array.location, "array " + name.first + " is uniform(), one record for all objects, and " +
                                need.writers.front().step + " writes its field '" + field +
                                "' of each; take uniform() away");
    } else if (need.kept && !live_.written.contains(name) && !is_input && !need.field.initial) {
      if (!need.readers.empty())
        unwritten_[{name.first, need.readers.front().step}].push_back(
            {first_place(need.readers.front(), array), field});
      else if (is_output && !(array.output->all && nothing_written(name.first, array)))
        error(array.output->location,
              "the output " + text_of(name) +
                  " is written by no step; run the step that computes it, or name it no output");
    } else if (is_output && !array.output->all && !live_.written.contains(name)) {
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
                        [&](const Field& field) { return live_.written.contains({name, field.name}); });
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
  Liveness live_;
  // Fields of the array at hand that are read and never written, or written in vain: by array and first step.
  std::map<std::pair<std::string, std::string>, Places> unwritten_, pruned_;
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

std::string text_of(const ReadTooEarly& read) {
  const char* them = read.fields.size() == 1 ? "it" : "them";
  return these(read.array, read.fields) + " read by " + read.step + " before any step has written " + them +
         "; declare input(" + in_quotes(read.fields) + ") where " + read.array +
         " is declared, or run a step before it that writes " + them;
}

std::vector<std::string> fields_without_values(const Array& array, const ArrayNeed& need) {
  std::vector<std::string> names;
  for (const FieldNeed& field : need.fields)
    if (field.kept && !need.local() && !array.is_input(field.field.name) && !field.field.initial)
      names.push_back(field.field.name);
  return names;
}

Needs find_needs(const Scene& scene, const usage::Usage& usage) { return NeedsFinder(scene, usage).find(); }

Needs everything(Needs needs) {
  for (ArrayNeed& array : needs.arrays) {
    array.group = -1;
    for (FieldNeed& field : array.fields) field.kept = true;
  }
  needs.groups.clear();
  needs.apart.clear();
  needs.not_joined.clear();
  return needs;
}

}  // namespace physgen::scenes
