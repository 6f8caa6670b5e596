"""The force differential, in our layouts and from the symmetric half, against cuSPARSE's block sparse product."""
import names
from content import Figure, Section
from drawing import INK, bars_height, grouped_bars, plot
from rows import by_machine, grouped, usual_size, where

KERNEL, LIBRARY = "add_force_differential", "cusparse_bsr_"  # and the order within blocks


def section(results):
    result = Section(
        "Force differential against cuSPARSE",
        [],
        (
            f"rows of kernel {KERNEL} with layout {LIBRARY}columns or {LIBRARY}rows beside ours "
            "(aos, soa, aosoa32, symmetric_fast, symmetric_deterministic)"
        ),
        "tools/dev run forces --json=forces.json",
    )
    for machine, of_machine in by_machine(where(results.rows, kernel=KERNEL, set="")):
        groups, sizes = [], set()
        for storage, rows in grouped(of_machine, "storage"):
            rows = [row for row in usual_size(rows) if row.layout != "copy"]
            rows = sorted(rows, key=lambda row: row.ms)
            library = [row for row in rows if row.layout.startswith(LIBRARY)]
            if library and len(rows) > len(library):
                groups.append((storage, rows, library[0]))
                result.used += rows
                sizes.add(rows[0].objects)
        if groups:
            result.blocks.append(_figure(machine, groups, sizes))
    return result


def _figure(machine, groups, sizes):
    bars = [
        (storage, [(row.ms, _label(row, library), names.layout_colour(row.layout)) for row in rows])
        for storage, rows, library in groups
    ]
    figure, axes = plot(bars_height(bars, bar=0.22))
    axes = axes[0, 0]
    grouped_bars(axes, bars)
    y = 0.0
    for _, rows, _ in groups:  # the copy's time as a tick across each bar
        for k, row in enumerate(rows):
            if row.copy_fraction:
                axes.plot([row.ms * row.copy_fraction] * 2, [y + k - 0.41, y + k + 0.41], color=INK, linewidth=1.4)
        y += len(rows) + 1.1
    axes.set_xlim(0, max(row.ms for _, rows, _ in groups for row in rows) * 1.5)
    axes.set_title(f"Force differential, {machine}")
    axes.set_xlabel("median time [ms]")
    return Figure(
        f"force-differential-{names.slug(machine)}",
        figure,
        (
            f"{machine}, "
            f"{' or '.join(f'{size:,}' for size in sorted(sizes))} nodes; the factor is cuSPARSE’s best time over "
            "the row’s. Black ticks: a copy of the bytes which that row must move."
        ),
    )


def _label(row, library):
    text = f"{names.significant(row.ms)} ms  {names.layout(row.layout)}"
    return text if row is library else f"{text}, {names.times(library.ms / row.ms)}"
