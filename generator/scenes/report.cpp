// See report.h.
#include "scenes/report.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "scenes/report_groups.h"
#include "scenes/report_halos.h"

namespace physgen::scenes {
namespace {

using Json = nlohmann::ordered_json;

constexpr int report_format = 3;  // counts up when an old reader would misread a new file; the first had no number

/// Bytes and elements of one object of each array of a set, together.
struct Sum {
  std::string set;  ///< "per tet"; "1 object"
  int kept_bytes = 0, all_bytes = 0;
  int kept_elements = 0, all_elements = 0;
};

template <class Visit>
void for_each_array(const Scene& scene, const Needs& needs, const Visit& visit) {
  for (const Group& group : scene.groups)
    for (const Array& array : group.arrays) visit(group, array, needs.of(group.full_name(array)));
}

std::vector<Sum> sums(const Scene& scene, const Needs& needs) {
  std::vector<Sum> sums;
  for_each_array(scene, needs, [&](const Group& /*group*/, const Array& array, const ArrayNeed& need) {
    const std::string set = array.uniform ? "once" : set_of(array);
    auto sum = std::find_if(sums.begin(), sums.end(), [&](const Sum& known) { return known.set == set; });
    if (sum == sums.end()) sum = sums.insert(sums.end(), Sum{set});
    for (const FieldNeed& field : need.fields) {
      sum->all_bytes += field.field.bytes;
      sum->all_elements += field.field.elements;
      if (!field.kept || need.local()) continue;
      sum->kept_bytes += field.field.bytes;
      sum->kept_elements += field.field.elements;
    }
  });
  return sums;
}

/// "physgen::Fused<physgen::fem::ComputeSvd>" gives "Fused<ComputeSvd>".
std::string without_namespaces(const std::string& name) {
  std::string result;
  std::size_t word = 0;  // where the last name begins in it
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name.compare(i, 2, "::") == 0) {
      result.resize(word);
      ++i;
      continue;
    }
    result += name[i];
    if (std::isalnum(static_cast<unsigned char>(name[i])) == 0 && name[i] != '_') word = result.size();
  }
  return result;
}

/// "ComputeSvd, ComputeStress and 2 more": the kernels of steps, without namespaces and arrays, each once; all of them
/// stand in report_json() and report_why().
std::string kernels(const std::vector<StepOfField>& uses) {
  std::vector<std::string> names;
  for (const StepOfField& use : uses) {
    const std::string name = without_namespaces(use.step.substr(0, use.step.find('(')));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  constexpr std::size_t most = 3;
  if (names.size() <= most) return names.empty() ? "-" : model::joined(names);
  const std::string more = " and " + std::to_string(names.size() - most) + " more";
  names.resize(most);
  return model::joined(names) + more;
}

std::string columns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Json write(const std::vector<StepOfField>& uses) {
  Json json = Json::array();
  for (const StepOfField& use : uses) {
    Json places = Json::array();
    for (const auto& place : use.places)
      places.push_back(place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column));
    json.push_back({{"step", use.step}, {"places", std::move(places)}});
  }
  return json;
}

std::string lines(const char* what, const std::vector<StepOfField>& uses) {
  std::string text;
  for (const StepOfField& use : uses) {
    text += std::string("  ") + what + " by " + use.step + "\n";
    for (const auto& place : use.places)
      text += "    at " + place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + "\n";
  }
  return text;
}

bool contains(const std::vector<StepOfField>& uses, const StepOfField& use) {
  return std::ranges::find(uses, use) != uses.end();
}

/// Who writes the field, and who reads it; a step that does both at the same places is named once.
std::string lines(const FieldNeed& field) {
  std::vector<StepOfField> writers, both, readers;
  for (const StepOfField& use : field.writers) (contains(field.readers, use) ? both : writers).push_back(use);
  for (const StepOfField& use : field.readers)
    if (!contains(field.writers, use)) readers.push_back(use);
  return lines("written", writers) + lines("read and written", both) + lines("read", readers);
}

