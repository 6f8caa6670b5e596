// Which names a schema may use: identifiers that C++ and CUDA accept in the generated code, and that are not needed
// there.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace physgen::emit::cpp {

enum class NameOf { field, object, scope };

/// Endings of the types generated for an object `Name`; "" is the value struct itself.
inline constexpr std::array<std::string_view, 8> generated_endings = {"",    "Formats", "Probe", "Record",
                                                                      "Ref", "Object",  "View",  "Array"};

/// Why `name` cannot be the name of such a thing, without subject ("is a keyword of C++; ..."); empty if it can be.
[[nodiscard]] std::string name_problem(std::string_view name, NameOf of);

}  // namespace physgen::emit::cpp
