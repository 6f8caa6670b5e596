#!/usr/bin/python3
"""Writes the mesh of a soft lobe in Gmsh's format, with groups: lobe.py CELLS FILE.msh

CELLS^3 cells of six tets fill a lobe, 60 mm wide at its base and 50 mm high, in millimetres. Groups: the flat side "base", the rest of
the surface "skin", of it what lies above 45 mm as "tip", and all tets, "lobe"."""
import math
import sys

# Corners of a cell by bits (1: along x, 2: y, 4: z) along the paths of the six tets around its diagonal.
PATHS = ((0, 1, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 3, 2, 7), (0, 5, 1, 7), (0, 6, 4, 7))
OUTWARD = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


def place(x, y, z):
    """Where a point of the box [-1, 1]^2 x [0, 1] lies in the lobe [mm]: squares are rounded and narrow upwards."""
    radius = 30 * math.sqrt(1 - 0.9 * z * z)
    return radius * x * math.sqrt(1 - 0.3 * y * y), radius * y * math.sqrt(1 - 0.3 * x * x), 50 * z


def main(cells, file):
    side = range(cells + 1)
    nodes = [place(2 * x / cells - 1, 2 * y / cells - 1, z / cells) for z in side for y in side for x in side]
    tets = [
        [x + (k & 1) + (cells + 1) * (y + (k >> 1 & 1) + (cells + 1) * (z + (k >> 2))) for k in path]
        for z in range(cells) for y in range(cells) for x in range(cells) for path in PATHS
    ]
    faces = {}
    for tet in tets:
        for corners in OUTWARD:
            face = [tet[c] for c in corners]
            key = tuple(sorted(face))
            faces[key] = None if key in faces else face
    rows = [(4, 4, tet) for tet in tets]
    for face in filter(None, faces.values()):
        heights = [nodes[n][2] for n in face]
        rows += [(2, 1 if max(heights) == 0 else 2, face)]
        rows += [(2, 3, face)] * (min(heights) >= 45)
    with open(file, "w", encoding="ascii") as out:
        out.write('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n2 1 "base"\n2 2 "skin"\n2 3 "tip"\n3 4 "lobe"\n')
        out.write(f"$EndPhysicalNames\n$Nodes\n{len(nodes)}\n")
        for number, x in enumerate(nodes, 1):
            out.write(f"{number} {x[0]:.17g} {x[1]:.17g} {x[2]:.17g}\n")
        out.write(f"$EndNodes\n$Elements\n{len(rows)}\n")
        for number, (kind, group, element) in enumerate(rows, 1):
            out.write(f"{number} {kind} 2 {group} 1 {' '.join(str(n + 1) for n in element)}\n")
        out.write("$EndElements\n")


if len(sys.argv) != 3:
    sys.exit(__doc__)
main(int(sys.argv[1]), sys.argv[2])
