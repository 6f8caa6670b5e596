// The kinds of elements that Gmsh's format numbers: what a reader must know to pass over them.
#pragma once

#include <fem/mesh/gmsh_input.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace physgen::fem {

struct GmshKind {
  int type, dimension, order;
  std::size_t nodes;
  const char* name;  ///< as Gmsh has it; of elements with volume alone
};

inline constexpr int gmsh_tet = 4;

/// Up to order 5, by type.
inline constexpr std::array gmsh_kinds{
    GmshKind{1, 1, 1, 2, ""},
    GmshKind{2, 2, 1, 3, ""},
    GmshKind{3, 2, 1, 4, ""},
    GmshKind{gmsh_tet, 3, 1, 4, "Tetrahedron 4"},
    GmshKind{5, 3, 1, 8, "Hexahedron 8"},
    GmshKind{6, 3, 1, 6, "Prism 6"},
    GmshKind{7, 3, 1, 5, "Pyramid 5"},
    GmshKind{8, 1, 2, 3, ""},
    GmshKind{9, 2, 2, 6, ""},
    GmshKind{10, 2, 2, 9, ""},
    GmshKind{11, 3, 2, 10, "Tetrahedron 10"},
    GmshKind{12, 3, 2, 27, "Hexahedron 27"},
    GmshKind{13, 3, 2, 18, "Prism 18"},
    GmshKind{14, 3, 2, 14, "Pyramid 14"},
    GmshKind{15, 0, 0, 1, ""},
    GmshKind{16, 2, 2, 8, ""},
    GmshKind{17, 3, 2, 20, "Hexahedron 20"},
    GmshKind{18, 3, 2, 15, "Prism 15"},
    GmshKind{19, 3, 2, 13, "Pyramid 13"},
    GmshKind{20, 2, 3, 9, ""},
    GmshKind{21, 2, 3, 10, ""},
    GmshKind{22, 2, 4, 12, ""},
    GmshKind{23, 2, 4, 15, ""},
    GmshKind{24, 2, 5, 15, ""},
    GmshKind{25, 2, 5, 21, ""},
    GmshKind{26, 1, 3, 4, ""},
    GmshKind{27, 1, 4, 5, ""},
    GmshKind{28, 1, 5, 6, ""},
    GmshKind{29, 3, 3, 20, "Tetrahedron 20"},
    GmshKind{30, 3, 4, 35, "Tetrahedron 35"},
    GmshKind{31, 3, 5, 56, "Tetrahedron 56"},
    GmshKind{32, 3, 4, 22, "Tetrahedron 22"},
    GmshKind{33, 3, 5, 28, "Tetrahedron 28"},
    GmshKind{36, 2, 3, 16, ""},
    GmshKind{37, 2, 4, 25, ""},
    GmshKind{38, 2, 5, 36, ""},
    GmshKind{39, 2, 3, 12, ""},
    GmshKind{40, 2, 4, 16, ""},
    GmshKind{41, 2, 5, 20, ""},
    GmshKind{92, 3, 3, 64, "Hexahedron 64"},
    GmshKind{93, 3, 4, 125, "Hexahedron 125"},
};

/// @param place where the element stands in the file
/// @throw Error when no kind has this type
[[nodiscard]] const GmshKind& gmsh_kind_of(const GmshInput& input, std::int64_t type, const char* place);

/// @param found how many elements of each kind a file has
/// @throw Error when there are elements with volume other than linear tets, with their kind, number and a remedy
void refuse_other_solids(const GmshInput& input, const std::array<std::uint64_t, gmsh_kinds.size()>& found);

}  // namespace physgen::fem
