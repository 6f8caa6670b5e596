// See liveness.h.
#include "scenes/liveness.h"

#include <algorithm>

namespace physgen::scenes {
namespace {

class LivenessFinder {
 public:
  LivenessFinder(const Scene& scene, const usage::Usage& usage) : scene_(scene), usage_(usage) {}

  Liveness find() && {
    known_names();
    roots();
    fixpoint();
    result_.complete = result_.errors.empty();
    if (result_.complete) dead_steps();
    return std::move(result_);
  }

 private:
  void error(const Location& place, std::string message) {
    result_.errors.push_back({Issue::Kind::error, place, std::move(message)});
  }

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
          if (array.is_output(field.name)) result_.wanted.insert({group.full_name(array), field.name});
    for (const auto& use : usage_.unattributed) {
      if (reads(use)) result_.wanted.insert(name_of(use));
      if (writes(use)) result_.written.insert(name_of(use));
    }
    for (const auto& use : usage_.unknown) unknown_use(use);
    for (const auto& race : usage_.races) error(location(race.writer_place), usage::text_of(race));
    for (const auto& dependence : usage_.dependences) error(location(dependence.place), usage::text_of(dependence));
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
             return writes(use) && result_.wanted.contains(name_of(use));
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
          if (reads(use)) result_.wanted.insert(name_of(use));
          if (writes(use)) result_.written.insert(name_of(use));
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

  const Scene& scene_;
  const usage::Usage& usage_;
  std::vector<bool> live_;  // beside usage_.steps
  Liveness result_;
};

}  // namespace

std::string listed(const std::vector<std::string>& words) {
  constexpr std::size_t most = 4;
  if (words.size() <= most) return model::joined(words, " and ");
  return model::joined({words.begin(), words.begin() + most}) + " and " + std::to_string(words.size() - most) + " more";
}

Liveness find_liveness(const Scene& scene, const usage::Usage& usage) { return LivenessFinder(scene, usage).find(); }

}  // namespace physgen::scenes
