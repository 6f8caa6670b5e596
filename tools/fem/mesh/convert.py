#!/usr/bin/python3
"""Converts a mesh of linear tets with its groups to Gmsh's format: convert.py BODY.inp|BODY.vtu|... BODY.msh

Of Abaqus's and CalculiX's .inp node sets, element sets and surfaces become groups of their names, and nodes and elements keep their
numbers. All else is read by meshio (Debian: python3-meshio): each value of an array of whole numbers becomes a group ARRAY_VALUE, and
groups of Salome's .med keep their names."""
import itertools
import os
import pathlib
import sys

# Sides of a C3D4 as Abaqus numbers them, S1 to S4, in the order in which it lists their corners.
SIDES = {"S1": (0, 1, 2), "S2": (0, 3, 1), "S3": (1, 3, 2), "S4": (2, 3, 0)}
CORNERS = {"C3D4": 4, "C3D4H": 4, "C3D4T": 4, "T3D2": 2, "B31": 2} | dict.fromkeys(
    ("S3", "S3R", "S3RS", "STRI3", "M3D3", "SFM3D3", "R3D3", "CPS3", "CPE3", "CAX3"), 3)
# Parameters that change no number here. Others may, so they are refused.
PARAMETERS = {"NODE": {"NSET", "SYSTEM"}, "ELEMENT": {"TYPE", "ELSET"}, "SURFACE": {"NAME", "TYPE", "INTERNAL"},
              "NSET": {"NSET", "ELSET", "GENERATE", "INSTANCE", "INTERNAL", "UNSORTED"},
              "ELSET": {"ELSET", "GENERATE", "INSTANCE", "INTERNAL", "UNSORTED"}, "INSTANCE": {"NAME", "PART"}}
