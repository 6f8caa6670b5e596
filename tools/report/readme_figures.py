"""Which figures of READMEs come from which results. readme_numbers.py compares them and writes them.

- A table stands in a README between `<!-- figures: NAME, from FILE.json -->` and `<!-- end of figures -->`; NAME is in
  TABLES, which makes all its lines. That of the packages comes in the same way from their list, tools/packages.txt.
- A figure in a sentence is a `{}` in SENTENCES; around it stand the words as the README has them.
- What looks measured in the parts of READMEs in COMPLETE, but comes from no result file, is in ELSEWHERE.

A figure is found by the names of rows, `kernel/layout/storage/space/objects[/set]`, where `*` stands for anything
within a part (`File` in readme_numbers.py)."""
import importlib
import json
from dataclasses import dataclass

import rows
from truthcube import linear_solves, records

READMES = ["README.md", "tools/fem/README.md", "tools/physbench/README.md", "tools/examples/kernels.md"]


# ---- Numbers as READMEs print them -----------------------------------------------------------------------------------
def _ms(row, digits=3):
    return f"{row.ms:.{digits}f}"


def _count(number):
    return f"{number:,.0f}"


def _range(values, form=".2f"):
    """The smallest and the largest, for `{} to {}`."""
    values = list(values)
    return [format(min(values), form), format(max(values), form)]


def _eps(value):
    return f"{value:.1f} eps" if value < 1e4 else f"{value:.0e} eps"


def _error(row, which):
    return f"{row.error(which):.1e}"


def _mebibytes(row):
    return row.counter("bytes_per_object") * row.objects / 2**20


def _copy_fractions(file, *patterns):
    return _range(row.copy_fraction for row in file.all(*patterns))


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
            [kernel, f"{tiles.counter('bytes_per_object'):.0f}", _ms(aos), _ms(soa), _ms(tiles)]
            + [f"{tiles.copy_fraction:.2f}", f"{aos.ms / tiles.ms:.2f}x", _error(tiles, "p50"), _error(tiles, "max")]
        )
    header = "kernel,bytes,AoS [ms],SoA [ms],AoSoA-32 [ms],/copy,over AoS,err p50,max"
    return _lines(header.split(","), body)


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
                f"{first.ms:.0f}" if first.ms >= 100 else _ms(first),
                f"{first.copy_fraction:.2f}" if first.copy_fraction >= 0.005 else "",
                _eps(max(row.counter("err_eps_max") for row in sets)),
                _eps(max(rotations)) if rotations else "",
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
            [words, f"{row.counter('bytes_per_object'):.0f}", _ms(row), f"{aos.ms / row.ms:.2f}x"]
            + [_error(row, which) for which in ("p50", "p99", "max")]
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
                [words, _ms(apart), _ms(fused), f"{apart.ms / fused.ms:.2f}x", f"{per_tet:.0f}"]
                + [f"{fused.copy_fraction:.2f}", _error(fused, "p50"), _error(fused, "max")]
            )
        return _lines("group,separate [ms],fused [ms],,bytes per tet,/copy,err p50,max".split(","), body)

    return table


def _packages(text):
    """Those of tools/packages.txt, which says what its lines are."""
    lines = dict(line.split(maxsplit=1) for line in text.splitlines() if line and line[0] != "#")
    best, *others = lines.pop("LLVM").split()
    names = {name: name.replace("LLVM", best) + f" (or {', '.join(others)})" * ("LLVM" in name) for name in lines}
    return _lines(["package", "what for"], [[names[name], reason] for name, reason in lines.items()])


def _truthcube(text):
    """Runs of truthcube_runs.py: one line for each."""
    body = []
    for run in json.loads(text)["runs"]:
        settings, steps = run["settings"], run["steps"]
        keys = ("newton_iterations", "pcg_iterations", "seconds", "warm_seconds")
        total = {key: sum(step[key] for step in steps) for key in keys}
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
                f"{total['warm_seconds'] * 1e3:.0f} ms",
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


TABLES = {
    "kernels": _kernels,
    "errors": _errors,
    "storage": _storage,
    "fused": _fused_in("aosoa32/float/cuda"),
    "fused_host": _fused_in("aosoa16/float/host"),
    "packages": _packages,
    "truthcube": _truthcube,
    "linear_solves": _linear_solves,
}


# ---- Sentences -------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Sentence:
    readme: str
    file: str  # of results
    words: str  # as the README has them, with `{}` for each figure; line breaks count as spaces
    figures: object  # File -> texts, one for each `{}`


