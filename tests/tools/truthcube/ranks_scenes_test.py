"""Scenes of truthcube on several ranks that move, or are linear elastic: ranks_scenes_test.py MPIRUN|none TRUTHCUBE CASE."""
import json
import os
import re
import shutil
import signal
import subprocess
import time

from ranks_runs import FOLDER, MPIRUN, TRUTHCUBE, done, expect_same, record, run_and_remove, said
from ranks import ENVIRONMENT, run  # behind ranks_runs, which says where it is


def command(count, *words):
    return [MPIRUN, "--oversubscribe", "-n", str(count), TRUTHCUBE, *words] if count > 1 else [TRUTHCUBE, *words]


def compare(name, files, cases):
    """Of runs that ranks share, files and what is printed."""
    for number, (counts, *words) in enumerate(cases):
        wanted = FOLDER / f"{name}_{number}"
        printed = said(done(0, *command(1, *words, "--out", str(wanted))))
        assert {path.name for path in wanted.iterdir()} >= set(files) and record(wanted)[0]["steps"], words
        print(words, "\n".join(printed))
        for count, *more in counts:
            found = FOLDER / f"{name}_{number}_{count}"
            again = said(done(0, *command(count, *words, *more, "--out", str(found))))
            assert again == printed, (words, count, again)
            expect_same(wanted, found, files)
            ranks = record(found)[1]
            assert ranks["count"] == count and min(ranks[what] for what in ("exchanges", "gathers", "messages", "bytes")) > 0, ranks


def motion_has_the_files_of_one_process():
    """By implicit steps, with multigrid over a mesh that is cut, too, and by explicit steps in either precision and other materials; what is
    seen at the end of a motion is another body than at its beginning."""
    compare("motion", ("beads.csv", "cube.vtkhdf"), (
        (((2,), (3, "--replicate", "1000")), "--scene", "implicit-dynamics", "--cells", "24", "--poisson", "0.49", "--compress", "0.1",
         "--duration", "0.02", "--frames", "2", "--time-step", "0.005", "--damping", "3"),
        (((3,),), "--scene", "implicit-dynamics", "--cells", "12", "--volume", "tets", "--preconditioner", "block-jacobi", "--compress", "0.1",
         "--duration", "0.01", "--frames", "2", "--time-step", "0.0025"),
        (((2,), (3,)), "--scene", "explicit-dynamics", "--cells", "16", "--compress", "0.05", "--duration", "0.01", "--frames", "3"),
        (((2,),), "--scene", "explicit-dynamics", "--cells", "8", "--precision", "double", "--material", "stable-neo-hookean", "--young", "2e4",
         "--compress", "0.1", "--duration", "0.02", "--frames", "2", "--output", "surface")))


def linear_elastic_bodies_have_the_files_of_one_process():
    """Assembled with multigrid, with matrices in half and as computed, and by tets."""
    linear = "--scene", "linear-elastic", "--compress", "0.02", "0.05"
    compare("linear", ("beads.csv", "cube.vtkhdf", "checkpoint.h5"), (
        (((2,), (3, "--replicate", "1000")), *linear, "--cells", "24"),
        (((2,),), *linear, "--cells", "12", "--precision", "double", "--tolerance", "1e-10", "--top", "frictionless"),
        (((3,),), *linear, "--cells", "16", "--product", "matrix-free", "--preconditioner", "block-jacobi", "--precision", "float")))


def a_linear_elastic_run_is_continued_on_any_number_of_ranks():
    """One that was begun on three is continued on one and on two, as if it had not ended."""
    linear = "--scene", "linear-elastic", "--cells", "16"
    wanted, begun = FOLDER / "wanted", FOLDER / "begun"
    done(0, *command(1, *linear, "--compress", "0.02", "0.05", "--out", str(wanted)))
    done(0, *command(3, *linear, "--compress", "0.02", "--out", str(begun)))
    for count in (1, 2):
        found = FOLDER / f"on_{count}"
        shutil.copytree(begun, found)
        output = done(0, *command(count, *linear, "--compress", "0.02", "0.05", "--out", str(found), "--restart"))
        assert output.count("continuing after step 1") == 1, output
        expect_same(wanted, found)


def a_dry_run_of_other_scenes_says_what_each_rank_has():
    """Bytes are those that a run takes, and the forecast is within a tenth; an explicit step has one exchange."""
    for scene, sent, *words in (("implicit-dynamics", "in a PCG iteration: 6 exchanges, 3 gathers", "--duration", "0.002", "--frames", "1"),
                                ("explicit-dynamics", "in a time step: 1 exchanges, 0 gathers", "--duration", "0.002", "--frames", "1"),
                                ("linear-elastic", "in a PCG iteration: 6 exchanges, 3 gathers")):
        words = "--scene", scene, "--cells", "24", "--compress", "0.02", *words
        out = FOLDER / scene
        output = done(0, *command(3, *words, "--dry-run", "--out", str(out)))
        print(output)
        parts = [list(map(int, line.split()[:8])) for line in output.splitlines() if re.match(r" +\d+( +\d+){7}  ", line)]
        assert not out.exists() and [part[0] for part in parts] == [0, 1, 2] and output.count(sent) == 1, output
        assert sum(part[1] for part in parts) == 25 ** 3 and sum(part[3] for part in parts) == 6 * 24 ** 3, parts
        forecast = int(re.search(r"^each of 3 ranks: about (\d+) bytes of the solver, and", output, re.M)[1])
        assert abs(forecast / max(part[6] for part in parts) - 1) < 0.1, (forecast, parts)
        done(0, *command(3, *words, "--out", str(out)))
        assert json.loads((out / "run.json").read_text())["bytes"] == sum(part[6] for part in parts), parts


def a_motion_that_is_not_finite_is_said_once():
    """The first rank alone sees the stresses; all end with one process's status and words."""
    words = "--scene", "explicit-dynamics", "--cells", "6", "--compress", "0.5", "--duration", "0.5", "--frames", "2"
    stable = re.search(r"about (\S+) s,", run(*command(1, *words, "--time-step", "1"))[2])[1]
    status, _, errors = run(*command(1, *words, "--time-step", stable))
    assert status == 3 and "the motion is not finite" in errors, (status, errors)
    found, _, again = run(*command(2, *words, "--time-step", stable))
    assert found == 3 and all(again.count(line) == 1 for line in errors.splitlines()), (errors, again)


def an_interrupt_of_one_rank_ends_a_motion():
    """All ranks end behind a time step; files have the states that are done."""
    out = FOLDER / "long"
    process = subprocess.Popen(command(3, "--scene", "explicit-dynamics", "--cells", "12", "--duration", "1000", "--frames", "100000", "--out", str(out)),
                               env=ENVIRONMENT, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    until = time.monotonic() + 60
    while not (out / "run.json").exists() or not json.loads((out / "run.json").read_text())["steps"]:
        assert time.monotonic() < until and process.poll() is None, process.communicate()
        time.sleep(0.05)
    children = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)], capture_output=True, text=True, check=True).stdout.split()
    os.kill(int(children[1]), signal.SIGINT)
    output, errors = process.communicate(timeout=30)
    steps = json.loads((out / "run.json").read_text())["steps"]
    assert process.returncode == 130 and re.findall(r"^interrupted; (\d+) states are written$", output, re.M) == [str(len(steps))], (output, errors)
    assert len((out / "beads.csv").read_text().splitlines()) == len(steps) * 343 + 1


run_and_remove(globals())
