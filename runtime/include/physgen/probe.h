// Probes find out which fields of which arrays a program reads and writes, by asking the compiler: nothing is run.
//
// A program is a template over its executor and its arrays. Compiled with ProbeExecutor and arrays of probes, it is the
// same source, and every access to a field goes through two functions of the field's format:
//
//   struct Tets { static constexpr const char* name = "tets"; };            // one tag type for each array
//   ProbeOf<elasticity::TetArray<float>, Tets> tets;                        // in place of elasticity::TetArray<float>
//   ProbeExecutor<Host> on;                                                 // in place of HostExecutor
//   program(on, tets, ...);
//   for (const probe::FieldAccess& use : probe::registered()) ...           // {"tets", ..., "nodes", ...}
//
// Rules:
// - A field is `read` where code that the program is made of can convert it to a value, `written` where code can store
//   to it; `add()` and operators such as += do both. Branches are united, whatever their conditions at run time; what
//   `if constexpr` leaves out is not there. Operands of decltype and sizeof are not read.
// - get() and put() of whole objects are uses of all their fields.
// - The address of an element (`atomicAdd(&view[i].count(), 1)`) is a use for reading and writing, and is marked.
// - What reads could hide behind does not compile: view.data(), `auto& x = view[i].m()`, a kernel over a concrete view.
//   A kernel must be a template over its views.
// - A kernel is looked at under each kind of index that the program calls it with: single objects, and packs on the
// CPU.
// - The end of a loop (`done` of repeat()) and value(array) are uses, of all that they read.
// - Layout, precision, sizes and the numbers of the formats are those of the arrays that probes stand for.
//
// Two ways to ask: registered(), with any compiler of C++20, by starting the program (it need not call anything); and
// `physgen usage`, by Clang, which also says which step, at which place, and reads code for devices.
#pragma once

#include <physgen/probe/access_format.h>
#include <physgen/probe/array.h>
#include <physgen/probe/executor.h>
#include <physgen/probe/field_accesses.h>
#include <physgen/probe/steps.h>
