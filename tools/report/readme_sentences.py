"""Figures in sentences of READMEs: each is a `{}` in SENTENCES; around it stand the words as the README has them.

A figure is found by the names of rows, `kernel/layout/storage/space/objects[/set]`, where `*` stands for anything
within a part (`File` in readme_numbers.py)."""
from dataclasses import dataclass

from readme_tables import copy_fractions, count, error, limits, mebibytes, ms

MEASURED = "tools/report/results/README.md"  # most figures stand there


@dataclass(frozen=True)
class Sentence:
    readme: str
    file: str  # of results
    words: str  # as the README has them, with `{}` for each figure; line breaks count as spaces
    figures: object  # File -> texts, one for each `{}`


def _schemes(file):
    rows = {row.storage: row for row in file.all("dp_from_df/aosoa16/*/host/*")}
    return [ms(rows[name], 2) for name in ("quaternion16", "bfloat16_derivative")]


def _xeon(file):
    rows = [file.one(f"dp_from_df/{name}/host/*") for name in ("aos/float", "aosoa16/float")]
    rows += [file.one(f"dp_from_df/aosoa16/{name}/host/*") for name in ("quaternion", "quaternion_half")]
    return [ms(row, 2) for row in rows]


def _xeon_cache(file):
    floats = file.one("dp_from_df/aosoa16/float/host/*")
    return [f"{mebibytes(floats):.0f}", f"{max(cache['size'] for cache in file.context['caches']) / 2**20:.0f}"]


def _small_launches(file):
    rows = [row for row in file.all("dp_from_df/aosoa32/float/cuda/*") if row.objects < 2**16]
    return limits((row.ms * 1e3 for row in rows), ".1f")


def _gathers(file):
    wanted = ["aos_padded/random", "soa/random", "aos_padded/renumbered"]
    return [ms(file.one("gather_nodes/{}/float/cuda/*/{}".format(*name.split("/")))) for name in wanted]


def _forces(file):
    ours = [ms(file.one(f"*/symmetric_{mode}/float/cuda/*")) for mode in ("fast", "deterministic")]
    library = min(file.all("*/cusparse_*/float/cuda/*"), key=lambda row: row.ms)
    return [*ours, ms(library), count(library.objects)]


def _whole_records(file):
    last = file.one("dp_from_df/aosoa32/quaternion16_all_half/cuda/*")
    record = file.one("dp_from_df/record/float/cuda/*")
    return [
        count(last.objects),
        ms(file.one("dp_from_df/aos/float/cuda/*")),
        ms(record, 2),
        f"{record.ms / last.ms:.1f}",
    ]


def _sectors(file):
    kernels, layouts = ("dp_from_df", "stress_derivative", "deformation_gradient"), ("aos", "soa", "aosoa32")
    rows = [file.one(f"{kernel}/{layout}/float/cuda/*") for kernel in kernels for layout in layouts]
    return [f"{row.counter('sectors_per_request'):.1f}" for row in rows]


def _element_speed_ups(file):
    elements = file.one("dp_from_df/aosoa32/float/cuda/*").objects
    rows = file.all(f"*/aosoa32/float/cuda/{elements}")
    return limits((file.one(f"{row.kernel}/aos/float/cuda/{elements}").ms / row.ms for row in rows), ".1f")


def _sweeps(file):
    in_float, in_double = (file.all(f"svd_3_sweeps/aosoa32/{real}/cuda/*/*") for real in ("float", "double"))
    largest = max(row.counter("err_eps_max") for row in in_float)
    return [f"{largest:.1f}", f"{max(row.error('max') for row in in_double):.1e}"]


