"""Tests of what Python sees of arrays. arrays_test.py FOLDER: the module `everything` lies there, of the golden schema of that name,
which has every shape and element type."""
import gc
import sys
import timeit
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))
import numpy as np  # noqa: E402

import everything  # noqa: E402
from drawn import values  # noqa: E402

LAYOUTS = ("aos", "aos_padded", "soa", "aosoa(4)", "aosoa(16)", "aosoa(64)")
WHOLE = ("aos", "aos_padded", "soa")  # layouts of which one stride says where the objects lie


class Views(unittest.TestCase):
    def test_shapes_are_those_of_the_schema_and_numbers_those_of_the_layout(self):
        # Matrices lie column by column; of symmetric and skew-symmetric ones a triangle is stored.
        of = everything.Shapes(100, layout="aos")
        for name, shape, strides in (("a", (), ()), ("v", (3,), (4,)), ("nodes", (4,), (4,)), ("F", (3, 3), (4, 12)),
                                     ("B", (2, 3), (4, 8)), ("row", (1, 4), (4, 4)), ("K", (6,), (4,)), ("C2", (3,), (8,)),
                                     ("s", (3,), (4,)), ("W", (3,), (4,)), ("U", (3, 3), (4, 12))):
            view = of[name]
            self.assertEqual(view.shape, (100, *shape), name)
            self.assertEqual(view.strides[1:], strides, name)
            self.assertTrue(view.flags.writeable, name)
        self.assertEqual(of.nodes.dtype, np.int32)
        self.assertEqual(of.C2.dtype, np.float64)
        self.assertEqual(everything.Shapes(3, precision="double").F.dtype, np.float64)
        entries = everything.Entries(50, layout="soa")
        self.assertEqual(entries.k.shape, (50, 4, 6))
        self.assertEqual(entries.edges.shape, (50, 6, 2))

    def test_what_is_written_through_views_is_what_the_library_copies_to_every_layout(self):
        for precision in ("float", "double"):
            for first in WHOLE:
                of = everything.Shapes(77, layout=first, precision=precision)
                expected = {}
                for seed, name in enumerate(of.units):
                    expected[name] = values(of[name].shape, seed, np.float32) * 100
                    of[name][...] = expected[name]
                for layout in LAYOUTS:
                    other = of.copy(layout=layout)
                    self.assertEqual(other.layout, layout)
                    for name, given in expected.items():
                        np.testing.assert_array_equal(other[name], given.astype(other[name].dtype), f"{name} in {layout}")

    def test_assignment_sets_one_field_in_every_layout_and_leaves_the_others(self):
        for layout in LAYOUTS:
            of = everything.Shapes(53, layout=layout)
            for name in of.units:
                of[name] = 7
            given = values((53, 3, 3))
            of.F = given
            for name in of.units:
                np.testing.assert_array_equal(of[name], given if name == "F" else np.full(of[name].shape, 7), f"{name} in {layout}")

    def test_values_need_not_be_contiguous_nor_of_the_same_type(self):
        for layout in LAYOUTS:
            of = everything.Shapes(20, layout=layout)
            wide = values((40, 3, 6), dtype=np.float64)
            for given in (wide[::2, :, ::-2], np.asfortranarray(wide[:20, :, :3]), wide[19::-1, :, 3:].astype(np.float16)):
                of.F = given
                np.testing.assert_array_equal(of.F, given.astype(np.float32))
            given = values((20, 3))
            given.setflags(write=False)
            of.v = given
            np.testing.assert_array_equal(of.v, given)
            of.v = [1, 2, 3]
            np.testing.assert_array_equal(of.v, np.tile([1, 2, 3], (20, 1)))
            of.v = of.v[::-1]  # memory of its own
            of.nodes = np.arange(80, dtype=np.int64).reshape(20, 4)
            np.testing.assert_array_equal(of.nodes[:, 1], np.arange(80)[1::4])

    def test_tiles_show_the_memory_of_every_layout(self):
        for layout in LAYOUTS:
            of = everything.Shapes(70, layout=layout)
            of.F = given = values((70, 3, 3))
            tiles = of.tiles("F")
            self.assertEqual(tiles.shape[2:], (3, 3))
            np.testing.assert_array_equal(tiles.reshape(-1, 3, 3)[:70], given)
            tiles[0, 0] = 5
            np.testing.assert_array_equal(of.F[0], np.full((3, 3), 5))
        self.assertEqual(everything.Shapes(70, layout="aosoa(16)").tiles("v").shape, (5, 16, 3))

    def test_nested_objects_are_parts_with_fields(self):
        of = everything.Element(9, layout="aos")
        of.lame.mu = 3
        of.fibres[1].direction = [1, 2, 3]
        of.fibres[0].direction[4] = [7, 8, 9]
        of.shapes.F[2, 0, 1] = 4
        self.assertEqual(of["lame.mu"].sum(), 27)
        np.testing.assert_array_equal(of["fibres[1].direction"][8], [1, 2, 3])
        np.testing.assert_array_equal(of["fibres[0].direction"].sum(axis=0), [7, 8, 9])
        self.assertEqual(of["shapes.F"].sum(), 4)
        self.assertEqual(getattr(of.lame, "lambda").sum(), 0)
        self.assertEqual(len(list(of.fibres)), 2)
        self.assertEqual(of.units["lame.mu"], "Pa")
        self.assertIn("direction", dir(of.fibres[0]))
        for name in ("shapes", "lame", "volume"):
            self.assertIn(name, dir(of))

    def test_new_objects_have_the_values_of_the_schema(self):
        of = everything.Options(40)
        self.assertEqual((of.layout, of.precision, len(of)), ("soa", "float", 40))
        np.testing.assert_array_equal(of.density, np.full(40, 1060, np.float32))
        of.resize(3)
        of.density = 1
        of.resize(1000)
        np.testing.assert_array_equal(of.density, [1] * 3 + [1060] * 997)


