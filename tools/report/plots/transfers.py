"""Transfers between host and device with a change of layout, as a fraction of the plain transfer's rate."""
import names
from content import Figure, Section
from rows import by_machine, grouped, usual_size

from .heat import heat_table

PREFIX = "transfer_"
KINDS = ["pinned", "pageable", "scattered"]


def section(results):
    result = Section(
        "Transfers between host and device",
        [],
        "rows of kernel transfer_pinned_36, transfer_pageable_36, transfer_scattered_36, …, layouts such as aos_to_aosoa32",
        "tools/dev run conversions --json=conversions.json",
    )
    rows = [row for row in results.rows if row.kernel.startswith(PREFIX) and row.layout != "copy" and row.copy_fraction]
    for machine, of_machine in by_machine(rows):
        for storage, same in grouped(of_machine, "storage"):
            result.blocks.append(_figure(machine, storage, same))
            result.used += same
    return result


def _figure(machine, storage, rows):
    rows = [row for _, same in grouped(rows, "kernel") for row in usual_size(same)]
    kinds = sorted(
        {row.kernel[len(PREFIX) :] for row in rows},
        key=lambda kind: (KINDS.index(kind) if kind in KINDS else len(KINDS), kind),
    )
    pairs = sorted(
        {row.layout for row in rows}, key=lambda pair: [names.layout_order(side) for side in pair.split("_to_")]
    )
    cells = {
        (names.layout(row.layout), names.kernel(row.kernel[len(PREFIX) :])): (
            row.copy_fraction,
            f"{row.counter('GBps') or 0:,.1f} GB/s",
        )
        for row in rows
    }
    sizes = sorted({row.objects for row in rows})
    figure = heat_table(
        f"{machine}, {storage}",
        [names.layout(pair) for pair in pairs],
        [names.kernel(kind) for kind in kinds],
        cells,
        "layouts, from → to",
        "host memory",
    )
    return Figure(
        f"transfers-{names.slug(storage)}-{names.slug(machine)}",
        figure,
        (
            f"{machine}, {storage}, {' or '.join(f'{size:,}' for size in sizes)} objects: rate over that of a plain "
            "copy of the same bytes in the same run (1 = the change of layout costs nothing), and bytes per second."
        ),
    )
