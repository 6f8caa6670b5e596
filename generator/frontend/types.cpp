// See types.h. One function per kind of type; the first lines of each message say what is there, the rest what to
// write.
#include "frontend/types.h"

#include <clang/AST/Attr.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/TypeLoc.h>

#include <climits>

#include "frontend/options.h"

namespace physgen::frontend {
namespace {

/// The remedy.
std::string allowed() { return "write " + model::joined(model::field_types()) + " or an object"; }

clang::SourceRange type_range(const clang::FieldDecl& declaration) {
  if (const auto* info = declaration.getTypeSourceInfo()) return info->getTypeLoc().getSourceRange();
  return declaration.getLocation();
}

std::string spelled(clang::QualType type, const clang::ASTContext& context) {
  clang::PrintingPolicy policy(context.getLangOpts());
  policy.SuppressScope = true;
  return type.getUnqualifiedType().getAsString(policy);
}

/// The element type that the catalogue has under the name of `type`; none: another type.
std::optional<model::Element> element_of(clang::QualType type, const clang::ASTContext& context) {
  const auto* builtin = type->getAs<clang::BuiltinType>();
  // std::int64_t is another name of long or of long long.
  if (builtin != nullptr && builtin->isInteger() && !builtin->isCharType() && context.getTypeSize(builtin) == 64)
    return builtin->isSignedInteger() ? model::Element::int64 : model::Element::uint64;
  const llvm::StringRef name =
      builtin != nullptr ? builtin->getName(context.getPrintingPolicy()) : vocabulary_name(type->getAsCXXRecordDecl());
  for (const model::ElementFacts& row : model::elements())
    if (row.schema == std::string_view(name)) return row.key;
  return std::nullopt;
}

class TypeReader {
 public:
  TypeReader(const clang::FieldDecl& declaration, model::Field& field, Report& report)
      : declaration_(declaration), field_(field), report_(report), context_(report.context()) {}

  bool read() {
    clang::QualType type = declaration_.getType();
    if (declaration_.isBitField())
      return fail("is a bit-field, whose bits have no address of their own; write 'int " + name() + ";'",
                  declaration_.getBitWidth()->getSourceRange());
    if (type->isReferenceType())
      return fail("is a reference, which an array of objects cannot store; write '" +
                  spelled(type.getNonReferenceType(), context_) + " " + name() + ";', or an Index into another array");
    if (type->isAnyPointerType() || type->isMemberPointerType() || type->isFunctionPointerType())
      return fail(
          "is a pointer, which means nothing in another memory space; write an Index into another array, or the "
          "value itself");
    if (!read_array(type)) return false;
    if (type.isConstQualified() || type.isVolatileQualified() || declaration_.isMutable())
      return fail(std::string("is ") +
                  (declaration_.isMutable()  ? "mutable"
                   : type.isConstQualified() ? "const"
                                             : "volatile") +
                  ", but whether an element may be written is the kernel's choice; write '" + spelled(type, context_) +
                  " " + name() + ";'");
    return read_entry(type.getCanonicalType().getUnqualifiedType());
  }

 private:
  [[nodiscard]] std::string name() const { return declaration_.getName().str(); }

  bool fail(const std::string& what, clang::SourceRange range = {}) {
    report_.error(range.isValid() ? range : type_range(declaration_), "field " + in_quotes(name()) + " " + what);
    return false;
  }

  bool read_array(clang::QualType& type) {
    if (!type->isArrayType()) return true;
    const auto* array = context_.getAsConstantArrayType(type);
    if (array == nullptr)
      return fail("is an array without a fixed extent; write the number of entries, such as '" + name() +
                  "[4]', or keep a varying number in an array of objects of their own");
    type = array->getElementType();
    if (type->isArrayType())
      return fail("is an array of arrays; write 'Matrix<R, C> " + name() +
                  ";' or one array of the product of the extents");
    if (array->getZExtSize() == 0)
      return fail("is an array of no entries; write an extent of at least 1, or remove it");
    if (type->isAnyPointerType() || type->isMemberPointerType())
      return fail("is an array of pointers, which mean nothing in another memory space; write 'Index " + name() +
                  "[...];'");
    field_.array_extent = static_cast<int>(std::min<std::uint64_t>(array->getZExtSize(), INT_MAX));
    return true;
  }

