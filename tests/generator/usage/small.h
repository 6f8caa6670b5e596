// The few declarations of probes that the analysis of usage knows, in front of small programs that need no other
// header.
#pragma once

#include <string>

namespace physgen::test {

// A view of objects with one field, which is read by get() and stored by put(). Lines of a test's text begin at 1.
inline const std::string small_probes = "#include \"" PHYSGEN_SMALL_PROBES "\"\n#line 1 \"small.cpp\"\n";

}  // namespace physgen::test
