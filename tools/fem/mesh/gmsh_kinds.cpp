#include <fem/mesh/gmsh_kinds.h>

#include <algorithm>
#include <string>

namespace physgen::fem {

const GmshKind& gmsh_kind_of(const GmshInput& input, std::int64_t type, const char* place) {
  const auto* found = std::ranges::lower_bound(gmsh_kinds, type, {}, &GmshKind::type);
  if (found != gmsh_kinds.end() && found->type == type) return *found;
  input.refuse("has " + input.place(place) + " an element of type " + std::to_string(type) +
               ", which is not known here; mesh the volume with linear tetrahedra alone");
}

void refuse_other_solids(const GmshInput& input, const std::array<std::uint64_t, gmsh_kinds.size()>& found) {
  for (std::size_t k = 0; k < gmsh_kinds.size(); ++k) {
    const GmshKind& kind = gmsh_kinds.at(k);
    if (kind.dimension < 3 || kind.type == gmsh_tet || found.at(k) == 0) continue;
    const std::string name = kind.name;
    const std::string count = "has " + std::to_string(found.at(k)) + " elements of the kind '" + name + "'";
    if (!name.starts_with("Tet")) input.refuse(count + "; mesh the volume with tetrahedra alone");
    input.refuse(count + " of order " + std::to_string(kind.order) +
                 "; save linear tetrahedra (Gmsh: Mesh.ElementOrder = 1, or -order 1)");
  }
}

}  // namespace physgen::fem
