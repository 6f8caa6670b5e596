// A scene of blocks, each with two or three steps and arrays of its own, and why physgen keeps the steps apart.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command_case.h"

namespace physgen::test {

/// A block of the program, with M and OUT for arrays of its own between and behind, and the fields wanted of OUT.
struct Block {
  std::string name, text, output;
};

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// @param before the scene, in its file
inline std::string scene_of(const std::vector<Block>& blocks, const std::string& before = {}) {
  std::string arrays, program;
  for (const Block& block : blocks) {
    arrays += "    PHYSGEN_ARRAY(per(\"particle\")) Array<m::ParticleObject, Real> m_" + block.name + ";\n";
    arrays += "    PHYSGEN_ARRAY(per(\"particle\"), output(" + block.output + ")) Array<m::ParticleObject, Real> out_" +
              block.name + ";\n";
    program += "    {\n    " +
               replaced(replaced(block.text, "OUT", "body.out_" + block.name + ".view()"), "M,",
                        "body.m_" + block.name + ".view(),") +
               "\n    }\n";
    program = replaced(program, "M}", "body.m_" + block.name + ".view()}");
  }
  return "#pragma once\n#include <physgen/scene.h>\n#include <physgen/launch/reduce.h>\n#include \"kernels.h\"\n" +
         before +
         "using namespace physgen::scene;\nstruct PHYSGEN_SCENE() groups {\n  using Real = float;\n  struct Body {\n"
         "    PHYSGEN_ARRAY(per(\"particle\"), input()) Array<m::ParticleObject, Real> in;\n"
         "    PHYSGEN_ARRAY(per(\"particle\"), input()) Array<m::LinkObject, Real> links;\n"
         "    PHYSGEN_ARRAY(per(\"particle\")) Array<m::ParticleObject, Real> further;\n"
         "    PHYSGEN_ARRAY(per(\"few\")) Array<m::ParticleObject, Real> few;\n"
         "    PHYSGEN_ARRAY(per(1), output()) Array<m::TotalObject, Real> sum;\n" +
         arrays +
         "  };\n  template <class On, class Body>\n  static void program(On& on, Body& body) {\n"
         "    const auto in = body.in.const_view();\n    const auto links = body.links.const_view();\n"
         "    const auto n = body.in.size();\n" +
         program + "  }\n};\n";
}

/// The report's words on the steps that stay apart, by the name of their block.
struct Apart {
  std::map<std::string, std::string> why, between;
};
inline Apart apart_of(const nlohmann::json& needs, const std::vector<Block>& blocks, const std::string& folder) {
  Apart result;
  for (const auto& apart : needs.at("apart")) {
    const std::string steps = apart.at("first").get<std::string>() + apart.at("second").get<std::string>();
    for (const Block& block : blocks)
      if (steps.find("_" + block.name) != std::string::npos) {
        for (const auto& reason : apart.at("why"))
          result.why[block.name] += replaced(reason.get<std::string>(), folder, "") + "; ";
        for (const auto& field : apart.at("between")) result.between[block.name] += field.get<std::string>() + "; ";
      }
  }
  return result;
}

}  // namespace physgen::test
