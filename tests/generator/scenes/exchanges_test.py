"""What crosses between ranks in three scenes, and before which step: exchanges_test.py ON|OFF FORCE_CHAIN RELAX QUASISTATIC, whether
kernels of CUDA are among their steps, and a NAME.need.json of each.

The tables below are read against what physgen has found of the scenes' kernels. A line that is indented is a row: the step, the fields of
other objects that it reads, so that they cross before it where they are stale, and the index field that finds those objects. Other lines
say what the rows below them are for. An exchange that no row explains fails, as does a row of which there is no exchange. Names without
a namespace are of physgen::fem.
"""
import json
import pathlib
import sys

FORCE_CHAIN = """
A tet reads the positions of its corners. What it pulls its nodes with is computed wherever one of these is owned, and crosses nowhere.
  ComputeDeformationGradient: body.positions.x through body.tets.nodes
"""

RELAX = """
A spring reads the positions of its ends; its pull is computed wherever one of these is owned, and crosses nowhere.
  springs::Pull: body.positions.x through body.edges.nodes
"""

QUASISTATIC = """
Forces, energies, stresses and tangents of a tet are of the positions of its corners, at rest and now, and of its patch's pressure.
  ComputeTetForces: body.positions.x, body.rest.x, body.trial.x through body.tets.nodes
  ComputeTetForces: body.volumes.pressure, body.volumes.tangent_pressure through patches.tet_patches.patch
  ComputeTetTangents: body.positions.x, body.rest.x through body.tets.nodes
  ComputeTetTangents: body.volumes.pressure, body.volumes.tangent_pressure through patches.tet_patches.patch
  EvaluateStress: body.positions.x, body.rest.x through body.tets.nodes
  EvaluateStress: body.volumes.pressure, body.volumes.tangent_pressure through patches.tet_patches.patch
  VolumeRatio: body.positions.x, body.rest.x, body.trial.x through body.tets.nodes
  PartBeforeFlat: body.positions.x, body.rest.x, level.constraints.fixed through body.tets.nodes

A patch reads the tets in its row, and their corners; its linear volume the step of its nodes; one of a finer mesh its parent.
  EvaluatePatches: body.tets.nodes through patches.patch_tet_entries.tet
  EvaluatePatches: body.positions.x, body.rest.x, body.trial.x through body.tets.nodes
  AdvancePatches: krylov.step.dx through patches.nodes.nodes
  InjectPatchPressures: body.volumes.linearised through patches.parents.patch

The stiffness of an edge is summed over its tets and patches; that of a coarse edge over fine nodes and edges, its terms.
  SumEdgeStiffness: chunk.tangent.U, chunk.tangent.g through body.edge_tet_entries.code
  SumEdgeStiffness: chunk.tangent.x1111, chunk.tangent.x2211, chunk.tangent.x3311 through body.edge_tet_entries.code
  SumEdgeStiffness: chunk.tangent.x2222, chunk.tangent.x3322, chunk.tangent.x3333 through body.edge_tet_entries.code
  SumEdgeStiffness: chunk.tangent.x2112, chunk.tangent.x2121, chunk.tangent.x3113 through body.edge_tet_entries.code
  SumEdgeStiffness: chunk.tangent.x3131, chunk.tangent.x3223, chunk.tangent.x3232 through body.edge_tet_entries.code
  SumEdgeStiffness: patches.tangent.g, patches.tangent.k through patches.edge_patch_entries.code
  CoarsenEdgeStiffness: level.edge_stiffness.E, level.node_stiffness.K through level.edge_term_entries.code

Scaled blocks of an edge are of what holds its nodes, and of their scales.
  ScaleEdges: level.constraints.fixed, level.scales.scale through level.edges.nodes

Between two meshes a node reads its parents, and a coarse node its children.
  InterpolateCorrection: level.correction.dx, level.scales.scale through level.parents.nodes
  InterpolateMotion: body.rest.x, body.kept.x, body.positions.x, body.trial.x through level.parents.nodes
  InterpolateMotion: body.trial_forces.f, body.increment.dx through level.parents.nodes
  AverageMotionGradients: body.rest.x, body.kept.x, body.positions.x through body.tets.nodes
  RestrictResidual: level.residual.df, level.scales.inverse through level.child_entries.code

A product reads its vector at both ends of an edge, which it is performed with: of the direction, the smoother's vectors, and the power
iteration's.
  lambda in add_edges: krylov.direction.dx, krylov.product.df through level.edges.nodes
  lambda in add_edges: level.direction.dx, level.residual.df through level.edges.nodes
  lambda in multiply: krylov.direction.dx, krylov.residual.df, level.power.dx, level.residual.df through level.edges.nodes
  lambda in multiply: level.node_stiffness.K, level.scaled_nodes.K through level.edges.nodes

The smoother's bounds are one record of a level, which all ranks have, as they have the coarsest mesh, whose inverse is dense.
  BeginChebyshev: level.smoother.largest through numbers that it forms
  ContinueChebyshev: level.smoother.largest through numbers that it forms
  NormalisePower: level.smoother.length through numbers that it forms
  ApplyCoarseInverse: level.coarse_inverse.G, level.residual.df through numbers that it forms
  lambda in invert_coarsest: level.constraints.fixed, level.node_stiffness.K, level.scales.scale through level.edges.nodes
  lambda in invert_coarsest: level.edge_stiffness.E, level.edges.nodes through numbers that it forms
"""

