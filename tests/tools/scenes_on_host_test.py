"""Whether the checked-in sets of scenes have all that programs do on the CPU.

scenes_on_host_test.py WRITTEN CHECKED_IN: folders of NAME.usage.json, the first as physgen has just found it, in a
build without CUDA on the CPU alone, the second united with what it finds on CUDA. What stands in the second alone is
not looked at.
"""
import json
import pathlib
import sys


def lists_of(field):
    return [(kind, place) for kind in ("places", "whole_places") for place in field.get(kind, [])]


def missing_of_fields(found, checked_in):
    """The uses on the CPU that fields of a step state and the checked-in ones do not."""
    known = {(field["array"], field["field"]): field for field in checked_in}
    for field in found:
        name = f"{field['array']}.{field['field']}"
        other = known.get((field["array"], field["field"]))
        if other is None:
            yield name
            continue
        yield from (f"{name}: {word}" for word in ("read", "written", "address_taken", "whole_object")
                    if field.get(word) and not other.get(word))
        places = lists_of(other)
        yield from (f"{name}: {place}" for kind, place in lists_of(field) if (kind, place) not in places)


def missing_of_program(found, checked_in):
    def key(step):
        return step["kernel"], step.get("place"), tuple(step["arrays"])

    steps = {}
    for step in checked_in["steps"]:
        steps.setdefault(key(step), []).extend(step["fields"])
    for step in found["steps"]:
        name = f"{step['kernel']} at {step.get('place')}"
        if key(step) not in steps:
            yield f"the step {name}"
            continue
        yield from (f"{name}: {what}" for what in missing_of_fields(step["fields"], steps[key(step)]))
    yield from (f"outside of all steps: {what}"
                for what in missing_of_fields(found.get("unattributed", []), checked_in.get("unattributed", [])))


def main(written, checked_in):
    missing, files = [], sorted(pathlib.Path(written).glob("*.usage.json"))
    for file in files:
        other = pathlib.Path(checked_in) / file.name
        if not other.exists():
            missing.append(f"{file.name}: there is none")
            continue
        found, known = (json.loads(path.read_text())["programs"][0] for path in (file, other))
        missing += [f"{file.name}: {what}" for what in missing_of_program(found, known)]
    print(f"{len(files)} scenes; what stands in {checked_in} alone, such as what they do on CUDA, was not compared")
    if not files or missing:
        sys.exit("\n".join([f"{checked_in} is stale; it lacks", *missing[:40],
                            "To renew it, in a build with -DPHYSGEN_CUDA=ON: the target update-generated"]))


main(*sys.argv[1:])
