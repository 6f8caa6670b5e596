#include "choices.h"

namespace physgen::truthcube {

const Names<VolumeTreatment> volumes{
    {"tets", VolumeTreatment::tets}, {"patches", VolumeTreatment::patches}, {"nodes", VolumeTreatment::nodes}};
const Names<TopPlate> tops{{"bonded", TopPlate::bonded}, {"frictionless", TopPlate::frictionless}};
const Names<Plates> plate_kinds{{"held", Plates::held}, {"contact", Plates::contact}};
const Names<Output> outputs{{"body", Output::body}, {"surface", Output::surface}};
const Names<NodeOrder> orders{{"mesh", NodeOrder::mesh}, {"metis", NodeOrder::metis}};
const Names<fem::Device> devices{{"cpu", fem::Device::cpu},
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
                                 {"cuda", fem::Device::cuda}
#endif
};
const Names<fem::TangentPrecision> precisions{{"half", fem::TangentPrecision::half},
                                              {"float", fem::TangentPrecision::float32},
                                              {"double", fem::TangentPrecision::float64}};
const Names<fem::Preconditioner> preconditioners = [] {
  Names<fem::Preconditioner> names;
  for (const fem::PreconditionerRow& row : fem::preconditioner_rows) names.emplace_back(row.name, row.kind);
  return names;
}();
const Names<bool> steppings{{"nested", true}, {"loads", false}};
const Names<fem::Product> products{{"assembled", fem::Product::assembled}, {"matrix-free", fem::Product::matrix_free}};

Names<std::string> materials() {
  Names<std::string> names;
  for (const std::string& name : fem::material_names()) names.emplace_back(name, name);
  return names;
}

}  // namespace physgen::truthcube
