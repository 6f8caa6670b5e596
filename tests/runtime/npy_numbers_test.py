"""NumPy reads and writes what save_npy() and load_npy() do: npy_numbers_test.py PROGRAM, which is npy_numbers."""
import pathlib
import subprocess
import sys
import tempfile

import numpy

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    subprocess.run([sys.argv[1], folder], check=True)
    for k, (field, kind) in enumerate({"x1111": "f2", "x2211": "f8", "x3311": "f4", "x2222": "f4", "x3322": "f4", "x3333": "f4"}.items()):
        stored = numpy.load(folder / f"numbers/{field}.npy")
        wanted = ((numpy.arange(1001) * 7 + k) % 128 - 64) / 64
        assert stored.dtype == numpy.dtype(kind) and stored.shape == (1001,), (field, stored.dtype)
        assert abs(stored - wanted).max() <= (2 / 32767 if field == "x3322" else 0), field

    marks = {path.stem: numpy.load(path) for path in (folder / "marks").iterdir()}
    assert (marks["key"] == 2**63 + numpy.arange(70, dtype="u8")).all() and marks["key"].dtype == "u8"
    assert (marks["alive"] == (numpy.arange(70) % 3 == 0)).all() and marks["alive"].dtype == bool
    assert (marks["counts"][:, 1] == -numpy.arange(70)).all() and marks["counts"].shape == (70, 4)
    assert marks["flags"].shape == (70, 5) and marks["weight"].dtype == "f2"
    turn = numpy.load(folder / "turns/U.npy")  # by columns
    assert (turn[2].reshape(3, 3).T == numpy.diag([1, -1, -1])).all() and (turn[0].reshape(3, 3) == numpy.eye(3)).all()

    # What NumPy writes is loaded: other numbers of objects, wider integers, other precisions.
    for field, values in marks.items():
        numpy.save(folder / f"marks/{field}.npy", values[::-1][:33])
    numpy.save(folder / "marks/lowest.npy", numpy.arange(33, dtype="i4"))
    numpy.save(folder / "marks/weight.npy", numpy.arange(33, dtype="f8"))
    numpy.save(folder / "marks/other.npy", numpy.arange(3))
    numpy.save(folder / "numbers/x1111.npy", numpy.arange(33, dtype="f8")[:, None] / 4)
    done = subprocess.run([sys.argv[1], folder, folder / "again"], check=True, capture_output=True, text=True)
    assert "33 objects" in done.stdout and "left out, since the array does not store it: 'other'" in done.stdout, done.stdout
    again = {path.stem: numpy.load(path) for path in (folder / "again/marks").iterdir()}
    assert (again["lowest"] == numpy.arange(33)).all() and again["lowest"].dtype == "i8"
    assert (again["weight"] == numpy.arange(33)).all()
    for field in again.keys() - {"lowest", "weight"}:
        assert (again[field] == marks[field][::-1][:33]).all(), field
    assert (numpy.load(folder / "again/numbers/x1111.npy") == numpy.arange(33) / 4).all()

    def refusal(field, values):
        numpy.save(folder / f"marks/{field}.npy", values)
        failed = subprocess.run([sys.argv[1], folder, folder / "again"], capture_output=True, text=True, check=False)
        assert failed.returncode != 0
        numpy.save(folder / f"marks/{field}.npy", marks[field][::-1][:33])
        return failed.stderr

    assert "holds numbers of type '>i8'; convert them by .astype()" in refusal("key", numpy.zeros(33, ">i8"))
    assert "has integers of 64 bits in the file and unsigned integers of 64 bits in the array" in refusal("key", numpy.zeros(33, "i8"))
    assert "has real numbers in the file and bool in the array" in refusal("alive", numpy.zeros(33))
    assert "stands in Fortran's order" in refusal("counts", numpy.zeros((4, 33), "i8").T)
    assert "has 3 dimensions" in refusal("counts", numpy.zeros((33, 2, 2), "i8"))
    assert "has 5 elements in the file and 4 elements in the array" in refusal("counts", numpy.zeros((33, 5), "i8"))
    assert "has 32 objects" in refusal("flags", numpy.zeros((32, 5), bool))
    assert "holds a byte 7 where bool is 0 or 1" in refusal("alive", numpy.full(33, 7, "u1").view(bool))