class Refused(unittest.TestCase):
    def refuses(self, error, words, call):
        with self.assertRaisesRegex(error, words):
            call()

    def test_counts_layouts_and_precisions_that_there_are_not(self):
        self.refuses(ValueError, "Shapes: an array of -1 objects cannot exist; give 0 or more", lambda: everything.Shapes(-1))
        self.refuses(ValueError, "there is no layout 'sao'; there are aos,", lambda: everything.Shapes(1, layout="sao"))
        self.refuses(ValueError, "there is no precision 'half'; there are float and", lambda: everything.Shapes(1, precision="half"))
        self.refuses(ValueError, "there is no space 'gpu'; there are host and cuda", lambda: everything.Shapes(1, space="gpu"))
        self.refuses(RuntimeError, "Shapes", lambda: everything.Shapes(2**60))
        self.refuses(TypeError, "incompatible", lambda: everything.Shapes(2.5))
        of = everything.Shapes(3)
        self.refuses(ValueError, "-5 objects", lambda: of.resize(-5))
        self.assertEqual(len(of), 3)

    def test_fields_that_there_are_not_with_the_nearest(self):
        of = everything.Options(2)
        self.refuses(AttributeError, "Options has no field 'densty'; did you mean 'density'\\?", lambda: of.densty)
        self.refuses(AttributeError, "has no field 'densty'; did you mean 'density'\\?", lambda: setattr(of, "densty", 1))
        self.refuses(AttributeError, "has no field 'zzz'; it has density, ", lambda: of.zzz)
        self.refuses(KeyError, "did you mean 'density'", lambda: of["densty"])
        self.refuses(KeyError, "did you mean 'density'", lambda: of.tiles("densty"))
        self.refuses(AttributeError, "layout cannot be set; set fields, and let copy\\(\\) make", lambda: setattr(of, "layout", "soa"))
        element = everything.Element(2)
        self.refuses(AttributeError, "Element.lame has no field 'nu'", lambda: element.lame.nu)
        self.refuses(IndexError, "Element.fibres has no entry 2", lambda: element.fibres[2])
        self.refuses(AttributeError, "lame cannot be set", lambda: setattr(element, "lame", 1))

    def test_values_of_another_shape_or_type(self):
        for layout in LAYOUTS:
            of = everything.Shapes(10, layout=layout)
            of.F = of.nodes = 3
            wrong = ((ValueError, "F has the shape \\(10, 3, 3\\); values of the shape \\(10, 3\\) do not fit; give that shape", "F", np.ones((10, 3)) * 2),
                     (ValueError, "values of the shape \\(9, 3, 3\\) do not fit", "F", np.ones((9, 3, 3))),
                     (TypeError, "F holds numbers of type float32, to which complex128 does not", "F", 1j),
                     (TypeError, "to which <U4 does not", "F", "text"),
                     (TypeError, "int32, to which float64 does not", "nodes", 2.5),
                     (ValueError, "nodes holds whole numbers .* the values go from 3 to 4294967296", "nodes", [3, 3, 3, 2**32]))
            for error, words, name, given in wrong:
                self.refuses(error, words, lambda name=name, given=given: setattr(of, name, given))
            self.assertTrue((of.F == 3).all() and (of.nodes == 3).all())


