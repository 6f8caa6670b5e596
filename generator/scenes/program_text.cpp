// See program_text.h.
#include "scenes/program_text.h"

#include <map>
#include <utility>

#include "emit/printer.h"
#include "scenes/header.h"
#include "scenes/local_arrays.h"

namespace physgen::scenes {
namespace {

/// The statement, with its line where nothing else stands there.
Span line_of(const std::string& text, const Span& statement) {
  const std::size_t before = text.find_last_not_of(" \t", statement.begin - 1);
  const std::size_t behind = text.find_first_not_of(" \t", statement.end);
  return text[before] == '\n' && text[behind] == '\n' ? Span{before + 1, behind + 1} : statement;
}

std::string fused(const std::string& text, const ProgramSteps& list, const StepGroup& group) {
  const ProgramStep& last = list.steps[group.last];
  const std::size_t line = text.rfind('\n', last.statement.begin) + 1;
  const std::string indent = "\n" + text.substr(line, text.find_first_not_of(" \t", line) - line) + "    ";
  std::string result = text.substr(last.statement.begin, last.count.end - last.statement.begin) + ", ::physgen::fuse(" +
                       indent + "::physgen::locals(";
  for (const std::string& local : group.locals)
    result += (&local == &group.locals.front() ? "" : ", ") + local + ".view()";
  result += ")";
  for (std::size_t k = group.first; k <= group.last; ++k) {
    const Span& kernel = list.steps[k].kernel;
    const std::string words =
        text.substr(kernel.begin, text.find_last_not_of(" \t\n", kernel.end - 1) + 1 - kernel.begin);
    result += "," + indent + words + (words.find("//") == std::string::npos ? "" : "\n");  // what follows is no comment
  }
  return result + "));";
}

}  // namespace

std::string joined_text(const Needs& needs, const ProgramText& program) {
  std::map<std::size_t, std::pair<std::size_t, std::string>> edits;  // where they begin and end, and the new text
  for (const StepGroup& group : needs.groups) {
    const ProgramSteps& list = program.lists[group.list];
    for (std::size_t k = group.first; k < group.last; ++k) {
      const Span line = line_of(program.text, list.steps[k].statement);
      edits[line.begin] = {line.end, ""};
    }
    const Span& last = list.steps[group.last].statement;
    edits[last.begin] = {last.end, fused(program.text, list, group)};
  }
  std::string text;
  std::size_t at = 0;
  for (const auto& [begin, edit] : edits) {
    text += program.text.substr(at, begin - at) + edit.second;
    at = edit.first;
  }
  return text + program.text.substr(at);
}

std::string program_header(const Scene& scene, const Needs& needs, const ProgramText& program) {
  const std::string space = scene.qualified_name() + "_scene", original = "::" + scene.qualified_name();
  emit::Printer out;
  out.comment("//", "The program of the scene " + scene.name + " over its arrays: " + space +
                        "::fused::program(on, ...). Written by physgen from " + scene.include +
                        ": change that, not this file.");
  out.line("#pragma once");
  out.line();
  if (!needs.groups.empty()) {
    out.line("#include <physgen/fuse.h>");
    out.line();
  }
  out.line("#include \"" + scene.include + "\"");
  out.line("#include \"" + file_of(scene) + "\"");
  out.line();
  out.line("namespace " + space + " {");
  out.line();
  if (needs.groups.empty()) {
    out.comment("///", "The scene: none of its program's steps are joined.");
    out.line("using fused = " + original + ";");
  } else {
    std::string comment = "The scene with a program in which steps are joined:";
    for (const StepGroup& group : needs.groups)
      comment += "\n- " + short_names(group.steps) + "; local to them: " + model::joined(group.locals, " and ");
    out.comment("///", comment);
    out.line("struct fused : " + original + " {");
    out.line("  " + joined_text(needs, program));
    out.line("};");
  }
  out.line();
  out.line("}  // namespace " + space);
  return std::move(out).text();
}

}  // namespace physgen::scenes
