// An emitter turns a model into the text of a file. Each is a folder here and a line in emitter.cpp.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "emit/file_name.h"
#include "model/model.h"
#include "model/validate.h"

namespace physgen::emit {

struct Emitter {
  std::string_view name;    ///< of --emitter: "cpp"
  std::string_view what;    ///< for help: "accessor classes in C++"
  std::string_view ending;  ///< of its files: ".physgen.h"
  /// Finds the parts of a schema that it cannot write, beyond the rules of the model: names that its language keeps,
  /// types that would clash, sizes.
  model::Rules objections;
  /// The text of the file; the same text for the same schema, whatever the machine and the time.
  /// @pre neither model::validate() nor objections() has an objection
  /// @throws std::logic_error when a planned record does not pass its proof (a defect of physgen)
  std::string (*emit)(const model::Schema&);
};

/// All of them; the first is the one that is taken where none is named.
[[nodiscard]] std::span<const Emitter> emitters();

/// There is no emitter of a name; what() says which is nearest, or which there are.
struct UnknownEmitter : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// @throws UnknownEmitter
[[nodiscard]] const Emitter& emitter(const std::string& name);

/// Name of the file that an emitter writes of a schema.
[[nodiscard]] inline std::string file_of(const Emitter& emitter, const std::string& schema_file) {
  return file_name(schema_file, emitter.ending);
}

}  // namespace physgen::emit
