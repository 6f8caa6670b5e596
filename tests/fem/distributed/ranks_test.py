"""Pieces of the solver on several ranks: ranks_test.py MPIRUN|none FOLDER CASE."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "runtime" / "distributed"))
from ranks import program, ranks, run, run_case  # noqa: E402

COUNTED = ("preparing exchanges", "preparing gathers", "exchanges", "gathers", "bytes", "gathered bytes", "levels cut", "ghosts", "waits", "waits behind")


def result(done):
    """What a solve ended with, what has crossed, and the kernels that the table lacks."""
    status, output, errors = done
    assert status == 0, f"status {status}: {output}{errors}"
    found = re.match(r"(digest \S+ norms \S+ iterations \d+ status \d+ rz \S+ alpha \S+)(.*)", output)
    assert found, output
    counts = re.match(r" prepared (\d+) (\d+) solved (\d+) (\d+) bytes (\d+) gathered (\d+) cut (\d+) ghosts (\d+) waits (\d+) and (\d+)", found.group(2))
    return found.group(1), dict(zip(COUNTED, map(int, counts.groups()))) if counts else {}, re.findall(r" unknown (\S+)", output)


def one_process(*options):
    """The result of the solver's own levels in one process, which has converged, and its number of iterations."""
    wanted = result(run(program("conjugate_gradients_without_mpi"), *options, "--plain", "1"))[0]
    assert result(run(program("conjugate_gradients_without_mpi"), *options))[0] == wanted, "the build without MPI"
    assert "status 1" in wanted, wanted
    print(*options, wanted)
    return wanted, int(re.search(r"iterations (\d+)", wanted).group(1))


def conjugate_gradients_have_the_bits_of_one_process():
    """Conjugate gradients with block Jacobi have the bits of one process: displacements, and the norms of all iterations."""
    wanted, iterations = one_process()
    assert 10 < iterations < 300, wanted
    for count in (1, 2, 4):
        found, counts, unknown = result(ranks(count, "conjugate_gradients"))
        print(f"{count} ranks: {counts}")
        assert found == wanted and not unknown, f"{count} ranks: {found} {unknown}"
        if count == 1:
            continue
        # Directions cross for each product, and nothing else. Two sums in each iteration.
        assert counts["exchanges"] == iterations and counts["gathers"] == 1 + 2 * iterations, counts
        # Without rows for the product more crosses with them, and nothing is missing.
        found, of_all, unknown = result(ranks(count, "conjugate_gradients", "--table", "0"))
        assert found == wanted and "physgen::fem::SymmetricProduct" in unknown and of_all["bytes"] > counts["bytes"], (found, unknown, of_all)
    for cells in ("1", "5"):  # ranks without nodes
        assert result(ranks(4, "conjugate_gradients", "--cells", cells))[0] == one_process("--cells", cells)[0]


def multigrid_has_the_bits_of_one_process():
    """The V-cycle below one level that is cut, and below two, has the bits of one process: displacements, and all norms."""
    for cells, coarsest, numbers in (("20", "5", (1, 2, 3, 4)), ("24", "6", (2, 4)), ("24", "3", (1, 3))):  # the last has a dense inverse
        options = "--preconditioner", "multigrid", "--cells", cells, "--coarsest", coarsest
        wanted, iterations = one_process(*options)
        assert 3 < iterations < 60, wanted
        for count in numbers:
            found, counts, unknown = result(ranks(count, "conjugate_gradients", *options))
            print(f"{count} ranks: {counts}")
            assert found == wanted and not unknown, f"{count} ranks: {found} {unknown}"
            if count == 1:
                continue
            assert counts["levels cut"] == 1, counts
            # The host waits for what a solve ended with, and for nothing inside of it.
            assert (counts["waits"], counts["waits behind"]) == (0, 1), counts
            # An iteration: the direction of the product; those of four smoothing steps, the interpolated one and the
            # residual that is restricted. Two sums, and the restricted residual, which all ranks are given. The first
            # preconditioning is one without a product.
            assert counts["exchanges"] == 6 * iterations + 5, (iterations, counts)
            assert counts["gathers"] == 3 * iterations + 2, (iterations, counts)
    options = "--preconditioner", "multigrid", "--cells", "8", "--coarsest", "2"  # ranks without nodes
    assert result(ranks(4, "conjugate_gradients", *options))[0] == one_process(*options)[0]
    # What crosses is what a step reads: at most a tenth more than one plane of nodes, of three floats, in each exchange.
    cells = 48
    options = "--preconditioner", "multigrid", "--cells", str(cells), "--coarsest", "6"
    wanted, iterations = one_process(*options)
    found, counts, unknown = result(ranks(2, "conjugate_gradients", *options))
    planes = counts["bytes"] / ((cells + 1) ** 2 * 12 * counts["exchanges"])
    print(f"2 ranks: {counts}: {planes:.3f} planes in each exchange")
    assert found == wanted and not unknown, f"{found} {unknown}"
    assert counts["exchanges"] == 6 * iterations + 5 and counts["gathers"] == 3 * iterations + 2, (iterations, counts)
    assert 0.5 < planes <= 1.10, planes
    # Two levels are cut: the second one's nodes are of two ranks, too.
    options = "--preconditioner", "multigrid", "--cells", "32", "--coarsest", "4"
    wanted, iterations = one_process(*options)
    for count in (2, 3):
        found, counts, unknown = result(ranks(count, "conjugate_gradients", *options, "--replicate", "3000"))
        print(f"{count} ranks: {counts}")
        assert found == wanted and not unknown, f"{count} ranks: {found} {unknown}"
        assert counts["levels cut"] == 2, counts
        assert counts["exchanges"] <= 12 * (iterations + 1) and counts["gathers"] == 3 * iterations + 2, (iterations, counts)


