"""States that several ranks print and write by windows far smaller than the mesh: ranks_windows_test.py MPIRUN|none TRUTHCUBE CASE."""
import json

from case_bodies import Box
from ranks_bodies import case_record, shuffled
from ranks_runs import FOLDER, MPIRUN, SCENE, TRUTHCUBE, command, done, expect_same, run_and_remove, said, without_times
from ranks import run  # behind ranks_runs, which says where it is

# 1171 nodes or 292 tets at once; then a node or a tet.
SMALL, SMALLEST = ("--window", "300000"), ("--window", "1")


def windows_far_smaller_than_the_mesh_write_the_files_of_one_window():
    """Of a cube whose 4913 nodes and 24576 tets, of any of three ranks, take many windows; of its surface, and of a restart. What is printed
    is the same, too: beads, how far sides reach, and estimates are of windows as well."""
    for output, count, window in (("body", 3, SMALL), ("surface", 2, SMALL), ("body", 1, SMALL)):
        words = ("--cells", "16", "--output", output, "--poisson", "0.49")
        both, first = ("--compress", "0.1", "0.2", "--out"), ("--compress", "0.1", "--out")
        wanted, found = FOLDER / f"{output}_{count}", FOLDER / f"{output}_{count}_by_windows"
        printed = without_times(done(0, TRUTHCUBE, *SCENE, *words, *both, str(wanted)))
        text = "\n".join(printed)
        assert "estimated from half as many cells" in text, text
        assert without_times(done(0, *command(count, *words, *window, *both, str(found)))) == printed
        expect_same(wanted, found)
        if count < 3:
            continue
        again = FOLDER / f"{output}_{count}_again"
        done(0, *command(count, *words, *window, *first, str(again)))
        done(0, *command(count, *words, *window, *both, str(again), "--restart"))
        expect_same(wanted, again)


def windows_of_a_node_and_of_a_tet_write_the_files_of_one_window():
    words = ("--cells", "4", "--volume", "tets", "--preconditioner", "block-jacobi", "--compress", "0.05", "--out")
    wanted, found = FOLDER / "wanted", FOLDER / "smallest"
    done(0, TRUTHCUBE, *SCENE, *words, str(wanted))
    done(0, *command(2, *SMALLEST, *words, str(found)))
    expect_same(wanted, found)


def cases_write_the_files_of_one_window():
    """Of nodes and tets in any order, in which the rows of a window are owned by all ranks by turns; the body, and its surface."""
    case = {"mesh": "m.msh", "material": {"young": 2e4, "poisson": 0.45}, "supports": [{"group": "z0"}], "loads": [{"group": "z1", "traction": [0, 30, -400]}],
            "steps": [0.5, 1], "probes": [{"name": "middle", "at": [0.02, 0.03, 0.05]}]}
    shuffled(Box(13)).write(FOLDER / "m.msh")
    has_metis = "this build has no METIS" not in run(TRUTHCUBE, "--mesh", "none.msh", "--order", "metis")[2]
    for output in ("body", "surface"):
        (FOLDER / f"{output}.json").write_text(json.dumps(case | {"output": output}))
        for order in ("mesh", "metis") if has_metis else ("mesh",):
            words = ("--case", str(FOLDER / f"{output}.json"), "--order", order, *SCENE, "--preconditioner", "block-jacobi", "--out")
            wanted, found = FOLDER / f"{output}_{order}", FOLDER / f"{output}_{order}_by_windows"
            printed = without_times(done(0, TRUTHCUBE, *words, str(wanted)))
            by_windows = done(0, MPIRUN, "--oversubscribe", "-n", "3", TRUTHCUBE, *SMALL, *words, str(found))
            assert without_times(by_windows) == printed, by_windows
            for file in ("cube.vtkhdf", "cube.xdmf", "groups.csv", "probes.csv"):
                assert (found / file).read_bytes() == (wanted / file).read_bytes(), f"{file} of {found}"
            assert case_record(found)[0] == case_record(wanted)[0] and len(case_record(found)[0]) == 2


def the_tet_that_is_deformed_most_is_found_by_windows():
    """Of a motion, whose smallest J is that of this tet, and of one whose tets are inverted, or not finite, which is said with its number."""
    scene = ("--scene", "explicit-dynamics", "--cells", "8", "--frames", "2")
    for name, status, flags in (("moved", 0, ("--duration", "0.004", "--compress", "0.05")),
                                ("not_finite", 3, ("--duration", "0.4", "--compress", "0.9", "--time-step", "1.7e-4", "--young", "3e4"))):
        results = []
        for count, window in ((1, ()), (2, SMALL)):
            out = FOLDER / f"{name}_{count}"
            found, output, errors = run(MPIRUN, "--oversubscribe", "-n", str(count), TRUTHCUBE, *scene, *flags, *window, "--out", str(out))
            assert found == status, (found, output, errors)
            results.append((said(output), errors.splitlines()[:1]))
            if status == 0:
                expect_same(FOLDER / f"{name}_1", out, ("cube.vtkhdf", "beads.csv"))
        assert results[0] == results[1], results


run_and_remove(globals())
