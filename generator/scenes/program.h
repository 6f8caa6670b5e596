// The steps of a scene's program as its text has them: which stand one behind the other, what their kernels do with
// each object, and where in the text they stand. read_program.h fills it; the groups and the fused program are made of
// it. Nothing of Clang appears here.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "usage/usage.h"

namespace physgen::scenes {

/// Bytes of ProgramText::text: begin .. end-1.
struct Span {
  std::size_t begin = 0, end = 0;
  bool operator==(const Span&) const = default;
};

/// A statement `on.run(count, kernel);`.
struct ProgramStep {
  std::string step;  ///< as name_of() calls it
  usage::Place place;
  Span statement, count, kernel;  ///< the first with its semicolon
  std::string runs;               ///< "per tet of body", "once", "n": the same for counts that are surely equal
  bool takes_packs = false;
  int scalar_bytes = 0;
  std::set<std::pair<std::string, std::string>> stores;  ///< (array, field) that it stores whole, on all its paths
  std::string obstacle;  ///< why it cannot be joined to any other: "calls log(), ..."; empty: it can
  bool operator==(const ProgramStep&) const = default;
};

/// Steps of one compound statement, in order.
struct ProgramSteps {
  std::vector<ProgramStep> steps;
  /// The statement before steps[k+1] that cannot stand before steps[k]: "on.reduce() at x.h:3:5"; empty: none.
  std::vector<std::string> between;
  bool operator==(const ProgramSteps&) const = default;
};

struct ProgramText {
  std::string text;   ///< of the declaration of program(), from 'template' to the last brace
  std::string cause;  ///< why it cannot be written anew: "a macro writes it"; empty: it can
  std::vector<ProgramSteps> lists;
  std::map<std::string, int> runs;               ///< of each step: how many statements of the program's own text run it
  std::map<std::string, std::string> elsewhere;  ///< step, and the function that runs it, other than the program
  /// Arrays of which the program takes more than size(), and views that it hands to kernels alone; and what it does.
  std::map<std::string, std::string> used;
  bool operator==(const ProgramText&) const = default;
};

}  // namespace physgen::scenes
