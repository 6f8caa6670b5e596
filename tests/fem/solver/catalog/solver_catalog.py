#!/usr/bin/env python3
"""The catalogue of the solver: in a copy of the tree a material, a preconditioner or a scene is added, each by a change of
a few files, and runs. What a row lacks is said with the row's name.

  solver_catalog.py material        whose volume can be averaged
  solver_catalog.py preconditioner  which has no arrays of its own
  solver_catalog.py scene           which truthcube offers
"""
import argparse
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[3]
sys.path.insert(0, str(ROOT / "tests/generator/catalog"))
from catalog import Tree, run  # noqa: E402

MATERIALS, FEM, SOLVER = "tools/fem/materials", "tools/fem", "tools/fem/solver"
MOST = {"material": 4, "preconditioner": 1 + 2, "scene": 3}  # files; a preconditioner's folder counts as one


def add_row(tree, path, table, row):
    """Puts a row in front of the others of a table."""
    tree.insert(path, r"#define PHYSGEN_%s\(ROW, \.\.\.\) *\\\n" % table, f"  ROW({row}, __VA_ARGS__) \\\n")


def add_material(tree):
    """Fixed corotated bodies by another name."""
    text = (tree.folder / MATERIALS / "fixed_corotated.h").read_text()
    tree.create(f"{MATERIALS}/also_corotated.h", text.replace("FixedCorotated", "AlsoCorotated").replace("fixed corotated", "also corotated"))
    tree.insert(f"{MATERIALS}/materials.h", "(?=#include <fem/materials/corotated.h>)", "#include <fem/materials/also_corotated.h>\n")
    add_row(tree, f"{MATERIALS}/materials.h", "MATERIALS", 'AlsoCorotated, also_corotated, "also-corotated"')
    tree.insert(f"{FEM}/reference/energy.h", r"(?=/// Smith et al. 2018, without)", """template <class R>
Jet energy(const AlsoCorotated<R>& m, const Stretches& s) {
  return Jet(Quad(m.mu)) * detail::squared_strains(s) +
         Jet(Quad(m.lambda) / 2) * detail::square(detail::volume(s) - Jet(1.));
}

""")


DIAGONAL = """// The diagonal of the stiffness.
#pragma once

#include <fem/solver/levels/preconditioner.h>
#include <fem/solver/levels/scaled_blocks.h>

namespace physgen::fem {

template <class NodeStiffnessView, class ResidualView, class CorrectionView>
struct ApplyDiagonal {
  using Scalar = typename CorrectionView::Precision;
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness
  ResidualView residual;        ///< elasticity::NodeForceDifferential
  CorrectionView corrections;   ///< elasticity::NodeDisplacement, written
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const Matrix3<Scalar> K = stiffness[i].K();
    const Vector3<Scalar> r = residual[i].df();
    for (int k = 0; k < 3; ++k) corrections[i].dx()[k] = K(k, k) < 0 ? -r[k] / K(k, k) : Scalar(0);
  }
};
template <class... Views>
ApplyDiagonal(Views...) -> ApplyDiagonal<Views...>;

struct Diagonal : WithoutArrays {
  template <class On, class Levels>
  static void prepare(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& /*settings*/, bool /*fresh*/) {
    scale_nodes(on, *levels[top], false);
  }
  template <class On, class Levels>
  static void apply(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& /*settings*/) {
    auto& level = *levels[top];
    on.run(level.nodes(), ApplyDiagonal{level.scaled_nodes.const_view(), level.residual.const_view(), level.correction.view()});
  }
};

}  // namespace physgen::fem
"""


WITHOUT_BYTES = """struct Diagonal {
  template <class Level>
  static void make_arrays(Level& /*level*/, const LevelGraph& /*graph*/, const std::vector<Point>& /*rest*/) {}
"""


