// Small pieces of C++ and of prose that several pieces of the generated code share.
#pragma once

#include <string>

#include "model/model.h"

namespace physgen::emit::cpp {

/// The shortest literal of type double that reads back as `value`, "3.0": as integers, numbers of 20 digits would be
/// taken modulo 2^64.
[[nodiscard]] std::string real(double value);

/// C++ type of a stored element: "Real", "float", "double", "std::int32_t".
[[nodiscard]] std::string stored_type(model::Element element);

/// Type of an element of a value struct, whose Real may be a SIMD batch: "Real", "physgen::same_lanes_t<Real, float>".
[[nodiscard]] std::string value_type(model::Element element);

/// "physgen::format::Half<4>": how elements of the field are stored in a space. @pre not an object
[[nodiscard]] std::string format_type(const model::Field& field, model::Space space);

/// "physgen::Aosoa<16>".
[[nodiscard]] std::string layout_type(const model::Layout& layout);

/// Name of a type generated for the object that `field` nests, as written in the code of
/// `user`: qualified when the namespaces differ.
[[nodiscard]] std::string nested_type_name(const model::Field& field, const char* ending, const model::Object& user);

/// The comment of a field: what the schema says, with unit, and what else holds for it. May be empty.
[[nodiscard]] std::string field_comment(const model::Field& field);

/// Whether the member of the value struct begins with the field's initial value. Fixed arrays have no short initializer
/// and skew-symmetric matrices hold -x as well: these get their values in a new array only.
[[nodiscard]] bool initial_in_value(const model::Field& field);

/// `name` for a local variable, with an underscore if a field is called so: fields never end with one.
[[nodiscard]] std::string local_name(const char* name, const model::Object& object);

}  // namespace physgen::emit::cpp
