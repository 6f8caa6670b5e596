// See read_program.h. The instantiated program is read, in which the types of kernels and arrays are known; its places
// are those of the text that was instantiated.
#include "scenes/read_program.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Lex/Lexer.h>

#include <cctype>
#include <map>
#include <optional>
#include <set>

#include "scenes/needs.h"
#include "scenes/read_kernel.h"
#include "scenes/read_plain.h"
#include "scenes/read_views.h"

namespace physgen::scenes {
namespace {
using usage::Names;
constexpr const char* blanks = " \t\n\r\v\f";

/// The function of an executor that is called: run, reduce, repeat, ...; empty: it is not a call of an executor.
std::string asked(const clang::CallExpr& call) {
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call.getDirectCallee());
  return method != nullptr && Names::is_physgen(method->getParent(), "ProbeExecutor") ? method->getNameAsString() : "";
}

const clang::CallExpr* call_of(const clang::Stmt* statement) {
  const auto* expression = llvm::dyn_cast_or_null<clang::Expr>(statement);
  return expression == nullptr ? nullptr : llvm::dyn_cast<clang::CallExpr>(expression->IgnoreImplicit());
}

bool has_word(const std::string& text, const std::string& word) {
  const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    if ((at == 0 || !part(text[at - 1])) && (at + word.size() >= text.size() || !part(text[at + word.size()])))
      return true;
  return false;
}

/// "physgen::fem::assemble": of a function, whatever it is instantiated for, and of a lambda in it.
std::string plain_name(const clang::DeclContext* scope) {
  if (scope == nullptr || scope->isTranslationUnit()) return {};
  std::string outer = plain_name(scope->getParent());
  const auto* named = llvm::dyn_cast<clang::NamedDecl>(scope);
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(scope);
  if (named == nullptr || named->getIdentifier() == nullptr || (record != nullptr && record->isLambda())) return outer;
  return (outer.empty() ? outer : outer + "::") + named->getName().str();
}

/// Whether a macro writes a part of an expression, such as an argument of a template. Its words stand elsewhere.
class OfMacros : public clang::RecursiveASTVisitor<OfMacros> {
 public:
  bool VisitStmt(clang::Stmt* part) { return look(part->getBeginLoc()) && look(part->getEndLoc()); }
  bool VisitTypeLoc(clang::TypeLoc part) { return look(part.getBeginLoc()) && look(part.getEndLoc()); }
  clang::SourceLocation found;

 private:
  bool look(clang::SourceLocation place) {
    if (place.isMacroID()) found = place;
    return found.isInvalid();
  }
};

class ProgramReader : public clang::RecursiveASTVisitor<ProgramReader> {
 public:
  ProgramReader(clang::ASTContext& context, const Scene& scene, const std::vector<std::string>& folders)
      : context_(context), sources_(context.getSourceManager()), scene_(scene), names_(context, folders) {}

  ProgramText read() && {
    const clang::FunctionDecl* program = find_program();
    if (program == nullptr || !text_of(*program)) return std::move(result_);
    for (const auto* step : names_.steps()) {
      const auto* arguments = step->getTemplateSpecializationArgs();
      if (step->getName() == "step")
        steps_[context_.getCanonicalType(arguments->get(0).getAsType()).getTypePtr()] = step;
    }
    plain_.emplace(*program, scene_, names_);
    TraverseStmt(program->getBody());
    if (!result_.cause.empty()) result_.lists.clear();
    result_.used = views_used(*program, scene_, names_);
    while (!queue_.empty()) {  // functions that the program calls
      const auto* function = queue_.back();
      queue_.pop_back();
      where_ = plain_name(function) + "()";
      TraverseStmt(function->getBody());
    }
    return std::move(result_);
  }

  bool VisitCompoundStmt(clang::CompoundStmt* compound) {
    if (where_.empty()) list(*compound);
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) {
    if (const std::string what = asked(*call); !what.empty()) {
      const auto* method = call->getDirectCallee();
      if (const std::string step = step_of(*method); what == "run" && known_.count(call) == 0 && !step.empty())
        result_.elsewhere.try_emplace(step, where_.empty() ? "a statement of its own" : where_);
    } else {
      follow(call->getDirectCallee());
    }
    return true;
  }
  /// A text that is another in a copy of the program: a line's number, a file's name.
  bool VisitExpr(clang::Expr* expression) {
    if (llvm::isa<clang::IntegerLiteral, clang::StringLiteral>(expression) && where_.empty() &&
        sources_.isWrittenInScratchSpace(sources_.getSpellingLoc(expression->getBeginLoc())))
      result_.cause = "a macro writes a part of it that may depend on its place" + at(expression->getBeginLoc());
    return true;
  }
  bool TraverseLambdaExpr(clang::LambdaExpr* lambda) {
    lambdas_.push_back(lambda);
    const bool goes_on = clang::RecursiveASTVisitor<ProgramReader>::TraverseLambdaExpr(lambda);
    lambdas_.pop_back();
    return goes_on;
  }

