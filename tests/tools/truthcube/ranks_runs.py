"""Runs of truthcube on several ranks, for tests that are called with MPIRUN|none TRUTHCUBE CASE."""
import json
import pathlib
import re
import shutil
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "runtime" / "distributed"))
from ranks import run, run_case  # noqa: E402

MPIRUN, TRUTHCUBE = sys.argv[1:3]
FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="ranks_"))
SCENE = ("--scene", "quasistatic", "--tolerance", "1e-4")
FILES = ("beads.csv", "cube.vtkhdf", "checkpoint.h5")


def command(ranks, *words):
    return [MPIRUN, "--oversubscribe", "-n", str(ranks), TRUTHCUBE, *SCENE, *words]


def done(status, *words):
    """The output of a command, which ends with this status."""
    found, output, errors = run(*words)
    assert found == status, f"status {found} of {words}: {output}{errors}"
    return output


def without_times(output):
    """Lines of a run, but those that ranks have besides and what says times and bytes."""
    lines = [line for line in output.splitlines() if not re.match(r" +rank .* machine$| +\d+( +\d+){7}  ", line)]
    return [re.sub(r" *\d+\.\d+ (s|MB)\b|\d+ bytes per node", "", line) for line in lines]


def said(output):
    """What is printed but for times, in lines of states, too, which end with the seconds that they took."""
    return [re.sub(r"^( +\S+ +0\.\d{5}( +\S+){7}) +\d+\.\d{3}\b", r"\1", line) for line in without_times(output)]


def record(folder):
    """run.json without times, and what of it tells of ranks."""
    run_json = json.loads((folder / "run.json").read_text())
    for step in run_json["steps"]:
        for line in (step, *step["newton"]):
            line.pop("seconds"), line.pop("warm_seconds", None)
    ranks = run_json.pop("ranks", None)
    return {key: run_json[key] for key in ("nodes", "tets", "settings", "held", "steps")}, ranks


def expect_same(wanted, found, names=FILES):
    for name in names:
        assert (found / name).read_bytes() == (wanted / name).read_bytes(), f"{name} of {found}"
    assert record(found)[0] == record(wanted)[0], f"{found}/run.json"


def run_and_remove(cases):
    """Ends with the status of the test that was asked for."""
    try:
        sys.exit(run_case(cases))
    finally:
        shutil.rmtree(FOLDER)
