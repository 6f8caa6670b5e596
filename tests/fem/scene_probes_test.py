"""Whether the checked-in set of a scene is what the compilers of the host find in its program.

scene_probes_test.py USAGE_JSON PROGRAM...: each program prints the fields that its compiler has found, g++ for the CPU
and nvcc for CUDA. These do not read code for devices that steps launch in a way of their own; what such steps alone do
may stand in the set beyond what the programs print.
"""
import json
import subprocess
import sys

WORDS = ("read", "written", "address_taken")


def registered(programs):
    found = set()
    for program in programs:
        lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
        if not lines:
            sys.exit(f"{program} has found nothing")
        for line in lines:
            array, field, *words = line.split()
            found |= {(array, field, word) for word in words}
    return found


def checked_in(file):
    """All uses, and those of steps of device code that is launched in a way of its own."""
    program = json.load(open(file, encoding="utf-8"))["programs"][0]
    every, own = set(), set()
    steps = [*program["steps"], {"fields": program.get("unattributed", [])}]
    for step in steps:
        uses = {(field["array"], field["field"], word)
                for field in step["fields"] for word in WORDS if field.get(word)}
        every |= uses
        if step.get("kernel", "").startswith("lambda in ") and "_cuda.h:" in step["place"]:
            own |= uses
    return every, own


def main(file, *programs):
    found = registered(programs)
    every, own = checked_in(file)
    wrong = [f"not in {file}: {' '.join(use)}" for use in sorted(found - every)]
    wrong += [f"found by no compiler: {' '.join(use)}" for use in sorted(every - own - found)]
    print(f"{len(found)} uses found, {len(every)} checked in, {len(every - found)} of device code alone")
    if wrong:
        sys.exit("\n".join(wrong))


main(*sys.argv[1:])
