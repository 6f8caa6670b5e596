// How much code an object becomes, estimated from the model before any of it is written: nested objects are written out
// field by field, so that a few lines of schema can stand for gigabytes.
#pragma once

#include <map>
#include <string>

#include "model/model.h"

namespace physgen::emit::cpp {

/// Largest code of one object and of the objects of one schema [bytes]. The former takes compilers about 10 seconds;
/// the latter is that of a thousand objects of ten fields.
inline constexpr double max_object_bytes = 2 << 20;
inline constexpr double max_header_bytes = 8 << 20;

/// Most fields of one object, those of nested objects one by one.
inline constexpr double max_object_fields = 4000;

struct ObjectSize {
  double bytes = 0;   ///< of generated code; at most a quarter less, and half more, than the emitter will write
  double fields = 0;  ///< those of nested objects one by one
  int largest_nested =
      -1;  ///< the field whose nested object takes most; -1: its own fields take more than nested objects
};

/// Estimates objects in order of declaration, imported ones included.
class HeaderSizes {
 public:
  /// The size of an object, which those after it may nest; nested objects that are not known count nothing.
  ObjectSize of(const model::Object& object);

  /// Objects that nest this one, which has been refused, are to be estimated without it.
  void forget(const model::Object& object) { runs_.erase(object.qualified_name()); }

 private:
  /// The fields of an object, those of its nested objects included: each has a text in the list of fields. Sums over
  /// all of them; double, because the numbers may have no end.
  struct Runs {
    double count = 0;
    double names = 0;  // characters of the paths from the object: a.b[3].c
  };
  std::map<std::string, Runs, std::less<>> runs_;  // by qualified name
};

}  // namespace physgen::emit::cpp
