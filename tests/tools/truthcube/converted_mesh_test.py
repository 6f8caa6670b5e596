"""Meshes of other formats with their groups: converted_mesh_test.py RULE PROGRAM FOLDER, with convert.py of tools/fem/mesh."""
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
from case_bodies import Box, Command, run_rule  # noqa: E402

CONVERT = pathlib.Path(__file__).parents[3] / "tools/fem/mesh/convert.py"
truthcube = Command(sys.argv[2], f"{sys.argv[3]}/{sys.argv[1]}")
EVEN = ((0, 1, 2, 3), (1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0))  # orders of a tet's corners of one sense
SIDES = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))  # of a C3D4: S1 to S4
CASE = {
    "material": {"young": 1e4, "poisson": 0.3, "density": 1000, "groups": [{"group": "FAR", "young": 3e4, "poisson": 0.2}]},
    "supports": [{"group": "z0"}],
    "loads": [{"group": "x1", "traction": [30, 20, 10]}, {"group": "y1", "pressure": 90}, {"gravity": [1, 2, 3]}],
}


def convert(source, target, status=0):
    done = subprocess.run([CONVERT, source, target], cwd=truthcube.folder, capture_output=True, text=True, check=False)
    assert (done.returncode != 0) == (status != 0) and "Traceback" not in done.stderr, (done.stdout, done.stderr)
    return done.stdout + done.stderr


def refused(text, *words):
    (truthcube.folder / "bad.inp").write_text(text, encoding="latin-1")
    said = convert("bad.inp", "bad.msh", 1)
    for word in words:
        assert word in said, (word, said)
    assert not (truthcube.folder / "bad.msh").exists()


def converted(text, encoding="utf-8"):
    """Nodes, elements and members of groups as the converted file has them, and what the command said."""
    (truthcube.folder / "some.inp").write_text(text, encoding=encoding)
    said = convert("some.inp", "some.msh")
    lines = (truthcube.folder / "some.msh").read_text(encoding="utf-8").splitlines()

    def rows(name):
        return [line.split(" ", 2 if name == "PhysicalNames" else -1)
                for line in lines[lines.index(f"${name}") + 2:lines.index(f"$End{name}")]]
    nodes = {int(number): tuple(map(float, x)) for number, *x in rows("Nodes")}
    elements = [tuple(map(int, row)) for row in rows("Elements")]
    groups = {name.strip('"'): [(row[0], row[5:]) for row in elements if row[3] == int(number)]
              for _, number, name in rows("PhysicalNames")}
    return nodes, {row[0]: row[5:] for row in elements if row[1] == 4}, groups, said


def same_as_written(box, groups, tags):
    """Whether the converted mesh has the results of the box that is written in Gmsh's format."""
    box.write(truthcube.folder / "direct.msh")
    plain = CASE | {"mesh": "direct.msh"}
    plain = plain | {"material": plain["material"] | {"groups": [plain["material"]["groups"][0] | {"group": "far"}]}}
    wanted, _ = truthcube.solve(plain)
    renamed = {
        "mesh": "converted.msh",
        "material": CASE["material"] | {"groups": [CASE["material"]["groups"][0] | {"group": groups["far"]}]},
        "supports": [{"group": groups["z0"]}],
        "loads": [load | ({"group": groups[load["group"]]} if "group" in load else {}) for load in CASE["loads"]],
    }
    found, _ = truthcube.solve(renamed)
    (step,), (other,) = wanted["steps"], found["steps"]
    assert wanted["tets"] == found["tets"] and wanted["nodes"] == found["nodes"]
    for name, mine in groups.items():
        for what in "reaction", "load":
            for a, b in zip(step["groups"][name][what], other["groups"][mine][what], strict=True):
                assert abs(a - b) < 1e-9 * 0.24, (name, what, a, b)
    for k in "xyz":
        assert abs(step["displacement"][k]["high"] - other["displacement"][k]["high"]) < 1e-12
    text = (truthcube.folder / "converted.msh").read_text(encoding="utf-8")
    for tag in tags:
        assert f"\n{tag} 4 2 " in text, tag


