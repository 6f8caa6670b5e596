#include "options.h"

#include <physgen/error.h>
#include <truthcube/command_line.h>
#include <truthcube/sizes.h>

#include <cmath>

namespace physgen::truthcube {

namespace {

constexpr const char* about =
    R"(Measures one linear solve of the Truth Cube, K dx = -f with K at rest or compressed and a scattered right-hand
side f, by several methods and to equal residuals. Prints a line for each: times of assembly, of the preconditioner's
set-up and of the solve (medians; the first solve is not counted), iterations, and the residual |f + K dx| / |f| of
free components, which is computed anew in double from the blocks of K and the step.)";

constexpr const char* footer =
    R"(Every method ends when the 2-norm of the residual that its iterations carry along is below the tolerance (--norm
preconditioned: sqrt(r . z), as the solver's Newton steps use it). In float that residual drifts from the one that is
printed, the more the more iterations there are.
Exit status: 0 done, 1 a file or the memory failed, 2 wrong use, 3 a solve has not converged.)";

const Names<VolumeTreatment> volumes{{"tets", VolumeTreatment::tets}, {"patches", VolumeTreatment::patches}};
const Names<fem::Device> devices{{"cpu", fem::Device::cpu},
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
                                 {"cuda", fem::Device::cuda}
#endif
};
const Names<fem::TangentPrecision> precisions{{"half", fem::TangentPrecision::half},
                                              {"float", fem::TangentPrecision::float32},
                                              {"double", fem::TangentPrecision::float64}};
const Names<Method> methods{{"multigrid", Method::multigrid},
                            {"schwarz", Method::schwarz},
                            {"block-jacobi", Method::block_jacobi},
                            {"none", Method::none},
                            {"vendor", Method::vendor}};
const Names<fem::LinearNorm> norms{{"euclidean", fem::LinearNorm::euclidean},
                                   {"preconditioned", fem::LinearNorm::preconditioned}};

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(what);
}

bool has(const std::vector<Method>& methods, Method method) {
  return std::ranges::find(methods, method) != methods.end();
}

void check(const LinearOptions& options) {
  for (const double nu : options.poissons_ratios) {
    require(nu > -1 && nu < 0.5, "--poisson " + std::to_string(nu) + ": Poisson's ratio is above -1 and below 0.5");
  }
  require(
      options.tolerance >= 1e-14 && options.tolerance <= 0.1,
      "--tolerance " + std::to_string(options.tolerance) + ": the residual's tolerance is a number from 1e-14 to 0.1");
  require(options.compression >= 0 && options.compression < 1,
          "--compress " + std::to_string(options.compression) + ": plate travel over height is from 0 to below 1");
  for (const int cells : options.cells) {
    require_cube_fits(cells, options.volume);
    require(cells > 1, "--cells 1: the plates hold every node; 2 cells have one that is free");
    require(!has(options.methods, Method::multigrid) || cells % 2 == 0 || cells < 5,
            "--cells " + std::to_string(cells) +
                ": an odd number of cells has no coarser mesh for --method multigrid; " + std::to_string(cells + 1) +
                " cells have one");
  }
  if (has(options.methods, Method::vendor)) {
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
    require(options.device == fem::Device::cuda,
            "--method vendor is cuSPARSE, which runs on GPUs: write --device cuda");
#else
    throw Error("--method vendor is cuSPARSE, and this build has no CUDA: configure it with -DPHYSGEN_CUDA=ON");
#endif
  }
}

}  // namespace

std::string name_of(Method method) { return name_of(methods, method); }
std::string name_of(fem::TangentPrecision precision) { return name_of(precisions, precision); }
std::string name_of(fem::LinearNorm norm) { return name_of(norms, norm); }
std::string name_of(VolumeTreatment volume) { return name_of(volumes, volume); }

LinearOptions parse_linear(const std::vector<std::string>& arguments) {
  LinearOptions options;
  CLI::App app{about, "linear_solves"};
  app.footer(footer);
  app.option_defaults()->always_capture_default();
  app.set_help_flag("-h,--help", "this text");
  app.add_option("--cells", options.cells, "cubes of N^3 cells of 6 tets, one after the other")
      ->check(whole_number(1, 100000))
      ->expected(1, -1)
      ->type_name("N");
  app.add_option("--poisson", options.poissons_ratios, "Poisson's ratios, above -1 and below 0.5")
      ->expected(1, -1)
      ->type_name("NU");
  add_choice(app, "--volume", options.volume, volumes, "treatment of volume",
             "change of volume by tets, or averaged over patches of about six");
  app.add_option("--compress", options.compression, "plate travel over height where K is taken; 0: at rest")
      ->type_name("C");
  add_choices(app, "--method", options.methods, methods, "method",
              "conjugate gradients with these preconditioners; vendor: with block Jacobi over cuSPARSE's block sparse "
              "product, in float, on CUDA alone");
  add_choices(app, "--precision", options.precisions, precisions, "precision",
              "half: in float, the matrices of multigrid and Schwarz blocks in half; other methods have nothing in "
              "half, and are "
              "then in float");
  add_choices(app, "--norm", options.norms, norms, "norm", "the norm of the residual that --tolerance bounds");
  app.add_option("--tolerance", options.tolerance, "largest norm of the residual over its first value, 1e-14 to 0.1")
      ->type_name("T");
  app.add_option("--repeat", options.repeats, "solves behind the first, which is not counted; times are their medians")
      ->check(whole_number(1, 1000))
      ->type_name("N");
  app.add_flag("--copies", options.copies,
               "compare a product of the stiffness, and an iteration, with the device's copy of as many bytes");
  add_choice(app, "--device", options.device, devices, "device", "device that solves");
  app.add_option("--output", options.output, "JSON file of the rows")->type_name("FILE");
  app.add_option("--threads", options.threads,
                 "threads on the CPU; 0: as OMP_NUM_THREADS says, or one for each processor that it may use")
      ->check(whole_number(0, 4096))
      ->type_name("N");
  options.help = parse_words(app, arguments);
  if (options.help.empty()) check(options);
  return options;
}

}  // namespace physgen::truthcube
