"""Speed against error: what each storage format costs in error and gains in time, per kernel and machine."""
import html

import matplotlib.ticker

import names
from content import Figure, Section, Table, Text
from drawing import INK, MUTED, RULE, log_ticks, margin_labels, plot
from rows import aos, by_machine, grouped, usual_size, where

DOMINATED = "#a9adb4"
OFF_SCALE = 1e-10  # errors below it stand at the left edge: double, which would squeeze the rest


def section(results):
    result = Section(
        "Speed against error",
        [],
        (
            "rows of one kernel in a storage format other than float and double "
            "(half, quaternion, quaternion16_half, …), with its aos/float row"
        ),
        "tools/dev run storage --json=storage.json",
    )
    for machine, kernels in by_machine(where(results.rows, set="")):
        for kernel, rows in grouped(kernels, "kernel"):
            rows = [row for row in usual_size(rows) if row.layout not in names.LIBRARIES]
            origin = aos(rows)
            points = [row for row in rows if row.error("p99") is not None and row.layout != "copy"]
            if origin and {row.storage for row in points} - {"float", "double"}:
                result.blocks += _blocks(machine, kernel, origin, points)
                result.used += [origin, *points]
    if result.blocks:
        result.blocks.insert(
            0,
            Text(
                "A format is worth having when it is on the <i>frontier</i>: nothing else is as fast "
                "with as small an error. The origin of the speed-up, 1×, is an array of structs "
                "of float."
            ),
        )
    return result


def frontier(points):
    """The rows that no other row beats: in order of growing error, each faster than all before."""
    best, found = float("inf"), []
    for row in sorted(points, key=lambda row: (row.error("p99"), row.ms, row.name)):
        if row.ms < best:
            best = row.ms
            found.append(row)
    return found


def _label(row):
    return f"{row.storage} · {names.layout(row.layout)}"


def _blocks(machine, kernel, origin, points):
    best = frontier(points)
    title = f"{names.kernel(kernel)} on {machine}"
    table = [
        [
            _label(row),
            names.significant(row.counter("bytes_per_object") or 0),
            names.significant(row.ms),
            names.times(origin.ms / row.ms),
            f"{row.copy_fraction:.2f}" if row.copy_fraction else "–",
            *(
                names.significant(row.error(which), 2) if row.error(which) is not None else "–"
                for which in ("p50", "p99", "max")
            ),
            "yes" if row in best else "",
        ]
        for row in sorted(points, key=lambda row: row.ms)
    ]
    return [
        Figure(
            f"pareto-{names.slug(kernel)}-{names.slug(machine)}",
            _draw(origin, points, best, title),
            (
                f"{title}, {origin.objects:,} objects. Dots: 99th percentile of the relative error, and speed-up over "
                f"AoS float ({names.significant(origin.ms)} ms). Thin lines end at the largest error. Blue: the "
                "frontier, with bytes per object; grey: beaten in both by another."
            ),
        ),
        Text(_losers(machine, origin, points)),
        Table(
            [
                "storage · layout",
                "bytes / object",
                "median [ms]",
                "over AoS float",
                "/copy",
                "error p50",
                "error p99",
                "error max",
                "frontier",
            ],
            table,
            f"{title}: all {len(points)} rows",
            folded=True,
        ),
    ]


def _losers(machine, origin, points):
    """Which formats are no faster than plain float here, each in its best layout."""
    fastest = {storage: min(rows, key=lambda row: row.ms) for storage, rows in grouped(points, "storage")}
    plain = fastest.get("float", origin)
    lose = sorted((row for name, row in fastest.items() if name != "float" and row.ms >= plain.ms), key=lambda r: r.ms)
    if not lose:
        return f"On {html.escape(machine)} every format is faster than plain float, each in its best layout."
    listed = ", ".join(f"<code>{html.escape(row.storage)}</code> ({names.times(plain.ms / row.ms)})" for row in lose)
    return (
        f"Formats that lose on {html.escape(machine)}: no faster than plain float "
        f"({names.significant(plain.ms)} ms in {names.layout(plain.layout)}), each in its best layout (factors are over that float): {listed}."
    )


def _draw(origin, points, best, title):
    on_scale = [row for row in points if row.error("p99") >= OFF_SCALE] or points
    left = max(min(row.error("p99") for row in on_scale), 1e-18) / 3
    right = max(max(row.error("p99"), (row.error("max") or 0) if row in best else 0) for row in on_scale)
    right = max(right * 2, left * 100)

    def place(row):
        return max(row.error("p99"), left), origin.ms / row.ms

    figure, grid = plot(3.9)
    axes = grid[0, 0]
    axes.set_xscale("log")
    axes.set_xlim(left, right)
    axes.set_ylim(0, max(place(row)[1] for row in points) * 1.12)
    for row in points:
        if row not in best:
            axes.plot(
                *place(row),
                "<" if row.error("p99") < left else "o",
                color=DOMINATED,
                markersize=4.5,
                markeredgewidth=0,
                clip_on=False,
                zorder=2.6,
            )
    steps = [place(row) for row in best]
    axes.step(
        [x for x, _ in steps] + [right],
        [y for _, y in steps] + [steps[-1][1]],
        where="post",
        linewidth=1.3,
        color=names.ACCENT,
        alpha=0.45,
        zorder=3,
    )
    for row in best:
        x, y = place(row)
        off = row.error("p99") < left
        if row.error("max") and not off:
            axes.plot(
                [x, row.error("max")],
                [y, y],
                "|-",
                markevery=[1],
                markersize=6,
                color=names.ACCENT,
                linewidth=1,
                zorder=3,
            )
        axes.plot(
            x, y, "<" if off else "o", color=names.ACCENT, markersize=6.5, markeredgewidth=0, clip_on=False, zorder=4
        )
        if off:
            axes.annotate(
                f"{_label(row)}  {names.times(y)}, error {names.significant(row.error('p99'), 2)}",
                (x, y),
                xytext=(8, -10),
                textcoords="offset points",
                fontsize=8,
                va="center",
            )
    _mark_origin(axes, origin, place)
    log_ticks(axes.xaxis, left, right, lambda tick: f"$10^{{{round(matplotlib.numpy.log10(tick))}}}$", steps=(1,))
    axes.yaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g×"))
    axes.set_xlabel("relative error, 99th percentile (log scale)")
    axes.set_ylabel("speed-up over AoS float")
    axes.set_title(title)
    margin_labels(
        axes,
        [
            (*place(row), f"{_label(row)}  {names.times(place(row)[1])}" + _bytes(row), RULE)
            for row in best
            if row.error("p99") >= left
        ]
        + [(right, 1, "AoS float = 1×, the origin", MUTED)],
    )
    return figure


def _bytes(row):
    return f", {row.counter('bytes_per_object'):.0f} B" if row.counter("bytes_per_object") else ""


def _mark_origin(axes, origin, place):
    axes.axhline(1, color=MUTED, linewidth=0.9, zorder=1.5)
    if origin.error("p99") is not None:
        axes.plot(
            *place(origin), "o", markersize=8, markerfacecolor="none", markeredgecolor=INK, markeredgewidth=1, zorder=5
        )
