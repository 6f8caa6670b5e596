// See records.h.
#include "scenes/records.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>

#include "frontend/constants.h"

namespace physgen::scenes {
namespace {

const clang::VarDecl* variable(clang::ASTContext& context, llvm::StringRef name) {
  for (const auto* space : context.getTranslationUnitDecl()->lookup(&context.Idents.get("physgen_probe_unit")))
    if (const auto* unit = llvm::dyn_cast<clang::NamespaceDecl>(space))
      for (const auto* found : unit->lookup(&context.Idents.get(name)))
        if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(found)) return variable;
  return nullptr;
}

}  // namespace

Records read_records(clang::ASTContext& context) {
  Records records;
  for (const char* space : {"host", "cuda"}) {
    const auto* found = variable(context, std::string("records_") + space);
    const clang::APValue* value = found == nullptr ? nullptr : found->evaluateValue();
    if (value == nullptr) return {};
    const frontend::Constant of_arrays{*value, found->getType()};
    records.resize(value->getArraySize());
    for (unsigned a = 0; a < value->getArraySize(); ++a) {
      const auto of = of_arrays.element(a);
      const auto number = [&](const char* name) {
        return static_cast<int>(of.member(name).value.getInt().getExtValue());
      };
      records[a].push_back(
          {space, frontend::literal(of.member("layout").value).value_or(""), number("needed"), number("all")});
    }
  }
  return records;
}

void add_records(const Records& records, Needs& needs) {
  for (std::size_t a = 0; a < records.size(); ++a) needs.arrays.at(a).records = records[a];
}

}  // namespace physgen::scenes
