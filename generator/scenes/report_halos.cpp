// See report_halos.h.
#include "scenes/report_halos.h"

#include <nlohmann/json.hpp>
#include <set>

namespace physgen::scenes {
namespace {

std::string by(const HaloRead& read) {
  return read.through.empty() ? " by numbers that it forms" : " through " + model::joined(read.through);
}
std::string fate(const HaloRead& read) {
  return read.local.empty() ? "exchanged if stale" : "none (" + read.local + ")";
}

}  // namespace

std::string halos_text(const Halos& halos) {
  if (!halos.stated) return {};
  std::string text = "\nHalos:\n";
  std::set<std::string> said;  // steps of a kernel over other arrays may read the same
  for (const HaloRead& read : halos.reads) {
    const std::string line =
        "  " + read.kernel + ": " + read.array + "." + read.field + " gathered" + by(read) + ": " + fate(read) + "\n";
    if (said.insert(line).second) text += line;
  }
  if (halos.reads.empty()) text += "  no step reads other objects than its own\n";
  for (const UnknownHalo& one : halos.unknown)
    text += "  " + one.step + ": not known of " + listed(one.fields) +
            ", which counts as read of others: " + one.reason + "\n";
  if (!halos.no_arrays.empty()) text += "  no header of arrays for several ranks: " + halos.no_arrays + "\n";
  return text;
}

std::string why_text(const Halos& halos, const std::string& array, const std::string& field) {
  std::string text;
  for (const HaloRead& read : halos.reads)
    if (read.array == array && read.field == field)
      text += (read.local.empty() ? "  crosses, if stale, before " : "  does not cross before ") + read.step +
              ", which reads it" + by(read) + (read.local.empty() ? "" : ": " + read.local) + "\n";
  if (halos.stated && text.empty()) text = "  crosses before no step: none reads it of other objects\n";
  return text;
}

void add_halos(const Halos& halos, nlohmann::ordered_json& json) {
  if (!halos.stated) return;
  using Json = nlohmann::ordered_json;
  Json written = {{"table", Json::array()}, {"reads", Json::array()}, {"unknown", Json::array()}};
  for (const HaloRow& row : halos.table)
    written["table"].push_back({{"kernel", row.kernel},
                                {"view", row.view},
                                {"field", row.field},
                                {"reads_own", row.reads_own},
                                {"reads_others", row.reads_others},
                                {"writes_own", row.writes_own},
                                {"writes_others", row.writes_others},
                                {"through", row.through}});
  for (const HaloRead& read : halos.reads)
    written["reads"].push_back({{"step", read.step},
                                {"array", read.array},
                                {"field", read.field},
                                {"through", read.through},
                                {"exchanged", read.local.empty()},
                                {"why", read.local}});
  for (const UnknownHalo& one : halos.unknown)
    written["unknown"].push_back({{"step", one.step}, {"fields", one.fields}, {"reason", one.reason}});
  if (!halos.no_arrays.empty()) written["no_arrays"] = halos.no_arrays;
  json["halos"] = std::move(written);
}

}  // namespace physgen::scenes