/// The records that pruning changes, or fails to change: an array with some fields that is stored without others.
std::string records_text(const Scene& scene, const Needs& needs) {
  std::vector<std::vector<std::string>> rows = {{"  array", "layout", "bytes", "with all fields", ""}};
  for_each_array(scene, needs, [&](const Group& group, const Array& array, const ArrayNeed& need) {
    if (need.left_out() || need.local() || std::ranges::all_of(need.fields, &FieldNeed::kept)) return;
    const bool is_same = std::ranges::all_of(need.records, [&](const Record& record) {
      const Record& first = need.records.front();
      return record.layout == first.layout && record.bytes == first.bytes && record.all_bytes == first.all_bytes;
    });
    for (const Record& record : need.records) {
      rows.push_back({"  " + group.full_name(array), record.layout + (is_same ? "" : " (" + record.space + ")"),
                      std::to_string(record.bytes), std::to_string(record.all_bytes),
                      record.bytes == record.all_bytes ? "padding takes what pruning saves" : ""});
      if (is_same) break;
    }
  });
  return rows.size() == 1
             ? std::string()
             : "\nBytes that records take without the fields that are pruned, padding included:\n" + columns(rows);
}

/// "force.h:7:3: field v of ..."
std::string too_early_text(const Needs& needs) {
  std::string text;
  for (const ReadTooEarly& read : needs.read_too_early)
    text += "  " + (read.place == usage::Place() ? "" : usage::text_of(read.place) + ": ") + text_of(read) + "\n";
  return text.empty() ? text : "\nRead before written:\n" + text;
}

/// "is kept: written by ..."
std::string fate_and_why(const Needs& needs, const ArrayNeed& need, const FieldNeed& field) {
  if (!field.kept || !need.local()) return (field.kept ? "is kept: " : "is not kept: ") + field.why;
  const StepGroup& group = needs.groups[static_cast<std::size_t>(need.group)];
  return "is local: " + model::joined(group.steps, " and ") + " are one step, and nothing else uses it; " + field.why;
}

/// The names that a question may give a field or an array.
std::vector<std::string> names_of(const Group& group, const Array& array) {
  const std::size_t scope = array.object.rfind("::");
  std::vector<std::string> names = {group.full_name(array), array.name, array.object};
  if (scope != std::string::npos) names.push_back(array.object.substr(scope + 2));
  return names;
}

}  // namespace

std::string fate(const Array& array, const ArrayNeed& need, const FieldNeed& field) {
  if (need.left_out()) return "left out";
  if (!field.kept) return "pruned";
  if (need.local()) return "local";
  return array.uniform ? "uniform" : "kept";
}

std::string report_text(const Scene& scene, const Needs& needs) {
  std::string text = "Scene " + scene.name + ": what its program needs\n";
  if (!scene.doc.empty()) text += scene.doc + "\n";
  text += "\n";
  std::vector<std::vector<std::string>> rows = {{"array", "field", "bytes", "", "written by", "read by"}};
  for_each_array(scene, needs, [&](const Group& group, const Array& array, const ArrayNeed& need) {
    for (const FieldNeed& field : need.fields) {
      std::string written = kernels(field.writers), read = kernels(field.readers);
      if (array.is_input(field.field.name)) written = written == "-" ? "(input)" : "(input), " + written;
      if (array.is_output(field.field.name)) read = read == "-" ? "(output)" : read + ", (output)";
      rows.push_back({&field == &need.fields.front() ? group.full_name(array) : "", field.field.name,
                      std::to_string(field.field.bytes), fate(array, need, field), written, read});
    }
  });
  text += columns(rows) + "\n";
  for (const Sum& sum : sums(scene, needs))
    text += sum.set + ": " + std::to_string(sum.kept_bytes) + " of " + std::to_string(sum.all_bytes) + " bytes, " +
            std::to_string(sum.kept_elements) + " of " + std::to_string(sum.all_elements) + " numbers\n";
  text += records_text(scene, needs) + too_early_text(needs) + groups_text(scene, needs) + halos_text(needs.halos) +
          "\nWhy:\n";
  for_each_array(scene, needs, [&](const Group& group, const Array& array, const ArrayNeed& need) {
    for (const FieldNeed& field : need.fields)
      text += "  " + group.full_name(array) + "." + field.field.name + " " + fate_and_why(needs, need, field) + "\n";
  });
  return text;
}

