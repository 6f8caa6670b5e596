"""All layouts of every kernel: time over the time of a copy of the same bytes."""
import names
from content import Figure, Section, Table
from drawing import MUTED, bars_height, grouped_bars, log_ticks, plot
from rows import aos, by_machine, grouped, usual_size, where

OTHER_SECTIONS = ("convert_", "transfer_", "gather_nodes")


def section(results):
    result = Section(
        "Layouts of every kernel",
        [],
        "rows of any kernel in several layouts, float or double",
        "tools/dev run --json=kernels.json",
    )
    rows = [
        row
        for row in where(results.rows, set="", storage={"float", "double"})
        if row.layout != "copy" and row.copy_fraction and not row.kernel.startswith(OTHER_SECTIONS)
    ]
    for machine, of_machine in by_machine(rows):
        for storage, of_storage in grouped(of_machine, "storage"):
            kernels = [
                (kernel, sorted(usual_size(same), key=lambda row: names.layout_order(row.layout)))
                for kernel, same in grouped(of_storage, "kernel")
            ]
            kernels = [(kernel, same) for kernel, same in kernels if len(same) > 1]
            if kernels:
                result.blocks += [_figure(machine, storage, kernels), _table(machine, storage, kernels)]
                result.used += [row for _, same in kernels for row in same]
    return result


def _figure(machine, storage, kernels):
    groups = [
        (
            names.kernel(kernel),
            [
                (
                    1 / row.copy_fraction,
                    f"{names.times(1 / row.copy_fraction)}  {names.layout(row.layout)}",
                    names.layout_colour(row.layout),
                )
                for row in rows
            ],
        )
        for kernel, rows in kernels
    ]
    values = [bar[0] for _, bars in groups for bar in bars]
    figure, axes = plot(bars_height(groups))
    axes = axes[0, 0]
    grouped_bars(axes, groups, start=1.0)
    axes.set_xscale("log")
    axes.set_xlim(min(0.9, min(values) * 0.95), max(values) ** 1.25 * 1.3)
    log_ticks(axes.xaxis, min(1, min(values)), max(values) * 1.3, lambda tick: f"{tick:g}×")
    axes.set_title(f"{machine}, {storage}")
    axes.axvline(1, color=MUTED, linewidth=1)
    axes.set_xlabel("time / time of a copy of the same bytes (1× = as fast as the copy; log scale)")
    return Figure(
        f"layouts-{names.slug(machine)}-{storage}",
        figure,
        (
            f"{machine}, {storage}. Bars start at the time of a "
            "copy: no bar is the best that memory allows; a bar to the left is faster than the copy. Counted are the "
            "bytes that must move in any layout."
        ),
    )


def _table(machine, storage, kernels):
    rows = []
    for kernel, same in kernels:
        origin = aos(same, storage)
        for row in same:
            rows.append(
                [
                    names.kernel(kernel),
                    names.layout(row.layout),
                    f"{row.objects:,}",
                    names.significant(row.counter("bytes_per_object") or 0),
                    names.significant(row.ms),
                    names.significant(row.counter("GBps") or 0),
                    f"{row.copy_fraction:.2f}",
                    names.times(origin.ms / row.ms) if origin else "–",
                    names.significant(row.error("max"), 2) if row.error("max") is not None else "–",
                ]
            )
    return Table(
        [
            "kernel",
            "layout",
            "objects",
            "bytes / object",
            "median [ms]",
            "rate [GB/s]",
            "/copy",
            "over AoS",
            "largest rel. error",
        ],
        rows,
        f"{machine}, {storage}: all {len(rows)} rows",
        folded=True,
    )
