// What every use of GPU or pinned memory says in a build without CUDA.
#pragma once

namespace physgen::backend {

inline constexpr const char* reason = "this physgen was built without CUDA; configure with -DPHYSGEN_CUDA=ON";

}  // namespace physgen::backend
