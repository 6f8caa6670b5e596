"""h5py reads saved arrays: saved_numbers_test.py PROGRAM, which is saved_numbers."""
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy


def number(dataset):
    """What the stored numbers stand for, by the conventions of netCDF."""
    stored = dataset[...].astype("f8")
    return dataset.attrs.get("add_offset", 0) + dataset.attrs.get("scale_factor", 1) * stored


def checksum(stored):
    """The sums that runtime/saving.md states, of the elements in their stored type."""
    data = stored.tobytes()
    words = numpy.frombuffer(data + b"\0" * (-len(data) % 4), "<u4").astype("u8")
    return [words.sum(), (words * numpy.arange(len(words), 0, -1, dtype="u8")).sum()]


with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "numbers.h5"
    subprocess.run([sys.argv[1], path], check=True)
    with h5py.File(path) as file:
        group = file["numbers"]
        assert file.attrs["physgen_file"] == 1
        assert (group.attrs["object"], group.attrs["count"]) == (b"elasticity::StressDerivative", 1001)
        types = {"x1111": "f2", "x2211": "f8", "x3311": "f4", "x2222": "f4", "x3322": "i2", "x3333": "f2"}
        formats = dict(zip(types, (b"half", b"float64", b"bfloat16", b"float32", b"snorm16", b"half")))
        for k, (name, kind) in enumerate(types.items()):
            field = group[name]
            assert field.dtype == numpy.dtype(kind), (name, field.dtype)
            assert (field.attrs["format"], field.attrs["unit"]) == (formats[name], b"Pa"), name
            wanted = ((numpy.arange(1001) * 7 + k) % 128 - 64) / 64
            error = abs(number(field) - wanted).max()
            assert error <= (2 / 32767 if name == "x3322" else 0), (name, error)
            if name != "x3311":  # which h5py widens
                assert (field.attrs["checksum"] == checksum(field[...])).all(), name
        assert group["x3322"].attrs["_FillValue"] == -32768
        assert group["x3333"].attrs["scale"] == 8
        (tet,) = file["tets"].values()
        assert tet.dtype == "i4" and (tet[...] == [[0, 1, 2, 3], [10, 11, 12, 13], [20, 21, 22, 23]]).all()
        marks = file["marks"]
        assert marks["key"].dtype == "u8" and (marks["key"][...] == 2**63 + numpy.arange(70, dtype="u8")).all()
        assert marks["alive"].dtype == bool and (marks["alive"][...] == (numpy.arange(70) % 3 == 0)).all()
        assert marks["counts"].dtype == "i8" and (marks["counts"][:, 1] == -numpy.arange(70)).all()
        assert marks["flags"].shape == (70, 5) and not marks["flags"][...].any()
        assert marks["alive"].attrs["doc"] == b"whether it takes part" and "doc" not in marks["key"].attrs
