"""Made-up results with every kind of row that physbench writes, for the tests of the report: near what an H200 and a
CPU do, but not measured.

    python3 report_test_rows.py > all_kinds.json"""
import json
import math
import sys

TETS, NODES, HOST_TETS = 8388608, 1442897, 1048576
GPU_RATE, CPU_RATE = 4.1e9, 0.25e9  # of a copy [bytes per ms]

# storage -> bytes per object of dP from dF, and p99 and largest error
FORMATS = {
    "float": (192, 4.5e-7, 1.5e-6),
    "double": (384, 8.4e-16, 3.2e-15),
    "quaternion": (152, 9e-7, 3e-6),
    "quaternion_half": (128, 8e-4, 1.3e-3),
    "quaternion16_half": (112, 8.3e-4, 1.4e-3),
    "half": (96, 9e-4, 2e-3),
    "bfloat16": (96, 7e-3, 1.6e-2),
    "unorm16": (96, 2.5e-5, 7e-5),
    "quaternion16_all_half": (76, 9.5e-4, 1.5e-3),
}


def row(name, ms, bytes_per_object, rate, errors=(), **counters):
    objects = int(name.split("/")[4])
    copy_ms = objects * bytes_per_object / rate + 0.0022
    counters.update(
        median_ms=ms,
        min_ms=ms * 0.98,
        copy_ms=copy_ms,
        copy_fraction=copy_ms / ms,
        bytes_per_object=bytes_per_object,
        GBps=objects * bytes_per_object / ms / 1e6,
    )
    counters.update(zip(("err_p50", "err_p99", "err_p9999", "err_max"), errors))
    return {
        "name": name,
        "run_name": name,
        "run_type": "iteration",
        "iterations": 100,
        "real_time": ms,
        "cpu_time": ms,
        "time_unit": "ms",
        **counters,
    }


def kernels_of(name):
    """As physbench writes them, of made-up hashes."""
    kernel, _, _, space, *_ = name.split("/")
    return f"scene/{space}/{kernel} 0123456789abcdef"


def _errors(p99, largest):
    return p99 / 4, p99, (p99 + largest) / 2, largest


def _formats():
    for space, objects, rate, layouts in (
        ("cuda", TETS, GPU_RATE, {"aos": 1.6, "soa": 1.01, "aosoa32": 0.97}),
        ("host", HOST_TETS, CPU_RATE, {"aos": 1.9, "aos_scalar": 1.7, "aosoa16": 1.0}),
    ):
        for storage, (size, p99, largest) in FORMATS.items():
            decoding = 1.0 if storage in ("float", "double") else 1.06 if space == "cuda" else 1.9
            for layout, slower in layouts.items():
                ms = objects * size / rate * slower * decoding
                yield row(
                    f"dp_from_df/{layout}/{storage}/{space}/{objects}",
                    ms,
                    size,
                    rate,
                    _errors(p99, largest),
                    **(_coalescing(layout) if space == "cuda" else {}),
                )
    yield row(f"dp_from_df/record/float/cuda/{TETS}", 1.304, 192, GPU_RATE, _errors(4.5e-7, 1.5e-6))
    yield row(f"dp_from_df/copy/float/cuda/{TETS}", 0.385, 192, GPU_RATE)
    yield row(f"stress_derivative/copy/float/cuda/{TETS}", 0.124, 60, GPU_RATE)
    for layout, ms in (("aos", 1.039), ("soa", 0.145), ("aosoa32", 0.132)):
        yield row(
            f"stress_derivative/{layout}/float/cuda/{TETS}",
            ms,
            60,
            GPU_RATE,
            _errors(1.8e-7, 3e-7),
            **_coalescing(layout),
        )


def _coalescing(layout):
    apart = layout == "aos"
    return {
        "sectors_per_request": 30.2 if apart else 4.0,
        "bytes_per_sector": 4.2 if apart else 31.9,
        "requests_per_transaction": 0.033 if apart else 0.25,
    }


def _conversions():
    layouts = ["aos", "aos_padded", "soa", "aosoa32"]
    for kernel, space, objects, rate in (
        ("convert_36", "cuda", 4194304, GPU_RATE),
        ("convert_48", "cuda", 4194304, GPU_RATE),
        ("convert_host_36", "host", HOST_TETS, CPU_RATE),
    ):
        size = 2 * int(kernel[-2:])
        for i, source in enumerate(layouts):
            for j, target in enumerate(layouts):
                if i != j:
                    fraction = 0.97 - 0.04 * i - 0.07 * j * (space == "host")
                    yield row(
                        f"{kernel}/{source}_to_{target}/float/{space}/{objects}",
                        objects * size / rate / fraction,
                        size,
                        rate,
                    )
    for kernel, rate in (("transfer_pinned", 0.055e9), ("transfer_pageable", 0.012e9), ("transfer_scattered", 0.052e9)):
        for k, pair in enumerate(("aos_to_aosoa32", "aos_to_soa", "aosoa32_to_aos")):
            yield row(f"{kernel}/{pair}/float/cuda/4194304", 4194304 * 36 / rate / (0.98 - 0.06 * k), 36, rate)


