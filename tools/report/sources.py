#!/usr/bin/env python3
"""Prints the hashes of the sources that physbench's figures depend on: `tools/report/sources.py [CHECKOUT]`. There is
one for each group, a folder or a file, and physbench writes the same line into its results.

The hash of a group is the first 16 digits that `sha256sum` gives for the output of `sha256sum FILE...`. The files are
those of the group with one of ENDINGS; they are named from the checkout's root and sorted by the bytes of their names,
and \\r\\n in them is read as \\n. tools/physbench/sources.cmake states the rule for the build; a test compares both."""
import hashlib
import os
import pathlib
import sys

GROUPS = (
    "runtime",
    "generated/elasticity.physgen.h",
    *(f"tools/fem/{folder}" for folder in ("kernels", "materials", "mesh", "numerics", "reference")),
    "tools/physbench",
)
ENDINGS = (".h", ".cpp", ".cu", ".in", ".cmake", "CMakeLists.txt")
CHECKOUT = pathlib.Path(__file__).resolve().parents[2]


def hashes(checkout=CHECKOUT, groups=GROUPS):
    """@return {group: hash}, in the order of the groups"""
    return {group: _hash(pathlib.Path(checkout), group) for group in groups}


def text(found):
    """The hashes as physbench writes them: `runtime 0123456789abcdef, tools/fem/kernels ...`."""
    return ", ".join(f"{group} {value}" for group, value in found.items())


def parse(written):
    """The reverse of text(). @return {group: hash}; None where that is not what physbench writes"""
    found = {}
    for part in written.split(", ") if isinstance(written, str) else [""]:
        group, space, value = part.partition(" ")
        if not space or len(value) != 16 or set(value) - set("0123456789abcdef"):
            return None
        found[group] = value
    return found


def _hash(checkout, group):
    whole = checkout / group
    found = [whole] if whole.is_file() else whole.rglob("*")
    paths = (path for path in found if path.name.endswith(ENDINGS) and path.is_file())
    lines = []
    for name in sorted(os.fsencode(path.relative_to(checkout).as_posix()) for path in paths):
        content = (checkout / os.fsdecode(name)).read_bytes().replace(b"\r\n", b"\n")
        lines.append(hashlib.sha256(content).hexdigest().encode() + b"  " + name + b"\n")
    return hashlib.sha256(b"".join(lines)).hexdigest()[:16]


if __name__ == "__main__":
    if len(sys.argv) > 2 or not os.path.isdir(sys.argv[-1] if len(sys.argv) == 2 else CHECKOUT):
        sys.exit("sources.py [CHECKOUT]: the folder of a checkout, or nothing for this one")
    print(text(hashes(*sys.argv[1:])))