  bool read_entry(clang::QualType type) {
    if (const auto element = element_of(type, context_)) {
      field_.shape = model::Shape::scalar;
      field_.element = *element;
      return true;
    }
    if (const auto* record = type->getAsCXXRecordDecl()) return read_record(*record);
    const auto* builtin = type->getAs<clang::BuiltinType>();
    const std::string what =
        "has the type " + in_quotes(spelled(declaration_.getType(), context_)) + ", which a schema does not have; ";
    if (type->isEnumeralType()) return fail(what + "write Index and keep the enumeration for the values");
    if (builtin != nullptr && builtin->isInteger())
      return fail(what + "write " + model::joined(model::element_types(true), " or "));
    if (builtin != nullptr && builtin->isFloatingPoint())
      return fail(what + "write " + model::joined(model::element_types(false), " or "));
    return fail(what + allowed());
  }

  bool read_record(const clang::CXXRecordDecl& record) {
    const llvm::StringRef vocabulary = vocabulary_name(&record);
    for (const model::ShapeFacts& shape : model::shapes())
      if (!vocabulary.empty() && shape.type == std::string_view(vocabulary)) return read_shape(record, shape);
    if (!vocabulary.empty())
      return fail("has the type " + in_quotes(vocabulary) +
                  " of a <physgen/schema.h> for another version, which this physgen does not know; " + allowed());
    if (const auto option = option_name(&record); !option.empty())
      return fail("has the type " + in_quotes(option) + ", which is an option and not a field type; " + allowed());
    if (record.isUnion()) return fail("is a union, whose members share memory; write one field per member");
    if (llvm::isa<clang::ClassTemplateSpecializationDecl>(record))
      return fail("has a template as its type, which a schema does not have; write a struct with PHYSGEN_OBJECT()");
    if (!is_object(record)) {
      if (report_.clang_errors()) return false;  // an option that Clang refused takes the marker with it
      report_.error(type_range(declaration_),
                    "field " + in_quotes(name()) + " has the type " + in_quotes(record.getName()) +
                        ", which is not an object; write 'struct PHYSGEN_OBJECT() " + record.getName().str() + "'",
                    Note{record.getLocation(), in_quotes(record.getName()) + " is declared here"});
      return false;
    }
    const std::string scope = scope_of(record);
    field_.shape = model::Shape::object;
    field_.object = (scope.empty() ? "" : scope + "::") + record.getName().str();
    return true;
  }

  bool read_shape(const clang::CXXRecordDecl& record, const model::ShapeFacts& shape) {
    field_.shape = shape.key;
    field_.rows = field_.cols = shape.side;
    const auto* specialization = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record);
    if (specialization == nullptr || shape.sides == model::Sides::fixed) return true;
    const auto& arguments = specialization->getTemplateArgs();
    const auto size = [&](unsigned number) {
      return static_cast<int>(arguments[number].getAsIntegral().getSExtValue());
    };
    const bool two_sizes = shape.sides == model::Sides::any;
    field_.rows = size(0);
    field_.cols = two_sizes ? size(1) : shape.sides == model::Sides::column ? 1 : field_.rows;
    const clang::QualType type = arguments[two_sizes ? 2 : 1].getAsType();
    const auto element = element_of(type, context_);
    if (!element || type.hasQualifiers()) {
      std::vector<std::string> words;
      for (const model::ElementFacts& row : model::elements()) words.emplace_back(row.schema);
      return fail("has elements of type " + in_quotes(type.getAsString(context_.getPrintingPolicy())) +
                  "; write one of " + model::joined(words, " and "));
    }
    field_.element = *element;
    return true;
  }

  const clang::FieldDecl& declaration_;
  model::Field& field_;
  Report& report_;
  clang::ASTContext& context_;
};

}  // namespace

bool read_type(const clang::FieldDecl& declaration, model::Field& field, Report& report) {
  return TypeReader(declaration, field, report).read();
}

bool is_object(const clang::CXXRecordDecl& record) {
  const auto carries = [](const clang::Decl& declaration) {
    return marker(declaration, object_annotation).has_value();
  };
  for (const auto* redeclaration : record.redecls())
    if (carries(*redeclaration)) return true;
  return false;
}

std::string scope_of(const clang::Decl& declaration) {
  std::string scope;
  for (const auto* context = declaration.getDeclContext(); context != nullptr; context = context->getParent()) {
    const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(context);
    if (space == nullptr || space->isInline() || space->isAnonymousNamespace()) continue;
    scope = space->getName().str() + (scope.empty() ? "" : "::" + scope);
  }
  return scope;
}

}  // namespace physgen::frontend
