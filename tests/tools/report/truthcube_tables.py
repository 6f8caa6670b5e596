"""The references of the tests of truthcube's pictures: tables of beads read in another way, and a mesh of known areas."""
import csv
import math

import numpy as np


def table(path, compression=None):
    """Rows of a table of beads as numbers, of one compression where there are several."""
    with open(path, encoding="utf-8") as stream:
        found = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(stream)]
    return [row for row in found if "compression" not in row or row["compression"] == compression]


def rms_mm(here, there):
    """The root of the mean squared distance of two lists of rows."""
    squares = [sum((a[axis] - b[axis]) ** 2 for axis in ("ux", "uy", "uz")) for a, b in zip(here, there)]
    return 1e3 * math.sqrt(sum(squares) / len(squares))


def kuhn_cube(cells):
    """The unit cube in cells^3 cells of six tets."""
    count = cells + 1
    k, j, i = np.meshgrid(*[np.arange(count)] * 3, indexing="ij")
    points = np.column_stack([i.ravel(), j.ravel(), k.ravel()]) / cells
    offset = [1, count, count * count]
    origin = (i + count * j + count * count * k)[:cells, :cells, :cells].ravel()
    tets = []
    for a, b, even in ((0, 1, True), (1, 2, True), (2, 0, True), (0, 2, False), (2, 1, False), (1, 0, False)):
        path = [0, offset[a], offset[a] + offset[b], sum(offset)]
        tets.append(origin[:, None] + (path if even else [path[k] for k in (0, 2, 1, 3)]))
    return points, np.concatenate(tets)


def area(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