UNREAD = ("INCLUDE", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM", "IMPERFECTION", "SYMMETRIC MODEL GENERATION")
GMSH_TYPE = {1: 15, 2: 1, 3: 2, 4: 4}  # of points, lines, triangles, tets by their corners
MOST_VALUES = 100  # of an array that makes groups; one of more values numbers things


class Refused(Exception):
    """What is wrong with a file, and what to do."""


def encoding_of(path):
    """Names are in UTF-8, or else in Latin-1."""
    try:
        with open(path, encoding="utf-8-sig") as file:
            return "utf-8-sig" if all(True for _ in file) else ""
    except UnicodeDecodeError:
        return "latin-1"


def abaqus_lines(path):
    """Yields (line number, words) of each line; a keyword's are one with the lines on which it goes on."""
    start, keyword = 0, []
    with open(path, encoding=encoding_of(path)) as file:
        for number, line in enumerate(file, 1):
            words = [word.strip() for word in line.strip().split(",")]
            if words == [""] or words[0].startswith("**"):
                continue
            if keyword and keyword[-1] == "" and not words[0].startswith("*"):
                keyword = keyword[:-1] + words
                continue
            if keyword:
                yield start, keyword
            start, keyword = number, words if words[0].startswith("*") else []
            if not keyword:
                yield number, words
    if keyword:
        yield start, keyword


def abaqus_blocks(path):
    """Yields (line number, KEYWORD, parameters, rows of (line number, words)) of each keyword; its rows are read before the next."""
    header = 0, [""]

    def header_of(line):
        nonlocal header
        header = line if line[1][0].startswith("*") else header
        return header

    for (start, words), rows in itertools.groupby(abaqus_lines(path), header_of):
        pairs = [word.partition("=") for word in words[1:] if word]
        parameters = {key.strip().upper(): value.strip().strip('"') for key, equals, value in pairs if value or not equals}
        yield start, " ".join(words[0][1:].upper().split()), parameters, itertools.islice(rows, 1, None)


class AbaqusMesh:
    """Nodes by number, elements as lists of corners by number, and groups as lists of (element or 0, corners)."""

    def __init__(self, path):
        self.path, self.where = path, path
        self.nodes, self.elements, self.names, self.groups = {}, {}, {}, {}
        self.sets = {"NSET": {}, "ELSET": {}}  # numbers by name in capitals
        self.kinds = {}  # of what a group consists: the keywords that name it
        for line, keyword, parameters, rows in abaqus_blocks(path):
            self.at(line, keyword)
            try:
                self.read(keyword, parameters, (self.at(number, keyword, words) for number, words in rows))
            except (KeyError, ValueError, IndexError) as error:
                what = {KeyError: f"the parameter {error} is missing", IndexError: "a number is missing"}.get(type(error), error)
                raise Refused(f"{self.where}: {what}; the file may be damaged: write the mesh again") from error
        self.where = path
        for element, corners in self.elements.items():
            self.require(corners, self.nodes, f"element {element} names node")
        for name, kinds in self.kinds.items():
            if len(kinds) > 1:
                print(f"note: {' and '.join(sorted(kinds))} {self.names[name]} become one group", file=sys.stderr)

    def all(self):
        return self.nodes, self.elements, self.groups

    def at(self, line, keyword, words=()):
        self.where = f"{self.path}: line {line}: *{keyword}"  # of messages, from here on
        return words

    def read(self, keyword, parameters, rows):
        if keyword in UNREAD or (keyword == "INSTANCE" and any(True for _ in rows)):
            raise Refused(f"{self.where} is not read; write the mesh flat, without parts, includes and generated nodes")
        for name, value in parameters.items():
            if name not in PARAMETERS.get(keyword, parameters) or (keyword, name) == ("NODE", "SYSTEM") and value.upper() != "R":
                raise Refused(f"{self.where}: the parameter {name}{value and '='}{value} may change what its lines mean, "
                              "and is not read; write the mesh without it")
        if keyword == "NODE":
            self.add_set("NSET", parameters, self.add(self.nodes, map(self.node_of, rows)))
        elif keyword == "ELEMENT":
            kind = parameters["TYPE"].upper()
            if kind not in CORNERS:
                raise Refused(f"{self.where}: there are {len(list(rows))} lines of elements of type {kind}, and only linear tets (C3D4), "
                              "with triangles and lines, are read; mesh the body with C3D4 alone")
            self.add_set("ELSET", parameters, self.add(self.elements, self.elements_of(kind, rows)))
        elif keyword in self.sets:
            numbers = self.members(keyword, rows, "GENERATE" in parameters)
            if keyword == "NSET" and "ELSET" in parameters:  # the nodes of its elements
                numbers += dict.fromkeys(n for e in self.members("ELSET", [[parameters["ELSET"]]], False) for n in self.elements[e])
            self.add_set(keyword, {keyword: parameters[keyword]}, numbers)
        elif keyword == "SURFACE":
            self.add_surface(parameters, rows)

    def node_of(self, row):
        words = (row[1:4] + [""] * 3)[:3]  # a blank is 0, and exponents may be Fortran's
        return int(row[0]), tuple(float(word.replace("D", "E").replace("d", "e") or 0) for word in words)

    def elements_of(self, kind, rows):
        """Yields (number, corners). A row that is not full goes on behind a comma at its end."""
        row = []
        for words in rows:
            row += words[:-1] if words[-1] == "" else words
            if words[-1] == "" and len(row) <= CORNERS[kind]:
                continue
            if len(row) != CORNERS[kind] + 1:
                break
            yield int(row[0]), tuple(map(int, row[1:]))
            row = []
        if row:
            raise Refused(f"{self.where}: an element of type {kind} has a number and {CORNERS[kind]} nodes, not {len(row) - 1}; correct it")

    def add(self, known, new):
        """Takes (number, values) into those that are known, and gives the numbers."""
        before = len(known)
        for number, values in new:
            if number in known:
                raise Refused(f"{self.where}: {number} stands twice; write the mesh flat, without parts, and each number once")
            known[number] = values
        return list(itertools.islice(known, before, None))

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
        self.group("SURFACE", name, [])
        kind = parameters.get("TYPE", "ELEMENT").upper()
        if kind == "NODE":
            numbers = self.members("NSET", (row[:1] for row in rows), False)
            self.require(numbers, self.nodes, f"the surface {name} names")
            self.group("SURFACE", name, [(0, [n]) for n in numbers])
            return
        if kind != "ELEMENT":
            raise Refused(f"{self.where}: a surface of TYPE={kind} is none of the mesh; remove it, or write TYPE=ELEMENT or TYPE=NODE")
        for row in rows:
            side = row[1].upper() if len(row) > 1 else ""
            numbers = self.members("ELSET", [row[:1]], False)
            self.require(numbers, self.elements, f"the surface {name} names")
            for corners in (self.elements[n] for n in numbers):
                if side not in (SIDES if len(corners) == 4 else ("", "SPOS", "SNEG") if len(corners) == 3 else ()):
                    faces = "side of a tet; write S1, S2, S3 or S4" if len(corners) == 4 else "face; write SPOS or SNEG of triangles"
                    raise Refused(f"{self.where}: '{', '.join(row)}' names no {faces}")
                self.group("SURFACE", name, [(0, [corners[c] for c in SIDES[side]] if len(corners) == 4 else corners)])

    def members(self, kind, rows, generate):
        """The numbers that the lines of a set name."""
        if generate:
            ranges = [[int(word) for word in row if word] for row in rows]
            return [n for row in ranges for n in range(row[0], row[1] + 1, row[2] if len(row) > 2 else 1)]
        found = []
        for word in (word for row in rows for word in row if word):
            if word.isdigit():
                found.append(int(word))
            elif word.strip('"').upper() in self.sets[kind]:
                found += self.sets[kind][word.strip('"').upper()]
            else:
                raise Refused(f"{self.where}: there is no {kind} '{word}' above this line; define it before it is used")
        return found


def read_other(path):
    """Nodes, elements and groups as AbaqusMesh has them, by meshio; numbers are from 1 on."""
    try:
        import meshio  # pylint: disable=import-outside-toplevel
        import numpy  # pylint: disable=import-outside-toplevel
        mesh = meshio.read(path)
    except ImportError as error:
        raise Refused(f"{path}: meshio reads this format, and is not here ({error}); install python3-meshio") from error
    except (Exception, SystemExit) as error:  # pylint: disable=broad-except
        raise Refused(f"{path}: meshio does not read it: {error}; save it as .vtu, .inp or .msh") from error
    others = [f"{len(block.data)} {block.type}" for block in mesh.cells if block.type not in ("vertex", "line", "triangle", "tetra")]
    if others:
        raise Refused(f"{path}: only linear tets, with triangles, lines and points, are read, and there are "
                      + ", ".join(others) + "; mesh the body with linear tets alone")
    nodes = {n: [float(x) for x in (*point, 0, 0)[:3]] for n, point in enumerate(mesh.points, 1)}
    numbers, groups = itertools.count(1), {}
    cells = [[(next(numbers), tuple(int(n) + 1 for n in cell)) for cell in block.data] for block in mesh.cells]
    elements = dict(itertools.chain(*cells))
    rows_of_points = [(0, [n]) for n in nodes]

    def add_values(name, rows, values, skipped):
        if values.ndim != 1 or values.dtype.kind not in "iub":
            return
        # Salome's families: a number each, and the names of the groups that its points or cells are in.
        families = getattr(mesh, name, None) if name in ("point_tags", "cell_tags") else None
        if families is None and len(numpy.unique(values)) > MOST_VALUES:
            print(f"note: {name} has more than {MOST_VALUES} values and makes no groups", file=sys.stderr)
            return
        for row, value in zip(rows, values.tolist()):
            own = [f"{name}_{int(value)}"] if value != skipped else []
            for group in own if families is None else families.get(value, []):
                groups.setdefault(group, []).append(row)

    for name, blocks in mesh.cell_data.items():
        add_values(name, elements.items(), numpy.concatenate(blocks), None)
    for name, values in mesh.point_data.items():
        add_values(name, rows_of_points, numpy.asarray(values), 0)
    for name, blocks in mesh.cell_sets.items():
        groups.setdefault(name, []).extend(rows[at] for rows, found in zip(cells, blocks) for at in found)
    for name, found in mesh.point_sets.items():
        groups.setdefault(name, []).extend(rows_of_points[at] for at in found)
    return nodes, elements, groups


def element_lines(elements, groups):
    """Yields (number, corners, group) of each: an element of several groups stands there once for each, under one number."""
    free, used = max(elements, default=0), set()
    for group, rows in enumerate(groups.values(), 1):
        for element, corners in rows:
            used.add(element)
            free += element == 0
            yield element or free, corners, group
    yield from ((element, corners, 0) for element, corners in elements.items() if element not in used)


def write_gmsh(path, nodes, elements, groups):
    """Version 2.2 as text."""
    names = [(d, number, name) for number, (name, rows) in enumerate(groups.items(), 1)
             for d in sorted({len(corners) - 1 for _, corners in rows})]
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(names)}\n")
        out.writelines(f'{dimension} {number} "{name}"\n' for dimension, number, name in names)
        out.write(f"$EndPhysicalNames\n$Nodes\n{len(nodes)}\n")
        out.writelines(f"{number} {x[0]:.17g} {x[1]:.17g} {x[2]:.17g}\n" for number, x in nodes.items())
        out.write(f"$EndNodes\n$Elements\n{sum(1 for _ in element_lines(elements, groups))}\n")
        for number, corners, group in element_lines(elements, groups):
            out.write(f"{number} {GMSH_TYPE[len(corners)]} 2 {group} {group} {' '.join(map(str, corners))}\n")
        out.write("$EndElements\n")


def main(source, target):
    if pathlib.Path(target).suffix != ".msh":
        raise Refused(f"{target}: the file that is written is in Gmsh's format; give it the ending .msh")
    if source.lower().endswith(".msh"):
        raise Refused(f"{source}: is in Gmsh's format already; give it to truthcube --mesh, or save it as .vtu where its ending is wrong")
    nodes, elements, groups = AbaqusMesh(source).all() if source.lower().endswith(".inp") else read_other(source)
    if (tets := sum(len(corners) == 4 for corners in elements.values())) == 0:
        raise Refused(f"{source}: has no linear tets; mesh the volume")
    if empty := [name for name, rows in groups.items() if not rows]:
        print(f"note: without members, so no groups: {', '.join(empty)}", file=sys.stderr)
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
    except OSError as failed:
        sys.exit(f"{failed.filename or sys.argv[2]}: {failed.strerror}; check the name, its folder, your rights and the disk's space")
