// See rules.h. One small function per rule; Checker carries what they share.
#include "emit/cpp/rules.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "emit/cpp/header_size.h"
#include "emit/cpp/names.h"
#include "emit/cpp/taken_names.h"
#include "model/limits.h"
#include "model/text.h"

namespace physgen::emit::cpp {
namespace {

using model::Aspect;
using model::Field;
using model::in_quotes;
using model::Issue;
using model::Object;
using model::Place;
using model::Shape;

class Checker {
 public:
  explicit Checker(const model::Schema& schema) : schema_(schema) {}

  std::vector<Issue> run() {
    for_each_object(schema_, [this](const Object& declared, Place place) {
      place_ = place;
      object(declared);
    });
    return std::move(issues_);
  }

 private:
  void report(Aspect aspect, std::string message, Place other = {}) {
    issues_.push_back({place_, aspect, std::move(message), other});
  }

  void object(const Object& object) {
    object_names(object);
    const Place self = place_;
    const NestedTypes types = nested_types(object);
    for (std::size_t i = 0; i < object.fields.size(); ++i) {
      place_.field = static_cast<int>(i);
      field_name(object, object.fields[i], types);
      value_size(object.fields[i]);
    }
    place_ = self;
    size(object);
  }

  void object_names(const Object& object) {
    if (auto problem = name_problem(object.name, NameOf::object); !problem.empty())
      report(Aspect::name, "object name " + in_quotes(object.name) + " " + problem);
    if (object.scope.empty())
      report(Aspect::name, "object " + in_quotes(object.name) +
                               " stands outside all namespaces, where the C library has names such as index, time and "
                               "link; write 'namespace some_name { ... }' around it");
    for (std::size_t begin = 0; begin < object.scope.size();) {
      const std::size_t end = std::min(object.scope.find("::", begin), object.scope.size());
      scope(object, object.scope.substr(begin, end - begin), object.scope.substr(0, end));
      begin = end + 2;
    }
    if (!declared_.insert(object.qualified_name()).second) return;  // declared twice, which is reported
    const std::string prefix = object.scope.empty() ? "" : object.scope + "::";
    bool reported = false;
    for (const auto ending : generated_endings) {
      const auto space = scopes_.find(prefix + object.name + std::string(ending));
      if (space == scopes_.end()) continue;
      report(Aspect::name,
             "object " + in_quotes(object.name) + " would generate a type " +
                 in_quotes(object.name + std::string(ending)) +
                 " beside the namespace of that name; rename one of them",
             space->second);
      reported = true;
    }
    for (const auto ending : generated_endings) {
      const std::string generated = prefix + object.name + std::string(ending);
      const auto [taken, is_new] = generated_.emplace(generated, place_);
      if (is_new || reported || taken->second == place_) continue;
      const Object& other = at(taken->second);
      report(Aspect::name,
             "objects " + in_quotes(object.name) + " and " + in_quotes(other.name) + " would both generate a type " +
                 in_quotes(object.name + std::string(ending)) + "; rename one of them",
             taken->second);
      reported = true;
    }
  }

  /// Types of nested objects that code of the object says, and the same with their namespaces.
  using NestedTypes = std::map<std::string, std::string, std::less<>>;

  static NestedTypes nested_types(const Object& object) {
    NestedTypes types;
    for (const Field& field : object.fields)
      for (const char* ending : {"", "Formats", "Object", "Probe", "Record", "Ref"})
        if (field.shape == Shape::object)
          types.emplace(field.object.substr(field.object.rfind(':') + 1) + ending, field.object + ending);
    return types;
  }

  /// @param name of the namespace
  /// @param qualified the same with those around it
  void scope(const Object& object, const std::string& name, const std::string& qualified) {
    if (auto problem = name_problem(name, NameOf::scope); !problem.empty())
      report(Aspect::scope, "namespace " + in_quotes(name) + " " + problem);
    else if (name == qualified && is_name_of_the_c_library(name))
      report(Aspect::scope,
             "namespace " + in_quotes(name) +
                 " has the name of something in the C library, which stands outside all namespaces, too; "
                 "choose another name");
    const auto [first, is_new] = scopes_.emplace(qualified, place_);
    if (!is_new) return;
    const auto taken = generated_.find(qualified);
    if (taken == generated_.end()) return;
    report(Aspect::scope,
           "object " + in_quotes(object.name) + " is in a namespace " + in_quotes(name) + ", beside object " +
               in_quotes(at(taken->second).name) + ", which would generate a type of that name; rename one of them",
           taken->second);
  }

