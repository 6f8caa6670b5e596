// The pieces of an object's generated code, in the order in which they are printed.
#pragma once

#include "emit/printer.h"
#include "plan/plan.h"

namespace physgen::emit {

/// `template <class Real> struct Name`: all fields of one object, by value.
void value_struct(Printer& out, const plan::Record& record);

/// `NameFormats<Space>`: how the fields are stored.
void formats_struct(Printer& out, const model::Object& object);

/// `NameProbe<ArrayTag, Base>`: the formats that tell reads and writes apart.
void probe_struct(Printer& out, const plan::Record& record);

/// `NameRecord<Real, Formats>`: the byte offsets of the fields.
void record_struct(Printer& out, const plan::Record& record);

/// `NameRef<Real, Formats, Cursor>`: the accessors.
void ref_class(Printer& out, const plan::Record& record);

/// `NameObject`: what the runtime is told, the aliases `NameView` and `NameArray`, and the proofs for both spaces.
void object_tag(Printer& out, const plan::Record& host, const plan::Record& cuda);

}  // namespace physgen::emit
