// See groups.h.
#include "scenes/groups.h"

#include <algorithm>
#include <map>

#include "scenes/liveness.h"
#include "scenes/local_arrays.h"

namespace physgen::scenes {
namespace {

using Reasons = std::vector<std::string>;

class Joiner {
 public:
  Joiner(const Scene& scene, const usage::Usage& usage, const ProgramText& program, Needs& needs)
      : uses_(scene, usage), program_(program), needs_(needs), locals_(scene, usage, program, needs, uses_) {}

  void join() {
    for (std::size_t l = 0; l < program_.lists.size(); ++l) list(l);
    for (std::size_t g = 0; g < needs_.groups.size(); ++g)
      for (const std::string& local : needs_.groups[g].locals)
        for (ArrayNeed& array : needs_.arrays)
          if (array.array == local) array.group = static_cast<int>(g);
    others();
  }

 private:
  void list(std::size_t number) {
    const ProgramSteps& list = program_.lists[number];
    std::size_t first = 0;
    for (std::size_t k = 0; k < list.steps.size(); ++k) {
      Reasons why = k + 1 < list.steps.size() ? apart(list, first, k + 1) : Reasons{};
      if (k + 1 < list.steps.size() && why.empty()) continue;
      const std::size_t begin = first;
      first = pieces(number, first, k);
      if (k + 1 < list.steps.size() && first > begin) {
        // A reason against the whole may not hold for its end.
        if (why = apart(list, first, k + 1); why.empty()) continue;
      }
      group(number, first, k);
      if (k + 1 < list.steps.size()) not_joined(list, k, std::move(why));
      first = k + 1;
    }
  }

  /// Makes groups of steps that can be joined, but of the last: where no array becomes local, nothing is gained.
  /// @return the first step of the last
  std::size_t pieces(std::size_t number, std::size_t first, std::size_t last) {
    const ProgramSteps& list = program_.lists[number];
    const auto locals = locals_.of(list, first, last);
    for (std::size_t k = first; k < last; ++k) {
      if (std::any_of(locals.begin(), locals.end(),
                      [&](const Local& local) { return local.first <= k && local.last > k; }))
        continue;
      group(number, first, k);
      not_joined(list, k, locals_.why_none(list, first, k, last));
      first = k + 1;
    }
    return first;
  }

  void group(std::size_t number, std::size_t first, std::size_t last) {
    if (first == last) return;
    const ProgramSteps& list = program_.lists[number];
    StepGroup made{number, first, last, {}, {}, {}};
    for (std::size_t k = first; k <= last; ++k) {
      made.steps.push_back(list.steps[k].step);
      made.places.push_back(list.steps[k].place);
    }
    for (const Local& local : locals_.of(list, first, last)) made.locals.push_back(local.array);
    needs_.groups.push_back(std::move(made));
  }

  void not_joined(const ProgramSteps& list, std::size_t k, Reasons why) {
    const ProgramStep &first = list.steps[k], &second = list.steps[k + 1];
    std::vector<std::string> between;
    if (const auto *a = uses_.of(first.step), *b = uses_.of(second.step); a != nullptr && b != nullptr)
      for (const auto& one : a->fields)
        if (writes(one) && std::any_of(b->fields.begin(), b->fields.end(),
                                       [&](const auto& other) { return name_of(one) == name_of(other); }))
          between.push_back(text_of(name_of(one)));
    needs_.apart.push_back({first.step, second.step, second.place, std::move(why), std::move(between)});
  }

  // ---- Why a step cannot be joined to those before it --------------------------------------------------------------

  [[nodiscard]] Reasons apart(const ProgramSteps& list, std::size_t first, std::size_t next) const {
    Reasons why;
    const ProgramStep &before = list.steps[next - 1], &step = list.steps[next];
    if (!list.between[next - 1].empty()) why.push_back(list.between[next - 1] + " stands between them");
    for (std::size_t k = first; k < next; ++k) hazards(list.steps[k], step, why);
    if (head(step) != head(before))
      why.push_back("they are run in different words, '" + head(before) + "' and '" + head(step) + "'");
    if (step.runs.empty() || before.runs.empty())
      why.push_back(short_name(step.runs.empty() ? step.step : before.step) +
                    " runs over a number of objects that is not the size() of an array");
    else if (step.runs != before.runs)
      why.push_back("they run over different objects, " + before.runs + " and " + step.runs);
    for (const ProgramStep* one : {&before, &step}) alone(*one, why);
    if (why.empty() && step.scalar_bytes != before.scalar_bytes)
      why.push_back("packs of " + short_name(step.step) + " have another width");
    return why;
  }

  /// "on.run("
  [[nodiscard]] std::string head(const ProgramStep& step) const {
    return program_.text.substr(step.statement.begin, step.count.begin - step.statement.begin);
  }

  void alone(const ProgramStep& step, Reasons& why) const {
    const std::string name = short_name(step.step);
    if (!step.takes_packs)
      why.push_back(name + " takes no packs, since its call operator is not a template over the index");
    else if (!step.obstacle.empty())
      why.push_back(name + ": " + step.obstacle);
    else if (uses_.of(step.step) == nullptr)
      why.push_back(name + " is not told apart from another step by its name and arrays");
  }

  /// Fields that one of them stores and that the other uses not only at its own index.
  void hazards(const ProgramStep& first, const ProgramStep& second, Reasons& why) const {
    const auto *a = uses_.of(first.step), *b = uses_.of(second.step);
    if (a == nullptr || b == nullptr) return;
    for (const auto& one : a->fields)
      for (const auto& other : b->fields) {
        if (name_of(one) != name_of(other) || (!writes(one) && !writes(other))) continue;
        if (uses_.of_others(other, second.runs))
          of_others(second, other, why);
        else if (uses_.of_others(one, first.runs))
          of_others(first, one, why);
      }
  }
  static void of_others(const ProgramStep& step, const usage::FieldUse& use, Reasons& why) {
    std::string text = short_name(step.step);
    if (use.address_taken)
      text += " takes the address of " + text_of(name_of(use));
    else
      text += (use.added    ? " adds to "
               : reads(use) ? " reads "
                            : " writes ") +
              text_of(name_of(use)) + " of other objects than its own";
    if (!use.places.empty()) text += ", " + usage::text_of(use.places.front());
    if (std::find(why.begin(), why.end(), text) == why.end()) why.push_back(std::move(text));
  }

  // ---- Steps that the program's own text does not run --------------------------------------------------------------

  void others() {
    if (!program_.cause.empty()) needs_.not_joined.push_back("no step is looked at: " + program_.cause);
    std::map<std::string, Reasons> by_function;
    for (const auto& [step, function] : program_.elsewhere)
      if (auto& steps = by_function[function]; steps.empty() || steps.back() != short_name(step))
        steps.push_back(short_name(step));
    for (const auto& [function, steps] : by_function)
      needs_.not_joined.push_back(function + " runs " + listed(steps) +
                                  ": only neighbouring statements of the program's own text are joined");
  }

  StepUses uses_;
  const ProgramText& program_;
  Needs& needs_;
  LocalArrays locals_;
};

}  // namespace

void join_steps(const Scene& scene, const usage::Usage& usage, const ProgramText& program, Needs& needs) {
  Joiner(scene, usage, program, needs).join();
}

}  // namespace physgen::scenes
