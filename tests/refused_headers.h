// What most sources of refused cases include: read once for each compiler (tests/CMakeLists.txt), since it is what
// takes time.
#pragma once
#include <elasticity.physgen.h>
#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>
