"""Tests that READMEs print what the checked-in results say, and of the command that writes it: readme_test.py"""
import collections
import contextlib
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
TOOL = ROOT / "tools" / "report" / "readme_numbers.py"
sys.path.insert(0, str(TOOL.parent))
import readme_figures  # noqa: E402
import readme_numbers  # noqa: E402
import readme_sentences  # noqa: E402
import report_test_rows  # noqa: E402
import rows  # noqa: E402

PACKAGES = "tools/packages.txt"
MEASURED = readme_sentences.MEASURED
DIGITS = re.compile(r"\d+")


Done = collections.namedtuple("Done", "returncode stdout stderr")


def command(*arguments):
    """readme_numbers.py in this process. @return its exit status, and what it wrote and said"""
    wrote, said = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(wrote), contextlib.redirect_stderr(said):
        try:
            status = readme_numbers.main([str(argument) for argument in arguments])
        except SystemExit as end:  # of wrong use
            status = end.code
    return Done(status, wrote.getvalue(), said.getvalue())


class ReadmeTest(unittest.TestCase):
    def setUp(self):
        """A copy of what the command reads and writes."""
        self.temporary = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.temporary.name)
        for readme in readme_figures.READMES:
            (self.root / readme).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / readme, self.root / readme)
        shutil.copytree(ROOT / readme_numbers.RESULTS, self.root / readme_numbers.RESULTS, dirs_exist_ok=True)
        shutil.copy(ROOT / PACKAGES, self.root / PACKAGES)

    def tearDown(self):
        self.temporary.cleanup()

    def result_files(self):
        return sorted((self.root / readme_numbers.RESULTS).glob("*.json"))

    def measure_cubes_again(self):
        """Runs of truthcube with other times, bytes and compressions."""
        for path in (self.root / readme_numbers.RESULTS / "truthcube").glob("*.json"):
            content = json.loads(path.read_text())
            for step in [step for run in content.get("runs", []) for step in run["steps"]]:
                step["seconds"] *= 1.5
                step["compression"] /= 2
            for row in content.get("rows", []):
                row["solve_seconds"] *= 1.5
                row["iterations"] += 3
                row["cells"] *= 2
            for scene in content.get("scenes", []):
                scene["scalars"] += 1
                for run in ("own", "everything"):
                    if run in scene:
                        scene[run]["bytes"] *= 2
            for ours, other in content.get("bodies", []):
                ours["whole"]["steps"][0]["warm_seconds"] *= 1.5
                for row in [*ours["linear"], *other["linear"]]:
                    row["solve_seconds"] *= 1.5 if row["method"] == "multigrid" else 1.7
            path.write_text(json.dumps(content))

    def change(self, name, old, new):
        path = self.root / name
        text = path.read_text(encoding="utf-8")
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, 1), encoding="utf-8")

    def refused(self, *words):
        for option in ("--check", "--write"):
            done = command(option, self.root)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertNotIn("Traceback", done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)

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
        self.change("README.md", "## Words", f"{place}<!-- end of figures -->\n\n## Words")
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
        self.change("README.md", "## Words", f"{place}<!-- end of figures -->\n\n## Words")
        self.assertEqual(command("--write", self.root).returncode, 0)
        text = readme_numbers.Checkout(self.root).text("README.md")
        self.assertIn("| positions to forces on nodes, sums in any order | 1.600 | 0.320 | 5.00x | 60 | 0.75 |", text)
        self.assertIn("| the same in a fixed order | 1.600 | 0.500 | 3.20x |", text)
        self.assertIn("clamped derivative | 1.000 | 0.400 | 2.50x | 300 | 0.75 |", text)
        del content["benchmarks"][-2]
        (results / "h200_fused.json").write_text(json.dumps(content))
        self.refused("h200_fused.json has no row matrix_free_separate/aosoa32/float/cuda/*")

    # ---- What is written -----------------------------------------------------------------------------------------
    def test_write_changes_nothing_where_all_agrees(self):
        done = command("--write", self.root)
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("", "", 0))

    def test_write_puts_new_figures_and_leaves_all_other_words(self):
        def words(readme):
            text = (self.root / readme).read_text(encoding="utf-8")
            for begin, end, *_ in reversed(readme_numbers.tables(readme, text)):
                text = text[:begin] + text[end:]
            return re.sub(readme_numbers.NUMBER, "0", text)

        before = [words(readme) for readme in readme_figures.READMES]
        for path in self.result_files():
            path.write_text(json.dumps(report_test_rows.measured_again(json.loads(path.read_text()))))
        self.measure_cubes_again()
        done = command("--write", self.root)
        self.assertEqual((done.stderr, done.returncode), ("", 0))
        changed = [readme for readme in readme_figures.READMES if readme != "tools/README.md"]  # this has packages alone
        changed += [picture.path for picture in readme_figures.PICTURES]
        self.assertEqual(done.stdout.split(), changed)
        self.assertEqual([words(readme) for readme in readme_figures.READMES], before)
        self.assertEqual(command("--check", self.root).returncode, 0)
        soa = next(
            row
            for row in rows.load([str(self.root / readme_numbers.RESULTS / "h200_gathers.json")]).rows
            if (row.layout, row.set) == ("soa", "random")
        )
        self.assertIn(f"ms padded and {soa.ms:.3f} ms as Soa", (self.root / MEASURED).read_text(encoding="utf-8"))

    def test_a_new_kernel_gets_a_line_of_its_own(self):
        path = self.root / readme_numbers.RESULTS / "h200.json"
        content = json.loads(path.read_text())
        for row in [row for row in content["benchmarks"] if row["name"].startswith("stress/")]:
            content["benchmarks"].append(dict(row, name="new_" + row["name"]))
        path.write_text(json.dumps(content))
        done = command("--check", self.root)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"a table that has other lines\n\+ \| new_stress \|.*\nas in h200.json")

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
    def test_a_sentence_that_was_reworded_is_refused_with_the_remedy(self):
        self.change(MEASURED, "ms padded and", "ms when padded and")
        self.refused("results/README.md has no sentences", "{} ms padded and {} ms as Soa", readme_numbers.SENTENCES)

    def test_a_sentence_that_stands_twice_is_refused(self):
        twice = "3 sweeps up to 9 eps in float and 9 |A| in double over the sets of\n`physbench errors`\n## SVD"
        self.change("tools/fem/README.md", "## SVD", twice)
        self.refused("tools/fem/README.md has 2 sentences")

    def test_a_table_that_is_not_listed_is_refused(self):
        self.change(MEASURED, "<!-- figures: storage,", "<!-- figures: stores,")
        self.refused("results/README.md:", "no table 'stores'", "kernels, errors, storage")

    def test_a_table_without_an_end_is_refused(self):
        self.change(MEASURED, "<!-- end of figures -->\n", "")
        self.refused("results/README.md:", "no '<!-- end of figures -->' behind the table 'kernels'")

    def test_results_without_a_row_are_refused(self):
        path = self.root / readme_numbers.RESULTS / "h200_gathers.json"
        content = json.loads(path.read_text())
        content["benchmarks"] = [row for row in content["benchmarks"] if "/soa/" not in row["name"]]
        path.write_text(json.dumps(content))
        self.refused("h200_gathers.json has no row gather_nodes/soa/float/cuda/*/random", readme_numbers.SENTENCES)

    def test_missing_and_foreign_results_are_refused(self):
        path = self.root / readme_numbers.RESULTS / "h200_gathers.json"
        content = json.loads(path.read_text())
        content["context"]["results_version"] = "2"
        path.write_text(json.dumps(content))
        self.refused("h200_gathers.json: context.results_version is '2'")
        path.unlink()
        self.refused("h200_gathers.json: No such file")
        (self.root / "README.md").unlink()
        self.refused("README.md: No such file")

    def test_wrong_use_exits_with_2(self):
        for arguments in ([], ["--check", "--write"], ["--check", self.root, "more"]):
            self.assertEqual(command(*arguments).returncode, 2)


if __name__ == "__main__":
    unittest.main()
