"""Tests of how the sources hang together. A unit is a header with the sources that implement it."""
import collections
import pathlib
import re
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
# Folders whose sources are included by these paths.
SEARCHED = ("runtime/include", "runtime/src", "generator", "schemas", "tools", "tools/physbench", "tools/truthcube", "tools/physgen")
# The folders of the solver, from the ground up. Its interface is below them, since all of them include it.
SOLVER = (
    *("", "/hierarchy", "/arrays", "/loads", "/elastic", "/levels", "/preconditioners/jacobi", "/preconditioners/none"),
    *("/preconditioners/multigrid", "/preconditioners/schwarz", "/preconditioners", "/linear", "/newton", "/solvers"),
)
# The rooms of the house from the ground up: what stands in one of them includes nothing from those behind it.
ROOMS = (
    *("runtime/include", "runtime/src", "schemas"),
    *("generator/model", "generator/plan", "generator/emit", "generator/frontend", "generator/usage"),
    *("generator/scenes", "tools/physgen"),
    *("tools/fem/numerics", "tools/fem/materials", "tools/fem/mesh", "tools/fem/kernels", "tools/fem/reference"),
    *(f"tools/fem/solver{folder}" for folder in SOLVER),
    *("tools/fem/dynamics", "tools/fem/solver/scenes"),
    *("tools/truthcube/output", "tools/truthcube"),
    *("tools/physbench/data", "tools/physbench/kernels", "tools/physbench/measure", "tools/physbench/coalescing"),
    *("tools/physbench/groups", "tools/physbench/vendor", "tools/physbench/report", "tools/physbench/linear_solves"),
    *("tools/physbench", "tools/examples"),
)
# The headers that users include; all others stand in folders that say what for.
DOORS = """cell_list channel config device error executor fill_rows format fuse gather kernel layout mirror parallel_for
    parallel_reduce print probe random row_arrays rows runtime save save_npy scan scene schema sort threads topology version""".split()
LONGEST = 300  # of a file that people write, in lines
WRITTEN = (".h", ".cpp", ".cu", ".py", ".sh", ".cmake", ".in", "CMakeLists.txt", "tools/dev")  # how their paths end


def sources(root):
    """Hand-written C++ and CUDA of the parts, without their tests."""
    for part in ("runtime", "generator", "schemas", "tools"):
        for path in sorted((root / part).rglob("*")):
            if path.suffix in (".h", ".cpp", ".cu") and path.is_file():
                yield path.relative_to(root)


def includes(root, path, known):
    """The sources that one of them includes."""
    for name in re.findall(r'^#include [<"]([^>"]+)[>"]', (root / path).read_text(), re.M):
        here = pathlib.Path(path.parent, name)
        candidates = [pathlib.Path(*resolved(here.parts)), *(pathlib.Path(folder, name) for folder in SEARCHED)]
        yield from [candidate for candidate in candidates if candidate in known][:1]


def resolved(parts):
    """A path without steps up."""
    done = []
    for part in parts:
        done = done[:-1] if part == ".." else [*done, part]
    return done


def unit(path):
    """The unit of a source: a header's own path stands for it, and backends implement the headers of backend/."""
    name = path.with_suffix("").as_posix()
    name = re.sub(r"^runtime/(include/physgen|src)/", "runtime/", name)
    return re.sub(r"^runtime/(no_)?cuda/(?=[a-z]+$)", "runtime/backend/", name) if "src" in path.parts else name


def graph(root):
    """The units that every unit includes."""
    known = set(sources(root))
    edges = collections.defaultdict(set)
    for path in known:
        edges[unit(path)] |= {unit(other) for other in includes(root, path, known)} - {unit(path)}
    return edges


def circles(edges):
    """Groups of units each of which includes all others, by way of some."""
    found, low, stack, groups = {}, {}, [], []

    def visit(node):
        found[node] = low[node] = len(found)
        stack.append(node)
        for other in edges.get(node, ()):
            if other not in found:
                visit(other)
            if other in stack:
                low[node] = min(low[node], low[other])
        if low[node] == found[node]:
            at = stack.index(node)
            groups.append(sorted(stack[at:]))
            del stack[at:]

    for node in sorted(edges):
        if node not in found:
            visit(node)
    return [group for group in groups if len(group) > 1]


def room(path):
    """The room of a source: the longest name that its path begins with."""
    rooms = [name for name in ROOMS if path.as_posix().startswith(name + "/")]
    return max(rooms, key=len, default=None)


def upward(root):
    """Includes from rooms behind one's own, as text."""
    known = set(sources(root))
    return [
        f"{path} includes {other}, of {room(other)}"
        for path in sorted(known)
        for other in includes(root, path, known)
        if ROOMS.index(room(path)) < ROOMS.index(room(other))
    ]


def written(root):
    """Code of every language that people write, tests and scripts included; physgen wrote *.physgen.h."""
    for part in ("runtime", "generator", "schemas", "tools", "tests"):
        for path in sorted((root / part).rglob("*")):
            if path.is_file() and path.as_posix().endswith(WRITTEN) and not path.name.endswith(".physgen.h"):
                yield path.relative_to(root)


def too_long(root):
    """Files that people write with more lines than LONGEST, as text."""
    lengths = {path: len((root / path).read_text(encoding="utf-8").splitlines()) for path in written(root)}
    return [f"{path}: {lines} lines" for path, lines in lengths.items() if lines > LONGEST]


def backends(root):
    """The names of the files of both backends, without their endings."""
    folders = (root / "runtime/src/cuda", root / "runtime/src/no_cuda")
    return [sorted(path.stem for path in folder.iterdir() if path.is_file()) for folder in folders]


