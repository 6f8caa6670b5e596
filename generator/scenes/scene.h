// The model of a scene: what its declaration says, as plain comparable structs. read.h fills it; the probing unit, the
// needs and the emitters read it. Nothing of Clang or LLVM appears here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "model/text.h"

namespace physgen::scenes {

using model::Location;

/// One field of an array's objects.
struct Field {
  std::string name;      ///< "svd.U" of a nested object, "points.x" of a fixed array of them
  std::string type;      ///< of its stored elements: "float32", "int32", ...
  int elements = 0;      ///< stored ones of one object
  int bytes = 0;         ///< of one object
  bool initial = false;  ///< its schema gives its elements a value other than zero
  bool operator==(const Field&) const = default;
};

/// Fields that an option names.
struct Selection {
  bool all = false;
  std::vector<std::string> names;
  Location location;  ///< of the option
  bool operator==(const Selection&) const = default;

  [[nodiscard]] bool has(const std::string& field) const;
};

/// An index field, and the set whose objects it names.
struct NamedObjects {
  std::string field;
  std::string set;  ///< empty: it names none, as bits and counts
  int shift = 0;    ///< the number is field >> shift
  Location location;
  bool operator==(const NamedObjects&) const = default;
};

struct Array {
  std::string name;
  std::string doc;
  std::string object;     ///< "elasticity::Tet"
  std::string header;     ///< what follows #include to have the object's arrays: "elasticity.physgen.h"
  std::string real;       ///< float or double
  bool own_real = false;  ///< it is spelt Real, as the scene calls its precision
  std::string set;        ///< "tet"; empty: `count` objects
  int count = 0;
  std::optional<Selection> input;
  std::optional<Selection> output;
  bool uniform = false;
  std::vector<NamedObjects> names;
  std::string follows;  ///< a set; empty: none
  std::vector<Field> fields;
  Location location;
  bool operator==(const Array&) const = default;

  [[nodiscard]] bool is_input(const std::string& field) const { return input && input->has(field); }
  [[nodiscard]] bool is_output(const std::string& field) const { return output && output->has(field); }
};

/// Arrays that are made and handed over together.
struct Group {
  std::string name;      ///< "Body"
  std::string variable;  ///< "body": the program's parameter
  std::string doc;
  std::vector<Array> arrays;
  Location location;
  bool operator==(const Group&) const = default;

  /// The name of one of its arrays in the analysis and in messages: "body.tets".
  [[nodiscard]] std::string full_name(const Array& array) const { return variable + "." + array.name; }
  /// The sets that its arrays are per, in order of declaration, each once.
  [[nodiscard]] std::vector<std::string> sets() const;
};

struct Scene {
  std::string name;   ///< "force_chain"
  std::string scope;  ///< enclosing namespaces, "scenes"; empty: global
  std::string doc;
  std::string file;     ///< as it was given
  std::string include;  ///< what follows #include in a program: "scenes/force_chain.h"
  std::string real;     ///< the precision, where the scene declares one as Real: float or double
  std::vector<Group> groups;
  std::vector<std::string> parameters;  ///< types of what the program takes behind its groups
  Location location;
  bool operator==(const Scene&) const = default;

  /// Whether the precision of these arrays is the scene's, which programs may choose otherwise.
  [[nodiscard]] bool has_own_real(const Array& array) const { return array.own_real && !real.empty(); }
  [[nodiscard]] std::string qualified_name() const { return scope.empty() ? name : scope + "::" + name; }
};

/// Whether the scene says which sets its index fields name, so that halos are looked for.
[[nodiscard]] bool states_names(const Scene& scene);

/// "per tet", "1 object", "3 objects".
[[nodiscard]] std::string set_of(const Array& array);

/// The array of a full name, which is unique in a scene. @return null: there is none of this name
[[nodiscard]] const Array* find(const Scene& scene, const std::string& full_name);

/// "elasticity::Tet", "Array" gives "elasticity::TetArray"; the name of what is generated for an object.
[[nodiscard]] std::string generated_name(const Array& array, const std::string& ending);

/// The scene as indented JSON, the same bytes for the same scene.
[[nodiscard]] std::string to_json(const Scene& scene);

using model::unknown;

}  // namespace physgen::scenes
