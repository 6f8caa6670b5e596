#!/usr/bin/env python3
"""Runs truthcube and collects what each run wrote into one file of JSON: runs for the table of the README, or, with
--errors, for the plot of error against time and the table of errors: each solves from rest to one compression, and its
beads are compared with the checked-in reference (tests/fem/solver/oracle), which is of a Poisson's ratio of 0.49, or with
those of a finer mesh with patches (--finest). Each is a program of its own, which solves four times; the shortest time
behind the first is in the plot, both are in the table. A small run comes before them, so that none waits for files and
drivers to be loaded. Needs nothing but Python."""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import kernel_hashes  # noqa: E402
import result_lines  # noqa: E402
from truthcube import beads, records  # noqa: E402

# Poisson's ratio and the treatment of the volume, for the table.
BODIES = (("0.45", "tets"), ("0.49", "patches"), ("0.499", "patches"))
# How the load is reached: at once, from coarser meshes; or in the paper's three steps.
STEPPINGS = {"nested": ["0.1825"], "loads": ["0.05", "0.125", "0.1825"]}
# For the errors: those of which the reference has beads.
COMPRESSIONS = ("0.05", "0.125", "0.1825")
VOLUMES = ("tets", "patches")
PRECONDITIONERS = ("multigrid", "schwarz", "block-jacobi")


def table_runs(options):
    """Arguments of each run."""
    for cells in options.cells:
        for poisson, volume in BODIES:
            for stepping in options.steppings:
                for preconditioner in options.preconditioners or ["multigrid"]:
                    yield [
                        "--cells", str(cells), "--poisson", poisson, "--volume", volume, "--stepping", stepping,
                        "--preconditioner", preconditioner, "--repeat", "3", "--compress", *STEPPINGS[stepping],
                    ]  # fmt: skip


def error_runs(options):
    for preconditioner in options.preconditioners or offered(options.program):
        for volume in VOLUMES:
            for cells in options.cells:
                if cells == options.finest and volume == "patches":
                    continue  # the reference itself
                for top in options.tops:
                    for compression in options.compressions:
                        yield error_run(options, cells, volume, top, preconditioner, compression)


def error_run(options, cells, volume, top, preconditioner, compression):
    return [
        "--cells", str(cells), "--poisson", options.poisson, "--volume", volume, "--top", top, "--stepping", "nested",
        "--preconditioner", preconditioner, "--repeat", str(options.repeat), "--compress", compression,
    ]  # fmt: skip


def finest_beads(options, place):
    """Those of a finer mesh with patches, by upper plate and compression; and how they were made."""
    found = {}
    for top in options.tops:
        for compression in options.compressions:
            arguments = [*place, *error_run(options, options.finest, "patches", top, "multigrid", compression)]
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([options.program, *arguments, "--quiet", "--out", folder], check=True)
                tables = beads.read_beads(pathlib.Path(folder) / "beads.csv")
            name = " ".join(["truthcube", *arguments])
            found[top, float(compression)] = name, beads.at_compression(tables, float(compression))
    return found


def oracle_beads(settings, compression):
    """The checked-in reference for a run, and its name."""
    name = beads.oracle_name(settings, compression)
    if name is None:
        sys.exit(
            f"truthcube_runs.py: {beads.ORACLE} has no beads of Poisson's ratio {settings['poisson']:g} at a compression of "
            f"{compression:g}; --finest CELLS compares with those of a finer mesh"
        )
    return name, beads.at_compression(beads.read_beads(beads.ROOT / name), compression)


def offered(program):
    """Those of PRECONDITIONERS that the program has."""
    text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    names = re.search(r"--preconditioner \{([^}]*)\}", text)
    if names is None:
        sys.exit(f"truthcube_runs.py: {program} --help lists no preconditioners: is it truthcube?")
    return [name for name in PRECONDITIONERS if name in re.split(r",\s*", names[1])]


def fastest(options, arguments, reference):
    """The fastest of options.repeats equal runs; one that failed, if any did."""
    runs = [run(options.program, arguments, reference) for _ in range(options.repeats)]
    return min(runs, key=lambda run: sum(step["seconds"] for step in run.get("steps", [])))