def add_preconditioner(tree):
    (tree.folder / SOLVER / "preconditioners/diagonal").mkdir()
    tree.create(f"{SOLVER}/preconditioners/diagonal/preconditioner.h", DIAGONAL)
    tree.insert(f"{SOLVER}/preconditioners/all.h", "(?=#include <fem/solver/preconditioners/jacobi)",
                "#include <fem/solver/preconditioners/diagonal/preconditioner.h>\n")
    add_row(tree, f"{SOLVER}/preconditioner_rows.h", "PRECONDITIONERS", 'diagonal, Diagonal, diagonal, "diagonal", "diagonal", edges')


def add_scene(tree):
    """Neo-Hookean bodies, tet by tet."""
    text = (tree.folder / SOLVER / "scenes/quasistatic_fixed_corotated.h").read_text()
    for old, new in (("quasistatic_fixed_corotated", "quasistatic_neo_hookean"), ("FixedCorotated", "NeoHookean"), ("materials/fixed_corotated", "materials/neo_hookean")):
        text = text.replace(old, new)
    tree.create(f"{SOLVER}/scenes/quasistatic_neo_hookean.h", text)
    add_row(tree, f"{SOLVER}/scene_rows.h", "EQUILIBRIUM_SCENES",
            'quasistatic_neo_hookean, "neo-hookean", NeoHookean, AssembledOnMeshes, by_tets')


class Copy:
    """A copy of the parts of the tree that the solver is compiled from, and what compiles it."""

    def __init__(self, arguments):
        self.arguments, self.folder = arguments, arguments.folder / arguments.test
        shutil.rmtree(self.folder, ignore_errors=True)
        for part in (FEM, "tools/cmake", "tools/truthcube"):
            shutil.copytree(ROOT / part, self.folder / part)
        (self.folder / "out").mkdir()
        own = [f"-I{self.folder}/{part}" for part in ("tools", "out", SOLVER)]
        self.compiler = [arguments.compiler[0], *own, *arguments.compiler[1:]]

    def changed(self):
        """Adds what the test is of. Fails when too many files change."""
        tree = Tree(self.folder)
        globals()[f"add_{self.arguments.test}"](tree)
        print(f"{self.arguments.test}: {len(tree.touched)} files, {', '.join(sorted(tree.touched))}")
        if len(tree.touched) > MOST[self.arguments.test]:
            sys.exit(f"that is more than {MOST[self.arguments.test]}")

    def rows(self, path, table, files):
        """The rows that CMake reads, or its message."""
        script = self.folder / "out/rows.cmake"
        script.write_text(f"include({self.folder}/tools/cmake/physgen_read_rows.cmake)\n"
                          f"physgen_read_rows(rows {self.folder}/{path} {table} FILES {self.folder}/{files})\nmessage(\"${{rows}}\")\n")
        done = subprocess.run([self.arguments.cmake, "-P", script], capture_output=True, text=True)
        return done.returncode, " ".join(done.stderr.split())

    def expect_rows(self, path, table, files, row, missing):
        """That CMake reads a row, and names it where its file is missing."""
        if row not in self.rows(path, table, files)[1]:
            sys.exit(f"CMake does not read the row {row}")
        file = self.folder / missing
        file.rename(file.with_suffix(".away"))
        code, text = self.rows(path, table, files)
        file.with_suffix(".away").rename(file)
        if code == 0 or f"the row {row.split('|')[0]} of PHYSGEN_{table} names" not in text or "does not exist" not in text:
            sys.exit(f"CMake does not say that a file is missing, but:\n{text}")

    def program(self, source, *more):
        """Compiles and runs a program of the test's, with more sources of the copy in front of it: as one, since reading
        the headers that they share is what takes time."""
        together, program = self.folder / "out/together.cpp", self.folder / "out/program"
        together.write_text("".join(f'#include "{path}"\n' for path in (*(self.folder / path for path in more), HERE / source)))
        run([*self.compiler, together, *self.arguments.link, "-lquadmath", "-o", program])
        print(run([program], stdout=subprocess.PIPE, text=True), end="")


def material(copy):
    copy.expect_rows(f"{MATERIALS}/materials.h", "MATERIALS", f"{MATERIALS}/@2@.h", "AlsoCorotated|also_corotated|also-corotated",
                     f"{MATERIALS}/also_corotated.h")
    copy.program("material.cpp", f"{SOLVER}/settings.cpp")


