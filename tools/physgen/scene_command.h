// `physgen scene`: from the declaration of a scene to the header of what its program needs, and the reports of why.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace physgen::command {

struct SceneRequest {
  std::string file;                ///< the declaration
  std::string output_dir;          ///< empty: the report goes to standard output, and nothing is written
  std::string why;                 ///< an array or field to explain; empty: none
  std::vector<std::string> flags;  ///< as of a compiler
  bool device = false;             ///< also what the program does on a CUDA device
  bool everything = false;         ///< also x.everything.h, with every field
  bool no_fuse = false;            ///< join no steps
  bool print_model = false;        ///< what the declaration says, as JSON, and nothing else
  bool print_unit = false;         ///< the unit that is analysed, and nothing else
  std::string precompiled;         ///< of `physgen precompile` with these flags; empty: none
  std::string depfile, stamp;      ///< as of `physgen generate`; empty: none
};

void describe_scene(CLI::App& app, SceneRequest& request);

/// @return exit status as run()'s: 1 where the declaration, its program or its needs have errors
/// @throws FileError, scenes::UnknownName
int scene(const SceneRequest& request, std::ostream& out, std::ostream& err);

}  // namespace physgen::command
