// The executor of programs whose reads and writes are looked for: see executor.h for what programs ask of one.
#pragma once

#include <physgen/probe/steps.h>

namespace physgen {

/// Makes the program's steps known to the compiler, and runs none of them: no kernel, no predicate, no code that is
/// given to perform(). Bodies of loops are called once, since they name the steps.
/// @tparam Space_ where the program runs otherwise: Host or Cuda
template <class Space_>
class ProbeExecutor {
 public:
  using Space = Space_;
  struct Loop {};
  [[nodiscard]] static Stream stream() { return nullptr; }

  template <class Kernel>
  void run(index_t /*n*/, const Kernel& kernel) {
    probe::detail::step<Kernel, Space>(kernel);
  }
  template <class Kernel, class Fold, class Then>
  void reduce(index_t /*n*/, const Kernel& kernel, Fold fold, const Then& then) {
    probe::detail::reduce_step<Kernel, Fold, Then, Space>(kernel, fold, then);
  }
  template <class Kernel, class Fold, class Then>
  void reduce_part(const PartOfReduction& /*part*/, const Kernel& kernel, Fold fold, const Then& then) {
    probe::detail::reduce_step<Kernel, Fold, Then, Space>(kernel, fold, then);
  }
  template <class Work>
  void perform(const Work& work) {
    probe::detail::perform_step<Work, Space>(work);
  }
  template <class Body, class Done>
  void repeat(Loop& /*loop*/, int /*most*/, const Body& body, const Done& done) {
    body();
    probe::detail::root<Done>(done);
  }
  void wait() {}
  /// @return an object of zeros
  template <class Array>
  [[nodiscard]] typename Array::Value value(const Array& array) {
    probe::detail::host_reads<Array>(array);
    return {};
  }
};

}  // namespace physgen
