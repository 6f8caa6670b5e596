"""Displacements of the beads as arrows; and, where there are beads to compare with, their differences."""
import matplotlib.colors
import numpy as np
from matplotlib.figure import Figure as Plot

import names
from drawing import MUTED, RULE, WIDTH

from . import geometry, render
from .body import DISPLACEMENT, shades
from .beads import at_compression, largest_mm, rms_mm
from .files import lengths

LENGTH, ERROR = shades("YlGnBu", 0.3, 0.9), shades("YlOrRd", 0.3, 1)  # seen on white


def draw(run, step, reference=None, reference_name=""):
    """One step: all beads in perspective, those of the middle plane, and there `reference` less the run, magnified."""
    beads = _Arrays(at_compression(run.beads, step.compression))
    columns = 2 if reference is None else 3
    figure = Plot(figsize=(WIDTH, 3.75 if columns == 3 else 4.2), layout="constrained")
    grid = figure.subplots(1, columns)
    _in_space(grid[0], run, step, beads)
    _in_plane(grid[1], run, beads)
    colours = _colours(beads.displacement)
    _bar(figure, list(grid[:2]), colours, f"{DISPLACEMENT.name} [{DISPLACEMENT.unit}]")
    if reference is not None:
        difference = np.array(beads.table.less(reference))
        _differences(figure, grid[2], run, beads, difference, reference_name)
    figure.get_layout_engine().set(rect=(0, 0, 1, 0.95))
    figure.suptitle(f"{len(beads.rest)} beads, {step.title()}: {run.title()}", fontsize=8.5, x=0.01, ha="left")
    return figure


class _Arrays:
    def __init__(self, table):
        self.table, self.rest, self.displacement = table, np.array(table.rest), np.array(table.displacement)


def _colours(vectors, colours=LENGTH):
    limits = matplotlib.colors.Normalize(0, 1e3 * lengths(vectors).max() or 1)
    return matplotlib.cm.ScalarMappable(limits, colours)


def _bar(figure, axes, mappable, label):
    bar = figure.colorbar(mappable, ax=axes, location="bottom", aspect=26, shrink=0.8, pad=0.03)
    bar.set_label(label)
    bar.outline.set_linewidth(0)
    bar.ax.tick_params(labelsize=8, color=MUTED, length=2)


def _arrows(axes, start, vectors, colours, width):
    axes.quiver(
        *start.T, *vectors.T, color=colours, angles="xy", scale_units="xy", scale=1, units="xy", width=width,
        headwidth=3.6, headlength=4.2, headaxislength=3.8, minlength=0, zorder=3,
    )  # fmt: skip


def _in_space(axes, run, step, beads):
    low, high = run.points.min(axis=0), run.points.max(axis=0)
    size = (high - low).max()
    camera = render.perspective((low + high) / 2, size)
    for nodes in geometry.box_edges(run.points):
        axes.plot(*camera.project(run.points[nodes])[0].T, "--", color=RULE, linewidth=0.7, zorder=1)
        moved = run.points[nodes] + step.displacement[nodes]
        axes.plot(*camera.project(moved)[0].T, color=MUTED, linewidth=0.8, zorder=2)
    order = np.argsort(-((beads.rest - camera.target) @ camera.ahead))  # the farthest first
    start = camera.project(beads.rest)[0]
    end = camera.project(beads.rest + beads.displacement)[0]
    colours = _colours(beads.displacement).to_rgba(1e3 * lengths(beads.displacement))
    _arrows(axes, start[order], (end - start)[order], colours[order], 0.006 * size)
    axes.set(aspect="equal")
    axes.axis("off")
    axes.set_title("from rest to where they are", fontweight="normal", fontsize=8, loc="center")


def _in_middle(beads):
    """The beads of the plane of y nearest to their middle, and x and z of their rest positions [mm]."""
    y = beads.rest[:, 1]
    nearest = y[np.argmin(np.abs(y - (y.min() + y.max()) / 2))]
    chosen = np.flatnonzero(np.abs(y - nearest) < 1e-6)
    return chosen, 1e3 * beads.rest[chosen][:, [0, 2]], 1e3 * nearest


def _plane(axes, run, title):
    low, high = 1e3 * run.points.min(axis=0), 1e3 * run.points.max(axis=0)
    axes.plot(
        [low[0], high[0], high[0], low[0], low[0]], [low[2], low[2], high[2], high[2], low[2]], "--", color=RULE,
        linewidth=0.7, zorder=1,
    )  # fmt: skip
    margin = 0.06 * (high - low).max()
    axes.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[2] - margin, high[2] + margin), aspect="equal")
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("z [mm]", labelpad=2)
    axes.set_title(title, fontweight="normal", fontsize=8, loc="center")


def _in_plane(axes, run, beads):
    chosen, start, y = _in_middle(beads)
    vectors = 1e3 * beads.displacement[chosen][:, [0, 2]]
    colours = _colours(beads.displacement).to_rgba(1e3 * lengths(beads.displacement[chosen]))
    _arrows(axes, start, vectors, colours, 0.55)
    _plane(axes, run, f"the plane y = {y:g} mm")


def _differences(figure, axes, run, beads, difference, reference_name):
    """Run less reference in the middle plane, magnified to a round factor."""
    chosen, start, y = _in_middle(beads)
    mm = 1e3 * difference
    factor = _round_down(8 / max(lengths(mm[chosen]).max(), 1e-9))
    _arrows(axes, start, factor * mm[chosen][:, [0, 2]], _colours(difference, ERROR).to_rgba(lengths(mm[chosen])), 0.55)
    _plane(axes, run, f"run less {reference_name}, {names.significant(factor, 1)} times as long")
    label = f"difference [mm]: RMS {rms_mm(difference):.3f}, largest {largest_mm(difference):.3f}"
    _bar(figure, [axes], _colours(difference, ERROR), label)


def _round_down(value):
    power = 10.0 ** np.floor(np.log10(value))
    return max(step * power for step in (1, 2, 5) if step * power <= value)
