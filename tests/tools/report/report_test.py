"""Tests of tools/report, through its command line: python3 report_test.py"""
import json
import pathlib
import re
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.dont_write_bytecode = True
import report_test_rows  # noqa: E402
from report_page import SECTIONS, Page, report, report_of_a_process, report_of_words  # noqa: E402

TOOL = pathlib.Path(__file__).resolve().parents[3] / "tools" / "report"
CHECKED_IN = sorted(str(path) for path in (TOOL / "results").glob("*.json"))

sys.path.insert(0, str(TOOL))
import drawing  # noqa: E402
import names  # noqa: E402
import rows  # noqa: E402


class ReportTest(unittest.TestCase):
    """Two reports, made once: of everything, and of the results that are checked in."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.all_kinds = cls.folder / "all_kinds.json"
        content = report_test_rows.results()
        cls.builds = cls.folder / "build"
        hashes = cls.builds / "made_up/tools/physbench/hashes/all.txt"
        hashes.parent.mkdir(parents=True)
        hashes.write_text("".join(sorted({row["kernels"] + "\n" for row in content["benchmarks"]})))
        cls.all_kinds.write_text(json.dumps(content))
        content["benchmarks"] = [row for row in content["benchmarks"] if row["name"].startswith("gather_nodes/")]
        cls.gathers = cls.folder / "gathers.json"
        cls.gathers.write_text(json.dumps(content))
        for name, files in (("all", [cls.all_kinds]), ("measured", CHECKED_IN)):
            done = report(*files, "-o", cls.folder / name, "--builds", cls.builds)
            if done.returncode != 0 or done.stderr:
                raise AssertionError(f"exit {done.returncode}: {done.stderr}")
        cls.all = Page(cls.folder / "all" / "index.html")
        cls.measured = Page(cls.folder / "measured" / "index.html")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    # ---- The page ------------------------------------------------------------------------------------------------
    def test_commands_that_draw_run_the_python_that_has_the_packages_of_debian(self):
        for name in ("report", "readme_numbers", "truthcube_pictures", "layout_picture"):
            first = (TOOL / f"{name}.py").read_text(encoding="utf-8").splitlines()[0]
            self.assertEqual(first, "#!/usr/bin/python3", name)

    def test_every_section_is_there_in_order(self):
        self.assertEqual(list(self.all.text), SECTIONS)
        self.assertEqual(list(self.measured.text), SECTIONS)

    def test_every_kind_of_row_fills_its_section(self):
        for section in SECTIONS[:-1]:
            with self.subTest(section):
                self.assertGreater(self.all.plots[section], 0)
                self.assertNotIn("no rows", self.all.text[section])

    def test_checked_in_results_fill_every_section(self):
        for section in SECTIONS[:-1]:
            self.assertGreater(self.measured.plots[section], 0, section)

    def test_section_without_rows_says_which_and_the_command(self):
        self.assertEqual(report_of_words(self.gathers, "-o", self.folder / "only").returncode, 0)
        page = Page(self.folder / "only" / "index.html")
        self.assertEqual([section for section in SECTIONS if page.plots[section]], ["gathered-against-streamed"])
        for section in SECTIONS[:5] + SECTIONS[6:9]:
            self.assertIn("no rows for this section", page.text[section])
            self.assertRegex(page.text[section], r"tools/dev run (errors |storage |conversions |forces |growth |)--json=")

    def test_page_refers_to_nothing_outside(self):
        for page in (self.all, self.measured):
            for reference in page.references:
                self.assertTrue(reference.startswith("#"), reference)
                self.assertIn(reference[1:], page.ids)
            self.assertNotRegex(page.source, r"<(script|link|img|iframe|object|image)\b|@import|url\((?!#)")

    def test_ids_are_unique_among_inlined_plots(self):
        self.assertEqual(len(self.all.ids), len(set(self.all.ids)))

    def test_every_plot_is_a_file_as_svg_and_png(self):
        for name, page in (("all", self.all), ("measured", self.measured)):
            files = {path.name for path in (self.folder / name).iterdir()}
            pngs = {file[:-4] for file in files if file.endswith(".png")}
            svgs = {file[:-4] for file in files if file.endswith(".svg")}
            self.assertEqual(pngs, svgs)
            self.assertEqual(len(pngs), sum(page.plots.values()))
            self.assertEqual(files, {stem + end for stem in pngs for end in (".png", ".svg")} | {"index.html"})
            for stem in svgs:
                xml.etree.ElementTree.parse(self.folder / name / (stem + ".svg"))

    def test_output_is_the_same_on_every_run(self):
        again = self.folder / "again"
        self.assertEqual(report_of_a_process(self.all_kinds, "-o", again, "--builds", self.builds), (0, ""))
        for path in (self.folder / "all").iterdir():
            self.assertEqual(path.read_bytes(), (again / path.name).read_bytes(), path.name)

    # ---- What it says --------------------------------------------------------------------------------------------
    def test_paper_figures_and_ours_stand_in_table_1(self):
        text = self.all.text[SECTIONS[0]]
        for figure in (
            "20.240",
            "2.430",
            "8.33×",
            "6.72×",
            "5.13×",
            "0.031 → 0.167",
            "0.026 → 0.222",
            "0.013 → 0.066",
            "30.2 → 4.00",
            "symmetric half, fast",
            "8,388,608",
        ):
            self.assertIn(figure, text)
        self.assertEqual(text.count("30.2 → 4.00"), 3)

    def test_pareto_is_apart_for_gpu_and_cpu_and_names_the_losers(self):
        self.assertEqual(self.all.plots[SECTIONS[1]], 2)
        losers = re.search(r"lose on Made-up CPU, 8 threads[^.]*\.\d[^:]*: ([^\n]*)", self.all.text[SECTIONS[1]])
        self.assertIsNotNone(losers)
        self.assertIn("quaternion_half", losers[1])
        self.assertNotIn("quaternion16_all_half", losers[1])

    def test_commands_are_quoted_for_a_shell(self):
        self.assertIn("tools/dev gpu '--benchmark_filter=.|/(x)' --json=a.json", self.all.text[SECTIONS[9]])

    def test_failed_rows_are_listed_and_escaped(self):
        self.assertIn("libcusolver.so &lt;was&gt; not found", self.all.source)
        self.assertIn("svd/cusolver/float/cuda/1048576/hard", self.all.text[SECTIONS[9]])

    def test_last_file_counts_where_rows_are_twice(self):
        slower = report_test_rows.results()
        slower["benchmarks"] = [
            dict(row, median_ms=7.0)
            for row in slower["benchmarks"]
            if row["name"] == "stress_derivative/aosoa32/float/cuda/8388608"
        ][:1]
        later = self.folder / "later.json"
        later.write_text(json.dumps(slower))
        results = rows.load([self.all_kinds, later], self.builds)
        self.assertEqual(results.replaced, 1)
        same = rows.where(results.rows, kernel="stress_derivative", layout="aosoa32", objects=8388608, set="")
        self.assertEqual([row.ms for row in same], [7.0])

    # ---- What is older than the code -----------------------------------------------------------------------------
    def page_of_gathers_with(self, kernels):
        """The page of all kinds of rows, with those of gather_nodes from a file that says something else of their kernels."""
        content = json.loads(self.gathers.read_text())
        for row in content["benchmarks"]:
            row.update(kernels=kernels) if kernels else row.pop("kernels")
        (self.folder / "other.json").write_text(json.dumps(content))
        files = (self.all_kinds, self.folder / "other.json")
        done = report_of_words(*files, "-o", self.folder / "marked", "--builds", self.builds)
        self.assertEqual(done.returncode, 0, done.stderr)
        return Page(self.folder / "marked" / "index.html")

    def check_only_gathers_are_marked(self, page, why, listed):
        marked = [section for section in SECTIONS if "May be older than the code" in page.text[section]]
        self.assertEqual(marked, ["gathered-against-streamed"])
        self.assertIn(why, page.text["gathered-against-streamed"])
        self.assertIn("other.json (2026-01-02)", page.text["gathered-against-streamed"])
        self.assertIn("1 of the files may be older than the code", page.source)
        self.assertRegex(page.source, rf"<td[^>]*>{listed}</td>")

    def test_results_of_the_kernels_of_a_build_are_not_marked(self):
        self.assertNotIn("older than the code", self.all.source)
        self.assertIn("as here", self.all.text[SECTIONS[9]])

    def test_section_with_results_of_other_kernels_says_which_differ(self):
        page = self.page_of_gathers_with("scene/cuda/gather_nodes fedcba9876543210")
        why = "measured other compiled kernels than the builds here (those of scene/cuda/gather_nodes)"
        self.check_only_gathers_are_marked(page, why, "other: scene/cuda/gather_nodes")

    def test_section_with_results_that_name_no_kernels_says_so(self):
        page = self.page_of_gathers_with(None)
        self.check_only_gathers_are_marked(page, "of before results had hashes of their compiled kernels", "not stated")

    def test_section_with_results_of_kernels_that_no_build_has_says_so(self):
        page = self.page_of_gathers_with("scene/cuda/gather_nodes 0123456789abcdef, gathers/cuda 0123456789abcdef")
        why = "were not compared, since no build here has their kernels"
        self.check_only_gathers_are_marked(page, why, "not compared: gathers/cuda")

    def test_every_section_knows_the_rows_that_it_shows(self):
        arguments = (self.all_kinds, "-o", self.folder / "unbuilt", "--builds", self.folder / "no build")
        self.assertEqual(report_of_words(*arguments).returncode, 0)
        page = Page(self.folder / "unbuilt" / "index.html")
        for section in SECTIONS[:-1]:
            self.assertIn("May be older than the code", page.text[section])

    # ---- Wrong input ---------------------------------------------------------------------------------------------
    def check_refused(self, content, message):
        wrong, out = self.folder / "wrong.json", self.folder / "refused"
        if content is not None:
            wrong.write_text(content)
        elif wrong.exists():
            wrong.unlink()
        done = report(self.all_kinds, wrong, "-o", out)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, message)
        self.assertIn("wrong.json", done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertFalse(out.exists())

    def test_missing_file_is_refused(self):
        self.check_refused(None, "No such file")

    def test_text_that_is_not_json_is_refused(self):
        self.check_refused("kernel ms\n", "not JSON")
        self.check_refused('{"context": {"physgen": "0.1.0"}, "benchmarks": [', "not JSON")

    def test_json_of_others_is_refused(self):
        for content in ("[]", "3", "{}", '{"context": {}, "benchmarks": []}', '{"context": {"physgen": "1"}}'):
            self.check_refused(content, "not of physbench")

    def test_wrong_rows_are_refused_by_name(self):
        def file(*benchmarks):
            return json.dumps({"context": {"physgen": "0.1.0"}, "benchmarks": benchmarks})

        self.check_refused(file(), "no rows")
        self.check_refused(file({"name": "BM_copy/8", "median_ms": 1.0}), "'BM_copy/8' is not kernel/layout")
        self.check_refused(file({"name": "svd/aos/float/cuda/0", "median_ms": 1.0}), "is not kernel/layout")
        self.check_refused(file({"name": "svd/aos/float/cuda/8"}), "median_ms")
        self.check_refused(file({"name": "svd/aos/float/cuda/8", "median_ms": float("nan")}), "median_ms")
        self.check_refused(file({"median_ms": 1.0}), "no name")

    def test_results_of_another_version_are_refused(self):
        content = json.loads(self.gathers.read_text())
        for version in ("2", 0, "", None, [1]):
            content["context"]["results_version"] = version
            self.check_refused(
                json.dumps(content),
                rf"context.results_version is '{re.escape(str(version))}'.* version 1; measure again with this",
            )

    def test_kernels_that_physbench_does_not_write_are_refused(self):
        content = json.loads(self.gathers.read_text())
        for wrong in ("", "a/b", "a/b 0123", "a/b 0123456789abcdeF", 3, None, ["a/b 0123456789abcdef"]):
            content["benchmarks"][0]["kernels"] = wrong
            self.check_refused(json.dumps(content), "gather_nodes/.*: kernels is .* measure again")

    def test_wrong_use_exits_with_2(self):
        self.assertEqual(report().returncode, 2)
        self.assertEqual(report(self.all_kinds).returncode, 2)
        done = report_of_a_process(self.gathers, "-o", self.folder / "x", "--colour")
        self.assertEqual(done.returncode, 2)
        self.assertIn("unrecognized arguments: --colour", done.stderr)
        done = report(self.gathers, "-o", self.gathers / "below")
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot write", done.stderr)

    def test_failed_write_leaves_the_old_report_and_nothing_half(self):
        folder = self.folder / "kept"
        (folder / ".index.html.partial").mkdir(parents=True)  # in the way of the page, which is written last
        (folder / "index.html").write_text("old")
        done = report_of_words(self.gathers, "-o", folder)
        self.assertEqual(done.returncode, 2)
        self.assertEqual((folder / "index.html").read_text(), "old")
        self.assertEqual({path.name for path in folder.iterdir()}, {"index.html", ".index.html.partial"})

    # ---- Small parts ---------------------------------------------------------------------------------------------
    def test_labels_are_spread_in_order_and_apart(self):
        self.assertEqual(drawing.spread([5.0, 1.0, 9.0], 1.0), [5.0, 1.0, 9.0])
        places = drawing.spread([2.0, 2.0, 2.1, 2.2, 8.0], 1.0)
        self.assertEqual(places, sorted(places))
        self.assertTrue(all(after - before > 0.999 for before, after in zip(places, places[1:])))
        self.assertAlmostEqual(sum(places[:4]) / 4, 2.075)

    def test_names_read_well(self):
        self.assertEqual(names.layout("aosoa32_to_aos_padded"), "AoSoA-32 → padded AoS")
        self.assertEqual(names.layout("something_new"), "something new")
        self.assertEqual(
            [names.significant(value) for value in (0, 0.0368, 1.65, 12.22, 4180.2, 1.2e-7, 5.9e6, 3.6e10)],
            ["0", "0.0368", "1.65", "12.2", "4,180", "1.20e-7", "5.90e6", "3.60e10"],
        )

    def test_repetitions_count_once_by_their_median(self):
        file = self.folder / "repeated.json"
        file.write_text(
            json.dumps(
                {
                    "context": {"physgen": "0.1.0"},
                    "benchmarks": [
                        {"name": "svd/aos/float/host/8/repeats:3", "median_ms": ms} for ms in (3.0, 1.0, 2.0)
                    ],
                }
            )
        )
        self.assertEqual([row.ms for row in rows.load([str(file)]).rows], [2.0])


if __name__ == "__main__":
    unittest.main()
