"""Tables of pages, each made from one file of results, with a caption where machine and number of objects are not in it.

A table stands between `<!-- figures: NAME, from FILE.json -->` and `<!-- end of figures -->`; NAME is in TABLES, whose function makes
all its lines. The table of packages comes in the same way from their list,
tools/packages.txt, and that of joined steps from the folder of the scenes' digests. Rows are found by name,
`kernel/layout/storage/space/objects`, where `*` stands for anything within a part."""
import re

import links
import solves_on_ranks
from table_text import captioned, count, eps, error, markdown, ms, times
from truthcube import bead_errors, layouts, linear_solves, records, runs, scenes

PAPER = {"dp_from_df": 8.33, "stress_derivative": 6.72, "add_force_differential": 5.13}  # table 1, over AoS, GTX 285, 2010
FIRST = [*PAPER, "element_force_differential"]  # these come first


def _kernels(file):
    """Every kernel in float on the GPU that has all three layouts; all but the first times are of tiles. Behind them what
    has AoS and tiles alone, or AoS alone."""
    kernels = list(dict.fromkeys(row.kernel for row in file.all("*/soa/float/cuda/*")))
    body = []
    for kernel in sorted(kernels, key=lambda name: FIRST.index(name) if name in FIRST else len(FIRST)):
        aos, soa, tiles = (file.one(f"{kernel}/{layout}/float/cuda/*") for layout in ("aos", "soa", "aosoa32"))
        body.append(_kernel(kernel, aos, soa, tiles))
    chain = [file.one(f"force_chain_separate/{layout}/float/cuda/*") for layout in ("aos", "aosoa32")]
    body.append(_kernel("force_chain_separate", chain[0], None, chain[1]))
    body.append(_kernel("svd over three arrays", file.one("svd/aos_three_arrays/float/cuda/*"), None, None))
    header = "kernel,objects,bytes,AoS [ms],SoA [ms],AoSoA-32 [ms],/copy,over AoS,the paper's,err p50,max"
    return f"{file.one('svd/aosoa32/float/cuda/*').machine}, float:\n\n" + markdown(header.split(","), body)


def _kernel(name, aos, soa, tiles):
    best = tiles or aos
    return [
        *(name, count(best.objects), f"{best.counter('bytes_per_object'):.0f}"),
        *(ms(row) if row else "" for row in (aos, soa, tiles)),
        *((f"{tiles.copy_fraction:.2f}", times(aos, tiles)) if tiles else ("", "")),
        *(f"{PAPER[name]:.2f}x" if name in PAPER else "", error(best, "p50"), error(best, "max")),
    ]


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
        body.append([words, ms(aos), ms(tiles), times(aos, tiles), f"{tiles.copy_fraction:.2f}"])
    return markdown(["kernel", "array of structs [ms]", "AoSoA-32 [ms]", "", "/copy"], body)


def _one_thread(file):
    """Kernels of FAST on one thread of a CPU, in tiles of 16, beside the faster of the two ways over structs, and plain Eigen."""
    body = []
    for kernel in FAST:
        tiles, eigen = (file.one(f"{kernel}/{layout}/float/host/*") for layout in ("aosoa16", "eigen"))
        structs = min((file.one(f"{kernel}/{layout}/float/host/*") for layout in ("aos", "aos_scalar")), key=lambda row: row.ms)
        rate = f"{tiles.objects / tiles.ms / 1e3:.0f}"
        body.append([f"`{kernel}`", ms(tiles), f"{tiles.copy_fraction:.2f}", times(structs, tiles), times(eigen, tiles), rate])
    header = "kernel,AoSoA-16 [ms],/copy,over AoS,over plain Eigen,million objects a second"
    return captioned(file.one("svd/aosoa16/float/host/*"), "objects of float", markdown(header.split(","), body))


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
    table = markdown(["", "ms", "/copy", "max error", "U, V orthogonal to", "failures"], body)
    return captioned(file.one("svd/aosoa32/float/cuda/*/random"), "objects of float", table)


STORAGE = {
    "float": "float",
    "quaternion": "rotations as float quaternions",
    "quaternion_half": "and the stress derivative in half",
    "quaternion16_half": "16-bit quaternions, the derivative in half",
    "quaternion16_all_half": "and dF, dP in half",
    "quaternion16": "16-bit quaternions alone",
    "bfloat16_derivative": "the stress derivative in bfloat16 alone",
}


