// See emitter.h. This file holds what surrounds the objects: head, includes, namespaces.
#include "emit/emitter.h"

#include <set>

#include "emit/pieces.h"
#include "plan/proof.h"

namespace physgen::emit {
namespace {

void head(Printer& out, const model::Schema& schema) {
  out.comment("//", "Accessor classes of the object types in " + schema.file +
                        ". Written by physgen: change the schema, not this file.");
  out.line("#pragma once");
  out.line();
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
  std::string text = std::move(out).text();
  text.pop_back();  // every object and namespace ends with an empty line
  return text;
}

}  // namespace physgen::emit
