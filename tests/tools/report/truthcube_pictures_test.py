"""Tests of the pictures of truthcube's runs and of truthcube_runs.py: truthcube_pictures_test.py PROGRAM. What is drawn
is compared with the files of a run, read here in other ways."""
import contextlib
import io
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
REPORT = ROOT / "tools" / "report"
PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(REPORT))
import drawing  # noqa: E402
import h5py  # noqa: E402
import matplotlib.quiver  # noqa: E402
import numpy as np  # noqa: E402
import truthcube_pictures  # noqa: E402
from truthcube_tables import area, kuhn_cube, rms_mm, table  # noqa: E402

from truthcube import arrows, beads, body, convergence, files, geometry, render  # noqa: E402

ORACLE = ROOT / "tests/fem/solver/oracle/0.49_bonded_0.125.csv"


def command(*arguments):
    """truthcube_pictures.py in this process: its exit status, and what it said."""
    said = io.StringIO()
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
        try:
            status = truthcube_pictures.main([str(argument) for argument in arguments])
        except SystemExit as end:  # of wrong use
            status = end.code
    return status, said.getvalue()


def truthcube(folder, *arguments):
    done = subprocess.run(
        [PROGRAM, "--threads", "1", *map(str, arguments), "--out", str(folder)], capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise AssertionError(done.stderr)
    return done.stdout


class PicturesTest(unittest.TestCase):
    """A run of 8^3 cells, made once."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.made = cls.folder / "run"
        cls.printed = truthcube(cls.made, "--cells", 8, "--compress", 0.05, 0.125, "--beads", ORACLE)
        cls.run_ = files.read_run(cls.made)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def copy(self):
        shutil.rmtree(self.folder / "copy", ignore_errors=True)
        return pathlib.Path(shutil.copytree(self.made, self.folder / "copy"))

    # ---- What is drawn is what the files say -----------------------------------------------------------------------
    def test_von_mises_stress_of_known_tensors(self):
        known = {  # xx yy zz xy yz xz
            (3, 0, 0, 0, 0, 0): 3,
            (0, 0, 0, 2, 0, 0): 2 * math.sqrt(3),
            (0, 0, 0, 0, 2, 0): 2 * math.sqrt(3),
            (5, 5, 5, 0, 0, 0): 0,
            (4, 4, 0, 0, 0, 0): 4,
            (1, -2, 3, 1, 2, -1): math.sqrt(0.5 * (9 + 25 + 4) + 3 * 6),
        }
        np.testing.assert_allclose(files.von_mises(np.array(list(known), float)), list(known.values()), atol=1e-12)

    def test_von_mises_stress_is_that_of_the_file(self):
        with h5py.File(self.made / "cube.vtkhdf") as file:
            written = file["VTKHDF/CellData/von_mises"][...]
        drawn = np.concatenate([step.von_mises for step in self.run_.steps])
        np.testing.assert_allclose(drawn, written, rtol=2e-4, atol=1e-3 * written.max())

    def test_averages_at_nodes_keep_a_constant_and_the_integral(self):
        np.testing.assert_allclose(self.run_.at_nodes(np.full(len(self.run_.tets), 7.0)), 7)
        alone = np.zeros(len(self.run_.tets))
        alone[0] = 1
        around = [(self.run_.tets == node).any(axis=1).sum() for node in self.run_.tets[0]]  # tets of equal volume
        np.testing.assert_allclose(self.run_.at_nodes(alone)[self.run_.tets[0]], 1 / np.array(around))

    def test_colours_of_displacement_end_at_the_largest_of_the_file(self):
        with h5py.File(self.made / "cube.vtkhdf") as file:
            written = file["VTKHDF/PointData/displacement"][...].astype(float)
        largest = 1e3 * np.sqrt((written**2).sum(axis=1)).max()
        low, high, _ = body.DISPLACEMENT.range(self.run_, self.run_.steps)
        self.assertEqual(low, 0)
        self.assertAlmostEqual(high, largest, places=9)

    def test_difference_of_beads_is_that_of_the_tables_and_of_the_program(self):
        wanted = rms_mm(table(self.made / "beads.csv", 0.125), table(ORACLE))
        here, there = beads.at_compression(self.run_.beads, 0.125), beads.at_compression(beads.read_beads(ORACLE), 0.125)
        self.assertAlmostEqual(beads.rms_mm(here.less(there)), wanted, places=12)
        printed = re.findall(r"RMS ([\d.]+)", self.printed)[-1]
        self.assertEqual(f"{wanted:.4f}", printed)
        figure = arrows.draw(self.run_, self.run_.steps[1], there, "reference")
        self.assertTrue(any(f"RMS {wanted:.3f}," in axes.get_xlabel() for axes in figure.axes))

    def test_arrows_of_the_middle_plane_are_the_displacements_there(self):
        figure = arrows.draw(self.run_, self.run_.steps[1])
        drawn = next(part for part in figure.axes[1].collections if isinstance(part, matplotlib.quiver.Quiver))
        rows = [row for row in table(self.made / "beads.csv", 0.125) if abs(row["y"] - 0.04) < 1e-9]
        self.assertEqual(len(rows), 49)
        np.testing.assert_allclose(drawn.XY, [[1e3 * row["x"], 1e3 * row["z"]] for row in rows])
        np.testing.assert_allclose(np.column_stack([drawn.U, drawn.V]), [[1e3 * row["ux"], 1e3 * row["uz"]] for row in rows])

    def test_convergence_is_that_of_the_record(self):
        record = json.loads((self.made / "run.json").read_text())
        figure = convergence.draw(self.run_)
        for axes, step in zip(figure.axes, record["steps"]):
            drawn = [point for line in axes.lines if line.get_marker() == "o" for point in line.get_xydata()]
            wanted = [[number, newton["residual"]] for number, newton in enumerate(step["newton"], 1)]
            np.testing.assert_array_equal(drawn, wanted)
            finest = [newton for newton in step["newton"] if newton["coarser_by"] == 0]
            self.assertEqual(len(finest), step["newton_iterations"])
            self.assertEqual(finest[-1]["residual"], step["residual"])

    # ---- Geometry and images ---------------------------------------------------------------------------------------
    def test_the_surface_of_a_cube_is_closed_and_of_its_area(self):
        points, tets = kuhn_cube(3)
        triangles = geometry.surface(tets)
        self.assertEqual(len(triangles), 6 * 9 * 2)
        self.assertAlmostEqual(area(points, triangles), 6)
        edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        self.assertTrue((np.unique(edges, axis=0, return_counts=True)[1] == 2).all())

    def test_a_cut_has_the_area_of_the_plane_and_values_of_the_body(self):
        for cells, place in ((4, 0.5), (3, 0.5), (4, 0.3)):  # through nodes, and between them
            points, tets = kuhn_cube(cells)
            edges, share, triangles = geometry.cut(points, tets, 1, place)
            corners = geometry.on_edges(points, edges, share)
            np.testing.assert_allclose(corners[:, 1], place, atol=1e-8)
            self.assertAlmostEqual(area(corners, triangles), 1, places=6)
            linear = points @ [1.0, 2.0, 3.0]
            np.testing.assert_allclose(geometry.on_edges(linear, edges, share), corners @ [1.0, 2.0, 3.0], atol=1e-8)

    def test_values_at_a_pixel_are_those_of_the_point_that_is_seen_there(self):
        points, tets = kuhn_cube(2)
        for camera in (render.perspective([0.5] * 3, 1.0), render.along_y([0.5] * 3)):
            window = (-1.0, 1.0, -0.9, 0.9)
            seen = render.look(camera, points, geometry.surface(tets), points, window, 40, closed=camera.distance < 99)
            rows, columns = np.nonzero(seen.triangle >= 0)
            self.assertGreater(len(rows), 500)
            pitch = 2.0 / (40 * render.SUPERSAMPLE)
            centres = np.column_stack([-1 + (columns + 0.5) * pitch, 0.9 - (rows + 0.5) * pitch])
            np.testing.assert_allclose(camera.project(seen.values[rows, columns])[0], centres, atol=1e-9)
            np.testing.assert_allclose(np.abs(seen.values[rows, columns] - 0.5).max(axis=1), 0.5)  # on the surface

    def test_what_is_nearer_hides_what_is_behind(self):
        camera = render.along_y([0, 0, 0])
        points = np.array([[-1, y, z] if k == 0 else [1, y, z] for y in (2, 1) for k, z in ((0, -1), (1, -1), (1, 1))], float)
        for triangles in (np.array([[0, 1, 2], [3, 4, 5]]), np.array([[3, 4, 5], [0, 1, 2]])):
            seen = render.look(camera, points, triangles, points, (-1.0, 1.0, -1.0, 1.0), 20)
            np.testing.assert_allclose(seen.values[seen.triangle >= 0][:, 1], 1)

    # ---- The command -----------------------------------------------------------------------------------------------
    def test_the_command_draws_all_pictures_the_same_on_every_run(self):
        names = ["beads.png", "convergence.png", "cut.png", "last_step.png", "surface.png"]
        tool = [sys.executable, REPORT / "truthcube_pictures.py", self.made, "-o", self.folder / "first"]
        done = subprocess.run(tool, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(command(self.made, "-o", self.folder / "second"), (0, ""))
        for out in ("first", "second"):
            self.assertEqual(sorted(path.name for path in (self.folder / out).iterdir()), names)
        for name in names:
            self.assertEqual(*((self.folder / out / name).read_bytes() for out in ("first", "second")), name)
        record = json.loads((self.made / "run.json").read_text())
        self.assertIn(record["command"].encode(), (self.folder / "first" / "last_step.png").read_bytes())

    # ---- What is refused -------------------------------------------------------------------------------------------
    def refused(self, folder, *words, more=()):
        out = self.folder / "refused"
        status, said = command(folder, "-o", out, *more)
        self.assertEqual(status, 2, said)
        for word in words:
            self.assertIn(word, said)
        self.assertFalse(out.exists())

    def test_records_that_are_none_are_refused_with_the_place(self):
        self.refused(self.folder / "absent", "absent/run.json: No such file")
        folder = self.copy()
        (folder / "run.json").write_text("{")
        self.refused(folder, "run.json: not JSON")
        (folder / "run.json").write_bytes(b"\xff\xfe\xff")
        self.refused(folder, "run.json: not text")
        whole = json.loads((self.made / "run.json").read_text())

        def changed(change, *words):
            record = json.loads(json.dumps(whole))
            change(record)
            (folder / "run.json").write_text(json.dumps(record))
            self.refused(folder, *words)

        changed(lambda r: r.pop("tets"), "has no 'tets'; run truthcube --out DIR")
        changed(lambda r: r["steps"][1].pop("newton"), "steps[1] has no 'newton'")
        changed(lambda r: r["steps"][0]["newton"][2].update(residual="small"), "steps[0].newton[2]: 'residual' is \"small\"")
        changed(lambda r: r["settings"].update(poisson="soft"), "settings: 'poisson' is \"soft\"")
        changed(lambda r: r.update(nodes=7), "729 nodes and 3072 tets, and run.json beside it 7", "not of one run")
        changed(lambda r: r["steps"][1].update(compression=0.13), "step 1 is of a compression of 0.125", "0.13")
        changed(lambda r: r["steps"].append(r["steps"][0]), "has 2 steps, and run.json 3")
        changed(lambda r: r["steps"].clear(), "no steps yet")

    def test_fields_that_are_none_are_refused_with_the_place(self):
        folder = self.copy()
        path = folder / "cube.vtkhdf"
        path.write_bytes(path.read_bytes()[:5000])
        self.refused(folder, "cube.vtkhdf: cannot be read as HDF5", "run truthcube")
        path.unlink()
        self.refused(folder, "cube.vtkhdf: No such file")
        folder = self.copy()
        with h5py.File(path, "r+") as file:
            file["VTKHDF/Connectivity"][5] = 729
        self.refused(folder, "Connectivity is empty or names nodes that are not there")
        with h5py.File(path, "r+") as file:
            del file["VTKHDF/CellData/stress"]
            file["VTKHDF/Connectivity"][5] = 0
        self.refused(folder, "has no VTKHDF/CellData/stress")

    def test_tables_that_are_none_are_refused_with_the_line(self):
        lines = (self.made / "beads.csv").read_text().splitlines()

        def refused(change, *words):
            other = list(lines)
            change(other)
            path = self.folder / "table.csv"
            path.write_text("\n".join(other) + "\n")
            self.refused(self.made, *words, more=["--beads", path])

        def cell(line, column, text):
            def change(other):
                cells = other[line].split(",")
                cells[column] = text
                other[line] = ",".join(cells)

            return change

        refused(cell(4, 3, "near"), "table.csv:5: 'near' in the column z")
        refused(cell(4, 3, "nan"), "table.csv:5: 'nan' in the column z")
        refused(cell(0, 3, "w"), "table.csv:1: the columns are not x,y,z")
        refused(lambda other: other.__setitem__(9, "1,2"), "table.csv:10: 2 cells in a table of 7 columns")
        refused(lambda other: other.__delitem__(slice(1, None)), "table.csv: has no rows")
        refused(lambda other: other.__delitem__(slice(344, None)), "no beads of a compression of 0.125")
        refused(lambda other: other.pop(), "343 beads cannot be compared with 342")
        refused(cell(-1, 1, "0.0701"), "bead 342 is at (0.07")
        self.refused(self.made, "gone.csv: No such file", more=["--beads", self.folder / "gone.csv"])

    def test_runs_without_beads_are_drawn_and_not_compared(self):
        folder = self.copy()
        (folder / "beads.csv").unlink()
        self.refused(folder, "has no beads.csv to compare", more=["--beads", ORACLE])
        record = json.loads((folder / "run.json").read_text())
        del record["settings"]["cells"]  # as of a mesh of one's own
        record["steps"] = record["steps"][:1]  # and a run that is going on
        (folder / "run.json").write_text(json.dumps(record))
        with unittest.mock.patch.object(drawing, "png", lambda figure, *rest, **options: b""):  # which take its time
            self.assertEqual(command(folder, "-o", self.folder / "mesh"), (0, ""))
        self.assertEqual(len(list((self.folder / "mesh").iterdir())), 4)

    def test_wrong_use_exits_with_2(self):
        for arguments in ([], [self.made], ["--errors", "a", "-o", "b", "--beads", "c"]):
            self.assertEqual(command(*arguments)[0], 2)
        status, said = command(self.made, "-o", self.made / "run.json" / "below")
        self.assertEqual(status, 2)
        self.assertIn("cannot write", said)


if __name__ == "__main__":
    unittest.main()
