"""Tables of READMEs, each made from one file of results, and numbers as READMEs print them.

A table stands between `<!-- figures: NAME, from FILE.json -->` and `<!-- end of figures -->`; NAME is in TABLES, whose function makes
all its lines. The table of packages comes in the same way from their list, tools/packages.txt."""
import json

from truthcube import bead_errors, layouts, linear_solves, records, scenes


# ---- Numbers ---------------------------------------------------------------------------------------------------------
def ms(row, digits=3):
    return f"{row.ms:.{digits}f}"


def count(number):
    return f"{number:,.0f}"


def limits(values, form=".2f"):
    """The smallest and the largest, for `{} to {}`."""
    values = list(values)
    return [format(min(values), form), format(max(values), form)]


def eps(value):
    return f"{value:.1f} eps" if value < 1e4 else f"{value:.0e} eps"


def error(row, which):
    return f"{row.error(which):.1e}"


def mebibytes(row):
    return row.counter("bytes_per_object") * row.objects / 2**20


def copy_fractions(file, *patterns):
    return limits(row.copy_fraction for row in file.all(*patterns))


# ---- Tables ----------------------------------------------------------------------------------------------------------
def _lines(header, body):
    head, *lines = ("| " + " | ".join(cells) + " |\n" for cells in (header, *body))
    return head + "|---" * len(header) + "|\n" + "".join(lines)


PAPER = ["dp_from_df", "stress_derivative", "add_force_differential", "element_force_differential"]  # these come first


def _kernels(file):
    """Every kernel in float on the GPU that has all three layouts; all but the first times are of tiles."""
    kernels = list(dict.fromkeys(row.kernel for row in file.all("*/soa/float/cuda/*")))
    body = []
    for kernel in sorted(kernels, key=lambda name: PAPER.index(name) if name in PAPER else len(PAPER)):
        aos, soa, tiles = (file.one(f"{kernel}/{layout}/float/cuda/*") for layout in ("aos", "soa", "aosoa32"))
        body.append(
            [kernel, f"{tiles.counter('bytes_per_object'):.0f}", ms(aos), ms(soa), ms(tiles)]
            + [f"{tiles.copy_fraction:.2f}", f"{aos.ms / tiles.ms:.2f}x", error(tiles, "p50"), error(tiles, "max")]
        )
    header = "kernel,bytes,AoS [ms],SoA [ms],AoSoA-32 [ms],/copy,over AoS,err p50,max"
    return _lines(header.split(","), body)


FAST = {
    "dp_from_df": "stress differential from its deformation's, dP from dF",
    "stress_derivative": "derivative of the stress",
    "svd": "SVD of the deformation gradient",
}


def _fast(file):
    """The first figures that a reader sees: one line for each kernel of FAST."""
    body = []
    for kernel, words in FAST.items():
        aos, tiles = (file.one(f"{kernel}/{layout}/float/cuda/*") for layout in ("aos", "aosoa32"))
        body.append([words, ms(aos), ms(tiles), f"{aos.ms / tiles.ms:.2f}x", f"{tiles.copy_fraction:.2f}"])
    return _lines(["kernel", "array of structs [ms]", "AoSoA-32 [ms]", "", "/copy"], body)


def _errors(file):
    """Every variant in float on the GPU, cuSOLVER first: time of the first set, the largest errors of all sets."""
    body = []
    variants = dict.fromkeys((row.kernel, row.layout) for row in file.all("*/aosoa32/float/cuda/*/*"))
    for kernel, layout in [("svd", "cusolver"), *variants]:
        sets = file.all(f"{kernel}/{layout}/float/cuda/*/*")
        first = file.one(f"{kernel}/{layout}/float/cuda/*/random")
        rotations = [row.counter("orth_eps_max") for row in sets if row.counter("orth_eps_max") is not None]
        body.append(
            [
                "cuSOLVER `gesvdjBatched`" if layout == "cusolver" else f"`{kernel}`",
                f"{first.ms:.0f}" if first.ms >= 100 else ms(first),
                f"{first.copy_fraction:.2f}" if first.copy_fraction >= 0.005 else "",
                eps(max(row.counter("err_eps_max") for row in sets)),
                eps(max(rotations)) if rotations else "",
                f"{sum(row.counter('failures') for row in sets):.0f}",
            ]
        )
    return _lines(["", "ms", "/copy", "max error", "U, V orthogonal to", "failures"], body)


