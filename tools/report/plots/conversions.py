"""Conversions between layouts: from one layout to another, as a fraction of the copy's rate."""
import re

import names
from content import Figure, Section
from rows import by_machine, grouped, usual_size, where

from .heat import heat_table


def section(results):
    result = Section(
        "Conversions between layouts",
        [],
        "rows of kernel convert_36, convert_48, …, layouts such as aos_to_aosoa32",
        "tools/dev run conversions --json=conversions.json",
    )
    rows = [
        row for row in results.rows if row.kernel.startswith("convert_") and "_to_" in row.layout and row.copy_fraction
    ]
    for machine, of_machine in by_machine(rows):
        for (kernel, storage), same in grouped(of_machine, "kernel", "storage"):
            result.blocks.append(_figure(machine, kernel, storage, usual_size(same)))
            result.used += usual_size(same)
    return result


def _figure(machine, kernel, storage, rows):
    cells = {}
    for row in rows:
        source, target = row.layout.split("_to_", 1)
        cells[source, target] = (row.copy_fraction, f"{row.counter('GBps') or 0:,.0f} GB/s")
    sources, targets = ({pair[k] for pair in cells} for k in (0, 1))
    sources, targets = (sorted(found, key=names.layout_order) for found in (sources, targets))
    named = {(names.layout(source), names.layout(target)): cell for (source, target), cell in cells.items()}
    size = re.search(r"\d+$", kernel)
    what = f"{size[0]}-byte objects" if size else names.kernel(kernel)
    title = f"{what}{'' if storage == 'float' else ', ' + storage}, {machine}"
    figure = heat_table(
        title, [names.layout(name) for name in sources], [names.layout(name) for name in targets], named, "from", "to"
    )
    return Figure(
        f"{names.slug(kernel)}-{names.slug(storage)}-{names.slug(machine)}",
        figure,
        (
            f"{title}, {rows[0].objects:,} objects: rate over that of a plain copy of the same bytes (1 = as fast as "
            "the copy), and bytes read and written per second."
        ),
    )