def newton(done):
    """The lines that all solves have to print, the steps in them, exchanges and gathers of each step, and lines on chunks and unknown kernels."""
    status, output, errors = done
    assert status == 0, f"status {status}: {output}{errors}"
    lines = output.splitlines()
    beside = ("traffic ", "chunks ", "unknown ")
    steps, level = [], 0
    for line in lines:
        if line.startswith("level "):
            level = int(line.split()[1])
        if line.startswith("step") and " iterations " in line:
            found = re.findall(r"\w+", line)[:8]
            steps.append({**dict(zip(found[::2], map(int, found[1::2]))), "level": level})
    traffic = [tuple(map(int, re.findall(r"\d+", line))) for line in lines if line.startswith("traffic ")]
    return [line for line in lines if not line.startswith(beside)], steps, traffic, [line for line in lines if line.startswith(beside[1:])]


def in_one_process(name, cells, *options):
    """The lines of a program's ordinary way, which no options change, and the steps in them; of 20 cells in three chunks of tets."""
    wanted, steps, _, chunks = newton(run(program(f"{name}_without_mpi"), "--cells", cells, *options, "--ordinary", "1"))
    print(name, "\n".join(wanted))
    assert len(steps) >= 3 and "result status 0" in "\n".join(wanted)
    assert all(step["iterations"] > 1 for step in steps), steps
    if cells == "20":
        assert chunks == ["chunks 3"], chunks
    found, _, _, _ = newton(run(program(f"{name}_without_mpi"), "--cells", cells, *options))
    assert found == wanted, found
    return wanted, steps


def on_ranks(count, name, wanted, *options):
    """Compares what several ranks print. Gives the exchanges and gathers of each step."""
    found, _, traffic, unknown = newton(ranks(count, name, *options))
    assert found == wanted, f"{count} ranks: {found}"
    assert not unknown, unknown
    print(f"{name} on {count} ranks: exchanges and gathers of each step {traffic}")
    return traffic


def expect_traffic(steps, traffic, patches):
    """Directions cross for each product, and in each step the positions where it ends, and for patches the step itself. Two sums in each
    iteration; and in each step one before the first, of the work, and of what evaluates its end: energy, forces, the least volume and the
    patches' energy. The first step evaluates its beginning, too."""
    for step, (exchanges, gathers) in zip(steps, traffic, strict=True):
        assert step["halvings"] == step["filtered"] == 0, step
        evaluation = 3 + patches
        assert gathers == 2 * step["iterations"] + 2 + evaluation * (2 if step["step"] == 1 else 1), (step, gathers)
        assert exchanges == step["iterations"] + 1 + patches, (step, exchanges)


def newton_has_the_bits_of_one_process():
    """Newton's method has the bits of one process that goes its ordinary way: of each step, of the last linear solve, positions, forces and stiffness."""
    # Of 12 cells two ranks own nodes, of 3 one.
    for cells, patches, counts in (("20", 0, (3,)), ("20", 1, (1, 2, 3, 4)), ("12", 1, (2, 4)), ("3", 1, (4,))):
        options = "--patches", str(patches)
        wanted, steps = in_one_process("newton", cells, *options)
        assert all(step["iterations"] > 10 and step["filtered"] == 0 for step in steps), steps
        for count in counts:
            traffic = on_ranks(count, "newton", wanted, "--cells", cells, *options)
            if count > 1:
                expect_traffic(steps, traffic, patches)


