// See validate.h: the rules about objects, names and nesting, one small function each; Checker carries what they share.
#include "model/validate.h"

#include <algorithm>
#include <bit>
#include <climits>
#include <cstdio>
#include <map>
#include <string_view>

#include "model/field_rules.h"
#include "model/header_size.h"
#include "model/names.h"
#include "model/taken_names.h"

namespace physgen::model {
namespace {

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

class Checker {
 public:
  explicit Checker(const Schema& schema) : schema_(schema) {}

  std::vector<Issue> run() {
    for (const bool imported : {true, false}) {
      const auto& objects = imported ? schema_.imported : schema_.objects;
      for (std::size_t i = 0; i < objects.size(); ++i) {
        place_ = {imported, static_cast<int>(i), -1};
        object(objects[i]);
      }
    }
    if (schema_.objects.empty()) {
      place_ = {};
      report(Aspect::fields, "a schema declares at least one object; write 'struct PHYSGEN_OBJECT() Name { ... };'");
    }
    return std::move(issues_);
  }

 private:
  struct Declared {
    Place place;
    long long elements = 0;
  };

  void report(Aspect aspect, std::string message, Place other = {}) {
    issues_.push_back({place_, aspect, std::move(message), other});
  }

  void object(const Object& object) {
    object_names(object);
    if (object.fields.empty())
      report(Aspect::fields,
             "object " + quoted(object.name) + " has no fields; declare at least one, such as 'Scalar x;'");
    layout(Aspect::host_layout, object.host_layout);
    layout(Aspect::cuda_layout, object.cuda_layout);
    if (object.alignment != 0 && !is_power_of_two_up_to(object.alignment, max_alignment))
      report(Aspect::alignment, "alignment " + std::to_string(object.alignment) +
                                    " is not a power of two from 1 to 256; write one, such as align(16)");
    const Place self = place_;
    long long elements = 0;
    Names names = nested_types(object);
    for (std::size_t i = 0; i < object.fields.size(); ++i) {
      place_.field = static_cast<int>(i);
      field_name(object, object.fields[i], names);
      elements = std::min<long long>(elements + field(object, object.fields[i]), INT_MAX);
    }
    place_ = self;
    if (elements > max_elements) {
      report(Aspect::name, "object " + quoted(object.name) + " has more than " + std::to_string(max_elements) +
                               " elements; split it, or keep its large parts in arrays of objects of their own");
      elements = 0;  // those that nest it are not at fault
    }
    if (!has_bearable_size(object)) elements = 0;
    declared_.emplace(object.qualified_name(), Declared{self, elements});
  }

  // An imported object's code is in the header of its own schema.
  bool has_bearable_size(const Object& object) {
    const ObjectSize size = sizes_.of(object);
    if (place_.imported) return true;
    const auto mebibytes = [](double bytes) {
      char text[32];
      std::snprintf(text, sizeof text, "%.3g MiB", bytes / (1 << 20));
      return std::string(text);
    };
    if (size.bytes > max_object_bytes) {
      const bool nested = size.largest_nested >= 0;
      const Place self = place_;
      place_.field = size.largest_nested;
      report(nested ? Aspect::type : Aspect::name,
             "object " + quoted(object.name) + " would become about " + mebibytes(size.bytes) +
                 " of generated code, and the limit is " + mebibytes(max_object_bytes) + "; " +
                 (nested ? "the fields of nested objects are written out one by one: keep what is repeated in an array "
                           "of objects of its own, and its number here as an Index"
                         : "split it into several objects"));
      place_ = self;
      sizes_.forget(object);
      return false;
    }
    const bool fitted = header_bytes_ <= max_header_bytes;
    header_bytes_ += size.bytes;
    if (fitted && header_bytes_ > max_header_bytes)
      report(Aspect::name, "with object " + quoted(object.name) + ", the generated header would exceed " +
                               mebibytes(max_header_bytes) +
                               "; move it and those after it to a schema of their own, and nest less deeply");
    return true;
  }

  void object_names(const Object& object) {
    if (auto problem = name_problem(object.name, NameOf::object); !problem.empty())
      report(Aspect::name, "object name " + quoted(object.name) + " " + problem);
    if (object.scope.empty())
      report(Aspect::name, "object " + quoted(object.name) +
                               " stands outside all namespaces, where the C library has names such as index, time and "
                               "link; write 'namespace some_name { ... }' around it");
    for (std::size_t begin = 0; begin < object.scope.size();) {
      const std::size_t end = std::min(object.scope.find("::", begin), object.scope.size());
      scope(object, object.scope.substr(begin, end - begin), object.scope.substr(0, end));
      begin = end + 2;
    }
    if (const auto same = declared_.find(object.qualified_name()); same != declared_.end()) {
      report(Aspect::name, "object " + quoted(object.qualified_name()) + " is declared twice; rename or remove one",
             same->second.place);
      return;
    }
    const std::string prefix = object.scope.empty() ? "" : object.scope + "::";
    bool reported = false;
    for (const auto ending : generated_endings) {
      const auto space = scopes_.find(prefix + object.name + std::string(ending));
      if (space == scopes_.end()) continue;
      report(Aspect::name,
             "object " + quoted(object.name) + " would generate a type " + quoted(object.name + std::string(ending)) +
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
             "objects " + quoted(object.name) + " and " + quoted(other.name) + " would both generate a type " +
                 quoted(object.name + std::string(ending)) + "; rename one of them",
             taken->second);
      reported = true;
    }
  }

