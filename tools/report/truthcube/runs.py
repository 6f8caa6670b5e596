"""Runs that truthcube_runs.py collected, in a list `runs` of a file, as lines of a table."""
from .records import AGAIN, RunError


def _runs(content, name):
    found = content.get("runs") if isinstance(content, dict) else None
    if not isinstance(found, list) or not found:
        raise RunError(f"{name}: no list of 'runs'; {AGAIN}")
    return found


def lines(content, name):
    """Header and rows of the table, a row for each run. @param name of the file. @throws RunError naming the place"""
    body = []
    for run in _runs(content, name):
        settings, steps = run["settings"], run["steps"]
        total = {key: sum(step[key] for step in steps) for key in ("newton_iterations", "pcg_iterations", "seconds")}
        warm = [step["warm_seconds"] for step in steps]  # null where nothing was solved again
        body.append(
            [
                f"{run['tets']:,}",
                f"{settings['poisson']:g}, {settings['volume']}",
                settings["stepping"] if settings["stepping"] == "nested" else f"{len(steps)} loads",
                settings["preconditioner"],
                f"{total['newton_iterations']}",
                f"{total['pcg_iterations']}",
                f"{steps[-1]['residual']:.1e}",
                f"{total['seconds'] * 1e3:.0f} ms",
                "–" if None in warm else f"{sum(warm) * 1e3:.0f} ms",
                f"{run['setup_seconds']:.1f} s",
                f"{run['bytes'] / run['nodes']:.0f}",
            ]
        )
    head = ["tets", "nu, volume by", "stepping", "preconditioner", "Newton steps", "PCG iterations", "residual"]
    head += ["solved first in", "again in", "set up in", "bytes per node"]
    return head, body
