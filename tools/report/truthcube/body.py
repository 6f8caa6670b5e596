"""The body at rest and compressed, in perspective and cut through the middle, coloured by displacement and von Mises
stress."""
from dataclasses import dataclass

import matplotlib.colors
import numpy as np
from matplotlib.figure import Figure as Plot

from drawing import INK, MUTED, WIDTH

from . import geometry, render
from .files import lengths

PIXELS = 1000  # of the width of all panels of a row
COLUMNS = 5  # of panels, at most
REST = "at rest"


@dataclass(frozen=True)
class Quantity:
    name: str
    unit: str
    colours: matplotlib.colors.Colormap
    values: object  # (run, step) -> values of the nodes
    share: float  # of the nodes that the colours' range has

    def range(self, run, steps):
        """@return the least, the largest of the colours, and the largest of all"""
        every = np.concatenate([self.values(run, step) for step in steps])
        return 0.0, float(np.quantile(every, self.share)), float(every.max())


def shades(name, begin, end):
    """A part of a colour map: painted lines are to be seen on its end, or its begin on white."""
    colours = matplotlib.colormaps[name](np.linspace(begin, end, 256))
    return matplotlib.colors.ListedColormap(colours, name)


DISPLACEMENT = Quantity(
    "displacement", "mm", shades("YlGnBu", 0, 0.84), lambda run, step: 1e3 * lengths(step.displacement), 1.0
)
# At bonded edges the stress has no largest value: finer meshes find larger ones.
VON_MISES = Quantity(
    "von Mises stress", "kPa", shades("YlOrRd", 0, 0.97), lambda run, step: 1e-3 * run.at_nodes(step.von_mises), 0.995
)


class View:
    """A way to look at a run: the triangles, and the camera with its window, which are the same for all steps."""

    def __init__(self, run, camera, edges, share, triangles, closed):
        self.run, self.camera = run, camera
        self.edges, self.share, self.triangles, self.closed = edges, share, triangles, closed
        low, high = run.points.min(axis=0), run.points.max(axis=0)
        self.low, self.distance = low, render.round_distance((high - low).max())
        every = [self.corners(run.points)] + [self.corners(run.points + step.displacement) for step in run.steps]
        flat = np.concatenate([camera.project(points)[0] for points in every])
        margin = 0.02 * np.ptp(flat, axis=0).max()
        left, bottom = flat.min(axis=0) - margin
        right, top = flat.max(axis=0) + margin
        self.window = (left, right, bottom, top)
        self.seen, self.pixels = {}, max(250, PIXELS // (1 + len(run.steps)))

    def corners(self, values):
        return geometry.on_edges(values, self.edges, self.share)

    def picture(self, step, quantity, limits):
        """The body, coloured; at rest where `step` is None. @return image with transparency"""
        if step not in self.seen:
            moved = self.run.points + (0 if step is None else step.displacement)
            values = [self.run.points] + [
                np.zeros(len(moved)) if step is None else q.values(self.run, step) for q in (DISPLACEMENT, VON_MISES)
            ]
            values = self.corners(np.column_stack(values))
            self.seen[step] = render.look(
                self.camera, self.corners(moved), self.triangles, values, self.window, self.pixels, self.closed
            )
        seen = self.seen[step]
        value = seen.values[..., 3 if quantity is DISPLACEMENT else 4]
        colours = quantity.colours(np.clip(value / limits[1], 0, 1))[..., :3]
        lines = render.grid_lines(seen.values[..., :3], self.distance, self.low)
        return render.paint(seen, colours, lines, self.closed)


def outside(run):
    """The surface in perspective."""
    low, high = run.points.min(axis=0), run.points.max(axis=0)
    triangles = geometry.surface(run.tets)
    nodes, index = np.unique(triangles, return_inverse=True)
    camera = render.perspective((low + high) / 2, (high - low).max())
    return View(run, camera, np.column_stack([nodes, nodes]), np.zeros(len(nodes)), index.reshape(-1, 3), True)


def middle(run):
    """The cut along y through the middle at rest; moved with the material."""
    low, high = run.points.min(axis=0), run.points.max(axis=0)
    centre = (low + high) / 2
    return View(run, render.along_y(centre), *geometry.cut(run.points, run.tets, 1, centre[1]), False)


# ---- Figures ---------------------------------------------------------------------------------------------------------
def _panel(axes, view, image, title, window=None):
    axes.imshow(image, extent=view.window, interpolation="antialiased", zorder=2)
    left, right, bottom, top = window or view.window
    axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
    axes.axis("off")
    axes.set_title(title, fontsize=8.5, fontweight="normal", loc="center", pad=3)


def _outline(axes, view):
    """The body's box at rest, dashed, behind the picture."""
    points = view.run.points
    low, high = points.min(axis=0), points.max(axis=0)
    corners = np.array([[(low, high)[bit >> k & 1][k] for k in range(3)] for bit in range(8)])
    flat = view.camera.project(corners)[0]
    for a in range(8):
        for k in range(3):
            if not a >> k & 1:
                axes.plot(*flat[[a, a | 1 << k]].T, "--", color=MUTED, linewidth=0.6, zorder=1)


def _bar(figure, axes, quantity, limits, **place):
    """A colour bar beside the panels; with a tip where some values lie beyond it."""
    low, high, largest = limits
    mappable = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(low, high), quantity.colours)
    beyond = largest > high * 1.001
    bar = figure.colorbar(mappable, ax=list(axes), extend="max" if beyond else "neither", **place)
    bar.set_label(f"{quantity.name} [{quantity.unit}]", color=INK)
    bar.outline.set_linewidth(0)
    bar.ax.tick_params(labelsize=8, color=MUTED, length=2)


