"""The table of truthcube's solves on one GPU and on several, of the rows of ranks_runs.py."""
from truthcube.records import RunError


def lines(file, name):
    """Header and rows: a body's solves on one GPU and on several, in milliseconds.

    @throws RunError where a row is missing"""
    several = max(row["ranks"] for row in file["rows"])
    body = []
    for one in (row for row in file["rows"] if row["ranks"] == 1):
        same = [row for row in file["rows"] if row["ranks"] == several and all(row[k] == one[k] for k in ("cells", "poisson", "volume"))]
        if len(same) != 1:
            raise RunError(f"{name} has {len(same)} rows of {several} ranks, {one['cells']}^3, {one['poisson']:g}; measure it again")
        many = same[0]
        body.append([f"{one['cells']}^3, {one['poisson']:g}, {one['volume']}", f"{one['tets'] / 1e6:.1f}", str(many["iterations"]),
                     f"{1e3 * one['seconds']:.1f}", f"{1e3 * many['seconds']:.1f}", f"{one['seconds'] / many['seconds']:.2f}",
                     f"{one['setup_seconds']:.1f} and {many['setup_seconds']:.1f}"])
    return ["cube, Poisson's ratio, volumes", "million tets", "iterations", "ms on one GPU", f"ms on {several}", "one over several",
            "s of set-up on one and on several"], body
