#include <fem/mesh/gmsh_format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace physgen::fem {

double read_gmsh_format(GmshInput& input) {
  const std::string_view line = input.line();
  std::array<double, 3> words{};
  const char *at = line.data(), *end = at + line.size();
  for (double& word : words) {
    while (at < end && *at == ' ') ++at;
    at = std::from_chars(at, end, word).ptr;
  }
  input.is_binary = words[1] != 0;
  if (!(words[0] >= 2 && words[0] <= 2.2) && words[0] != 4.1) {
    const std::string version(line.substr(0, std::min(line.find(' '), std::size_t{20})));
    input.refuse("is in version " + version +
                 " of Gmsh's format; save it in version 4.1 (gmsh FILE -save -format msh41 -o FILE.msh)");
  }
  if (!input.is_binary) return words[0];
  const char* place = input.here();
  const std::int64_t one = input.integer();
  if (one == 0x01000000) {
    input.refuse(
        "has numbers of another order of bytes; save it on a machine like this one, or as text (Gmsh: Mesh.Binary = "
        "0)");
  }
  if (one != 1 || words[2] != 8) input.refuse_at(place, "this is no binary file with numbers of 8 bytes");
  return words[0];
}

}  // namespace physgen::fem
