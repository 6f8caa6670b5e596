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


def newton(done):
    """What a solve printed, but for what has crossed; its steps; exchanges and gathers of each of them; and numbers by name."""
    status, output, errors, _ = done
    assert status == 0, f"status {status}: {output}{errors}"
    lines = output.splitlines()
    beside = ("traffic ", "chunks ", "unknown ")
    steps = [dict(zip(found[::2], map(int, found[1::2]))) for found in
             (re.findall(r"\w+", line)[:8] for line in lines if line.startswith("step") and " iterations " in line)]
    traffic = [tuple(map(int, re.findall(r"\d+", line))) for line in lines if line.startswith("traffic ")]
    return [line for line in lines if not line.startswith(beside)], steps, traffic, [line for line in lines if line.startswith(beside[1:])]


def newton_has_the_bits_of_one_process():
    """Newton's method has the bits of one process that goes its ordinary way: of each step, of the last linear solve, positions, forces and stiffness."""
    for cells, counts in (("20", (1, 2, 3, 4)), ("12", (2, 4)), ("3", (4,))):  # of 12 cells two ranks own nodes, of 3 one
        wanted, steps, _, chunks = newton(run(program("newton_without_mpi"), "--cells", cells, "--ordinary", "1"))
        print("\n".join(wanted))
        assert len(steps) >= 3 and "result status 0" in "\n".join(wanted)
        assert all(step["iterations"] > 10 and step["halvings"] == step["filtered"] == 0 for step in steps), steps
        if cells == "20":
            assert chunks == ["chunks 3"], chunks
        found, _, _, _ = newton(run(program("newton_without_mpi"), "--cells", cells))
        assert found == wanted, found
        for count in counts:
            found, _, traffic, unknown = newton(ranks(count, "newton", "--cells", cells))
            assert found == wanted, f"{count} ranks: {found}"
            assert not unknown, unknown
            if count == 1:
                continue
            print(f"{count} ranks: exchanges and gathers of each step {traffic}")
            # Directions cross for each product, and positions once for each step. Two sums in each iteration; and in each step one before
            # the first, of the work, and of what evaluates its end: energy, forces, and the least volume. The first evaluates its beginning.
            for step, (exchanges, gathers) in zip(steps, traffic, strict=True):
                first = step["step"] == 1
                assert gathers == 2 * step["iterations"] + (8 if first else 5), (step, gathers)
                assert exchanges == step["iterations"] + 1, (step, exchanges)


sys.exit(run_case(globals()))