def _schemes(file):
    rows = {row.storage: row for row in file.all("dp_from_df/aosoa16/*/host/*")}
    return [_ms(rows[name], 2) for name in ("quaternion16", "bfloat16_derivative")]


def _xeon(file):
    rows = [file.one(f"dp_from_df/{name}/host/*") for name in ("aos/float", "aosoa16/float")]
    rows += [file.one(f"dp_from_df/aosoa16/{name}/host/*") for name in ("quaternion", "quaternion_half")]
    return [_ms(row, 2) for row in rows]


def _xeon_cache(file):
    floats = file.one("dp_from_df/aosoa16/float/host/*")
    return [f"{_mebibytes(floats):.0f}", f"{max(cache['size'] for cache in file.context['caches']) / 2**20:.0f}"]


def _small_launches(file):
    rows = [row for row in file.all("dp_from_df/aosoa32/float/cuda/*") if row.objects < 2**16]
    return _range((row.ms * 1e3 for row in rows), ".1f")


def _gathers(file):
    wanted = ["aos_padded/random", "soa/random", "aos_padded/renumbered"]
    return [_ms(file.one("gather_nodes/{}/float/cuda/*/{}".format(*name.split("/")))) for name in wanted]


def _forces(file):
    ours = [_ms(file.one(f"*/symmetric_{mode}/float/cuda/*")) for mode in ("fast", "deterministic")]
    library = min(file.all("*/cusparse_*/float/cuda/*"), key=lambda row: row.ms)
    return [*ours, _ms(library), _count(library.objects)]


def _whole_records(file):
    last = file.one("dp_from_df/aosoa32/quaternion16_all_half/cuda/*")
    record = file.one("dp_from_df/record/float/cuda/*")
    return [
        _count(last.objects),
        _ms(file.one("dp_from_df/aos/float/cuda/*")),
        _ms(record, 2),
        f"{record.ms / last.ms:.1f}",
    ]


def _sectors(file):
    kernels, layouts = ("dp_from_df", "stress_derivative", "deformation_gradient"), ("aos", "soa", "aosoa32")
    rows = [file.one(f"{kernel}/{layout}/float/cuda/*") for kernel in kernels for layout in layouts]
    return [f"{row.counter('sectors_per_request'):.1f}" for row in rows]


def _element_speed_ups(file):
    elements = file.one("dp_from_df/aosoa32/float/cuda/*").objects
    rows = file.all(f"*/aosoa32/float/cuda/{elements}")
    return _range((file.one(f"{row.kernel}/aos/float/cuda/{elements}").ms / row.ms for row in rows), ".1f")


def _sweeps(file):
    in_float, in_double = (file.all(f"svd_3_sweeps/aosoa32/{real}/cuda/*/*") for real in ("float", "double"))
    largest = max(row.counter("err_eps_max") for row in in_float)
    return [f"{largest:.1f}", f"{max(row.error('max') for row in in_double):.1e}"]


