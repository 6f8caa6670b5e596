#!/usr/bin/env python3
"""Runs physbench linear_solves for the comparison of one linear solve by several methods and collects the rows:
linear_solves_runs.py PROGRAM -o FILE.json [--device cpu|cuda] [--cells N] [--counts N ...] [--large N] [--repeat N]

  --cells   the cube on which all methods are compared, with the device's copy beside them (0: none)
  --counts  cubes whose iterations with multigrid are counted, in both norms (0: none)
  --large   a cube whose iteration is held against the device's copy (0: none)"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import kernel_hashes  # noqa: E402
import result_lines  # noqa: E402
from truthcube import linear_solves  # noqa: E402

# Poisson's ratios with the treatment of the volume: those of one volume share their mesh.
BODIES = (("tets", ["0.45"]), ("patches", ["0.49", "0.499"]))


def arguments_of(options):
    """The runs, as arguments of physbench linear_solves."""
    for volume, poissons in BODIES:
        body = ["--volume", volume, "--poisson", *poissons, "--device", options.device]
        if options.cells:
            methods = ["multigrid", "schwarz", "block-jacobi"] + ["vendor"] * (options.device == "cuda")
            yield ["--cells", str(options.cells), "--method", *methods, "--precision", "half", "float", "--norm", "euclidean",
                   "--repeat", str(options.repeat), *body]
        if any(options.counts):  # not times, so one solve is enough
            yield ["--cells", *map(str, options.counts), "--method", "multigrid", "--norm", "preconditioned", "euclidean",
                   "--repeat", "1", *body]
    if options.large:
        yield ["--cells", str(options.large), "--volume", "tets", "--poisson", "0.45", "--method", "multigrid",
               "block-jacobi", "--device", options.device, "--repeat", "3"]


def run(program, arguments):
    """The rows of one run, with its table on the way."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "rows.json"
        words = ["linear_solves", *arguments, f"--json={file}", "--benchmark_min_time=0"]  # a sample is a median
        status = subprocess.run([program, *words], check=False).returncode
        if not file.exists():
            sys.exit(f"{program} {' '.join(words)}: exit status {status} and no rows")
        rows = linear_solves.rows_of(json.loads(file.read_text()), file.name)
    for row in rows:
        row["command"] = "physbench linear_solves " + " ".join(arguments)
    return rows


def named(row):
    return f"{row['cells']}^3, nu {row['poisson']:g} by {row['volume']}, {row['norm']} norm"


def ratios(rows):
    """For each body on which the vendor was measured: how much faster each method is, without and with its set-up."""
    for vendor in (row for row in rows if row["method"] == "vendor"):
        for row in rows:
            if row["method"] == "vendor" or named(row) != named(vendor):
                continue
            solve = vendor["solve_seconds"] / row["solve_seconds"]
            whole = (vendor["setup_seconds"] + vendor["solve_seconds"]) / (row["setup_seconds"] + row["solve_seconds"])
            yield (
                f"{named(row)}: {row['method']} in {row['precision']} is {solve:.1f}x as fast as the vendor, {whole:.1f}x "
                f"with the set-up of both; residuals {row['residual']:.1e} and {vendor['residual']:.1e}"
            )


def halves(rows):
    """Multigrid in half against multigrid in float."""
    for half in (row for row in rows if (row["method"], row["precision"]) == ("multigrid", "half")):
        for row in rows:
            if (row["method"], row["precision"], named(row)) != ("multigrid", "float", named(half)):
                continue
            faster = row["seconds_per_iteration"] / half["seconds_per_iteration"]
            yield (
                f"{named(row)}: multigrid in half takes {half['iterations']} iterations, in float {row['iterations']}; an "
                f"iteration in half is {faster:.2f}x as fast"
            )


def counts(rows):
    """Iterations of multigrid in half over the cubes."""
    found = {}
    for row in rows:
        if (row["method"], row["precision"]) == ("multigrid", "half"):
            found.setdefault((row["poisson"], row["volume"], row["norm"]), {})[row["cells"]] = row["iterations"]
    for (poisson, volume, norm), iterations in found.items():
        of_cells = ", ".join(f"{count} for {cells}^3" for cells, count in sorted(iterations.items()))
        yield f"nu {poisson:g} by {volume}, {norm} norm: multigrid takes {of_cells}"


def shares(rows):
    """Products and iterations against the device's copy of as many bytes."""
    for row in rows:
        if row["product_copy_seconds"] is not None and row["norm"] == "euclidean":
            product = row["product_copy_seconds"] / row["product_seconds"]
            iteration = row["iteration_copy_seconds"] / row["seconds_per_iteration"]
            yield (
                f"{named(row)}: {row['method']} in {row['precision']}: a product runs at {product:.2f} of the copy rate of its "
                f"{row['product_bytes'] / 1e6:.0f} MB, an iteration at {iteration:.2f} of its {row['iteration_bytes'] / 1e6:.0f} MB"
            )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--device", default="cuda", choices=["cpu", "cuda"])
    parser.add_argument("--cells", type=int, default=64)
    parser.add_argument("--counts", type=int, nargs="+", default=[0])
    parser.add_argument("--large", type=int, default=0)
    parser.add_argument("--repeat", type=int, default=5)
    options = parser.parse_args()
    rows = []
    for arguments in arguments_of(options):
        print("physbench linear_solves", *arguments, flush=True)
        rows += run(options.program, arguments)
        # Kept on the way, so that a run that is cut short leaves what was measured.
        result_lines.write(options.output, {"kernels": kernel_hashes.of([options.program]), "rows": rows})
    for summary in (ratios, halves, counts, shares):
        print("", *summary(rows), sep="\n")


if __name__ == "__main__":
    main()
