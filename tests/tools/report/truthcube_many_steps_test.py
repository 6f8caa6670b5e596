"""Tests of the pictures of runs with many steps, and of motions: truthcube_many_steps_test.py PROGRAM"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(ROOT / "tools" / "report"))
import drawing  # noqa: E402
import numpy as np  # noqa: E402
import truthcube_pictures  # noqa: E402

from truthcube import body, convergence, files  # noqa: E402
from truthcube.records import RunError  # noqa: E402


class ManyStepsTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.made = pathlib.Path(self.temporary.name) / "run"

    def tearDown(self):
        self.temporary.cleanup()

    def truthcube(self, *arguments):
        subprocess.run([PROGRAM, "--threads", "1", "--quiet", *map(str, arguments), "--out", self.made], check=True)
        return files.read_run(self.made)

    def test_ten_steps_have_panels_that_are_apart_and_of_a_readable_size(self):
        loads = [round(0.015 * k, 3) for k in range(1, 11)]
        run = self.truthcube("--cells", 2, "--compress", *loads)
        for figure, repeats in ((body.steps(run, body.outside(run)), 2), (convergence.draw(run), 1)):
            panels = [axes for axes in figure.axes if axes.get_title(loc="center")]
            titles = [axes.get_title(loc="center") for axes in panels]
            self.assertEqual([titles.count(f"compressed by {100 * load:g} %") for load in loads], 10 * [repeats])
            figure.draw_without_rendering()
            boxes = [axes.get_window_extent() for axes in panels]
            boxes += [axes.title.get_window_extent() for axes in panels]  # which may lie in no panel, nor on another
            for k, box in enumerate(boxes):
                self.assertFalse(any(box.overlaps(other) for other in boxes[:k]), titles[k % len(titles)])
            self.assertGreater(min(box.width for box in boxes[: len(panels)]), 0.1 * figure.bbox.width)

    def test_of_very_many_steps_some_are_shown_and_the_last_of_them(self):
        for count, shown in ((13, 13), (14, 14), (15, 14), (100, 14)):
            found = files.Run({}, None, None, list(range(count)), {}).shown()
            self.assertEqual((len(set(found)), found[-1]), (shown, count - 1))
            self.assertEqual(found, sorted(found))

    def test_states_of_a_motion_have_pictures_and_beads_of_their_own(self):
        options = ["--scene", "implicit-dynamics", "--compress", 0.1, "--duration", 0.04, "--frames", 4]
        run = self.truthcube("--cells", 4, *options)
        self.assertEqual([step.compression for step in run.steps[1:]], 3 * [0.1])  # held from the middle on
        with open(self.made / "beads.csv", encoding="utf-8") as stream:
            rows = [[float(row[u]) for u in ("ux", "uy", "uz")] for row in csv.DictReader(stream)]
        np.testing.assert_array_equal(run.beads[0.1].displacement, rows[-343:])
        view = body.outside(run)
        first, second, third = (view.picture(step, body.VON_MISES, (0, 1e4)) for step in run.steps[1:])
        self.assertFalse((first == second).all() or (second == third).all())
        titles = [step.title() for step in run.steps]
        self.assertEqual(titles, [f"at {time} s, by {load} %" for time, load in
                                  ((0.01, 5), (0.02, 10), (0.03, 10), (0.04, 10))])  # fmt: skip
        self.assertIn("implicit-dynamics", run.title())
        with unittest.mock.patch.object(drawing, "png", lambda figure, *rest, **options: b""):  # their names alone
            drawn = truthcube_pictures._pictures(self.made, None)
        self.assertEqual(sorted(drawn), ["beads.png", "cut.png", "last_step.png", "surface.png"])  # no Newton steps
        record = json.loads((self.made / "run.json").read_text())
        record["steps"][2]["time"] = 0.5
        (self.made / "run.json").write_text(json.dumps(record))
        with self.assertRaisesRegex(RunError, "step 2 is of a time of 0.03, and in run.json of 0.5"):
            files.read_run(self.made)


if __name__ == "__main__":
    unittest.main()
