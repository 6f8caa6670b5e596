#!/usr/bin/env python3
"""Runs truthcube for the table of the README and collects what each run wrote: truthcube_runs.py PROGRAM -o FILE.json
[--device cpu|cuda] [--cells N ...]"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import sources  # noqa: E402

# What the figures depend on.
MEASURED = ("runtime", "generated", "tools/fem", "tools/truthcube")
# Poisson's ratio and the treatment of the volume.
BODIES = (("0.45", "tets"), ("0.49", "patches"), ("0.499", "patches"))
# How the load is reached: at once, from coarser meshes; or in the paper's three steps.
STEPPINGS = {"nested": ["0.1825"], "loads": ["0.05", "0.125", "0.1825"]}


def run(program, arguments):
    """One run, as its run.json has it, with its command. Each is a program of its own, so the first solve counts."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, *arguments, "--quiet"]
        done = subprocess.run([*command, "--out", folder], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return {"command": " ".join(["truthcube", *arguments]), "failed": done.stderr.strip(), "status": done.returncode}
        record = json.loads((pathlib.Path(folder) / "run.json").read_text())
        record["command"] = " ".join(["truthcube", *arguments])
        return record


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--device", default="cuda", choices=["cpu", "cuda"])
    parser.add_argument("--cells", type=int, nargs="+", default=[64])
    parser.add_argument("--preconditioners", nargs="+", default=["multigrid"])
    options = parser.parse_args()
    runs = []
    for cells in options.cells:
        for poisson, volume in BODIES:
            for stepping, loads in STEPPINGS.items():
                for preconditioner in options.preconditioners:
                    arguments = ["--device", options.device, "--cells", str(cells), "--poisson", poisson]
                    arguments += ["--volume", volume, "--stepping", stepping, "--preconditioner", preconditioner]
                    runs.append(run(options.program, [*arguments, "--compress", *loads]))
                    print(runs[-1]["command"], [step["seconds"] for step in runs[-1].get("steps", [])], flush=True)
    text = json.dumps({"sources": sources.text(sources.hashes(groups=MEASURED)), "runs": runs}, indent=1)
    pathlib.Path(options.output).write_text(text + "\n")


if __name__ == "__main__":
    main()
