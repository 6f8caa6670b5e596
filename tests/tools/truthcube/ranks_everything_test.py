"""The scene everything of truthcube on several ranks: ranks_everything_test.py MPIRUN|none TRUTHCUBE CASE."""
import json
import re

from case_bodies import Box
from ranks_bodies import case_record, shuffled
from ranks_runs import FOLDER, MPIRUN, TRUTHCUBE, done, expect_same, record, run_and_remove, without_times
from ranks import run  # behind ranks_runs, which says where it is


def on(count, *words):
    """The command on so many ranks, or as one process."""
    return ([MPIRUN, "--oversubscribe", "-n", str(count)] if count > 1 else []) + [TRUTHCUBE, *words]


def the_default_scene_has_the_files_of_one_process():
    """Without --scene, between plates that are held or that push: also of a run that goes on on another number of ranks."""
    for name, counts, first, last, *words in (
            ("default", (2, 3), "0.05", "0.1", "--cells", "16"), ("contact", (2, 3), "0.2", "0.42", "--cells", "16", "--plates", "contact"),
            ("float", (2,), "0.2", "0.42", "--scene", "everything", "--cells", "24", "--precision", "float", "--material", "mooney-rivlin",
             "--volume", "tets", "--poisson", "0.4", "--plates", "contact")):
        words = (*words, "--tolerance", "1e-4")
        cut = ("--replicate", "1000") if name == "float" else ()  # the mesh of 12^3 cells, too
        wanted = FOLDER / name
        printed = without_times(done(0, *on(1, *words, "--compress", first, last, "--out", str(wanted))))
        assert len(record(wanted)[0]["steps"]) == 2
        pushes = "the lower one pushes them back with" in "\n".join(printed)
        assert pushes == ("contact" in words), printed
        for count in counts:
            found = FOLDER / f"{name}_{count}"
            assert without_times(done(0, *on(count, *words, *cut, "--compress", first, last, "--out", str(found)))) == printed, f"{count} ranks"
            expect_same(wanted, found)
            assert record(found)[1]["count"] == count and record(found)[1]["messages"] > 0
        for begins, ends in ((2, 3), (3, 1)):
            begun = FOLDER / f"{name}_on_{begins}_and_{ends}"
            done(0, *on(begins, *words, "--compress", first, "--out", str(begun)))
            done(0, *on(ends, *words, "--compress", first, last, "--out", str(begun), "--restart"))
            expect_same(wanted, begun)


def parts_of_a_first_step_have_the_files_of_one_process():
    """Where the first step of a load would turn tets over, parts of it are taken, and the rest behind them."""
    words = ("--cells", "16", "--grading", "1.8", "--poisson", "0.4999", "--stepping", "loads", "--tolerance", "1e-2", "--compress", "0.15", "--out")
    wanted, found = FOLDER / "parts", FOLDER / "parts_ranks"
    printed = without_times(done(0, *on(1, *words, str(wanted))))
    assert re.search(r"^ +1 .*shortened", "\n".join(printed), re.M), printed
    assert without_times(done(0, *on(2, *words, str(found)))) == printed
    expect_same(wanted, found)


def meshes_and_cases_have_the_files_of_one_process():
    """On a background grid, in a law of the case, in several materials, and with coarser meshes."""
    shuffled(Box(13)).write(FOLDER / "mesh.msh")
    words = ("--mesh", str(FOLDER / "mesh.msh"), "--plates", "contact", "--compress", "0.03", "0.06")
    wanted, found = FOLDER / "mesh", FOLDER / "mesh_ranks"
    assert "background grid" in done(0, *on(1, *words, "--out", str(wanted)))
    done(0, *on(3, *words, "--out", str(found)))
    expect_same(wanted, found, ("cube.vtkhdf", "checkpoint.h5"))
    case = {"mesh": "case.msh", "material": {"law": "neo-hookean", "young": 2e4, "poisson": 0.45, "density": 1000}, "supports": [{"group": "z0"}],
            "loads": [{"group": "z1", "traction": [0, 30, -400]}, {"gravity": [0, 0, -9.81]}], "steps": [0.5, 1]}
    groups = [{"group": "far", "young": 5e4, "poisson": 0.3}]
    for name, box, flags, more in (("plain", Box(12), (), {}), ("nested", Box(4), ("--refine", "2"), {}),
                                   ("materials", Box(13), (), {"groups": groups}), ("nested_materials", Box(4), ("--refine", "2"), {"groups": groups})):
        shuffled(box).write(FOLDER / "case.msh")
        (FOLDER / "case.json").write_text(json.dumps(case | {"material": case["material"] | more}))
        words = ("--case", str(FOLDER / "case.json"), *flags, "--out")
        wanted, found = FOLDER / f"{name}_case", FOLDER / f"{name}_case_ranks"
        printed = without_times(done(0, *on(1, *words, str(wanted))))
        assert without_times(done(0, *on(2, *words, str(found)))) == printed
        for file in ("cube.vtkhdf", "groups.csv"):
            assert (found / file).read_bytes() == (wanted / file).read_bytes(), f"{file} of {found}"
        assert case_record(found)[0] == case_record(wanted)[0] and len(case_record(found)[0]) == 2


def what_one_process_alone_has_of_it_is_refused():
    """By the flag or the place in the case, with the remedy, once, before anything is made or written."""
    out = FOLDER / "refused"
    shuffled(Box(3)).write(FOLDER / "case.msh")
    case = {"mesh": "case.msh", "material": {"young": 2e4, "poisson": 0.45}, "supports": [{"group": "z0"}]}
    (FOLDER / "follows.json").write_text(json.dumps(case | {"loads": [{"group": "z1", "pressure": 100, "follows": True}]}))
    axis = {"supports": [{"group": "z0"}, {"group": "z1", "axis": [1, 1, 0]}], "loads": [{"group": "z1", "traction": [0, 0, -1]}]}
    (FOLDER / "axis.json").write_text(json.dumps(case | axis))
    of_axis = r"supports along other axes than x, y and z \(supports of the case \S*axis.json\); turn the mesh so that they lie along these, and write \"fixed\""
    end = ", or start one process, without mpirun"
    for words, said in (
            (("--precision", "double"), "--precision double; write --precision float" + end),
            (("--volume", "nodes"), "--volume nodes; write --volume patches" + end),
            (("--preconditioner", "schwarz"), "--preconditioner schwarz; write --preconditioner multigrid" + end),
            (("--product", "matrix-free", "--preconditioner", "block-jacobi"), "--product matrix-free of --scene everything"),
            (("--case", str(FOLDER / "axis.json")), of_axis + end),
            (("--case", str(FOLDER / "axis.json"), "--scene", "quasistatic", "--preconditioner", "block-jacobi"), of_axis + end),
            (("--case", str(FOLDER / "follows.json")), r"pressures that follow the surface \(loads of the case \S*follows.json\); remove \"follows\"" + end)):
        status, output, errors = run(*on(2, *words, "--out", str(out)))
        assert status == 1 and not output and not out.exists(), (words, status, output, errors)
        assert len(re.findall("several ranks do not have " + said, errors)) == 1, (words, errors)


run_and_remove(globals())
