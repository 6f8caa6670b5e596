// See validate.h: the rules about objects and nesting, one small function each; Checker carries what they share.
#include "model/validate.h"

#include <algorithm>
#include <climits>
#include <map>
#include <string>

#include "model/field_rules.h"
#include "model/limits.h"
#include "model/text.h"

namespace physgen::model {
namespace {

class Checker {
 public:
  explicit Checker(const Schema& schema) : schema_(schema) {}

  std::vector<Issue> run() {
    for_each_object(schema_, [this](const Object& declared, Place place) {
      place_ = place;
      object(declared);
    });
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
    if (const auto same = declared_.find(object.qualified_name()); same != declared_.end())
      report(Aspect::name, "object " + in_quotes(object.qualified_name()) + " is declared twice; rename or remove one",
             same->second.place);
    if (object.fields.empty())
      report(Aspect::fields,
             "object " + in_quotes(object.name) + " has no fields; declare at least one, such as 'Scalar x;'");
    layout(Aspect::host_layout, object.host_layout);
    layout(Aspect::cuda_layout, object.cuda_layout);
    if (object.alignment != 0 && !is_power_of_two_up_to(object.alignment, max_alignment))
      report(Aspect::alignment, "alignment " + std::to_string(object.alignment) +
                                    " is not a power of two from 1 to 256; write one, such as align(16)");
    const Place self = place_;
    long long elements = 0;
    std::map<std::string, Place> fields;
    for (std::size_t i = 0; i < object.fields.size(); ++i) {
      place_.field = static_cast<int>(i);
      const std::string& name = object.fields[i].name;
      const auto [first, is_new] = fields.emplace(name, place_);
      if (!is_new)
        report(Aspect::name, "field " + in_quotes(name) + " is declared twice; rename or remove one", first->second);
      elements = std::min<long long>(elements + field(object, object.fields[i]), INT_MAX);
    }
    place_ = self;
    if (elements > max_elements) {
      report(Aspect::name, "object " + in_quotes(object.name) + " has more than " + std::to_string(max_elements) +
                               " elements; split it, or keep its large parts in arrays of objects of their own");
      elements = 0;  // those that nest it are not at fault
    }
    declared_.emplace(object.qualified_name(), Declared{self, elements});
  }

  /// @return the number of elements, 0 if it cannot be said
  long long field(const Object& object, const Field& field) {
    const bool is_array = field.array_extent != 0;
    if (is_array && (field.array_extent < 1 || field.array_extent > max_extent))
      report(Aspect::type, "array " + in_quotes(field.name) + " has an extent outside 1 to " +
                               std::to_string(max_extent) +
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
             "object " + in_quotes(object.name) + " contains itself; store an 'Index' of the other object instead");
      return 0;
    }
    const auto found = declared_.find(field.object);
    if (found == declared_.end()) {
      report(Aspect::type,
             "field " + in_quotes(field.name) + " nests " + in_quotes(field.object) +
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

  const Schema& schema_;
  Place place_;
  std::map<std::string, Declared, std::less<>> declared_;
  std::vector<Issue> issues_;
};

}  // namespace

std::vector<Issue> validate(const Schema& schema) { return Checker(schema).run(); }

}  // namespace physgen::model
