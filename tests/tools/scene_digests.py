"""Whether the checked-in digests of scenes are what physgen has just found.

scene_digests.py (--all | --on-the-cpu) WRITTEN CHECKED_IN: folders of NAME.digest, the first of a build. With
--on-the-cpu it was a build without CUDA: what stands in CHECKED_IN alone, such as what programs do on CUDA, is not
looked at. Reports of scenes (NAME.need.json and the like) are files of a build, and none of CHECKED_IN.
"""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools" / "report"))
from truthcube import digest, records  # noqa: E402

RENEW = "To renew it, in a build with -DPHYSGEN_CUDA=ON: tools/dev build release update-generated"
KNOWN = (".scene.h", ".program.h", ".digest")


def of_arrays(found, known, exactly):
    for name in sorted(found.keys() | known.keys()) if exactly else sorted(found):
        if name not in found or name not in known:
            yield f"array {name}: it is in the {'scene, not in the digest' if name in found else 'digest, not in the scene'}"
            continue
        one, other = found[name], known[name]
        if exactly or one["of"] != other["of"]:
            yield from (f"array {name}: '{one[key]}' is found, and the digest has '{other[key]}'"
                        for key in ("of", "other") if one[key] != other[key])
        for field in sorted(one["fields"].keys() | other["fields"].keys()):
            yield from of_field(f"field {name}.{field}", one["fields"].get(field), other["fields"].get(field), exactly)


def text_of(field):
    return "none" if field is None else " ".join([field["type"], str(field["elements"]), field["fate"], *sorted(field["uses"])])


def of_field(name, found, known, exactly):
    """Without CUDA a field may be pruned that CUDA needs, and have fewer uses."""
    if found is not None and known is not None and not exactly:
        more = {**found, "uses": found["uses"] | known["uses"]}
        if found["fate"] in ("pruned", "left_out") or known["fate"] == "kept":
            more["fate"] = known["fate"]
        found = more
    if found != known:
        yield f"{name}: '{text_of(found)}' is found, and the digest has '{text_of(known)}'"


def of_steps(found, known, exactly):
    for step in sorted(found.keys() | known.keys()) if exactly else sorted(found):
        if step not in found or step not in known:
            yield f"{step}: it is in the {'program, not in the digest' if step in found else 'digest, not in the program'}"
            continue
        yield from (f"{step}: field {field} is {way}, which the digest does not say"
                    for field, way in sorted(found[step] - known[step]))
        yield from (f"{step}: the digest says that field {field} is {way}, which is not found"
                    for field, way in sorted(known[step] - found[step]) if exactly)


def differences(found, known, exactly):
    yield from of_arrays(found["arrays"], known["arrays"], exactly)
    yield from of_steps(found["steps"], known["steps"], exactly)
    if exactly:
        for line in sorted(set(found["joins"]) ^ set(known["joins"])):
            yield f"'{line}' stands in the {'digest alone' if line in known['joins'] else 'scene, not in the digest'}"


def main(mode, written, checked_in):
    written, checked_in = pathlib.Path(written), pathlib.Path(checked_in)
    stale, exactly = [], {"--all": True, "--on-the-cpu": False}[mode]
    scenes = {file.stem for folder in (written, checked_in) for file in folder.glob("*.digest")}
    for scene in sorted(scenes):
        file, other = written / f"{scene}.digest", checked_in / f"{scene}.digest"
        if not file.exists() or not other.exists():
            stale.append(f"scene {scene}: there is no {other if file.exists() else file}")
            continue
        try:
            stale += [f"scene {scene}: {what}" for what in differences(digest.read(file), digest.read(other), exactly)]
        except records.RunError as error:
            stale.append(f"scene {scene}: {error}")
        if exactly and not stale and file.read_text() != other.read_text():
            stale.append(f"scene {scene}: {other} has other lines than {file}")
    others = [file.name for file in sorted(checked_in.iterdir()) if not file.name.endswith(KNOWN)]
    if others:
        stale.append(f"{', '.join(others)}: no files of this folder, but reports of an older checkout; delete them: reports "
                     f"of scenes are written to {written}")
    print(f"{len(scenes)} scenes" + ("" if exactly else "; what stands in the digests alone, such as uses on CUDA, was not compared"))
    if not scenes or stale:
        sys.exit("\n".join([f"{checked_in} is stale:", *stale[:40], *(["..."] if stale[40:] else []), RENEW]))


main(*sys.argv[1:])