def _storage_in(tiles, storages, others):
    """dP from dF in tiles, in ever fewer bytes, behind other layouts of floats."""

    def table(file):
        layout, space = tiles.split("/")
        aos = file.one(f"dp_from_df/aos/float/{space}/*")
        found = [(words, file.one(f"dp_from_df/{name}/float/{space}/*")) for name, words in others.items()]
        found += [(STORAGE[name], file.one(f"dp_from_df/{layout}/{name}/{space}/*")) for name in storages]
        body = [
            [words, f"{row.counter('bytes_per_object'):.0f}", ms(row), times(aos, row)]
            + [error(row, which) for which in ("p50", "p99", "max")]
            for words, row in found
        ]
        return captioned(aos, "objects", markdown(["storage", "bytes", "ms", "over AoS", "err p50", "p99", "max"], body))

    return table


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
                [words, ms(apart), ms(fused), times(apart, fused), f"{per_tet:.0f}"]
                + [f"{fused.copy_fraction:.2f}", error(fused, "p50"), error(fused, "max")]
            )
        table = markdown("group,separate [ms],fused [ms],,bytes per tet,/copy,err p50,max".split(","), body)
        return captioned(file.one(f"newton_update_fused/{tiles}/*"), "tets in float", table)

    return table


COPY, READ, TRANSFER = "the device's own copy", "a pass that only reads as many bytes", "a plain transfer"
PACKING = "packing such objects into one array of the host, with all its cores"
CONVERSIONS = [
    ("copies between Aos, Soa and Aosoa<32>, objects of 36 and 48 bytes", "convert_*/*_to_*/float/cuda/*", COPY),
    ("such copies that also convert float to half", "convert_*/*_to_*/half/cuda/*", COPY),
    ("transfers with conversion, from and to pinned memory", "transfer_pinned_*/*/*/cuda/*", TRANSFER),
    ("transfers with conversion, from and to pageable memory, in float", "transfer_pageable_*/*/float/cuda/*", TRANSFER),
    ("transfers with conversion, from and to pageable memory, to half", "transfer_pageable_*/*/half/cuda/*", TRANSFER),
    ("objects that lie scattered on the host, to the device", "transfer_scattered_*/*/*/cuda/*", PACKING),
]
DOT_PRODUCTS = [(f"dot product of 2^{k} vectors, in one launch, with the same bits as on the CPU", f"dot_product/*/*/cuda/{2**k}", READ) for k in (24, 22)]


def _rates(operations):
    """The smallest and the largest rate of rows of an operation."""

    def table(file):
        body = []
        for words, pattern, of in operations:
            found = [row.copy_fraction for row in file.all(pattern) if "padded" not in row.layout]
            body.append([words, f"{min(found):.2f} to {max(found):.2f}", of])
        return markdown(["operation", "rate", "of"], body)

    return table


def _transfers(file):
    """Who converts: floats on the host to halves on the device."""
    found = [file.one(f"transfer_{of}_48/aos_to_aosoa32/half/cuda/*") for of in ("pinned", "pageable")]
    table = markdown(["from", "ms"], [[f"{of} memory", ms(row, 1)] for of, row in zip(("pinned", "pageable"), found)])
    return captioned(found[0], "objects of 48 bytes, floats on the host, to halves", table)


def _launches(file):
    """Few objects cost their launch."""
    found = [row for row in file.all("dp_from_df/aosoa32/float/cuda/*") if row.objects <= 2**18]
    return markdown(["objects", *(count(row.objects) for row in found)], [["µs", *(f"{row.ms * 1e3:.1f}" for row in found)]])


def _products(file):
    """The product with the assembled stiffness, ours and that of the vendor's library."""
    names = {
        "symmetric_fast": "symmetric half, with atomics",
        "symmetric_deterministic": "symmetric half, in a fixed order",
        "cusparse_bsr_columns": "cuSPARSE, full blocks by columns",
        "cusparse_bsr_rows": "cuSPARSE, full blocks by rows",
    }
    found = [(words, file.one(f"*/{name}/float/cuda/*")) for name, words in names.items()]
    table = markdown(["product", "ms", "/copy"], [[words, ms(row), f"{row.copy_fraction:.2f}"] for words, row in found])
    return captioned(found[0][1], "nodes", table)


GATHERS = {"ordered": "as the mesh is made", "random": "at random", "renumbered": "random, renumbered"}


