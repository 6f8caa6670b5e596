// See compare.h. Programs become lists of facts, "which thing: which property" with its text, so that whatever a file
// says is compared, and added or missing steps are named by what they are.
#include "usage/compare.h"

#include <map>

namespace physgen::usage {
namespace {

using Facts = std::map<std::string, std::string>;

std::string text_of(const std::vector<Place>& places) {
  std::string result;
  for (const Place& place : places) result += (result.empty() ? "" : ", ") + usage::text_of(place);
  return result.empty() ? "nowhere" : result;
}

const char* text_of(bool value) { return value ? "yes" : "no"; }

void add(Facts& facts, const std::string& where, const std::vector<FieldUse>& uses) {
  for (const FieldUse& use : uses) {
    const std::string field = where + ": " + use.array + "." + use.field;
    facts[field + ": read"] = text_of(use.read);
    facts[field + ": written"] = text_of(use.written);
    facts[field + ": address taken"] = text_of(use.address_taken);
    facts[field + ": of the step's own objects"] = text_of(use.own);
    facts[field + ": of other objects"] = text_of(use.gathered);
    facts[field + ": added to other objects"] = text_of(use.added);
    facts[field + ": with all fields at once"] = text_of(use.whole_object);
    facts[field + ": places"] = text_of(use.places);
    facts[field + ": places of all fields at once"] = text_of(use.whole_places);
  }
}

Facts facts_of(const std::vector<Program>& programs) {
  Facts facts;
  for (const Program& program : programs) {
    facts[program.name] = "there";
    for (const StepUse& step : program.usage.steps) {
      std::string name = program.name + ": " + name_of(step);
      for (int same = 2; facts.count(name) != 0; ++same)
        name = program.name + ": " + name_of(step) + ", number " + std::to_string(same);
      facts[name] = "there";
      facts[name + ": defined"] = usage::text_of(step.place);
      facts[name + ": always wanted"] = text_of(step.root);
      add(facts, name, step.fields);
    }
    add(facts, program.name + ": outside of all steps", program.usage.unattributed);
    for (const UnknownUse& use : program.usage.unknown)
      facts[program.name + ": " + use.array + ": " + use.what + " at " + usage::text_of(use.place)] = "there";
  }
  return facts;
}

}  // namespace

std::vector<std::string> differences(const std::vector<Program>& checked_in, const std::vector<Program>& found) {
  const Facts before = facts_of(checked_in), now = facts_of(found);
  std::vector<std::string> result;
  for (const auto& [fact, value] : now) {
    const auto old = before.find(fact);
    if (old == before.end())
      result.push_back(fact + ": " + value + "; not in the file");
    else if (old->second != value)
      result.push_back(fact + ": " + value + "; in the file: " + old->second);
  }
  for (const auto& [fact, value] : before)
    if (now.find(fact) == now.end()) result.push_back(fact + ": not found; in the file: " + value);
  return result;
}

}  // namespace physgen::usage
