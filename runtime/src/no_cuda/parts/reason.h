// The message of every use of GPU or pinned memory in a program whose library has no CUDA.
#pragma once

namespace physgen::backend {

inline constexpr const char* reason =
    "this program has physgen without CUDA; enable the language CUDA before find_package(physgen), or ask it for "
    "COMPONENTS cuda; physgen itself is configured with -DPHYSGEN_CUDA=ON";

}  // namespace physgen::backend
