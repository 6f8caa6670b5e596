"""Meshes of a user's own and cases in truthcube on several ranks: ranks_bodies_test.py MPIRUN|none TRUTHCUBE CASE."""
import json
import re
import shutil

from case_bodies import Box
from ranks_bodies import case_record, shuffled
from ranks_runs import FOLDER, MPIRUN, SCENE, TRUTHCUBE, command, done, expect_same, record, run_and_remove, without_times
from ranks import run  # behind ranks_runs, which says where it is


def a_mesh_of_ones_own_has_the_files_of_one_process():
    """In each order, with coarser meshes and without, also of two bodies that do not touch; and where a run is continued on several ranks."""
    has_metis = "this build has no METIS" not in run(TRUTHCUBE, "--mesh", "none.msh", "--order", "metis")[2]
    bodies = (("one", (Box(14),), ("--preconditioner", "block-jacobi"), 3), ("two", (Box(10), Box(9)), ("--preconditioner", "block-jacobi"), 2),
              ("refined", (Box(4),), ("--refine", "2", "--replicate", "500", "--volume", "patches"), 3))
    for name, boxes, flags, count in bodies:
        mesh = FOLDER / f"{name}.msh"
        shuffled(*boxes).write(mesh)
        for order in ("mesh", "metis") if has_metis else ("mesh",):
            words = ("--mesh", str(mesh), "--order", order, *flags)
            wanted, found = FOLDER / f"{name}_{order}", FOLDER / f"{name}_{order}_ranks"
            alone = tuple(word for word in words if word not in ("--replicate", "500"))
            done(0, TRUTHCUBE, *SCENE, *alone, "--compress", "0.03", "0.06", "--out", str(wanted))
            done(0, *command(count, *words, "--compress", "0.03", "--out", str(found)))
            done(0, *command(count, *words, "--compress", "0.03", "0.06", "--restart", "--out", str(found)))
            files = ("cube.vtkhdf", "cube.xdmf", "checkpoint.h5") + (("order.h5",) if order == "metis" else ())
            assert {path.name for path in wanted.iterdir()} == {*files, "run.json"} == {path.name for path in found.iterdir()}, wanted
            expect_same(wanted, found, files)
            assert record(found)[1]["count"] == count and len(record(found)[0]["steps"]) == 2
        if not has_metis:
            continue
        both = [(FOLDER / f"{name}_{order}" / "checkpoint.h5").read_bytes() for order in ("mesh", "metis")]
        assert both[0] != both[1], "the order does nothing"
        if name == "two":  # the order of another mesh, which all ranks read
            shutil.copy(FOLDER / "one_metis" / "order.h5", found / "order.h5")
            status, _, errors = run(*command(2, *words, "--compress", "0.03", "0.09", "--restart", "--out", str(found)))
            assert status == 1 and len(re.findall("order.h5: this order belongs to another mesh, of 3375 nodes and .* tets; give the --mesh", errors)) == 1, errors


