"""Bodies and cases for tests of truthcube --case in Python: a box of cells of tets with groups, and runs of the command."""
import itertools
import json
import os
import pathlib
import subprocess

SIZE = (0.04, 0.06, 0.1)  # [m]
# Corners of a cell by bits (1: along x, 2: y, 4: z) along the paths of the six tets around its diagonal.
PATHS = ((0, 1, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 3, 2, 7), (0, 5, 1, 7), (0, 6, 4, 7))
OUTWARD = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))  # the faces of a tet, seen from outside counter-clockwise


class Box:
    """cells^3 cells between the faces x0, x1, y0, ... z1: `faces` has triangles by these names, `far` the numbers of the tets that
    lie in the upper half."""

    def __init__(self, cells):
        side = range(cells + 1)
        self.nodes = [tuple(s * (k / cells) for s, k in zip(SIZE, (x, y, z))) for z, y, x in itertools.product(side, side, side)]
        self.tets = [
            tuple(x + (k & 1) + (cells + 1) * (y + (k >> 1 & 1) + (cells + 1) * (z + (k >> 2))) for k in path)
            for z, y, x, path in itertools.product(range(cells), range(cells), range(cells), PATHS)
        ]
        self.faces = {name: [] for name in ("x0", "x1", "y0", "y1", "z0", "z1")}
        for face in surface(self.tets):
            for k, at in itertools.product(range(3), (0, 1)):
                if all(self.nodes[n][k] == at * SIZE[k] for n in face):
                    self.faces["xyz"[k] + str(at)].append(face)
        self.far = [t for t, tet in enumerate(self.tets) if all(2 * self.nodes[n][2] >= SIZE[2] for n in tet)]

    def write(self, path, move=lambda x: x):
        """In Gmsh's format, version 2.2. @param move of nodes"""
        numbers = {name: number for number, name in enumerate(self.faces, 1)}
        far = set(self.far)
        rows = [(4, 8 if t in far else 7, tet) for t, tet in enumerate(self.tets)]
        rows += [(2, numbers[name], face) for name, faces in self.faces.items() for face in faces]
        with open(path, "w", encoding="ascii") as out:
            out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n8\n")
            out.writelines(f'2 {number} "{name}"\n' for name, number in numbers.items())
            out.write(f'3 7 "near"\n3 8 "far"\n$EndPhysicalNames\n$Nodes\n{len(self.nodes)}\n')
            for number, node in enumerate(self.nodes, 1):
                out.write(" ".join([str(number), *(repr(float(x)) for x in move(node))]) + "\n")
            out.write(f"$EndNodes\n$Elements\n{len(rows)}\n")
            for number, (kind, group, corners) in enumerate(rows, 1):
                out.write(f"{number} {kind} 2 {group} 1 {' '.join(str(n + 1) for n in corners)}\n")
            out.write("$EndElements\n")


def surface(tets):
    """The faces that one tet alone has, outward; by brute force."""
    found = {}
    for tet, corners in itertools.product(tets, OUTWARD):
        face = tuple(tet[c] for c in corners)
        found.setdefault(tuple(sorted(face)), []).append(face)
    return [faces[0] for faces in found.values() if len(faces) == 1]


class Command:
    """truthcube in a folder of its own."""

    def __init__(self, program, folder):
        self.program, self.folder = os.path.abspath(program), pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def run(self, *flags, status=0):
        """@return what it printed on standard output and on standard error"""
        words = [self.program, *map(str, flags)]
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True, check=False,
                              env=os.environ | {"OMP_NUM_THREADS": "1"})
        assert done.returncode == status, (words, done.returncode, done.stdout, done.stderr)
        return done.stdout, done.stderr

    def solve(self, case, *flags, out="o"):
        """Solves a case exactly. @return run.json and the output"""
        (self.folder / "case.json").write_text(json.dumps(case), encoding="ascii")
        said, _ = self.run("--case", "case.json", "--threads", 1, "--precision", "double", "--tolerance", 1e-12, "--out", out, *flags)
        return json.loads((self.folder / out / "run.json").read_text(encoding="utf-8")), said

    def refuse(self, case, *words, status):
        (self.folder / "case.json").write_text(json.dumps(case), encoding="ascii")
        _, said = self.run("--case", "case.json", status=status)
        for word in words:
            assert word in said, (word, said)


def near(a, b, error):
    assert abs(a - b) <= error, (a, b, error)


def run_rule(rules, name):
    """Runs the one of these functions that has the name."""
    {rule.__name__: rule for rule in rules}[name]()
