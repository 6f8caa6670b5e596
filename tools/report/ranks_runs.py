#!/usr/bin/env python3
"""Runs truthcube on one GPU and on several ranks with a GPU each, by turns, and collects their times:
ranks_runs.py TRUTHCUBE -o FILE.json [--ranks N] [--runs N] CELLS,POISSON,VOLUME[,RUNS]...

A cube is pressed by 5 %, nested, and solved again three times; times are medians of all runs. Needs nothing but Python
and mpirun."""
import argparse
import datetime
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import result_lines  # noqa: E402

FLAGS = ["--scene", "quasistatic", "--device", "cuda", "--compress", "0.05", "--repeat", "3", "--quiet"]


def run(program, ranks, body, folder):
    """run.json of one run."""
    launcher = [] if ranks == 1 else ["mpirun", "--oversubscribe", "-n", str(ranks)]
    out = pathlib.Path(folder) / f"{ranks}"
    subprocess.run([*launcher, program, *body, *FLAGS, "--out", str(out)], check=True)
    record = json.loads((out / "run.json").read_text())
    for file in out.iterdir():
        file.unlink()
    return record


def row(ranks, cells, poisson, volume, records):
    steps = [record["steps"][-1] for record in records]

    def median(of):
        return round(statistics.median(of), 6)

    sent = records[0].get("ranks")
    crossed = {"exchanges": sent["exchanges"], "gathers": sent["gathers"], "sent_bytes": sent["bytes"] + sent["gathered_bytes"]} if sent else {}
    return {"cells": int(cells), "poisson": float(poisson), "volume": volume, "ranks": ranks, "tets": records[0]["tets"], "runs": len(records),
            "newton_steps": steps[0]["newton_iterations"], "iterations": steps[0]["pcg_iterations"],
            "first_seconds": median(step["seconds"] for step in steps), "seconds": median(step["warm_seconds"] for step in steps),
            "setup_seconds": median(record["setup_seconds"] for record in records), "bytes": records[0]["bytes"], **crossed}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="TRUTHCUBE")
    parser.add_argument("-o", "--output", required=True, metavar="FILE.json")
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--runs", type=int, default=5, help="of each body and number of ranks")
    parser.add_argument("bodies", nargs="+", metavar="CELLS,POISSON,VOLUME[,RUNS]")
    options = parser.parse_args()
    rows = []
    for body in options.bodies:
        words = body.split(",")
        if len(words) not in (3, 4) or not words[-1 if len(words) == 4 else 0].isdecimal():
            sys.exit(f"ranks_runs.py: '{body}' is no body; write cells, Poisson's ratio, volumes and, for other than --runs, how many runs, "
                     "such as 64,0.49,patches or 216,0.45,tets,1")
        cells, poisson, volume = words[:3]
        records = {1: [], options.ranks: []}
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(int(words[3]) if len(words) == 4 else options.runs):
                for ranks, of_ranks in records.items():
                    of_ranks.append(run(options.program, ranks, ["--cells", cells, "--poisson", poisson, "--volume", volume], folder))
        device = f"{options.ranks} x {records[1][0]['device']}"
        for ranks, of_ranks in records.items():
            rows.append(row(ranks, cells, poisson, volume, of_ranks))
            print(json.dumps(rows[-1]), flush=True)
        command = f"ranks_runs.py truthcube --ranks {options.ranks} --runs {options.runs} " + " ".join(options.bodies)
        result_lines.write(options.output, {"command": command, "date": str(datetime.date.today()), "device": device, "rows": rows})


if __name__ == "__main__":
    try:
        main()
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        sys.exit(f"ranks_runs.py: {error}")
