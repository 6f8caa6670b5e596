"""Reads the digest of a scene, which physgen writes (generator/scenes/digest.h has its lines). Needs nothing but Python."""
import pathlib

from .records import RunError

FORMAT = "format 1"
REMEDY = "write it with physgen of this checkout: tools/dev build release update-generated"


def read(path):
    """@return {"arrays": {name: {"of": "per tet", "other": ..., "fields": {name: {"type", "elements", "fate", "uses"}}}},
    "steps": {step: {(array.field, way)}}, "joins": [line]}, "uses" and ways in words. @throws RunError naming the line"""
    try:
        lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise RunError(f"{path}: {error.strerror or error}; {REMEDY}") from None
    if lines[1:2] != [FORMAT]:
        raise RunError(f"{path}:2: the digest has no line '{FORMAT}'; {REMEDY}")
    digest = {"arrays": {}, "steps": {}, "joins": []}
    array = step = None
    for number, line in enumerate(lines[2:], 3):
        try:
            word, rest = line.split(maxsplit=1)
            if line.startswith("array "):
                name, text = rest.split(" of ", 1)
                kind, _, other = text.partition("; ")
                array, step = {"of": kind.split(" ", 1)[1], "other": f"{kind.split(' ')[0]}; {other}", "fields": {}}, None
                digest["arrays"][name] = array
            elif line.startswith("  field "):
                name, kind, elements, fate, *uses = rest.split()
                array["fields"][name] = {"type": kind, "elements": int(elements), "fate": fate, "uses": set(uses)}
            elif line.startswith(("step ", "outside ")):
                array, step = None, digest["steps"].setdefault(line, set())
            elif line.startswith("  "):
                ways, fields = line.split(": ")
                step.update((field, way) for field in fields.split() for way in ways.split())
            elif line.startswith(("joined: ", "read before written: ")):
                digest["joins"].append(line)
            else:
                raise ValueError(word)
        except (ValueError, TypeError, AttributeError, IndexError):
            raise RunError(f"{path}:{number}: '{line}' is not a line of a digest; {REMEDY}") from None
    return digest
