"""ranks_runs.py over a program and a launcher that stand in for truthcube and mpirun."""
import json
import os
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
REPORT = pathlib.Path(__file__).resolve().parents[3] / "tools" / "report"
sys.path.insert(0, str(REPORT))
import solves_on_ranks  # noqa: E402

# Each run takes longer than the one before: 1, 2, 3, ... ms on one GPU, and a third of that on two.
TRUTHCUBE = """#!/usr/bin/env python3
import json, os, pathlib, sys
words = sys.argv[1:]
value = lambda flag: words[words.index(flag) + 1]
folder, ranks = pathlib.Path(value("--out")), int(os.environ.get("RANKS", "1"))
count = pathlib.Path(__file__).with_suffix(f".{ranks}")
run = int(count.read_text()) + 1 if count.exists() else 1
count.write_text(str(run))
folder.mkdir(exist_ok=True)
steps = [{"seconds": 1.0, "warm_seconds": 1.0, "newton_iterations": 1, "pcg_iterations": 1},
         {"seconds": 0.01 * run, "warm_seconds": 0.001 * run / (1 if ranks == 1 else 3), "newton_iterations": 2, "pcg_iterations": 12}]
record = {"device": "a GPU", "tets": 6 * int(value("--cells")) ** 3, "bytes": 1000, "setup_seconds": 0.5 * ranks, "steps": steps}
if ranks > 1:
    record["ranks"] = {"exchanges": 7, "gathers": 3, "bytes": 40, "gathered_bytes": 2}
(folder / "run.json").write_text(json.dumps(record))
"""
MPIRUN = """#!/bin/sh
[ "$1" = --oversubscribe ] && [ "$2" = -n ] || exit 1
RANKS=$3; export RANKS; shift 3; exec "$@"
"""


class RanksRuns(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        for name, text in (("truthcube", TRUTHCUBE), ("mpirun", MPIRUN)):
            file = pathlib.Path(self.folder.name) / name
            file.write_text(text)
            file.chmod(file.stat().st_mode | stat.S_IXUSR)
        self.out = pathlib.Path(self.folder.name) / "solves.json"

    def measure(self, *words):
        program = pathlib.Path(self.folder.name) / "truthcube"
        environment = {**os.environ, "PATH": f"{self.folder.name}:{os.environ['PATH']}"}
        return subprocess.run([sys.executable, REPORT / "ranks_runs.py", program, "-o", self.out, *words], env=environment, capture_output=True,
                              text=True, check=False)

    def test_times_are_medians_of_all_runs_and_the_table_divides_them(self):
        done = self.measure("--runs", "3", "4,0.45,tets", "8,0.49,patches,1")
        self.assertEqual(done.returncode, 0, done.stderr)
        file = json.loads(self.out.read_text())
        self.assertEqual(file["device"], "2 x a GPU")
        found = [(row["cells"], row["ranks"], row["runs"], row["seconds"], row["first_seconds"]) for row in file["rows"]]
        self.assertEqual(found, [(4, 1, 3, 0.002, 0.02), (4, 2, 3, 0.000667, 0.02), (8, 1, 1, 0.004, 0.04), (8, 2, 1, 0.001333, 0.04)])
        self.assertEqual([row.get("sent_bytes") for row in file["rows"]], [None, 42, None, 42])
        _, lines = solves_on_ranks.lines(file, "solves.json")
        self.assertEqual(lines[0], ["4^3, 0.45, tets", "0.0", "12", "2.0", "0.7", "3.00", "0.5 and 1.0"])

    def test_words_that_are_no_body_are_refused(self):
        for word in ("4,0.45", "4,0.45,tets,many", "4,0.45,tets,1,2"):
            done = self.measure(word)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(f"'{word}' is no body; write cells", done.stderr)
            self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
