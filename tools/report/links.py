"""The table of what crossing costs between GPUs, of the rows that distributed_links_gpu prints, a line of JSON each."""
from truthcube.records import RunError

WAYS = [
    ("NCCL, in a graph of 4 rounds", "NCCL", "graph of 4 rounds"),
    ("NCCL, step by step", "NCCL", "step by step"),
    ("pinned memory and MPI", "pinned", "step by step"),
]


def lines(file, name):
    """Header and rows: medians in microseconds, an exchange and a gather of as many bytes of each rank.

    @throws RunError where a row is missing"""
    sizes = sorted({row["bytes"] for row in file["rows"]})
    body = []
    for words, by, how in WAYS:
        body.append([words, *(" and ".join(_us(file, name, what, by, how, size) for what in ("exchange", "gather")) for size in sizes)])
    return ["µs for an exchange and for a gather", *(f"{size:,} bytes" for size in sizes)], body


def _us(file, name, what, by, how, size):
    wanted = {"what": what, "how": how, "bytes": size}
    found = [row["us"] for row in file["rows"] if row["by"].startswith(by) and wanted.items() <= row.items()]
    if len(found) != 1:
        raise RunError(f"{name} has {len(found)} rows of {what} by {by}, {how}, {size} bytes; measure it again")
    return f"{found[0]:.1f}"
