// The steps that executors do in ways of their own: on CUDA, where the file is compiled for it, and else on the CPU. So
// that one source is the program of both.
#pragma once

#ifdef __CUDACC__
#include <fem/solver/coarse_inverse_cuda.h>
#include <fem/solver/product_cuda.h>
#include <fem/solver/schwarz_cuda.h>
#include <fem/solver/small_levels_cuda.h>
#else
#include <fem/solver/product_host.h>
#include <fem/solver/schwarz_host.h>
#endif
