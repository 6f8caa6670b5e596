"""The ratio table: times of one linear solve of the Truth Cube by several methods, to equal residuals. Its file holds a
list `rows` of objects {cells, poisson, volume, method, setup_seconds, solve_seconds, iterations, residual, device}; they
may also have compression, norm, tolerance, precision and status. rows_of() makes them of what physbench linear_solves
writes."""
from . import records
from .records import RunError

METHODS = {
    "multigrid": "multigrid",
    "schwarz": "Schwarz",
    "block-jacobi": "block Jacobi",
    "none": "no preconditioner",
    "vendor": "vendor's library",
}
AGAIN = "measure again with tools/report/linear_solves_runs.py"
CONVERGED = "converged"
EQUAL = 10  # residuals of one tolerance differ by less than this factor: a method ends at an iteration, not between
_KINDS = {"cells": int, "poisson": float, "volume": str, "method": str, "setup_seconds": float, "solve_seconds": float,
          "iterations": int, "residual": float, "device": str}  # fmt: skip
_BODY = ("device", "cells", "poisson", "volume", "compression", "norm", "tolerance")
_SECONDS = {"solve_ms": "median_ms", "assembly_ms": "assembly_ms", "setup_ms": "setup_ms", "product_ms": "product_ms",
            "product_copy_ms": "product_copy_ms"}  # fmt: skip
_OF_RUN = ("compression", "tolerance")  # the same for all rows of a file, and missing where a solve has failed
_NUMBERS = ("product_bytes", "iteration_bytes")


def rows_of(results, name):
    """The rows of a JSON file of physbench linear_solves. A time that was not measured is None; so are all of a solve
    that has failed, whose status says why. @throws RunError naming what is missing"""
    context = results.get("context", {}) if isinstance(results, dict) else {}
    measured = results.get("benchmarks", []) if isinstance(results, dict) else []
    of_run = {key: result[key] for key in _OF_RUN for result in measured if key in result}
    found = []
    for result in measured:
        words = result["name"].split("/")
        if len(words) != 6 or words[0] != "linear_solve":
            raise RunError(f"{name}: {result['name']} is no row of linear_solves; {AGAIN}")
        volume, poisson, norm = words[5].split("_")
        row = {"tets": int(words[4]), "poisson": float(poisson), "volume": volume, "method": words[1],
               "precision": words[2], "norm": norm, "status": result.get("error_message", CONVERGED)}  # fmt: skip
        row["cells"] = round((row["tets"] / 6) ** (1 / 3))
        row |= of_run | {key: result.get(key) for key in _NUMBERS}
        row["iterations"] = int(result.get("iteration_count", 0))
        row["residual"] = result.get("err_max")
        for key, counter in _SECONDS.items():
            row[key.replace("_ms", "_seconds")] = None if result.get(counter) is None else result[counter] / 1e3
        solved = row["solve_seconds"] is not None and row["iterations"] > 0
        row["seconds_per_iteration"] = row["solve_seconds"] / row["iterations"] if solved else None
        row["iteration_copy_seconds"] = result["copy_ms"] / 1e3 / row["iterations"] if solved else None
        row["vendor_product"] = result.get("label", "") if row["method"] == "vendor" else None
        row["device"] = context.get("gpu" if words[3] == "cuda" else "cpu", "").split(",")[0]
        row["command"] = context.get("command", "")
        found.append(row)
    if not found:
        raise RunError(f"{name}: no rows of physbench linear_solves; {AGAIN}")
    return found


def groups(content, name):
    """Rows of one body, residual and machine: [{method: row}], in the order of the file; of several precisions the
    fastest. @param name of the file. @throws RunError naming the row"""
    rows = content.get("rows") if isinstance(content, dict) else None
    if not isinstance(rows, list) or not rows:
        raise RunError(f"{name}: no list of 'rows'; {AGAIN}")
    found = {}
    for number, row in enumerate(rows):
        _check(row, f"{name}: rows[{number}]")
        group = found.setdefault(tuple(row.get(key) for key in _BODY), {})
        other = group.setdefault(row["method"], row)
        if other is not row and other.get("precision") == row.get("precision"):
            raise RunError(f"{name}: rows[{number}]: '{row['method']}' of this body is there already; leave one of them")
        if _solves(row) and (not _solves(other) or row["solve_seconds"] < other["solve_seconds"]):
            group[row["method"]] = row
    for group in found.values():
        _check_group(group, name)
    return list(found.values())


