// Generated code includes this: views, arrays and everything they are made of, but neither SIMD nor CUDA headers.
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/arrays/view.h>
