"""Tests that READMEs print what the checked-in results say, and that differences are found: readme_test.py"""
import json
import re
import subprocess
import sys
import unittest

from readme_case import MEASURED, PACKAGES, ROOT, TOOL, ReadmeCase, command

import readme_figures
import readme_numbers
import readme_sentences
import report_test_rows

DIGITS = re.compile(r"\d+")


class ReadmeTest(ReadmeCase):
    # ---- The checkout --------------------------------------------------------------------------------------------
    def test_figures_of_readmes_are_those_of_the_results(self):
        done = subprocess.run([sys.executable, TOOL, "--check"], capture_output=True, text=True, check=False)
        self.assertEqual((done.stderr, done.returncode), ("", 0))

    def test_every_result_file_has_figures_in_a_readme(self):
        used = {sentence.file for sentence in readme_sentences.SENTENCES}
        for readme in readme_figures.READMES:
            text = (self.root / readme).read_text(encoding="utf-8")
            files = [file for *_, file in readme_numbers.tables(readme, text)]
            used |= {file for file in files if file.endswith(".json") and "/" not in file}
        self.assertEqual(used, {path.name for path in self.result_files()})

    # ---- What is found -------------------------------------------------------------------------------------------
    def test_a_changed_digit_of_a_readme_is_found_in_its_line(self):
        checkout, tried = readme_numbers.Checkout(self.root), 0
        for readme in readme_figures.READMES:
            text = checkout.text(readme)
            for edit in checkout.edits(readme, text):
                for number in DIGITS.finditer(text, edit.begin, edit.end):
                    place = number.end() - 1
                    digit = str((int(text[place]) + 1) % 10)
                    (self.root / readme).write_text(text[:place] + digit + text[place + 1 :], encoding="utf-8")
                    try:
                        found = checkout.differences_in(readme)
                    except readme_numbers.FiguresError as error:  # of a digit in words that belong to a sentence
                        self.fail(f"{readme}: {number[0]}: {error}")
                    self.assertEqual(len(found), 1, number[0])
                    self.assertIn(f"{readme}:{readme_numbers.line(text, place)}: ", found[0])
                    tried += 1
            (self.root / readme).write_text(text, encoding="utf-8")
        self.assertGreater(tried, 300)

    def test_every_figure_changes_when_the_results_do(self):
        for path in self.result_files():
            path.write_text(json.dumps(report_test_rows.measured_again(json.loads(path.read_text()))))
        self.measure_cubes_again()
        checkout = readme_numbers.Checkout(self.root)
        for readme in readme_figures.READMES:
            text = checkout.text(readme)
            for edit in checkout.edits(readme, text):
                present = text[edit.begin : edit.end]
                if edit.file != PACKAGES and re.search(r"(?<![\w-])\d", present):  # else it is the head of a table
                    self.assertNotEqual(present, edit.wanted, f"{readme}:{readme_numbers.line(text, edit.begin)}")
        stale = " ".join(checkout.differences())
        for picture in readme_figures.PICTURES:
            self.assertIn(f"{picture.path}: not drawn from the present", stale)

    def test_a_changed_digit_of_a_result_is_found(self):
        path = self.root / readme_numbers.RESULTS / "h200_gathers.json"
        content = json.loads(path.read_text())
        row = next(row for row in content["benchmarks"] if re.fullmatch("gather_nodes/soa/.*/random", row["name"]))
        row["median_ms"] += 0.001
        path.write_text(json.dumps(content))
        done = command("--check", self.root)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"results/README.md:\d+: '0\.\d+' is '0\.\d+' in h200_gathers.json")
        self.assertIn("readme_numbers.py --write", done.stderr)

    def test_a_figure_that_nothing_holds_is_found(self):
        for figure in ("0.75 of a copy", "12 ms", "1,234 nodes", "7 µs", "3 million matrices"):
            before = (self.root / MEASURED).read_text(encoding="utf-8")
            self.change(MEASURED, "The paper's table 1", f"It has {figure}. The paper's table 1")
            done = command("--check", self.root)
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"'{figure.split()[0]}' is held by no results", done.stderr)
            (self.root / MEASURED).write_text(before, encoding="utf-8")

    def test_the_picture_of_the_cube_is_small_and_its_command_is_in_the_readme(self):
        content = (ROOT / "tools/report/results/truthcube/cube.png").read_bytes()
        self.assertLess(len(content), 300_000)
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        self.assertIn("](tools/report/results/truthcube/cube.png)", readme)
        run = re.search(rb"tEXtDescription\0(truthcube [^;]*);", content)[1].decode()
        self.assertTrue(f"`{run}`" in readme, f"README.md has no `{run}`, which the picture was drawn of")

    def test_pictures_are_small_and_stand_in_a_readme(self):
        shown = set()
        for readme in readme_figures.READMES:
            text = (ROOT / readme).read_text(encoding="utf-8")
            shown |= {(ROOT / readme).parent.joinpath(link).resolve() for link in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text)}
        for picture in readme_figures.PICTURES:
            self.assertIn((ROOT / picture.path).resolve(), shown)
            self.assertLess((ROOT / picture.path).stat().st_size, 300_000)

    def test_a_table_of_ratios_is_made_of_linear_solves(self):
        row = {"cells": 8, "poisson": 0.49, "volume": "tets", "device": "cpu", "setup_seconds": 0.5, "iterations": 9}
        fast = {**row, "method": "multigrid", "solve_seconds": 2.0, "residual": 1e-5}
        slow = {**row, "method": "block-jacobi", "solve_seconds": 5.0, "residual": 2e-5}
        name = "tools/report/results/truthcube/linear_solves.json"
        (self.root / name).write_text(json.dumps({"rows": [fast, slow]}))
        place = f"<!-- figures: linear_solves, from {name} -->\n"
        self.change("README.md", "## Pages", f"{place}<!-- end of figures -->\n\n## Pages")
        self.assertEqual(command("--write", self.root).returncode, 0)
        self.assertIn("| 8³ | 0.49, tets | 1.00 : 2.50 | 1.00 : 2.20 |", (self.root / "README.md").read_text(encoding="utf-8"))
        (self.root / name).write_text(json.dumps({"rows": [slow]}))
        self.refused("linear_solves.json: 8 cells", "no solve by multigrid")

    def test_a_table_of_fused_kernels_stands_them_beside_the_separate_ones(self):
        results = self.root / readme_numbers.RESULTS
        content = json.loads((results / "h200.json").read_text())
        like = next(row for row in content["benchmarks"] if row["name"].startswith("dp_from_df/aosoa32/float/cuda/"))
        chain = {"separate": 1.6, "fused": 0.32, "fused_fixed_order": 0.5, "fused_gathered": 0.8}
        times = {f"force_chain_{name}": ms for name, ms in chain.items()}
        times |= {"newton_update_separate": 1.0, "newton_update_fused": 0.4}
        times |= {"matrix_free_separate": 1.1, "matrix_free_fused": 0.55}
        content["benchmarks"] = [
            dict(like, name=f"{kernel}/aosoa32/float/cuda/{1000 if kernel.startswith('newton') else 200}")
            | {"median_ms": ms, "bytes_per_object": 300, "copy_fraction": 0.75}
            for kernel, ms in times.items()
        ]
        (results / "h200_fused.json").write_text(json.dumps(content))
        place = "<!-- figures: fused, from h200_fused.json -->\n"
        self.change("README.md", "## Pages", f"{place}<!-- end of figures -->\n\n## Pages")
        self.assertEqual(command("--write", self.root).returncode, 0)
        text = readme_numbers.Checkout(self.root).text("README.md")
        self.assertIn("| positions to forces on nodes, sums in any order | 1.600 | 0.320 | 5.00x | 60 | 0.75 |", text)
        self.assertIn("| the same in a fixed order | 1.600 | 0.500 | 3.20x |", text)
        self.assertIn("clamped derivative | 1.000 | 0.400 | 2.50x | 300 | 0.75 |", text)
        del content["benchmarks"][-2]
        (results / "h200_fused.json").write_text(json.dumps(content))
        self.refused("h200_fused.json has no row matrix_free_separate/aosoa32/float/cuda/*")


if __name__ == "__main__":
    unittest.main()
