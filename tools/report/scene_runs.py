#!/usr/bin/env python3
"""Runs the scenes of truthcube and collects what each of them keeps and takes: scene_runs.py build/release/bin/truthcube -o FILE.json

Of each scene: the scalars that it stores of a tet, from generated/scenes; the bytes of its arrays for a cube in float
(--bytes-cells), and of those of the scene everything by the same choices, where it offers them; and the time of a step
of both on one thread of the CPU, by turns: that of a load for equilibria, a time step for motions. A time is what the
processor spent, so that other programs do not change it much: that of several steps less that of one step, each the
shortest of --repeats. With --cells 0 nothing is timed, and any build does, since bytes are the same in all. Needs nothing but Python."""
import argparse
import pathlib
import re
import resource
import subprocess
import sys

sys.dont_write_bytecode = True
import kernel_hashes  # noqa: E402
import result_lines  # noqa: E402
import truthcube_runs  # noqa: E402
from truthcube import records, scenes  # noqa: E402

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
FLOAT = ["--precision", "float"]
STABLE = ["--material", "stable-neo-hookean"]
BY_TETS = ["--product", "matrix-free", "--preconditioner", "block-jacobi"]
# Each has its name, its other flags, and those of everything for the same, or none.
SCENES = (
    ("quasistatic", [], [*STABLE, *FLOAT]),
    ("matrix-free", [], [*STABLE, *FLOAT, *BY_TETS]),
    ("fixed-corotated", [], ["--material", "fixed-corotated", "--volume", "tets", *FLOAT]),
    ("implicit-dynamics", [], None),
    ("explicit-dynamics", FLOAT, None),
    ("linear-elastic", FLOAT, None),
    ("linear-elastic", [*FLOAT, *BY_TETS], None),
)
MOTIONS = {"implicit-dynamics": "1e-2", "explicit-dynamics": "1e-5"}  # with their time steps [s]
STEPS = 3  # of which the first does what a program does once


def run(program, arguments):
    """@return what was printed, and the seconds of the processor. @throws RunError where it failed"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, *arguments, "--threads", "1"], capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise records.RunError(f"{' '.join(arguments)}: exit status {done.returncode}: {done.stderr.strip()}")
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def steps(scene, count):
    """Flags for a run of so many equal steps."""
    if scene not in MOTIONS:
        return ["--compress", "0.05", "--repeat", str(count - 1)]
    step = float(MOTIONS[scene])
    return ["--compress", "0.01", "--duration", f"{count * step:g}", "--frames", str(count), "--time-step", MOTIONS[scene]]


def bytes_of(program, arguments):
    """@return the tets and bytes that a dry run says"""
    text, _ = run(program, [*arguments, "--dry-run"])
    level, solver = re.search(r"^ +0 +\d+ +(\d+) ", text, re.MULTILINE), re.search(r"^solver: (\d+) bytes", text, re.MULTILINE)
    if level is None or solver is None:
        raise records.RunError(f"{program} --dry-run: no line of level 0 or of the solver: is it truthcube of this checkout?")
    return int(level[1]), int(solver[1])


def measure(options, name, flags):
    """Tets and bytes of the large cube, and the seconds that one step and several steps of the small one take."""
    tets, total = bytes_of(options.program, [*flags, "--cells", str(options.bytes_cells)])
    own = {"flags": " ".join(flags), "tets": tets, "bytes": total}
    if options.cells == 0:
        return own, None
    cube = [*flags, "--cells", str(options.cells), "--quiet"]
    return own, [run(options.program, [*cube, *steps(name, count)])[1] for count in (1, STEPS)]


def shortest(turns):
    """A run of those that were measured by turns, with the seconds of a step: the shortest of several steps less the
    shortest of one. (The shortest difference would be that of the slowest single step.)"""
    own, times = turns[0]
    if times is None:
        return {**own, "seconds": None}
    one, several = (min(seconds) for seconds in zip(*(times for _, times in turns)))
    return {**own, "seconds": (several - one) / (STEPS - 1)}


def best(options, name, flags_of_each):
    """The runs of all choices of flags, which take turns."""
    runs = [[measure(options, name, flags) for flags in flags_of_each] for _ in range(options.repeats)]
    return [shortest(turns) for turns in zip(*runs)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("-o", "--output", required=True, metavar="FILE.json")
    parser.add_argument("--bytes-cells", type=int, default=64, help="of the cube whose bytes are said; 64")
    parser.add_argument("--cells", type=int, default=16, help="of the cube whose steps are timed, 0: none are; 16")
    parser.add_argument("--repeats", type=int, default=3, help="measurements, of which the shortest count; 3")
    options = parser.parse_args()
    where = truthcube_runs.machine(argparse.Namespace(device="cpu", threads=1))
    rows = []
    for name, flags, others in SCENES:
        both = [["--scene", name, *flags]] + ([["--scene", "everything", *others]] if others else [])
        own, *everything = best(options, name, both)
        rows.append({"scene": name, "scalars": scenes.scalars(CHECKOUT, name, own["flags"]), "own": own})
        if everything:
            rows[-1]["everything"] = everything[0]
        file = {
            "kernels": kernel_hashes.of([options.program]),
            "machine": where,
            "cells": options.cells,
            "scenes": rows,
        }
        result_lines.write(options.output, file)
        print(*scenes.lines(file, options.output)[1][-1], sep="; ", flush=True)


if __name__ == "__main__":
    try:
        main()
    except (OSError, ValueError, records.RunError) as error:
        sys.exit(f"scene_runs.py: {error}")
