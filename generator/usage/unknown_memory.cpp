// Code that reaches a view's own memory, or an element's, other than through the view. See unknown.h.
#include <clang/AST/DeclCXX.h>

#include <array>

#include "usage/expressions.h"
#include "usage/running_code.h"
#include "usage/unknown.h"

namespace physgen::usage {

class UnknownUses::Memory : public RunningCode<Memory> {
 public:
  explicit Memory(UnknownUses& to) : to_(to) {}

  bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr* expression) {
    if (expression->getKind() == clang::UETT_SizeOf)
      to_.add(expression->getTypeOfArgument(), "sizeof", expression->getBeginLoc());
    return true;
  }

  bool VisitCallExpr(clang::CallExpr* call) {
    const clang::FunctionDecl* callee = call->getDirectCallee();
    if (callee == nullptr) return true;
    if (callee->isVariadic())
      for (unsigned k = callee->getNumParams(); k < call->getNumArgs(); ++k)
        to_.add(call->getArg(k)->getType(), "an argument that ... takes as any type", call->getArg(k)->getBeginLoc());
    if (callee->getIdentifier() == nullptr) return true;
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
    const llvm::StringRef name = callee->getName();
    if (method != nullptr && name == "data" && Names::is_physgen(method->getParent(), "View"))
      to_.add(object_of(*call)->getType(), "data()", place_of(*call));
    static constexpr std::array bytes = {"bit_cast", "as_bytes", "as_writable_bytes"};
    for (const llvm::StringRef known : bytes)
      if (name == known && call->getNumArgs() > 0)
        to_.add(call->getArg(0)->getType(), known.data(), call->getBeginLoc());
    if (name == "addressof" && call->getNumArgs() > 0) element(*call->getArg(0), call->getBeginLoc());
    return true;
  }
  bool VisitCastExpr(clang::CastExpr* cast) {
    static constexpr const char* what = "a cast to other types, as of memcpy or reinterpret_cast";
    const auto kind = cast->getCastKind();
    const bool is_of_bits = kind == clang::CK_BitCast || kind == clang::CK_LValueBitCast ||
                            kind == clang::CK_LValueToRValueBitCast || kind == clang::CK_IntegralToPointer;
    if (is_of_bits || kind == clang::CK_PointerToIntegral)
      to_.add(cast->getSubExpr()->getType(), what, cast->getBeginLoc());
    if (is_of_bits) to_.add(cast->getType(), what, cast->getBeginLoc());
    return true;
  }
  bool VisitUnaryOperator(clang::UnaryOperator* taken) {
    if (taken->getOpcode() == clang::UO_AddrOf) element(*taken->getSubExpr(), taken->getBeginLoc());
    return true;
  }
  bool VisitCXXNewExpr(clang::CXXNewExpr* made) {
    if (made->getNumPlacementArgs() > 0)
      to_.add(made->getAllocatedType(), "a place in memory of other types", made->getBeginLoc());
    return true;
  }
  bool VisitGCCAsmStmt(clang::GCCAsmStmt* statement) {
    for (const clang::Stmt* operand : statement->children())
      if (const auto* value = llvm::dyn_cast<clang::Expr>(operand))
        to_.add(value->getType(), "an instruction of a processor", statement->getBeginLoc());
    return true;
  }
  bool VisitCXXTypeidExpr(clang::CXXTypeidExpr* expression) {
    to_.add(expression->isTypeOperand() ? expression->getTypeOperand(to_.context_)
                                        : expression->getExprOperand()->getType(),
            "typeid", expression->getBeginLoc());
    return true;
  }
  bool VisitCXXThrowExpr(clang::CXXThrowExpr* thrown) {
    if (thrown->getSubExpr() != nullptr)
      to_.add(thrown->getSubExpr()->getType(), "an exception, which is caught by its type,", thrown->getThrowLoc());
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) {
    if (const auto* record = llvm::dyn_cast<clang::RecordDecl>(member->getMemberDecl()->getDeclContext());
        record != nullptr && record->isUnion())
      to_.add(to_.context_.getCanonicalTagType(record), "a union", member->getMemberLoc());
    return true;
  }
  bool VisitCXXDefaultInitExpr(clang::CXXDefaultInitExpr* expression) { return TraverseStmt(expression->getExpr()); }
  bool VisitCXXDefaultArgExpr(clang::CXXDefaultArgExpr* expression) { return TraverseStmt(expression->getExpr()); }

 private:
  /// A named reference, `auto&& m = view[i].m()`: where memory holds numbers, its address is that of a number.
  void element(const clang::Expr& taken, clang::SourceLocation location) {
    if (Names::is_physgen(taken.getType()->getAsCXXRecordDecl(), "ElementRef"))
      to_.add(taken.getType(), address, location);
  }

  UnknownUses& to_;
};

void UnknownUses::look_for_memory(const clang::Decl& code) { Memory(*this).look_through(code); }

}  // namespace physgen::usage
