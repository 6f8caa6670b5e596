// See validate.h. One small function per rule; Checker carries what they share.
#include "model/validate.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <charconv>
#include <climits>
#include <cmath>
#include <map>
#include <string_view>

#include "model/names.h"

namespace physgen::model {
namespace {

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string sized(const Field& field) {  // the field's type as a schema says it: Symmetric<3>
  const std::string n = std::to_string(field.rows);
  switch (field.shape) {
    case Shape::scalar:
      return "Scalar";
    case Shape::vector:
      return "Vector<" + n + ">";
    case Shape::matrix:
      return "Matrix<" + n + ", " + std::to_string(field.cols) + ">";
    case Shape::symmetric:
      return "Symmetric<" + n + ">";
    case Shape::diagonal:
      return "Diagonal<" + n + ">";
    case Shape::skew:
      return "Skew<" + n + ">";
    case Shape::rotation:
      return "Rotation";
    case Shape::object:
      return field.object;
  }
  return {};
}

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
    std::map<std::string, Place, std::less<>> names;
    for (std::size_t i = 0; i < object.fields.size(); ++i) {
      place_.field = static_cast<int>(i);
      field_name(object, object.fields[i], names);
      elements = std::min<long long>(elements + field(object, object.fields[i]), INT_MAX);
    }
    place_ = self;
    if (elements > max_elements)
      report(Aspect::name, "object " + quoted(object.name) + " has more than " + std::to_string(max_elements) +
                               " elements; split it, or keep its large parts in arrays of objects of their own");
    declared_.emplace(object.qualified_name(), Declared{self, elements});
  }