SENTENCES = [
    Sentence(
        "README.md",
        "h200.json",
        "H200, float, {} objects, median; `/copy`",
        lambda file: [_count(file.one("dp_from_df/aosoa32/float/cuda/*").objects)],
    ),
    Sentence(
        "README.md",
        "h200.json",
        "run over the mesh's {} nodes, `edge_stiffness` over its {} edges",
        lambda file: [_count(file.one(f"{name}_stiffness/aosoa32/float/cuda/*").objects) for name in ("node", "edge")],
    ),
    Sentence(
        "README.md",
        "h200_errors.json",
        "H200, float, {} objects, the largest errors of all three sets",
        lambda file: [_count(file.one("svd/aosoa32/float/cuda/*/random").objects)],
    ),
    Sentence(
        "README.md",
        "h200.json",
        "over three arrays of 36, 12 and 36 bytes it takes {} ms",
        lambda file: [_ms(file.one("svd/aos_three_arrays/float/cuda/*"))],
    ),
    Sentence(
        "README.md",
        "h200.json",
        "each of which stores what the next one reads, take {} ms in tiles and {} ms as AoS",
        lambda file: [_ms(file.one(f"force_chain_separate/{layout}/float/cuda/*")) for layout in ("aosoa32", "aos")],
    ),
    Sentence(
        "README.md",
        "h200_errors.json",
        "{} eps means not orthogonal at all",
        lambda file: [f"{max(row.counter('orth_eps_max') for row in file.all('svd/cusolver/float/cuda/*/*')):.0e}"],
    ),
    Sentence(
        "README.md",
        "h200_storage.json",
        "dP from dF on the H200, {} objects, AoSoA-32; times against an array of structs of floats ({} ms) in the same "
        "run; whole records of 48 scalars take {} ms, {} times the last row.",
        _whole_records,
    ),
    Sentence(
        "README.md",
        "xeon_storage.json",
        "({} threads of a Xeon, AVX-512, {} objects, AoSoA-16;",
        lambda file: [
            file.context["threads"].split(",")[0],
            _count(file.one("dp_from_df/aosoa16/float/host/*").objects),
        ],
    ),
    Sentence("README.md", "xeon_storage.json", "the {} MiB of floats fit into its L3 cache of {} MiB", _xeon_cache),
    Sentence(
        "README.md",
        "xeon_storage.json",
        "AoS takes {} ms, AoSoA of floats {} ms, float quaternions {} ms, and with the derivative in half {} ms.",
        _xeon,
    ),
    Sentence(
        "README.md",
        "xeon_storage.json",
        "16-bit quaternions take {} ms, bfloat16 {} ms",
        _schemes,
    ),
    Sentence(
        "README.md",
        "h200_conversions.json",
        "Copies between Aos, Soa and Aosoa<32> run at {} to {} of the device's own copy",
        lambda file: _range(
            row.copy_fraction for row in file.all("convert_*/*_to_*/float/cuda/*") if "padded" not in row.layout
        ),
    ),
    Sentence(
        "README.md",
        "h200_conversions.json",
        "those that also make halves at {} to {};",
        lambda file: _copy_fractions(file, "convert_*/*_to_*/half/cuda/*"),
    ),
    Sentence(
        "README.md",
        "h200_conversions.json",
        "transfers with conversion at {} to {} of a plain one from and to pinned memory",
        lambda file: _copy_fractions(file, "transfer_pinned_*/*/*/cuda/*"),
    ),
    Sentence(
        "README.md",
        "h200_conversions.json",
        "{} to {} from and to pageable memory in float",
        lambda file: _copy_fractions(file, "transfer_pageable_*/*/float/cuda/*"),
    ),
    Sentence(
        "README.md",
        "h200_conversions.json",
        "in float and {} to {} where halves are made.",
        lambda file: _copy_fractions(file, "transfer_pageable_*/*/half/cuda/*"),
    ),
    Sentence(
        "README.md",
        "h200_conversions.json",
        "at {} to {} of the rate of packing from objects",
        lambda file: _copy_fractions(file, "transfer_scattered_*/*/*/cuda/*"),
    ),
    Sentence("README.md", "h200_growth.json", "launch, {} to {} µs however few they are", _small_launches),
    Sentence(
        "README.md",
        "h200_reduce.json",
        "runs at {} to {} of a pass that only reads as many bytes for 2^24 vectors",
        lambda file: _copy_fractions(file, f"dot_product/*/*/cuda/{2**24}"),
    ),
    Sentence(
        "README.md",
        "h200_reduce.json",
        "and at {} to {} for 2^22",
        lambda file: _copy_fractions(file, f"dot_product/*/*/cuda/{2**22}"),
    ),
    Sentence(
        "README.md",
        "h200_forces.json",
        "takes {} ms from its symmetric half with atomics and {} ms in a fixed order, cuSPARSE's best {} ms over full "
        "blocks ({} nodes,",
        _forces,
    ),
    Sentence(
        "README.md",
        "h200_gathers.json",
        "random numbering cost {} ms padded and {} ms as Soa; renumbered, {}, as on the ordered mesh",
        _gathers,
    ),
    Sentence(
        "tools/fem/README.md",
        "h200_errors.json",
        "3 sweeps up to {} eps in float and {} |A| in double over the sets of `physbench errors`",
        _sweeps,
    ),
    Sentence(
        "tools/physbench/README.md",
        "h200_storage.json",
        "dF and dP in half, too ({} bytes); `all_half`: matrices, all in half ({}); `all_bfloat16`: quaternions and "
        "all else in bfloat16 ({})",
        lambda file: [
            f"{file.one(f'dp_from_df/aosoa32/{name}/cuda/*').counter('bytes_per_object'):.0f}"
            for name in ("quaternion16_all_half", "all_half", "all_bfloat16")
        ],
    ),
    Sentence(
        "tools/physbench/README.md",
        "h200_forces.json",
        "`add_force_differential` on a mesh of {} nodes (GPU)",
        lambda file: [_count(file.one("*/symmetric_fast/float/cuda/*").objects)],
    ),
    Sentence(
        "tools/physbench/README.md",
        "h200_conversions.json",
        "{} objects of 48 bytes, floats on the host, to halves on an H200: {} ms from pinned memory, {} ms from "
        "pageable memory",
        lambda file: [
            _count(file.one("transfer_pinned_48/aos_to_aosoa32/half/cuda/*").objects),
            *(_ms(file.one(f"transfer_{of}_48/aos_to_aosoa32/half/cuda/*"), 1) for of in ("pinned", "pageable")),
        ],
    ),
    Sentence(
        "tools/physbench/README.md",
        "h200.json",
        "has {}, {} and {} sectors over AoS, SoA and tiles for the first, {}, {} and {} for the second, {}, {} and {} "
        "for the third",
        _sectors,
    ),
    Sentence(
        "tools/physbench/README.md",
        "h200_errors.json",
        "over three sets of deformation gradients, {} on the CPU as on the GPU",
        lambda file: [_count(file.one("svd/aosoa32/float/cuda/*/random").objects)],
    ),
    Sentence(
        "tools/physbench/README.md",
        "h200_errors.json",
        "The first {} objects differ",
        lambda file: [_count(file.one("svd/aosoa32/float/cuda/*/random").counter("samples"))],
    ),
    Sentence("tools/examples/kernels.md", "h200.json", "H200: {} to {} times as fast as `aos`", _element_speed_ups),
    Sentence(
        "tools/examples/kernels.md",
        "h200_gathers.json",
        "H200, random numbers: {} ms against {} ms as `soa`",
        lambda file: [_ms(file.one(f"gather_nodes/{name}/float/cuda/*/random"), 2) for name in ("aos_padded", "soa")],
    ),
    Sentence(
        "tools/examples/kernels.md",
        "h200.json",
        "H200: `add_force_differential` {} ms against {} ms in tiles",
        lambda file: [_ms(file.one(f"add_force_differential/{name}/float/cuda/*"), 2) for name in ("aos", "aosoa32")],
    ),
]