class Lifetimes(unittest.TestCase):
    def test_a_view_keeps_the_memory_of_an_array_that_is_gone(self):
        view = everything.Shapes(5000, layout="soa").F
        view[...] = 3
        gc.collect()
        others = [everything.Shapes(5000, layout="soa") for _ in range(5)]  # would reuse the memory
        for other in others:
            other.F = 9
        self.assertTrue((view == 3).all())

    def test_an_array_with_a_view_is_not_resized_until_the_view_is_gone(self):
        of = everything.Shapes(10, layout="soa")
        of.v = [1, 2, 3]
        column = of.v[:, 1]  # a view of a view
        with self.assertRaisesRegex(BufferError, "Shapes: 1 views of this array exist, so it cannot get 20 objects in place of 10"):
            of.resize(20)
        np.testing.assert_array_equal(column, [2] * 10)
        tiles = of.tiles("v")
        del column
        with self.assertRaises(BufferError):
            of.resize(20)
        of.resize(10)  # is none
        del tiles
        of.resize(20)
        np.testing.assert_array_equal(of.v[:, 1], [2] * 10 + [0] * 10)
        copied = everything.Shapes(100).F
        everything.Shapes(100).resize(3)
        self.assertEqual(copied.shape, (100, 3, 3))

    def test_a_resized_array_keeps_objects_and_gives_initial_ones(self):
        for layout in LAYOUTS:
            of = everything.Options(40, layout=layout)
            of.density = np.arange(40)
            of.tiles("density")[...].fill(-1)  # padding, too
            of.density = np.arange(40)
            of.resize(33)
            of.resize(100)
            np.testing.assert_array_equal(of.density, [*range(33), *[1060] * 67], layout)
            of.resize(0)
            self.assertEqual(of.density.shape, (0,))
            self.assertEqual(of.tiles("metric").shape[0], 0)
            of.density = 3


class Exchange(unittest.TestCase):
    class Tensor:  # what another library's tensor shows of itself
        def __init__(self, array, device):
            self.array, self.device = array, device

        def __dlpack__(self, stream=None):
            return self.array.__dlpack__()

        def __dlpack_device__(self):
            return self.device

    def test_views_are_dlpack_tensors_without_a_copy(self):
        of = everything.Shapes(10, layout="soa")
        self.assertEqual(of.F.__dlpack_device__(), (1, 0))
        tensor = np.from_dlpack(of.F)
        of.F[3, 1, 2] = 8
        self.assertEqual(tensor[3, 1, 2], 8)
        with self.assertRaises(BufferError):
            of.resize(20)
        del tensor
        gc.collect()
        of.resize(20)
        for copied in (everything.Shapes(100).F, everything.Stored(10).wide):
            with self.assertRaises(BufferError):  # could be written there
                copied.__dlpack__()

    def test_tensors_of_the_host_are_taken_and_others_refused(self):
        of = everything.Shapes(10)
        given = values((10, 3, 3))
        of.F = self.Tensor(given, (1, 0))
        np.testing.assert_array_equal(of.F, given)
        for device in ((2, 0), (10, 1)):
            with self.assertRaisesRegex(BufferError, f"F: the values lie on DLPack's device \\({device[0]}, {device[1]}\\).*copy them to the host"):
                of.F = self.Tensor(given, device)


class Cost(unittest.TestCase):
    def test_times_are_printed(self):
        of, tiled = everything.Shapes(1000, layout="soa"), everything.Shapes(1000)
        for what, call, runs in (("a view of a field", lambda: of.F, 20000), ("a copy of 1000 objects in tiles", lambda: tiled.F, 1000)):
            print(f"{what}: {min(timeit.repeat(call, number=runs, repeat=3)) / runs * 1e6:.2f} us")


if __name__ == "__main__":
    unittest.main()
