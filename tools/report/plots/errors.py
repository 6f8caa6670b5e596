"""Error against speed of the SVD and its variants, the stress derivatives and dP from dF over sets of hard inputs."""
import names
from content import Figure, Section, Table, Text
from drawing import key, log_ticks, plot
from rows import EPS, by_machine, grouped, where

SETS = ["random", "near_rest", "hard"]
CAP = 1e5  # beyond, an error is drawn at the right edge [eps]


def section(results):
    result = Section(
        "Error against speed on hard inputs",
        [],
        "rows of the sets random, near_rest and hard, with errors in eps",
        "tools/dev run errors --json=errors.json",
    )
    rows = [row for row in where(results.rows, storage=EPS) if row.set and row.counter("err_eps_max") is not None]
    for machine, of_machine in by_machine(rows):
        for storage, same in grouped(of_machine, "storage"):
            result.blocks += _blocks(machine, storage, same)
            result.used += same
    if result.blocks:
        result.blocks.insert(
            0,
            Text(
                "Sets of deformation gradients: ordinary ones (<code>random</code>), near rest"
                " (<code>near_rest</code>), and more than a hundred families of hard ones (<code>hard</code>: rank"
                " deficient, inverted, gaps of ulps, extreme norms). A failure is a result that is not finite or off by"
                " 1 % or more; 1 eps is 2<sup>−23</sup> in float, 2<sup>−52</sup> in double."
            ),
        )
    return result


def _blocks(machine, storage, rows):
    variants = [(kernel, layout, same) for (kernel, layout), same in grouped(rows, "kernel", "layout")]
    ours = [kernel for kernel, layout, _ in variants if layout not in names.LIBRARIES]
    labelled = [
        (
            names.kernel(kernel)
            + (f", {names.layout(layout)}" if layout in names.LIBRARIES or ours.count(kernel) > 1 else ""),
            same,
        )
        for kernel, layout, same in variants
    ]
    what = f"{machine}, {storage}, {' or '.join(f'{size:,}' for size in sorted({row.objects for row in rows}))} objects"
    return [
        Figure(
            f"errors-{names.slug(machine)}-{storage}",
            _draw(labelled, f"{machine}, {storage}"),
            (
                f"{what}. Left: median time. Right: lines from the median error to the largest one, a tick at the 99th"
                " percentile, one line per set; an arrow points beyond the scale."
            ),
        ),
        Table(
            [
                "variant",
                "time [ms]",
                "[ns / object]",
                "/copy",
                *(f"max error, {name} [eps]" for name in SETS),
                "p99 error [eps]",
                "U, V orthogonal to [eps]",
                "failures",
            ],
            [_line(label, same) for label, same in labelled],
            f"{what}. Times are of the first set; p99 and orthogonality are the worst of all sets, failures their sum.",
        ),
    ]


def _line(label, rows):
    first = rows[0]

    def worst(which, chosen):
        values = [row.counter(which) for row in chosen if row.counter(which) is not None]
        return names.significant(max(values), 2) if values else "–"

    failures = sum(row.counter("failures") or 0 for row in rows)
    return [
        label,
        names.significant(first.ms),
        names.significant(first.ns_per_object),
        "–" if not first.copy_fraction else f"{first.copy_fraction:.2f}" if first.copy_fraction >= 0.005 else "<0.01",
        *(worst("err_eps_max", where(rows, set=name)) for name in SETS),
        worst("err_eps_p99", rows),
        worst("orth_eps_max", rows),
        f"{failures:,.0f}",
    ]


def _draw(labelled, title):
    figure, grid = plot(1.0 + 0.31 * len(labelled), 2, gridspec_kw={"width_ratios": [1, 1.5]}, sharey=True)
    speed, error = grid[0]
    times = [same[0].ns_per_object for _, same in labelled]
    errors = [row.counter(which) for _, same in labelled for row in same for which in ("err_eps_p50", "err_eps_max")]
    low, high = max(min(errors), 1e-2) * 0.8, min(max(errors), CAP) * 1.5
    speed.set(xscale="log", xlim=(min(times) / 1.6, max(times) * 6))
    error.set(xscale="log", xlim=(low, high))
    for y, (label, same) in enumerate(labelled):
        speed.plot(times[y], y, "o", color=names.ACCENT, markersize=5)
        speed.annotate(
            names.significant(times[y]),
            (times[y], y),
            xytext=(6, 0),
            textcoords="offset points",
            va="center",
            fontsize=8,
        )
        for row in same:
            _range(error, row, y + 0.22 * (_place(row.set) - 1), low, high)
        failures = sum(row.counter("failures") or 0 for row in same)
        if failures:
            error.annotate(
                f"{failures:.0f} failure{'s' * (failures != 1)}",
                (1, y),
                xycoords=("axes fraction", "data"),
                xytext=(6, 0),
                textcoords="offset points",
                va="center",
                fontsize=8,
            )
    speed.set_yticks(range(len(labelled)), [label for label, _ in labelled])
    speed.set_ylim(len(labelled) - 0.5, -0.5)
    speed.set_title(title)
    speed.set_xlabel("time per object [ns], log scale")
    error.set_xlabel("error [eps], log scale")
    log_ticks(
        speed.xaxis,
        *speed.get_xlim(),
        lambda tick: f"{tick:g}",
        steps=(1,) if max(times) > 50 * min(times) else (1, 2, 5),
    )
    log_ticks(error.xaxis, low, high, lambda tick: f"{tick:g}", steps=(1,) if high > 1e4 * low else (1, 2, 5))
    for axes in (speed, error):
        axes.tick_params(axis="y", length=0)
        axes.spines["left"].set_visible(False)
        axes.grid(axis="both", alpha=0.8)
    key(error, [(name, names.SERIES[_place(name)]) for name in SETS])
    return figure


def _place(name):
    return SETS.index(name) if name in SETS else len(SETS)


def _range(axes, row, y, low, high):
    colour = names.SERIES[_place(row.set)]
    p50, p99, largest = (min(max(row.counter("err_eps_" + which) or low, low), high) for which in ("p50", "p99", "max"))
    axes.plot([p50, largest], [y, y], color=colour, linewidth=1.6, solid_capstyle="butt")
    if p99 < high:
        axes.plot([p99], [y], "|", color=colour, markersize=4.5, markeredgewidth=1.2)
    axes.plot(
        [largest],
        [y],
        ">" if (row.counter("err_eps_max") or 0) > high else "o",
        color=colour,
        markersize=3.2,
        clip_on=False,
    )
