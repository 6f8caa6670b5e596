"""The memory of truthcube on several ranks: ranks_memory_test.py MPIRUN|none TRUTHCUBE CASE."""
import json
import re

from ranks_runs import FOLDER, SCENE, TRUTHCUBE, command, done, run_and_remove
from ranks import run  # behind ranks_runs, which says where it is


def a_dry_run_says_what_each_rank_has():
    """Parts add up to the mesh, and bytes are those that a run takes; nothing is written."""
    out = FOLDER / "dry"
    output = done(0, *command(3, "--cells", "24", "--compress", "0.05", "--dry-run", "--out", str(out)))
    assert not out.exists() and "compression" not in output, output
    parts = [list(map(int, line.split()[:8])) for line in output.splitlines() if re.match(r" +\d+( +\d+){7}  ", line)]
    print(output)
    assert [part[0] for part in parts] == [0, 1, 2], output
    nodes, tets = (sum(part[k] for part in parts) for k in (1, 3))
    assert (nodes, tets) == (25 ** 3, 6 * 24 ** 3), (nodes, tets)
    for part, sides in zip(parts, (1, 2, 1)):  # of a cut
        assert sides * 25 ** 2 <= part[2] <= sides * 2.1 * 25 ** 2 and part[4] > 0, parts
    assert [part[5] for part in parts] == [1, 2, 1], "neighbours"
    # Arrays are those of what a rank has, and of the coarser meshes, which all have; the forecast is made before there are parts.
    levels = [list(map(int, line.split())) for line in output.splitlines() if re.match(r" +\d+( +\d+){4}$", line)]
    assert [level[1] for level in levels] == [25 ** 3, 13 ** 3, 7 ** 3, 4 ** 3], levels
    def window(tets):  # what kernels over a chunk leave: nine doubles of forces, and 26 floats of a tangent
        return min(tets, 2 ** 14) * (9 * 8 + 26 * 4)
    of_all = levels[0][4] + 9 * 8 * tets - window(tets)  # with stresses
    for part in parts:
        wanted = of_all * (part[3] + part[4]) / tets + sum(level[4] for level in levels[1:]) + window(tets) + window(levels[1][2])
        assert abs(part[6] / wanted - 1) < 0.1, (part, wanted)
    forecast = int(re.search(r"^each of 3 ranks: about (\d+) bytes of the solver, and [0-9.]+ GB more on the host", output, re.M)[1])
    assert abs(forecast / max(part[6] for part in parts) - 1) < 0.1, (forecast, parts)
    # Where the first rank writes, it has a window: 512 bytes for each of up to 2^16 tets, and 128 for each of up to 2^18 nodes.
    assert f"; the first has {512 * min(6 * 24 ** 3, 2 ** 16) + 128 * min(25 ** 3, 2 ** 18)} bytes of a step that it writes\n" in output, output
    # Where the surface is written, lists are of the whole, and arrays the same.
    surface = done(0, *command(3, "--cells", "24", "--compress", "0.05", "--output", "surface", "--dry-run", "--out", str(out)))
    assert f"each of 3 ranks: about {forecast} bytes of the solver" in surface, surface
    # An iteration has six exchanges with multigrid over one level that is cut, and three gathers; each has a message to each neighbour.
    assert output.count("in a PCG iteration: 6 exchanges, 3 gathers") == 1, output
    sent = [list(map(int, line.split()[:4])) for line in output.splitlines() if re.match(r" +\d+( +\d+){3}  \S+$", line)]
    assert [line[:2] for line in sent] == [[0, 6], [1, 12], [2, 6]], sent
    plane = 25 ** 2 * 12
    assert all(0.5 * plane < line[2] / line[1] <= 1.10 * plane and line[3] > 0 for line in sent), sent
    done(0, *command(3, "--cells", "24", "--compress", "0.05", "--out", str(out)))
    assert json.loads((out / "run.json").read_text())["bytes"] == sum(part[6] for part in parts), parts
    again = done(0, *command(3, "--cells", "24", "--compress", "0.05", "0.1", "--dry-run", "--restart", "--beads", "none.csv", "--out", str(out)))
    assert "compression" not in again and " machine" in again, again


def ghosts_are_two_planes_of_nodes_at_most():
    """At each side of a cut. One plane is what products read. A coarse edge, of the next mesh, which all ranks have, is computed from fine
    edges that are up to a plane farther (level.edge_term_entries), each of which comes with its tets and patches (edge_tet_entries,
    edge_patch_entries)."""
    for volume in ("tets", "patches"):
        output = done(0, *command(2, "--cells", "48", "--volume", volume, "--compress", "0.05", "--dry-run"))
        assert "that it writes" not in output, output
        ghosts = [int(line.split()[2]) for line in output.splitlines() if re.match(r" +\d+( +\d+){7}  ", line)]
        print(volume, "planes", [number / 49 ** 2 for number in ghosts])
        assert len(ghosts) == 2 and all(49 ** 2 <= number <= 2 * 49 ** 2 for number in ghosts), ghosts


def a_cube_is_refused_by_what_its_ranks_take():
    """Not by the whole for each: two ranks take a part of it, its ghosts, and lists. Nothing is made before."""
    words = ("--cells", "128", "--compress", "0.05", "--out", str(FOLDER / "large"))
    taken = []
    for name, words in ((r"a cube of 128\^3 cells", (TRUTHCUBE, *SCENE, *words)), (r"a cube of 128\^3 cells on each of 2 ranks", command(2, *words))):
        found, output, errors = run("bash", "-c", 'ulimit -v 6000000 && exec "$@"', "bash", *words)
        said = re.findall(name + r" takes [0-9.]+ GB \((\d+) bytes\), and this machine has 6.14 GB; ", errors)
        assert found == 1 and len(said) == 1 and not (FOLDER / "large").exists(), (found, output, errors)
        taken.append(int(said[0]))
    assert 1.0 < taken[1] / taken[0] < 1.5, taken


run_and_remove(globals())