def preconditioner(copy):
    header = f"{SOLVER}/preconditioners/diagonal/preconditioner.h"
    copy.expect_rows(f"{SOLVER}/preconditioner_rows.h", "PRECONDITIONERS", f"{SOLVER}/preconditioners/@3@/preconditioner.h",
                     "diagonal|Diagonal|diagonal|diagonal", header)
    copy.program("preconditioner.cpp", f"{SOLVER}/settings.cpp")
    (copy.folder / header).write_text(DIAGONAL.replace("struct Diagonal : WithoutArrays {\n", WITHOUT_BYTES))
    done = subprocess.run([*map(str, copy.compiler), "-fsyntax-only", "-x", "c++", "-"], input="#include <fem/solver/preconditioners/all.h>\n",
                          capture_output=True, text=True)
    said = "the row diagonal of PHYSGEN_PRECONDITIONERS: Diagonal has no bytes<Extra>(nodes, edges)"
    if done.returncode == 0 or said not in done.stderr:
        sys.exit(f"the compiler does not say '{said}', but:\n{done.stderr[:4000]}")


def scene(copy):
    name = "quasistatic_neo_hookean"
    copy.expect_rows(f"{SOLVER}/scene_rows.h", "EQUILIBRIUM_SCENES", f"{SOLVER}/scenes/@1@.h", f"{name}|neo-hookean|NeoHookean",
                     f"{SOLVER}/scenes/{name}.h")
    flags = [flag for flag in copy.compiler if flag.startswith(("-I", "-isystem", "/"))]
    run([copy.arguments.physgen, "scene", copy.folder / SOLVER / f"scenes/{name}.h", "-o", copy.folder / "out", "--",
         *[flag for flag in flags if flag.startswith("-I")], *copy.arguments.scene_flag], stdout=subprocess.DEVNULL)
    rows = copy.rows(f"{SOLVER}/scene_rows.h", "EQUILIBRIUM_SCENES", f"{SOLVER}/scenes/@1@.h")[1].split(";")
    rows += copy.rows(f"{SOLVER}/scene_rows.h", "IMPLICIT_SCENES", f"{SOLVER}/scenes/@1@.h")[1].split(";")
    (copy.folder / "out/solved_scenes.h").write_text("".join(f"#include <{row.split('|')[0]}.scene.h>\n" for row in rows))
    solver = (copy.folder / SOLVER / "solvers/scene_solver.in").read_text()
    for word, value in {"HEADER": "solver_of", "MADE": "EquilibriumSolver", "PLACE": "host", "SCENE": name, "SETTINGS": "SolverSettings",
                        "SOLVER": "SolverOf", "EXECUTOR": "HostExecutor", "SPACE": "Host"}.items():
        solver = solver.replace(f"@{word}@", value)
    (copy.folder / "out/scene_solver.cpp").write_text(solver)
    parts = [f"tools/truthcube/{part}.cpp" for part in ("arrays", "names", "run_bytes", "scene_choice", "sizes", "solver_bytes")]
    copy.program("scene.cpp", *parts, f"{SOLVER}/solvers/solvers.cpp", "out/scene_solver.cpp")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("test", choices=sorted(MOST))
    parser.add_argument("--folder", type=Path, required=True, help="of what is written")
    parser.add_argument("--cmake", required=True)
    parser.add_argument("--physgen", help="the command, for scenes")
    parser.add_argument("--scene-flag", action="append", default=[], help="of the compiler with which a scene is read; repeated")
    parser.add_argument("--link", action="append", default=[], help="what programs are linked to; repeated")
    parser.add_argument("--compiler", nargs=argparse.REMAINDER, required=True, help="and its flags")
    arguments = parser.parse_args()
    copy = Copy(arguments)
    copy.changed()
    {"material": material, "preconditioner": preconditioner, "scene": scene}[arguments.test](copy)


if __name__ == "__main__":
    main()
