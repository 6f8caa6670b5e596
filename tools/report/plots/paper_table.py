"""Table 1 of the paper, redone: arrays of structs against the best layout, then and now."""
import names
from content import Figure, Section, Table, Text
from drawing import bars_height, grouped_bars, plot
from rows import aos, by_machine, usual_size, where

# Mistry et al., VECPAR 2010, table 1, GTX 285: AoS [ms], best [ms], requests per transaction over AoS and best.
PAPER = {
    "dp_from_df": (20.240, 2.430, 0.031, 0.167),
    "stress_derivative": (10.480, 1.560, 0.026, 0.222),
    "add_force_differential": (5.900, 1.150, 0.013, 0.066),
}
COUNTERS = {
    "requests_per_transaction": "requests / transaction",
    "sectors_per_request": "sectors / request",
    "bytes_per_sector": "bytes used / 32 B sector",
}
NOT_A_LAYOUT = {"copy", "record", "aos_scalar"} | names.LIBRARIES


def section(results):
    compared = [
        _compare(results.rows, machine, kernel)
        for machine, _ in by_machine(where(results.rows, space="cuda"))
        for kernel in PAPER
    ]
    compared = [entry for entry in compared if entry]
    result = Section(
        "The paper’s table 1, redone",
        [],
        "rows of dp_from_df, stress_derivative and add_force_differential in float on a GPU, layout aos and another",
        "tools/dev run --json=kernels.json",
    )
    result.used = [row for entry in compared for row in entry[2:] if row]
    if compared:
        result.blocks = [
            Text(
                "Mistry, Kaeli et al., <i>Data Structures and Transformations for Physically Based "
                "Simulation on a GPU</i> (VECPAR 2010), measured on a GTX 285. Object counts and hardware "
                "differ, so compare speed-ups, not times. “Best” is the fastest of our layouts; "
                "where AoS itself is the fastest, the speed-up is 1."
            ),
            _figure(compared),
            _times(compared),
            _coalescing(results.rows, compared),
        ]
    return result


def _compare(rows, machine, kernel):
    """(machine, kernel, AoS row, best row, row over whole records or None), or None where something is missing."""
    rows = usual_size(where(rows, machine=machine, kernel=kernel, storage="float", set=""))
    origin = aos(rows)
    others = [row for row in rows if row.layout not in NOT_A_LAYOUT]
    if not origin or len(others) < 2:
        return None
    record = where(rows, layout="record")
    return machine, kernel, origin, min(others, key=lambda row: row.ms), record[0] if record else None


def _figure(compared):
    groups = []
    for kernel, (before, after, *_) in PAPER.items():
        bars = [(before / after, f"{names.times(before / after)}  GTX 285, 2010", "#a9adb4")]
        for machine, _, origin, best, record in (entry for entry in compared if entry[1] == kernel):
            note = f"{machine}, {names.layout(best.layout)}"
            bars.append((origin.ms / best.ms, f"{names.times(origin.ms / best.ms)}  {note}", names.ACCENT))
            if record:
                bars.append(
                    (
                        record.ms / best.ms,
                        f"{names.times(record.ms / best.ms)}  {note}, over whole element records",
                        names.layout_colour("record"),
                    )
                )
        groups.append((names.kernel(kernel), bars))
    figure, axes = plot(bars_height(groups, bar=0.22))
    axes = axes[0, 0]
    grouped_bars(axes, groups)
    axes.set_xlim(0, max(bar[0] for _, bars in groups for bar in bars) * 1.5)
    axes.set_title("Speed-up over arrays of structs, float")
    axes.set_xlabel("time over AoS / time in the best layout")
    return Figure(
        "paper-table",
        figure,
        (
            "Grey: the paper; colours: these results, median times. The third bar of a "
            "kernel, where there is one, starts from an array of whole 48-scalar element records instead."
        ),
    )


def _times(compared):
    rows = []
    for machine, kernel, origin, best, record in compared:
        before, after, *_ = PAPER[kernel]
        rows.append(
            [
                names.kernel(kernel),
                f"{before:.3f}",
                f"{after:.3f}",
                names.times(before / after),
                machine,
                f"{best.objects:,}",
                names.significant(record.ms) if record else "–",
                names.significant(origin.ms),
                names.significant(best.ms),
                names.layout(best.layout),
                names.times(origin.ms / best.ms),
                f"{best.copy_fraction:.2f}" if best.copy_fraction else "–",
            ]
        )
    return Table(
        [
            "kernel",
            "2010: AoS [ms]",
            "2010: best [ms]",
            "2010: speed-up",
            "now on",
            "objects",
            "whole records [ms]",
            "AoS [ms]",
            "best [ms]",
            "best layout",
            "speed-up",
            "/copy",
        ],
        rows,
        "Median times. “/copy” is the best layout’s rate over that of a device copy of the same bytes.",
    )


def _coalescing(results, compared):
    def counter(row, name):
        """The coalescing of the row or, as it does not depend on the object count, of the same row at another count."""
        same = where(results, machine=row.machine, kernel=row.kernel, layout=row.layout, storage=row.storage, set="")
        return next((other.counter(name) for other in [row, *same] if other.counter(name) is not None), None)

    counters = {
        name: title
        for name, title in COUNTERS.items()
        if any(counter(row, name) is not None for entry in compared for row in entry[2:4])
    }

    def cells(row):
        found = [counter(row, name) for name in counters]
        return [names.significant(value) if value is not None else "–" for value in found]

    def change(first, then):
        return f"{first} → {then}" if (first, then) != ("–", "–") else "–"

    rows = []
    for machine, kernel, origin, best, _ in compared:
        _, _, before, after = PAPER[kernel]
        rows.append(
            [names.kernel(kernel), f"{before:.3f} → {after:.3f}", machine]
            + [change(first, then) for first, then in zip(cells(origin), cells(best))]
        )
    caption = "Memory coalescing, AoS → best layout. The paper’s column is requests over transactions: more is better."
    if not counters:
        caption += (
            " These results hold no counters of our own: rows with sectors_per_request, bytes_per_sector or "
            "requests_per_transaction would add columns."
        )
    return Table(["kernel", "2010: requests / transaction", "now on", *counters.values()], rows, caption)
