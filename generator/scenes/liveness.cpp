// See liveness.h.
#include "scenes/liveness.h"

#include <algorithm>

namespace physgen::scenes {
namespace {

class LivenessFinder {
 public:
  LivenessFinder(const Scene& scene, const usage::Usage& usage) : scene_(scene), usage_(usage) {
    for (const usage::StepUse& step : usage.steps) dead_.push_back(&step);
  }

  Liveness find() && {
    for (const auto& step : usage_.steps) known_names(step.fields);
    known_names(usage_.unattributed);
    roots();
    fixpoint();
    if (result_.complete = result_.errors.empty(); result_.complete) dead_steps();
    return std::move(result_);
  }

 private:
  void error(const Location& place, std::string message) {
    result_.errors.push_back({Issue::Kind::error, place, std::move(message)});
  }

  void known_names(const std::vector<usage::FieldUse>& uses) {
    for (const auto& use : uses) {
      std::vector<std::string> names;
      const Array* array = scenes::find(scene_, use.array);
      if (array == nullptr) {
        for (const Group& group : scene_.groups)
          for (const Array& one : group.arrays) names.push_back(group.full_name(one));
        error(scene_.location, unknown("array", use.array, names));
        continue;
      }
      for (const Field& field : array->fields) names.push_back(field.name);
      if (std::ranges::count(names, use.field) == 0)
        error(array->location, "in " + use.array + " " + unknown("field", use.field, names));
    }
  }

  void used(const std::vector<usage::FieldUse>& uses) {
    for (const auto& use : uses) {
      if (reads(use)) result_.wanted.insert(name_of(use));
      if (writes(use)) result_.written.insert(name_of(use));
    }
  }

  void roots() {
    for (const Group& group : scene_.groups)
      for (const Array& array : group.arrays)
        for (const Field& field : array.fields)
          if (array.is_output(field.name)) result_.wanted.insert({group.full_name(array), field.name});
    used(usage_.unattributed);
    for (const auto& use : usage_.unknown)  // all of the array may be read and written there
      if (const Array* array = scenes::find(scene_, use.array);
          array == nullptr || !array->output || !array->output->all)
        error(location(use.place), use.what + " of " + use.array +
                                       " hides which fields are used; write view[i].field(), or declare the array "
                                       "output(), which keeps all its fields");
    for (const auto& race : usage_.races) error(location(race.writer_place), usage::text_of(race));
    for (const auto& dependence : usage_.dependences) error(location(dependence.place), usage::text_of(dependence));
  }

  void fixpoint() {
    for (std::size_t before = dead_.size() + 1; before != dead_.size();) {
      before = dead_.size();
      std::erase_if(dead_, [&](const usage::StepUse* step) {
        const bool is_live = step->root || std::ranges::any_of(step->fields, [&](const usage::FieldUse& use) {
                               return writes(use) && result_.wanted.contains(name_of(use));
                             });
        if (is_live) used(step->fields);
        return is_live;
      });
    }
  }

  /// Their kernels are in the program, so that they would read fields that are not there, or run for nothing.
  void dead_steps() {
    for (const usage::StepUse* step : dead_) {
      std::vector<std::string> written;
      for (const auto& use : step->fields)
        if (writes(use)) written.push_back(text_of(name_of(use)));
      error(location(step->place),
            "the step " + scenes::name_of(*step) +
                (written.empty() ? " writes no field; take it out of the program"
                                 : " writes only " + listed(written) +
                                       ", which nothing that is wanted depends on; take the step out of the program, "
                                       "or declare what it writes output(...)"));
    }
  }

  const Scene& scene_;
  const usage::Usage& usage_;
  std::vector<const usage::StepUse*> dead_;  // those that are not found live
  Liveness result_;
};

}  // namespace

Liveness find_liveness(const Scene& scene, const usage::Usage& usage) { return LivenessFinder(scene, usage).find(); }

}  // namespace physgen::scenes