  struct Names {
    std::map<std::string, Place, std::less<>> fields;  // of the object, so far
    std::map<std::string, std::string, std::less<>>
        types;  // of nested objects that code of the object says, with scope
  };

  static Names nested_types(const Object& object) {
    Names names;
    for (const Field& field : object.fields)
      for (const char* ending : {"", "Formats", "Probe", "Record", "Ref"})
        if (field.shape == Shape::object)
          names.types.emplace(field.object.substr(field.object.rfind(':') + 1) + ending, field.object + ending);
    return names;
  }

  /// @param name of the namespace
  /// @param qualified the same with those around it
  void scope(const Object& object, const std::string& name, const std::string& qualified) {
    if (auto problem = name_problem(name, NameOf::scope); !problem.empty())
      report(Aspect::scope, "namespace " + quoted(name) + " " + problem);
    else if (name == qualified && is_name_of_the_c_library(name))
      report(Aspect::scope,
             "namespace " + quoted(name) +
                 " has the name of something in the C library, which stands outside all namespaces, too; "
                 "choose another name");
    const auto [first, is_new] = scopes_.emplace(qualified, place_);
    if (!is_new) return;
    const auto taken = generated_.find(qualified);
    if (taken == generated_.end()) return;
    report(Aspect::scope,
           "object " + quoted(object.name) + " is in a namespace " + quoted(name) + ", beside object " +
               quoted(at(taken->second).name) + ", which would generate a type of that name; rename one of them",
           taken->second);
  }

  void field_name(const Object& object, const Field& field, Names& names) {
    if (auto problem = name_problem(field.name, NameOf::field); !problem.empty())
      report(Aspect::name, "field name " + quoted(field.name) + " " + problem);
    for (const auto ending : generated_endings)
      if (field.name == object.name + std::string(ending))
        report(Aspect::name, "field name " + quoted(field.name) + " is also the name of a type generated for object " +
                                 quoted(object.name) + "; choose another name");
    const auto type = names.types.find(field.name);
    if (type != names.types.end() && field.name != object.name)
      report(Aspect::name, "field name " + quoted(field.name) + " is also the name of the object type " +
                               quoted(type->second) + " nested here; choose another name");
    const auto [first, is_new] = names.fields.emplace(field.name, place_);
    if (!is_new)
      report(Aspect::name, "field " + quoted(field.name) + " is declared twice; rename or remove one", first->second);
  }

  /// @return the number of elements, 0 if it cannot be said
  long long field(const Object& object, const Field& field) {
    const bool is_array = field.array_extent != 0;
    if (is_array && (field.array_extent < 1 || field.array_extent > max_extent))
      report(Aspect::type, "array " + quoted(field.name) + " has an extent outside 1 to " + std::to_string(max_extent) +
                               "; keep large or varying numbers of entries in an array of objects of their own");
    const bool sized =
        check_field(field, [this](Aspect aspect, std::string message) { report(aspect, std::move(message)); });
    const long long entries = is_array ? std::clamp(field.array_extent, 1, max_extent) : 1;
    if (field.shape == Shape::object) return entries * nested(object, field);
    return sized ? entries * element_count(field) : 0;
  }

  long long nested(const Object& object, const Field& field) {
    if (field.object == object.qualified_name()) {
      report(Aspect::type,
             "object " + quoted(object.name) + " contains itself; store an 'Index' of the other object instead");
      return 0;
    }
    const auto found = declared_.find(field.object);
    if (found == declared_.end()) {
      report(Aspect::type,
             "field " + quoted(field.name) + " nests " + quoted(field.object) +
                 ", which is not declared before it; declare that object first (objects cannot nest each other)");
      return 0;
    }
    return found->second.elements;
  }

  void layout(Aspect aspect, const std::optional<Layout>& layout) {
    if (!layout) return;
    const LayoutFacts& row = facts(layout->kind);
    const std::string word(row.word);
    if (row.tiled && (layout->tile < 2 || !is_power_of_two_up_to(layout->tile, max_tile)))
      report(aspect, "tile " + std::to_string(layout->tile) + " is not a power of two from 2 to " +
                         std::to_string(max_tile) + "; write one, such as " + layout_word({layout->kind, 32}));
    if (!row.tiled && layout->tile != 0) report(aspect, "a layout " + word + " has no tile; leave it out");
  }

  const Object& at(const Place& place) const {
    return (place.imported ? schema_.imported : schema_.objects)[static_cast<std::size_t>(place.object)];
  }

  const Schema& schema_;
  Place place_;
  std::map<std::string, Declared, std::less<>> declared_;
  std::map<std::string, Place, std::less<>> generated_;  // qualified names of all generated types
  std::map<std::string, Place, std::less<>> scopes_;     // qualified names of all namespaces, with their first objects
  HeaderSizes sizes_;
  double header_bytes_ = 0;
  std::vector<Issue> issues_;
};

}  // namespace

bool is_power_of_two_up_to(int value, int limit) {
  return value >= 1 && value <= limit && std::has_single_bit(static_cast<unsigned>(value));
}

std::vector<Issue> validate(const Schema& schema) { return Checker(schema).run(); }

}  // namespace physgen::model
