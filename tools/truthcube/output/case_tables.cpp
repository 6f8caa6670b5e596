// Numbers have 17 significant digits, which give the same numbers when read.
#include <files/disk.h>
#include <truthcube/output/case_tables.h>

#include <sstream>
#include <string>

namespace physgen::truthcube {

namespace {

void put(std::ostream& out, const fem::Point& x) { out << "," << x[0] << "," << x[1] << "," << x[2]; }

/// A name as a field of a table: in quotes where it has a comma or a quote.
std::string field(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == name.npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

}  // namespace

void write_case_tables(const std::filesystem::path& folder, std::span<const CaseState> steps) {
  std::ostringstream groups, probes;
  groups.precision(17);
  probes.precision(17);
  groups << "step,load,group,reaction_x,reaction_y,reaction_z,load_x,load_y,load_z,largest_displacement\n";
  probes << "step,load,probe,x,y,z,ux,uy,uz\n";
  for (std::size_t s = 0; s < steps.size(); ++s) {
    for (const GroupState& group : steps[s].groups) {
      groups << s + 1 << "," << steps[s].load << "," << field(group.group);
      put(groups, group.reaction);
      put(groups, group.load);
      groups << "," << group.largest_displacement << "\n";
    }
    for (const ProbeState& probe : steps[s].probes) {
      probes << s + 1 << "," << steps[s].load << "," << field(probe.probe);
      put(probes, probe.at);
      put(probes, probe.displacement);
      probes << "\n";
    }
  }
  disk::write_text(folder / "groups.csv", groups.str());
  if (!steps.empty() && !steps.front().probes.empty()) disk::write_text(folder / "probes.csv", probes.str());
}

}  // namespace physgen::truthcube
