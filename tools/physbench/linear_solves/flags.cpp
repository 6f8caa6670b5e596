#include "linear_solves/flags.h"

#include <physgen/error.h>
#include <truthcube/choices.h>
#include <truthcube/command_line.h>
#include <truthcube/sizes.h>

#include <algorithm>

namespace physgen::bench {

namespace {

using truthcube::devices, truthcube::precisions;
using truthcube::Names;
using truthcube::VolumeTreatment;

const Names<VolumeTreatment> volumes{{"tets", VolumeTreatment::tets}, {"patches", VolumeTreatment::patches}};
const Names<Method> methods = [] {
  Names<Method> names;
  for (const fem::PreconditionerRow& row : fem::preconditioner_rows) names.emplace_back(row.name, row.kind);
  names.emplace_back("vendor", vendor);
  return names;
}();
const Names<fem::LinearNorm> norms{{"euclidean", fem::LinearNorm::euclidean},
                                   {"preconditioned", fem::LinearNorm::preconditioned}};

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(what);
}

bool has(const std::vector<Method>& methods, Method method) {
  return std::ranges::find(methods, method) != methods.end();
}

}  // namespace

std::string name_of(Method method) { return truthcube::name_of(methods, method); }
std::string name_of(fem::TangentPrecision precision) { return truthcube::name_of(precisions, precision); }
std::string name_of(fem::LinearNorm norm) { return truthcube::name_of(norms, norm); }
std::string name_of(VolumeTreatment volume) { return truthcube::name_of(volumes, volume); }

void add_solve_flags(CLI::App& app, SolveFlags& flags) {
  const auto several = [](CLI::Option* option) { option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll); };
  several(app.add_option("--cells", flags.cells, "cubes of N^3 cells of 6 tets, one after the other (default: 16)")
              ->check(truthcube::whole_number(1, 100000))
              ->expected(1, -1)
              ->type_name("N"));
  several(app.add_option("--poisson", flags.poissons_ratios, "Poisson's ratios, above -1 and below 0.5")
              ->expected(1, -1)
              ->type_name("NU"));
  truthcube::add_choice(app, "--volume", flags.volume, volumes, "treatment of volume",
                        "change of volume by tets, or averaged over patches of about six");
  app.add_option("--compress", flags.compression, "plate travel over height where K is taken; 0: at rest")
      ->type_name("C");
  several(truthcube::add_choices(app, "--method", flags.methods, methods, "method",
                                 "conjugate gradients with these preconditioners; vendor: with block Jacobi over "
                                 "cuSPARSE's block sparse product, in float, on CUDA alone"));
  several(truthcube::add_choices(app, "--precision", flags.precisions, precisions, "precision",
                                 "half: in float, the preconditioner's matrices in half; methods without such matrices "
                                 "run in float"));
  several(truthcube::add_choices(app, "--norm", flags.norms, norms, "norm",
                                 "the norm of the residual that --tolerance bounds"));
  app.add_option("--tolerance", flags.tolerance, "largest norm of the residual over its first value, 1e-14 to 0.1")
      ->type_name("T");
  app.add_option("--repeat", flags.repeats, "solves behind the first, which is not counted; times are their medians")
      ->check(truthcube::whole_number(1, 1000))
      ->type_name("N");
  truthcube::add_choice(app, "--device", flags.device, devices, "device", "device that solves");
}

void check(const SolveFlags& flags) {
  for (const double nu : flags.poissons_ratios) {
    require(nu > -1 && nu < 0.5,
            "--poisson " + std::to_string(nu) + ": Poisson's ratio must be above -1 and below 0.5");
  }
  require(flags.tolerance >= 1e-14 && flags.tolerance <= 0.1,
          "--tolerance " + std::to_string(flags.tolerance) +
              ": the residual's tolerance must be a number from 1e-14 to 0.1");
  require(flags.compression >= 0 && flags.compression < 1,
          "--compress " + std::to_string(flags.compression) + ": plate travel over height must be from 0 to below 1");
  for (const int cells : flags.cells) {
    truthcube::require_cube_fits(cells, flags.volume);
    require(cells > 1, "--cells 1: the plates hold every node; 2 cells have one that is free");
    require(!has(flags.methods, fem::Preconditioner::multigrid) || cells % 2 == 0 || cells < 5,
            "--cells " + std::to_string(cells) +
                ": an odd number of cells has no coarser mesh for --method multigrid; " + std::to_string(cells + 1) +
                " cells have one");
  }
  if (has(flags.methods, vendor)) {
#ifdef PHYSGEN_BENCH_HAS_CUDA
    require(flags.device == fem::Device::cuda, "--method vendor is cuSPARSE, which runs on GPUs: write --device cuda");
#else
    throw Error("--method vendor is cuSPARSE, and this build has no CUDA: configure it with -DPHYSGEN_CUDA=ON");
#endif
  }
}

}  // namespace physgen::bench
