// The need report: every field of every array of a scene, who writes and reads it, and what becomes of it.
#pragma once

#include <stdexcept>
#include <string>

#include "scenes/needs.h"

namespace physgen::scenes {

/// What becomes of a field: "kept", "pruned", "left out", "local" or "uniform".
[[nodiscard]] std::string fate(const Array& array, const ArrayNeed& need, const FieldNeed& field);

/// For people: a table, sums for each set of objects, records, what is read too early, groups, and why.
[[nodiscard]] std::string report_text(const Scene& scene, const Needs& needs);

/// The same as indented JSON, with the places of all uses.
[[nodiscard]] std::string report_json(const Scene& scene, const Needs& needs);

/// A name that there is not; what() says which is nearest.
struct UnknownName : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Explains the fate of a field, or of all fields of an array, and which lines of which kernels decide it.
/// @param name "body.svds.U", "svds.U", "DeformationSvd.U", "elasticity::DeformationSvd.U", "body.svds", "svds"
/// @throws UnknownName
[[nodiscard]] std::string report_why(const Scene& scene, const Needs& needs, const std::string& name);

/// "force_chain.h:12:5: error: ...": an issue in one line.
[[nodiscard]] std::string text_of(const Issue& issue);

}  // namespace physgen::scenes
