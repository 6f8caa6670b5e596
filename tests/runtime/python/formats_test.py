"""Tests of the storage formats that Python sees. formats_test.py FOLDER: the module `everything` lies there, of the golden schema of
that name, which has every format."""
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))
import numpy as np  # noqa: E402

import everything  # noqa: E402
from drawn import SEED, values  # noqa: E402


def rotations(shape):
    q = np.random.default_rng(SEED).normal(size=(*shape, 4))
    w, x, y, z = np.moveaxis(q / np.linalg.norm(q, axis=-1, keepdims=True), -1, 0)
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1)).astype(np.float32)


class Formats(unittest.TestCase):
    def setUp(self):
        self.of = everything.Stored(300)  # in tiles of 8
        self.whole = everything.Stored(300, layout="aos")

    def test_native_numbers_and_half_are_seen_without_a_copy(self):
        for name, dtype in (("single", "f4"), ("twice", "f8"), ("narrowed", "f4"), ("plain_half", "f2"), ("stretch", "f2"),
                            ("halves", "f2"), ("entries", "f2"), ("R", "f4"), ("count", "i4")):
            view = self.whole[name]
            self.assertEqual(view.dtype, np.dtype(dtype), name)
            view[...] = 1
            self.assertTrue((self.whole[name] == 1).all(), name)
            self.assertFalse(self.of[name].flags.writeable, name)

    def test_other_formats_are_decoded_copies_that_keep_what_the_format_can(self):
        bits = np.ascontiguousarray(values(300) * 1000).view(np.uint32)
        bfloat = ((bits + 0x7FFF + ((bits >> 16) & 1)) & 0xFFFF0000).view(np.float32)  # the nearest, ties to even
        for of in (self.of, self.whole):
            of.wide = bits.view(np.float32)
            np.testing.assert_array_equal(of.wide, bfloat)
            of.plain_half = halves = values(300)
            np.testing.assert_array_equal(of.plain_half, halves.astype(np.float16).astype(of.plain_half.dtype))
            for name, low, high in (("angle", -3.25, 3.25), ("spin", -8, 8)):
                given = values(of[name].shape, 1) * high
                of[name] = given
                self.assertFalse(of[name].flags.writeable, name)
                np.testing.assert_allclose(of[name], given, rtol=0, atol=(high - low) / 65534, err_msg=name)
                self.assertTrue((of[name] != given).any(), name)
            for name, error in (("R32", 1e-6), ("R64", 1e-6), ("Rhalf", 2e-3), ("Rbfloat", 2e-2), ("R16", 1e-4), ("turns", 2e-3)):
                given = rotations(of[name].shape[:-2])
                of[name] = given
                np.testing.assert_allclose(of[name], given, rtol=0, atol=error, err_msg=name)

    def test_integers_of_64_bits_and_bool_are_seen_without_a_copy_and_keep_every_bit(self):
        of, tiles = everything.Marks(40, layout="soa"), everything.Marks(40, layout="aosoa(4)")
        for name, dtype in (("lowest", "i8"), ("key", "u8"), ("alive", "?"), ("counts", "i8"), ("flags", "?")):
            self.assertEqual((of[name].dtype, tiles[name].dtype), (np.dtype(dtype), np.dtype(dtype)), name)
            self.assertTrue(of[name].flags.writeable, name)
        keys = np.arange(40, dtype="u8") + 2**63 + 1
        of.key[...] = keys
        tiles.key = keys
        tiles.alive = of.alive = keys % 3 == 0
        of.flags[:, 2] = True
        np.testing.assert_array_equal(tiles.key, keys)
        np.testing.assert_array_equal(tiles.alive, keys % 3 == 0)
        self.assertEqual(of.flags.sum(), 40)
        of.key = 5
        self.assertEqual(of.key[39], 5)
        np.testing.assert_array_equal(np.from_dlpack(of.lowest), np.full(40, -(2**63)))
        with self.assertRaisesRegex(ValueError, "key holds whole numbers from 0 to 18446744073709551615, and the values go from -1"):
            of.key = -1
        with self.assertRaisesRegex(TypeError, "alive holds numbers of type bool, to which int64 does not convert"):
            of.alive = 1

    def test_a_copy_cannot_be_written_and_says_so(self):
        for array in (self.of.single, self.of.wide, self.whole.wide, self.whole.R16, everything.Shapes(100).F):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[...] = 1
            with self.assertRaises(ValueError):
                array.setflags(write=True)
        with self.assertRaisesRegex(ValueError, "read-only"):
            self.of.single += 1
        with self.assertRaisesRegex(TypeError, "wide is stored in a format that NumPy does not know; read the field itself"):
            self.of.tiles("wide")

    def test_values_that_a_format_cannot_hold_are_refused_and_named(self):
        of = self.whole
        for name, wrong, message in (("angle", 4, "4 rad in angle of object 0"), ("wide", np.nan, "in wide of object 0"),
                                     ("plain_half", 1e6, "1e\\+06 in plain_half of object 0"),
                                     ("R16", np.ones((3, 3)), "not rotations")):
            before = of[name].copy()
            with self.assertRaisesRegex(ValueError, message):
                of[name] = wrong
            np.testing.assert_array_equal(of[name], before, name)


if __name__ == "__main__":
    unittest.main()
