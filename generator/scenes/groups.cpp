// See groups.h.
#include "scenes/groups.h"

#include <algorithm>
#include <map>

#include "scenes/issue.h"
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
      for (ArrayNeed& array : needs_.arrays)
        if (std::ranges::count(needs_.groups[g].locals, array.array) > 0) array.group = static_cast<int>(g);
    if (!program_.cause.empty()) needs_.not_joined.push_back("no step is looked at: " + program_.cause);
    std::map<std::string, Reasons> by_function;
    for (const auto& [step, function] : program_.elsewhere)
      if (auto& steps = by_function[function]; steps.empty() || steps.back() != short_name(step))
        steps.push_back(short_name(step));
    for (const auto& [function, steps] : by_function)
      needs_.not_joined.push_back(function + " runs " + listed(steps) +
                                  ": only neighbouring statements of the program's own text are joined");
  }

 private:
  void list(std::size_t number) {
    const ProgramSteps& list = program_.lists[number];
    for (std::size_t first = 0, next = 1; next <= list.steps.size(); ++next) {
      const bool is_end = next == list.steps.size();
      Reasons why = is_end ? Reasons{} : apart(list, first, next);
      if (!is_end && why.empty()) continue;
      const std::size_t rest = pieces(number, first, next - 1);
      // A reason against the whole may not hold for its end.
      if (!is_end && rest > first && (why = apart(list, first = rest, next)).empty()) continue;
      group(number, rest, next - 1);
      if (!is_end) not_joined(list, next - 1, std::move(why));
      first = next;
    }
  }

  /// Makes groups of steps that can be joined, but of the last: where no array becomes local, nothing is gained.
  /// @return the first step of the last
  std::size_t pieces(std::size_t number, std::size_t first, std::size_t last) {
    const ProgramSteps& list = program_.lists[number];
    const auto locals = locals_.of(list, first, last);
    for (std::size_t k = first; k < last; ++k) {
      if (std::ranges::any_of(locals, [&](const Local& local) { return local.first <= k && local.last > k; })) continue;
      group(number, first, k);
      not_joined(list, k, locals_.why_none(list, first, k, last));
      first = k + 1;
    }
    return first;
  }

  void group(std::size_t number, std::size_t first, std::size_t last) {
    if (first == last) return;
    StepGroup made{number, first, last, {}, {}, {}};
    for (std::size_t k = first; k <= last; ++k) {
      made.steps.push_back(program_.lists[number].steps[k].step);
      made.places.push_back(program_.lists[number].steps[k].place);
    }
    for (const Local& local : locals_.of(program_.lists[number], first, last)) made.locals.push_back(local.array);
    needs_.groups.push_back(std::move(made));
  }

  void not_joined(const ProgramSteps& list, std::size_t k, Reasons why) {
    const ProgramStep &first = list.steps[k], &second = list.steps[k + 1];
    StepsApart apart{first.step, second.step, second.place, std::move(why), {}};
    for_shared(first, second, [&](const usage::FieldUse& one, const usage::FieldUse&) {
      if (writes(one)) apart.between.push_back(text_of(name_of(one)));
    });
    needs_.apart.push_back(std::move(apart));
  }

  /// Visits the uses of each field that both steps use.
  template <class Visit>
  void for_shared(const ProgramStep& first, const ProgramStep& second, const Visit& visit) const {
    if (const auto *a = uses_.of(first.step), *b = uses_.of(second.step); a != nullptr && b != nullptr)
      for (const auto& one : a->fields)
        for (const auto& other : b->fields)
          if (name_of(one) == name_of(other)) visit(one, other);
  }

  /// Why a step cannot be joined to those before it.
  [[nodiscard]] Reasons apart(const ProgramSteps& list, std::size_t first, std::size_t next) const {
    Reasons why;
    const ProgramStep &before = list.steps[next - 1], &step = list.steps[next];
    const std::string name = short_name(step.step), earlier = short_name(before.step);
    if (!list.between[next - 1].empty())
      why.push_back(list.between[next - 1] + " stands between them; write it before " + earlier + " or behind " + name +
                    " where it may stand there");
    for (std::size_t k = first; k < next; ++k)
      for_shared(list.steps[k], step, [&](const usage::FieldUse& one, const usage::FieldUse& other) {
        if (!writes(one) && !writes(other)) return;
        const std::string text = uses_.of_others(other, step.runs) ? of_others(name, other)
                                 : uses_.of_others(one, list.steps[k].runs)
                                     ? of_others(short_name(list.steps[k].step), one)
                                     : "";
        if (!text.empty() && std::ranges::count(why, text) == 0) why.push_back(text);
      });
    const auto head = [&](const ProgramStep& one) {  // "on.run("
      return program_.text.substr(one.statement.begin, one.count.begin - one.statement.begin);
    };
    if (head(step) != head(before))
      why.push_back("they are run in different words, '" + head(before) + "' and '" + head(step) + "'");
    if (step.runs.empty() || before.runs.empty())
      why.push_back((step.runs.empty() ? name : earlier) +
                    " runs over a number of objects that is not the size() of an array, as it is and in a const "
                    "variable of its type at most");
    else if (step.runs != before.runs)
      why.push_back("they run over different objects, " + before.runs + " and " + step.runs);
    for (const ProgramStep* one : {&before, &step})
      if (!one->takes_packs)
        why.push_back(short_name(one->step) + " cannot take packs, since its call operator takes single objects alone");
      else if (!one->obstacle.empty())
        why.push_back(short_name(one->step) + ": " + one->obstacle);
      else if (uses_.of(one->step) == nullptr)
        why.push_back(short_name(one->step) + " is not told apart from another step by its name and arrays");
    if (why.empty() && step.scalar_bytes != before.scalar_bytes)
      why.push_back("packs of " + name + " have another width");
    return why;
  }
  static std::string of_others(const std::string& step, const usage::FieldUse& use) {
    const char* what = use.added ? " adds to " : reads(use) ? " reads " : " writes ";
    return step + (use.address_taken ? " takes the address of " : what) + text_of(name_of(use)) +
           (use.address_taken ? "" : " of other objects than its own") +
           (use.places.empty() ? "" : ", " + usage::text_of(use.places.front()));
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
