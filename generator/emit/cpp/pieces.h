// The pieces of an object's generated code, in the order in which they are printed. Most need no plan: the runtime
// computes offsets from the formats when it is compiled, for formats that a program chooses, too.
#pragma once

#include "emit/printer.h"
#include "plan/plan.h"

namespace physgen::emit::cpp {

/// Entries of the longest fixed arrays that generated code goes through without a loop. Longer loops stay loops: code
/// size and compile time must not grow with the extent of an array.
inline constexpr int longest_unrolled = 32;

/// `template <class Real> struct Name`: all fields of one object, by value.
void value_struct(Printer& out, const model::Object& object);

/// `NameFormats<Space>`: how the fields are stored.
void formats_struct(Printer& out, const model::Object& object);

/// `NameProbe<ArrayTag, Base>`: the formats that tell reads and writes apart.
void probe_struct(Printer& out, const plan::Record& record);

/// `NameRecord<Real, Formats>`: the fields with their shapes, formats and types.
void record_struct(Printer& out, const model::Object& object);

/// `NameRef<Real, Formats, Cursor>`: the accessors.
void ref_class(Printer& out, const model::Object& object);

/// `NameObject`: what the runtime is told, the aliases `NameView` and `NameArray`, and the proofs for both spaces.
void object_tag(Printer& out, const plan::Record& host, const plan::Record& cuda);

}  // namespace physgen::emit::cpp