 private:
  // ---- The program, and functions that it calls --------------------------------------------------------------------

  /// As instantiate<Probed>() of the unit calls it.
  const clang::FunctionDecl* find_program() {
    for (const auto* found : context_.getTranslationUnitDecl()->lookup(&context_.Idents.get("physgen_probe_unit")))
      if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(found))
        for (auto* inner : space->lookup(&context_.Idents.get("instantiate")))
          if (auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(inner))
            for (const auto* function : pattern->specializations())
              if (const auto* program = called(*function); program != nullptr) return program;
    return nullptr;
  }
  static const clang::FunctionDecl* called(const clang::FunctionDecl& function) {
    const auto* arrays = function.getTemplateSpecializationArgs()->get(0).getAsType()->getAsCXXRecordDecl();
    const clang::FunctionDecl* definition = nullptr;
    if (arrays == nullptr || arrays->getName() != "Probed" || !function.isDefined(definition)) return nullptr;
    for (const auto* statement : definition->getBody()->children())
      if (const auto* call = call_of(statement); call != nullptr && call->getDirectCallee() != nullptr)
        if (const clang::FunctionDecl* program = nullptr; call->getDirectCallee()->isDefined(program)) return program;
    return nullptr;
  }

  bool text_of(const clang::FunctionDecl& program) {
    const auto* pattern = program.getTemplateInstantiationPattern();
    const auto* whole = pattern == nullptr ? nullptr : pattern->getDescribedFunctionTemplate();
    if (whole == nullptr) return false;
    const auto first = whole->getBeginLoc(), last = pattern->getBody()->getEndLoc();
    if (first.isMacroID() || last.isMacroID()) {
      result_.cause = "a macro writes the program";
      return false;
    }
    const auto [file, begin] = sources_.getDecomposedLoc(first);
    file_ = file;
    begin_ = begin;
    result_.text = sources_.getBufferData(file).substr(begin, sources_.getFileOffset(last) + 1 - begin).str();
    return true;
  }

  void follow(const clang::FunctionDecl* function) {
    const clang::FunctionDecl* definition = nullptr;
    if (function == nullptr || !function->isDefined(definition) || names_.is_library(definition->getLocation())) return;
    if (definition->getBody() != nullptr && seen_.insert(definition->getCanonicalDecl()).second)
      queue_.push_back(definition);
  }

  /// The name of the step that an executor's function is instantiated for.
  std::string step_of(const clang::FunctionDecl& method) {
    const auto* arguments = method.getTemplateSpecializationArgs();
    if (arguments == nullptr || arguments->size() == 0) return {};
    const auto found = steps_.find(context_.getCanonicalType(arguments->get(0).getAsType()).getTypePtr());
    return found == steps_.end() ? std::string() : scenes::name_of(names_.step(*found->second).use);
  }

  // ---- Statements --------------------------------------------------------------------------------------------------

  [[nodiscard]] std::optional<std::size_t> offset(clang::SourceLocation location) const {
    if (location.isInvalid() || location.isMacroID()) return std::nullopt;
    const auto [file, at] = sources_.getDecomposedLoc(location);
    if (file != file_ || at < begin_ || at - begin_ > result_.text.size()) return std::nullopt;
    return at - begin_;
  }
  [[nodiscard]] std::string text_of(const Span& span) const {
    return result_.text.substr(span.begin, span.end - span.begin);
  }
  [[nodiscard]] std::string at(clang::SourceLocation location) const {
    return " at " + usage::text_of(names_.place(location));
  }

  void list(const clang::CompoundStmt& compound) {
    ProgramSteps steps;
    std::string between;
    std::size_t first = 0;  // of those with nothing between them
    for (const clang::Stmt* statement : compound.body()) {
      const auto* call = call_of(statement);
      if (auto step = call != nullptr && asked(*call) == "run" ? this->step(*call) : std::nullopt) {
        if (!steps.steps.empty()) {
          if (between.empty()) between = directive(steps.steps.back(), *step);
          if (!between.empty()) first = steps.steps.size();
          steps.between.push_back(std::move(between));
        }
        between.clear();
        known_.insert(call);
        ++result_.runs[step->step];
        steps.steps.push_back(std::move(*step));
        continue;
      }
      if (between.empty()) between = plain_->not_in_statement(*statement);
      if (between.empty()) between = clash(steps, first, llvm::cast<clang::DeclStmt>(*statement));
    }
    if (!steps.steps.empty()) result_.lists.push_back(std::move(steps));
  }