def newton_by_tets_has_the_bits_of_one_process():
    """The same where products are those of tets and patches, without an assembled stiffness."""
    for cells, counts in (("20", (2, 4)), ("3", (4,))):
        wanted, steps = in_one_process("newton_by_tets", cells)
        for count in counts:
            expect_traffic(steps, on_ranks(count, "newton_by_tets", wanted, "--cells", cells), 1)


def nested_iteration_from_a_cut_mesh_has_the_bits_of_one_process():
    """Nested iteration begins from a coarser mesh of which ranks have parts, too: of several blocks each, or of one that one rank owns."""
    for cells, replicate, counts, others in (("40", "9000", (2,), 0), ("24", "2000", (3,), 1), ("16", "700", (4,), 1)):
        wanted, steps = in_one_process("nested_newton", cells)
        assert {step["level"] for step in steps} >= {0, 1}, steps
        for count in counts:
            traffic = on_ranks(count, "nested_newton", wanted, "--cells", cells, "--replicate", replicate)
            expect_traffic_of_levels(steps, traffic, cut=2, half=1, nested=1, others=others)
    # Without the row of the coarser mesh's gradients the motion is poisoned, and the finer mesh begins on straight lines.
    rows = run(program("nested_newton_without_mpi"), "--rows", "1")[1].splitlines()
    number = next(line.split()[0] for line in rows if line.endswith("InterpolateMotion 6 f reads others"))
    found, _, _, _ = newton(ranks(2, "nested_newton", "--cells", cells, "--replicate", replicate, "--without", number))
    assert found != wanted, found


def expect_traffic_of_levels(steps, traffic, cut=1, half=0, patches=0, nested=0, others=1):
    """The V-cycle in place of block Jacobi. Each level that is cut has six exchanges in each preconditioning, one less where no product is
    before it, and the finest one that is not cut a residual that all ranks are given. Before the first, each has the scales of nodes, what is
    coarsened of nodes, the vectors of two power iterations, or of nine besides the first, whose length is measured twice then, in half the
    inverses of scales, and below the finest the blocks of edges. A motion that is interpolated crosses, for the ghosts that its first two
    readers need one after the other, and its least volume is measured; where the coarser mesh is cut, too, what its gradients are of crosses
    before, and its motion with these. A coarser mesh that is cut needs one exchange more in its first step, for what other ghosts need, but where
    these are among the first (others=0)."""
    coarsest = max(step["level"] for step in steps)
    for step, (exchanges, gathers) in zip(steps, traffic, strict=True):
        levels = cut - step["level"]
        if levels <= 0:
            assert (exchanges, gathers) == (0, 0), step
            continue
        if step["filtered"]:  # more solves than one
            continue
        first = step["step"] == 1
        begins = nested * first * (step["level"] < coarsest)
        beside = patches + (2 if levels == 1 else 4) * begins + others * (first and step["level"] > 0)
        assert exchanges == levels * (6 * (step["iterations"] + 1) + 4 + half + 7 * first) + beside, (step, exchanges)
        assert gathers == 3 * step["iterations"] + 4 + (3 + patches) * (1 + first) + levels * (2 + first) + begins, (step, gathers)


def multigrid_in_newton_has_the_bits_of_one_process():
    """Whole solves with multigrid, which is made from the stiffness that ranks assemble, have the bits of one process that goes its ordinary way."""
    for name, cells, options, counts, traits in (
            ("newton", "20", ("--levels", "3"), (1, 2, 3, 4), {}),
            ("newton", "12", ("--levels", "3", "--patches", "1"), (2,), {"patches": 1}),
            ("nested_newton", "20", ("--percent", "49"), (1, 2, 3, 4), {"half": 1}),
            ("nested_newton", "16", (), (2, 3), {"half": 1, "nested": 1}),
            ("nested_newton", "24", ("--nested", "0", "--replicate", "2000"), (2, 3), {"half": 1, "cut": 2})):
        wanted, steps = in_one_process(name, cells, *options)
        for count in counts:
            traffic = on_ranks(count, name, wanted, "--cells", cells, *options)
            if count > 1:
                expect_traffic_of_levels(steps, traffic, **traits)
    wanted, _ = in_one_process("nested_newton", "8")
    on_ranks(4, "nested_newton", wanted, "--cells", "8")  # ranks without nodes
    rows = run(program("nested_newton_without_mpi"), "--rows", "1")[1].splitlines()
    for row in ("SymmetricProduct 3 dx reads others", "RestrictResidual 4 df reads others"):  # what they read of others is poisoned
        number = next(line.split()[0] for line in rows if line.endswith(row))
        status, output, errors = ranks(2, "nested_newton", "--cells", "12", "--replicate", "300", "--without", number)
        assert status == 0 and re.search(r"\brz -?nan\b", output) and "result status 0" not in output, f"without {row}: {output}{errors}"


sys.exit(run_case(globals()))
