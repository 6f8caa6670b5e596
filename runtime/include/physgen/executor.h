// Runs the steps of a program over arrays. Programs are templates over their executor, `template <class On> void
// solve(On& on, ...)`, so that one source runs on the CPU and on CUDA (cuda/executor.h has that executor), and tells
// which fields it needs (probe.h).
//
//   on.run(n, kernel)                    kernel(i) for the objects 0 .. n-1
//   on.reduce(n, kernel, fold, then)     the same; then(value) runs where the value was formed, and nothing waits
//   on.reduce_part(part, kernel, fold, then)
//                                        the same part by part, kernel(i) for the objects 0 .. part.count-1;
//                                        `then` runs behind the last part. No other reduction stands between two parts
//   on.perform(work)                     work(stream): steps in a way of their own, such as kernels that share memory
//   on.repeat(loop, most, body, done)    body() until done() holds or `most` bodies were run; nothing waits. `loop` is
//                                        an On::Loop that belongs to this place in the program and to these arrays
//   on.wait()                            until all that was given to `on` is done
//   on.value(array)                      waits, and returns the object of an array of one object
#pragma once

#include <physgen/error.h>
#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>

#include <vector>

namespace physgen {

/// The threads of the CPU (threads.h). Every call returns when it is done.
class HostExecutor {
 public:
  using Space = Host;
  /// Nothing is kept of a loop.
  struct Loop {};
  [[nodiscard]] static Stream stream() { return nullptr; }

  /// @throw what kernel(i) throws
  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    parallel_for(Host{}, n, kernel);
  }

  /// @param then takes the fold's Value, or of several terms a std::array or Eigen matrix of them
  template <class Kernel, class Fold, class Then>
  void reduce(index_t n, const Kernel& kernel, Fold fold, const Then& then) {
    then(parallel_reduce(Host{}, n, kernel, fold));
  }

  /// @throw Error when the part does not begin and end with whole blocks; what kernel(i) throws
  template <class Kernel, class Fold, class Then>
  void reduce_part(const PartOfReduction& part, const Kernel& kernel, Fold /*fold*/, const Then& then) {
    using Types = detail::HostReduction<Kernel, Fold>;
    using Value = typename Types::Value;
    part.check();
    const index_t blocks = part.blocks();
    values_.resize(static_cast<std::size_t>(blocks * Types::count) * sizeof(Value));
    auto* const values = reinterpret_cast<Value*>(values_.data());
    detail::reduce_blocks<Fold>(0, part.count, kernel, values + part.first_block(), blocks, part.first);
    if (part.is_last()) then(detail::join_entries<Fold, Types>(values, blocks));
  }

  /// @param work a function object `void operator()(Stream) const`
  /// @throw what it throws
  template <class Work>
  void perform(const Work& work) {
    work(stream());
  }

  /// @param done a function object of what arrays hold, `bool operator()() const`
  template <class Body, class Done>
  void repeat(Loop& /*loop*/, int most, const Body& body, const Done& done) {
    for (int k = 0; k < most; ++k) {
      body();
      if (done()) return;
    }
  }

  void wait() {}

  template <class Array>
  [[nodiscard]] typename Array::Value value(const Array& array) {
    if (array.size() != 1) {
      throw Error(std::string(Array::Object::name) + ": value() is of an array of one object; this one has " +
                  std::to_string(array.size()));
    }
    return array.const_view().get(index_t{0});
  }

 private:
  std::vector<std::byte> values_;  // of the blocks of a reduction in parts
};

}  // namespace physgen
