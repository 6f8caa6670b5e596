// All storage formats: how the elements of a field lie in memory, apart from the type they are computed with. A format
// is a struct with the members of format::Native in one file of format/: accessors take it as it is, also one of a
// program's own. What it stores is an ElementType; a new one of these needs its size and relative error in
// element_type.h and, for copies, a codec and its case in src/element_codec.h.
#pragma once

#include <physgen/format/bfloat16.h>
#include <physgen/format/half.h>
#include <physgen/format/native.h>
#include <physgen/format/quaternion.h>
#include <physgen/format/snorm16.h>
