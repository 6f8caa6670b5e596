"""Tests of what gdb shows. debugger_test.py GDB SCRIPT FOLDER PROGRAM...: the programs are made of debugged.cpp, with and without
optimisation and checks, and carry the script (physgen-gdb.py), which is also sourced where gdb may not load it from them. The
modules of the script lie in FOLDER."""
import os
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
GDB, SCRIPT, FOLDER, *PROGRAMS = sys.argv[1:]
sys.path.insert(0, FOLDER)
from physgen_gdb import elements, layout  # noqa: E402
from physgen_gdb.layout import Layout  # noqa: E402

SOA_OBJECTS = 512
IN_MAIN = ["set width 0", "set print elements 0", "set print repeats 0", "set confirm off", "break stop", "run", "up"]


ASKED = """
print -elements 1 -- aos
print -elements 1 -- aos_padded
print -elements 1 -- soa
print -elements 1 -- view
print -elements 1 -- tiles_of_8
print -elements 1 -- uniform
print -elements 1 -- thief
whatis aos[3]
soa[3].F()[2][0]
soa.get(3).a() * 2
soa.view()[3].a()
view[3].v()
one.load() + 1
formats[13].halves(2)
formats[13].halves()
formats[13].frames(1).origin()
value.F
plain
dynamic
partial
rows
rows_view
odd[7]
odd[7].weight()
odd[7].turn()
empty
stolen
garbage
garbage[3]
null_view
null_view[3]
print -elements 1 -- stray
stray[3]
aos[70]
aos[-1]
soa[3].nonsense()
""".strip().splitlines()