STORAGE = {
    "float": "float",
    "quaternion": "rotations as float quaternions",
    "quaternion_half": "and the stress derivative in half",
    "quaternion16_half": "16-bit quaternions, the derivative in half",
    "quaternion16_all_half": "and dF, dP in half",
}


def _storage(file):
    """dP from dF in AoSoA-32 on the GPU, in ever fewer bytes."""
    aos = file.one("dp_from_df/aos/float/cuda/*")
    body = []
    for storage, words in STORAGE.items():
        row = file.one(f"dp_from_df/aosoa32/{storage}/cuda/*")
        body.append(
            [words, f"{row.counter('bytes_per_object'):.0f}", ms(row), f"{aos.ms / row.ms:.2f}x"]
            + [error(row, which) for which in ("p50", "p99", "max")]
        )
    return _lines(["storage", "bytes", "ms", "over AoS", "err p50", "p99", "max"], body)


FUSED = {
    "force_chain_fused": ("force_chain_separate", "positions to forces on nodes, sums in any order"),
    "force_chain_fused_fixed_order": ("force_chain_separate", "the same in a fixed order"),
    "force_chain_fused_gathered": ("force_chain_separate", "the same, corner forces stored and gathered"),
    "newton_update_fused": ("newton_update_separate", "positions to corner forces, U, V, clamped derivative"),
    "matrix_free_fused": ("matrix_free_separate", "displacements to force differentials on nodes"),
}


def _fused_in(tiles):
    """Each fused group in float beside the kernels that it is made of; bytes of the fused ones, per tet."""

    def table(file):
        tets = file.one(f"newton_update_fused/{tiles}/*").objects
        body = []
        for kernel, (separate, words) in FUSED.items():
            fused, apart = file.one(f"{kernel}/{tiles}/*"), file.one(f"{separate}/{tiles}/*")
            per_tet = fused.counter("bytes_per_object") * fused.objects / tets
            body.append(
                [words, ms(apart), ms(fused), f"{apart.ms / fused.ms:.2f}x", f"{per_tet:.0f}"]
                + [f"{fused.copy_fraction:.2f}", error(fused, "p50"), error(fused, "max")]
            )
        return _lines("group,separate [ms],fused [ms],,bytes per tet,/copy,err p50,max".split(","), body)

    return table


def _packages(text):
    """Those of tools/packages.txt, which says what its lines are."""
    lines = dict(line.split(maxsplit=1) for line in text.splitlines() if line and line[0] != "#")
    best, *others = lines.pop("LLVM").split()
    del lines["MORE"]
    names = {name: name.replace("LLVM", best) + f" (or {', '.join(others)})" * ("LLVM" in name) for name in lines}
    return _lines(["package", "what for"], [[names[name], reason] for name, reason in lines.items()])


def _truthcube(text):
    """Runs of truthcube_runs.py: one line for each."""
    body = []
    for run in json.loads(text)["runs"]:
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
    return _lines(head, body)


def _linear_solves(text):
    """Rows of the program linear_solves: one line for each body and machine."""
    name = "linear_solves.json"
    return _lines(*linear_solves.lines(records.parse(text, name), name))


def _iterations(text):
    """Iterations of multigrid over cubes: one line for each body and norm."""
    name = "linear_solves_counts.json"
    return _lines(*linear_solves.iterations(records.parse(text, name), name))


def _beads(text):
    """Runs of truthcube_runs.py --errors: one line for each mesh."""
    name = "runs of truthcube_runs.py --errors"
    return _lines(*bead_errors.lines(records.parse(text, name), name))


def _layouts(text):
    """Two builds of layout_runs.py: one line for each body."""
    name = "layouts.json"
    return _lines(*layouts.lines(records.parse(text, name), name))


def _scenes(text):
    """Scenes of scene_runs.py: one line for each."""
    name = "scenes.json"
    return _lines(*scenes.lines(records.parse(text, name), name))


TABLES = {
    "fast": _fast,
    "kernels": _kernels,
    "errors": _errors,
    "storage": _storage,
    "fused": _fused_in("aosoa32/float/cuda"),
    "fused_host": _fused_in("aosoa16/float/host"),
    "packages": _packages,
    "truthcube": _truthcube,
    "linear_solves": _linear_solves,
    "iterations": _iterations,
    "layouts": _layouts,
    "scenes": _scenes,
    "beads": _beads,
}
