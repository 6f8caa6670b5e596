"""Programs on several ranks, started as users start them: ranks_test.py MPIRUN|none FOLDER CASE."""
import os
import pathlib
import re
import subprocess
import sys
import time

from ranks import ENVIRONMENT, MPIRUN, SECONDS, program, ranks, run, run_case

COUNTS = (1, 2, 3, 4, 8)


def digest(done):
    status, output, errors = done
    assert status == 0, f"status {status}: {output}{errors}"
    return re.match(r"digest \S+ square \S+ node \S+ steps \S+", output).group(0)


def fails(done, *texts):
    status, output, errors = done
    assert status != 0, f"status 0: {output}{errors}"
    for text in texts:
        assert text in errors, f"'{text}' is not in: {errors}"


def all_numbers_of_ranks_have_the_bits_of_one_process():
    """All numbers of ranks and threads give the bits of whole arrays in one process, also of the build without MPI."""
    wanted = digest(run(program("relax_without_mpi"), "--plain"))
    assert digest(run(program("relax_without_mpi"))) == wanted
    assert digest(run(program("relax"))) == wanted, "without mpirun"
    for count in COUNTS:
        assert digest(ranks(count, "relax")) == wanted, f"{count} ranks"
        print(f"{count} ranks: {wanted}")
    assert digest(ranks(2, "relax", "--threads", "2")) == wanted, "2 threads"
    # Without a table more is fetched, and nothing is missing.
    known, by_hand, unknown = ranks(3, "relax"), ranks(3, "relax", "--by-hand"), ranks(3, "relax", "--no-table")
    assert digest(by_hand) == wanted and digest(unknown) == wanted
    exchanges = [int(re.search(r"exchanges (\d+)", done[1]).group(1)) for done in (known, by_hand, unknown)]
    # Without far edges most edges of a rank are inner ones, and are pulled while positions cross.
    near = run(program("relax_without_mpi"), "--plain", "--near")
    for count in (2, 3):
        done = ranks(count, "relax", "--near")
        assert digest(done) == digest(near), f"{count} ranks"
        assert "overlapped 19" in done[1], done[1]
    # Positions cross once for each step but the first.
    assert exchanges[0] == exchanges[1] == 19 and exchanges[2] > exchanges[0], exchanges
    assert "unknown springs::Pull" in unknown[1] and "unknown" not in known[1]
    # More ranks than there are blocks, and hardly any nodes: ranks without objects work.
    for cells in ("1", "3"):
        assert digest(ranks(4, "relax", "--cells", cells)) == digest(run(program("relax_without_mpi"), "--plain", "--cells", cells))


def random_programs_over_random_graphs_have_them_too():
    """Random programs over random graphs: owned objects and fresh ghosts have the bits of one process."""
    for k, count in enumerate((1, 2, 3, 4, 8)):
        first = 40 * k
        status, output, errors = ranks(count, "graphs", "--seeds", str(first), str(first + 40))
        print(output)
        assert status == 0, output + errors
    status, output, errors = ranks(4, "graphs", "--seeds", "200", "212", "--most", "30000")
    print(output)
    assert status == 0, output + errors
    assert int(re.search(r"(\d+) exchanges overlapped", output).group(1)) > 0, output


def ranks_need_to_know_no_more_objects_than_they_have():
    """Ranks that know what they have name the same as those that know all, also with threads; one less is refused by name."""
    for k, count in enumerate((1, 2, 3, 4, 8)):
        for threads in ("1", "3"):
            first = 30 * k
            status, output, errors = run(MPIRUN, "--oversubscribe", "-n", str(count), program("known"), "--seeds", str(first),
                                            str(first + 30), environment={"OMP_NUM_THREADS": threads})
            assert status == 0 and output.count(" 0 differences") == count, f"{count} ranks, {threads} threads: {output}{errors}"
    for lacking in ("node", "edge", "quad", "group"):
        done = ranks(3, "known", "--seeds", "0", "30", "--lacks", lacking)
        fails(done, "let ", " know more")
        print(lacking, re.search("physgen: .*", done[2]).group(0))


