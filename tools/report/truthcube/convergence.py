"""Residual over the Newton steps of each step of a run, on all meshes."""
import matplotlib.ticker
import numpy as np
from matplotlib.figure import Figure as Plot

import names
from drawing import MUTED, WIDTH, key, log_ticks

from .body import COLUMNS


def curves(step):
    """Newton steps in order, by mesh: [(levels coarser, [number of the step], [residual], [PCG iterations])]; a mesh
    begins anew when another one lay between."""
    found = []
    for number, newton in enumerate(step.record["newton"], 1):
        if not found or found[-1][0] != newton["coarser_by"]:
            found.append((newton["coarser_by"], [], [], []))
        residual = newton["residual"]
        for values, value in zip(found[-1][1:], (number, np.nan if residual is None else residual, newton["pcg_iterations"])):
            values.append(value)
    return found


def draw(run):
    steps = run.shown()
    columns = min(len(steps), COLUMNS)
    rows = -(-len(steps) // columns)
    figure = Plot(figsize=(WIDTH, 0.4 + 2.5 * rows), layout="constrained")
    grid = figure.subplots(rows, columns, sharey=True, squeeze=False)
    tolerance = run.record["settings"]["tolerance"]
    every = [value for step in steps for curve in curves(step) for value in curve[2] if value > 0]
    low, high = min(min(every), tolerance) / 4, max(every) * 4
    levels = 0
    for axes in grid.ravel()[len(steps) :]:
        axes.remove()
    for axes, step in zip(grid.ravel(), steps):
        for level, numbers, residuals, iterations in curves(step):
            levels = max(levels, level)
            colour = _colour(level)
            axes.plot(numbers, residuals, "o-", color=colour, markersize=4, linewidth=1.3)
            for x, y, count in zip(numbers, residuals, iterations):
                axes.annotate(f"{count}", (x, y), xytext=(4, 3), textcoords="offset points", fontsize=7, color=MUTED)
        axes.axhline(tolerance, color=MUTED, linewidth=0.8, linestyle="--")
        axes.set(yscale="log", ylim=(low, high))
        axes.set_title(step.title(), fontsize=8.5, fontweight="normal", loc="center", pad=14)
        axes.set_xlabel("Newton step")
        axes.xaxis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))
        axes.margins(x=0.12)
        axes.grid(axis="y")
        axes.tick_params(axis="y", length=0)
    log_ticks(grid[0, 0].yaxis, low, high, lambda tick: f"$10^{{{round(np.log10(tick))}}}$", steps=(1,))
    for axes in grid[:, 0]:
        axes.set_ylabel("relative residual after the step")
    grid[0, 0].annotate("tolerance", (0, tolerance), xycoords=("axes fraction", "data"), xytext=(2, -2),
                     textcoords="offset points", va="top", fontsize=7.5, color=MUTED)  # fmt: skip
    key(grid[0, 0], [(_name(level), _colour(level)) for level in range(levels, -1, -1)], in_layout=False)
    figure.suptitle(f"Numbers at points: PCG iterations. {run.title()}", fontsize=8.5, x=0.01, ha="left")
    return figure


def _name(level):
    return "finest mesh" if level == 0 else f"{2**level} times coarser" if level > 1 else "twice as coarse"


def _colour(level):
    return names.SERIES[level % len(names.SERIES)]
