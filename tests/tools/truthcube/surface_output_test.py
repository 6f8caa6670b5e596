"""The surface alone as an output, read by h5py: surface_output_test.py RULE PROGRAM FOLDER"""
import json
import sys

import h5py
import numpy

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
from case_bodies import Box, Command, run_rule, surface  # noqa: E402

truthcube = Command(sys.argv[2], f"{sys.argv[3]}/{sys.argv[1]}")
FIELDS = {"PointData": ("displacement", "pressure"), "CellData": ("stress", "von_mises", "J")}
CASE = {
    "mesh": "m.msh", "material": {"young": 1e4, "poisson": 0.3}, "supports": [{"group": "z0"}],
    "loads": [{"group": "x1", "traction": [30, 20, 10]}], "steps": [0.5, 1],
}


def check(body, part, step):
    """Whether a file has the surface of the mesh in another, with its values at a step."""
    tets = body["Connectivity"][:].reshape(-1, 4)
    triangles = part["Connectivity"][:].reshape(-1, 3)
    assert set(part["Types"][:]) == {5} and (part["Offsets"][:] == 3 * numpy.arange(len(triangles) + 1)).all()
    assert part.attrs["Type"] == b"UnstructuredGrid" and part["NumberOfCells"][0] == len(triangles)
    points, all_points = part["Points"][:], body["Points"][:]
    number = {tuple(x): n for n, x in enumerate(all_points)}
    nodes = numpy.array([number[tuple(x)] for x in points])
    assert (numpy.diff(nodes) > 0).all() and len(numpy.unique(triangles)) == len(points) == part["NumberOfPoints"][0]
    # By brute force: the same triangles in the same sense, closed, around the volume of the tets.
    first = [tuple(numpy.roll(face, -numpy.argmin(face))) for face in nodes[triangles]]
    exact = {tuple(numpy.roll(face, -numpy.argmin(face))): t for t, tet in enumerate(tets) for face in surface([tet])}
    outside = {tuple(numpy.roll(face, -numpy.argmin(face))) for face in surface(tets)}
    assert set(first) == outside and len(first) == len(outside)
    sides = [(face[k], face[(k + 1) % 3]) for face in triangles for k in range(3)]
    assert len(set(sides)) == len(sides) and {(b, a) for a, b in sides} == set(sides)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    corners = all_points[tets]
    volume = numpy.linalg.det(corners[:, 1:] - corners[:, :1]).sum()
    assert abs((a * numpy.cross(b, c)).sum() - volume) < 1e-12 * volume
    behind = numpy.array([exact[face] for face in first])
    for group, names in FIELDS.items():
        rows = nodes if group == "PointData" else behind
        count = len(all_points) if group == "PointData" else len(tets)
        for name in names:
            offset = part[f"Steps/{group}Offsets/{name}"][step]
            assert offset == step * len(rows), (name, offset)
            wanted = body[group][name][step * count : (step + 1) * count][rows]
            assert (part[group][name][offset : offset + len(rows)] == wanted).all(), name
            assert name == "pressure" or abs(wanted).max() > 0
    return first, behind


def the_surface_has_the_values_of_the_body_and_the_groups_of_the_case():
    box = Box(3)
    box.write(truthcube.folder / "m.msh")
    for flags in [], ["--refine", 1]:
        truthcube.solve(CASE, *flags, out="body")
        truthcube.solve(CASE | {"output": "surface"}, *flags, out="part")
        with h5py.File(truthcube.folder / "body/cube.vtkhdf") as body, h5py.File(truthcube.folder / "part/cube.vtkhdf") as part:
            body, part = body["VTKHDF"], part["VTKHDF"]
            assert part["Steps"].attrs["NSteps"] == 2
            for step in range(2):
                first, _ = check(body, part, step)
            names = {name for name in part["CellData"] if name.startswith("group_")}
            assert names == {"group_" + name for name in (*box.faces, "near", "far")}
            points = body["Points"][:]
            for name in names:
                is_in = part["CellData"][name][:]
                assert len(is_in) == len(first) and (part[f"Steps/CellDataOffsets/{name}"][:] == [0, 0]).all()
                places = points[numpy.array(first)]
                if name in ("group_near", "group_far"):
                    assert is_in[places[:, :, 2].min(axis=1) >= 0.0501].all() == (name == "group_far")
                    continue
                axis, at = "xyz".index(name[6]), (0, (0.04, 0.06, 0.1)["xyz".index(name[6])])[int(name[7])]
                assert (is_in == (abs(places[:, :, axis] - at) < 1e-12).all(axis=1)).all() and is_in.any(), name
            assert (part["CellData/group_near"][:] + part["CellData/group_far"][:] == 1).all()


def names_of_groups_hold_nothing_that_parts_names():
    box = Box(2)
    box.write(truthcube.folder / "m.msh")
    text = (truthcube.folder / "m.msh").read_text(encoding="ascii")
    (truthcube.folder / "m.msh").write_text(text.replace('"y0"', '"y/0.a|b:c"'), encoding="ascii")
    truthcube.solve(CASE | {"output": "surface"}, out="named")
    with h5py.File(truthcube.folder / "named/cube.vtkhdf") as file:
        assert "group_y_0_a_b_c" in file["VTKHDF/CellData"], list(file["VTKHDF/CellData"])


def the_cube_is_written_as_its_surface_and_continued():
    common = ["--cells", 4, "--threads", 1]
    truthcube.run(*common, "--compress", 0.05, 0.1, "--out", "body")
    truthcube.run(*common, "--compress", 0.05, "--out", "part", "--output", "surface")
    _, said = truthcube.run(*common, "--compress", 0.05, 0.1, "--out", "part", "--restart", status=1)
    assert "output" in said, said
    truthcube.run(*common, "--compress", 0.05, 0.1, "--out", "part", "--output", "surface", "--restart")
    with h5py.File(truthcube.folder / "body/cube.vtkhdf") as body, h5py.File(truthcube.folder / "part/cube.vtkhdf") as part:
        for step in range(2):
            check(body["VTKHDF"], part["VTKHDF"], step)
    assert json.loads((truthcube.folder / "part/run.json").read_text())["settings"]["output"] == "surface"


def outputs_that_contradict_or_do_not_exist_are_refused():
    Box(1).write(truthcube.folder / "m.msh")
    truthcube.refuse(CASE | {"output": "surfaces"}, "case case.json: output: there is no output surfaces; did you mean surface?", status=2)
    _, said = truthcube.run("--output", "surface", status=2)
    assert "--output says what the files in --out DIR have; add --out" in said, said
    truthcube.solve(CASE | {"output": "surface"}, "--output", "surface")
    _, said = truthcube.run("--case", "case.json", "--output", "body", "--out", "o", status=2)
    assert '--output body: the case case.json says "output": "surface"; remove one of them' in said, said


run_rule((the_surface_has_the_values_of_the_body_and_the_groups_of_the_case, names_of_groups_hold_nothing_that_parts_names,
          the_cube_is_written_as_its_surface_and_continued, outputs_that_contradict_or_do_not_exist_are_refused), sys.argv[1])
