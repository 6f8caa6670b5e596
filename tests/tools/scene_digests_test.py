"""Tests of scene_digests.py: faults that are planted in copies of generated/scenes are found and named."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
CHECKED_IN = HERE.parents[1] / "generated" / "scenes"


class SceneDigestsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.found, self.known = (pathlib.Path(folder.name) / name for name in ("found", "known"))
        for copied in (self.found, self.known):
            shutil.copytree(CHECKED_IN, copied)

    def compare(self, mode="--all"):
        command = [sys.executable, HERE / "scene_digests.py", mode, self.found, self.known]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.returncode, done.stderr

    def change(self, folder, old, new):
        file = folder / "force_chain.digest"
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new, 1))

    def refused(self, *words, mode="--all"):
        status, said = self.compare(mode)
        self.assertEqual(status, 1, said)
        for word in (*words, "tools/dev build release update-generated"):
            self.assertIn(word, said)

    def test_equal_digests_pass(self):
        self.assertEqual(self.compare(), (0, ""))
        self.assertEqual(self.compare("--on-the-cpu"), (0, ""))

    def test_a_field_of_another_fate_is_named_with_its_scene(self):
        self.change(self.known, "field s float32 3 local", "field s float32 3 pruned")
        self.refused("scene force_chain: field body.svds.s: 'float32 3 local read written' is found, and the digest has 'float32 "
                     "3 pruned read written'")

    def test_a_use_that_the_digest_lacks_is_named_on_the_cpu_too(self):
        self.change(self.known, " body.svds.V", "")
        for mode in ("--all", "--on-the-cpu"):
            self.refused("scene force_chain: step physgen::fem::ComputeStress(body.svds, body.stresses): field body.svds.V is own, "
                         "which the digest does not say", mode=mode)

    def test_what_programs_do_on_cuda_alone_is_missing_on_the_cpu_without_a_word(self):
        self.change(self.found, " body.svds.V", "")
        self.change(self.found, "field V float32 9 local read", "field V float32 9 pruned")
        self.assertEqual(self.compare("--on-the-cpu"), (0, ""))
        self.refused("the digest says that field body.svds.V is read, which is not found")

    def test_steps_and_arrays_that_one_side_lacks_are_named(self):
        self.change(self.known, "step physgen::fem::ComputeStress(", "step physgen::fem::Other(")
        self.change(self.known, "array body.svds of", "array body.others of")
        self.refused("step physgen::fem::ComputeStress(body.svds, body.stresses): it is in the program, not in the digest",
                     "step physgen::fem::Other(body.svds, body.stresses): it is in the digest, not in the program",
                     "array body.svds: it is in the scene, not in the digest")

    def test_records_and_joined_steps_are_compared(self):
        self.change(self.known, "; aos_padded 16 of 16 bytes", "; aos 12 of 12 bytes")
        self.change(self.known, "; local body.gradients, ", "; local ")
        self.refused("array body.positions: ", "aos 12 of 12 bytes", "'joined: ")

    def test_a_digest_that_is_missing_or_none_is_named(self):
        (self.known / "quasistatic.digest").unlink()
        self.change(self.known, "array body.tets of", "arrays body.tets of")
        self.refused("scene quasistatic: there is no ", "is not a line of a digest")
        self.change(self.known, "format 1", "format 2")
        self.refused("has no line 'format 1'")

    def test_reports_of_an_older_checkout_are_refused(self):
        (self.known / "force_chain.need.json").write_text("{}")
        self.refused("force_chain.need.json: no files of this folder, but reports of an older checkout; delete them")


unittest.main()
