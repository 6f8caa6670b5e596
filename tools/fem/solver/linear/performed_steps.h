// The products that executors do in ways of their own: on CUDA, where the file is compiled for it, and else on the CPU,
// so that one source is the program of both.
#pragma once

#ifdef __CUDACC__
#include <fem/solver/linear/product_cuda.h>
#else
#include <fem/solver/linear/product_host.h>
#endif
