"""The common part of the tests of readme_numbers.py: a copy of the pages and results that it reads, and how it is called."""
import collections
import contextlib
import io
import json
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
TOOL = ROOT / "tools" / "report" / "readme_numbers.py"
sys.path.insert(0, str(TOOL.parent))
import readme_numbers  # noqa: E402

PACKAGES = "tools/packages.txt"
SCENES = "generated/scenes"
MEASURED = "tools/report/results/README.md"
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


class ReadmeCase(unittest.TestCase):
    def setUp(self):
        """A copy of what the command reads and writes."""
        self.temporary = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.temporary.name)
        for page in readme_numbers.PAGES:
            (self.root / page).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / page, self.root / page)
        shutil.copytree(ROOT / readme_numbers.RESULTS, self.root / readme_numbers.RESULTS, dirs_exist_ok=True)
        shutil.copytree(ROOT / SCENES, self.root / SCENES)
        shutil.copy(ROOT / PACKAGES, self.root / PACKAGES)

    def tearDown(self):
        self.temporary.cleanup()

    def result_files(self):
        return sorted((self.root / readme_numbers.RESULTS).glob("*.json"))

    def measure_cubes_again(self):
        """Runs of truthcube with other times, bytes and compressions, and links with other times."""
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
        solves = self.root / readme_numbers.RESULTS / "ranks" / "solves.json"
        content = json.loads(solves.read_text())
        for row in content["rows"]:
            row["seconds"] *= 1.5
        solves.write_text(json.dumps(content))
        links = self.root / readme_numbers.RESULTS / "ranks" / "links.json"
        content = json.loads(links.read_text())
        for row in content["rows"]:
            row["us"] *= 2
        links.write_text(json.dumps(content))

    def change(self, name, old, new):
        path = self.root / name
        text = path.read_text(encoding="utf-8")
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, 1), encoding="utf-8")

    def append(self, name, text):
        path = self.root / name
        path.write_text(path.read_text(encoding="utf-8") + text, encoding="utf-8")

    def refused(self, *words):
        for option in ("--check", "--write"):
            done = command(option, self.root)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertNotIn("Traceback", done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)
