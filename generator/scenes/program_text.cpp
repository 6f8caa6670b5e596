// See program_text.h.
#include "scenes/program_text.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "emit/printer.h"
#include "scenes/header.h"
#include "scenes/local_arrays.h"

namespace physgen::scenes {
namespace {

struct Edit {
  Span span;
  std::string text;
};

std::string part(const std::string& text, const Span& span) { return text.substr(span.begin, span.end - span.begin); }

/// The statement, and its line where nothing else stands there.
Span line_of(const std::string& text, const Span& statement) {
  const std::size_t before = text.find_last_not_of(" \t", statement.begin - 1);
  const std::size_t behind = text.find_first_not_of(" \t", statement.end);
  if (before == std::string::npos || behind == std::string::npos || text[before] != '\n' || text[behind] != '\n')
    return statement;
  return {before + 1, behind + 1};
}

std::string indentation(const std::string& text, std::size_t at) {
  const std::size_t line = text.rfind('\n', at) + 1;
  return text.substr(line, text.find_first_not_of(" \t", line) - line);
}

/// A kernel, so that what follows it is not part of its last comment.
std::string kernel(const std::string& text, const Span& span) {
  std::string result = part(text, span);
  result.erase(result.find_last_not_of(" \t\n") + 1);
  const std::size_t line = result.rfind('\n');
  if (result.find("//", line == std::string::npos ? 0 : line) != std::string::npos) result += '\n';
  return result;
}

std::string fused(const std::string& text, const ProgramSteps& list, const StepGroup& group) {
  const ProgramStep& last = list.steps[group.last];
  const std::string inner = "\n" + indentation(text, last.statement.begin) + "    ";
  std::string result =
      part(text, {last.statement.begin, last.count.end}) + ", ::physgen::fuse(" + inner + "::physgen::locals(";
  for (const std::string& local : group.locals)
    result += (&local == &group.locals.front() ? "" : ", ") + local + ".view()";
  result += ")";
  for (std::size_t k = group.first; k <= group.last; ++k) result += "," + inner + kernel(text, list.steps[k].kernel);
  return result + "));";
}

}  // namespace

std::string joined_text(const Needs& needs, const ProgramText& program) {
  std::vector<Edit> edits;
  for (const StepGroup& group : needs.groups) {
    const ProgramSteps& list = program.lists[group.list];
    for (std::size_t k = group.first; k < group.last; ++k)
      edits.push_back({line_of(program.text, list.steps[k].statement), ""});
    edits.push_back({list.steps[group.last].statement, fused(program.text, list, group)});
  }
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.span.begin > b.span.begin; });
  std::string text = program.text;
  for (const Edit& edit : edits) text.replace(edit.span.begin, edit.span.end - edit.span.begin, edit.text);
  return text;
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
    for (const StepGroup& group : needs.groups) {
      std::vector<std::string> names;
      for (const std::string& step : group.steps) names.push_back(short_name(step));
      comment += "\n- " + model::joined(names, " and ") + "; local to them: " + model::joined(group.locals, " and ");
    }
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
