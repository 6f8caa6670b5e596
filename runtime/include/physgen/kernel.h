// All words that a kernel is written in, for single objects, packs and CUDA threads at once:
//
//   any(i, mask), all(i, mask)               questions to the objects at the kernel's index i
//   largest(i, x), smallest(i, x)            over them: `for (int k = 0; k < largest(i, count); ++k)`
//   wanted<Scalar>(i), numbers(i)            which lanes are objects, and their numbers
//   object_number(i)                         of one object: its number
//   object_of_part(first, i)                 object(s) first + i, as the kernel's own
//   add(i, view[j].f(), value)               sums at objects that several lanes or threads may name
//   store_where(mask, view[i].f(), value)    a store where a condition holds
//   select(mask, a, b)                       in place of `?:`; masks join by &&, || and !
//   cast<double>(x), to_real<S>(n)           float, double and integers in one kernel
//   to_index(floor(x / h))                   the number of a cell, or of another object
//   exp, log, pow, max, ... of math.h        with plain numbers second: `max(m, 0.0)`
//
// Write `using namespace physgen; using namespace physgen::math;` where the kernel stands, and call them unqualified.
// No SIMD is included here, so that CUDA translation units can; parallel_for.h adds what packs need.
#pragma once

#include <physgen/detail/lanewise.h>
#include <physgen/kernels/add.h>
#include <physgen/kernels/lanes.h>
#include <physgen/kernels/math.h>
#include <physgen/kernels/pack.h>
