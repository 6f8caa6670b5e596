// Runs the steps of a program on several ranks, each over its part of the arrays: see executor.h for what programs ask
// of an executor. Which fields cross between ranks, and when, is found from the kernels (halo_uses.h); the results have
// the bits that one process has.
#pragma once

#include <physgen/distributed/arrays.h>
#include <physgen/distributed/block_values.h>
#include <physgen/distributed/options.h>
#include <physgen/distributed/step_kernels.h>
#include <physgen/executor.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace physgen {

/// With one rank every call is On's. With several, kernels show their views (kernel_members.h), and an exception of a
/// kernel ends all ranks with its message. While fields cross, a step is called for the objects that need none of them.
template <class On>
  requires(std::is_same_v<typename On::Space, Host>)
class DistributedExecutor<On> {
 public:
  using Space = typename On::Space;
  using Loop = typename On::Loop;

  /// @param arrays outlive this. @pre cut() was called
  DistributedExecutor(const Ranks& ranks, DistributedArrays& arrays, DistributedOptions options = {})
      : ranks_(ranks), arrays_(arrays), steps_(arrays, options.poisons_stale_ghosts) {}

  [[nodiscard]] Stream stream() const { return on_.stream(); }

  /// @param n of the objects that are here, array.size()
  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    if (ranks_.count() == 1) return on_.run(n, kernel);
    ranks_.guard([&] {
      const HaloSteps::Objects objects = begin(n, kernel, HaloSteps::Way::run);
      for_ranges(objects, [&](index_t first, index_t last) { parallel_for(Host{}, first, last, kernel); });
      steps_.end();
    });
  }

  /// The terms are those of owned objects; `then` is called on all ranks, with the same value.
  template <class Kernel, class Fold, class Then>
  void reduce(index_t n, const Kernel& kernel, Fold fold, const Then& then) {
    if (ranks_.count() == 1) return on_.reduce(n, kernel, fold, then);
    ranks_.guard([&] {
      detail::require_replicated(steps_, then);
      const HaloSteps::Objects objects = begin(n, kernel, HaloSteps::Way::reduce);
      if (objects.set == nullptr) {
        on_.reduce(n, kernel, fold, then);
      } else {
        values_.begin<detail::HostReduction<Kernel, Fold>>(*objects.set);
        for_ranges(objects, [&](index_t first, index_t last) { values_.add<Fold>(first, last, 0, kernel); });
        drop_ghosts<Fold>(objects, objects.also, 0, kernel);
        then(values_.of_all_ranks<Fold, Kernel>(arrays_.transport()));
      }
      steps_.end();
    });
  }

  /// The parts are those of the objects that are here, part.of = array.size(); ranks may have other numbers of parts.
  /// `then` is called behind the last, on all ranks, with the value that one reduction of all objects has.
  /// @throw Error, too, when another step runs between two parts, but for steps over windows (add_window())
  template <class Kernel, class Fold, class Then>
  void reduce_part(const PartOfReduction& part, const Kernel& kernel, Fold fold, const Then& then) {
    if (ranks_.count() == 1) return on_.reduce_part(part, kernel, fold, then);
    ranks_.guard([&] {
      detail::require_replicated(steps_, then);
      part.check();
      const std::vector<HaloSteps::Kernel> kernels = detail::kernels_of(kernel);
      const HaloSteps::Objects objects = steps_.begin_part(kernels, part);
      if (objects.set == nullptr) {
        on_.reduce_part(part, kernel, fold, then);
      } else {
        if (part.first == 0) values_.begin<detail::HostReduction<Kernel, Fold>>(*objects.set);
        const auto of_part = [&](index_t object) { return std::clamp(object, part.first, part.first + part.count); };
        const index_t first = of_part(objects.begin), last = of_part(objects.end);
        if (first < last) values_.add<Fold>(first, last, part.first, kernel);
        drop_ghosts<Fold>(objects, {of_part(objects.also.begin), of_part(objects.also.end)}, part.first, kernel);
        if (part.is_last()) then(values_.of_all_ranks<Fold, Kernel>(arrays_.transport()));
      }
      steps_.end_part(part);
    });
  }

  /// @throw Error with several ranks: what the work uses is not known; give a kernel that has the same views
  template <class Work>
  void perform(const Work& work) {
    if (ranks_.count() > 1) {
      ranks_.fail("perform() of work whose views are not known; give a kernel that has them as the second argument");
    }
    on_.perform(work);
  }
  /// work(stream) computes what the kernel would for the objects here that are owned, or for more.
  template <class Work, class Kernel>
  void perform(const Work& work, const Kernel& kernel, index_t n) {
    if (ranks_.count() == 1) return on_.perform(work);
    ranks_.guard([&] {
      (void)begin(n, kernel, HaloSteps::Way::at_once);
      on_.perform(work);
      steps_.end();
    });
  }

  /// The same, of what all ranks have, by each of them: nothing crosses, and it need not be a step over a set.
  /// @throw Error when one of the kernel's views is of an array of which ranks have parts
  template <class Work, class Kernel>
  void perform_on_each(const Work& work, const Kernel& kernel) {
    if (ranks_.count() > 1) ranks_.guard([&] { detail::require_replicated(steps_, kernel); });
    on_.perform(work);
  }

  /// @param done a function object of what all ranks have
  template <class Body, class Done>
  void repeat(Loop& loop, int most, const Body& body, const Done& done) {
    if (ranks_.count() > 1) ranks_.guard([&] { detail::require_replicated(steps_, done); });
    on_.repeat(loop, most, body, done);
  }

  void wait() { on_.wait(); }

  /// Of an array of one object, which all ranks have.
  template <class Array>
  [[nodiscard]] typename Array::Value value(const Array& array) {
    if (ranks_.count() > 1) {
      ranks_.guard([&] { detail::require_replicated_value(steps_, array); });
    }
    return on_.value(array);
  }

  /// See kernels/object_numbers.h. @throw Error when the array is of entries of rows
  template <class Array>
  [[nodiscard]] ObjectNumbers numbers_of(const Array& array) {
    return {ranks_.count() == 1 ? nullptr : arrays_.global_numbers(array)};
  }

  /// Kernels that the table lacks; see HaloSteps.
  [[nodiscard]] const std::set<std::string>& unknown_kernels() const { return steps_.unknown(); }
  [[nodiscard]] const Traffic& traffic() const { return arrays_.transport().traffic(); }

 private:
  template <class Kernel>
  [[nodiscard]] HaloSteps::Objects begin(index_t n, const Kernel& kernel, HaloSteps::Way way) {
    return steps_.begin(detail::kernels_of(kernel), n, way);
  }

  template <class Call>
  void for_ranges(const HaloSteps::Objects& objects, const Call& call) {
    detail::for_ranges(steps_, objects, arrays_.transport(), call);
  }

  /// Calls a kernel of a reduction for the ghosts of a range.
  template <class Fold, class Kernel>
  void drop_ghosts(const HaloSteps::Objects& objects, const HaloSteps::Range& range, index_t shift,
                   const Kernel& kernel) {
    detail::BlockValues::drop<Fold>(range.begin, std::min(range.end, objects.begin), shift, kernel);
    detail::BlockValues::drop<Fold>(std::max(range.begin, objects.end), range.end, shift, kernel);
  }

  const Ranks& ranks_;
  DistributedArrays& arrays_;
  HaloSteps steps_;
  detail::BlockValues values_;
  On on_;
};

}  // namespace physgen
