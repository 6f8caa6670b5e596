"""Node data that elements gather by index: which layout of the nodes, under three numberings of the mesh."""
import names
from content import Figure, Section, Table
from drawing import bars_height, grouped_bars, plot
from rows import by_machine, grouped, usual_size, where

KERNEL = "gather_nodes"
SETS = {"ordered": "ordered mesh", "random": "random numbering", "renumbered": "renumbered"}


def section(results):
    result = Section(
        "Gathered against streamed",
        [],
        f"rows of kernel {KERNEL}, layouts aos, aos_padded, soa, aosoa32, sets ordered, random, renumbered",
        "tools/dev run gathers --json=gathers.json",
    )
    for machine, of_machine in by_machine(where(results.rows, kernel=KERNEL)):
        for storage, rows in grouped(of_machine, "storage"):
            rows = [row for row in usual_size(rows) if row.layout != "copy"]
            if rows:
                result.blocks += _blocks(machine, storage, rows)
                result.used += rows
    return result


def _blocks(machine, storage, rows):
    order = list(SETS)
    rows = sorted(
        rows,
        key=lambda row: (
            order.index(row.set) if row.set in SETS else len(order),
            row.set,
            names.layout_order(row.layout),
        ),
    )
    groups = [
        (
            SETS.get(name, name or "no set"),
            [
                (row.ms, f"{names.significant(row.ms)} ms  {names.layout(row.layout)}", names.layout_colour(row.layout))
                for row in same
            ],
        )
        for name, same in grouped(rows, "set")
    ]
    figure, axes = plot(bars_height(groups, bar=0.2))
    axes = axes[0, 0]
    grouped_bars(axes, groups)
    axes.set_xlim(0, max(row.ms for row in rows) * 1.3)
    axes.set_title(f"Nodes gathered by index, {machine}, {storage}")
    axes.set_xlabel("median time [ms]")
    table = [
        [
            SETS.get(row.set, row.set),
            names.layout(row.layout),
            names.significant(row.ms),
            names.significant(row.ns_per_object),
            *(
                f"{value:.2f}" if value is not None else "–"
                for value in (row.copy_fraction, row.counter("sectors_per_request"))
            ),
        ]
        for row in rows
    ]
    where_from = f"{machine}, {storage}, {rows[0].objects:,} elements"
    return [
        Figure(
            f"gathered-{names.slug(machine)}-{names.slug(storage)}",
            figure,
            f"{where_from}: each gathers its nodes by index, by layout of the nodes and numbering of the mesh.",
        ),
        Table(
            ["numbering", "node layout", "median [ms]", "[ns / element]", "/copy", "sectors / request"],
            table,
            f"{where_from}: all rows",
            folded=True,
        ),
    ]
