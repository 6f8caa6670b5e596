#!/usr/bin/python3
"""Converts a mesh of linear tets with its groups to Gmsh's format: convert.py BODY.inp|BODY.vtu|... BODY.msh

Of Abaqus's and CalculiX's .inp node sets, element sets and surfaces become groups of their names, and nodes and elements keep their
numbers. All else is read by meshio (Debian: python3-meshio): each value of an array of whole numbers becomes a group ARRAY_VALUE."""
import os
import pathlib
import sys

# Sides of a C3D4 as Abaqus numbers them, S1 to S4, in the order in which it lists their corners.
SIDES = {"S1": (0, 1, 2), "S2": (0, 3, 1), "S3": (1, 3, 2), "S4": (2, 3, 0)}
CORNERS = {"C3D4": 4, "C3D4H": 4, "C3D4T": 4, "T3D2": 2, "B31": 2} | dict.fromkeys(
    ("S3", "S3R", "S3RS", "STRI3", "M3D3", "SFM3D3", "R3D3", "CPS3", "CPE3", "CAX3"), 3)
UNREAD = ("INCLUDE", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM")
GMSH_TYPE = {1: 15, 2: 1, 3: 2, 4: 4}  # of points, lines, triangles, tets by their corners
MOST_VALUES = 100  # of an array that makes groups; one of more values numbers things


class Refused(Exception):
    """What is wrong with a file, and what to do."""


def abaqus_blocks(path):
    """Yields (line number, KEYWORD, parameters, rows of words) of each keyword."""
    start, keyword, parameters, rows, open_row = 0, "", {}, [], False
    with open(path, encoding="latin-1") as file:
        for number, line in enumerate(file, 1):
            words = [word.strip() for word in line.strip().split(",")]
            if line.startswith("**") or words == [""]:
                continue
            if line.startswith("*"):
                if keyword:
                    yield start, keyword, parameters, rows
                start, keyword, rows, open_row = number, " ".join(words[0][1:].upper().split()), [], False
                pairs = [word.partition("=") for word in words[1:] if word]
                parameters = {key.strip().upper(): value.strip().strip('"') for key, _, value in pairs}
                continue
            full = [word for word in words if word]
            rows[-1:] = [rows[-1] + full] if open_row else rows[-1:] + [full]
            open_row = words[-1] == "" and keyword == "ELEMENT"  # such a line goes on
    if keyword:
        yield start, keyword, parameters, rows


class AbaqusMesh:
    """Nodes by number, elements as lists of corners by number, and groups as lists of (element or 0, corners)."""

    def __init__(self, path):
        self.path, self.where = path, path
        self.nodes, self.elements, self.names, self.groups = {}, {}, {}, {}
        self.sets = {"NSET": {}, "ELSET": {}}  # numbers by name in capitals
        self.kinds = {}  # of what a group consists: the keywords that name it
        for line, keyword, parameters, rows in abaqus_blocks(path):
            self.where = f"{path}: line {line}: *{keyword}"
            try:
                self.read(keyword, parameters, rows)
            except (KeyError, ValueError, IndexError) as error:
                raise Refused(f"{self.where}: {error} is missing or is no number; the file may be damaged") from error
        self.where = path
        for element, corners in self.elements.items():
            self.require(corners, self.nodes, f"element {element} names node")
        for name, kinds in self.kinds.items():
            if len(kinds) > 1:
                print(f"note: {' and '.join(sorted(kinds))} {self.names[name]} become one group", file=sys.stderr)

    def read(self, keyword, parameters, rows):
        if keyword in UNREAD or (keyword == "INSTANCE" and rows):
            raise Refused(f"{self.where} is not read; write the mesh flat, without parts, includes and generated nodes")
        if keyword == "NODE":
            self.add(self.nodes, {int(row[0]): [float(x) for x in (row[1:4] + ["0"] * 3)[:3]] for row in rows})
            self.add_set("NSET", parameters, [int(row[0]) for row in rows])
        elif keyword == "ELEMENT":
            kind = parameters["TYPE"].upper()
            if kind not in CORNERS:
                raise Refused(f"{self.where}: there are {len(rows)} elements of type {kind}, and only linear tets (C3D4), with "
                              "triangles and lines, are read; mesh the body with C3D4 alone")
            if any(len(row) != CORNERS[kind] + 1 for row in rows):
                raise Refused(f"{self.where}: an element of type {kind} has a number and {CORNERS[kind]} nodes, this has others")
            self.add(self.elements, {int(row[0]): [int(n) for n in row[1:]] for row in rows})
            self.add_set("ELSET", parameters, [int(row[0]) for row in rows])
        elif keyword in self.sets:
            self.add_set(keyword, parameters, self.members(keyword, rows, "GENERATE" in parameters))
        elif keyword == "SURFACE":
            self.add_surface(parameters, rows)

    def add(self, known, new):
        if twice := known.keys() & new.keys():
            raise Refused(f"{self.where}: {min(twice)} stands twice; write the mesh flat, without parts")
        known.update(new)

    def require(self, numbers, known, what):
        if lost := [n for n in numbers if n not in known]:
            raise Refused(f"{self.where}: {what} {lost[0]}, which the file does not have; write the mesh again")

    def group(self, kind, name, rows):
        self.names.setdefault(name.upper(), name)
        self.kinds.setdefault(name.upper(), set()).add(kind)
        self.groups.setdefault(self.names[name.upper()], []).extend(rows)

    def add_set(self, kind, parameters, numbers):
        if kind not in parameters:  # of nodes and elements without one
            return
        name = parameters[kind]
        self.require(numbers, self.nodes if kind == "NSET" else self.elements, f"the set {name} names")
        self.sets[kind].setdefault(name.upper(), []).extend(numbers)
        self.group(kind, name, [(0, [n]) if kind == "NSET" else (n, self.elements[n]) for n in numbers])

    def add_surface(self, parameters, rows):
        name = parameters["NAME"]
        if parameters.get("TYPE", "ELEMENT").upper() == "NODE":
            numbers = self.members("NSET", [row[:1] for row in rows], False)
            self.group("SURFACE", name, [(0, [n]) for n in numbers])
            return
        for row in rows:
            side = row[1].upper() if len(row) > 1 else ""
            numbers = self.members("ELSET", [row[:1]], False)
            self.require(numbers, self.elements, f"the surface {name} names")
            for corners in (self.elements[n] for n in numbers):
                if len(corners) == 4 and side not in SIDES:
                    raise Refused(f"{self.where}: '{', '.join(row)}' names no side of a tet; write S1, S2, S3 or S4")
                self.group("SURFACE", name, [(0, [corners[c] for c in SIDES[side]] if len(corners) == 4 else corners)])

    def members(self, kind, rows, generate):
        """The numbers that the lines of a set name."""
        if generate:
            ranges = [[int(word) for word in row] for row in rows]
            return [n for row in ranges for n in range(row[0], row[1] + 1, row[2] if len(row) > 2 else 1)]
        found = []
        for word in (word for row in rows for word in row):
            if word.isdigit():
                found.append(int(word))
            elif word.strip('"').upper() in self.sets[kind]:
                found += self.sets[kind][word.strip('"').upper()]
            else:
                raise Refused(f"{self.where}: there is no {kind} '{word}' above this line; define it before it is used")
        return found


def read_abaqus(path):
    mesh = AbaqusMesh(path)
    return mesh.nodes, mesh.elements, mesh.groups


def read_other(path):
    """Nodes, elements and groups as AbaqusMesh has them, by meshio; numbers are from 1 on."""
    try:
        import meshio  # pylint: disable=import-outside-toplevel
        import numpy  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise Refused(f"{path}: meshio reads this format, and is not here ({error}); install python3-meshio") from error
    try:
        mesh = meshio.read(path)
    except (Exception, SystemExit) as error:  # pylint: disable=broad-except
        raise Refused(f"{path}: meshio does not read it: {error}; save it as .vtu, .inp or .msh") from error
    kinds = {"vertex": 1, "line": 2, "triangle": 3, "tetra": 4}
    others = [f"{len(block.data)} {block.type}" for block in mesh.cells if block.type not in kinds]
    if others:
        raise Refused(f"{path}: only linear tets, with triangles, lines and points, are read, and there are "
                      + ", ".join(others) + "; mesh the body with linear tets alone")
    nodes = {n: [float(x) for x in (*point, 0, 0)[:3]] for n, point in enumerate(mesh.points, 1)}
    cells = [[(0, [int(n) + 1 for n in cell]) for cell in block.data] for block in mesh.cells]
    elements, groups = {}, {}
    for rows in cells:
        for at, (_, corners) in enumerate(rows):
            rows[at] = (len(elements) + 1, corners)
            elements[len(elements) + 1] = corners
    rows_of_points = [(0, [n]) for n in nodes]

    def add_values(name, rows, values, skipped):
        values = numpy.asarray(values)
        if values.ndim != 1 or values.dtype.kind not in "iub":
            return
        if len(numpy.unique(values)) > MOST_VALUES:
            print(f"note: {name} has more than {MOST_VALUES} values and makes no groups", file=sys.stderr)
            return
        for row, value in zip(rows, values.tolist()):
            if value != skipped:
                groups.setdefault(f"{name}_{int(value)}", []).append(row)

    for name, blocks in mesh.cell_data.items():
        for rows, values in zip(cells, blocks):
            add_values(name, rows, values, None)
    for name, values in mesh.point_data.items():
        add_values(name, rows_of_points, values, 0)
    for name, blocks in mesh.cell_sets.items():
        groups.setdefault(name, []).extend(rows[at] for rows, found in zip(cells, blocks) for at in found)
    for name, found in mesh.point_sets.items():
        groups.setdefault(name, []).extend(rows_of_points[at] for at in found)
    return nodes, elements, groups


def write_gmsh(path, nodes, elements, groups):
    """Version 2.2 as text. An element of several groups stands there once for each, under one number."""
    rows, names, used = [], [], set()
    free = max(elements, default=0)
    for number, (name, members_of) in enumerate(groups.items(), 1):
        for element, corners in members_of:
            used.add(element)
            free += element == 0
            rows.append((element or free, GMSH_TYPE[len(corners)], number, corners))
        names += [(d, number, name) for d in sorted({len(corners) - 1 for _, corners in members_of})]
    rows += [(element, GMSH_TYPE[len(corners)], 0, corners) for element, corners in elements.items() if element not in used]
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(names)}\n")
        for dimension, number, name in names:
            out.write(f'{dimension} {number} "{name}"\n')
        out.write(f"$EndPhysicalNames\n$Nodes\n{len(nodes)}\n")
        for number, x in nodes.items():
            out.write(f"{number} {x[0]:.17g} {x[1]:.17g} {x[2]:.17g}\n")
        out.write(f"$EndNodes\n$Elements\n{len(rows)}\n")
        for number, kind, group, corners in rows:
            out.write(f"{number} {kind} 2 {group} {group} {' '.join(map(str, corners))}\n")
        out.write("$EndElements\n")


def main(source, target):
    if pathlib.Path(target).suffix != ".msh":
        raise Refused(f"{target}: the file that is written is in Gmsh's format; give it the ending .msh")
    if not os.path.isfile(source):
        raise Refused(f"{source}: cannot be read; check its name and your rights")
    nodes, elements, groups = (read_abaqus if source.lower().endswith(".inp") else read_other)(source)
    tets = sum(len(corners) == 4 for corners in elements.values())
    if tets == 0:
        raise Refused(f"{source}: has no linear tets; mesh the volume")
    groups = {name.replace('"', "'"): rows for name, rows in groups.items() if rows}
    write_gmsh(target + ".part", nodes, elements, groups)
    os.replace(target + ".part", target)
    print(f"{target}: {len(nodes)} nodes, {tets} tets; groups: {', '.join(groups) or 'none'}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        main(sys.argv[1], sys.argv[2])
    except Refused as refused:
        sys.exit(str(refused))
