"""The bytes that the scenes of truthcube keep, and the time that they take. Its file is what scene_runs.py writes: a list
`scenes`, of each {scene, scalars, own: {flags, tets, bytes, seconds}} and, where the scene everything offers the same
choices, `everything`, too."""
import pathlib

from . import digest, records
from .records import RunError

AGAIN = "measure again with tools/report/scene_runs.py"
# Whose arrays a scene has; of what they have of tets, corner forces and assembled tangents are those of a chunk.
ARRAYS = {
    "quasistatic": "quasistatic",
    "matrix-free": "quasistatic_matrix_free",
    "fixed-corotated": "quasistatic_fixed_corotated",
    "implicit-dynamics": "implicit_dynamics",
    "explicit-dynamics": "explicit_dynamics",
    "linear-elastic": "linear_elastic_assembled",
}
_RUN = {"flags": str, "tets": int, "bytes": int, "seconds": float}


def scalars(checkout, scene, flags):
    """The scalars, numbers of nodes and the like left out, that a scene stores of each tet between two steps, as physgen
    found them. @throws RunError"""
    arrays = ARRAYS[scene]
    if scene == "linear-elastic" and "--product matrix-free" in flags:
        arrays = "linear_elastic"
    sets = ["per tet", "per gathered_tet"] + ["per kept_tet"] * (scene == "matrix-free")
    needs = digest.read(pathlib.Path(checkout) / "generated" / "scenes" / f"{arrays}.digest")
    return sum(
        field["elements"]
        for name, array in needs["arrays"].items()
        if array["of"] in sets and not name.startswith("stresses.")
        for field in array["fields"].values()
        if field["fate"] == "kept" and not field["type"].startswith("int")
    )


def lines(content, name):
    """Header and rows of the table, a row for each scene. @param name of the file. @throws RunError naming the place"""
    rows = content.get("scenes") if isinstance(content, dict) else None
    if not isinstance(rows, list) or not rows:
        raise RunError(f"{name}: no list of 'scenes'; {AGAIN}")
    table, timed = [], False
    for number, row in enumerate(rows):
        place = f"{name}: scenes[{number}]"
        records.require(row, {"scene": str, "scalars": int, "own": dict}, place, AGAIN)
        both = [row["own"], row.get("everything")]
        for run in filter(None, both):
            records.require(run, _RUN, place, AGAIN)
        words = row["own"]["flags"].removeprefix("--scene ")
        cells = [f"`{words}`", f"{row['scalars']}"]
        cells += [f"{run['bytes'] / run['tets']:.1f}" if run else "" for run in both]
        times = [run and run["seconds"] for run in both]
        timed = timed or any(times)
        table.append([*cells, *(f"{1e3 * time:.3g}" if time else "" for time in times)])
    head = ["`--scene`", "scalars per tet", "bytes per tet", "over arrays of `everything`"]
    if not timed:
        return head, [cells[: len(head)] for cells in table]
    return [*head, "a step [ms]", "over arrays of `everything` [ms]"], table
