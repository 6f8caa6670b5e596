// See emitter.h. This file holds what surrounds the objects: head, includes, namespaces.
#include "emit/emitter.h"

#include <cctype>
#include <cstdint>
#include <cstdio>
#include <set>

#include "emit/pieces.h"
#include "plan/proof.h"

namespace physgen::emit {
namespace {

// Names the schema and, by a checksum (FNV-1a), the text: a header that two targets generated from one schema is the
// same to a program that includes both, which #pragma once cannot know, and other schemas of the same file name are
// not.
std::string include_guard(const std::string& schema_file, std::string_view text) {
  std::string guard = "PHYSGEN_";
  for (const char c : schema_file) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter < 0x80 && std::isalnum(letter) != 0)
      guard += static_cast<char>(std::toupper(letter));
    else if (guard.back() != '_')
      guard += '_';
  }
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[20];
  std::snprintf(digits, sizeof digits, "%s%016llX", guard.back() == '_' ? "" : "_",
                static_cast<unsigned long long>(sum));
  return guard + digits;
}

void head(Printer& out, const model::Schema& schema) {
  out.line("#include <physgen/runtime.h>");
  out.line();
  const std::string version = std::to_string(runtime_version);
  out.line("#if PHYSGEN_RUNTIME_VERSION != " + version);
  out.line("#error \"" + model::generated_header(schema.file) + " is for version " + version +
           " of the physgen runtime: generate it again with the installed physgen\"");
  out.line("#endif");
  out.line();
  std::set<std::string> headers;
  for (const model::Object& object : schema.imported) {
    if (!object.header.empty()) headers.insert(object.header);
  }
  for (const std::string& header : headers) out.line("#include \"" + header + "\"");
  if (!headers.empty()) out.line();
}

void object_code(Printer& out, const plan::Record& host, const plan::Record& cuda) {
  const model::Object& object = *host.object;
  std::string title = "// ---- " + object.name + " ";
  out.line(title.append(Printer::columns - std::min(Printer::columns, title.size()), '-'));
  out.line();
  value_struct(out, host);
  out.line();
  formats_struct(out, object);
  out.line();
  probe_struct(out, host);
  out.line();
  record_struct(out, host);
  out.line();
  ref_class(out, host);
  out.line();
  object_tag(out, host, cuda);
  out.line();
}

}  // namespace

std::string accessor_header(const model::Schema& schema) {
  Printer out;
  head(out, schema);
  const plan::Records host(schema, model::Space::host), cuda(schema, model::Space::cuda);
  std::string scope;
  const auto enter = [&](const std::string& next) {
    if (next == scope) return;
    if (!scope.empty()) {
      out.line("}  // namespace " + scope);
      out.line();
    }
    scope = next;
    if (scope.empty()) return;
    out.line("namespace " + scope + " {");
    out.line();
  };
  for (const model::Object& object : schema.objects) {
    const std::string name = object.qualified_name();
    plan::require_sound(host.of(name));
    plan::require_sound(cuda.of(name));
    enter(object.scope);
    object_code(out, host.of(name), cuda.of(name));
  }
  enter("");
  const std::string body = std::move(out).text();  // every object and namespace ends with an empty line
  const std::string guard = include_guard(schema.file, body);
  Printer file;
  file.comment("//", "Accessor classes of the object types in " + schema.file +
                         ". Written by physgen: change the schema, not this file.");
  file.line("#ifndef " + guard);
  file.line("#define " + guard);
  file.line();
  return std::move(file).text() + body + "#endif  // " + guard + "\n";
}

}  // namespace physgen::emit
