"""Reads and checks the JSON files that physbench writes, and finds rows in them."""
import fnmatch
import functools
import json
import math
import os
import pathlib
import re
from dataclasses import dataclass, replace

import kernel_hashes

BUILDS = pathlib.Path(__file__).resolve().parents[2] / "build"  # of this checkout
VERSION = "1"  # of results: names and meanings of rows and counters. Files that state none are of this one, too
EPS = {"float": 2.0**-23, "double": 2.0**-52}  # what err_eps_* are in


class ResultsError(Exception):
    """A file that is missing, or not what physbench writes."""


@dataclass(frozen=True)
class Row:
    """One measured row, `kernel/layout/storage/space/objects[/set]`, and the machine that it was measured on."""

    kernel: str
    layout: str
    storage: str
    space: str
    objects: int
    set: str
    machine: str
    counters: dict
    older: tuple = ()  # (why its file may be older than the code, the file and its date); empty: it is not
    peers: int = 0  # rows of the same kernel, set and object count on the machine

    @property
    def name(self):
        return "/".join(filter(None, (self.kernel, self.layout, self.storage, self.space, str(self.objects), self.set)))

    def counter(self, name):
        """The counter of that name; None where there is none or it is not finite."""
        value = self.counters.get(name)
        number = isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
        return float(value) if number else None

    @property
    def ms(self):
        """Median time over all objects [ms]."""
        return self.counter("median_ms")

    @property
    def copy_fraction(self):
        """Time of a copy of the same bytes over the row's time, or None; 1 is as fast as the copy."""
        return self.counter("copy_fraction") or None

    @property
    def ns_per_object(self):
        return self.ms * 1e6 / self.objects

    def error(self, which):
        """Relative error at a percentile, `p50`, `p99`, `p9999` or `max`; None where it was not measured."""
        relative, in_eps = self.counter("err_" + which), self.counter("err_eps_" + which)
        if relative is None and in_eps is not None and self.storage in EPS:
            relative = in_eps * EPS[self.storage]
        return relative


@dataclass(frozen=True)
class ResultFile:
    """One run of physbench: its context (machine, versions, command), its rows, and the rows that failed."""

    name: str
    context: dict
    rows: list
    failures: list  # (name, message)
    kernels: str  # what it measured: "as here", "other: scene/host/svd", "not compared: ...", "not stated"


@dataclass(frozen=True)
class Results:
    files: list
    rows: list
    replaced: int  # rows that a later file has again


def load(paths, builds=BUILDS):
    """Reads files. Of rows that several files have from one machine, the last file's count.

    @param builds the folder of builds whose compiled kernels count as the present ones
    @throws ResultsError that names the file and what is wrong with it"""
    here = kernel_hashes.of_builds(builds)
    files = [_read(path, here) for path in paths]
    unique = {(row.machine, row.name): row for file in files for row in file.rows}
    peers = {key: len(same) for key, same in grouped(unique.values(), "machine", "kernel", "set", "objects")}
    rows = [replace(row, peers=peers[row.machine, row.kernel, row.set, row.objects]) for row in unique.values()]
    return Results(files, rows, sum(len(file.rows) for file in files) - len(rows))


