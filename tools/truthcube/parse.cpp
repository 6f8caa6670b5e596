#include "parse.h"

#include <physgen/error.h>

#include <cmath>

#include "case_choice.h"
#include "choices.h"
#include "command_line.h"
#include "grading.h"
#include "mesh_order.h"
#include "scene_choice.h"
#include "sizes.h"

namespace physgen::truthcube {

namespace {

constexpr const char* about =
    R"(Compresses the Truth Cube (Kerdok et al. 2003), a silicone cube of 8 cm side with 343 beads inside, or a mesh of
your own, between two plates, and solves for its quasistatic equilibrium. Prints a line for each Newton step: the
residual |force on free components| / |force on prescribed ones|, iterations of conjugate gradients, energy, the
smallest current over rest volume of a tet, and the time. Other scenes move it in time, or take it for linear elastic.)";

constexpr const char* footer =
    R"(Free sides bulge towards the plates near bonded edges. With --plates held they fold past them, on fine meshes from a
compression of about 0.1 on, in a zone of 1 to 2 mm of the cube. With --plates contact the plates are rigid and without
friction: a node that is past one by d is pushed back by k d per area of the surface at rest, so that the body stays past
it by its pressure over k. --plate-stiffness F gives k = F E / h [Pa/m], E being Young's modulus and h the mean spacing of
nodes: where the pressure is E/10 and F is 100, by a thousandth of h. Each step says how far the sides reach past.
Scenes that move begin at rest; the upper plate goes to its compression smoothly in the first half of the duration, and
stays there. A line is a state that is written: its time, compression, energies, reaction and what led to it.
Exit status: 0 done, 1 a file or the memory failed, 2 wrong use, 3 no convergence, 130 interrupted; whatever steps were
done are then written.
Built: every material, precision and treatment of volume, on the CPU)"
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
    " and on CUDA"
#endif
    ",\nin the layout " PHYSGEN_TRUTHCUBE_LAYOUT
    ", with products assembled (under every preconditioner) or matrix-free"
    ".\nAnother layout is another build: cmake -DPHYSGEN_LAYOUT=schema, aos, aos_padded, soa or aosoa.";

/// @throw Error for a layout that the solver was not compiled for
void require_built(const std::string& layout) {
  if (layout == built_layout()) return;
  const std::vector<std::string> layouts{"schema", "aos", "aos_padded", "soa", "aosoa"};
  if (std::ranges::find(layouts, layout) == layouts.end()) {
    throw Error("--layout: " + unknown("layout", layout, layouts) + " This build has " + built_layout());
  }
  throw Error("--layout " + layout + ": the layout is a choice of the build, and this one has " + built_layout() +
              "; configure one with cmake -DPHYSGEN_LAYOUT=" + layout);
}

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(what);
}