def _check(row, place):
    records.require(row, _KINDS, place, AGAIN)
    if row["method"] not in METHODS:
        raise RunError(f"{place}: the method '{row['method']}' is none of {', '.join(METHODS)}")
    for key in ("setup_seconds", "solve_seconds", "residual"):
        least = 0 if key == "setup_seconds" else 1e-300
        if _solves(row) and (row[key] is None or row[key] < least):
            raise RunError(f"{place}: '{key}' is {row[key]}, which is not a positive number; {AGAIN}")


def _check_group(group, name):
    first = next(iter(group.values()))
    body = f"{name}: {first['cells']} cells, nu {first['poisson']:g}, {first['volume']} on {first['device']}"
    if "multigrid" not in group or not _solves(group["multigrid"]):
        raise RunError(f"{body}: no solve by multigrid, to which the others are compared; {AGAIN}")
    residuals = [row["residual"] for row in group.values() if _solves(row)]
    if max(residuals) > EQUAL * min(residuals):
        raise RunError(
            f"{body}: residuals from {min(residuals):.1e} to {max(residuals):.1e} are not equal ones; "
            "measure all methods to the same tolerance"
        )


def _solves(row):
    return row.get("status", CONVERGED) == CONVERGED


def lines(content, name):
    """Header and rows of the table: ratios of times over multigrid's, to solve and with the set-up of the method; then
    for each method the time to solve, and its iterations."""
    table, present = [], groups(content, name)
    methods = [method for method in METHODS if any(method in group for group in present)]
    for group in present:
        first = group["multigrid"]
        residuals = [row["residual"] for row in group.values() if _solves(row)]
        table.append(
            [f"{first['cells']}³", f"{first['poisson']:g}, {first['volume']}"]
            + [_ratios(group, methods, lambda row: row["solve_seconds"])]
            + [_ratios(group, methods, lambda row: row["setup_seconds"] + row["solve_seconds"])]
            + [_cell(group[method]) if method in group else "–" for method in methods]
            + [f"{min(residuals):.1e} to {max(residuals):.1e}", first["device"]]
        )
    named = [f"{METHODS[method]} [ms]" for method in methods]
    ratio = " : ".join(METHODS[method] for method in methods)
    return ["cells", "nu, volume by", ratio, "with set-up", *named, "residual", "device"], table


def iterations(content, name):
    """Header and rows of the table of multigrid's iterations: a column for each cube, a row for each body and norm; the
    spread is how many more the worst cube takes than the best, from 16^3 cells on."""
    present = [group["multigrid"] for group in groups(content, name)]
    cells = sorted({row["cells"] for row in present})
    found = {}
    for row in present:
        key = (f"{row['poisson']:g}, {row['volume']}", row.get("norm", ""))
        found.setdefault(key, {})[row["cells"]] = row["iterations"]
    table = []
    for (body, norm), counts in sorted(found.items()):
        of_size = [count for of, count in counts.items() if of >= 16]
        spread = f"{100 * (max(of_size) / min(of_size) - 1):.0f} %" if of_size else "–"
        table.append([body, norm, *(str(counts.get(of, "–")) for of in cells), spread])
    return ["nu, volume by", "norm", *(f"{of}³" for of in cells), "spread from 16³"], table


def _ratios(group, methods, seconds):
    least = seconds(group["multigrid"])
    return " : ".join(
        f"{seconds(group[method]) / least:.2f}" if method in group and _solves(group[method]) else "–"
        for method in methods
    )


def _cell(row):
    return f"{1e3 * row['solve_seconds']:.3g} in {row['iterations']}" if _solves(row) else row["status"]
