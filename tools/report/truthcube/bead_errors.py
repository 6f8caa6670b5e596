"""Errors of beads and of reactions over meshes, from files of truthcube_runs.py --errors: a row for each treatment of the
volume and each number of cells. Needs nothing but Python."""
import re

from . import beads, records
from .records import RunError

AGAIN = "measure again with tools/report/truthcube_runs.py --errors"
REACTIONS = f"{beads.ORACLE}/README.md"


def oracle_reactions():
    """The checked-in reference: {(upper plate, compression): over Young's modulus [m^2]}. @throws RunError"""
    text = " ".join((beads.ROOT / REACTIONS).read_text(encoding="utf-8").split())
    found = re.search(r"Reaction / E \[1e-4 m\^2\], c = ([\d., ]+): bonded ([-\d., ]+); frictionless ([-\d., ]+)\.", text)
    if found is None:
        raise RunError(f"{REACTIONS} has no line of reactions")
    compressions, *tops = ([float(number) for number in part.split(",")] for part in found.groups())
    return {
        (top, compression): 1e-4 * reaction
        for top, reactions in zip(("bonded", "frictionless"), tops)
        for compression, reaction in zip(compressions, reactions)
    }


def lines(content, name):
    """Header and rows of the table, of runs under multigrid. The reactions are those at the largest compression, where the
    reference has one: of the mesh, and extrapolated from half as many cells. @param name of the file. @throws RunError
    naming the place"""
    runs = content.get("runs") if isinstance(content, dict) else None
    if not isinstance(runs, list) or not runs:
        raise RunError(f"{name}: no list of 'runs'; {AGAIN}")
    found = {}
    for number, run in enumerate(runs):
        place = f"{name}: runs[{number}]"
        if isinstance(run, dict) and "failed" in run:
            raise RunError(f"{place} failed: {run['failed']}")
        records.check_record(run, place, with_newton=False)
        settings = run["settings"]
        records.require(settings, {"cells": int, "young": float}, f"{place}: settings", AGAIN)
        if settings["preconditioner"] != "multigrid":
            continue
        if len(run["steps"]) != 1:
            raise RunError(f"{place} has {len(run['steps'])} steps, and a row is of solves from rest; {AGAIN}")
        step = run["steps"][0]
        records.require(step, {"beads": dict, "reaction": float, "reaction_estimate": float}, f"{place}: steps[0]", AGAIN)
        records.require(step["beads"], {"rms_mm": float}, f"{place}: steps[0].beads", AGAIN)
        body = (settings["top"], settings["poisson"], settings["volume"], settings["cells"])
        if step["compression"] in found.setdefault(body, {}):
            raise RunError(f"{place}: such a run is there already")
        found[body][step["compression"]] = run, step
    compressions = sorted({compression for steps in found.values() for compression in steps})
    if not compressions:
        raise RunError(f"{name}: no run by multigrid; {AGAIN}")
    reactions = oracle_reactions()
    with_reactions = any(poisson == 0.49 and (top, compressions[-1]) in reactions for top, poisson, *_ in found)
    table = []
    for (top, poisson, volume, cells), steps in found.items():
        rms = [f"{steps[c][1]['beads']['rms_mm']:.3f}" if c in steps else "–" for c in compressions]
        run, step = steps.get(compressions[-1], (None, None))
        row = [f"{top}, {poisson:g}, {volume}", f"{cells}³", *rms]
        if with_reactions:
            wanted = reactions.get((top, compressions[-1])) if poisson == 0.49 else None
            for key in ("reaction", "reaction_estimate"):
                known = step is not None and step[key] is not None and wanted is not None
                row.append(f"{100 * (step[key] / run['settings']['young'] / wanted - 1):+.1f} %" if known else "–")
        table.append([*row, f"{step['seconds']:.3g} s" if step else "–"])
    at = [f"beads at {100 * compression:g} % [mm RMS]" for compression in compressions]
    head = ["upper plate, nu, volume by", "cells", *at]
    last = f"at {100 * compressions[-1]:g} %"
    if with_reactions:
        head += [f"reaction of the mesh {last}", "extrapolated"]
    return [*head, f"solved {last} in"], table
