// All storage formats: how the elements of a field lie in memory, apart from the type they are computed with. A format
// is a struct with the members of format::Native; one of a program's own needs nothing else to be used by accessors,
// and a case in src/element_codec.h to be converted by copy().
#pragma once

#include <physgen/format/bfloat16.h>
#include <physgen/format/half.h>
#include <physgen/format/native.h>
#include <physgen/format/quaternion.h>
#include <physgen/format/snorm16.h>
