"""Motion by the solvers on several ranks: motion_on_ranks_test.py MPIRUN|none FOLDER CASE."""
import pathlib
import random
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "runtime" / "distributed"))
from ranks import program, ranks, run, run_case  # noqa: E402


def in_one_process(*options):
    """What a motion prints, of which each step ends with another kinetic energy; and how many steps there are."""
    status, wanted, errors = run(program("motion_on_ranks"), *options, "--ordinary", "1")
    kinetic = [float.fromhex(line.split()[1]) for line in wanted.splitlines() if line.startswith("kinetic ")]
    print(options, wanted)
    assert status == 0 and wanted.count("moved status 0") == len(kinetic) and wanted.count("stresses ") == 2, wanted + errors
    assert len(kinetic) == len(set(kinetic)) >= 4 and 0 < min(kinetic) and max(kinetic) < 10, kinetic
    return wanted, len(kinetic)


def on_ranks(count, wanted, *options):
    """Compares what ranks print. Gives exchanges and gathers of each step."""
    status, output, errors = ranks(count, "motion_on_ranks", *options)
    lines = output.splitlines(keepends=True)
    found = "".join(line for line in lines if not line.startswith("traffic "))
    assert status == 0 and found == wanted, f"{count} ranks, {options}: {output}{errors}"
    return [tuple(int(word) for word in re.findall(r"(?:exchanges|gathers) (\d+)", line)) for line in lines if line.startswith("traffic of a step")]


def seed():
    """Of the velocities."""
    number = str(random.randrange(1, 10 ** 6))
    print("seed", number)
    return "--seed", number


def explicit_steps_have_the_bits_of_one_process():
    """Twenty steps of symplectic Euler, and one of a solver that goes on from what was handed out: energies and momentum of each, positions,
    velocities, forces and stresses. In each step the displacements cross once, for forces and energies, and two sums are made."""
    for cells, precision, levels, counts in (("20", "float", "1", (1, 2, 4, 8)), ("3", "float", "1", (4,)), ("20", "double", "2", (3,)),
                                             ("24", "float", "2", (2, 8))):  # levels: of regular tets, whose lists a rank makes in part
        options = "--scene", "explicit_dynamics", "--cells", cells, "--precision", precision, "--levels", levels, *seed()
        wanted, steps = in_one_process(*options)
        assert steps == 21, steps
        for count in counts:
            traffic = on_ranks(count, wanted, *options)
            assert len(traffic) == steps and (count == 1 or all(step == (1, 2) for step in traffic[2:20])), traffic


def implicit_steps_have_the_bits_of_one_process():
    """The same of steps of backward Euler, with block Jacobi and with multigrid, by tets and patches."""
    for cells, counts, *options in (("20", (1, 4, 8)), ("3", (4,)), ("20", (2,), "--levels", "3", "--patches", "1"),
                                    ("24", (3,), "--levels", "3", "--replicate", "1000")):
        options = "--cells", cells, *options, *seed()
        wanted, _ = in_one_process(*options)
        assert all(int(count) > 3 for count in re.findall(r"moved status 0 steps \d+ iterations (\d+)", wanted)), wanted
        for count in counts:
            on_ranks(count, wanted, *options)


def what_an_iteration_of_a_motion_sends_is_told():
    """Before a motion the solver says what an iteration sends, or an explicit step; and saying it changes no result."""
    for scene, sent, *options in (("explicit_dynamics", (1, 0), "--cells", "20"), ("implicit_dynamics", (1, 2), "--cells", "20"),
                                  ("implicit_dynamics", (6, 3), "--cells", "20", "--levels", "3", "--patches", "1")):
        options = "--scene", scene, *options, *seed()
        wanted, _ = in_one_process(*options)
        on_ranks(2, wanted, *options, "--iteration", "1")
        line = ranks(2, "motion_on_ranks", *options, "--iteration", "1")[1].splitlines()[0]
        print(line)
        exchanges, messages, size, gathers, _ = map(int, re.findall(r"\d+", line))
        assert line.startswith("traffic of an iteration: ") and (exchanges, gathers) == sent and messages == exchanges and size > 0, line


sys.exit(run_case(globals()))
