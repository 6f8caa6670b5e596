// A case: a file that says what a body is made of, what holds it and what loads it, step by step.
#pragma once

#include <fem/solver/load_case.h>

#include <filesystem>
#include <string>
#include <vector>

namespace physgen::truthcube {

/// A place of the body at rest [m], whose displacement is recorded.
struct Probe {
  std::string name;
  fem::Point at{};
};

struct Case {
  std::filesystem::path mesh;  ///< a path relative to the case's folder is made one of this process
  double scale = 1;            ///< [m] of the mesh's unit of length
  std::string law;             ///< of elasticity; empty: as the command line says
  double young = 0, poisson = 0;
  std::vector<std::string> material_groups;      ///< whose tets have a material of their own
  std::vector<fem::ElasticConstants> of_groups;  ///< the constants of each
  fem::LoadCase load_case;
  std::vector<double> steps{1};  ///< factors of all loads and displacements, one after the other
  std::vector<Probe> probes;
  std::string output;  ///< as --output; empty: as the command line says
  std::string text;    ///< all of the file, as one line of JSON
};

/// Reads a case in JSON, with comments if it has some.
/// @throw Error with the file's name, the place in it (such as loads[1].traction; for what is not JSON the line), what
/// is wrong and a remedy: for an unknown key with the nearest one
[[nodiscard]] Case read_case(const std::filesystem::path& file);

}  // namespace physgen::truthcube
