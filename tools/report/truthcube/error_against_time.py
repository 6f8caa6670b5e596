"""Error against time: how far the beads of runs are from the checked-in reference, over the seconds of the solve, for
meshes, treatments of the volume and preconditioners. Drawn from what truthcube_runs.py --errors writes."""
import pathlib
from dataclasses import dataclass

from matplotlib.lines import Line2D

import names
from drawing import INK, MUTED, RULE, log_ticks, plot

from . import records
from .linear_solves import METHODS
from .records import RunError

AGAIN = "tools/report/truthcube_runs.py PROGRAM -o FILE.json --errors writes such a file"
# Estimated error (RMS) of the reference itself [mm]: tests/fem/solver/oracle/README.md.
REFERENCE = {0.05: 0.0007, 0.125: 0.003, 0.1825: 0.011}
COLOURS = dict(zip(("multigrid", "schwarz", "block-jacobi"), names.SERIES))
STYLES = {"patches": ("o", "-", "volume by patches"), "tets": ("s", "--", "volume by tets")}


@dataclass(frozen=True)
class Point:
    compression: float
    volume: str
    preconditioner: str
    cells: int
    seconds: float  # of the shortest solve behind the program's first
    rms_mm: float


def read(path):
    """@return points, what ran them, commands of runs that failed. @throws RunError naming the run"""
    path = pathlib.Path(path)
    content = records.load_json(path)
    if not isinstance(content, dict) or not isinstance(content.get("runs"), list) or not content["runs"]:
        raise RunError(f"{path}: no runs; {AGAIN}")
    points, machines, failed = [], [], []
    for number, run in enumerate(content["runs"]):
        place = f"{path}: runs[{number}]"
        if isinstance(run, dict) and "failed" in run:
            failed.append(str(run.get("command")))
            continue
        points += _points(records.check_record(run, place, with_newton=False), place)
        device = content.get("machine") if run["device"] == "cpu" else run["device"]
        machines.append(str(device or "CPU"))
    if len(set(machines)) > 1:
        raise RunError(f"{path}: runs of {' and '.join(sorted(set(machines)))}: their times do not compare; {AGAIN}")
    if not points:
        raise RunError(f"{path}: all runs failed; {AGAIN}")
    repeats = content.get("repeats", 1)
    return points, machines[0] + (f", fastest of {repeats} runs" if repeats != 1 else ""), failed


def _points(run, place):
    settings = run["settings"]
    records.require(settings, {"cells": int}, f"{place}: settings")
    if len(run["steps"]) != 1:
        raise RunError(f"{place} has {len(run['steps'])} steps, and times count from rest to one compression; {AGAIN}")
    step, place = run["steps"][0], f"{place}: steps[0]"
    records.require(step, {"beads": dict, "warm_seconds": float}, place)
    records.require(step["beads"], {"rms_mm": float, "reference": str}, f"{place}.beads")
    for name, value in (("warm_seconds", step["warm_seconds"]), ("rms_mm", step["beads"]["rms_mm"])):
        if value is None or value <= 0:
            raise RunError(f"{place}: '{name}' is {value}, and a logarithm is drawn of it; {AGAIN}")
    return [
        Point(step["compression"], settings["volume"], settings["preconditioner"], settings["cells"],
              step["warm_seconds"], step["beads"]["rms_mm"])
    ]  # fmt: skip


def curves(points):
    """{compression: {(preconditioner, volume): points by cells}}"""
    found = {}
    for point in sorted(points, key=lambda point: (point.compression, point.cells)):
        of = found.setdefault(point.compression, {})
        of.setdefault((point.preconditioner, point.volume), []).append(point)
    return found


def draw(path):
    points, machine, failed = read(path)
    panels = curves(points)
    figure, grid = plot(3.7, len(panels), sharex=True, sharey=True)
    times, errors = [point.seconds for point in points], [point.rms_mm for point in points]
    limits = (min(times) / 1.6, max(times) * 1.9), (min(errors) / 1.6, max(errors) * 1.5)
    for axes, (compression, lines) in zip(grid[0], panels.items()):
        axes.set(xscale="log", yscale="log", xlim=limits[0], ylim=limits[1])
        axes.grid(alpha=0.8)
        axes.tick_params(length=0)
        for side in ("left", "bottom"):
            axes.spines[side].set_visible(False)
        for (preconditioner, volume), line in lines.items():
            marker, dashes, _ = STYLES.get(volume, ("^", ":", volume))
            axes.plot(
                [point.seconds for point in line], [point.rms_mm for point in line], marker + dashes,
                color=_colour(preconditioner), markersize=4.5, linewidth=1.3,
                markerfacecolor=None if volume == "patches" else "white", zorder=3,
            )  # fmt: skip
        _cells(axes, lines)
        own = REFERENCE.get(compression)
        if own and own > limits[1][0]:
            axes.axhspan(limits[1][0], own, color=RULE, alpha=0.5, zorder=0, linewidth=0)
            axes.annotate("the reference's own error", (0, own), xycoords=("axes fraction", "data"), xytext=(3, -2),
                          textcoords="offset points", va="top", fontsize=7, color=MUTED)  # fmt: skip
        axes.set_title(f"compressed by {100 * compression:g} %", fontsize=8.5, fontweight="normal", loc="center")
        axes.set_xlabel("time to solve from rest")
    span = max(times) / min(times) > 30
    log_ticks(grid[0][0].xaxis, *limits[0], _seconds, steps=(1,) if span else (1, 2, 5))
    log_ticks(grid[0][0].yaxis, *limits[1], lambda tick: f"{tick:g}")
    grid[0][0].set_ylabel("RMS error of 343 beads [mm]")
    _legend(figure, points)
    missing = f"; {len(failed)} run{'s' * (len(failed) != 1)} failed" if failed else ""
    figure.suptitle(f"Truth Cube, ν = 0.49, {machine}: numbers are cells per side{missing}", fontsize=9, x=0.01, ha="left")
    return figure


def _cells(axes, lines):
    """Cells per side at the points of the longest curves, and the fastest of them, one for each volume."""
    for volume in STYLES:
        of = [line for (_, name), line in lines.items() if name == volume]
        if not of:
            continue
        for point in min(of, key=lambda line: (-len(line), line[-1].seconds)):
            above = volume == "tets"
            axes.annotate(
                f"{point.cells}", (point.seconds, point.rms_mm), xytext=(4, 4) if above else (-4, -5),
                textcoords="offset points", ha="left" if above else "right", va="bottom" if above else "top",
                fontsize=7.5, color=INK,
            )  # fmt: skip


def _legend(figure, points):
    preconditioners = dict.fromkeys(point.preconditioner for point in points)
    handles = [Line2D([], [], color=_colour(name), linewidth=2.5, label=METHODS.get(name, name)) for name in preconditioners]
    for volume in dict.fromkeys(point.volume for point in points):
        marker, dashes, label = STYLES.get(volume, ("^", ":", volume))
        face = MUTED if volume == "patches" else "white"
        handles.append(Line2D([], [], color=MUTED, linestyle=dashes, marker=marker, markersize=4.5,
                              markerfacecolor=face, label=label))  # fmt: skip
    figure.legend(handles=handles, loc="lower center", ncols=len(handles), frameon=False, fontsize=8)
    figure.get_layout_engine().set(rect=(0, 0.075, 1, 0.925))  # matplotlib 3.6 keeps no room for it


def _colour(preconditioner):
    return COLOURS.get(preconditioner, "#8c8c8c")


def _seconds(tick):
    return f"{tick * 1e3:g} ms" if tick < 1 else f"{tick:g} s"
