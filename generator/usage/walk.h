// Follows the instantiated functions of a program in Clang's syntax tree and writes down what calls what. Of this
// folder's headers, only this one and names.h know Clang.
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>

#include <memory>
#include <string>
#include <vector>

#include "usage/graph.h"

namespace physgen::usage {

class Walk;

/// A unit's graph, in two parts: what is there over probes, and later what else its program has been run over.
class GraphReader {
 public:
  /// @param folders in which #include looks: files are named without them. It outlives the reader
  GraphReader(clang::ASTContext& context, const std::vector<std::string>& folders);
  ~GraphReader();
  GraphReader(GraphReader&&) noexcept;

  /// @param functions of the program that have bodies, instantiated ones among them
  [[nodiscard]] const Graph& read(const std::vector<const clang::FunctionDecl*>& functions);
  /// The same graph with the variants and what all functions consist of.
  [[nodiscard]] const Graph& read_variants();

 private:
  std::unique_ptr<Walk> walk_;
};

}  // namespace physgen::usage