def session(program, expressions, before=(), options=(), loaded=True, core=()):
    """What gdb prints of expressions, or of whole commands: text by expression."""
    command = [GDB, "-nx", "-batch", *options]
    command += ["-iex", f"add-auto-load-safe-path {os.path.dirname(program)}"] if loaded else ["-ex", f"source {SCRIPT}"]
    for line in [*IN_MAIN[: 4 if core else None], *before]:
        command += ["-ex", line]
    for number, expression in enumerate(expressions):
        whole = re.match(r"(print|whatis|set|generate-core-file) ", expression)
        command += ["-ex", f"echo \\n#{number}#\\n", "-ex", expression if whole else f"print {expression}"]
    done = subprocess.run([*command, program, *core], capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    parts = re.split(r"\n#\d+#\n", done.stdout)
    if len(parts) != len(expressions) + 1 or "Exception" in done.stderr:
        raise AssertionError(f"{done.stdout}\n{done.stderr}")
    return {expression: re.sub(r"^\$\d+ = ", "", part.strip()) for expression, part in zip(expressions, parts[1:])}


def expected(program):
    """What the program says gdb should show: text by expression."""
    output = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    return dict(line.removeprefix("expected ").split(" = ", 1) for line in output.splitlines())


def numbers(text):
    return [float(number) for number in re.findall(r"-?[\d.]+(?:e[+-]?\d+)?", text)]


class GdbTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.expected = {program: expected(program) for program in PROGRAMS}
        cls.shown = {program: session(program, [*cls.expected[program], *ASKED]) for program in PROGRAMS}

    def test_objects_of_every_layout_shape_and_format_are_shown_as_the_library_reads_them(self):
        for program in PROGRAMS:
            with self.subTest(os.path.basename(program)):
                texts, shown = self.expected[program], self.shown[program]
                self.assertGreater(len(texts), 18)
                for expression, text in texts.items():
                    if "turn()" in expression:  # of a quaternion, calculated in other steps
                        for x, y in zip(numbers(shown[expression]), numbers(text), strict=True):
                            self.assertAlmostEqual(x, y, delta=1e-6)
                    else:
                        self.assertEqual(shown[expression], text, expression)

    def test_the_script_is_sourced_where_it_is_not_loaded_from_the_program(self):
        program, text = PROGRAMS[0], self.expected[PROGRAMS[0]]["soa[3]"]
        off = ["-iex", "set auto-load python-scripts off"]
        self.assertEqual(session(program, ["soa[3]"], options=off, loaded=False)["soa[3]"], text)
        self.assertNotEqual(session(program, ["soa[3]"], options=off)["soa[3]"], text)

    def test_arrays_and_views_say_how_many_objects_they_have_and_how_these_lie(self):
        for found in self.shown.values():
            shown = {expression.removeprefix("print -elements 1 -- "): text for expression, text in found.items()}
            self.assertTrue(shown["aos"].startswith("70 tissue::model::Shapes, array of structs = {{a = 0"), shown["aos"])
            self.assertIn(f"{SOA_OBJECTS} tissue::model::Shapes, struct of arrays", shown["soa"])
            self.assertIn(f"{SOA_OBJECTS} tissue::model::Shapes, struct of arrays", shown["view"])
            self.assertIn("70 tissue::model::Shapes, tiles of 8", shown["tiles_of_8"])
            self.assertIn("array of structs, padded", shown["aos_padded"])
            self.assertIn("1000 tissue::model::Shapes, one record for all", shown["uniform"])
            self.assertEqual(shown["whatis aos[3]"], "type = tissue::model::ShapesObject")

    def test_fields_and_their_elements_are_read_by_name_and_number(self):
        asked = ["soa[3].F()[2][0]", "soa.get(3).a() * 2", "formats[13].halves(2)", "formats[13].halves()", "view[3].v()",
                 "formats[13].frames(1).origin()", "one.load() + 1", "soa.view()[3].a()", "value.F", "plain", "dynamic"]  # fmt: skip
        for shown in self.shown.values():
            self.assertEqual(
                [shown[expression] for expression in asked],
                ["-6", "0.75", "15", "{13, 14, 15, 16, 17}", "{3, 4, -3}", "{13, 1, 2}", "13001", "0.375"]
                + ["{{6, 0, 0}, {8, 0, 1}, {-6, 0, 0}}", "{{1, 2, 3}, {4, 5, 6}}", "{1, 2, 3}"],
            )

    def test_rows_are_shown_with_their_entries(self):
        for shown in self.shown.values():
            for text in (shown["rows"], shown["rows_view"]):
                self.assertEqual(
                    text,
                    "3 rows of 3 elasticity::Incidence, which name 5 targets = {[0][0] = {element = 4, local = 0}, "
                    "[0][1] = {element = 2, local = 1}, [1] = no entries, [2][0] = {element = 3, local = 2}}",
                )

    def test_formats_of_a_programs_own_and_fields_that_are_not_stored_say_so(self):
        for shown in self.shown.values():
            self.assertIn("turn = nothing is stored", shown["odd[7]"])
            self.assertIn("origin [m] = {300, 301, 299}", shown["odd[7]"])
            self.assertIn("weight = bytes 0038 in a format of the program's own", shown["odd[7]"])
            self.assertIn("bytes 0038", shown["odd[7].weight()"])
            self.assertIn("nothing is stored", shown["odd[7].turn()"])

    def test_arrays_that_are_none_say_what_is_wrong(self):
        for shown in self.shown.values():
            for name in ("empty", "stolen"):
                self.assertIn("0 tissue::model::Shapes", shown[name])
            for name in ("garbage", "garbage[3]"):
                self.assertIn("corrupted, or not made yet: its size is -6510615555426900571", shown[name])
            for name in ("null_view", "null_view[3]"):
                self.assertIn("null, though its size is 30", shown[name])
            self.assertIn("no memory can be read at 0x", shown["print -elements 1 -- stray"])
            self.assertIn("no memory can be read at 0x", shown["stray[3]"])
            self.assertIn("object 70 of 70", shown["aos[70]"])
            self.assertIn("object -1 of 70", shown["aos[-1]"])
            self.assertIn("tissue::model::Shapes has no nonsense()", shown["soa[3].nonsense()"])
            self.assertIn("7 tissue::model::Shapes", shown["print -elements 1 -- thief"])

    def test_an_array_that_was_overwritten_is_found_out(self):
        spoiled = {
            "aos": ("size_ = 71000000", "are not those of 71000000 objects"),
            "aos_padded": ("buffer_.bytes_ = 27000", "are not those of 70 objects"),
            "tiles_of_2": ("buffer_.data_ = (std::byte*)0", "null, though its size is 70"),
            "tiles_of_8": ("buffer_.data_ = (std::byte*)5", "corrupted"),
            "tiles_of_64": ("buffer_.space_ = (physgen::SpaceKind)2", "corrupted"),
            "rows": ("ranges_.buffer_.data_ = (std::byte*)256", "no memory can be read at 0x100"),
            "rows_view": ("entries_.size_ = 1", "[0] = entries 0 .. 1 of 1: corrupted"),
        }
        before = [f"set var {name}.{change}" for name, (change, _) in spoiled.items()]
        for program in PROGRAMS:
            shown = session(program, [*spoiled, *(f"{name}[3]" for name in spoiled if "rows" not in name)], before=before)
            for expression, text in shown.items():
                self.assertIn(spoiled[expression.removesuffix("[3]")][1], text)

    def test_packs_and_references_to_their_objects_are_shown_by_lane(self):
        inside = ["continue", "up"]
        for program in PROGRAMS:
            self.assertEqual(self.shown[program]["partial"], "objects 18 .. 20, in a pack of 8")
            if "optimised" in program:
                continue  # there the compiler keeps no variables of a kernel
            shown = session(program, ["i", "of_pack", "gathered_at", "gathered"], before=inside)
            self.assertRegex(shown["i"], r"^objects 0 \.\. \d+, in a pack of \d+$")
            self.assertRegex(shown["of_pack"], r"^\d+ lanes = \{\{a = 0, v = \{0, 1, -0\}, .*\}, \{a = 0.125, v = \{1, 2, -1\}")
            self.assertRegex(shown["gathered_at"], r"^\{0, 1, 2")
            self.assertEqual(shown["gathered"], shown["of_pack"])

    def test_without_the_type_of_a_value_elements_are_listed_as_they_are_stored(self):
        without = ["python import sys; sys.modules['physgen_gdb'].fields.value_type = lambda *of: None"]
        shown = session(PROGRAMS[0], ["aos[3]", "nested[4].elements(1)"], before=without)
        self.assertIn("a = 0.375, v (3 stored) = {3, 4, -3}", shown["aos[3]"])
        self.assertIn("K (6 stored) [N/m] = {12, 8, -6, 0, 1, 0}, C2 (3 stored) = {0, 1, 0}", shown["aos[3]"])
        self.assertIn("U = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}", shown["aos[3]"])
        self.assertIn("no value of tissue::other::Patch is in this program", shown["nested[4].elements(1)"])

    def test_arrays_are_read_from_a_core_without_the_program(self):
        program, core = PROGRAMS[0], PROGRAMS[0] + ".core"
        text = self.expected[program]["tiles_of_8[69]"]
        session(program, [f"generate-core-file {core}"])
        try:
            self.assertEqual(session(program, ["tiles_of_8[69]"], before=["up"], core=[core])["tiles_of_8[69]"], text)
        finally:
            os.unlink(core)


class LawTest(unittest.TestCase):
    """The law of addresses in Python is that of layout/."""

    def test_pitch_padding_records_and_addresses_are_those_of_the_library(self):
        lines = subprocess.run([PROGRAMS[0], "law"], capture_output=True, text=True, check=True).stdout.splitlines()
        self.assertEqual(len(lines), 8 * 13 * 6 * 5)
        for line in lines:
            given, told = line.split(" : ")
            name, objects, content, alignment = given.rsplit(" ", 3)
            objects, content, alignment = int(objects), int(content), int(alignment)
            of = Layout(name)
            pitch, record = of.pitch(objects), of.record_bytes(content, alignment)
            places = [layout.element(256, pitch, record, of.record_of(i), content - 2, 2) for i in range(0, objects, 1 + objects // 3)]
            self.assertEqual([pitch, of.padded(objects), record, *places], [int(word) for word in told.split()], given)

    def test_a_layout_that_is_none_is_refused(self):
        for name in ("mine::Aos", "physgen::Aosoa<>", "physgen::Zigzag<2>"):
            self.assertRaises(ValueError, Layout, name)

    def test_matrices_are_put_together_from_what_is_stored(self):
        self.assertEqual(elements.rows([1, 2, 3, 4, 5, 6], (3, 3)), [[1, 2, 3], [2, 4, 5], [3, 5, 6]])
        self.assertEqual(elements.rows([1, 2, 3], (3, 3)), [[0, -1, -2], [1, 0, -3], [2, 3, 0]])
        self.assertEqual(elements.rows([1, 2, 3, 4, 5, 6], (2, 3)), [[1, 3, 5], [2, 4, 6]])
        self.assertRaises(ValueError, elements.rows, [1, 2, 3, 4], (3, 3))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
