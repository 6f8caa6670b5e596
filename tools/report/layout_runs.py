#!/usr/bin/env python3
"""Runs truthcube and physbench linear_solves of two builds that differ in their layouts, and collects their times:
layout_runs.py build/release build/aos -o FILE.json [--device cpu|cuda] [--cells N]

The first build has the layouts of the schemas, the second one layout for all arrays (cmake -DPHYSGEN_LAYOUT=aos). For
each body the builds take turns: the whole solve, to 18.25 % by nested steps, and one linear solve at rest. Each time is
the shortest (truthcube) or the median (linear_solves) of solves behind a first one. Needs nothing but Python."""
import argparse
import pathlib
import sys

sys.dont_write_bytecode = True
import linear_solves_runs  # noqa: E402
import kernel_hashes  # noqa: E402
import result_lines  # noqa: E402
import truthcube_runs  # noqa: E402
from truthcube import layouts, records  # noqa: E402


def measure(build, place, poisson, volume):
    """One body in one build. @throws RunError where a program failed"""
    body = [*place, "--poisson", poisson, "--volume", volume]
    nested = ["--stepping", "nested", "--compress", "0.1825", "--repeat", "3"]
    whole = truthcube_runs.run(str(build / "bin" / "truthcube"), [*body, *nested])
    if "failed" in whole:
        raise records.RunError(f"{build}: {whole['command']}: exit status {whole['status']}: {whole['failed']}")
    methods = ["--method", "multigrid", "block-jacobi", "--norm", "euclidean"]
    linear = linear_solves_runs.run(str(build / "bin" / "physbench"), [*body, *methods])
    return {"layout": whole["layout"], "whole": whole, "linear": linear}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("builds", nargs=2, type=pathlib.Path, metavar="BUILD", help="with the schemas' layouts, and with one")
    parser.add_argument("-o", "--output", required=True, metavar="FILE.json")
    parser.add_argument("--device", default="cuda", choices=["cpu", "cuda"])
    parser.add_argument("--cells", type=int, default=64)
    options = parser.parse_args()
    place = ["--device", options.device, "--cells", str(options.cells)]
    bodies, programs = [], [build / "bin" / name for build in options.builds for name in ("truthcube", "physbench")]
    for poisson, volume in truthcube_runs.BODIES:
        bodies.append([measure(build, place, poisson, volume) for build in options.builds])
        file = {"kernels": kernel_hashes.of(programs), "bodies": bodies}
        result_lines.write(options.output, file)
        print(*layouts.lines(file, options.output)[1][-1], sep="; ", flush=True)


if __name__ == "__main__":
    try:
        main()
    except (OSError, ValueError, records.RunError) as error:
        sys.exit(f"layout_runs.py: {error}")
