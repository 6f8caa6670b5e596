"""The solver on several ranks: solver_on_ranks_test.py MPIRUN|none FOLDER CASE."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "runtime" / "distributed"))
from ranks import program, ranks, run, run_case  # noqa: E402


def compare(cases):
    """All that the solver of a scene hands out is that of one process, on every rank. Returns that of the last case."""
    for cells, counts, *options in cases:
        options = "--cells", cells, *options
        status, wanted, errors = run(program("solver_on_ranks"), *options, "--ordinary", "1")
        assert status == 0 and wanted.count("status 0") == 2 and wanted.count("stresses") == 2, wanted + errors
        assert (" coarser " in wanted) == ("level 1" in wanted), wanted
        print(options, wanted)
        for count in counts:
            status, found, errors = ranks(count, "solver_on_ranks", *options)
            assert status == 0 and found == wanted, f"{count} ranks: {found}{errors}"
    return wanted


def the_solver_of_several_ranks_has_the_bits_of_one_process():
    """Nested or not, by tets and patches, under each preconditioner, also of a solver that goes on from the state of another."""
    compare((
        ("20", (1, 3), "--patches", "1", "--percent", "49"),
        ("20", (2, 4)),
        ("20", (3,), "--replicate", "200"),  # the coarsest mesh, which is smoothed, is cut, too
        ("24", (2, 3), "--replicate", "1000"),  # meshes of 12^3 cells are cut, too
        ("24", (3,), "--patches", "1", "--percent", "49", "--replicate", "1000"),
        ("16", (2,), "--patches", "1", "--percent", "49", "--restored", "1"),
        ("16", (3,), "--restored", "1"),
        ("16", (2,), "--patches", "1", "--nested", "0"),
        ("12", (2,), "--preconditioner", "block-jacobi", "--patches", "1"),
        ("12", (2,), "--preconditioner", "none"),
        ("8", (4,), "--patches", "1")))  # ranks without nodes


def solvers_of_other_scenes_have_the_bits_of_one_process():
    """Those of fixed corotated bodies, and of products by tets, whose coarser meshes are cut, too, or stand on every rank."""
    by_tets = "--scene", "quasistatic_matrix_free", "--patches", "1"
    compare((
        ("20", (1, 2, 3), "--scene", "quasistatic_fixed_corotated"),
        ("16", (2,), "--scene", "quasistatic_fixed_corotated", "--replicate", "500", "--restored", "1"),
        ("20", (1, 2, 3), *by_tets, "--preconditioner", "block-jacobi"),
        ("16", (2, 4), *by_tets, "--preconditioner", "none", "--replicate", "500")))


def linear_elasticity_has_the_bits_of_one_process():
    """By tets with block Jacobi and without a preconditioner, and assembled with multigrid, in each precision. A solver goes on from the state
    of another."""
    linear = "--scene", "linear_elastic"
    by_tets = *linear, "--product", "matrix-free", "--preconditioner"
    compare((
        ("16", (1, 2, 4, 8), *by_tets, "block-jacobi", "--levels", "1"),
        ("3", (4,), *by_tets, "block-jacobi", "--levels", "1"),
        ("16", (3,), *by_tets, "block-jacobi", "--precision", "double"),
        ("12", (2,), *by_tets, "none"),
        ("20", (2, 8), *linear, "--precision", "half"),
        ("24", (2,), *linear, "--replicate", "1000", "--restored", "1"),
        ("16", (3,), *linear, "--replicate", "500", "--precision", "double"),
        ("14", (2,), *linear, "--preconditioner", "block-jacobi", "--levels", "1", "--precision", "half")))
    # Before a solve what an iteration sends is said, which changes no result.
    for options, sent in (((*linear, "--cells", "20", "--precision", "half"), (6, 3)), ((*by_tets, "block-jacobi", "--cells", "20"), (1, 2))):
        wanted = run(program("solver_on_ranks"), *options, "--ordinary", "1")[1]
        status, output, errors = ranks(2, "solver_on_ranks", *options, "--iteration", "1")
        lines = output.splitlines()
        assert status == 0 and [line for line in lines if not line.startswith("traffic ")] == wanted.splitlines(), output + errors
        exchanges, messages, size, gathers, _ = map(int, re.findall(r"\d+", lines[0]))
        print(options, lines[0])
        assert lines[0].startswith("traffic of an iteration") and (exchanges, gathers) == sent and messages == exchanges and size > 0, lines[0]


def the_scene_everything_has_the_bits_of_one_process():
    """In each material, stored in half or not, by tets and patches, on meshes and on a background grid."""
    everything = "--scene", "everything"
    compare((
        ("20", (2, 4), *everything, "--material", "neo-hookean", "--patches", "1", "--percent", "49", "--precision", "half"),
        ("24", (3,), *everything, "--patches", "1", "--replicate", "1000", "--precision", "half"),
        ("16", (3,), *everything, "--material", "mooney-rivlin", "--restored", "1"),
        ("14", (2,), *everything, "--material", "corotated", "--preconditioner", "block-jacobi"),
        *((cells, (count,), *everything, "--material", material, "--nested", nested) for cells, count, material, nested in (
            ("12", 2, "st-venant-kirchhoff", "0"), ("16", 3, "fixed-corotated", "1"), ("14", 2, "stable-neo-hookean-full", "0"))),
        ("16", (2, 3), *everything, "--grid", "1", "--precision", "half"),
        ("14", (4,), *everything, "--grid", "1", "--patches", "1", "--percent", "49")))


def several_materials_have_the_bits_of_one_process():
    """Which begin inside of the blocks that ranks own, by tets and patches, where coarser meshes are cut and where ranks have them whole."""
    materials = "--scene", "everything", "--materials", "1"
    compare((
        ("16", (1, 2, 3), *materials),
        ("24", (2, 4), *materials, "--patches", "1", "--percent", "49", "--replicate", "1000", "--precision", "half"),
        ("14", (8,), *materials, "--patches", "1", "--material", "neo-hookean", "--preconditioner", "block-jacobi"),
        ("16", (2,), *materials, "--planes", "1", "--restored", "1")))
    alone = [run(program("solver_on_ranks"), "--cells", "16", *words, "--ordinary", "1")[1] for words in (materials, materials[:2])]
    assert alone[0] != alone[1], "the materials do nothing"


def contact_has_the_bits_of_one_process():
    """Rigid planes push a body: also of the force and depth of each, on the finest mesh and on the next coarser one."""
    planes = "--scene", "everything", "--planes", "1"
    for meshes, *case in ((1, "8", (2,), *planes), (1, "20", (1, 2, 4, 8), *planes, "--precision", "half"),
                          (2, "24", (2,), *planes, "--patches", "1", "--percent", "49", "--replicate", "2000"),
                          (1, "14", (4,), *planes, "--preconditioner", "block-jacobi", "--nested", "0", "--material", "neo-hookean"),
                          (2, "16", (3,), *planes, "--restored", "1"), (1, "14", (2,), *planes, "--grid", "1")):
        output = compare((case,))
        forces = [float.fromhex(line.split()[2]) for line in output.splitlines() if line.startswith("plane force ")]
        assert len(forces) == 2 * 2 * meshes and min(forces[2 * meshes:]) > 0, output  # at the first load one may not touch yet


def what_one_process_alone_has_of_everything_is_refused():
    """By the solver, too, with the remedy, once."""
    for option, word, said in (("--precision", "double", "tangents in double; take them in float or half"),
                               ("--preconditioner", "schwarz", "the Schwarz preconditioner; take another")):
        status, output, errors = ranks(2, "solver_on_ranks", "--cells", "8", "--scene", "everything", option, word)
        assert status == 1 and not output and len(re.findall(f"several ranks do not have {said}, or solve in one process", errors)) == 1, (status, output, errors)


def what_an_iteration_sends_is_what_newton_steps_send_for_each():
    """Before a solve the solver says what an iteration sends. Steps that differ by k iterations differ by k times that; and saying it changes
    no result."""
    for cells, count, *options in (("24", 3, "--patches", "1", "--nested", "0", "--replicate", "1000", "--percent", "49"),
                                   ("20", 2, "--preconditioner", "block-jacobi"),
                                   ("24", 2, "--scene", "everything", "--planes", "1", "--replicate", "1000", "--nested", "0")):
        options = "--cells", cells, *options
        wanted = run(program("solver_on_ranks"), *options, "--ordinary", "1")[1]
        status, output, errors = ranks(count, "solver_on_ranks", *options, "--iteration", "1")
        lines = output.splitlines()
        assert status == 0 and [line for line in lines if not line.startswith("traffic ")] == wanted.splitlines(), output + errors
        of_one = list(map(int, re.findall(r"\d+", lines[0])))
        print(options, lines[0])
        assert lines[0].startswith("traffic of an iteration") and min(of_one) > 0, lines[0]
        # Those of the steps of a load behind its first, where nothing but iterations differs.
        steps = [[]]
        for k, line in enumerate(lines):
            if line.startswith("status "):
                steps.append([])
            if line.startswith("traffic of a step"):
                step = dict(zip(("step", "iterations", "halvings", "filtered"), map(int, re.findall(r"\d+", lines[k + 2])[:4])))
                if lines[k + 1] == "level 0" and step["step"] > 1 and step["halvings"] == step["filtered"] == 0:
                    steps[-1].append((step["iterations"], list(map(int, re.findall(r"\d+", line)))))
        pairs = [(a, b) for of_load in steps for a, b in zip(of_load, of_load[1:]) if a[0] != b[0]]
        assert pairs, output
        for (few, sent), (many, sent_more) in pairs:
            assert [b - a for a, b in zip(sent, sent_more)] == [(many - few) * one for one in of_one], (few, many, sent, sent_more, of_one)


def numbers(output, name):
    """Of the equilibria."""
    return [float.fromhex(number) for number in re.findall(r"status 0 .*" + name + r" (\S+)", output)]


def the_solver_of_several_gpus_has_the_bits_of_one():
    """All that the solver hands out on CUDA is that of one rank, by NCCL and through pinned memory, also where ranks share a GPU; and
    reactions and energies are those of the CPU."""
    devices = int(run(program("links_gpu"), "--devices")[1])
    if devices < 1:
        print("skipped: there is no GPU")
        sys.exit(77)
    ways = [(2, "0", {"PHYSGEN_SHARE_GPU": "1"}), (3, "0", {"PHYSGEN_SHARE_GPU": "1"})]
    if devices > 1:
        ways += [(2, "1", {}), (2, "0", {}), (2, "1", {"PHYSGEN_LOOPS_ON_HOST": "1"})]
    for cells, *options in (
            ("20", "--patches", "1", "--percent", "49"),
            ("24", "--replicate", "1000"),
            ("24", "--patches", "1", "--percent", "49", "--replicate", "1000"),
            ("16", "--patches", "1", "--restored", "1"),
            ("16", "--nested", "0"),
            ("12", "--preconditioner", "block-jacobi", "--patches", "1"),
            ("8", "--patches", "1")):  # ranks without nodes
        options = "--cells", cells, *options
        status, wanted, errors = run(program("solver_on_ranks"), *options, "--device", "cuda")
        assert status == 0 and wanted.count("status 0") == 2 and wanted.count("stresses") == 2, wanted + errors
        print(options, wanted)
        on_cpu = run(program("solver_on_ranks"), *options, "--ordinary", "1")[1]
        for name in ("energy", "reaction"):
            pairs = list(zip(numbers(wanted, name), numbers(on_cpu, name)))
            assert len(pairs) == 2 and all(abs(a - b) <= 1e-5 * abs(b) for a, b in pairs), (name, pairs)
        for count, nccl, environment in ways:
            status, found, errors = ranks(count, "solver_on_ranks", *options, "--device", "cuda", "--nccl", nccl, environment=environment)
            assert status == 0 and found == wanted, f"{count} ranks, NCCL {nccl}, {environment}: {found}{errors}"


sys.exit(run_case(globals()))