void check(const Options& options) {
  if (options.is_cube()) {
    require_cube_fits(options.cells, options.volume);
    check_grading(options.cells, options.grading);
  }
  const double nu = options.solver.poissons_ratio;
  require(nu > -1 && nu < 0.5, "--poisson " + number(nu) + ": Poisson's ratio must be above -1 and below 0.5");
  const double young = options.solver.youngs_modulus;
  require(young > 0 && std::isfinite(young), "--young " + number(young) + ": Young's modulus must be positive");
  const double tolerance = options.solver.newton.tolerance;
  require(tolerance >= 1e-14 && tolerance <= 0.1,
          "--tolerance " + number(tolerance) + ": the residual's tolerance must be a number from 1e-14 to 0.1");
  const double stiffness = options.solver.plane_stiffness;
  require(stiffness >= 1e-3 && stiffness <= 1e4,
          "--plate-stiffness " + number(stiffness) + ": the stiffness of plates must be a number from 0.001 to 1e4");
  require(options.plate_tolerance >= 0 && options.plate_tolerance <= largest_plate_tolerance,
          "--plate-tolerance " + number(options.plate_tolerance) +
              ": the distance within which plates hold nodes must be a number of mean edge lengths from 0 to " +
              number(largest_plate_tolerance) + "; " + number(default_plate_tolerance) + " is common");
  check_motion(options.motion);
  double before = 0;
  for (const double c : options.compressions) {
    const std::string what = "--compress takes ascending numbers between 0 and 1, plate travel over height; ";
    require(c != 0, what + "at 0 the body is at rest and no force acts; begin with a larger number");
    require(std::isfinite(c) && c > 0 && c < 1, what + number(c) + " is not such a number");
    require(c > before, what + number(c) + " is not larger than " + number(before) + ", which stands before it");
    before = c;
  }
  if (options.volume != VolumeTreatment::tets && !fem::can_average_volume(options.solver.material)) {
    throw Error("the energy of '" + options.solver.material +
                "' has no separate volume part to average; write --volume tets, or choose another --material");
  }
  const fem::NewtonSettings& newton = options.solver.newton;
  const fem::PreconditionerRow& preconditioner = fem::row_of(newton.preconditioner.kind);
  require(newton.product == fem::Product::assembled || (preconditioner.asked & fem::asks::edges) == 0,
          "--product matrix-free requires --preconditioner " + fem::preconditioners_without(fem::asks::edges) + ": " +
              preconditioner.name + " is formed from blocks of edges, which this product does not have");
  require(
      options.volume != VolumeTreatment::nodes || newton.product == fem::Product::assembled,
      "--volume nodes requires --product assembled: --product matrix-free, which --historical uses, too, has only the "
      "tangents of tets and patches");
  require(
      options.plates == Plates::held || newton.product == fem::Product::assembled,
      "--plates contact requires --product assembled: --product matrix-free, which --historical uses, too, has only "
      "the stiffness of tets");
  require(!options.restart || !options.out.empty(), "--restart continues the run in --out DIR; add --out");
  require(options.refinements == 0 || !options.mesh.empty(),
          "--refine is for a mesh of your own; for the cube, write more --cells");
}

}  // namespace