def a_case_has_the_files_of_one_process():
    """In each order, with coarser meshes and without; its loads follow curves, so that the solver's loading changes from step to step."""
    case = {"mesh": "", "material": {"young": 2e4, "poisson": 0.45, "density": 1000}, "supports": [{"group": "z0"}, {"group": "x0", "fixed": ["x"]}],
            "loads": [{"group": "z1", "traction": [0, 30, -400], "curve": "there"}, {"group": "y1", "pressure": 100}, {"gravity": [0, 0, -9.81]}],
            "curves": {"there": [[0, 0], [1, 1], [2, 0.2]]}, "steps": [0.5, 1, 2], "probes": [{"name": "middle", "at": [0.02, 0.03, 0.05]}]}
    has_metis = "this build has no METIS" not in run(TRUTHCUBE, "--mesh", "none.msh", "--order", "metis")[2]
    linear = "--scene", "linear-elastic", "--preconditioner", "block-jacobi"
    for name, box, flags, count in (("plain", Box(13), (*SCENE, "--preconditioner", "block-jacobi"), 2), ("nested", Box(4), (*SCENE, "--refine", "2"), 3),
                                    ("linear", Box(13), linear, 3)):
        shuffled(box).write(FOLDER / f"{name}.msh")
        (FOLDER / f"{name}.json").write_text(json.dumps(case | {"mesh": f"{name}.msh"}))
        for order in ("mesh", "metis") if has_metis else ("mesh",):
            words = ("--case", str(FOLDER / f"{name}.json"), "--order", order, *flags, "--out")
            wanted, found = FOLDER / f"{name}_{order}_case", FOLDER / f"{name}_{order}_case_ranks"
            printed = without_times(done(0, TRUTHCUBE, *words, str(wanted)))
            again = done(0, MPIRUN, "--oversubscribe", "-n", str(count), TRUTHCUBE, *words, str(found))
            assert without_times(again) == printed, again
            files = {path.name for path in wanted.iterdir()}
            assert files == {path.name for path in found.iterdir()} == {"cube.vtkhdf", "cube.xdmf", "groups.csv", "probes.csv", "run.json"} | ({"order.h5"} if order == "metis" else set())
            for file in files - {"run.json"}:
                assert (found / file).read_bytes() == (wanted / file).read_bytes(), f"{file} of {found}"
            steps, ranks = case_record(found)
            assert steps == case_record(wanted)[0] and len(steps) == 3 and ranks["count"] == count and ranks["messages"] > 0, ranks
            heights = [row.split(",")[-1] for row in (found / "probes.csv").read_text().splitlines()[1:]]
            assert len(set(heights)) == 3, heights


def a_case_that_one_rank_cannot_read_ends_all():
    """Where one rank finds its command wrong that others take, all end with both; so they do where the case's contents are others, or a
    group of its mesh alone."""
    box = shuffled(Box(3))
    for name in ("with", "without", "changed", "regrouped"):
        (FOLDER / name).mkdir()
        if name == "regrouped":
            box.faces["x1"].pop()
        box.write(FOLDER / name / "m.msh")
    case = {"mesh": "m.msh", "material": {"young": 2e4, "poisson": 0.45}, "supports": [{"group": "z0"}]}
    for name in ("with", "regrouped"):
        (FOLDER / name / "c.json").write_text(json.dumps(case))
    (FOLDER / "changed" / "c.json").write_text(json.dumps(case | {"steps": [2]}))
    words = (TRUTHCUBE, *SCENE, "--case", "c.json", "--preconditioner", "block-jacobi")
    for other, said in (("without", r'rank 1 on \S+ has another error in its command: "[^"]*c.json[^"]*", and rank 0 has "none"'),
                        ("changed", r"rank 1 on \S+ has another case: "),
                        ("regrouped", r'rank 1 on \S+ has another set of groups in its mesh: "\d+", and rank 0 has "\d+"')):
        found, _, errors = run(MPIRUN, "--oversubscribe", "-n", "1", "-wdir", str(FOLDER / "with"), *words, ":", "-n", "1", "-wdir", str(FOLDER / other), *words)
        assert found == 1 and len(re.findall(said, errors)) == 1, (found, errors)


def a_mesh_that_one_rank_cannot_read_ends_all():
    """As where machines have folders of their own: it is named, with the rank and the remedy. So is a file with another mesh."""
    for name in ("has", "lacks", "other"):
        (FOLDER / name).mkdir()
    shuffled(Box(3)).write(FOLDER / "has" / "m.msh")
    shuffled(Box(4)).write(FOLDER / "other" / "m.msh")
    words = (TRUTHCUBE, *SCENE, "--mesh", "m.msh", "--preconditioner", "block-jacobi", "--compress", "0.05", "--out", "out")
    for other, said in (("lacks", r"rank 1 of 2 on \S+: cannot read the mesh m.msh: No such file or directory; each rank reads it, so put it where"),
                        ("other", r'rank 1 on \S+ has another mesh: "\d+", and rank 0 has "\d+"')):
        found, _, errors = run(MPIRUN, "--oversubscribe", "-n", "1", "-wdir", str(FOLDER / "has"), *words, ":", "-n", "1", "-wdir", str(FOLDER / other), *words)
        assert found == 1 and len(re.findall(said, errors)) == 1, (found, errors)
        assert not any((FOLDER / name / "out" / "checkpoint.h5").exists() for name in ("has", other))


run_and_remove(globals())
