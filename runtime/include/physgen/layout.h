// All layouts. Every one obeys one law with a single pitch: element of `size` bytes at byte offset B of a record,
//
//   address(B, i) = base + (i / pitch) * pitch * record_bytes + B * pitch + (i % pitch) * size
//
// pitch = 1 is an array of structs, the padded object count a struct of arrays, W an array of structs of W-wide arrays.
#pragma once

#include <physgen/layout/aos.h>
#include <physgen/layout/aos_padded.h>
#include <physgen/layout/aosoa.h>
#include <physgen/layout/soa.h>
