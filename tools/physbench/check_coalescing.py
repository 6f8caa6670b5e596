#!/usr/bin/env python3
"""Compares physbench's model of coalescing with the counters of a GPU, on a machine with Nsight Compute (ncu).

    check_coalescing.py [--physbench PATH] [--kernels dp_from_df,stress_derivative,...] [--objects N]

Prints sectors per request of loads and stores together, modelled and counted, and their difference. Exit status: 0 when
all agree to --tolerance, 1 when one does not, 2 when ncu or physbench cannot be run.
"""

import argparse
import csv
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile

METRICS = {
    "sectors": [
        "l1tex__t_sectors_pipe_lsu_mem_global_op_ld.sum",
        "l1tex__t_sectors_pipe_lsu_mem_global_op_st.sum",
    ],
    "requests": [
        "l1tex__t_requests_pipe_lsu_mem_global_op_ld.sum",
        "l1tex__t_requests_pipe_lsu_mem_global_op_st.sum",
    ],
}


def fail(message):
    print(f"check_coalescing.py: {message}", file=sys.stderr)
    sys.exit(2)


def run(command):
    """The standard output of a command that must succeed."""
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        fail(f"{' '.join(command)} ended with status {done.returncode}: {(done.stderr or done.stdout).strip()[-800:]}")
    return done.stdout


def modelled(physbench, filter_, objects):
    """Sectors per request of each row, as physbench models them."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "rows.json")
        run([physbench, f"--objects={objects}", f"--benchmark_filter={filter_}", "--benchmark_min_time=0.001",
             f"--json={path}"])
        with open(path, encoding="utf-8") as file:
            rows = json.load(file)["benchmarks"]
    return {row["name"]: row["sectors_per_request"] for row in rows if "sectors_per_request" in row}


def counted(ncu, physbench, name, objects):
    """Sectors per request of the first launch of a row's kernel, as the hardware counts them."""
    metrics = ",".join(METRICS["sectors"] + METRICS["requests"])
    text = run([ncu, "--clock-control", "none", "--csv", "--page", "raw", "--kernel-name", "regex:for_each_object",
                "--metrics", metrics, "--launch-count", "1", physbench, f"--objects={objects}",
                f"--benchmark_filter=^{name}$", "--benchmark_min_time=0.001"])
    lines = [line for line in text.splitlines() if line.startswith('"')]
    table = list(csv.DictReader(io.StringIO("\n".join(lines))))
    row = table[-1]
    total = lambda metrics_: sum(float(row[metric].replace(",", "")) for metric in metrics_)
    return total(METRICS["sectors"]) / total(METRICS["requests"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--physbench", default="build/release/bin/physbench", help="the program (default: %(default)s)")
    parser.add_argument("--kernels", default="dp_from_df,stress_derivative,deformation_gradient,elastic_force",
                        help="kernels, separated by commas (default: %(default)s)")
    parser.add_argument("--objects", type=int, default=20000, help="tets (default: %(default)s)")
    parser.add_argument("--tolerance", type=float, default=0.05, help="relative (default: %(default)s)")
    arguments = parser.parse_args()
    ncu = shutil.which("ncu") or os.path.join(os.environ.get("CUDA_HOME", "/usr/local/cuda"), "bin", "ncu")
    if not os.access(ncu, os.X_OK):
        fail("there is no ncu on PATH or in $CUDA_HOME/bin; install Nsight Compute")
    if not os.access(arguments.physbench, os.X_OK):
        fail(f"there is no program {arguments.physbench}; tools/dev build makes it, --physbench=PATH names another")
    names = "|".join(arguments.kernels.split(","))
    rows = modelled(arguments.physbench, f"^({names})/(aos|soa|aosoa32)/float/cuda/", arguments.objects)
    if not rows:
        fail("no row has a model: is there a GPU?")
    worst = 0.0
    print(f"{'row':60} {'model':>8} {'counted':>8} {'off by':>8}")
    for name, model in rows.items():
        count = counted(ncu, arguments.physbench, name, arguments.objects)
        worst = max(worst, abs(model / count - 1))
        print(f"{name:60} {model:8.3f} {count:8.3f} {100 * (model / count - 1):7.2f}%", flush=True)
    return 0 if worst <= arguments.tolerance else 1


if __name__ == "__main__":
    sys.exit(main())
