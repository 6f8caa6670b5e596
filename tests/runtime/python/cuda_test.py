"""Tests of what Python sees of arrays in CUDA memory, skipped where there is none. cuda_test.py FOLDER: the module `everything` lies there,
of the golden schema of that name."""
import ctypes
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))
import numpy as np  # noqa: E402

import everything  # noqa: E402
from drawn import values  # noqa: E402

LAYOUTS = ("aos", "aos_padded", "soa", "aosoa(8)", "aosoa(32)")


class Tensor(ctypes.Structure):  # of DLPack's specification
    _fields_ = [("data", ctypes.c_void_p), ("kind", ctypes.c_int32), ("number", ctypes.c_int32), ("dimensions", ctypes.c_int32),
                ("code", ctypes.c_uint8), ("bits", ctypes.c_uint8), ("lanes", ctypes.c_uint16),
                ("shape", ctypes.POINTER(ctypes.c_int64)), ("strides", ctypes.POINTER(ctypes.c_int64)), ("offset", ctypes.c_uint64)]


def taken(field):
    """The numbers of a tensor on the device, as another library would find them."""
    capsule = field.__dlpack__(stream=None)
    pointer = ctypes.pythonapi.PyCapsule_GetPointer
    pointer.restype, pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    tensor = Tensor.from_address(pointer(capsule, b"dltensor"))
    shape, strides = tensor.shape[:tensor.dimensions], tensor.strides[:tensor.dimensions]
    dtype = np.dtype({0: "i", 2: "f"}[tensor.code] + str(tensor.bits // 8))
    memory = np.empty(sum((n - 1) * s for n, s in zip(shape, strides)) + 1, dtype)
    copy = ctypes.CDLL("libcuda.so.1").cuMemcpyDtoH_v2
    copy.argtypes = [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_size_t]
    assert copy(memory.ctypes.data, tensor.data, memory.nbytes) == 0
    assert (tensor.kind, tensor.number) == field.__dlpack_device__() and tensor.lanes == 1 and tensor.offset == 0
    return np.lib.stride_tricks.as_strided(memory, shape, [s * dtype.itemsize for s in strides]).copy()


class Cuda(unittest.TestCase):
    def setUp(self):
        try:
            everything.Shapes(1, space="cuda")
        except RuntimeError as refused:
            self.assertRegex(str(refused), "tissue::model::Shapes\\[1\\].*(CUDA|cuda)")
            self.skipTest(str(refused))

    def test_objects_go_to_the_device_and_come_back(self):
        for layout in LAYOUTS:
            of = everything.Shapes(1003)
            for seed, name in enumerate(of.units):
                of[name] = (values(of[name].shape, seed) * 100).astype(of[name].dtype)
            there = of.copy(space="cuda", layout=layout)
            self.assertEqual((there.space, there.layout, len(there)), ("cuda", layout, 1003))
            there.F = given = values((1003, 3, 3), 99)
            there.resize(1500)
            there.resize(1001)
            back = there.copy(space="host", layout="aos")
            for name in of.units:
                np.testing.assert_array_equal(back[name], (given if name == "F" else of[name])[:1001], f"{name} in {layout}")

    def test_fields_are_tensors_of_dlpack(self):
        for precision in ("float", "double"):
            for layout in ("aos", "aos_padded", "soa"):
                of = everything.Shapes(300, layout=layout, precision=precision, space="cuda")
                for name in ("a", "F", "nodes", "K"):
                    host = (values(of[name].shape, 1) * 100).astype("i4" if name == "nodes" else "f4")
                    of[name] = host
                    self.assertEqual(of[name].__dlpack_device__(), (2, 0))
                    np.testing.assert_array_equal(taken(of[name]), host, f"{name} in {layout}")
        tiled = everything.Shapes(70, layout="aosoa(32)", space="cuda")
        tiled.F = host = values((70, 3, 3))
        tiles = taken(tiled.tiles("F"))
        self.assertEqual(tiles.shape, (3, 32, 3, 3))
        np.testing.assert_array_equal(tiles.reshape(-1, 3, 3)[:70], host)

    def test_a_tensor_keeps_the_memory_and_the_array_its_size(self):
        of = everything.Shapes(300, layout="soa", space="cuda")
        of.F = 3
        field = of.F
        capsule = field.__dlpack__()
        del field
        with self.assertRaisesRegex(BufferError, "1 views of this array exist"):
            of.resize(5)
        del capsule
        of.resize(5)
        field = of.F
        del of
        self.assertTrue((taken(field) == 3).all())

    def test_what_cannot_be_a_tensor_is_refused(self):
        with self.assertRaisesRegex(TypeError, "F lies in tiles of CUDA memory.*take tiles\\(\\) of it"):
            everything.Shapes(300, layout="aosoa(32)", space="cuda").F  # noqa: B018
        with self.assertRaisesRegex(TypeError, "angle is stored in a format that DLPack does not know; copy\\(space=\"host\"\\)"):
            everything.Stored(300, layout="soa", space="cuda").angle  # noqa: B018
        of = everything.Shapes(300, layout="soa", space="cuda")
        with self.assertRaisesRegex(BufferError, "device \\(2, 0\\); they are taken from host memory"):
            of.F = of.F


if __name__ == "__main__":
    unittest.main()