def abaqus(box):
    """A box as Abaqus and CalculiX have it: far tets by numbers, near ones by a set of ELEMENT, surfaces by sides and shells."""
    tets = [tuple(tet[k] for k in EVEN[t // 3 % 4]) for t, tet in enumerate(box.tets)]
    number = {t: 100 + 3 * t for t in range(len(box.tets))}
    lines = ["*Heading", "** a comment, which counts for nothing", "*NODE, NSET=All nodes"]
    lines += [f"{n}, " + ", ".join(map(repr, x)) for n, x in enumerate(box.nodes, 1)]
    lines += ["*Element, type=c3d4, elset=\"Body\""]
    for t, tet in enumerate(tets):  # one in three goes on in the next line
        corners = [n + 1 for n in tet]
        lines += [f"{number[t]}, {corners[0]},", f" {corners[1]}, {corners[2]}, {corners[3]}"] if t % 3 == 0 else [
            f"{number[t]}, " + ", ".join(map(str, corners))]
    skin = 100 + 3 * len(box.tets)
    lines += ["*ELEMENT, TYPE=S3, ELSET=x1"] + [
        f"{skin + k}, " + ", ".join(str(n + 1) for n in face) for k, face in enumerate(box.faces["x1"])]
    ground = sorted({n + 1 for face in box.faces["z0"] for n in face})
    cells = round(len(ground) ** 0.5)
    lines += ["*NSET, NSET=lower, GENERATE", f"1, {cells * cells}", "*Nset, nset=z0", "lower"]
    lines += ["*ELSET, ELSET=upper"] + [f"{number[t]}," for t in box.far[:7]]
    lines += ["*ELSET, ELSET=FAR"] + ["upper, " + ", ".join(str(number[t]) for t in box.far[7:])]
    sides = {}
    for face in box.faces["y1"]:
        for t, tet in enumerate(tets):
            for side, corners in enumerate(SIDES, 1):
                if {tet[c] for c in corners} == set(face):
                    sides.setdefault(side, []).append(number[t])
    assert sorted(sides) == [1, 2, 3, 4], sides
    for side, numbers in sides.items():
        lines += [f"*ELSET, ELSET=_y1_S{side}, INTERNAL"] + [", ".join(map(str, numbers))]
    lines += ["*SURFACE, TYPE=ELEMENT, NAME=y1"] + [f"_Y1_S{side}, S{side}" for side in sides]
    lines += ["*SURFACE, TYPE=NODE, NAME=Ground", "LOWER, 1.0"]
    lines += ["*MATERIAL, NAME=tissue", "*ELASTIC", "1e4, 0.3", "*STEP", "*STATIC", "*END STEP"]
    return "\n".join(lines) + "\n", number


def sets_and_surfaces_of_abaqus_become_groups():
    box = Box(3)
    text, number = abaqus(box)
    (truthcube.folder / "body.inp").write_text(text, encoding="latin-1")
    said = convert("body.inp", "converted.msh")
    assert "64 nodes, 162 tets; groups: All nodes, Body, x1, lower, z0, upper, FAR" in said and "y1, Ground" in said, said
    same_as_written(box, {"z0": "z0", "x1": "x1", "y1": "y1", "far": "FAR"}, number.values())
    _, said = truthcube.run("--mesh", "body.inp", status=1)
    assert "convert it with its groups: physgen-convert-mesh body.inp body.msh (in a checkout tools/fem/mesh/convert.py)" in said, said
    convert("body.inp", "body.msh")  # what the message says


def whole_numbers_of_a_vtu_become_groups():
    import meshio  # pylint: disable=import-outside-toplevel
    import numpy  # pylint: disable=import-outside-toplevel
    box = Box(3)
    blocks = [("tetra", numpy.array(box.tets))] + [("triangle", numpy.array(box.faces[name])) for name in ("x1", "y1")]
    part = [numpy.isin(range(len(box.tets)), box.far).astype(int)]
    part += [numpy.full(len(box.faces[name]), k) for k, name in ((5, "x1"), (6, "y1"))]
    low = numpy.isin(range(len(box.nodes)), box.faces["z0"]).astype("i4")
    young = [numpy.linspace(0, 1, len(rows)) for _, rows in blocks]
    ids = numpy.arange(1000, 1000 + len(box.tets))
    mesh = meshio.Mesh(numpy.array(box.nodes), blocks, cell_data={"part": part, "young": young}, point_data={"low": low})
    mesh.write(truthcube.folder / "body.vtu")
    said = convert("body.vtu", "converted.msh")
    assert "64 nodes, 162 tets; groups: part_0, part_1, part_5, part_6, low_1" in said, said
    same_as_written(box, {"z0": "low_1", "x1": "part_5", "y1": "part_6", "far": "part_1"}, range(1, len(box.tets) + 1))
    meshio.Mesh(numpy.array(box.nodes), blocks[:1], cell_data={"ids": [ids]}).write(truthcube.folder / "numbered.vtu")
    assert "note: ids has more than 100 values and makes no groups" in convert("numbered.vtu", "numbered.msh")
    meshio.Mesh(numpy.random.default_rng(5).random((10, 3)), [("tetra10", numpy.arange(10)[None])]).write(truthcube.folder / "second.vtu")
    assert "only linear tets, with triangles, lines and points, are read, and there are 1 tetra10" in convert("second.vtu", "a.msh", 1)
    some = [numpy.arange(len(rows)) + first for first, (_, rows) in zip((0, 162, 180), blocks)]  # in one block 18 values
    meshio.Mesh(numpy.array(box.nodes), blocks, cell_data={"ids": some}).write(truthcube.folder / "blocks.vtu")
    assert "groups: none" in convert("blocks.vtu", "blocks.msh")
    (truthcube.folder / "broken.vtu").write_text("<VTKFile", encoding="ascii")
    assert "meshio does not read it" in convert("broken.vtu", "a.msh", 1)


def groups_of_salome_keep_their_names():
    import meshio  # pylint: disable=import-outside-toplevel
    import numpy  # pylint: disable=import-outside-toplevel
    box = Box(3)
    blocks = [("tetra", numpy.array(box.tets))] + [("triangle", numpy.array(box.faces[name])) for name in ("x1", "y1")]
    far = numpy.isin(range(len(box.tets)), box.far)
    tags = [numpy.where(far, -1, 0)] + [numpy.full(len(box.faces[name]), k) for k, name in ((-2, "x1"), (-3, "y1"))]
    low = numpy.isin(range(len(box.nodes)), box.faces["z0"]).astype(int)
    blocks = [blocks[0], ("triangle", numpy.concatenate([rows for _, rows in blocks[1:]]))]  # one of each type, as in a .med
    mesh = meshio.Mesh(numpy.array(box.nodes), blocks, cell_data={"cell_tags": [tags[0], numpy.concatenate(tags[1:])]},
                       point_data={"point_tags": low})
    mesh.cell_tags = {-1: ["FAR"], -2: ["x1", "skin"], -3: ["y1", "skin"]}
    mesh.point_tags = {1: ["z0"]}
    mesh.write(truthcube.folder / "body.med")
    said = convert("body.med", "converted.msh")
    assert "64 nodes, 162 tets; groups: FAR, x1, skin, y1, z0" in said, said
    same_as_written(box, {"z0": "z0", "x1": "x1", "y1": "y1", "far": "FAR"}, range(1, len(box.tets) + 1))


NODES = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, 1, 1, 1\n"
TETS = "*ELEMENT, TYPE=C3D4, ELSET=E\n1, 1, 2, 3, 4\n2, 2, 3, 4, 5\n"


def what_abaqus_allows_is_read_as_abaqus_reads_it():
    nodes, tets, _, _ = converted(NODES + TETS)
    assert nodes[5] == (1, 1, 1) and tets == {1: (1, 2, 3, 4), 2: (2, 3, 4, 5)}
    for text in (
            NODES.replace("3, 0, 1, 0", "3,,1,0").replace("4, 0, 0, 1", "4,,,1,").replace("1, 0, 0, 0", "1,") + TETS,  # blanks are 0
            NODES.replace("2, 1, 0, 0", "2, 1.0D0, 0d0, 0.0E-1") + TETS,
            NODES.replace("*NODE", " *NODE, SYSTEM=R") + "\t" + TETS,
            NODES + TETS.replace("C3D4, ELSET", "C3D4,\n** a comment\n ELSET"),
            NODES + TETS.replace("3, 4\n", "3, 4,\n"),
            NODES + TETS.replace("1, 1, 2, 3, 4\n", "1, 1,\n2, 3,\n4\n"),
            NODES + TETS + "*ORIENTATION, SYSTEM=CYLINDRICAL, NAME=o\n0, 0, 0, 0, 0, 1\n*NODE PRINT, NSET=x\nU\n"):
        found = converted(text)
        assert found[:2] == (nodes, tets) and found[2]["E"] == list(tets.items()), (text, found)
    groups = converted(NODES + TETS + "*NSET, NSET=N,\nGENERATE\n1, 5, 2\n")[2]
    assert [corners for _, corners in groups["N"]] == [(1,), (3,), (5,)], groups
    for encoding in "utf-8", "latin-1", "utf-8-sig":
        assert list(converted(NODES + TETS.replace("=E", "=Höhle"), encoding)[2]) == ["Höhle"], encoding


def sets_of_sets_are_the_nodes_of_elements_and_empty_ones_are_said():
    _, _, groups, said = converted(NODES + TETS + "*ELSET, ELSET=one\n2\n*NSET, NSET=N, ELSET=one\n*SURFACE, TYPE=NODE, NAME=S\nN,\n")
    for name in "N", "S":
        assert [corners for _, corners in groups[name]] == [(2,), (3,), (4,), (5,)], (name, groups)
    assert "note" not in said, said
    _, _, groups, said = converted(NODES + TETS + "*NSET, NSET=N\n*SURFACE, TYPE=NODE, NAME=S\nN,\n")
    assert list(groups) == ["E"] and "note: without members, so no groups: N, S" in said, (groups, said)


def meshes_that_cannot_be_converted_are_refused_with_their_line():
    nodes = NODES.replace("5, 1, 1, 1\n", "")
    tet = nodes + "*ELEMENT, TYPE=C3D4, ELSET=all\n1, 1, 2, 3, 4\n"
    refused(nodes + "*ELEMENT, TYPE=C3D10, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n*ELSET, ELSET=F\nE\n",
            "line 6: *ELEMENT: there are 1 lines of elements of type C3D10, and only linear tets (C3D4)", "mesh the body with C3D4 alone")
    refused(nodes, "has no linear tets; mesh the volume")
    refused(tet + "*NSET, NSET=a\n1, 9\n", "line 9: *NSET: the set a names 9, which the file does not have")
    refused(tet + "*ELSET, ELSET=a\nb\n", "line 9: *ELSET: there is no ELSET 'b' above this line")
    refused(tet + "*SURFACE, NAME=a\nall, S5\n", "line 9: *SURFACE: 'all, S5' names no side of a tet; write S1, S2, S3 or S4")
    triangle = tet + "*ELEMENT, TYPE=S3, ELSET=s\n2, 1, 2, 3\n*ELEMENT, TYPE=B31, ELSET=b\n3, 1, 2\n*SURFACE, NAME=a\n"
    for row in ("s, E1", "s, S1", "b, SPOS"):  # an edge, an edge of a plane element, and a line
        refused(triangle + row + "\n", f"line 13: *SURFACE: '{row}' names no face; write SPOS or SNEG of triangles")
    refused(tet + "*IMPERFECTION, INPUT=shape\n", "line 8: *IMPERFECTION is not read; write the mesh flat")
    refused(tet + "*INCLUDE, INPUT=more.inp\n", "line 8: *INCLUDE is not read; write the mesh flat")
    refused(tet + "*NODE\n4, 0, 0, 2\n", "line 9: *NODE: 4 stands twice; write the mesh flat, without parts")
    refused(tet.replace("3, 4\n", "3, 5\n"), "element 1 names node 5, which the file does not have")
    refused(tet.replace("3, 4\n", "3\n"), "line 7: *ELEMENT: an element of type C3D4 has a number and 4 nodes")
    refused(tet.replace("1, 0, 0, 0", "1, zero, 0, 0"), "line 2: *NODE: could not convert string to float: 'zero'; the file may be damaged: write the mesh again")
    refused(tet.replace("TYPE=C3D4, ", ""), "line 6: *ELEMENT: the parameter 'TYPE' is missing")
    refused(tet + "*ELEMENT, TYPE=C3D4\n2, 1, 2\n3, 4\n",
            "line 9: *ELEMENT: an element of type C3D4 has a number and 4 nodes, not 2; correct it")
    refused(nodes + "4, 0, 0, 1\n" + tet, "line 6: *NODE: 4 stands twice")
    refused(tet + "1, 2, 3, 4, 1\n", "line 8: *ELEMENT: 1 stands twice; write the mesh flat, without parts, and each number once")
    refused(tet.replace("*NODE", "*NODE, SYSTEM=C"), "line 1: *NODE: the parameter SYSTEM=C may change what its lines mean")
    refused(tet + "*NODE, INPUT=more.inp\n", "line 8: *NODE: the parameter INPUT=more.inp", "write the mesh without it")
    refused(tet + "*ELEMENT, TYPE=C3D4, INPUT=more.inp\n", "line 8: *ELEMENT: the parameter INPUT=more.inp")
    refused(tet + "*SURFACE, NAME=a, COMBINE=UNION\nb, c\n", "line 8: *SURFACE: the parameter COMBINE=UNION")
    refused(tet + "*SURFACE, NAME=a, TYPE=REVOLUTION\nSTART, 0, 0\n", "line 8: *SURFACE: a surface of TYPE=REVOLUTION is none of the mesh")
    refused(tet + "*NSET\n1\n", "line 9: *NSET: the parameter 'NSET' is missing")
    refused(tet + "*ELSET, ELSET=\n1\n", "line 9: *ELSET: the parameter 'ELSET' is missing")
    refused(tet + "*NSET, NSET=a, ELSET=b\n", "line 8: *NSET: there is no ELSET 'b' above this line")
    (truthcube.folder / "good.inp").write_text(tet, encoding="ascii")
    assert "nowhere/a.msh.part: No such file or directory; check the name, its folder" in convert("good.inp", "nowhere/a.msh", 1)
    convert("good.inp", "good.msh")
    written = (truthcube.folder / "good.msh").read_bytes()
    for target in "good.msh", "a.msh":
        assert "good.msh: is in Gmsh's format already; give it to truthcube --mesh" in convert("good.msh", target, 1)
    assert (truthcube.folder / "good.msh").read_bytes() == written
    assert "none.inp: No such file or directory; check the name" in convert("none.inp", "a.msh", 1)
    assert "a.vtk: the file that is written is in Gmsh's format; give it the ending .msh" in convert("none.inp", "a.vtk", 1)


run_rule((sets_and_surfaces_of_abaqus_become_groups, whole_numbers_of_a_vtu_become_groups, groups_of_salome_keep_their_names,
          what_abaqus_allows_is_read_as_abaqus_reads_it, sets_of_sets_are_the_nodes_of_elements_and_empty_ones_are_said,
          meshes_that_cannot_be_converted_are_refused_with_their_line), sys.argv[1])