  void field_name(const Object& object, const Field& field, const NestedTypes& types) {
    if (auto problem = name_problem(field.name, NameOf::field); !problem.empty())
      report(Aspect::name, "field name " + in_quotes(field.name) + " " + problem);
    for (const auto ending : generated_endings)
      if (field.name == object.name + std::string(ending))
        report(Aspect::name, "field name " + in_quotes(field.name) +
                                 " is also the name of a type generated for object " + in_quotes(object.name) +
                                 "; choose another name");
    const auto type = types.find(field.name);
    if (type != types.end() && field.name != object.name)
      report(Aspect::name, "field name " + in_quotes(field.name) + " is also the name of the object type " +
                               in_quotes(type->second) + " nested here; choose another name");
  }

  // Symmetric and skew-symmetric matrices are full ones as values.
  void value_size(const Field& field) {
    const bool has_size = std::min(field.rows, field.cols) >= 1 && std::max(field.rows, field.cols) <= model::max_side;
    if (field.shape == Shape::object || !has_size) return;
    const int element = facts(field.element).bytes_with_double;
    const int bytes = field.rows * (facts(field.shape).column ? 1 : field.cols) * element;
    if (bytes > max_value_bytes)
      report(Aspect::type, "field " + in_quotes(field.name) + " has the type " + schema_type(field) +
                               ", whose value takes " + std::to_string(bytes) +
                               (element == 8 ? " bytes in double" : " bytes") + ", and Eigen keeps no more than " +
                               std::to_string(max_value_bytes) +
                               " on the stack; write blocks, such as 'Matrix<64, 64> " + field.name + "[...]'");
  }

  // An imported object's code is in the header of its own schema.
  void size(const Object& object) {
    const ObjectSize of = sizes_.of(object);
    if (place_.imported) return;
    const auto mebibytes = [](double bytes) {
      char text[32];
      std::snprintf(text, sizeof text, "%.3g MiB", bytes / (1 << 20));
      return std::string(text);
    };
    const bool too_long = of.bytes > max_object_bytes;
    if (too_long || of.fields > max_object_fields) {
      const bool nested = of.largest_nested >= 0;
      const Place self = place_;
      place_.field = of.largest_nested;
      report(nested ? Aspect::type : Aspect::name,
             "object " + in_quotes(object.name) + " would " +
                 (too_long ? "become about " + mebibytes(of.bytes) + " of generated code, and the limit is " +
                                 mebibytes(max_object_bytes)
                           : "have " + model::number(of.fields) + " fields, and the limit is " +
                                 model::number(max_object_fields)) +
                 "; " +
                 (nested ? "the fields of nested objects are listed one by one: keep what is repeated in an array of "
                           "objects of its own, and its number here as an Index"
                         : "split it into several objects"));
      place_ = self;
      sizes_.forget(object);
      return;
    }
    const bool fitted = header_bytes_ <= max_header_bytes;
    header_bytes_ += of.bytes;
    if (fitted && header_bytes_ > max_header_bytes)
      report(Aspect::name, "with object " + in_quotes(object.name) + ", the generated header would exceed " +
                               mebibytes(max_header_bytes) +
                               "; move it and those after it to a schema of their own, and nest less deeply");
  }

  const Object& at(const Place& place) const {
    return (place.imported ? schema_.imported : schema_.objects)[static_cast<std::size_t>(place.object)];
  }

  const model::Schema& schema_;
  Place place_;
  std::set<std::string> declared_;                       // qualified names of objects
  std::map<std::string, Place, std::less<>> generated_;  // qualified names of all generated types
  std::map<std::string, Place, std::less<>> scopes_;     // qualified names of all namespaces, with their first objects
  HeaderSizes sizes_;
  double header_bytes_ = 0;
  std::vector<Issue> issues_;
};

}  // namespace

std::vector<Issue> objections(const model::Schema& schema) { return Checker(schema).run(); }

}  // namespace physgen::emit::cpp
