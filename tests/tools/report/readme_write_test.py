"""Tests of what readme_numbers.py writes into READMEs, and of what it refuses: readme_write_test.py"""
import json
import re
import unittest

from readme_case import MEASURED, PACKAGES, ReadmeCase, command

import readme_numbers
import report_test_rows
import rows


class WriteTest(ReadmeCase):
    # ---- What is written -----------------------------------------------------------------------------------------
    def test_write_changes_nothing_where_all_agrees(self):
        done = command("--write", self.root)
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("", "", 0))

    def test_write_puts_new_tables_and_leaves_all_other_words(self):
        def words(page):
            text = (self.root / page).read_text(encoding="utf-8")
            for table in reversed(readme_numbers.tables(page, text)):
                text = text[: table.begin] + text[table.end :]
            return text

        before = [words(page) for page in readme_numbers.PAGES]
        for path in self.result_files():
            path.write_text(json.dumps(report_test_rows.measured_again(json.loads(path.read_text()))))
        self.measure_cubes_again()
        done = command("--write", self.root)
        self.assertEqual((done.stderr, done.returncode), ("", 0))
        changed = [page for page in readme_numbers.PAGES if page not in ("tools/README.md", "generator/scenes/README.md")]
        changed += [picture.path for picture in readme_numbers.PICTURES]
        self.assertEqual(done.stdout.split(), changed)
        self.assertEqual([words(page) for page in readme_numbers.PAGES], before)
        self.assertEqual(command("--check", self.root).returncode, 0)
        soa = next(
            row
            for row in rows.load([str(self.root / readme_numbers.RESULTS / "h100_gathers.json")]).rows
            if (row.layout, row.set) == ("soa", "random")
        )
        self.assertRegex((self.root / MEASURED).read_text(encoding="utf-8"), rf"\| at random \| .* \| {soa.ms:.3f} \|")

    def test_a_new_kernel_gets_a_line_of_its_own(self):
        path = self.root / readme_numbers.RESULTS / "h100.json"
        content = json.loads(path.read_text())
        for row in [row for row in content["benchmarks"] if row["name"].startswith("stress/")]:
            content["benchmarks"].append(dict(row, name="new_" + row["name"]))
        path.write_text(json.dumps(content))
        done = command("--check", self.root)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"the table 'kernels' is not what h100.json says:\n\+ \| new_stress \|")

    def test_the_table_of_packages_is_that_of_their_list(self):
        path = self.root / PACKAGES
        list_of_packages = path.read_text(encoding="utf-8").replace("LLVM 22 21 ", "LLVM 31 22 ")
        path.write_text(list_of_packages + "liblater-dev  what comes later\n", encoding="utf-8")
        done = command("--check", self.root)
        self.assertEqual(done.returncode, 1)
        self.assertIn("+ | liblater-dev | what comes later |", done.stderr)
        self.assertEqual(command("--write", self.root).stdout, "tools/README.md\n")
        written = (self.root / "tools/README.md").read_text(encoding="utf-8")
        self.assertIn("| liblater-dev | what comes later |\n<!-- end of figures -->", written)
        self.assertIn("| clang-31 (or 22, 20, 19) | ", written)

    # ---- What is refused -----------------------------------------------------------------------------------------
    def test_a_table_that_is_not_listed_is_refused(self):
        self.change(MEASURED, "<!-- figures: storage,", "<!-- figures: stores,")
        self.refused("results/README.md:", "no table 'stores'", "kernels, errors, storage")

    def test_a_table_without_an_end_is_refused(self):
        self.change(MEASURED, "<!-- end of figures -->\n", "")
        self.refused("results/README.md:", "no '<!-- end of figures -->' behind the table 'kernels'")

    def test_results_without_a_row_are_refused(self):
        path = self.root / readme_numbers.RESULTS / "h100_gathers.json"
        content = json.loads(path.read_text())
        content["benchmarks"] = [row for row in content["benchmarks"] if "/soa/" not in row["name"]]
        path.write_text(json.dumps(content))
        self.refused("h100_gathers.json has no row gather_nodes/soa/float/cuda/*/ordered; measure it")

    def test_missing_and_foreign_results_are_refused(self):
        path = self.root / readme_numbers.RESULTS / "h100_gathers.json"
        content = json.loads(path.read_text())
        content["context"]["results_version"] = "2"
        path.write_text(json.dumps(content))
        self.refused("h100_gathers.json: context.results_version is '2'")
        path.unlink()
        self.refused("h100_gathers.json: No such file")
        (self.root / "README.md").unlink()
        self.refused("README.md: No such file")

    def test_wrong_use_exits_with_2(self):
        for arguments in ([], ["--check", "--write"], ["--check", self.root, "more"]):
            self.assertEqual(command(*arguments).returncode, 2)


if __name__ == "__main__":
    unittest.main()
