// Runs the steps of a program on several ranks, each over its part of the arrays: see executor.h for what programs ask
// of an executor. Which fields cross between ranks, and when, is found from the kernels (halo_uses.h); the results have
// the bits that one process has.
#pragma once

#include <physgen/distributed/arrays.h>
#include <physgen/distributed/halo_steps.h>
#include <physgen/distributed/kernel_members.h>
#include <physgen/executor.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace physgen {

/// How an executor of several ranks is made.
struct DistributedOptions {
  /// Fields of ghosts become signalling NaN when they turn stale: a step that reads them nevertheless is seen.
  bool poisons_stale_ghosts = checked_build;
};

/// @tparam On HostExecutor, which runs the steps of each rank
///
/// With one rank every call is On's. With several, run() and reduce() take kernels that show their views
/// (kernel_members.h), and an exception of a kernel ends all ranks with its message.
template <class On>
  requires(std::is_same_v<typename On::Space, Host>)
class DistributedExecutor {
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
      const HaloSteps::Objects objects = begin(n, kernel, false);
      parallel_for(Host{}, objects.begin, objects.end, kernel);
      steps_.end();
    });
  }

  /// The kernel is called for owned objects alone; `then` is called on all ranks, with the same value.
  template <class Kernel, class Fold, class Then>
  void reduce(index_t n, const Kernel& kernel, Fold fold, const Then& then) {
    if (ranks_.count() == 1) return on_.reduce(n, kernel, fold, then);
    ranks_.guard([&] {
      require_replicated(then);
      const HaloSteps::Objects objects = begin(n, kernel, true);
      if (objects.set == nullptr) {
        on_.reduce(n, kernel, fold, then);
      } else {
        then(value_of_all<Fold>(objects, kernel));
      }
      steps_.end();
    });
  }

  /// @throw Error with several ranks: their parts of a set are not those of a reduction in parts
  template <class Kernel, class Fold, class Then>
  void reduce_part(const PartOfReduction& part, const Kernel& kernel, Fold fold, const Then& then) {
    if (ranks_.count() > 1) {
      ranks_.fail(name_of_kernel<Kernel>() +
                  " is reduced part by part, which several ranks cannot do; reduce all objects at once");
    }
    on_.reduce_part(part, kernel, fold, then);
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
      (void)begin(n, kernel, true);
      on_.perform(work);
      steps_.end();
    });
  }

  /// @param done a function object of what all ranks have
  template <class Body, class Done>
  void repeat(Loop& loop, int most, const Body& body, const Done& done) {
    if (ranks_.count() > 1) ranks_.guard([&] { require_replicated(done); });
    on_.repeat(loop, most, body, done);
  }

  void wait() { on_.wait(); }

  /// Of an array of one object, which all ranks have.
  template <class Array>
  [[nodiscard]] typename Array::Value value(const Array& array) {
    if (ranks_.count() > 1) {
      ranks_.guard([&] {
        const UntypedArray memory = array.untyped();
        const KernelView view{memory.base, memory.size, false, memory.object};
        steps_.require_replicated(std::span(&view, 1), "value()");
      });
    }
    return on_.value(array);
  }

  /// Kernels that the table lacks; see HaloSteps.
  [[nodiscard]] const std::set<std::string>& unknown_kernels() const { return steps_.unknown(); }
  [[nodiscard]] const Traffic& traffic() const { return arrays_.transport().traffic(); }

 private:
  template <class Kernel>
  [[nodiscard]] HaloSteps::Objects begin(index_t n, const Kernel& kernel, bool owned_only) {
    std::vector<HaloSteps::Kernel> kernels;
    for_each_kernel(kernel, [&](const auto& one) {
      HaloSteps::Kernel& added = kernels.emplace_back();
      added.name = &name_of_kernel<std::remove_cvref_t<decltype(one)>>();
      for_each_view(one, [&](const KernelView& view) { added.views.push_back(view); });
    });
    return steps_.begin(kernels, n, owned_only);
  }

  template <class Then>
  void require_replicated(const Then& then) const {
    if constexpr (std::is_aggregate_v<Then>) {
      std::vector<KernelView> views;
      for_each_view(then, [&](const KernelView& view) { views.push_back(view); });
      steps_.require_replicated(views, name_of_kernel<Then>());
    }
  }

  /// The values of all ranks' blocks, joined as one process joins them.
  template <class Fold, class Kernel>
  [[nodiscard]] auto value_of_all(const HaloSteps::Objects& objects, const Kernel& kernel) {
    using Types = detail::HostReduction<Kernel, Fold>;
    using Value = typename Types::Value;
    const Runs& runs = objects.set->runs();
    const auto blocks_of = [&](int rank) { return detail::blocks_of(runs.begin(rank), runs.end(rank)); };
    const index_t mine = blocks_of(ranks_.rank()), all = detail::blocks_of(0, runs.size());
    const auto values = std::make_unique<Value[]>(static_cast<std::size_t>(mine * Types::count));
    detail::reduce_blocks<Fold>(objects.begin, objects.end, kernel, values.get(), mine, runs.begin(ranks_.rank()));

    std::vector<index_t> sizes;
    for (int r = 0; r < ranks_.count(); ++r) sizes.push_back(blocks_of(r) * Types::count * index_t{sizeof(Value)});
    const auto gathered = std::make_unique<Value[]>(static_cast<std::size_t>(all * Types::count));
    const auto count = static_cast<std::size_t>(all * Types::count);
    arrays_.transport().gather(std::as_bytes(std::span(values.get(), static_cast<std::size_t>(mine * Types::count))),
                               sizes, std::as_writable_bytes(std::span(gathered.get(), count)));
    // Each rank gave its blocks entry by entry.
    const auto ordered = std::make_unique<Value[]>(count);
    const Value* from = gathered.get();
    index_t before = 0;
    for (int r = 0; r < ranks_.count(); ++r) {
      for (index_t k = 0; k < Types::count; ++k) {
        std::copy_n(from, blocks_of(r), ordered.get() + k * all + before);
        from += blocks_of(r);
      }
      before += blocks_of(r);
    }
    return detail::join_entries<Fold, Types>(ordered.get(), all);
  }

  const Ranks& ranks_;
  DistributedArrays& arrays_;
  HaloSteps steps_;
  On on_;
};

}  // namespace physgen
