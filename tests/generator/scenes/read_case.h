// A declaration of a scene over objects that stand for generated ones, and the errors that it gets.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "frontend/case.h"
#include "scenes/read.h"

namespace physgen::test {

inline const std::string objects = R"(#include <physgen/scene.h>
#include <array>
#include <string_view>
enum class ElementType { float32, float64, int32, half, bfloat16, snorm16, none, fixed24 };
struct FieldInfo { std::string_view name; ElementType type; int count; double initial; };
struct SvdObject {
  template <class Space> struct Formats {};
  template <class Real, class Formats> static constexpr std::array<FieldInfo, 4> fields = {{
      {"U", ElementType::float32, 9, 0}, {"n", ElementType::int32, 1, 2},
      {"points[0].x", ElementType::float32, 3, 0}, {"points[1].x", ElementType::float32, 3, 0}}};
};
using namespace physgen::scene;
)";

/// Reads `text` behind the objects, as scene.h; line 1 is its first.
inline scenes::Declaration read(const std::string& text) {
  const Folder folder;
  folder.write("objects.h", objects);
  return scenes::read(folder.write("scene.h", "#include \"objects.h\"\n#line 1\n" + text),
                      {"-I", PHYSGEN_RUNTIME_INCLUDE});
}

/// A scene with these arrays in its one group, which begin on line 3, and this behind the group.
inline std::string scene_of(
    const std::string& arrays,
    const std::string& program = "template <class On, class B> static void program(On&, B& body);") {
  return "struct PHYSGEN_SCENE() scene {\nstruct Body {\n" + arrays + "\n};\n" + program + "\n};\n";
}

/// The errors without file names: "4:3: error: ...".
inline std::vector<std::string> errors_of(const std::string& diagnostics) {
  std::vector<std::string> result;
  const std::string mark = "scene.h:";
  std::istringstream lines(diagnostics);
  for (std::string line; std::getline(lines, line);)
    if (const auto place = line.find(mark); place != std::string::npos && line.find("error: ") != std::string::npos)
      result.push_back(line.substr(place + mark.size()));
  return result;
}

struct Wrong {
  std::string name, text;
  std::vector<std::string> expected;
};
inline void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

inline const std::string svds = "PHYSGEN_ARRAY(per(\"tet\")) Array<SvdObject, float> svds;";

}  // namespace physgen::test
