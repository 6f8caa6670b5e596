// Checks what names() and follows() say of sets, once all arrays of a scene have been read. See read_options.h.
#include <clang/AST/Attr.h>

#include <algorithm>
#include <map>
#include <set>

#include "scenes/read_options.h"

namespace physgen::scenes {
namespace {

/// Option `name` of the array, number `number` of those of its type: what is underlined.
clang::SourceRange option_of(const clang::FieldDecl& declaration, llvm::StringRef type, std::size_t number) {
  for (const auto* attribute : declaration.specific_attrs<clang::AnnotateAttr>())
    if (attribute->getAnnotation() == array_annotation)
      for (const clang::Expr* argument : attribute->args()) {
        const auto* record = argument->IgnoreImplicit()->getType()->getAsCXXRecordDecl();
        if (record != nullptr && record->getName() == type && number-- == 0)
          return argument->IgnoreImplicit()->getSourceRange();
      }
  return declaration.getLocation();
}

/// The sets that a set follows, and those that these follow.
std::set<std::string> followed_by(const std::string& set, const std::multimap<std::string, std::string>& follows) {
  std::set<std::string> result;
  std::vector<std::string> next = {set};
  while (!next.empty()) {
    const auto [begin, end] = follows.equal_range(next.back());
    next.pop_back();
    for (auto one = begin; one != end; ++one)
      if (result.insert(one->second).second) next.push_back(one->second);
  }
  return result;
}

}  // namespace

void check_names(const Scene& scene, const std::vector<const clang::FieldDecl*>& declarations,
                 frontend::Report& report) {
  std::vector<std::string> sets;
  std::multimap<std::string, std::string> follows;
  std::vector<const Array*> arrays;
  for (const Group& group : scene.groups)
    for (const Array& array : group.arrays) {
      arrays.push_back(&array);
      if (!array.set.empty() && std::ranges::find(sets, array.set) == sets.end()) sets.push_back(array.set);
      if (!array.follows.empty()) follows.emplace(array.set, array.follows);
    }
  for (std::size_t a = 0; a < std::min(arrays.size(), declarations.size()); ++a) {
    const Array& array = *arrays[a];
    const std::string is = "array " + frontend::in_quotes(array.name) + " ";
    for (std::size_t n = 0; n < array.names.size(); ++n)
      if (!array.names[n].set.empty() && std::ranges::find(sets, array.names[n].set) == sets.end())
        report.error(
            option_of(*declarations[a], "NamesObjects", n),
            is + "names objects of a set of which the scene has no array; " + unknown("set", array.names[n].set, sets));
    if (array.follows.empty()) continue;
    const clang::SourceRange range = option_of(*declarations[a], "Follows", 0);
    if (array.set.empty() || array.uniform)
      report.error(range, is + "follows a set, and has the same objects on every rank; remove follows(...)");
    else if (std::ranges::find(sets, array.follows) == sets.end())
      report.error(range, is + "follows a set of which the scene has no array; " + unknown("set", array.follows, sets));
    else if (followed_by(array.set, follows).contains(array.set))
      report.error(
          range, is + "is per(" + frontend::in_quotes(array.set) + "), and " + array.set +
                     (array.set == array.follows ? " follows itself" : " and " + array.follows + " follow each other") +
                     ", so that no rank would know where to begin; remove one follows(...)");
  }
}

}  // namespace physgen::scenes