def _read(path, here):
    try:
        with open(path, encoding="utf-8") as stream:
            content = json.load(stream)
    except OSError as error:
        raise ResultsError(f"{path}: {error.strerror or error}") from None
    except (ValueError, RecursionError) as error:
        raise ResultsError(f"{path}: not JSON: {error}") from None
    context = content.get("context") if isinstance(content, dict) else None
    if not isinstance(context, dict) or "physgen" not in context or not isinstance(content.get("benchmarks"), list):
        raise ResultsError(f"{path}: JSON, but not of physbench --json (no context with 'physgen', or no benchmarks)")
    _check_version(path, context)
    name = os.path.basename(path)
    dated = f"{name} ({str(context.get('date', 'no date'))[:10]})"
    rows, failures, compared = {}, [], set()
    for entry in content["benchmarks"]:
        if not isinstance(entry, dict) or not isinstance(entry.get("name"), str):
            raise ResultsError(f"{path}: a benchmark has no name")
        if entry.get("run_type") == "aggregate":
            continue  # means and deviations of repetitions: the repetitions themselves are there, too
        short, why = _kernels(path, entry, here)
        compared.update(short)
        row = _row(path, entry, context, (why, dated) if why else ())
        if entry.get("error_occurred"):
            failures.append((row.name, str(entry.get("error_message", "no message"))))
        elif row.ms is None or row.ms <= 0:
            raise ResultsError(f"{path}: {row.name}: the counter median_ms is not a positive number")
        else:
            rows.setdefault(row.name, []).append(row)
    if not rows and not failures:
        raise ResultsError(f"{path}: no rows")
    middle = [sorted(same, key=lambda row: row.ms)[(len(same) - 1) // 2] for same in rows.values()]
    return ResultFile(name, context, middle, failures, "; ".join(sorted(compared)) or "as here")


def _check_version(path, context):
    version = str(context.get("results_version", VERSION))
    if version != VERSION:
        raise ResultsError(
            f"{path}: context.results_version is '{version}', but this checkout reads results of version {VERSION}; "
            "measure again with this checkout's physbench (--json=FILE), or take the report of the checkout that wrote it"
        )


def _kernels(path, entry, here):
    """What tells a row's compiled kernels from those of builds, in short words; and why it may be older than the code."""
    if "kernels" not in entry:
        return {"not stated"}, "files of before results had hashes of their compiled kernels"
    stated = [tuple(part.split(" ")) for part in str(entry["kernels"]).split(", ")]
    if not all(len(part) == 2 and re.fullmatch("[0-9a-f]{16}", part[1]) for part in stated):
        raise ResultsError(
            f"{path}: {entry['name']}: kernels is '{entry['kernels']}', not names and hashes as physbench writes them; "
            "measure again instead of editing the file"
        )
    unknown = sorted(key for key, _ in stated if key not in here)
    other = sorted(key for key, hashed in stated if hashed not in here.get(key, {hashed}))
    if other:
        listed = ", ".join(other)
        return {f"other: {key}" for key in other}, f"files that measured other compiled kernels than the builds here (those of {listed})"
    if unknown:
        return {f"not compared: {key}" for key in unknown}, "files that were not compared, since no build here has their kernels"
    return set(), ""


def _row(path, entry, context, older):
    name = re.sub(r"/(manual_time|real_time|repeats:\d+)", "", entry["name"])
    parts = name.split("/")
    if len(parts) < 5 or not parts[4].isdigit() or int(parts[4]) == 0:
        raise ResultsError(f"{path}: '{name}' is not kernel/layout/storage/space/objects[/set]")
    kernel, layout, storage, space, objects = parts[:5]
    machine = _machine(space, context)
    return Row(kernel, layout, storage, space, int(objects), "/".join(parts[5:]), machine, entry, older)


def _machine(space, context):
    """The device that ran a row: the GPU, or the CPU and how many of its threads."""
    if space == "cuda":
        return str(context.get("gpu", "GPU")).split(",")[0]
    cpu = re.sub(r"\((R|TM|tm)\)", "", str(context.get("cpu", "CPU")))
    threads = re.match(r"\d+", str(context.get("threads", "")))
    return " ".join(cpu.split()) + (f", {threads[0]} thread{'s' * (threads[0] != '1')}" if threads else "")


class NamedRows:
    """The rows of a file, found by their names, in which `*` stands for anything within a part."""

    def __init__(self, path):
        self.path, self.rows = path, load([str(path)]).files[0].rows
        self._found = {}  # of patterns that were asked for

    def all(self, *patterns):
        """Rows whose names fit one of the patterns. @throws ResultsError where none fits"""
        if patterns not in self._found:
            self._found[patterns] = [row for row in self.rows if any(_fits(row.name, pattern) for pattern in patterns)]
        found = list(self._found[patterns])
        if not found:
            raise ResultsError(f"{self.path} has no row {' or '.join(patterns)}; measure it, or ask for another name")
        return found

    def one(self, pattern):
        """The only row of that name. @throws ResultsError where there is none, or more than one"""
        found = self.all(pattern)
        if len(found) > 1:
            raise ResultsError(f"{self.path} has {len(found)} rows {pattern}; ask for one")
        return found[0]


def _fits(name, pattern):
    name, pattern = name.split("/"), pattern.split("/")
    return len(name) == len(pattern) and all(map(fnmatch.fnmatchcase, name, pattern))


# ---- Finding rows ----------------------------------------------------------------------------------------------------
def where(rows, **wanted):
    """Rows whose attributes equal, or are among, the wanted: where(rows, kernel="svd", storage={"float", "double"})."""

    def fits(row):
        return all(
            (
                getattr(row, key) in value
                if isinstance(value, (set, frozenset, list, tuple, dict))
                else getattr(row, key) == value
            )
            for key, value in wanted.items()
        )

    return [row for row in rows if fits(row)]


def grouped(rows, *attributes):
    """(key, rows) for each value of the attributes, a tuple where there are several, in order of appearance."""
    found = {}
    for row in rows:
        key = tuple(getattr(row, name) for name in attributes)
        found.setdefault(key if len(key) > 1 else key[0], []).append(row)
    return list(found.items())


def by_machine(rows):
    """(machine, rows), GPUs first."""
    return sorted(grouped(rows, "machine"), key=lambda item: item[1][0].space != "cuda")


def usual_size(rows):
    """The rows of one kernel that have the object count that was measured most widely; of equal ones, of the largest."""
    sizes = grouped(rows, "objects")
    return max(sizes, key=lambda item: (item[1][0].peers, item[0]))[1] if sizes else []


def aos(rows, storage="float"):
    """The row over arrays of structs, the origin of speed-ups; of the CPU's two ways the faster. None if there is none."""
    return min(where(rows, layout={"aos", "aos_scalar"}, storage=storage, set=""), key=lambda row: row.ms, default=None)
