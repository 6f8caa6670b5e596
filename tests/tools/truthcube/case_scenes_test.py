"""Tests of truthcube --case with scenes that have arrays of their own: case_scenes_test.py RULE PROGRAM FOLDER."""
import copy
import json
import pathlib
import sys

sys.dont_write_bytecode = True
from case_bodies import Box, Command, run_rule  # noqa: E402

truthcube = Command(sys.argv[2], pathlib.Path(sys.argv[3]) / sys.argv[1])
CASE = {
    "mesh": "m.msh", "material": {"young": 2e4, "poisson": 0.45, "density": 1000}, "supports": [{"group": "z0"}],
    "loads": [{"group": "z1", "traction": [0, 30, -400], "curve": "there"}, {"group": "y1", "pressure": 100}],
    "curves": {"there": [[0, 0], [1, 1], [2, 0.2]]}, "steps": [0.5, 1, 2], "probes": [{"name": "middle", "at": [0.02, 0.03, 0.05]}],
}
SCENES = (("quasistatic", "stable-neo-hookean", ()), ("fixed-corotated", "fixed-corotated", ("--volume", "tets")),
          ("matrix-free", "stable-neo-hookean", ("--product", "matrix-free", "--preconditioner", "block-jacobi")))


def run(out, case, *flags):
    """The files of a case, but for run.json, and its steps without times."""
    (truthcube.folder / "case.json").write_text(json.dumps(case), encoding="ascii")
    truthcube.run("--case", "case.json", "--threads", 1, "--out", out, "--tolerance", 1e-4, *flags)
    folder = truthcube.folder / out
    steps = json.loads((folder / "run.json").read_text(encoding="utf-8"))["steps"]
    for step in steps:
        for line in (step, *step["newton"]):
            line.pop("seconds")
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.name != "run.json"}, steps


def scenes_of_their_own_solve_a_case_as_everything_does():
    """To the last bit, over loads that go up and down; the law that is left out is the scene's."""
    Box(4).write(truthcube.folder / "m.msh")
    for scene, law, flags in SCENES:
        named = copy.deepcopy(CASE)
        named["material"]["law"] = law
        wanted = run(f"{scene}_everything", named, "--precision", "float", *flags)
        assert len(wanted[1]) == 3 and set(wanted[0]) == {"cube.vtkhdf", "cube.xdmf", "groups.csv", "probes.csv"}, wanted[0].keys()
        assert run(f"{scene}_named", named, "--scene", scene) == wanted, scene
        assert run(scene, CASE, "--scene", scene) == wanted, scene


def cases_that_a_scene_does_not_have_are_refused_with_their_place():
    Box(2).write(truthcube.folder / "m.msh")

    def refuse(words, status, change, *flags):
        case = copy.deepcopy(CASE)
        change(case)
        (truthcube.folder / "case.json").write_text(json.dumps(case), encoding="ascii")
        _, said = truthcube.run("--case", "case.json", *flags, status=status)
        for word in words:
            assert word in said, (word, said)

    refuse(["case.json: material.law: --scene quasistatic has no neo-hookean, but stable-neo-hookean; take --scene everything"], 2,
           lambda case: case["material"].update(law="neo-hookean"), "--scene", "quasistatic")
    refuse(["case.json: material.groups: --scene matrix-free has one material; take --scene everything"], 2,
           lambda case: case["material"].update(groups=[{"group": "far", "young": 1e4, "poisson": 0.4}]), "--scene", "matrix-free")
    refuse(["case.json: loads: --scene fixed-corotated has no pressures that follow the surface; take --scene everything"], 2,
           lambda case: case["loads"][1].update(follows=True), "--scene", "fixed-corotated")
    refuse(["--case cannot take --scene implicit-dynamics, which moves; take"], 2, lambda case: None, "--scene", "implicit-dynamics")
    Box(6).write(truthcube.folder / "m.msh")
    refuse(["multigrid of this mesh needs a background grid, which --scene quasistatic does not have; add --preconditioner block-jacobi"], 1,
           lambda case: None, "--scene", "quasistatic")


run_rule((scenes_of_their_own_solve_a_case_as_everything_does, cases_that_a_scene_does_not_have_are_refused_with_their_place), sys.argv[1])
