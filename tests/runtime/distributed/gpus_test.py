"""Programs on several GPUs, started as users start them: gpus_test.py MPIRUN|none FOLDER CASE. Skipped where there are too few."""
import re
import sys

from ranks import program, ranks, run, run_case

SKIPPED = 77


def devices():
    return int(run(program("links_gpu"), "--devices")[1])


def skip_below(count):
    """Ends the test where there are fewer GPUs."""
    if devices() < count:
        print(f"skipped: it needs {count} GPUs, and there are {devices()}")
        sys.exit(SKIPPED)


def digest(done):
    status, output, errors = done
    assert status == 0, f"status {status}: {output}{errors}"
    return re.match(r"digest \S+ square \S+ node \S+ steps \S+", output).group(0)


def succeeds(done):
    status, output, errors = done
    print(output + errors)
    assert status == 0, f"status {status}: {output}{errors}"
    return output + errors


def fails(done, *texts):
    status, output, errors = done
    assert status != 0, f"status 0: {output}{errors}"
    for text in texts:
        assert text in errors, f"'{text}' is not in: {errors}"


def have_the_bits_of_the_host(counts, environment):
    """All numbers of ranks, by all transports, with and without a table."""
    for more in ((), ("--near",), ("--cells", "1"), ("--cells", "40")):
        wanted = digest(run(program("relax_without_mpi"), "--plain", *more))
        assert digest(run(program("relax_gpu"), "--plain", *more)) == wanted, "one process without anything of distributed/"
        assert digest(run(program("relax_gpu"), *more)) == wanted, "one rank"
        for count in counts:
            for way in ((), ("--pinned",), ("--no-table",)):
                done = ranks(count, "relax_gpu", *more, *way, environment=environment)
                assert digest(done) == wanted, f"{count} ranks {way} {more}: {done}"
                print(f"{count} ranks {way} {more}: {done[1].strip()}")
                if more == ("--near",) and not way and count in (2, 3):
                    assert "overlapped 19" in done[1], done[1]


def ranks_that_share_a_gpu_have_the_bits_of_the_host():
    """Also on one GPU: 2, 3 and 5 ranks share it, through pinned memory and MPI."""
    skip_below(1)
    have_the_bits_of_the_host((2, 3, 5), {"PHYSGEN_SHARE_GPU": "1"})
    for count, first in ((2, 0), (3, 20), (5, 40)):
        succeeds(ranks(count, "graphs_gpu", "--seeds", str(first), str(first + 20), environment={"PHYSGEN_SHARE_GPU": "1"}))


def two_gpus_have_the_bits_of_the_host():
    """By NCCL and through pinned memory."""
    skip_below(2)
    have_the_bits_of_the_host((2,), {})
    assert " by NCCL 2." in ranks(2, "relax_gpu")[1]


def random_programs_on_two_gpus_have_the_bits_of_one():
    """Owned objects and fresh ghosts, by both transports."""
    skip_below(2)
    for seeds in (("0", "14"), ("14", "27"), ("27", "40"), ("60", "80", "--pinned")):  # NCCL connects for each program, for seconds
        succeeds(ranks(2, "graphs_gpu", "--seeds", *seeds))
    output = succeeds(ranks(2, "graphs_gpu", "--seeds", "200", "206", "--most", "30000"))
    assert int(re.search(r"(\d+) exchanges overlapped", output).group(1)) > 0


def a_row_that_is_left_out_is_missed_on_gpus():
    """So stale ghosts are poisoned on devices, too."""
    skip_below(1)
    for row in ("0", "2", "6"):
        status, output, errors = ranks(3, "graphs_gpu", "--seeds", "0", "24", "--most", "9000", "--without", row,
                                          environment={"PHYSGEN_SHARE_GPU": "1"})
        assert status != 0, f"without row {row} of the table nothing differs: {output}{errors}"


def two_ranks_on_one_gpu_are_refused():
    """One rank more than there are GPUs."""
    skip_below(1)
    count = devices() + 1
    fails(ranks(count, "relax_gpu"), "would share a GPU", "PHYSGEN_SHARE_GPU=1")


def without_nccl_pinned_memory_is_taken_and_said_once():
    """NCCL is hidden; the results stay."""
    skip_below(2)
    done = ranks(2, "relax_gpu", environment={"PHYSGEN_NCCL": "/nowhere/libnccl.so.2"})
    assert digest(done) == digest(ranks(2, "relax_gpu"))
    assert "by pinned memory and MPI" in done[1], done
    assert done[2].count("without NCCL: rank 0: /nowhere/libnccl.so.2") == 1, done


def a_rank_that_cannot_go_on_ends_all_gpus():
    """A killed rank, and a GPU without memory."""
    skip_below(2)
    for way in ((), ("--pinned",)):
        fails(ranks(2, "relax_gpu", "--steps", "2000", "--kill", "1", *way), "rank 1", "signal 9")
    fails(ranks(2, "relax_gpu", "--fill", "1"), "rank 1 of 2 on ", "out of memory")


def links_are_measured():
    """Every size, by every way; all bytes are right."""
    skip_below(2)
    lines = [line for line in succeeds(ranks(2, "links_gpu")).splitlines() if line.startswith("{")]
    assert len(lines) == 4 * 6, lines


if __name__ == "__main__":
    sys.exit(run_case(globals()))
