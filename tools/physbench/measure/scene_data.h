// The scene as provider of a kernel's data. What compares and makes inputs is defined in scene_errors.h and compiled
// once per kernel, by the C++ compiler; CUDA files only call it.
#pragma once

#include <memory>
#include <string>

#include "data/operands.h"
#include "measure/row.h"

namespace physgen::bench {

template <class Kernel_, class Real_>
class OnScene {
 public:
  using Kernel = Kernel_;
  using Real = Real_;
  static constexpr bool errors_in_eps = false;

  explicit OnScene(std::shared_ptr<Scene> scene, std::string set = "")
      : scene_(std::move(scene)), set_(std::move(set)) {}
  [[nodiscard]] index_t objects() const { return count(Kernel::domain); }
  [[nodiscard]] index_t count(Domain domain) const { return scene_->count(domain, Kernel::domain); }
  [[nodiscard]] index_t results(Domain domain) const { return count(domain); }
  [[nodiscard]] double bytes() const;  ///< that the kernel must move
  template <class Scheme>
  [[nodiscard]] double bytes_in() const;  ///< the same, in the formats of a scheme
  /// The mesh, the inputs in double, the results and their references.
  [[nodiscard]] double memory() const {
    return scene_->memory() + bytes() / sizeof(Real) * (sizeof(double) + 2 * sizeof(Real) + sizeof(long double));
  }
  [[nodiscard]] const std::string& set() const { return set_; }
  [[nodiscard]] const std::shared_ptr<Scene>& scene() const { return scene_; }

  [[nodiscard]] Masters<typename Kernel::Reads> inputs() const;
  [[nodiscard]] Accuracy check(const HostArrays<typename Kernel::Writes, Real>& results) const;
  template <class At>
  [[nodiscard]] Accuracy compare(const At& at) const;

 private:
  std::shared_ptr<Scene> scene_;
  std::string set_;
};

}  // namespace physgen::bench