QUASISTATIC_ON_CUDA = """
Products and the coarsest inverse are kernels there that find edges and pairs of nodes by numbers which they form.
  lambda in add_edges: level.power.dx through level.edges.nodes
  lambda in add_edges: level.edges.nodes, level.edge_stiffness.E, level.scaled_edges.E through numbers that it forms
  lambda in multiply: level.edges.nodes, level.edge_stiffness.E through numbers that it forms
  lambda in invert_coarsest: level.coarse_inverse.G through numbers that it forms

Scaled blocks of small meshes stand at the entries of rows, where edges are looked up.
  AtEntries: level.edge_stiffness.E, level.edges.nodes through level.node_edge_entries.code
  AtEntries: level.constraints.fixed, level.scales.scale through level.edges.nodes

Small meshes, which all ranks have, are cycled through in one kernel, and their products go by rows.
  lambda in cycle_at_once: level.child_entries.code, level.child_ranges.begin, level.child_ranges.end through numbers that it forms
  lambda in cycle_at_once: level.coarse_inverse.G, level.direction.dx, level.inverse.D, level.parents.nodes through numbers that it forms
  lambda in cycle_at_once: level.scaled_edges.E, level.scaled_nodes.K, level.smoother.largest through numbers that it forms
  lambda in cycle_at_once: level.constraints.fixed, level.correction.dx through level.child_entries.code, level.parents.nodes
  lambda in cycle_at_once: level.residual.df, level.scales.inverse, level.scales.scale through level.child_entries.code, level.parents.nodes
  lambda in run_rows: level.child_entries.code, level.child_ranges.begin, level.child_ranges.end through numbers that it forms
  lambda in run_rows: level.coarse_inverse.G, level.direction.dx, level.power.dx, level.residual.df through numbers that it forms
  lambda in run_rows: level.scaled_edges.E through numbers that it forms
  lambda in run_rows: level.constraints.fixed, level.residual.df through level.child_entries.code
  lambda in run_rows: level.scales.inverse, level.scales.scale through level.child_entries.code
"""


def expected(table):
    """(step, field, index fields) of each row and field."""
    found = set()
    for row in (line.strip() for line in table.splitlines() if line.startswith("  ")):
        step, rest = row.split(": ")
        fields, through = rest.split(" through ")
        for field in fields.split(", "):
            assert (step, field, through) not in found, f"the row of {field} in {row!r} stands twice"
            found.add((step, field, through))
    return found


def found(file):
    """The same of what physgen has found, and the kernels of which it does not know all."""
    halos = json.loads(file.read_text())["halos"]
    reads = [read for read in halos["reads"] if read["exchanged"]]
    return {(read["step"].split("(")[0].replace("physgen::fem::", ""), f"{read['array']}.{read['field']}",
             ", ".join(read["through"]) or "numbers that it forms") for read in reads}, halos["unknown"]


def main():
    wrong = []
    quasistatic = QUASISTATIC + (QUASISTATIC_ON_CUDA if sys.argv[1] == "ON" else "")
    for table, file in zip((FORCE_CHAIN, RELAX, quasistatic), map(pathlib.Path, sys.argv[2:]), strict=True):
        exchanges, unknown = found(file)
        wanted = expected(table)
        assert wanted, file
        for what, rows in (("no row explains", exchanges - wanted), ("there is no exchange of the row", wanted - exchanges)):
            wrong += [f"{file.name}: {what} {step}: {field} through {through}" for step, field, through in sorted(rows)]
        wrong += [f"{file.name}: not known: {one}" for one in unknown]
    if wrong:
        sys.exit("\n".join(wrong))


main()
