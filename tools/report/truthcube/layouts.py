"""The worth of the schemas' layouts: the same programs built with all arrays in one layout, beside them. Its file is
what layout_runs.py writes: a list `bodies`, of each the two builds {layout, whole: a run of truthcube, linear: rows of
linear_solves}."""
from . import records
from .records import RunError

AGAIN = "measure again with tools/report/layout_runs.py"
SCHEMA = "schema"


def lines(content, name):
    """Header and rows of the table, a row for each body: times in the schemas' layouts and in the other one, and the
    second over the first. @param name of the file. @throws RunError naming the place"""
    bodies = content.get("bodies") if isinstance(content, dict) else None
    if not isinstance(bodies, list) or not bodies:
        raise RunError(f"{name}: no list of 'bodies'; {AGAIN}")
    table, others = [], set()
    for number, builds in enumerate(bodies):
        place = f"{name}: bodies[{number}]"
        if not isinstance(builds, list) or len(builds) != 2:
            raise RunError(f"{place} is not a pair of builds; {AGAIN}")
        for k, build in enumerate(builds):
            records.require(build, {"layout": str, "whole": dict, "linear": list}, f"{place}[{k}]", AGAIN)
            records.check_record(build["whole"], f"{place}[{k}].whole", with_newton=False)
        ours, other = builds
        if ours["layout"] != SCHEMA or other["layout"] == SCHEMA:
            raise RunError(f"{place} has the layouts {ours['layout']} and {other['layout']}, not schema and another; {AGAIN}")
        others.add(other["layout"])
        run, settings = ours["whole"], ours["whole"]["settings"]
        cells = [f"{run['tets']:,}", f"{settings['poisson']:g}, {settings['volume']}"]
        cells.append(_cell(*(_whole(build["whole"], place) for build in builds)))
        for method in ("multigrid", "block-jacobi"):
            cells.append(_cell(*(_linear(build["linear"], method, place) for build in builds)))
        table.append([*cells, run["device"]])
    if len(others) > 1:
        raise RunError(f"{name}: the layouts {' and '.join(sorted(others))} are not in one table; {AGAIN}")
    ratio = f"schema, {others.pop()} [ms], ratio"
    head = [f"{what}: {ratio}" for what in ("whole solve", "one linear solve, multigrid", "and block Jacobi")]
    return ["tets", "nu, volume by", *head, "device"], table


def _whole(record, place):
    """[s]"""
    for step in record["steps"]:
        records.require(step, {"warm_seconds": float}, place, AGAIN)
    times = [step["warm_seconds"] for step in record["steps"]]
    if not times or None in times:
        raise RunError(f"{place}: a run without repeated solves; {AGAIN}")
    return sum(times)


def _linear(rows, method, place):
    """[s]"""
    found = [row for row in rows if isinstance(row, dict) and row.get("method") == method]
    if len(found) != 1:
        raise RunError(f"{place}: {len(found)} linear solves by {method}; {AGAIN}")
    records.require(found[0], {"solve_seconds": float}, place, AGAIN)
    return found[0]["solve_seconds"]


def _cell(ours, other):
    return f"{1e3 * ours:.3g}, {1e3 * other:.3g}, {other / ours:.2f}"
