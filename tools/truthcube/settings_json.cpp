#include "settings_json.h"

#include <nlohmann/json.hpp>

#include "arrays.h"
#include "choices.h"
#include "scene_choice.h"

namespace physgen::truthcube {

std::string settings_json(const Options& options) {
  nlohmann::json json;
  json["scene"] = name_of(scene_kinds, options.scene);
  json["arrays"] = arrays_of(options);
  if (options.moves()) {
    json["time_step"] = options.motion.time_step;
    json["duration"] = options.motion.duration;
    json["density"] = options.motion.density;
    json["damping"] = options.motion.damping;
    json["frames"] = options.motion.frames;
    if (options.scene == SceneKind::explicit_dynamics) json["fixed_order"] = options.motion.fixed_order;
  }
  if (options.is_cube()) {
    json["cells"] = options.cells;
    json["grading"] = options.grading;
  } else {
    json["refine"] = options.refinements;
    if (options.order != NodeOrder::mesh) json["order"] = name_of(orders, options.order);
    if (!options.is_case()) json["plate_tolerance"] = options.plate_tolerance;
  }
  if (options.is_case()) json["case"] = nlohmann::json::parse(options.given_case.text);
  json["material"] = options.solver.material;
  json["young"] = options.solver.youngs_modulus;
  json["poisson"] = options.solver.poissons_ratio;
  json["volume"] = name_of(volumes, options.volume);
  if (!options.is_case()) {
    json["top"] = name_of(tops, options.top);
    json["plates"] = name_of(plate_kinds, options.plates);
  }
  if (options.plates == Plates::contact) json["plate_stiffness"] = options.solver.plane_stiffness;
  json["precision"] = name_of(precisions, options.solver.precision);
  json["preconditioner"] = name_of(preconditioners, options.solver.newton.preconditioner.kind);
  json["product"] = name_of(products, options.solver.newton.product);
  json["tolerance"] = options.solver.newton.tolerance;
  json["stepping"] = options.solver.nested ? "nested" : "loads";
  if (options.output != Output::body) json["output"] = name_of(outputs, options.output);
  json["historical"] = options.historical;
  return json.dump();
}

}  // namespace physgen::truthcube
