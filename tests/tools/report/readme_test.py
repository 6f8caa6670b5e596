"""Tests that READMEs print what the checked-in results say, and that differences are found: readme_test.py"""
import json
import re
import subprocess
import sys
import unittest

from readme_case import MEASURED, PACKAGES, ROOT, TOOL, ReadmeCase, command

import readme_numbers
import report_test_rows


class ReadmeTest(ReadmeCase):
    # ---- The checkout --------------------------------------------------------------------------------------------
    def test_figures_of_readmes_are_those_of_the_results(self):
        done = subprocess.run([sys.executable, TOOL, "--check"], capture_output=True, text=True, check=False)
        self.assertEqual((done.stderr, done.returncode), ("", 0))

    def test_every_result_file_has_a_table_on_a_page(self):
        pages = {page: (self.root / page).read_text(encoding="utf-8") for page in readme_numbers.PAGES}
        used = {table.file for page, text in pages.items() for table in readme_numbers.tables(page, text)}
        files = {path.name for path in self.result_files()}
        self.assertEqual({file for file in used if "/" not in file}, files)
        results = self.root / readme_numbers.RESULTS
        self.assertEqual(
            {file for file in used if file.startswith(readme_numbers.RESULTS)},
            {path.relative_to(self.root).as_posix() for folder in ("ranks", "truthcube") for path in (results / folder).glob("*.json")}
            - {f"{readme_numbers.RESULTS}/truthcube/linear_solves_large.json"},  # its figures are in no table yet
        )

    # ---- What is found -------------------------------------------------------------------------------------------
    def test_a_changed_digit_of_a_table_or_its_caption_is_found_in_its_line(self):
        checkout, tried = readme_numbers.Checkout(self.root), 0
        for page in readme_numbers.PAGES:
            text = checkout.text(page)
            for table in readme_numbers.tables(page, text):
                wanted = checkout.wanted(page, table)
                self.assertEqual(text[table.begin : table.end], wanted)
                place = re.search(r"\d", wanted)
                number = table.begin + place.start()
                other = text[:number] + str((int(place[0]) + 1) % 10) + text[number + 1 :]
                (self.root / page).write_text(other, encoding="utf-8")
                found = checkout.differences()
                self.assertEqual(found[0], f"{page}:{table.line}: the table '{table.name}' is not what {table.file} says:")
                self.assertGreater(len(found), 2)
                tried += 1
            (self.root / page).write_text(text, encoding="utf-8")
        self.assertGreater(tried, 15)

    def test_every_table_and_picture_changes_when_the_results_do(self):
        for path in self.result_files():
            path.write_text(json.dumps(report_test_rows.measured_again(json.loads(path.read_text()))))
        self.measure_cubes_again()
        checkout = readme_numbers.Checkout(self.root)
        for page in readme_numbers.PAGES:
            text = checkout.text(page)
            for table in readme_numbers.tables(page, text):
                if table.file == PACKAGES:
                    continue
                for old, new in zip(text[table.begin : table.end].splitlines(), checkout.wanted(page, table).splitlines()):
                    if old.startswith("|") and re.search(r"\d[.:]\d", old):  # else a caption, or the head of a table
                        self.assertNotEqual(old, new, f"{page}:{table.line}")
        stale = " ".join(checkout.differences())
        for picture in readme_numbers.PICTURES:
            self.assertIn(f"{picture.path}: not drawn from the present", stale)

    def test_a_changed_digit_of_a_result_is_found(self):
        path = self.root / readme_numbers.RESULTS / "h100_gathers.json"
        content = json.loads(path.read_text())
        row = next(row for row in content["benchmarks"] if re.fullmatch("gather_nodes/soa/.*/random", row["name"]))
        row["median_ms"] += 0.001
        path.write_text(json.dumps(content))
        done = command("--check", self.root)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"results/README.md:\d+: the table 'gathers' is not what h100_gathers.json says:\n- .*\n\+ ")
        self.assertIn("readme_numbers.py --write", done.stderr)

    def test_the_picture_of_the_cube_is_small_and_its_command_is_in_the_readme(self):
        content = (ROOT / "tools/report/results/truthcube/cube.png").read_bytes()
        self.assertLess(len(content), 300_000)
        run = re.search(rb"tEXtDescription\0(truthcube [^;]*);", content)[1].decode()
        pages = [(ROOT / page).read_text(encoding="utf-8") for page in ("README.md", "tools/truthcube/README.md")]
        for page in pages:
            self.assertRegex(page, r"\]\([./\w]*results/truthcube/cube\.png\)")
        self.assertTrue(any(f"`{run}`" in page for page in pages), f"no page has `{run}`, which the picture was drawn of")

    def test_pictures_are_small_and_stand_in_a_readme(self):
        shown = set()
        for page in readme_numbers.PAGES:
            text = (ROOT / page).read_text(encoding="utf-8")
            shown |= {(ROOT / page).parent.joinpath(link).resolve() for link in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text)}
        for picture in readme_numbers.PICTURES:
            self.assertIn((ROOT / picture.path).resolve(), shown)
            self.assertLess((ROOT / picture.path).stat().st_size, 300_000)

    def test_a_table_of_ratios_is_made_of_linear_solves(self):
        row = {"cells": 8, "poisson": 0.49, "volume": "tets", "device": "cpu", "setup_seconds": 0.5, "iterations": 9}
        fast = {**row, "method": "multigrid", "solve_seconds": 2.0, "residual": 1e-5}
        slow = {**row, "method": "block-jacobi", "solve_seconds": 5.0, "residual": 2e-5}
        name = "tools/report/results/truthcube/linear_solves.json"
        (self.root / name).write_text(json.dumps({"rows": [fast, slow]}))
        place = f"<!-- figures: linear_solves, from {name} -->\n"
        self.append("README.md", f"\n{place}<!-- end of figures -->\n")
        self.assertEqual(command("--write", self.root).returncode, 0)
        self.assertIn("| 8³ | 0.49, tets | 1.00 : 2.50 | 1.00 : 2.20 |", (self.root / "README.md").read_text(encoding="utf-8"))
        (self.root / name).write_text(json.dumps({"rows": [slow]}))
        self.refused("linear_solves.json: 8 cells", "no solve by multigrid")

    def test_the_table_of_joined_steps_is_that_of_the_digests(self):
        digest = self.root / "generated" / "scenes" / "force_chain.digest"
        digest.write_text(digest.read_text().replace(", physgen::fem::ComputeCornerForces(body.rest, body.stresses, body.corner_forces); ", "; "))
        said = command("--check", self.root).stderr
        self.assertIn("generator/scenes/README.md", said)
        self.assertIn("+ | `force_chain` | 5 | `ComputeDeformationGradient` to `ComputeStress`: 3 | none |", said)

    def test_a_table_of_fused_kernels_stands_them_beside_the_separate_ones(self):
        results = self.root / readme_numbers.RESULTS
        content = json.loads((results / "h100.json").read_text())
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
        (results / "h100_fused.json").write_text(json.dumps(content))
        place = "<!-- figures: fused, from h100_fused.json -->\n"
        self.append("README.md", f"\n{place}<!-- end of figures -->\n")
        self.assertEqual(command("--write", self.root).returncode, 0)
        text = readme_numbers.Checkout(self.root).text("README.md")
        self.assertIn("| positions to forces on nodes, sums in any order | 1.600 | 0.320 | 5.00x | 60 | 0.75 |", text)
        self.assertIn("| the same in a fixed order | 1.600 | 0.500 | 3.20x |", text)
        self.assertIn("clamped derivative | 1.000 | 0.400 | 2.50x | 300 | 0.75 |", text)
        del content["benchmarks"][-2]
        (results / "h100_fused.json").write_text(json.dumps(content))
        self.refused("h100_fused.json has no row matrix_free_separate/aosoa32/float/cuda/*")


if __name__ == "__main__":
    unittest.main()
