"""Pieces of the solver on several ranks: ranks_test.py MPIRUN|none FOLDER CASE."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "runtime" / "distributed"))
from ranks import program, ranks, run, run_case  # noqa: E402


def result(done):
    """What a solve ended with, and what has crossed."""
    status, output, errors, _ = done
    assert status == 0, f"status {status}: {output}{errors}"
    found = re.match(r"(digest \S+ iterations \d+ status \d+ rz \S+ alpha \S+) exchanges (\d+) bytes (\d+) gathers (\d+)(.*)", output)
    assert found, output
    return found.group(1), [int(found.group(k)) for k in (2, 3, 4)], found.group(5)


def conjugate_gradients_have_the_bits_of_one_process():
    """Conjugate gradients with block Jacobi have the bits of one process: displacements, r . z and the length of the last step."""
    wanted = result(run(program("conjugate_gradients_without_mpi")))[0]
    print(wanted)
    iterations = int(re.search(r"iterations (\d+)", wanted).group(1))
    assert 10 < iterations < 300 and "status 1" in wanted, wanted
    for count in (1, 2, 4):
        found, (exchanges, known_bytes, gathers), unknown = result(ranks(count, "conjugate_gradients"))
        print(f"{count} ranks: {exchanges} exchanges, {known_bytes} bytes, {gathers} gathers")
        assert found == wanted, f"{count} ranks: {found}"
        assert not unknown, unknown
        if count == 1:
            continue
        # Two make the plans; then directions cross for each product, and nothing else. Two sums in each iteration.
        assert exchanges == 2 + iterations and gathers == 1 + 2 * iterations, (exchanges, gathers)
        # Without rows for the product more crosses with them, and nothing is missing.
        found, (_, all_bytes, _), unknown = result(ranks(count, "conjugate_gradients", "--table", "0"))
        assert found == wanted and "SymmetricProduct" in unknown and all_bytes > known_bytes, (found, unknown, all_bytes)
    for cells in ("1", "5"):  # ranks without nodes
        assert result(ranks(4, "conjugate_gradients", "--cells", cells))[0] == result(run(program("conjugate_gradients_without_mpi"), "--cells", cells))[0]


sys.exit(run_case(globals()))