def cut_decides_what_a_search_over_all_objects_does():
    """Runs, ghosts, what leads to ghosts and local numbers are those that a search finds which leaves out no object."""
    for k, count in enumerate((1, 2, 3, 4, 8)):
        for threads in ("1", "3"):
            first = 24 * (2 * k + int(threads) // 2)
            status, output, errors = ranks(count, "cuts", "--seeds", str(first), str(first + 24), environment={"OMP_NUM_THREADS": threads})
            print(output)
            assert status == 0 and output.count(" 0 differences") == count, f"{count} ranks, {threads} threads: {output}{errors}"
            asked = [tuple(map(int, pair)) for pair in re.findall(r"(\d+) edges were asked (\d+) times", output)]
            edges, times = (sum(numbers) for numbers in zip(*asked))
            # Once for the bounds of all, once for the numbers of a rank's own, and a few at its ends.
            assert edges > 0, "no seed has nodes on all ranks"
            assert times <= (1 + 2 / count) * edges, f"{count} ranks: {times} questions for {edges} edges"


def a_row_of_the_table_that_is_left_out_is_missed():
    """Each row of the table that an exchange or a stale field depends on is missed when it is left out."""
    status, output, errors = ranks(3, "graphs", "--seeds", "0", "24", "--most", "9000", "--without", "each")
    print(output)
    assert status == 0, output + errors
    missed, rows = (int(number) for number in re.search(r"each of (\d+) rows of (\d+) is missed", output).groups())
    assert 20 < missed < rows, output


def a_plan_that_lacks_an_object_is_missed():
    """Of sets there are several plans, and the first four are missed, each, when they lack an object of each message."""
    seeds = "--seeds", "72", "96"  # several of these programs read a lacking object, whichever of the four needs has it
    status, output, errors = ranks(3, "graphs", *seeds)
    assert status == 0, output + errors
    needs = range(1, 5)  # need 0 is of all ghosts; later ones join others, and cross once or twice in so short programs
    assert int(re.search(r"(\d+) needs of a set", output).group(1)) > max(needs), output
    for need in needs:
        status, output, errors = ranks(3, "graphs", *seeds, "--lacking", str(need))
        assert status == 3, f"nothing differs where need {need} of each set lacks objects: {output}{errors}"
        print(output)


def left_over():
    """Processes of this test that still run, among those of other tests."""
    mark, found = f"PHYSGEN_STARTED_BY={os.getpid()}".encode(), []
    for process in os.listdir("/proc"):
        try:
            if process.isdigit() and mark in pathlib.Path("/proc", process, "environ").read_bytes().split(b"\0"):
                found.append(process)
        except OSError:
            pass
    return found


def left_over_becomes(wanted):
    """Waits until just these run: a process that starts has no environment yet, and one that ends still has it."""
    until = time.monotonic() + SECONDS
    while left_over() != wanted:
        assert time.monotonic() < until, left_over()
        time.sleep(0.1)


def a_rank_that_cannot_go_on_ends_all():
    """One rank that cannot go on ends all, with its message."""
    with subprocess.Popen(["sleep", str(2 * SECONDS)], env=ENVIRONMENT) as other:
        left_over_becomes([str(other.pid)])
        other.kill()
    fails(ranks(4, "relax", "--throw", "1"), "rank 1 of 4 on ", "physgen: node ", " may not move")
    fails(ranks(4, "relax", "--kill", "2"), "rank 2", "signal 9")
    for first in (0, 2):  # what several ranks find is said by the lowest
        done = ranks(4, "relax", "--fail", str(first))
        fails(done, f"rank {first} of 4 on ", "the springs cannot be found")
        assert done[2].count("the springs cannot be found") == 1, done
    left_over_becomes([])


def what_cannot_work_is_refused_with_the_remedy():
    """What cannot work is refused with the remedy."""
    one = [program("relax"), "--cells", "4"]
    both = run(MPIRUN, "--oversubscribe", "-n", "2", *one, "--options", "a", ":", "-n", "1", *one, "--options", "b")
    fails(both, 'rank 2 on ', 'has another option: "b", and rank 0 has "a"; start all ranks with equal programs, options and files')
    both = run(MPIRUN, "--oversubscribe", "-n", "1", *one, ":", "-n", "1", *one, "--build", "physgen 0.0, compiler of another machine")
    fails(both, 'rank 1 on ', 'has another build: "physgen 0.0, compiler of another machine", and rank 0 has "physgen ', "equal programs")
    fails(ranks(2, "relax", "--sizes", "1"), "has another list of sets and sizes", "node:15625")
    # The launcher of another MPI starts programs of which each would be rank 0.
    fails(run(program("relax"), environment={"PMI_SIZE": "4"}), "PMI_SIZE=4", "start it with the mpirun of Open MPI")
    fails(ranks(2, "relax_without_mpi"), "OMPI_COMM_WORLD_SIZE=2", "physgen was built without MPI; install libopenmpi-dev")


sys.exit(run_case(globals()))