# ---- Pictures --------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Picture:
    """A plot, made from some files of results."""

    path: str
    files: tuple
    draw: object  # paths of the files -> matplotlib's figure, or None where they have no rows for it


def _of_page(plot):
    """The first plot of a section of the report, plots/`plot`.py."""

    def draw(paths):
        section = importlib.import_module(f"plots.{plot}").section(rows.load(paths))  # only drawing needs matplotlib
        return next((block.plot for block in section.blocks if hasattr(block, "plot")), None)

    return draw


def _error_against_time(paths):
    return importlib.import_module("truthcube.error_against_time").draw(*paths)


PICTURES = [
    Picture("tools/report/results/h200_pareto.svg", ("h200.json", "h200_storage.json"), _of_page("pareto")),
    Picture("tools/report/results/h200_gathered.svg", ("h200_gathers.json",), _of_page("gathered")),
    Picture("tools/report/results/truthcube/error_against_time.svg", ("truthcube/errors.json",), _error_against_time),
]

# ---- What is from elsewhere ------------------------------------------------------------------------------------------
# Parts of READMEs, from one text to another ("" is the end), in which all that looks measured must be held by results
# or stand in ELSEWHERE: words as in SENTENCES, and where they are from.
COMPLETE = {"README.md": ("## Measured", "What accessors cost:"), "tools/physbench/README.md": ("# physbench", "")}
ELSEWHERE = {
    "README.md": [
        ("The paper's table 1 (GTX 285, 2010) had {}, {} and {} for the first three.", "the paper"),
        (
            "runs at the rate of a copy ({} to {}), {} to {} times as fast as the better of the two ways over AoS",
            "`tools/dev run --threads=1` on such a machine; no results of it are checked in",
        ),
        ("One CPU core with AVX-512 (AMD EPYC, {} objects,", "as above"),
        ("the stress derivative at {} to {} of a copy, {} to {} times AoS.", "as above"),
        ("The SVD does {} million matrices a second ({} million in packs of 8,", "as above"),
        ("Eigen's JacobiSVD {} million.", "as above"),
    ],
    "tools/physbench/README.md": [
        ("compressed by {} % with a bulge", "fem/mesh/truth_cube.cpp"),
        ("Default sizes ({} tets on the CPU, {} on the GPU)", "options.h"),
        ("the same row took {} ms; that way is gone", "a way to copy that is gone; no command measures it any more"),
        ("| `random` | I + {} N(0,1) |", "how the set is made"),
    ],
}
