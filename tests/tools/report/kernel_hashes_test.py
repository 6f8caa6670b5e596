"""Tests of the hashes of compiled kernels: kernel_hashes_test.py COMPILER [NVCC]"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools" / "report"))
import kernel_hashes  # noqa: E402

COMPILER, *NVCC = sys.argv[1:]
HOST = """#include <cmath>
template <class T>
T square(T x) { return x * x + T(3); }
double kernel(double x) { return std::sin(square(x)) * 0.5; }
"""
CUDA = """namespace {
__constant__ float table[4];
__device__ float scaled(float x) { return x * 3; }
}
static __global__ void own(float* p) { p[threadIdx.x] = scaled(p[threadIdx.x]) + table[threadIdx.x & 3]; }
template <class T>
__global__ void kernel(T* p, int n) { if (threadIdx.x < n) p[threadIdx.x] += T(1); }
void launch(float* p, int n) { kernel<<<1, 32>>>(p, n); own<<<1, 4>>>(p); }
"""


class KernelHashesTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def object(self, text, name, *command):
        source, compiled = self.folder / name, self.folder / (name + ".o")
        source.write_text(text)
        subprocess.run([*command, "-c", source, "-o", compiled], check=True)
        return compiled

    def host(self, text, *flags, name="a.cpp"):
        return kernel_hashes.of([self.object(text, name, COMPILER, "-std=c++20", "-O2", *flags)])

    def cuda(self, text, name="a.cu"):
        command = [*NVCC, "-std=c++20", "--no-compress"]
        return kernel_hashes.of([self.object(text, name, *command)])

    def test_comments_lines_names_and_what_debuggers_read_do_not_count(self):
        expected = self.host(HOST)
        self.assertEqual(len(expected), 16)
        self.assertEqual(self.host(HOST.replace("template", "// A comment.\n\ntemplate")), expected)
        self.assertEqual(self.host(HOST.replace("(T x)", "(T y)").replace("x * x", "y * y")), expected)
        self.assertEqual(self.host(HOST, "-g"), expected)
        self.assertEqual(self.host(HOST, name="b.cpp"), expected)

    def test_instructions_constants_functions_that_are_called_and_options_count(self):
        changed = [HOST.replace("x * x", "x * x * x"), HOST.replace("0.5", "0.25"), HOST.replace("std::sin", "std::cos")]
        found = {self.host(text) for text in (HOST, *changed)} | {self.host(HOST, "-O0")}
        self.assertEqual(len(found), 5)

    @unittest.skipUnless(NVCC, "this build is without CUDA")
    def test_the_same_holds_of_kernels_of_cuda(self):
        expected = self.cuda(CUDA)
        self.assertEqual(self.cuda(CUDA.replace("template", "// A comment.\n\ntemplate")), expected)
        self.assertEqual(self.cuda(CUDA, name="b.cu"), expected)
        changed = [CUDA.replace("T(1)", "T(2)"), CUDA.replace("x * 3", "x * 4"), CUDA.replace("<<<1, 32>>>", "<<<1, 64>>>")]
        self.assertEqual(len({expected, *map(self.cuda, changed)}), 4)

    def test_the_command_writes_a_line_for_each_key(self):
        first, second = (self.object(HOST, name, COMPILER, "-std=c++20") for name in ("a.cpp", "b.cpp"))
        out = self.folder / "made_up/tools/physbench/hashes/rows.txt"
        out.parent.mkdir(parents=True)
        command = [sys.executable, ROOT / "tools/report/kernel_hashes.py", "-o", out, "--objects", first, second, "--keys"]
        subprocess.run([*command, "scene/host/svd=a.cpp", "storage/host=b.cpp", "scene/host/stress=a.cpp"], check=True)
        hashed = kernel_hashes.of([first])
        self.assertEqual(
            out.read_text(), f"scene/host/stress {hashed}\nscene/host/svd {hashed}\nstorage/host {kernel_hashes.of([second])}\n"
        )
        self.assertIn(f'"scene/host/svd {hashed}\\n"', out.with_suffix(".cpp").read_text())
        self.assertEqual(kernel_hashes.of_builds(self.folder)["scene/host/svd"], {hashed})
        done = subprocess.run([*command, "scene/host/svd=c.cpp"], capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "kernel_hashes.py: 0 objects are of c.cpp, which has the kernels of scene/host/svd\n")

    def test_files_that_are_no_objects_are_refused(self):
        (self.folder / "a.o").write_text("text")
        with self.assertRaisesRegex(ValueError, "a.o is no object or program of 64 bits"):
            kernel_hashes.of([self.folder / "a.o"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
