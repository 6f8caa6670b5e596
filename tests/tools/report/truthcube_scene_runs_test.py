"""Tests of what scenes keep and take: scene_runs.py, and the table of its file: truthcube_scene_runs_test.py PROGRAM"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
REPORT = ROOT / "tools" / "report"
PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(REPORT))
from truthcube import scenes  # noqa: E402
from truthcube.records import RunError  # noqa: E402


def run(flags, total):
    return {"flags": flags, "tets": 100, "bytes": total, "seconds": 0.0125}


class SceneRunsTest(unittest.TestCase):
    def test_scalars_are_those_that_physgen_kept_between_steps(self):
        found = [scenes.scalars(ROOT, name, "") for name in scenes.ARRAYS]
        self.assertEqual(found, [0, 30, 0, 0, 19, 10])
        self.assertEqual(scenes.scalars(ROOT, "linear-elastic", "--product matrix-free"), 10)

    def test_the_table_has_a_line_for_each_scene(self):
        own, all_arrays = run("--scene matrix-free", 30900), run("--scene everything --precision float", 31000)
        rows = [{"scene": "matrix-free", "scalars": 30, "own": own, "everything": all_arrays}]
        rows.append({"scene": "explicit-dynamics", "scalars": 19, "own": run("--scene explicit-dynamics", 15540)})
        head, lines = scenes.lines({"scenes": rows}, "a.json")
        self.assertEqual(len(head), 6)
        self.assertEqual(lines[0], ["`matrix-free`", "30", "309.0", "310.0", "12.5", "12.5"])
        self.assertEqual(lines[1], ["`explicit-dynamics`", "19", "155.4", "", "12.5", ""])

    def test_what_was_not_timed_has_no_columns_of_times(self):
        own = {**run("--scene quasistatic", 59200), "seconds": None}
        head, lines = scenes.lines({"scenes": [{"scene": "quasistatic", "scalars": 0, "own": own}]}, "a.json")
        self.assertEqual(head[-1], "over arrays of `everything`")
        self.assertEqual(lines, [["`quasistatic`", "0", "592.0", ""]])

    def test_files_that_are_none_of_these_are_refused(self):
        def refused(content, words):
            with self.assertRaisesRegex(RunError, words):
                scenes.lines(content, "a.json")

        refused({}, "a.json: no list of 'scenes'; measure again with tools/report/scene_runs.py")
        refused({"scenes": [{"scene": "a", "scalars": 1}]}, r"a.json: scenes\[0\]")
        own = {**run("", 1), "bytes": "many"}
        refused({"scenes": [{"scene": "a", "scalars": 1, "own": own}]}, r"scenes\[0\].*bytes")

    def test_small_cubes_are_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "scenes.json"
            sizes = ["--cells", "2", "--bytes-cells", "4", "--repeats", "1"]
            command = [sys.executable, REPORT / "scene_runs.py", PROGRAM, "-o", out, *sizes]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = json.loads(out.read_text())["scenes"]
            _, lines = scenes.lines({"scenes": rows}, "scenes.json")
        self.assertEqual(len(lines), 7)
        for row in rows:
            self.assertEqual(row["own"]["tets"], 384)
            if "everything" in row:
                self.assertLessEqual(row["own"]["bytes"], row["everything"]["bytes"])
                self.assertIn("--scene everything", row["everything"]["flags"])
        self.assertEqual([row["scene"] for row in rows if "everything" in row], ["quasistatic", "matrix-free", "fixed-corotated"])


if __name__ == "__main__":
    unittest.main()
