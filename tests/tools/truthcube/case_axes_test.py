"""Supports along axes of one's own: case_axes_test.py RULE PROGRAM FOLDER"""
import json
import math
import re
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
from case_bodies import SIZE, Box, Command, near, run_rule  # noqa: E402

truthcube = Command(sys.argv[2], f"{sys.argv[3]}/{sys.argv[1]}")
COSINE, SINE = math.cos(math.pi / 6), math.sin(math.pi / 6)
STIFF = {"young": 1e4, "poisson": 0.3, "density": 1000}


def turned(x):
    """By 30 degrees about y, and then about x."""
    x, y, z = x[0] * COSINE + x[2] * SINE, x[1], x[2] * COSINE - x[0] * SINE
    return [x, y * COSINE - z * SINE, y * SINE + z * COSINE]


def a_turned_box_on_turned_supports_moves_as_the_box_does():
    box = Box(3)
    box.write(truthcube.folder / "plain.msh")
    box.write(truthcube.folder / "turned.msh", turned)
    places = {"end": (0.031, 0.02, 0.1), "middle": (0.02, 0.03, 0.05)}
    cases = []
    for mesh, turn in ("plain.msh", lambda x: list(x)), ("turned.msh", turned):
        ex, ez = turn((1, 0, 0)), turn((0, 0, 1))
        plain = mesh == "plain.msh"
        cases.append({
            "mesh": mesh, "material": STIFF,
            "supports": [
                {"group": "x0", "fixed": ["x"]} if plain else {"group": "x0", "axis": [5 * a for a in ex]},
                {"group": "y0", "fixed": ["y"]} if plain else {"group": "y0", "axis": "normal"},
                {"group": "z0", "fixed": ["z"]} if plain else {"group": "z0", "axis": [-a for a in ez]},
                {"group": "z1", "displacement": {"z": 0.004}, "curve": "late"} if plain
                else {"group": "z1", "axis": "normal", "displacement": 0.004, "curve": "late"},
            ],
            "loads": [{"gravity": turn((1, -2, -9))}, {"group": "x1", "traction": turn((40, 10, 0))},
                      {"group": "y1", "pressure": 60, "follows": True}],
            "curves": {"late": [[0.5, 0], [1, 1]]}, "steps": [0.5, 1],
            "probes": [{"name": name, "at": turn(x)} for name, x in places.items()],
        })
    # Refinement cuts along a fixed direction, which does not turn with the body: at these angles both are cut alike, at others not.
    for flags in ([], ["--refine", 1], ["--volume", "tets", "--preconditioner", "block-jacobi"], ["--preconditioner", "schwarz"]):
        plain, _ = truthcube.solve(cases[0], *flags)
        found, said = truthcube.solve(cases[1], *flags)
        for step, other in zip(plain["steps"], found["steps"], strict=True):
            for name in places:
                moved = other["probes"][name]["displacement"]
                for a, b in zip(turned(step["probes"][name]["displacement"]), moved, strict=True):
                    near(a, b, 1e-9)  # of millimetres
            for name, group in step["groups"].items():
                for what in "reaction", "load":
                    for a, b in zip(turned(group[what]), other["groups"][name][what], strict=True):
                        near(a, b, 1e-8)
            for name, k, sign in ("x0", 0, 1), ("y0", 1, -1), ("z0", 2, -1), ("z1", 2, 1):
                (along,) = other["groups"][name]["axes"]
                for a, b in zip(turned([sign * (c == k) for c in range(3)]), along["axis"], strict=True):
                    near(a, b, 1e-12)
                near(along["reaction"], sign * step["groups"][name]["reaction"][k], 1e-8)
        assert "reaction of z1" in said and "along its axis (" in said, said
        near(found["steps"][1]["energy"], plain["steps"][1]["energy"], 1e-9 * abs(plain["steps"][1]["energy"]))
    set_up = []
    for case in cases:
        (truthcube.folder / "case.json").write_text(json.dumps(case), encoding="ascii")
        said, _ = truthcube.run("--case", "case.json", "--refine", 3, "--dry-run")
        set_up.append(float(re.search("set-up: ([0-9.]+) GB more", said)[1]))
    assert set_up[1] > 1.2 * set_up[0], set_up  # with the turned copy of lists


def a_box_on_an_incline_is_stretched_exactly():
    box = Box(3)
    box.write(truthcube.folder / "m.msh", turned)
    supports = [{"group": group, "axis": "normal"} for group in ("x0", "y0", "z0")]
    run, _ = truthcube.solve(
        {"mesh": "m.msh", "material": STIFF, "supports": supports, "loads": [{"group": "z1", "traction": turned((0, 0, 70))}],
         "probes": [{"name": "end", "at": turned((0.011, 0.02, 0.1))}]}, "--scene", "linear-elastic")
    (step,) = run["steps"]
    exact = turned([-0.3 * 70 / 1e4 * 0.011, -0.3 * 70 / 1e4 * 0.02, 70 / 1e4 * 0.1])
    for a, b in zip(step["probes"]["end"]["displacement"], exact, strict=True):
        near(a, b, 1e-12)
    near(step["groups"]["z0"]["axes"][0]["reaction"], 70 * SIZE[0] * SIZE[1], 1e-9)


def axes_that_cannot_be_are_refused_with_their_place():
    Box(1).write(truthcube.folder / "m.msh")

    def refuse(supports, *words, status=2):
        truthcube.refuse({"mesh": "m.msh", "material": STIFF, "supports": supports}, *words, status=status)

    base = {"group": "z0"}
    refuse([base, {"group": "x0", "axis": [0, 0, 0]}], "supports[1].axis: [0, 0, 0] has no direction")
    refuse([base, {"group": "x0", "axis": [0, 1]}], "supports[1].axis: this must be 3 numbers")
    refuse([base, {"group": "x0", "axis": "norm"}], 'supports[1].axis: an axis is three numbers, such as [1, 1, 0], or "normal"')
    refuse([base, {"group": "x0", "axis": [0, 1, 0], "fixed": ["x"]}], "supports[1].fixed: a support with an axis holds along it")
    refuse([base, {"group": "x0", "axis": [0, 1, 0], "displacement": {"x": 1}}], "supports[1].displacement: this must be a number")
    refuse([{"group": "x1", "axis": [2, 0, 0], "displacement": 0.1}, {"group": "x1", "displacement": {"x": 0.2}}, base],
           "groups 'x1' and 'x1' share the node at (0.04, 0, 0) m at rest",
           "different displacements along (1, 0, 0) there, 0.1 and 0.2 m; leave", status=1)
    refuse([base, {"group": "near", "axis": "normal"}], "group 'near' has no faces", status=1)
    refuse([{"group": "x0", "fixed": ["x"]}, {"group": "x1", "axis": [COSINE, SINE, 0]}],
           "group 'x0', (1, 0, 0), and of group 'x1', (0.866025, 0.5, 0), are at 30 degrees; turn one of the axes", status=1)
    refuse([{"group": "x0", "axis": [1, 1, 0]}], "nothing keeps the body from moving", "translation along z",
           "rotation about (0.7071, 0.7071, 0)", status=1)


run_rule((a_turned_box_on_turned_supports_moves_as_the_box_does, a_box_on_an_incline_is_stretched_exactly,
          axes_that_cannot_be_are_refused_with_their_place), sys.argv[1])