def details_first(root):
    """Public headers of the runtime that do not begin with a comment, or have inner parts before what they offer."""
    folder = root / "runtime/include/physgen"
    found = []
    for path in sorted(folder.rglob("*.h")):
        text = path.read_text(encoding="utf-8")
        before, inner, _ = text.partition("\nnamespace detail {")
        offers = re.search(r"(?m)^(template|struct|class|enum|using|inline|constexpr|concept|\[\[|PHYSGEN|#define)", before)
        if path.parent != folder / "detail" and (not text.startswith("// ") or (inner and not offers)):
            found.append(path.relative_to(folder).as_posix())
    return found


class StructureTest(unittest.TestCase):
    def test_every_source_has_a_room(self):
        self.assertEqual([str(path) for path in sources(ROOT) if room(path) is None], [])

    def test_no_source_includes_from_a_room_above_its_own(self):
        self.assertEqual(upward(ROOT), [])

    def test_no_units_include_each_other(self):
        edges = graph(ROOT)
        self.assertGreater(sum(map(len, edges.values())), 1000)
        self.assertEqual(circles(edges), [])

    def test_no_file_is_longer_than_a_concept(self):
        self.assertGreater(sum(1 for _ in written(ROOT)), 700)
        self.assertEqual(too_long(ROOT), [])

    def test_public_headers_begin_with_what_they_offer(self):
        self.assertEqual(details_first(ROOT), [])

    def test_the_headers_on_top_of_the_runtime_are_those_that_users_include(self):
        folder = ROOT / "runtime/include/physgen"
        self.assertEqual(sorted(path.stem for path in folder.glob("*.h")), DOORS)
        page = (ROOT / "runtime/README.md").read_text(encoding="utf-8")
        for path in folder.iterdir():
            self.assertTrue(path.is_file() or f"`{path.name}/`" in page or f"/{path.name}/`" in page, path)

    def test_both_backends_have_the_same_files(self):
        with_cuda, without = backends(ROOT)
        self.assertGreater(len(with_cuda), 3)
        self.assertEqual(with_cuda, without)


class FaultsTest(unittest.TestCase):
    """Faults in a small tree are found."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def write(self, name, *included, lines=0):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(f"#include {other}\n" for other in included) + "\n" * lines)

    def test_a_circle_by_way_of_sources_is_found(self):
        self.write("runtime/include/physgen/copy.h")
        self.write("runtime/src/copy.cpp", "<physgen/copy.h>", '"plain.h"')
        self.write("runtime/src/plain.h")
        self.write("runtime/src/plain.cpp", '"backend/memory.h"')
        self.write("runtime/src/backend/memory.h")
        self.assertEqual(circles(graph(self.root)), [])
        self.write("runtime/src/cuda/memory.cu", '"../backend/memory.h"', "<physgen/copy.h>")
        self.assertEqual(circles(graph(self.root)), [["runtime/backend/memory", "runtime/copy", "runtime/plain"]])

    def test_a_circle_of_the_generator_is_found(self):
        self.write("generator/model/limits.h")
        self.write("generator/model/validate.h", '"model/limits.h"')
        self.write("generator/model/validate.cpp", '"model/validate.h"', '"model/rules.h"')
        self.write("generator/model/rules.h")
        self.write("generator/model/rules.cpp", '"model/rules.h"', '"model/limits.h"')
        self.assertEqual(circles(graph(self.root)), [])
        self.write("generator/model/rules.cpp", '"model/rules.h"', '"model/validate.h"')
        self.assertEqual(circles(graph(self.root)), [["generator/model/rules", "generator/model/validate"]])

    def test_an_include_from_above_is_found(self):
        self.write("runtime/src/a.cpp", "<physgen/a.h>", "<fem/kernels/a.h>")
        self.write("runtime/include/physgen/a.h")
        self.write("tools/fem/kernels/a.h", "<physgen/a.h>")
        self.assertEqual(upward(self.root), ["runtime/src/a.cpp includes tools/fem/kernels/a.h, of tools/fem/kernels"])

    def test_a_schema_that_includes_what_is_made_of_it_is_found(self):
        self.write("schemas/a.h", "<physgen/schema.h>", "<fem/kernels/a.h>")
        self.write("runtime/include/physgen/schema.h")
        self.write("tools/fem/kernels/a.h")
        self.assertEqual(upward(self.root), ["schemas/a.h includes tools/fem/kernels/a.h, of tools/fem/kernels"])

    def test_a_public_header_that_begins_with_inner_parts_is_found(self):
        folder = self.root / "runtime/include/physgen"
        (folder / "detail").mkdir(parents=True)
        inner, offered = "namespace detail {\nint f();\n}\n", "inline int g();\n"
        (folder / "first.h").write_text("// Numbers.\n" + inner + offered)
        (folder / "last.h").write_text("// Numbers.\n" + offered + inner)
        (folder / "silent.h").write_text("#pragma once\n" + offered)
        (folder / "detail/all.h").write_text("// Numbers.\n" + inner)
        self.assertEqual(details_first(self.root), ["first.h", "silent.h"])

    def test_a_long_source_and_a_missing_one_of_a_backend_are_found(self):
        self.write("runtime/src/cuda/memory.cu", lines=LONGEST + 1)
        self.write("runtime/src/no_cuda/device.cpp", lines=LONGEST)
        self.write("tests/golden/a.physgen.h", lines=LONGEST + 1)
        self.write("tools/dev", lines=LONGEST + 2)
        self.assertEqual(
            too_long(self.root), [f"runtime/src/cuda/memory.cu: {LONGEST + 1} lines", f"tools/dev: {LONGEST + 2} lines"]
        )
        self.assertEqual(backends(self.root), [["memory"], ["device"]])


if __name__ == "__main__":
    unittest.main()