def _title(run, view):
    return f"{run.title()}; lines are {1e3 * view.distance:g} mm apart at rest"


def steps(run, view):
    """Steps of a run: rows by displacement, then rows by von Mises stress, at rest first."""
    panels = [None, *run.shown()]
    columns = min(len(panels), COLUMNS)
    rows = -(-len(panels) // columns)
    left, right, bottom, top = view.window
    height = (WIDTH - 1.0) / columns * (top - bottom) / (right - left) + 0.25
    figure = Plot(figsize=(WIDTH, 2 * rows * height + 0.35), layout="constrained")
    grid = figure.subplots(2 * rows, columns, squeeze=False)
    for block, quantity in zip((grid[:rows].ravel(), grid[rows:].ravel()), (DISPLACEMENT, VON_MISES)):
        limits = quantity.range(run, run.shown())
        for axes in block[len(panels) :]:
            axes.axis("off")
        for axes, step in zip(block, panels):
            _outline(axes, view)
            _panel(axes, view, view.picture(step, quantity, limits), REST if step is None else step.title())
        _bar(figure, block, quantity, limits, aspect=16 * rows, shrink=0.82, pad=0.01)
    figure.suptitle(_title(run, view), fontsize=8.5, x=0.01, ha="left")
    return figure


def last_step(run, *views):
    """At rest; and after the last step by displacement, by von Mises stress, and this in the cut. @param views outside,
    middle"""
    step = run.steps[-1]
    panels = [
        (views[0], None, DISPLACEMENT, REST),
        (views[0], step, DISPLACEMENT, step.title()),
        (views[0], step, VON_MISES, step.title()),
        (views[1], step, VON_MISES, "cut through the middle"),
    ]
    figure = Plot(figsize=(WIDTH, 2.85), layout="constrained")
    grid = figure.subplots(1, 4)
    for axes, (view, at, quantity, title) in zip(grid, panels):
        _outline(axes, view)
        _panel(axes, view, view.picture(at, quantity, quantity.range(run, [step])), title, views[0].window)
    for quantity, axes in ((DISPLACEMENT, grid[:2]), (VON_MISES, grid[2:])):
        _bar(figure, axes, quantity, quantity.range(run, [step]), location="bottom", aspect=28, shrink=0.75, pad=0.02)
    figure.suptitle(_title(run, views[0]), fontsize=8.5, x=0.01, ha="left")
    return figure