def _gathered():
    for name, factors in (
        ("ordered", (1.0, 1.0, 1.02, 1.0)),
        ("random", (1.98, 1.62, 3.72, 2.4)),
        ("renumbered", (1.08, 1.05, 1.15, 1.1)),
    ):
        for layout, factor in zip(("aos", "aos_padded", "soa", "aosoa32"), factors):
            yield row(
                f"gather_nodes/{layout}/float/cuda/4400000/{name}",
                0.1 * factor,
                90,
                GPU_RATE,
                sectors_per_request=4.5 * factor,
            )


def _growth():
    for kernel, size in (("dp_from_df", 192), ("stress_derivative", 60), ("svd", 120)):
        for layout, slower in (("aos", 7.8 if size == 60 else 1.7), ("soa", 1.02), ("aosoa32", 1.0)):
            for power in range(10, 25):
                if 2**power != TETS or kernel == "svd":
                    ms = math.hypot(0.0023, 2**power * size * slower / GPU_RATE)
                    yield row(f"{kernel}/{layout}/float/cuda/{2**power}", ms, size, GPU_RATE, _errors(4e-7, 1e-6))


def _force_differential():
    for storage, factor, size in (("float", 1.0, 470), ("double", 1.7, 766)):
        for layout, ms, bytes_moved in (
            ("aos", 0.487, size),
            ("soa", 1.342, size),
            ("aosoa32", 1.251, size),
            ("symmetric_fast", 0.121, size / 2),
            ("symmetric_deterministic", 0.168, size / 2),
            ("cusparse_bsr_columns", 0.43, size * 1.1),
            ("cusparse_bsr_rows", 0.44, size * 1.1),
        ):
            yield row(
                f"add_force_differential/{layout}/{storage}/cuda/{NODES}",
                ms * factor,
                bytes_moved,
                GPU_RATE,
                _errors(7e-5, 1.5e-3),
                **(_coalescing(layout) if storage == "float" else {}),
            )


def _sets():
    for space, rate, layout in (("cuda", GPU_RATE, "aosoa32"), ("host", CPU_RATE, "aosoa16")):
        for k, kernel in enumerate(("svd", "svd_3_sweeps", "svd_quaternions", "polar_rotation", "stress_derivative")):
            for storage in ("float", "double"):
                for s, name in enumerate(("random", "near_rest", "hard")):
                    largest = (
                        (3 + k) * (1 + s) * (1e9 if kernel == "svd_3_sweeps" and storage == "double" and s == 2 else 1)
                    )
                    yield row(
                        f"{kernel}/{layout}/{storage}/{space}/{HOST_TETS}/{name}",
                        0.03 * (1 + k / 8) * GPU_RATE / rate,
                        120,
                        rate,
                        err_eps_p50=0.5,
                        err_eps_p99=2.0 + k,
                        err_eps_p9999=2.5 + k,
                        err_eps_max=largest,
                        orth_eps_max=6.0,
                        failures=float(largest > 1e6),
                        samples=65536.0,
                    )


def results():
    """All of it, as physbench of this checkout would write it."""
    benchmarks = [*_formats(), *_conversions(), *_gathered(), *_growth(), *_force_differential(), *_sets()]
    benchmarks.append(
        {
            "name": f"svd/cusolver/float/cuda/{HOST_TETS}/hard",
            "run_type": "iteration",
            "error_occurred": True,
            "error_message": "libcusolver.so <was> not found",
        }
    )
    benchmarks.append({**row(f"svd/aos/float/cuda/{TETS}", 2.1, 120, GPU_RATE), "run_type": "aggregate"})
    for entry in benchmarks:
        entry["kernels"] = kernels_of(entry["name"])
    return {
        "context": {
            "date": "2026-01-02T03:04:05+00:00",
            "command": "physbench --benchmark_filter=.|/(x) --json=a.json",
            "compiler": "g++ 12.2.0",
            "cpu": "Made-up(R) CPU",
            "gpu": "Made-up GPU, 100 multiprocessors",
            "physgen": "0.1.0",
            "results_version": "1",
            "threads": "8, packs of 16 float or 8 double",
        },
        "benchmarks": benchmarks,
    }


if __name__ == "__main__":
    json.dump(results(), sys.stdout, indent=1)


def measured_again(content):
    """The same rows with other times, errors, sizes and counts, as if all had been measured on another machine."""
    for number, row in enumerate(content["benchmarks"]):
        factor = 1.7 + 0.3 * (number % 5)
        parts = row["name"].split("/")
        row["name"] = "/".join([*parts[:4], str(int(parts[4]) * 4), *parts[5:]])
        for name, value in row.items():
            if isinstance(value, (int, float)):
                row[name] = value * factor + 3 if name in ("failures", "iterations", "samples") else value * factor
    content["context"]["threads"] = "6, packs of 8 float or 4 double"
    for cache in content["context"]["caches"]:
        cache["size"] *= 3
    return content