  /// @return a name that is declared, and that an earlier step uses for something else
  std::string clash(const ProgramSteps& steps, std::size_t first, const clang::DeclStmt& declared) const {
    for (const clang::Decl* one : declared.decls())
      for (std::size_t k = first; k < steps.steps.size(); ++k)
        if (const std::string name = llvm::cast<clang::NamedDecl>(one)->getNameAsString();
            has_word(text_of(steps.steps[k].statement), name))
          return "the declaration of " + name + at(one->getLocation()) + ", a name that " + steps.steps[k].step +
                 " is given, too,";
    return {};
  }
  std::string directive(const ProgramStep& before, const ProgramStep& step) const {
    const std::string text = text_of({before.statement.begin, step.statement.end});
    for (const char* sign : {"#", "%:", "_Pragma"})
      if (text.find(sign) != std::string::npos) return "a directive of the preprocessor";
    if (text.find('\\') != std::string::npos) return "a backslash, with which names are written in two ways,";
    return {};
  }

  std::optional<ProgramStep> step(const clang::CallExpr& call) {
    const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(&call);
    const auto* on = member == nullptr
                         ? nullptr
                         : llvm::dyn_cast<clang::DeclRefExpr>(member->getImplicitObjectArgument()->IgnoreImpCasts());
    if (on == nullptr || !llvm::isa<clang::ParmVarDecl>(on->getDecl())) return std::nullopt;
    const auto begin = offset(call.getBeginLoc()), end = offset(call.getRParenLoc());
    if (!begin || !end || call.getNumArgs() != 2) return std::nullopt;
    const auto count_begin = offset(call.getArg(0)->getBeginLoc());
    const auto count_end =
        offset(clang::Lexer::getLocForEndOfToken(call.getArg(0)->getEndLoc(), 0, sources_, context_.getLangOpts()));
    if (!count_begin || !count_end) return std::nullopt;
    const std::size_t comma = result_.text.find_first_not_of(blanks, *count_end);
    const std::size_t semicolon = result_.text.find_first_not_of(blanks, *end + 1);
    if (result_.text[comma] != ',' || result_.text[semicolon] != ';') return std::nullopt;
    ProgramStep step;
    step.step = step_of(*call.getDirectCallee());
    if (step.step.empty()) return std::nullopt;
    step.place = names_.place(call.getBeginLoc());
    step.statement = {*begin, semicolon + 1};
    step.count = {*count_begin, *count_end};
    step.kernel = {result_.text.find_first_not_of(blanks, comma + 1), *end};
    step.runs = counted(call.getArg(0), scene_, context_);
    const auto kernel = call.getDirectCallee()->getTemplateSpecializationArgs()->get(0).getAsType();
    KernelFacts facts =
        read_kernel(names_, others_, scene_, kernel, *steps_.at(context_.getCanonicalType(kernel).getTypePtr()));
    step.takes_packs = facts.takes_packs;
    step.scalar_bytes = facts.scalar_bytes;
    step.stores = std::move(facts.stores);
    step.obstacle = std::move(facts.obstacle);
    for (const clang::Expr* argument : call.arguments()) {
      if (const std::string other = plain_->not_in(argument); step.obstacle.empty() && !other.empty())
        step.obstacle = "it is given " + other + "; give a value its name before the steps, const auto value = ...;";
      OfMacros macros;
      macros.TraverseStmt(const_cast<clang::Expr*>(argument));
      if (step.obstacle.empty() && macros.found.isValid())
        step.obstacle = "it is given what a macro writes" + at(macros.found);
    }
    for (const auto* lambda : lambdas_)
      if (lambda->getCaptureDefault() != clang::LCD_ByRef && step.obstacle.empty())
        step.obstacle = "it stands in a lambda without [&]";
    return step;
  }

  clang::ASTContext& context_;
  const clang::SourceManager& sources_;
  const Scene& scene_;
  Names names_;
  const OtherFunctions others_{*context_.getTranslationUnitDecl(), names_};
  std::optional<Plain> plain_;
  std::map<const clang::Type*, const clang::FunctionDecl*> steps_;  // by kernel
  clang::FileID file_;
  std::size_t begin_ = 0;  // of the text in the file
  std::string where_;      // the function at hand; empty: the program
  std::vector<const clang::LambdaExpr*> lambdas_;
  std::set<const clang::CallExpr*> known_;
  std::vector<const clang::FunctionDecl*> queue_;
  std::set<const clang::Decl*> seen_;
  ProgramText result_;
};

}  // namespace

ProgramText read_program(clang::ASTContext& context, const Scene& scene, const std::vector<std::string>& folders) {
  return ProgramReader(context, scene, folders).read();
}

}  // namespace physgen::scenes
