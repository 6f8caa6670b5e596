"""Reads and checks JSON of truthcube: run.json, and files of several runs. Needs nothing but Python."""
import json
import math
import pathlib

AGAIN = "run truthcube --out DIR with this checkout's program again"


class RunError(Exception):
    """A file that is missing, or not what truthcube writes: its name, the place, and what to do."""


def read_record(path):
    """@return run.json as it is. @throws RunError"""
    return check_record(load_json(path), str(path))


def load_json(path):
    try:
        return parse(pathlib.Path(path).read_text(encoding="utf-8"), path)
    except OSError as error:
        raise RunError(f"{path}: {error.strerror or error}") from None
    except UnicodeDecodeError as error:
        raise RunError(f"{path}: not text: {error}") from None


def parse(text, name):
    """JSON. @param name of the file. @throws RunError"""
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise RunError(f"{name}: not JSON: {error}") from None


_SETTINGS = {"material": str, "poisson": float, "volume": str, "top": str, "preconditioner": str, "stepping": str,
             "tolerance": float}  # fmt: skip
_STEP = {"compression": float, "newton_iterations": int, "pcg_iterations": int, "residual": float, "seconds": float}  # fmt: skip
_NEWTON = {"coarser_by": int, "pcg_iterations": int, "residual": float, "seconds": float}


def check_record(record, place, with_newton=True):
    """A run.json as it was read, or one of several in a file, without Newton steps. @return it. @throws RunError naming
    the key"""
    require(record, {"nodes": int, "tets": int, "device": str, "command": str, "settings": dict, "steps": list}, place)
    require(record["settings"], _SETTINGS, f"{place}: settings")
    for number, step in enumerate(record["steps"]):
        require(step, _STEP, f"{place}: steps[{number}]")
        if not with_newton:
            continue
        require(step, {"newton": list}, f"{place}: steps[{number}]")
        for k, newton in enumerate(step["newton"]):
            require(newton, _NEWTON, f"{place}: steps[{number}].newton[{k}]")
    return record


def require(record, kinds, place, remedy=AGAIN):
    """That an object has these keys with values of these kinds. Numbers are finite, or null. @throws RunError"""
    if not isinstance(record, dict):
        raise RunError(f"{place} is not an object; {remedy}")
    for key, kind in kinds.items():
        if key not in record:
            raise RunError(f"{place} has no '{key}'; {remedy}")
        value = record[key]
        number = isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
        fits = (number or value is None) if kind is float else isinstance(value, kind) and not isinstance(value, bool)
        if not fits:
            raise RunError(f"{place}: '{key}' is {json.dumps(value)[:40]}, which is no {kind.__name__}; {remedy}")
