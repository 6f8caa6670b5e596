// Visits the code of a function that runs, and tells in which order its calls are evaluated, arguments before what
// takes them, and which of them a condition may leave out.
#pragma once

#include <map>
#include <set>

#include "usage/running_code.h"

namespace physgen::usage {

template <class Derived>
class InOrder : public RunningCode<Derived> {
 public:
  bool VisitIfStmt(clang::IfStmt* branch) {
    if (!branch->isConstexpr()) conditional_.insert({branch->getThen(), branch->getElse()});
    return true;
  }
  bool VisitSwitchStmt(clang::SwitchStmt* branch) {
    conditional_.insert(branch->getBody());
    return true;
  }
  bool VisitConditionalOperator(clang::ConditionalOperator* choice) {
    conditional_.insert({choice->getTrueExpr(), choice->getFalseExpr()});
    return true;
  }
  bool VisitBinaryOperator(clang::BinaryOperator* operation) {
    if (operation->isLogicalOp()) conditional_.insert(operation->getRHS());
    return true;
  }

  /// Clang keeps the increment before the body.
  bool TraverseForStmt(clang::ForStmt* loop) {
    clang::Stmt* const parts[] = {loop->getInit(), loop->getConditionVariableDeclStmt(), loop->getCond(),
                                  loop->getBody(), loop->getInc()};
    for (clang::Stmt* part : parts)
      if (!this->getDerived().TraverseStmt(part)) return false;
    return true;
  }

  bool dataTraverseStmtPre(clang::Stmt* statement) {
    if (conditional_.contains(statement)) ++conditions_;
    return true;
  }
  bool dataTraverseStmtPost(clang::Stmt* statement) {
    const auto [begin, end] = ends_.equal_range(statement);
    for (auto call = begin; call != end; ++call) this->getDerived().set_order(call->second, next_++);
    ends_.erase(begin, end);
    if (conditional_.contains(statement)) --conditions_;
    return true;
  }

 protected:
  /// The number of what comes next.
  [[nodiscard]] int next() { return next_++; }
  /// A call that is made when all else of a statement has been evaluated gets its number then, by set_order().
  void at_end_of(const clang::Stmt* statement, std::size_t call) { ends_.emplace(statement, call); }
  /// Whether the code at hand stands in a branch. Loops are taken to run.
  [[nodiscard]] bool is_conditional() const { return conditions_ > 0; }

 private:
  int next_ = 0, conditions_ = 0;
  std::multimap<const clang::Stmt*, std::size_t> ends_;
  std::set<const clang::Stmt*> conditional_;
};

}  // namespace physgen::usage