def run(program, arguments, reference=None):
    """One run, as its run.json has it without Newton steps, with its command; or why it failed.
    @param reference of a run's settings and a compression: name and beads that its own are compared with"""
    command = {"command": " ".join(["truthcube", *arguments])}
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [program, *arguments, "--quiet", "--out", folder], capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            return {**command, "failed": done.stderr.strip(), "status": done.returncode}
        record = {**records.read_record(pathlib.Path(folder) / "run.json"), **command}
        for step in record["steps"]:
            del step["newton"]
            if reference is not None:
                table = beads.read_beads(pathlib.Path(folder) / "beads.csv")
                step["beads"] = errors(table, step["compression"], *reference(record["settings"], step["compression"]))
        return record


def errors(table, compression, name, there):
    """How far the run's beads are from those of the reference."""
    difference = beads.at_compression(table, compression).less(there)
    return {"reference": name, "rms_mm": beads.rms_mm(difference), "max_mm": beads.largest_mm(difference)}


def machine(options):
    """The processor that times on the CPU are of; a GPU is named in each run."""
    if options.device == "cuda":
        return ""
    name = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    threads = f"{options.threads} thread{'s' * (options.threads != 1)}" if options.threads else "all threads"
    busy = ", beside other work" if os.getloadavg()[0] > 1 else ""  # before the first run: times are then too long
    return f"{name[1].strip() if name else 'CPU'}, {threads}{busy}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("-o", "--output", required=True, metavar="FILE.json")
    parser.add_argument("--errors", action="store_true", help="runs for the plot of error against time")
    parser.add_argument("--device", default="cuda", choices=["cpu", "cuda"])
    parser.add_argument("--threads", type=int, default=0, help="on the CPU; 0: as many as truthcube takes by itself")
    parser.add_argument("--cells", type=int, nargs="+", help="64; with --errors 8 16 32 64")
    parser.add_argument("--preconditioners", nargs="+", help="multigrid; with --errors those that the program has")
    parser.add_argument("--poisson", default="0.49", metavar="NU", help="with --errors; 0.49")
    parser.add_argument("--tops", nargs="+", choices=["bonded", "frictionless"], default=["bonded"], help="with --errors; bonded")
    parser.add_argument("--compressions", nargs="+", default=COMPRESSIONS, metavar="C", help="with --errors; those of the reference")
    parser.add_argument("--finest", type=int, metavar="CELLS", help="with --errors: compare with so many cells with patches")
    parser.add_argument("--repeat", type=int, default=3, metavar="N", help="with --errors: further solves of each program; 3")
    parser.add_argument("--steppings", nargs="+", choices=STEPPINGS, default=list(STEPPINGS), help="for the table; all")
    parser.add_argument("--repeats", type=int, default=1, help="runs of a kind, of which the fastest counts")
    options = parser.parse_args()
    options.cells = options.cells or ([8, 16, 32, 64] if options.errors else [64])
    where = machine(options)
    measured = kernel_hashes.of([options.program])
    runs, place = [], ["--device", options.device, *(["--threads", str(options.threads)] if options.threads else [])]
    run(options.program, [*place, "--cells", "4", "--compress", "0.05"])
    reference = oracle_beads if options.errors else None
    if options.errors and options.finest:
        finest = finest_beads(options, place)
        reference = lambda settings, compression: finest[settings["top"], compression]  # noqa: E731
    for arguments in (error_runs if options.errors else table_runs)(options):
        runs.append(fastest(options, [*place, *arguments], reference))
        outcome = [[step["seconds"], step.get("beads", {}).get("rms_mm", "")] for step in runs[-1].get("steps", [])]
        print(runs[-1]["command"], *outcome, runs[-1].get("failed", ""), flush=True)
        # Kept on the way, so that runs that are cut short leave what was measured.
        file = {"kernels": measured, "machine": where, "repeats": options.repeats, "runs": runs}
        result_lines.write(options.output, file)
    return 1 if any("failed" in run for run in runs) else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (records.RunError, OSError, ValueError) as error:
        sys.exit(f"truthcube_runs.py: {error}")
