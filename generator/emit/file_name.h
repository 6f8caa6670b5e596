// Names of the files that emitters write.
#pragma once

#include <string>
#include <string_view>

namespace physgen::emit {

/// The file of a schema: "a/elasticity.h" gives "elasticity.physgen.h" where `ending` is ".physgen.h"; folders are
/// dropped.
[[nodiscard]] inline std::string file_name(const std::string& schema_file, std::string_view ending) {
  std::string name = schema_file.substr(schema_file.find_last_of('/') + 1);
  const auto dot = name.find_last_of('.');
  if (dot != std::string::npos && dot != 0) name.resize(dot);
  return name.append(ending);
}

}  // namespace physgen::emit
