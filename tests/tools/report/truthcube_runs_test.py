"""Tests of what is made of many runs of truthcube: the plot of error against time, the ratio table, and truthcube_runs.py:
truthcube_runs_test.py PROGRAM"""
import csv
import json
import math
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
from truthcube import bead_errors, error_against_time, layouts, linear_solves  # noqa: E402
from truthcube.records import RunError  # noqa: E402

CHECKED_IN = REPORT / "results" / "truthcube" / "errors.json"


def beads_of(path):
    with open(path, encoding="utf-8") as stream:
        return [[float(row[name]) for name in ("ux", "uy", "uz")] for row in csv.DictReader(stream)]


class RunsTest(unittest.TestCase):
    """Runs of 4^3 cells, made once by the command."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.made = cls.folder / "errors.json"
        options = ["--errors", "--device", "cpu", "--threads", "1", "--cells", "4", "2"]
        cls.done = subprocess.run(
            [sys.executable, REPORT / "truthcube_runs.py", PROGRAM, "-o", cls.made, *options, "--preconditioners", "block-jacobi"],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        cls.content = json.loads(cls.made.read_text()) if cls.done.returncode == 0 else None

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_the_runs_are_the_grid(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))
        found = {
            (run["settings"]["volume"], run["settings"]["cells"], run["steps"][0]["compression"])
            for run in self.content["runs"]
        }
        wanted = {(v, n, c) for v in ("tets", "patches") for n in (4, 2) for c in (0.05, 0.125, 0.1825)}
        self.assertEqual((found, len(self.content["runs"])), (wanted, len(wanted)))
        self.assertRegex(self.content["machine"], ", 1 thread(, beside other work)?$")
        for run in self.content["runs"]:
            self.assertNotIn("newton", run["steps"][0])

    def test_errors_are_those_of_the_beads_of_such_a_run(self):
        for run in self.content["runs"]:
            if run["settings"]["cells"] != 4:
                continue
            compression = run["steps"][0]["compression"]
            again = self.folder / "again"
            subprocess.run([PROGRAM, *run["command"].split()[1:], "--quiet", "--out", again], check=True)
            reference = ROOT / "tests/fem/solver/oracle" / f"0.49_bonded_{compression:g}.csv"
            lengths = [math.dist(a, b) for a, b in zip(beads_of(again / "beads.csv"), beads_of(reference))]
            self.assertEqual(len(lengths), 343)
            said = run["steps"][0]["beads"]
            self.assertEqual(said["reference"], reference.relative_to(ROOT).as_posix())
            self.assertAlmostEqual(said["rms_mm"], 1e3 * math.sqrt(sum(e * e for e in lengths) / 343), places=6)
            self.assertAlmostEqual(said["max_mm"], 1e3 * max(lengths), places=6)

    def test_the_preconditioners_are_those_that_the_program_has(self):
        listed = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout
        script = "import sys; sys.path.insert(0, sys.argv[1]); import truthcube_runs; print(*truthcube_runs.offered(sys.argv[2]))"
        done = subprocess.run([sys.executable, "-c", script, REPORT, PROGRAM], capture_output=True, text=True, check=True)
        offered = done.stdout.split()
        self.assertIn("multigrid", offered)
        self.assertEqual("schwarz" in offered, "schwarz" in listed.split("--preconditioner", 1)[1].split("}")[0])
        self.assertNotIn("none", offered)

    def test_a_run_that_fails_is_kept_with_its_reason(self):
        out = self.folder / "failed.json"
        tool = [sys.executable, REPORT / "truthcube_runs.py", PROGRAM, "-o", out, "--errors", "--device", "cpu"]
        done = subprocess.run([*tool, "--cells", "0"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        run = json.loads(out.read_text())["runs"][0]
        self.assertEqual(run["status"], 2)
        self.assertIn("Value 0 not in range", run["failed"])
        with self.assertRaisesRegex(RunError, "failed.json: all runs failed"):
            error_against_time.read(out)

    def test_meshes_have_a_line_each_with_reactions_against_the_reference(self):
        runs = [json.loads(json.dumps(run)) for run in self.content["runs"][:3]]  # 4 cells, tets
        for run in runs:
            run["settings"]["preconditioner"] = "multigrid"
        runs[2]["steps"][0].update(reaction=-17.108e-4 * 15000 * 1.02, reaction_estimate=-17.108e-4 * 15000 * 0.99)
        head, lines = bead_errors.lines({"runs": [*runs, *self.content["runs"]]}, "a.json")
        self.assertEqual(head[:3], ["upper plate, nu, volume by", "cells", "beads at 5 % [mm RMS]"])
        self.assertEqual(head[5:], ["reaction of the mesh at 18.25 %", "extrapolated", "solved at 18.25 % in"])
        beads = [f"{run['steps'][0]['beads']['rms_mm']:.3f}" for run in runs]
        self.assertEqual(len(lines), 1)
        self.assertEqual(lines[0][:-1], ["bonded, 0.49, tets", "4³", *beads, "+2.0 %", "-1.0 %"])

        def refused(content, words):
            with self.assertRaisesRegex(RunError, words):
                bead_errors.lines(content, "a.json")

        refused({"runs": []}, "a.json: no list of 'runs'; measure again with tools/report/truthcube_runs.py --errors")
        refused({"runs": [runs[0], runs[0]]}, r"a.json: runs\[1\]: such a run is there already")
        refused(self.content, "a.json: no run by multigrid")
        refused({"runs": [{"failed": "no equilibrium"}]}, r"runs\[0\] failed: no equilibrium")

    def test_beads_may_be_compared_with_those_of_a_finer_mesh(self):
        made, tool = self.folder / "finest.json", [sys.executable, REPORT / "truthcube_runs.py", PROGRAM]
        options = ["--errors", "--device", "cpu", "--threads", "1", "--preconditioners", "multigrid", "--cells", "2", "4"]
        options += ["--poisson", "0.499", "--compressions", "0.05", "--tops", "frictionless", "--repeat", "0"]
        done = subprocess.run([*tool, "-o", made, *options], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "no beads of Poisson's ratio 0.499 .*; --finest CELLS compares with those of a finer")
        done = subprocess.run([*tool, "-o", made, *options, "--finest", "4"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        runs = json.loads(made.read_text())["runs"]
        self.assertEqual([(run["settings"]["volume"], run["settings"]["cells"]) for run in runs],
                         [("tets", 2), ("tets", 4), ("patches", 2)])  # fmt: skip
        said = [run["steps"][0]["beads"] for run in runs]
        self.assertTrue(all("--cells 4 --poisson 0.499 --volume patches --top frictionless" in s["reference"] for s in said))
        subprocess.run([PROGRAM, *said[0]["reference"].split()[1:], "--quiet", "--out", self.folder / "fine"], check=True)
        subprocess.run([PROGRAM, *runs[2]["command"].split()[1:], "--quiet", "--out", self.folder / "wide"], check=True)
        fine, wide = (beads_of(self.folder / name / "beads.csv") for name in ("fine", "wide"))
        square = sum(math.dist(a, b) ** 2 for a, b in zip(fine, wide)) / len(fine)
        self.assertAlmostEqual(said[2]["rms_mm"], 1e3 * math.sqrt(square), places=9)
        self.assertGreater(said[2]["rms_mm"], 0.01)
        head, lines = bead_errors.lines({"runs": runs}, "a.json")
        self.assertEqual(head[2:], ["beads at 5 % [mm RMS]", "solved at 5 % in"])  # without reactions of other codes
        self.assertEqual([line[1] for line in lines], ["2³", "4³", "2³"])

    # ---- Error against time ----------------------------------------------------------------------------------------
    def test_points_are_drawn_where_the_file_says(self):
        for path in (self.made, CHECKED_IN):
            runs = json.loads(path.read_text())["runs"]
            figure = error_against_time.draw(path)
            panels = sorted({run["steps"][0]["compression"] for run in runs})
            self.assertEqual(len(figure.axes), len(panels))
            for axes, compression in zip(figure.axes, panels):
                steps = [run["steps"][0] for run in runs]
                wanted = [
                    (step["warm_seconds"], step["beads"]["rms_mm"]) for step in steps if step["compression"] == compression
                ]
                drawn = [tuple(point) for line in axes.lines for point in line.get_xydata()]
                self.assertEqual(sorted(drawn), sorted(wanted))
                self.assertIn(f"{100 * compression:g} %", axes.get_title(loc="center"))

    def test_the_machine_and_failed_runs_are_named(self):
        content = json.loads(self.made.read_text())
        content["runs"].append({"command": "truthcube --cells 8", "failed": "no equilibrium", "status": 3})
        path = self.folder / "some_failed.json"
        path.write_text(json.dumps(content))
        title = error_against_time.draw(path)._suptitle.get_text()
        self.assertIn(f"{content['machine']}: numbers", title)
        content["repeats"] = 4
        path.write_text(json.dumps(content))
        title = error_against_time.draw(path)._suptitle.get_text()
        self.assertIn(f"{content['machine']}, fastest of 4 runs: numbers", title)
        self.assertIn("; 1 run failed", title)

    def test_files_of_runs_that_are_none_are_refused_with_the_place(self):
        path = self.folder / "wrong.json"

        def refused(change, words):
            content = json.loads(self.made.read_text())
            change(content["runs"])
            path.write_text(json.dumps(content))
            with self.assertRaisesRegex(RunError, words):
                error_against_time.read(path)

        refused(lambda runs: runs.clear(), "wrong.json: no runs; tools/report/truthcube_runs.py")
        refused(lambda runs: runs[3].pop("settings"), r"runs\[3\] has no 'settings'")
        refused(lambda runs: runs[3]["steps"][0].pop("beads"), r"runs\[3\]: steps\[0\] has no 'beads'")
        refused(lambda runs: runs[3]["steps"][0]["beads"].update(rms_mm=0), r"'rms_mm' is 0, and a logarithm")
        refused(lambda runs: runs[3]["steps"][0].update(warm_seconds=None), "'warm_seconds' is None, and a logarithm")
        refused(lambda runs: runs[3]["steps"].append(runs[3]["steps"][0]), r"runs\[3\] has 2 steps, and times count")
        refused(lambda runs: runs[3].update(device="A GPU"), "runs of A GPU and .*: their times do not compare")

    # ---- The ratio table -------------------------------------------------------------------------------------------
    def rows(self, **of_first):
        common = {"cells": 64, "poisson": 0.49, "volume": "patches", "device": "A GPU", "setup_seconds": 0.001}
        made = [
            {"method": "block-jacobi", "solve_seconds": 0.022, "iterations": 600, "residual": 9e-5, "setup_seconds": 0.0},
            {"method": "multigrid", "solve_seconds": 0.004, "iterations": 19, "residual": 4e-5},
            {"method": "vendor", "solve_seconds": 0.03, "iterations": 601, "residual": 8e-5, "setup_seconds": 0.002},
        ]
        return [{**common, **row, **(of_first if number == 0 else {})} for number, row in enumerate(made)]

    def test_rows_of_physbench_are_rows_of_the_ratio_table(self):
        numbers = {"poisson": 0.45, "compression": 0.0, "tolerance": 1e-4, "product_bytes": 5e6, "iteration_bytes": 6e7}
        times = {"median_ms": 4.4, "assembly_ms": 0.5, "setup_ms": 1.0, "product_ms": 0.1, "product_copy_ms": 0.05, "copy_ms": 1.1}
        solved = {**numbers, **times, "iterations": 3, "iteration_count": 11.0, "err_max": 4e-5}
        body = "cuda/1572864/tets_0.45_euclidean"
        results = [{"name": "linear_solve/multigrid/half/" + body, **solved}]
        results.append({"name": "linear_solve/none/float/" + body, "error_message": "not finite"})
        row, failed = linear_solves.rows_of({"context": {"gpu": "A GPU, CUDA 13.0"}, "benchmarks": results}, "a.json")
        self.assertEqual((row["cells"], row["precision"], row["iterations"], row["device"]), (64, "half", 11, "A GPU"))
        self.assertEqual((row["solve_seconds"], row["setup_seconds"], row["residual"]), (4.4e-3, 1e-3, 4e-5))
        self.assertAlmostEqual(row["seconds_per_iteration"] / row["iteration_copy_seconds"], 4)
        self.assertEqual((failed["status"], failed["solve_seconds"]), ("not finite", None))
        lines = linear_solves.lines({"rows": [row, failed]}, "a.json")[1]
        self.assertEqual(lines[0][4:6], ["4.4 in 11", "not finite"])
        with self.assertRaisesRegex(RunError, "a.json: svd/aos/float/host/8 is no row of linear_solves; measure again"):
            linear_solves.rows_of({"benchmarks": [{"name": "svd/aos/float/host/8"}]}, "a.json")

    def test_ratios_are_of_times_over_multigrid(self):
        head, lines = linear_solves.lines({"rows": self.rows()}, "a.json")
        self.assertEqual(head[2], "multigrid : block Jacobi : vendor's library")
        self.assertEqual(
            lines,
            [
                ["64³", "0.49, patches", "1.00 : 5.50 : 7.50", "1.00 : 4.40 : 6.40", "4 in 19", "22 in 600", "30 in 601"]
                + ["4.0e-05 to 9.0e-05", "A GPU"]
            ],
        )

    def test_bodies_have_a_line_each_and_methods_that_are_missing_a_dash(self):
        other = [{**row, "cells": 32} for row in self.rows() if row["method"] != "vendor"]
        schwarz = {**self.rows()[0], "method": "schwarz", "solve_seconds": 0.01}
        head, lines = linear_solves.lines({"rows": [*self.rows(), schwarz, *other]}, "a.json")
        self.assertEqual(head[2], "multigrid : Schwarz : block Jacobi : vendor's library")
        self.assertEqual([line[2] for line in lines], ["1.00 : 2.50 : 5.50 : 7.50", "1.00 : – : 5.50 : –"])

    def test_of_several_precisions_the_fastest_counts_and_what_did_not_converge_is_said(self):
        rows = [{**row, "precision": "float"} for row in self.rows(status="iterations used up")]
        rows.append({**rows[1], "precision": "half", "solve_seconds": 0.003})
        _, lines = linear_solves.lines({"rows": rows}, "a.json")
        self.assertEqual(lines[0][2], "1.00 : – : 10.00")
        self.assertEqual(lines[0][4:7], ["3 in 19", "iterations used up", "30 in 601"])

    def test_rows_that_do_not_compare_are_refused(self):
        def refused(rows, words):
            with self.assertRaisesRegex(RunError, words):
                linear_solves.lines({"rows": rows}, "a.json")

        refused([], "a.json: no list of 'rows'; measure again")
        refused(self.rows(method="magic"), r"rows\[0\]: the method 'magic' is none of multigrid, schwarz")
        refused(self.rows(residual=9e-3), "64 cells, nu 0.49, patches on A GPU: residuals from .* are not equal ones")
        refused(self.rows(method="multigrid"), r"rows\[1\]: 'multigrid' of this body is there already")
        refused(self.rows()[:1], "no solve by multigrid")
        refused(self.rows(solve_seconds=0), r"rows\[0\]: 'solve_seconds' is 0, which is not a positive number")
        refused(self.rows(iterations="many"), r"rows\[0\]: 'iterations' is \"many\"")

    def test_iterations_stand_by_cube_with_their_spread_from_16_cells(self):
        rows = [
            {**self.rows()[1], "cells": cells, "norm": norm, "iterations": iterations}
            for norm, counts in (("euclidean", {32: 25, 8: 10, 16: 20}), ("preconditioned", {8: 9}))
            for cells, iterations in counts.items()
        ]
        head, lines = linear_solves.iterations({"rows": rows}, "a.json")
        self.assertEqual(head, ["nu, volume by", "norm", "8³", "16³", "32³", "spread from 16³"])
        self.assertEqual(lines[0], ["0.49, patches", "euclidean", "10", "20", "25", "25 %"])
        self.assertEqual(lines[1], ["0.49, patches", "preconditioned", "9", "–", "–", "–"])

    # ---- Layouts ---------------------------------------------------------------------------------------------------
    def test_layouts_are_compared_body_by_body(self):
        def build(layout, seconds, solve_seconds):
            whole = json.loads(json.dumps(self.content["runs"][0]))
            whole["steps"][0]["warm_seconds"] = seconds
            linear = [{**row, "solve_seconds": solve_seconds * (k + 1)} for k, row in enumerate(self.rows()[:2])]
            return {"layout": layout, "whole": whole, "linear": linear}

        ours, other = build("schema", 0.04, 0.002), build("aos", 0.06, 0.005)
        head, lines = layouts.lines({"bodies": [[ours, other]]}, "a.json")
        self.assertEqual(head[2], "whole solve: schema, aos [ms], ratio")
        self.assertEqual(lines[0][2:5], ["40, 60, 1.50", "4, 10, 2.50", "2, 5, 2.50"])

        def refused(bodies, words):
            with self.assertRaisesRegex(RunError, words):
                layouts.lines({"bodies": bodies}, "a.json")

        refused([], "a.json: no list of 'bodies'; measure again with tools/report/layout_runs.py")
        refused([[ours]], r"bodies\[0\] is not a pair of builds")
        refused([[other, ours]], r"bodies\[0\] has the layouts aos and schema, not schema and another")
        refused([[ours, other], [ours, build("soa", 1, 1)]], "the layouts aos and soa are not in one table")
        refused([[ours, build("aos", None, 1)]], "a run without repeated solves")
        refused([[ours, {**other, "linear": []}]], "0 linear solves by multigrid")

    def test_two_builds_are_run_in_turns_and_refused_where_both_have_one_layout(self):
        build, out = pathlib.Path(PROGRAM).parents[1], self.folder / "layouts.json"
        tool = [sys.executable, REPORT / "layout_runs.py", build, build, "-o", out, "--device", "cpu", "--cells", "4"]
        done = subprocess.run(tool, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "layout_runs.py: .*has the layouts (.*) and \\1, not schema and another")
        ours, other = json.loads(out.read_text())["bodies"][0]
        self.assertEqual([row["method"] for row in ours["linear"]], ["multigrid", "block-jacobi"])
        self.assertEqual(ours["whole"]["steps"][0]["reaction"], other["whole"]["steps"][0]["reaction"])
        self.assertGreater(ours["whole"]["steps"][0]["warm_seconds"], 0)


if __name__ == "__main__":
    unittest.main()