std::string built_layout() { return PHYSGEN_TRUTHCUBE_LAYOUT; }

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  options.solver.youngs_modulus = 15e3;
  options.solver.poissons_ratio = 0.49;
  CLI::App app{about, "truthcube"};
  app.footer(footer);
  app.option_defaults()->always_capture_default();
  app.set_help_flag("-h,--help", "this text");
  auto* cells = app.add_option("--cells", options.cells, "the cube in N^3 cells of 6 tets; powers of two are fastest")
                    ->check(whole_number(1, 100000))
                    ->type_name("N");
  const auto* grading =
      app.add_option(
             "--grading", options.grading,
             "how much the cells of the cube narrow towards all faces, where errors come from: corner k of N/2 lies "
             "at 40 mm (2 k/N)^G; 1 is uniform. From 1.25 to 1.75 a larger G brings beads nearer to those of finer "
             "cells, and solves take longer")
          ->type_name("G");
  app.add_option("--mesh", options.mesh,
                 "a mesh of tets in Gmsh's format (.msh of version 2.2 or 4.1; physgen-convert-mesh makes one of .inp, "
                 ".vtu and others), in metres, in place of the cube; its plates hold its lowest and highest nodes "
                 "along z")
      ->excludes(cells)
      ->type_name("FILE");
  app.add_option("--case", options.case_file,
                 "a case in JSON: a mesh with groups, its material, and on groups supports, displacements, forces, "
                 "tractions, pressures and gravity, step by step, in place of the plates")
      ->type_name("FILE");
  app.add_option("--refine", options.refinements,
                 "cut each tet of the mesh into 8, so many times; --stepping nested needs 1 at least")
      ->check(whole_number(0, 6))
      ->type_name("N");
  const auto* order = add_choice(
      app, "--order", options.order, orders, "order",
      "in which order the solver stores nodes and tets of the mesh: by their numbers in the file (mesh), or in 64 "
      "compact parts found by METIS (metis), faster where neighbours have numbers far apart; files keep the file's "
      "numbers");
  add_choice(
      app, "--scene", options.scene, scene_kinds, "scene",
      "the problem that is solved: equilibria by Newton's method with any of the choices below (everything); the same "
      "over arrays of the one scene alone, in float, of stable Neo-Hookean bodies (quasistatic), also without blocks "
      "of edges (matrix-free), or of fixed corotated ones (fixed-corotated); motion in time by backward Euler "
      "(implicit-dynamics; of stable Neo-Hookean bodies in float where --material and --precision say nothing else) or "
      "symplectic Euler (explicit-dynamics); equilibria for small strain (linear-elastic)");
  add_choice(app, "--material", options.solver.material, materials(), "material", "law of elasticity");
  app.add_option("--young", options.solver.youngs_modulus, "Young's modulus [Pa]")->type_name("E");
  app.add_option("--poisson", options.solver.poissons_ratio, "Poisson's ratio, above -1 and below 0.5")
      ->type_name("NU");
  auto* volume = add_choice(
      app, "--volume", options.volume, volumes, "treatment of volume",
      "change of volume by tets, which lock near 0.5, or averaged: over patches of about six tets, or at nodes, over "
      "the tets of each, which takes 1.7 times the memory; of the beads of 16^3 cells the largest error is up to 21 % "
      "smaller than by patches at 0.45 and 0.49, the RMS is smaller in 9 of 12 cases, and at 0.499 both are larger");
  add_choice(app, "--top", options.top, tops, "plate", "how the upper plate holds the body; the lower is bonded");
  add_choice(app, "--plates", options.plates, plate_kinds, "kind of plates",
             "held: they act only on the nodes that they hold; contact: they also push back sides that reach them");
  const auto* plate_stiffness =
      app.add_option("--plate-stiffness", options.solver.plane_stiffness,
                     "with --plates contact: stiffness per area, in E over the mean spacing of nodes")
          ->type_name("F");
  const auto* plate_tolerance =
      app.add_option(
             "--plate-tolerance", options.plate_tolerance,
             "the plates of a mesh hold the nodes that lie within T mean edge lengths of its lowest and highest, 0 "
             "to 0.5; a warning says where others lie just beyond")
          ->type_name("T");
  app.add_option("--compress", options.compressions, "plate travel over height, a step each, ascending")
      ->expected(1, -1)
      ->type_name("C");
  app.add_option("--duration", options.motion.duration, "duration of a motion [s]; the plate moves in its first half")
      ->type_name("T");
  app.add_option("--time-step", options.motion.time_step,
                 "largest time step [s]; 0: implicit-dynamics takes a hundredth of the duration, explicit-dynamics "
                 "half of the stable one")
      ->type_name("DT");
  app.add_option("--frames", options.motion.frames, "number of states of a motion that are written, evenly in time")
      ->check(whole_number(1, 100000))
      ->type_name("N");
  app.add_option("--density", options.motion.density, "density of a body that moves [kg/m^3]")->type_name("RHO");
  app.add_option("--damping", options.motion.damping,
                 "damping of a body that moves [1/s]: the force -D m v on each node")
      ->type_name("D");
  app.add_flag("--fixed-order", options.motion.fixed_order,
               "explicit-dynamics on CUDA: forces on nodes are summed in a fixed order, so that a motion has the same "
               "bits on every run; it takes longer, and 80 bytes more per tet in float. On the CPU it is always so");
  add_choice(app, "--device", options.solver.device, devices, "device", "device that solves");
  auto* precision =
      add_choice(app, "--precision", options.solver.precision, precisions, "precision",
                 "numbers of the tangent and its solver; half: in float, the preconditioner's matrices in half. "
                 "States and forces are in double");
  app.add_option_function<std::string>("--layout", require_built,
                                       "layout of all arrays, a choice of the build; schema: as schemas/*.h say, nodes "
                                       "in padded records, elements in tiles")
      ->type_name("{" + built_layout() + "}")
      ->default_str(built_layout());
  auto* preconditioner =
      add_choice(app, "--preconditioner", options.solver.newton.preconditioner.kind, preconditioners, "preconditioner",
                 "preconditioner of conjugate gradients; for a mesh without a coarser one: " +
                     fem::preconditioners_without(fem::asks::coarser));
  auto* product =
      add_choice(app, "--product", options.solver.newton.product, products, "product",
                 "product of the tangent with vectors: from assembled blocks of nodes and edges, or matrix-free, "
                 "tet by tet, which takes less memory, under --preconditioner " +
                     fem::preconditioners_without(fem::asks::edges));
  app.add_option("--tolerance", options.solver.newton.tolerance,
                 "largest relative residual of an equilibrium, 1e-14 to 0.1")
      ->type_name("T");
  auto* stepping =
      add_choice(app, "--stepping", options.solver.nested, steppings, "way of stepping",
                 "nested: each load on coarser meshes first; loads: the plate moves inside the first linear solve");
  app.add_flag("--historical", options.historical,
               "as in 2005: matrix-free plain conjugate gradients in float, no line search, no nesting, an absolute "
               "tolerance of 1e-3 N or --tolerance times E times the squared height, whichever is smaller")
      ->excludes(precision)
      ->excludes(preconditioner)
      ->excludes(product)
      ->excludes(stepping);
  app.add_option(
         "--out", options.out,
         "folder for cube.vtkhdf, cube.xdmf, run.json and checkpoint.h5; beads.csv or, of a case, groups.csv and "
         "probes.csv; and order.h5 with --order metis")
      ->type_name("DIR");
  const auto* output = add_choice(
      app, "--output", options.output, outputs, "output",
      "what cube.vtkhdf has: the body, all its nodes and tets; or its surface alone, triangles with the values "
      "of the tets behind them and, of a case, its groups");
  app.add_flag("--restart", options.restart, "continue after the last step in --out");
  app.add_option("--beads", options.beads, "a table of measured beads (x,y,z,ux,uy,uz in metres) to compare with")
      ->type_name("FILE");
  app.add_option("--repeat", options.repetitions,
                 "solve all steps so often again and print the shortest times: the first solve of a program loads and "
                 "records kernels")
      ->check(whole_number(0, 1000))
      ->type_name("N");
  app.add_option("--threads", options.threads,
                 "threads on the CPU; 0: as OMP_NUM_THREADS says, or one for each processor that it may use")
      ->check(whole_number(0, 4096))
      ->type_name("N");
  app.add_option("--replicate", options.replicate,
                 "with several ranks: coarser meshes of more than N nodes are cut among them, too; 0: those that have "
                 "more than 50653 nodes, and eight blocks of 2048 nodes for each rank")
      ->check(whole_number(0, 2147483647))
      ->type_name("N");
  app.add_option("--window", options.window)->group("");  // for tests: in no help
  app.add_flag("--timings", options.timings,
               "print what each stage of the set-up takes, beside the bytes that it moves at least");
  app.add_flag("--dry-run", options.dry_run, "print sizes and bytes only");
  app.add_flag("--set-up", options.set_up_only,
               "make all that the first Newton step needs, print the stages as --timings does, write run.json into "
               "--out, and end: what a run of the same flags takes before it solves");
  app.add_flag("-q,--quiet", options.quiet, "print warnings and errors only");
  options.help = parse_words(app, arguments);
  if (!options.help.empty()) return options;
  const auto given = [&app](const std::string& flag) { return app.get_option(flag)->count() > 0; };
  if (options.is_case()) apply_case(options, given);
  apply_scene(options, given);
  if (volume->count() == 0 && options.volume != VolumeTreatment::tets &&
      !fem::can_average_volume(options.solver.material)) {
    options.volume = VolumeTreatment::tets;
    options.notes.push_back("the energy of '" + options.solver.material +
                            "' has no separate volume part to average: --volume tets, which locks near a "
                            "Poisson's ratio of 0.5");
  }
  for (const char* flag : {"--dry-run", "--restart", "--repeat", "--beads"}) {
    require(!options.set_up_only || !given(flag), std::string("--set-up cannot take ") + flag +
                                                      ", because it ends before the first Newton step, with " +
                                                      "everything made; remove " + flag);
  }
  require(plate_stiffness->count() == 0 || options.plates == Plates::contact,
          "--plate-stiffness requires --plates contact; add it, or remove --plate-stiffness");
  require(plate_tolerance->count() == 0 || !options.is_cube(),
          "--plate-tolerance is for a mesh of your own: the faces of the cube are flat; remove --plate-tolerance");
  require(output->count() == 0 || !options.out.empty(),
          "--output says what the files in --out DIR have; add --out, or remove --output");
  check_order(options, order->count() > 0);
  require(grading->count() == 0 || options.is_cube(),
          "--grading is for the cube: a mesh of your own has the cells that its file says; remove --grading");
  if (options.historical) {
    options.solver.nested = false;
    options.solver.precision = fem::TangentPrecision::float32;
    options.solver.newton.preconditioner.kind = fem::Preconditioner::none;
    options.solver.newton.product = fem::Product::matrix_free;
    options.solver.newton.line_search = false;
  }
  check(options);
  return options;
}

}  // namespace physgen::truthcube
