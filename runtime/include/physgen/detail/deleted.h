// Declares a deleted function with the reason that compilers print: `refused f(X) PHYSGEN_DELETED(refused);`.
//
// The reason is the name of a type, which the function also returns or takes, since g++ and nvcc print the function's
// declaration in the line of the error. clang prints the declaration in a note behind it, so it is given the reason.
#pragma once

#if defined(__clang__) && defined(__cpp_deleted_function)  // from clang 19 on, in C++20 as an extension
#define PHYSGEN_DELETED(reason)                                                                 \
  _Pragma("clang diagnostic push") _Pragma("clang diagnostic ignored \"-Wc++26-extensions\"") = \
      delete (#reason)_Pragma("clang diagnostic pop")
#else
#define PHYSGEN_DELETED(reason) = delete
#endif
