"""Tests of pictures of layouts, through both commands: python3 layout_picture_test.py PHYSGEN"""
import contextlib
import io
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[3]
DRAW = ROOT / "tools" / "report" / "layout_picture.py"
sys.path.insert(0, str(DRAW.parent))
sys.dont_write_bytecode = True
PHYSGEN = sys.argv.pop()
SCHEMA = """#include <physgen/schema.h>
using namespace physgen::schema;
namespace m {
struct PHYSGEN_OBJECT(layout(cuda, aos_padded)) Node { Vector<3> x; };
struct PHYSGEN_OBJECT() Tet { PHYSGEN(format(cuda, half)) Matrix<3, 3> F; Scalar volume; };
}
"""


class LayoutPictureTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "a.h").write_text(SCHEMA)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def layout(self, *options):
        """The output of physgen on the schema, as a file."""
        path = self.folder / "a.json"
        subprocess.run([PHYSGEN, "layout", self.folder / "a.h", "--json", "-o", path, *options], check=True)
        return path

    def draw(self, *arguments, **options):
        done = subprocess.run([DRAW, *arguments], capture_output=True, text=True, **options)
        return done.returncode, done.stderr

    def picture(self, *options):
        """An SVG of the schema's layouts: its texts, and the kinds of its boxes."""
        target = self.folder / "a.svg"
        self.assertEqual(self.draw(self.layout(*options), "-o", target), (0, ""))
        text = target.read_text()
        xml.etree.ElementTree.fromstring(text)
        return re.findall(r">([^<>]+)</text>", text), re.findall(r'<g id="([a-z]+)-[0-9]+"', text)

    def test_a_record_has_its_padding_and_a_request_its_sectors(self):
        texts, boxes = self.picture("--object", "Node", "--space", "cuda")
        for text in ("m::Node", "aos_padded on cuda, Real = float", "records of 16 bytes, 4 of them padding", "4.00x",
                     "object 7", "object 31", "All 3 requests: 48 sectors, 4.00x the ideal 12; 16 different ones.",
                     "... 256 bytes ...", "Outlined: x[0] of objects 0 to 31, one request of a warp. Each sector that it "
                     "touches has a bar below."):  # fmt: skip
            self.assertIn(text, texts)
        # Objects 0 to 7 and 31 of three elements, each with its padding; two of them share a sector, but for the last.
        self.assertEqual([boxes.count(kind) for kind in ("cell", "padding", "request", "sector")], [27, 9, 9, 5])

    def test_a_tile_has_an_element_of_all_its_objects_side_by_side(self):
        texts, boxes = self.picture("--object", "Tet", "--space", "cuda")
        for text in ("F(0,0)", "volume", "31", "63", "half", "float", "aosoa(32) on cuda, Real = float"):
            self.assertIn(text, texts)
        self.assertEqual(boxes.count("request"), 32)
        self.assertEqual(boxes.count("sector"), 4)  # of volume, which is a float, in front
        self.assertEqual(boxes.count("padding"), 0)

    def test_every_key_of_the_json_stands_on_the_page_of_the_command(self):
        def keys(value):
            members = value.values() if isinstance(value, dict) else value if isinstance(value, list) else []
            return {*(value if isinstance(value, dict) else ())}.union(*map(keys, members))

        page = (ROOT / "tools" / "physgen" / "README.md").read_text(encoding="utf-8")
        described = page.split("## The JSON of `physgen layout`\n")[1].split("\n## ")[0]
        found = keys(json.loads(self.layout("--layout", "all").read_text()))
        self.assertGreater(len(found), 25)
        self.assertEqual(sorted(key for key in found if f"`{key}`" not in described), [])

    def test_an_array_per_object_space_and_layout(self):
        texts, _ = self.picture("--layout", "all", "--real", "double")
        self.assertEqual(texts.count("m::Node"), 5)  # aosoa(16) and aosoa(32), and three that are the same in both spaces
        self.assertEqual(texts.count("m::Tet"), 8)

    def test_the_same_layout_gives_the_same_bytes_from_a_file_and_from_standard_input(self):
        path = self.layout("--object", "Node")
        for name in ("one.svg", "two.svg"):
            with path.open() as stream:
                self.assertEqual(self.draw("-", "-o", self.folder / name, stdin=stream), (0, ""))
        self.assertEqual(self.draw(path, "-o", self.folder / "three.svg"), (0, ""))
        pictures = {(self.folder / f"{name}.svg").read_bytes() for name in ("one", "two", "three")}
        self.assertEqual(len(pictures), 1)

    def test_a_png_is_a_png(self):
        target = self.folder / "a.png"
        self.assertEqual(self.draw(self.layout("--object", "Node", "--space", "host"), "-o", target), (0, ""))
        self.assertTrue(target.read_bytes().startswith(b"\x89PNG"))

    def test_a_png_higher_than_matplotlib_draws_is_refused(self):
        import drawing
        import layout_picture

        target, errors = self.folder / "high.png", io.StringIO()
        with unittest.mock.patch.object(drawing, "PNG_MOST", 200), contextlib.redirect_stderr(errors):
            self.assertEqual(layout_picture.main([str(self.layout()), "-o", str(target)]), 2)
            self.assertEqual(layout_picture.main([str(self.layout()), "-o", str(self.folder / "high.svg")]), 0)
        self.assertRegex(errors.getvalue(), r"its 4 arrays is \d+ pixels high.* at most 200; write a \.svg, or fewer arrays")
        self.assertFalse(target.exists())

    def test_files_that_physgen_did_not_write_are_refused(self):
        def damaged(change):
            content = json.loads(self.layout().read_text())
            change(content["arrays"][0])
            return json.dumps(content)

        target = self.folder / "refused.svg"
        for text, why in (("{", "is not JSON"), ("[]", "is not a file of layouts of format 1"),
                          ('{"physgen_layout": 2}', "is not a file of layouts of format 1"),
                          (damaged(lambda array: array["rows"][0]["boxes"][0].pop("end")), "is damaged (KeyError: 'end')"),
                          (damaged(lambda array: array["rows"][0]["boxes"][0].update(elements=0)), "is damaged (ZeroDiv"),
                          (damaged(lambda array: array.update(warp=7)), "is damaged (TypeError")):  # fmt: skip
            path = self.folder / "wrong.json"
            path.write_text(text)
            status, message = self.draw(path, "-o", target)
            self.assertEqual(status, 2)
            self.assertIn(f"layout_picture.py: {path} {why}", message)
            self.assertIn("give a file that 'physgen layout SCHEMA --json -o x.json' wrote", message)
        self.assertIn("cannot open", self.draw(self.folder / "absent.json", "-o", target)[1])
        self.assertIn("ends neither with .svg nor with .png", self.draw(path, "-o", self.folder / "a.pdf")[1])
        self.assertFalse(target.exists())


if __name__ == "__main__":
    unittest.main()
