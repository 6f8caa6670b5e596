"""Tests of the hashes of sources, in tools/report/sources.py and when physbench is built: sources_test.py CMAKE"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools" / "report"))
import sources  # noqa: E402

CMAKE = "cmake"


def of_the_build(checkout):
    """The hashes that physbench built from that checkout prints."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "sources.cpp"
        script = ROOT / "tools" / "physbench" / "sources.cmake"
        subprocess.run(
            [CMAKE, "-D", f"CHECKOUT={checkout}", "-D", f"OUTPUT={output}", "-P", script],
            check=True,
            capture_output=True,
        )
        return re.search(r'return "(.*)";', output.read_text())[1]


class SourcesTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="a+b (c) ")
        self.checkout = pathlib.Path(self.temporary.name)
        self.write("runtime/include/a.h", "// [0] ${x} \\ ; µ \"q\" ]]\n")
        self.write("runtime/a-b.cpp", "")
        self.write("runtime/a/b.cu", "no end of line")
        self.write("runtime/CMakeLists.txt", "\n\n \n")
        self.write("tools/physbench/rows.cpp.in", "@x@ \\\n")
        self.write("tools/physbench/a.cmake", "set(x)\n")

    def tearDown(self):
        self.temporary.cleanup()

    def write(self, name, content):
        path = self.checkout / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode())

    def hashes(self):
        found = sources.hashes(self.checkout)
        self.assertEqual(of_the_build(self.checkout), sources.text(found))
        return found

    def test_build_and_report_agree_on_this_checkout(self):
        self.assertEqual(of_the_build(ROOT), sources.text(sources.hashes()))

    def test_command_prints_what_physbench_writes(self):
        tool = ROOT / "tools" / "report" / "sources.py"
        done = subprocess.run([sys.executable, tool, self.checkout], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, of_the_build(self.checkout) + "\n")
        self.assertEqual(sources.parse(done.stdout.rstrip()), self.hashes())
        wrong = subprocess.run([sys.executable, tool, "/no/such"], capture_output=True, check=False)
        self.assertNotEqual(wrong.returncode, 0)

    def test_hash_is_that_of_sha256sum(self):
        files = ["CMakeLists.txt", "a-b.cpp", "a/b.cu", "include/a.h"]
        lines = subprocess.run(
            ["sha256sum", *(f"runtime/{file}" for file in files)], cwd=self.checkout, capture_output=True, check=True
        ).stdout
        whole = subprocess.run(["sha256sum"], input=lines, capture_output=True, check=True).stdout.decode()
        self.assertEqual(self.hashes()["runtime"], whole[:16])

    def test_every_kind_of_source_counts_in_its_group_alone(self):
        for name in (
            "runtime/include/a.h",
            "runtime/a-b.cpp",
            "runtime/a/b.cu",
            "runtime/CMakeLists.txt",
            "tools/physbench/rows.cpp.in",
            "tools/physbench/a.cmake",
            "generated/elasticity.physgen.h",
            "tools/fem/kernels/new.h",
            "tools/fem/reference/new.cpp",
        ):
            with self.subTest(name):
                before = self.hashes()
                self.write(name, "// a comment\n")
                group = next(group for group in before if (name + "/").startswith(group + "/"))
                self.assertEqual([key for key, value in self.hashes().items() if value != before[key]], [group])

    def test_names_of_files_count(self):
        before = self.hashes()
        (self.checkout / "runtime/a/b.cu").rename(self.checkout / "runtime/a/c.cu")
        self.assertNotEqual(self.hashes()["runtime"], before["runtime"])

    def test_line_endings_and_other_files_do_not_count(self):
        before = self.hashes()
        self.write("runtime/CMakeLists.txt", "\r\n\r\n \r\n")
        self.write("runtime/README.md", "text")
        self.write("tools/report/report.py", "text")
        self.write("tests/a.cpp", "text")
        self.write("generated/solver.physgen.h", "text")
        self.write("tools/fem/solver/newton.h", "text")
        self.assertEqual(self.hashes(), before)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        CMAKE = sys.argv.pop(1)
    unittest.main()