SENTENCES = [
    Sentence(
        MEASURED,
        "h200.json",
        "H200, float, {} objects, median; `/copy`",
        lambda file: [count(file.one("dp_from_df/aosoa32/float/cuda/*").objects)],
    ),
    Sentence(
        MEASURED,
        "h200.json",
        "run over the mesh's {} nodes, `edge_stiffness` over its {} edges",
        lambda file: [count(file.one(f"{name}_stiffness/aosoa32/float/cuda/*").objects) for name in ("node", "edge")],
    ),
    Sentence(
        MEASURED,
        "h200_errors.json",
        "H200, float, {} objects, the largest errors of all three sets, and",
        lambda file: [count(file.one("svd/aosoa32/float/cuda/*/random").objects)],
    ),
    Sentence(
        MEASURED,
        "h200.json",
        "over three arrays of 36, 12 and 36 bytes it takes {} ms",
        lambda file: [ms(file.one("svd/aos_three_arrays/float/cuda/*"))],
    ),
    Sentence(
        MEASURED,
        "h200.json",
        "each of which stores what the next one reads, take {} ms in tiles and {} ms as AoS",
        lambda file: [ms(file.one(f"force_chain_separate/{layout}/float/cuda/*")) for layout in ("aosoa32", "aos")],
    ),
    Sentence(
        MEASURED,
        "h200_errors.json",
        "{} eps means not orthogonal at all",
        lambda file: [f"{max(row.counter('orth_eps_max') for row in file.all('svd/cusolver/float/cuda/*/*')):.0e}"],
    ),
    Sentence(
        MEASURED,
        "h200_storage.json",
        "dP from dF on the H200, {} objects, AoSoA-32; times are compared with an array of structs of floats ({} ms) in "
        "the same run. Whole records of 48 scalars take {} ms, {} times the last row.",
        _whole_records,
    ),
    Sentence(
        MEASURED,
        "xeon_storage.json",
        "({} threads of a Xeon, AVX-512, {} objects, AoSoA-16;",
        lambda file: [
            file.context["threads"].split(",")[0],
            count(file.one("dp_from_df/aosoa16/float/host/*").objects),
        ],
    ),
    Sentence(MEASURED, "xeon_storage.json", "The {} MiB of floats fit into its L3 cache of {} MiB", _xeon_cache),
    Sentence(
        MEASURED,
        "xeon_storage.json",
        "AoS takes {} ms, AoSoA of floats {} ms, float quaternions {} ms, and with the derivative in half {} ms.",
        _xeon,
    ),
    Sentence(
        MEASURED,
        "xeon_storage.json",
        "16-bit quaternions take {} ms, bfloat16 {} ms",
        _schemes,
    ),
    Sentence(
        MEASURED,
        "h200_conversions.json",
        "| copies between Aos, Soa and Aosoa<32>, objects of 36 and 48 bytes | {} to {} |",
        lambda file: limits(
            row.copy_fraction for row in file.all("convert_*/*_to_*/float/cuda/*") if "padded" not in row.layout
        ),
    ),
    Sentence(
        MEASURED,
        "h200_conversions.json",
        "| such copies that also convert float to half | {} to {} |",
        lambda file: copy_fractions(file, "convert_*/*_to_*/half/cuda/*"),
    ),
    Sentence(
        MEASURED,
        "h200_conversions.json",
        "| transfers with conversion, from and to pinned memory | {} to {} |",
        lambda file: copy_fractions(file, "transfer_pinned_*/*/*/cuda/*"),
    ),
    Sentence(
        MEASURED,
        "h200_conversions.json",
        "| transfers with conversion, from and to pageable memory, in float | {} to {} |",
        lambda file: copy_fractions(file, "transfer_pageable_*/*/float/cuda/*"),
    ),
    Sentence(
        MEASURED,
        "h200_conversions.json",
        "| transfers with conversion, from and to pageable memory, to half | {} to {} |",
        lambda file: copy_fractions(file, "transfer_pageable_*/*/half/cuda/*"),
    ),
    Sentence(
        MEASURED,
        "h200_conversions.json",
        "| objects that lie scattered on the host, to the device | {} to {} |",
        lambda file: copy_fractions(file, "transfer_scattered_*/*/*/cuda/*"),
    ),
    Sentence(MEASURED, "h200_growth.json", "launch, {} to {} µs however few they are", _small_launches),
    Sentence(
        MEASURED,
        "h200_reduce.json",
        "| dot product of 2^24 vectors, in one launch, with the same bits as on the CPU | {} to {} |",
        lambda file: copy_fractions(file, f"dot_product/*/*/cuda/{2**24}"),
    ),
    Sentence(
        MEASURED,
        "h200_reduce.json",
        "| dot product of 2^22 vectors | {} to {} |",
        lambda file: copy_fractions(file, f"dot_product/*/*/cuda/{2**22}"),
    ),
    Sentence(
        MEASURED,
        "h200_forces.json",
        "takes {} ms from its symmetric half with atomics and {} ms in a fixed order, cuSPARSE's best {} ms over full "
        "blocks ({} nodes,",
        _forces,
    ),
    Sentence(
        MEASURED,
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
        lambda file: [count(file.one("*/symmetric_fast/float/cuda/*").objects)],
    ),
    Sentence(
        "tools/physbench/README.md",
        "h200_conversions.json",
        "{} objects of 48 bytes, floats on the host, to halves on an H200: {} ms from pinned memory, {} ms from "
        "pageable memory",
        lambda file: [
            count(file.one("transfer_pinned_48/aos_to_aosoa32/half/cuda/*").objects),
            *(ms(file.one(f"transfer_{of}_48/aos_to_aosoa32/half/cuda/*"), 1) for of in ("pinned", "pageable")),
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
        lambda file: [count(file.one("svd/aosoa32/float/cuda/*/random").objects)],
    ),
    Sentence(
        "tools/physbench/README.md",
        "h200_errors.json",
        "The first {} objects differ",
        lambda file: [count(file.one("svd/aosoa32/float/cuda/*/random").counter("samples"))],
    ),
    Sentence("tools/examples/kernels.md", "h200.json", "H200: {} to {} times as fast as `aos`", _element_speed_ups),
    Sentence(
        "tools/examples/kernels.md",
        "h200_gathers.json",
        "H200, random numbers: {} ms against {} ms as `soa`",
        lambda file: [ms(file.one(f"gather_nodes/{name}/float/cuda/*/random"), 2) for name in ("aos_padded", "soa")],
    ),
    Sentence(
        "tools/examples/kernels.md",
        "h200.json",
        "H200: `add_force_differential` {} ms against {} ms in tiles",
        lambda file: [ms(file.one(f"add_force_differential/{name}/float/cuda/*"), 2) for name in ("aos", "aosoa32")],
    ),
]