def _gathers(file):
    """Nodes that are gathered, in each layout under each numbering."""
    kept = {"aos": "Aos", "aos_padded": "AosPadded", "soa": "Soa", "aosoa32": "Aosoa<32>"}
    body = [
        [words, *(ms(file.one(f"gather_nodes/{layout}/float/cuda/*/{of}")) for layout in kept)] for of, words in GATHERS.items()
    ]
    table = markdown(["numbering", *(f"{name} [ms]" for name in kept.values())], body)
    return captioned(file.all("gather_nodes/*/float/cuda/*/*")[0], "tets", table)


def _sectors(file):
    """Sectors per request, as the model of coalescing counts them."""
    layouts_of = {"aos": "AoS", "soa": "SoA", "aosoa32": "tiles"}
    body = []
    for kernel in ("dp_from_df", "stress_derivative", "deformation_gradient"):
        found = [file.one(f"{kernel}/{layout}/float/cuda/*") for layout in layouts_of]
        body.append([f"`{kernel}`", *(f"{row.counter('sectors_per_request'):.1f}" for row in found)])
    return markdown(["sectors per request", *layouts_of.values()], body)


def _packages(text):
    """Those of tools/packages.txt, which says what its lines are."""
    lines = dict(line.split(maxsplit=1) for line in text.splitlines() if line and line[0] != "#")
    best, *others = lines.pop("LLVM").split()
    del lines["RUN"], lines["MORE"]
    names = {name: name.replace("LLVM", best) + f" (or {', '.join(others)})" * ("LLVM" in name) for name in lines}
    return markdown(["package", "what for"], [[names[name], reason] for name, reason in lines.items()])


def _kernels_in(text):
    """The first and the last kernel of "physgen::fem::A(body.x), ..., physgen::fem::B(...)", or of Fused<...>."""
    names = re.findall(r"physgen::fem::(\w+)", text)
    return f"`{names[0]}` to `{names[-1]}`: {len(names)}"


def _joins(digests):
    """What is one kernel in each scene: by physgen, and by fuse(...) in the code of its steps."""
    body = []
    for scene, found in digests.items():
        joined = [_kernels_in(line.split("; local")[0]) for line in found["joins"] if line.startswith("joined: ")]
        fused = dict.fromkeys(_kernels_in(step.rsplit("(", 1)[0]) for step in found["steps"] if "physgen::Fused<" in step)
        steps = len(dict.fromkeys(step.split("(")[0] for step in found["steps"] if step.startswith("step ")))
        body.append([f"`{scene}`", f"{steps}", "; ".join(joined) or "none", "; ".join(fused) or "none"])
    return markdown(["scene", "kernels", "joined by physgen", "joined by hand, with `fuse(...)`"], body)


def _of_cubes(lines, name):
    """A table of a file of truthcube: `lines` makes its header and rows of the file's content."""
    return lambda text: markdown(*lines(records.parse(text, name), name))


TABLES = {
    "fast": _fast,
    "kernels": _kernels,
    "errors": _errors,
    "storage": _storage_in("aosoa32/cuda", list(STORAGE)[:5], {"aos": "array of structs", "record": "whole records of 48 scalars"}),
    "storage_host": _storage_in("aosoa16/host", ["float", *list(STORAGE)[1:3], *list(STORAGE)[5:]], {"aos": "array of structs"}),
    "conversions": _rates(CONVERSIONS),
    "dot_products": _rates(DOT_PRODUCTS),
    "transfers": _transfers,
    "launches": _launches,
    "products": _products,
    "gathers": _gathers,
    "sectors": _sectors,
    "fused": _fused_in("aosoa32/float/cuda"),
    "fused_host": _fused_in("aosoa16/float/host"),
    "one_thread": _one_thread,
    "packages": _packages,
    "joins": _joins,
    "truthcube": _of_cubes(runs.lines, "runs of truthcube_runs.py"),
    "linear_solves": _of_cubes(linear_solves.lines, "linear_solves.json"),
    "iterations": _of_cubes(linear_solves.iterations, "linear_solves_counts.json"),
    "links": _of_cubes(links.lines, "links.json"),
    "solves_on_ranks": _of_cubes(solves_on_ranks.lines, "solves.json"),
    "layouts": _of_cubes(layouts.lines, "layouts.json"),
    "scenes": _of_cubes(scenes.lines, "scenes.json"),
    "beads": _of_cubes(bead_errors.lines, "runs of truthcube_runs.py --errors"),
}
