// A vendor's shared library that is loaded when it is first used, so that programs start where there is none.
#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <string>
#include <type_traits>

namespace physgen::bench {

/// Its functions, by name. Stays loaded until the program ends.
class VendorLibrary {
 public:
  /// @param name such as "libcusparse.so"; looked for where the system does, then in CUDA's usual folder
  /// @param versions endings of the name to try, such as ".12"
  explicit VendorLibrary(const std::string& name, std::initializer_list<const char*> versions = {}) : name_(name) {
    library_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    for (const char* version : versions) {
      if (library_ == nullptr) library_ = dlopen((name + version).c_str(), RTLD_NOW | RTLD_LOCAL);
    }
    const std::string usual = "/usr/local/cuda/lib64/" + name;
    if (library_ == nullptr) library_ = dlopen(usual.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) missing_ = "no " + name + ": its rows are left out";
  }

  /// Sets `function` to the one of this name, or to null, which missing() then tells.
  template <class Function>
  void find(const char* function_name, Function& function) {
    if (library_ == nullptr) return;
    function = reinterpret_cast<std::remove_reference_t<Function>>(dlsym(library_, function_name));
    if (function == nullptr && missing_.empty())
      missing_ = name_ + " has no " + function_name + ": its rows are left out";
  }

  /// Why the library cannot be used; empty if it can.
  [[nodiscard]] const std::string& missing() const { return missing_; }

 private:
  std::string name_, missing_;
  void* library_ = nullptr;
};

/// Defines `struct Name`, which finds the functions of a list in a library: a member of each function's own name, and
/// `shared`, the library. A list is `#define FUNCTIONS(USE) USE(cusparseCreate) USE(cusparseDestroy)`.
#define PHYSGEN_VENDOR_FUNCTION(function) \
  decltype(&::function) function = nullptr;  // NOLINT: a name in parentheses is none
#define PHYSGEN_VENDOR_FIND(function) shared.find(#function, function);
#define PHYSGEN_VENDOR_LIBRARY(Name, FUNCTIONS, ...) \
  struct Name {                                      \
    FUNCTIONS(PHYSGEN_VENDOR_FUNCTION)               \
    VendorLibrary shared{__VA_ARGS__};               \
    Name() { FUNCTIONS(PHYSGEN_VENDOR_FIND) }        \
  }

}  // namespace physgen::bench