std::string report_json(const Scene& scene, const Needs& needs) {
  Json json = {{"format", report_format}, {"scene", scene.qualified_name()}};
  json["arrays"] = Json::array();
  for_each_array(scene, needs, [&](const Group& group, const Array& array, const ArrayNeed& need) {
    Json written = {{"array", group.full_name(array)},
                    {"object", array.object},
                    {"real", array.real},
                    {"of", set_of(array)},
                    {"read_only", need.read_only}};
    written["fields"] = Json::array();
    for (const FieldNeed& field : need.fields)
      written["fields"].push_back({{"field", field.field.name},
                                   {"type", field.field.type},
                                   {"elements", field.field.elements},
                                   {"bytes", field.field.bytes},
                                   {"fate", fate(array, need, field)},
                                   {"input", array.is_input(field.field.name)},
                                   {"output", array.is_output(field.field.name)},
                                   {"why", field.why},
                                   {"written_by", write(field.writers)},
                                   {"read_by", write(field.readers)}});
    written["records"] = Json::array();
    for (const Record& record : need.records)
      written["records"].push_back({{"space", record.space},
                                    {"layout", record.layout},
                                    {"bytes", need.local() ? 0 : record.bytes},
                                    {"all_bytes", record.all_bytes}});
    json["arrays"].push_back(std::move(written));
  });
  json["sums"] = Json::array();
  for (const Sum& sum : sums(scene, needs))
    json["sums"].push_back({{"of", sum.set},
                            {"kept_bytes", sum.kept_bytes},
                            {"all_bytes", sum.all_bytes},
                            {"kept_elements", sum.kept_elements},
                            {"all_elements", sum.all_elements}});
  json["read_too_early"] = Json::array();
  for (const ReadTooEarly& read : needs.read_too_early)
    json["read_too_early"].push_back({{"array", read.array},
                                      {"fields", read.fields},
                                      {"step", read.step},
                                      {"place", read.place == usage::Place() ? "" : usage::text_of(read.place)},
                                      {"note", text_of(read)}});
  add_groups(needs, json);
  add_halos(needs.halos, json);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_why(const Scene& scene, const Needs& needs, const std::string& name) {
  std::string text;
  std::vector<std::string> names;
  for_each_array(scene, needs, [&](const Group& group, const Array& array, const ArrayNeed& need) {
    const auto called = names_of(group, array);
    names.insert(names.end(), called.begin(), called.end());
    for (const FieldNeed& field : need.fields)
      for (const std::string& word : called) {
        names.push_back(word + "." + field.field.name);
        if (name != word && name != names.back()) continue;
        text += group.full_name(array) + "." + field.field.name + " of " + array.object + " " +
                fate_and_why(needs, need, field) + "\n" + lines(field) +
                why_text(needs.halos, group.full_name(array), field.field.name);
        break;
      }
  });
  if (text.empty()) throw UnknownName("in the scene " + scene.name + " " + unknown("array or field", name, names));
  return text;
}

std::string text_of(const Issue& issue) {
  std::string place;
  if (!issue.place.file.empty())
    place = issue.place.file + ":" + std::to_string(issue.place.line) + ":" + std::to_string(issue.place.column) + ": ";
  return place + (issue.kind == Issue::Kind::error ? "error: " : "note: ") + issue.message + "\n";
}

}  // namespace physgen::scenes