  void object_names(const Object& object) {
    if (auto problem = name_problem(object.name, NameOf::object); !problem.empty())
      report(Aspect::name, "object name " + quoted(object.name) + " " + problem);
    for (std::size_t begin = 0; begin < object.scope.size();) {
      const std::size_t end = std::min(object.scope.find("::", begin), object.scope.size());
      const std::string part = object.scope.substr(begin, end - begin);
      if (auto problem = name_problem(part, NameOf::scope); !problem.empty())
        report(Aspect::scope, "namespace " + quoted(part) + " " + problem);
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

  void field_name(const Object& object, const Field& field, std::map<std::string, Place, std::less<>>& names) {
    if (auto problem = name_problem(field.name, NameOf::field); !problem.empty())
      report(Aspect::name, "field name " + quoted(field.name) + " " + problem);
    for (const auto ending : generated_endings)
      if (field.name == object.name + std::string(ending))
        report(Aspect::name, "field name " + quoted(field.name) + " is also the name of a type generated for object " +
                                 quoted(object.name) + "; choose another name");
    for (const Field& other : object.fields)
      for (const char* ending : {"", "Formats", "Record", "Ref"})
        if (other.shape == Shape::object && field.name != object.name &&
            field.name == other.object.substr(other.object.rfind(':') + 1) + ending)
          report(Aspect::name, "field name " + quoted(field.name) + " is also the name of the object type " +
                                   quoted(other.object + ending) + " nested here; choose another name");
    const auto [first, is_new] = names.emplace(field.name, place_);
    if (!is_new)
      report(Aspect::name, "field " + quoted(field.name) + " is declared twice; rename or remove one", first->second);
  }

  /// @return the number of elements, 0 if it cannot be said
  long long field(const Object& object, const Field& field) {
    const bool is_array = field.array_extent != 0;
    if (is_array && (field.array_extent < 1 || field.array_extent > max_extent))
      report(Aspect::type, "array " + quoted(field.name) + " has an extent outside 1 to " + std::to_string(max_extent) +
                               "; keep large or varying numbers of entries in an array of objects of their own");
    options(field);
    const long long entries = is_array ? std::clamp(field.array_extent, 1, max_extent) : 1;
    if (field.shape == Shape::object) return entries * nested(object, field);
    return sizes(field) ? entries * element_count(field) : 0;
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

  bool sizes(const Field& field) {
    const auto wrong = [&](const std::string& instead) {
      report(Aspect::type, "field " + quoted(field.name) + " has the type " + sized(field) + ", " + instead);
      return false;
    };
    const std::string limits = "whose sizes must be from 1 to " + std::to_string(max_side);
    const int rows = field.rows, cols = field.cols;
    if (rows < 1 || cols < 1) return wrong("which stores nothing; " + std::string("sizes must be at least 1"));
    if (rows > max_side || cols > max_side) return wrong(limits + "; keep larger matrices in objects of blocks");
    switch (field.shape) {
      case Shape::scalar:
        return (rows == 1 && cols == 1) || wrong("but rows and cols are not 1");
      case Shape::vector:
        return cols == 1 || wrong("but cols is not 1");
      case Shape::skew:
        if (rows == 1) return wrong("which stores nothing; a skew-symmetric matrix has at least size 2");
        [[fallthrough]];
      case Shape::symmetric:
      case Shape::diagonal:
        return rows == cols || wrong("but rows and cols differ");
      case Shape::rotation:
        if (field.element == Element::index || field.element == Element::int32)
          return wrong("whose elements must be real");
        return (rows == 3 && cols == 3) || wrong("but rows and cols are not 3");
      case Shape::matrix:
      case Shape::object:
        return true;
    }
    return true;
  }

  void options(const Field& field) {
    if (field.shape == Shape::object) {
      const std::string advice = " has no meaning for nested object " + quoted(field.name) +
                                 "; write it at the fields of " + quoted(field.object);
      if (!field.unit.empty()) report(Aspect::unit, "unit()" + advice);
      if (field.range) report(Aspect::range, "range()" + advice);
      if (field.initial) report(Aspect::initial, "initial()" + advice);
      if (field.host_format != Format{}) report(Aspect::host_format, "format()" + advice);
      if (field.cuda_format != Format{}) report(Aspect::cuda_format, "format()" + advice);
      return;
    }
    unit(field.unit);
    if (field.range) range(*field.range);
    if (field.initial) initial(field);
    format(Aspect::host_format, field, field.host_format);
    format(Aspect::cuda_format, field, field.cuda_format);
  }

  void format(Aspect aspect, const Field& field, const Format& format) {
    if (format == Format{}) return;
    if (field.element == Element::index || field.element == Element::int32)
      report(aspect,
             "the elements of " + quoted(field.name) + " are integers, which have no other format; leave it out");
    else if (format.quaternion && field.shape != Shape::rotation)
      report(aspect, "only a Rotation can be stored as a quaternion; " + quoted(field.name) + " is a " + sized(field));
    else if (format.encoding == Encoding::snorm16 && field.shape != Shape::rotation && !field.range)
      report(aspect, "snorm16 has equal steps over a range, and " + quoted(field.name) +
                         " states none; add one, such as range(-1, 1)");
    else if (format.encoding == Encoding::snorm16 && field.shape != Shape::rotation &&
             !(field.range->low < field.range->high))
      report(aspect,
             "snorm16 has equal steps over a range of more than one value; widen the range of " + quoted(field.name));
    else if (format.encoding == Encoding::half && field.initial && std::abs(*field.initial) > 65504 && !field.range)
      report(aspect, "initial(" + number(*field.initial) + ") is no half, which ends at 65504; state the range of " +
                         quoted(field.name) + ", and it is scaled");
    else
      magnitudes(aspect, field, format.encoding);
  }

  // Stated values that the format would lose: halves are scaled by 2^-100 to 2^100, the others end where float does.
  void magnitudes(Aspect aspect, const Field& field, Encoding encoding) {
    if (encoding == Encoding::native || encoding == Encoding::float64 || field.shape == Shape::rotation) return;
    if (encoding == Encoding::snorm16 && field.element == Element::float64) return;
    const double end = field.range ? std::max(std::abs(field.range->low), std::abs(field.range->high)) : 0;
    const double largest = std::max(end, std::abs(field.initial.value_or(0)));
    const double limit = encoding == Encoding::half ? 0x1p115 : encoding == Encoding::bfloat16 ? 0x1.FEp127 : FLT_MAX;
    const bool too_small = encoding == Encoding::half && end > 0 && end < 0x1p-86;
    if (largest <= limit && !too_small) return;
    const char* held = too_small                        ? "ranges that end above 1.3e-26"
                       : encoding == Encoding::half     ? "sizes up to 4.1e+34"
                       : encoding == Encoding::bfloat16 ? "sizes up to 3.38e+38"
                                                        : "sizes up to 3.4e+38";
    report(aspect, std::string(end > limit || too_small ? "the range" : "the initial value") + " of " +
                       quoted(field.name) + " is beyond what this format holds, " + held + "; choose float64");
  }

  void unit(const std::string& unit) {
    const auto unprintable = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '"' || c == '\\'; };
    if (unit.size() > 64 || std::any_of(unit.begin(), unit.end(), unprintable))
      report(Aspect::unit,
             "a unit is at most 64 printable characters without quotes and backslashes; write one such as "
             "unit(\"N/m^2\")");
  }

  void range(const Range& range) {
    if (!std::isfinite(range.low) || !std::isfinite(range.high))
      report(Aspect::range, "both ends of a range must be finite; write the largest meaningful value instead");
    else if (range.low > range.high)
      report(Aspect::range, "range(" + number(range.low) + ", " + number(range.high) +
                                ") is empty; write the lower end first, range(" + number(range.high) + ", " +
                                number(range.low) + ")");
  }

  void initial(const Field& field) {
    const double value = *field.initial;
    const bool whole = field.element == Element::index || field.element == Element::int32;
    const bool is_float = field.element == Element::real || field.element == Element::float32;  // or can be
    if (!std::isfinite(value))
      report(Aspect::initial, "an initial value must be finite; leave initial() out for 0");
    else if (field.shape == Shape::rotation)
      report(Aspect::initial, "a matrix of equal elements is not a rotation; leave initial() out");
    else if (whole && (value != std::floor(value) || value < INT_MIN || value > INT_MAX))
      report(Aspect::initial, "initial(" + number(value) + ") is not a 32-bit integer, as the elements of " +
                                  quoted(field.name) + " are; write one");
    else if (is_float && std::abs(value) > FLT_MAX)
      report(Aspect::initial, "initial(" + number(value) + ") is no float, as the elements of " + quoted(field.name) +
                                  " are or can be; write a value from -" + number(FLT_MAX) + " to " + number(FLT_MAX) +
                                  ", or declare it double");
    else if (field.range && (value < field.range->low || value > field.range->high))
      report(Aspect::initial, "initial(" + number(value) + ") is outside range(" + number(field.range->low) + ", " +
                                  number(field.range->high) + "); change one of them");
  }

  void layout(Aspect aspect, const std::optional<Layout>& layout) {
    if (!layout) return;
    if (layout->kind == LayoutKind::aosoa && (layout->tile < 2 || !is_power_of_two_up_to(layout->tile, max_tile)))
      report(aspect, "tile " + std::to_string(layout->tile) +
                         " is not a power of two from 2 to 1024; write one, such as aosoa(32)");
    if (layout->kind != LayoutKind::aosoa && layout->tile != 0)
      report(aspect, "only an aosoa layout has a tile; leave it out");
  }

  const Object& at(const Place& place) const {
    return (place.imported ? schema_.imported : schema_.objects)[static_cast<std::size_t>(place.object)];
  }

  const Schema& schema_;
  Place place_;
  std::map<std::string, Declared, std::less<>> declared_;
  std::map<std::string, Place, std::less<>> generated_;  // qualified names of all generated types
  std::vector<Issue> issues_;
};

}  // namespace

bool is_power_of_two_up_to(int value, int limit) {
  return value >= 1 && value <= limit && std::has_single_bit(static_cast<unsigned>(value));
}

std::vector<Issue> validate(const Schema& schema) { return Checker(schema).run(); }

}  // namespace physgen::model
