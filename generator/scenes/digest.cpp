// See digest.h.
#include "scenes/digest.h"

#include <algorithm>
#include <map>
#include <set>

#include "scenes/report.h"

namespace physgen::scenes {
namespace {

constexpr int digest_format = 1;  // counts up when an old reader would misread a new file

/// "aosoa 84 of 84 bytes", of each space where they differ.
std::string records(const ArrayNeed& need) {
  const auto text = [&](const Record& record) {
    return record.layout + " " + std::to_string(need.local() ? 0 : record.bytes) + " of " +
           std::to_string(record.all_bytes) + " bytes";
  };
  std::vector<std::string> texts;
  bool is_same = true;
  for (const Record& record : need.records) {
    is_same = is_same && text(record) == text(need.records.front());
    texts.push_back(record.space + " " + text(record));
  }
  if (texts.empty()) return "";
  return "; " + (is_same ? text(need.records.front()) : model::joined(texts));
}

std::string lines(const Group& group, const Array& array, const ArrayNeed& need) {
  std::string text = "array " + group.full_name(array) + " of " + array.object + "<" + array.real + "> " +
                     (array.uniform ? "once" : set_of(array)) + records(need) + (need.read_only ? "; read only" : "") +
                     "\n";
  for (const FieldNeed& field : need.fields) {
    std::string fate_of_it = fate(array, need, field);
    std::replace(fate_of_it.begin(), fate_of_it.end(), ' ', '_');
    text += "  field " + field.field.name + " " + field.field.type + " " + std::to_string(field.field.elements) + " " +
            fate_of_it;
    if (array.is_input(field.field.name)) text += " input";
    if (!field.readers.empty()) text += " read";
    if (!field.writers.empty()) text += " written";
    text += array.is_output(field.field.name) ? " output\n" : "\n";
  }
  return text;
}

/// How a step uses a field: "read own".
std::string way_of(const usage::FieldUse& use) {
  std::string way;
  const auto add = [&](bool is_so, const char* word) {
    if (is_so) way += (way.empty() ? "" : " ") + std::string(word);
  };
  add(use.read, "read");
  add(use.written, "written");
  add(use.own, "own");
  add(use.gathered, "gathered");
  add(use.added, "added");
  add(use.whole_object, "whole");
  add(use.address_taken, "by_address");
  return way;
}

std::string lines(const std::string& head, const std::vector<usage::FieldUse>& uses) {
  std::map<std::string, std::set<std::string>> ways;
  for (const usage::FieldUse& use : uses) ways[way_of(use)].insert(" " + use.array + "." + use.field);
  std::string text = head + "\n";
  for (const auto& [way, fields] : ways) {
    text += "  " + way + ":";
    for (const std::string& field : fields) text += field;
    text += "\n";
  }
  return text;
}

/// Steps of a kernel on the same arrays, which places alone tell apart, are one.
std::string steps(const usage::Usage& usage) {
  std::map<std::string, std::vector<usage::FieldUse>> uses;
  for (const usage::StepUse& step : usage.steps) {
    auto& of_step =
        uses["step " + step.kernel + "(" + model::joined(step.arrays) + ")" + (step.root ? "; wanted" : "")];
    for (const usage::FieldUse& use : step.fields) usage::add(of_step, use);
  }
  std::string text;
  for (const auto& [head, fields] : uses) text += lines(head, fields);
  return usage.unattributed.empty() ? text : text + lines("outside of steps", usage.unattributed);
}

}  // namespace

std::string digest(const Scene& scene, const Needs& needs, const usage::Usage& usage) {
  std::string text = "# What the scene " + scene.qualified_name() + " needs, without places. Written by physgen from " +
                     scene.include + ": change that, not this file.\nformat " + std::to_string(digest_format) + "\n";
  for (const Group& group : scene.groups)
    for (const Array& array : group.arrays) text += lines(group, array, needs.of(group.full_name(array)));
  text += steps(usage);
  for (const ReadTooEarly& read : needs.read_too_early) {
    std::vector<std::string> fields;
    for (const std::string& field : read.fields) fields.push_back(read.array + "." + field);
    text += "read before written: " + model::joined(fields) + " by " + read.step + "\n";
  }
  for (const StepGroup& group : needs.groups)
    text += "joined: " + model::joined(group.steps) + "; local " + model::joined(group.locals) + "\n";
  return text;
}

}  // namespace physgen::scenes
