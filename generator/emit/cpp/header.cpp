// See header.h. This file writes the frame of the objects: head, includes, namespaces.
#include "emit/cpp/header.h"

#include <cctype>
#include <cstdint>
#include <cstdio>
#include <set>

#include "emit/cpp/pieces.h"
#include "emit/file_name.h"
#include "plan/proof.h"

namespace physgen::emit::cpp {
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
  out.line("#error \"" + file_name(schema.file, ending) + " is for version " + version +
           " of the physgen runtime: generate it again with the installed physgen\"");
  out.line("#endif");
  out.line("#ifdef PHYSGEN_SCHEMA_H");
  out.line("#error \"a program includes " + file_name(schema.file, ending) +
           " in place of the schema: remove the #include of the schema\"");
  out.line("#endif");
  out.line("#define PHYSGEN_GENERATED_HEADER");
  out.line();
  std::set<std::string> headers;
  for (const model::Object& object : schema.imported) {
    if (!object.schema.empty()) headers.insert(file_name(object.schema, ending));
  }
  for (const std::string& header : headers) out.line("#include \"" + header + "\"");
  if (!headers.empty()) out.line();
}

void object_code(Printer& out, const plan::Record& host, const plan::Record& cuda) {
  const model::Object& object = *host.object;
  std::string title = "// ---- " + object.name + " ";
  out.line(title.append(Printer::columns - std::min(Printer::columns, title.size()), '-'));
  out.line();
  value_struct(out, object);
  out.line();
  formats_struct(out, object);
  out.line();
  probe_struct(out, host);
  out.line();
  record_struct(out, object);
  out.line();
  ref_class(out, object);
  out.line();
  object_tag(out, host, cuda);
  out.line();
}

// Explains the pieces that each object has, once for all of them.
void explain(Printer& out) {
  const auto paragraph = [&](const char* text) {
    out.line("//");
    out.comment("//", text);
  };
  paragraph("Of each object type X:");
  for (const char* piece :
       {"X<Real> is the value of one object, all its fields. Real is float, double, or a SIMD batch of one of them.",
        "XFormats<Space> says how each field is stored in a memory space. To change a field's format, derive a struct "
        "from it, redeclare the field's alias there, and pass the struct as the last argument of XArray.",
        "XProbe are formats that tell reads and writes apart for the array that the tag ArrayTag names; see "
        "<physgen/probe.h>. The list of fields of Object has the first of these as number first.",
        "XRecord<Real, Formats> says where each field lies in the record of one object, and as what.",
        "XRef<Real, Formats, Cursor> has the accessors of one object of an array, or of those under a SIMD index: a "
        "function for each field; get() and put() load and store all of them.",
        "XObject is what the runtime knows of the type; XView and XArray are what programs name."})
    out.comment("//  ", piece);
  paragraph(
      "The static_asserts compare what physgen planned with what the compiler finds, with Real = float and with "
      "Real = double: bytes and alignment of a record, and the offsets of its fields. physgen has proved of them, for "
      "every layout and every number of objects, that no two channels share a byte, and that each is aligned to its "
      "elements and lies inside its tile.");
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
  explain(file);
  file.line("#ifndef " + guard);
  file.line("#define " + guard);
  file.line();
  return std::move(file).text() + body + "#endif  // " + guard + "\n";
}

}  // namespace physgen::emit::cpp
