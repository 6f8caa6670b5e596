"""Tables of beads: beads.csv, the checked-in reference and users' tables; and how far two are apart. Needs nothing but
Python."""
import csv
import math
import pathlib
from dataclasses import dataclass

from .records import RunError

ROOT = pathlib.Path(__file__).resolve().parents[3]
ORACLE = "tests/fem/solver/oracle"  # beads of another code, nu = 0.49
SAME_COMPRESSION = 1e-6
SAME_PLACE = 1e-7  # [m]


@dataclass(frozen=True)
class Beads:
    rest: list  # (x, y, z) [m]
    displacement: list  # (ux, uy, uz) [m]

    def less(self, other):
        """Displacements less those of the other, bead by bead [m]. @throws RunError where they are other beads"""
        if len(self.rest) != len(other.rest):
            raise RunError(f"{len(self.rest)} beads cannot be compared with {len(other.rest)}")
        for number, (here, there) in enumerate(zip(self.rest, other.rest)):
            if math.dist(here, there) > SAME_PLACE:
                raise RunError(f"bead {number} is at {here} m, and in the table to compare with at {there} m")
        return [
            tuple(a - b for a, b in zip(mine, others)) for mine, others in zip(self.displacement, other.displacement)
        ]


def rms_mm(vectors):
    """Root of the mean square of the vectors' lengths, from metres [mm]."""
    return 1e3 * math.sqrt(sum(math.hypot(*vector) ** 2 for vector in vectors) / len(vectors))


def largest_mm(vectors):
    return 1e3 * max(math.hypot(*vector) for vector in vectors)


_COLUMNS = ("x", "y", "z", "ux", "uy", "uz")


def read_beads(path):
    """A table with the columns x, y, z, ux, uy, uz in metres and, if there is one, compression: beads.csv, the oracle's
    and users' tables. @return {compression or None: Beads}. @throws RunError naming the line"""
    groups = {}
    try:
        with open(path, encoding="utf-8-sig", newline="") as stream:
            lines = csv.reader(stream)
            header = [name.strip() for name in next(lines, [])]
            if sorted(set(header) - {"compression"}) != sorted(_COLUMNS) or len(set(header)) != len(header):
                raise RunError(f"{path}:1: the columns are not x,y,z,ux,uy,uz and, if there is one, compression")
            for cells in lines:
                if not any(cell.strip() for cell in cells):
                    continue
                values = _numbers(cells, header, f"{path}:{lines.line_num}")
                groups.setdefault(values.get("compression"), []).append([values[name] for name in _COLUMNS])
    except OSError as error:
        raise RunError(f"{path}: {error.strerror or error}") from None
    except UnicodeDecodeError as error:
        raise RunError(f"{path}: not a table of text: {error}") from None
    if not groups:
        raise RunError(f"{path}: has no rows of beads")
    return {
        key: Beads([tuple(row[:3]) for row in rows], [tuple(row[3:]) for row in rows]) for key, rows in groups.items()
    }


def _numbers(cells, header, place):
    if len(cells) != len(header):
        raise RunError(f"{place}: {len(cells)} cells in a table of {len(header)} columns")
    values = {}
    for name, cell in zip(header, cells):
        try:
            values[name] = float(cell)
        except ValueError:
            values[name] = math.nan
        if not math.isfinite(values[name]):
            raise RunError(f"{place}: '{cell.strip()}' in the column {name} is not a finite number")
    return values


def at_compression(tables, compression):
    """The beads of a compression among those of read_beads(); those of a table without compressions; or None."""
    near = [beads for key, beads in tables.items() if key is None or abs(key - compression) < SAME_COMPRESSION]
    return near[0] if near else None


def oracle_name(settings, compression):
    """The file of the checked-in reference for a run's settings, from the root of the checkout; None where there is
    none."""
    if "cells" not in settings or settings["material"] != "neo-hookean" or settings["poisson"] != 0.49:
        return None
    name = f"{ORACLE}/0.49_{settings['top']}_{compression:g}.csv"
    return name if (ROOT / name).exists() else None
