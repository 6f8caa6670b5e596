"""Cost per object against the number of objects: launch overhead at one end, bandwidth at the other."""
import math

import names
from content import Figure, Section
from drawing import INK, MUTED, log_ticks, plot, spread
from rows import by_machine, grouped, where

SIZES = 5  # object counts that make a curve
COLUMNS = 2


def section(results):
    result = Section(
        "Cost per object against the number of objects",
        [],
        f"the same row at {SIZES} or more object counts, such as 1024, 2048, … 16777216",
        "tools/dev run growth --json=growth.json",
    )
    rows = where(results.rows, set="")
    for machine, of_machine in by_machine(rows):
        for storage, of_storage in grouped(of_machine, "storage"):
            kernels = []
            for kernel, of_kernel in grouped(of_storage, "kernel"):
                curves = [
                    (layout, sorted(same, key=lambda row: row.objects))
                    for layout, same in grouped(of_kernel, "layout")
                    if len({row.objects for row in same}) >= SIZES
                ]
                if curves:
                    kernels.append((kernel, sorted(curves, key=lambda curve: names.layout_order(curve[0]))))
            if kernels:
                result.blocks.append(_figure(machine, storage, kernels))
                result.used += [row for _, curves in kernels for _, curve in curves for row in curve]
    return result


def _figure(machine, storage, kernels):
    lines = math.ceil(len(kernels) / COLUMNS)
    figure, grid = plot(0.5 + 2.9 * lines, min(COLUMNS, len(kernels)), lines)
    figure.suptitle(f"{machine}, {storage}", x=0, ha="left", fontsize=9)
    for axes, entry in zip(grid.flat, kernels):
        _panel(axes, *entry)
    for axes in list(grid.flat)[len(kernels) :]:
        axes.set_visible(False)
    for axes in grid[:, 0]:
        axes.set_ylabel("time per object [ns]")
    return Figure(
        f"growth-{names.slug(machine)}-{names.slug(storage)}",
        figure,
        (
            f"{machine}, {storage}: median time over "
            "objects, both scales logarithmic. Dashed: a constant time, that of the shortest run, which is what a "
            "launch costs however few the objects; where a curve leaves it, the work begins to count."
        ),
    )


def _panel(axes, kernel, curves):
    rows = [row for _, curve in curves for row in curve]
    first, last = min(row.objects for row in rows), max(row.objects for row in rows)
    floor = min(row.ms for row in rows)
    low, high = (pick(row.ns_per_object for row in rows) for pick in (min, max))
    axes.set(xscale="log", yscale="log", xlim=(first, last), ylim=(low / 2.2, high * 1.6))
    axes.plot([first, last], [floor * 1e6 / first, floor * 1e6 / last], "--", color=MUTED, linewidth=1)
    for layout, curve in curves:
        axes.plot(
            [row.objects for row in curve],
            [row.ns_per_object for row in curve],
            "-o",
            linewidth=1.4,
            markersize=2.6,
            color=names.layout_colour(layout),
            clip_on=False,
        )
    axes.set_title(names.kernel(kernel))
    axes.set_xlabel("objects")
    powers = range(math.ceil(math.log2(first)), int(math.log2(last)) + 1)
    powers = [power for power in powers if power % 2 == 0] if len(powers) > 8 else powers
    log_ticks(axes.xaxis, 1, 0, str)
    axes.set_xticks([2**power for power in powers], [f"$2^{{{power}}}$" for power in powers])
    log_ticks(axes.yaxis, low / 2.2, high * 1.6, lambda tick: f"{tick:g}", steps=(1,))
    axes.grid(axis="y")
    _label(axes, curves, floor, first, last)


def _label(axes, curves, floor, first, last):
    """Names at the ends of the curves; the constant time beside its dashed line."""
    axes.figure.draw_without_rendering()
    to_axes = axes.transAxes.inverted().transform
    ends = [to_axes(axes.transData.transform((curve[-1].objects, curve[-1].ns_per_object)))[1] for _, curve in curves]
    for (layout, _), place in zip(curves, spread(ends, 0.065)):
        axes.text(1.025, place, names.layout(layout), transform=axes.transAxes, va="center", fontsize=8, color=INK)
    x = first * (last / first) ** 0.25
    axes.annotate(
        f"{names.significant(floor * 1e3, 2)} µs",
        (x, floor * 1e6 / x),
        xytext=(-8, -3),
        textcoords="offset points",
        ha="right",
        va="top",
        fontsize=8,
        color=MUTED,
    )
