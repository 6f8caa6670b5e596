"""Tests of the form of result files, and that the checked-in ones have it: result_lines_test.py"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools" / "report"))
import result_lines  # noqa: E402

CONTENT = {"context": {"cpu": "a, b: {c}", "caches": [{"level": 1}]}, "rows": [{"ms": 1.0, "steps": [{"n": 1}]}, {"ms": None}]}
TEXT = """{
 "context": {
  "cpu": "a, b: {c}",
  "caches": [
   {"level": 1}
  ]
 },
 "rows": [
  {"ms": 1.0, "steps": [{"n": 1}]},
  {"ms": null}
 ]
}
"""


class ResultLinesTest(unittest.TestCase):
    def command(self, text):
        """@return the command's outcome for a file of this text, and what is in the file then"""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.json"
            path.write_text(text)
            done = subprocess.run(
                [sys.executable, ROOT / "tools/report/result_lines.py", path], capture_output=True, text=True, check=False
            )
            return done, path.read_text()

    def test_every_checked_in_result_has_a_row_a_line(self):
        files = sorted((ROOT / "tools/report/results").rglob("*.json"))
        self.assertGreater(len(files), 15)
        for path in files:
            self.assertTrue(
                result_lines.is_formed(path.read_text(encoding="utf-8")),
                f"{path} has other lines; to bring it into form: tools/report/result_lines.py {path}",
            )

    def test_a_row_is_one_line_and_what_it_holds_stays(self):
        self.assertEqual(result_lines.text(CONTENT), TEXT)
        self.assertEqual(json.loads(TEXT), CONTENT)
        self.assertEqual(result_lines.text([[{"a": 1}], [], 2]), '[\n [\n  {"a": 1}\n ],\n [],\n 2\n]\n')
        self.assertEqual(result_lines.text({}), "{}\n")

    def test_other_spellings_of_numbers_and_blanks_have_the_form_too(self):
        self.assertTrue(result_lines.is_formed(TEXT))
        self.assertTrue(result_lines.is_formed(TEXT.replace("1.0", "1.000e+00").replace("\n ", "\n     ")))
        self.assertTrue(result_lines.is_formed('{\n "caches": [\n ]\n}\n'))  # of a machine whose caches are not known
        self.assertTrue(result_lines.is_formed('{\n "caches": []\n}\n'))

    def test_other_lines_do_not_have_the_form(self):
        for other in (TEXT.replace(', "steps"', ',\n"steps"'), TEXT.replace("},\n  {", "}, {"), json.dumps(CONTENT)):
            self.assertFalse(result_lines.is_formed(other), other)

    def test_the_command_changes_lines_and_no_value(self):
        done, text = self.command(json.dumps(CONTENT, indent=4))
        self.assertEqual((done.returncode, done.stderr, text), (0, "", TEXT))
        done, text = self.command(TEXT)
        self.assertEqual((done.returncode, done.stdout, text), (0, "", TEXT))

    def test_what_would_lose_a_value_is_refused(self):
        twice = '{"rows": [{"ms": 1, "ms": 2}]}'
        done, text = self.command(twice)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("a key stands twice among ms, ms", done.stderr)
        self.assertEqual(text, twice)
        self.assertFalse(result_lines._same({"a": 1}, {"a": 1.0}))


unittest.main()
