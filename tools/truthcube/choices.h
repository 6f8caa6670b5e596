// The names of what flags choose among.
#pragma once

#include <fem/solver/settings.h>

#include <string>

#include "names.h"
#include "options.h"

namespace physgen::truthcube {

extern const Names<VolumeTreatment> volumes;
extern const Names<TopPlate> tops;
extern const Names<Plates> plate_kinds;
extern const Names<Output> outputs;
extern const Names<NodeOrder> orders;
extern const Names<fem::Device> devices;
extern const Names<fem::TangentPrecision> precisions;
extern const Names<fem::Preconditioner> preconditioners;
extern const Names<bool> steppings;  ///< whether nested
extern const Names<fem::Product> products;
[[nodiscard]] Names<std::string> materials();

}  // namespace physgen::truthcube
