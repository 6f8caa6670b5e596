"""Reads what truthcube wrote into a folder: run.json, cube.vtkhdf and beads.csv."""
import functools
import os
import pathlib
from dataclasses import dataclass

os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")  # a run may be going on, and folders may be read-only
import h5py  # noqa: E402
import numpy as np  # noqa: E402

from .beads import SAME_COMPRESSION, Beads, at_compression, read_beads  # noqa: E402
from .records import AGAIN, RunError, read_record, require  # noqa: E402


SHOWN = 14  # steps in one picture at most


@dataclass(frozen=True, eq=False)  # a step equals itself alone
class Step:
    compression: float  # plate travel over height
    time: float | None  # of a motion [s]
    displacement: np.ndarray  # of the nodes [m], n x 3
    von_mises: np.ndarray  # of the tets [Pa]
    record: dict  # of run.json

    def title(self):
        if self.time is None:
            return f"compressed by {100 * self.compression:g} %"
        return f"at {self.time:g} s, by {100 * self.compression:.3g} %"


@dataclass(frozen=True)
class Run:
    record: dict
    points: np.ndarray  # rest positions [m], n x 3
    tets: np.ndarray  # corners, t x 4
    steps: list
    beads: dict  # compression -> Beads, of a motion those of its last state; empty for meshes that are no Truth Cube

    @property
    def moves(self):
        """Whether steps are states of a motion, and no equilibria."""
        return _moves(self.record)

    def shown(self):
        """The steps that pictures have: SHOWN at most, evenly spread, the last one among them."""
        count = len(self.steps)
        if count <= SHOWN:
            return self.steps
        return [self.steps[round((k + 1) * count / SHOWN) - 1] for k in range(SHOWN)]

    def at_nodes(self, values):
        """Values of tets, averaged over those at each node by their volume at rest."""
        nodes, weights, total = self._weights
        return np.bincount(nodes, weights * np.repeat(values, 4), len(self.points)) / total

    @functools.cached_property
    def _weights(self):
        """For each corner of each tet its node and the tet's volume; and their sums at nodes, 1 where there are none."""
        corners = self.points[self.tets]
        nodes = self.tets.ravel()
        weights = np.repeat(np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])), 4)
        total = np.bincount(nodes, weights, len(self.points))
        return nodes, weights, np.where(total > 0, total, 1)

    def title(self):
        """The problem that was solved, in words."""
        settings = self.record["settings"]
        body = f"{settings['cells']}³ cells" if "cells" in settings else "a mesh"
        scene = settings.get("scene", "quasistatic")
        return (
            f"{'' if scene == 'quasistatic' else scene + ': '}{body}, {self.record['tets']:,} tets, "
            f"{settings['material']}, ν = {settings['poisson']:g}, volume by {settings['volume']}, {settings['top']} top"
        )


def _moves(record):
    return "duration" in record["settings"]


def lengths(vectors):
    return np.sqrt((vectors**2).sum(axis=-1))


def von_mises(stress):
    """The von Mises norms of symmetric tensors, rows of xx yy zz xy yz xz."""
    normal, shear = stress[:, :3], stress[:, 3:]
    deviator = normal - normal.mean(axis=1, keepdims=True)
    return np.sqrt(1.5 * (deviator**2).sum(axis=1) + 3 * (shear**2).sum(axis=1))


def read_run(folder):
    """@throws RunError"""
    folder = pathlib.Path(folder)
    record = read_record(folder / "run.json")
    points, tets, steps = _read_fields(folder / "cube.vtkhdf", record)
    table = folder / "beads.csv"
    beads = read_beads(table) if table.exists() else {}
    return Run(record, points, tets, steps, _last_beads(beads, record["steps"]) if _moves(record) else beads)


def _last_beads(beads, steps):
    """The beads of the last of the states of a motion that have one compression."""
    if not beads or not steps:
        return {}
    compression = steps[-1]["compression"]
    of_all = at_compression(beads, compression)
    states = sum(abs(step["compression"] - compression) < SAME_COMPRESSION for step in steps)
    count = len(of_all.rest) // states if of_all else 0
    return {compression: Beads(of_all.rest[-count:], of_all.displacement[-count:])} if count else {}


# ---- cube.vtkhdf -----------------------------------------------------------------------------------------------------
def _read_fields(path, record):
    if not path.exists():
        raise RunError(f"{path}: No such file; {AGAIN}")
    try:
        with h5py.File(path, "r") as file:
            return _fields_of(file, path, record)
    except OSError as error:
        raise RunError(f"{path}: cannot be read as HDF5: {error}; {AGAIN}") from None


def _fields_of(file, path, record):
    def get(name, *shape):
        if name not in file:
            raise RunError(f"{path} has no {name}; {AGAIN}")
        found = file[name].shape
        if len(found) != len(shape) or any(want not in (None, have) for want, have in zip(shape, found)):
            raise RunError(f"{path}: {name} has the shape {found}, not {shape}; {AGAIN}")
        return file[name]

    points = get("VTKHDF/Points", None, 3)[...]
    nodes, tets = len(points), len(get("VTKHDF/Types", None))
    corners = get("VTKHDF/Connectivity", 4 * tets)[...].reshape(tets, 4)
    if corners.size == 0 or corners.min() < 0 or corners.max() >= nodes:
        raise RunError(f"{path}: VTKHDF/Connectivity is empty or names nodes that are not there; {AGAIN}")
    if (nodes, tets) != (record["nodes"], record["tets"]):
        here = f"{nodes} nodes and {tets} tets"
        there = f"{record['nodes']} and {record['tets']}"
        raise RunError(f"{path} has {here}, and run.json beside it {there}: the files are not of one run; {AGAIN}")
    times, offsets = get("VTKHDF/Steps/Values", None)[...], "VTKHDF/Steps/{}DataOffsets/{}"
    if len(times) < len(record["steps"]):
        raise RunError(f"{path} has {len(times)} steps, and run.json {len(record['steps'])}; {AGAIN}")
    steps = []
    time, words = ("time", "a time") if _moves(record) else ("compression", "a compression")
    for k, of_record in enumerate(record["steps"]):
        require(of_record, {time: float}, f"run.json beside {path}: steps[{k}]")
        if of_record[time] is None or abs(times[k] - of_record[time]) > SAME_COMPRESSION:
            raise RunError(
                f"{path}: step {k} is of {words} of {times[k]:g}, and in run.json of {of_record[time]}: the files are "
                f"not of one run; {AGAIN}"
            )
        first = [int(get(offsets.format(*names), None)[k]) for names in (("Point", "displacement"), ("Cell", "stress"))]
        displacement = get("VTKHDF/PointData/displacement", None, 3)[first[0] : first[0] + nodes].astype(float)
        stress = get("VTKHDF/CellData/stress", None, 6)[first[1] : first[1] + tets].astype(float)
        if len(displacement) != nodes or len(stress) != tets:
            raise RunError(f"{path}: step {k} is cut off; {AGAIN}")
        of_motion = float(times[k]) if _moves(record) else None
        steps.append(Step(of_record["compression"], of_motion, displacement, von_mises(stress), of_record))
    return points, corners, steps
