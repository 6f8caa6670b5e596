"""What a whole solve of truthcube on several ranks exchanges: ranks_counts_test.py MPIRUN|none TRUTHCUBE CASE."""
import re

from ranks_runs import FOLDER, SCENE, TRUTHCUBE, command, done, expect_same, record, run_and_remove


def a_nested_solve_of_two_cut_meshes_has_few_operations_and_the_bits_of_one_process():
    """Of 24^3 cells, whose mesh of 12^3 is cut, too: on two ranks of two threads, and on eight of a block each. An operation is an exchange
    or a gather. Scaled to 21 iterations and 4 Newton steps on the finest mesh, as 144^3 cells take, they are 700 at most."""
    words = ("--cells", "24", "--volume", "tets", "--poisson", "0.45", "--compress", "0.1")
    cut = ("--replicate", "1000")
    done(0, TRUTHCUBE, *SCENE, *words, "--out", str(FOLDER / "one"))
    for count, threads in ((2, "2"), (8, "1")):
        done(0, *command(count, *words, *cut, "--threads", threads, "--out", str(FOLDER / str(count))))
        expect_same(FOLDER / "one", FOLDER / str(count))
    output = done(0, *command(2, *words, *cut, "--dry-run"))
    exchanges, gathers = map(int, re.search(r"in a PCG iteration: (\d+) exchanges, (\d+) gathers", output).groups())
    assert 0 < exchanges <= 6 * 2 and 0 < gathers <= 3, output
    sent = [list(map(int, line.split()[:2])) for line in output.splitlines() if re.match(r" +\d+( +\d+){3}  \S+$", line)]
    assert [rank for rank, _ in sent] == [0, 1] and all(0 < messages <= exchanges for _, messages in sent), sent  # to one neighbour

    run, ranks = record(FOLDER / "2")
    newton = run["steps"][0]["newton"]
    iterations = [sum(step["pcg_iterations"] for step in newton if step["coarser_by"] == by) for by in (0, 1)]
    steps = [sum(step["coarser_by"] == by for step in newton) for by in (0, 1)]
    assert min(iterations) > 3 and min(steps) > 1, newton
    assert ranks["messages"] <= 2 * ranks["exchanges"], ranks
    operations = ranks["exchanges"] + ranks["gathers"]
    of_iteration = exchanges + gathers  # on 12^3 cells, below which nothing is cut, six exchanges less
    beside = operations - of_iteration * iterations[0] - (of_iteration - 6) * iterations[1]
    scaled = operations + of_iteration * (21 - iterations[0]) + beside / sum(steps) * (4 - steps[0])
    print(f"{operations} operations in {iterations} iterations and {steps} Newton steps, beside iterations {beside}; scaled {scaled:.0f}")
    assert beside > 0 and scaled <= 700, scaled


run_and_remove(globals())
