// Runs the steps of a program on several ranks with a CUDA device each: see distributed/executor.h. Included by CUDA
// translation units only.
#pragma once

#include <physgen/cuda/executor.h>
#include <physgen/distributed/arrays.h>
#include <physgen/distributed/cuda/block_values.h>
#include <physgen/distributed/cuda/halo_exchange.h>
#include <physgen/distributed/cuda/recorded_loops.h>
#include <physgen/distributed/cuda/transports.h>
#include <physgen/distributed/options.h>
#include <physgen/distributed/step_kernels.h>
#include <physgen/kernels/object_numbers.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace physgen {

/// The executor of arrays in CUDA memory, on the device that cut() took for this rank. With one rank every call is
/// On's. Several ranks give the bits of one that computes on such a device. Where NCCL carries what crosses, their
/// loops are graphs whose rounds the device decides on; else, or with PHYSGEN_LOOPS_ON_HOST in the environment, the
/// host waits in every round for `done`.
/// @tparam On CudaExecutor
template <class On>
  requires(std::is_same_v<typename On::Space, Cuda>)
class DistributedExecutor<On> {
 public:
  using Space = typename On::Space;
  /// A loop, once it has been run. It is run again with the same arrays, kernels and their parameters.
  struct Loop {
    typename On::Loop of_one;                                    ///< rank
    std::vector<cuda::RecordedLoop<typename On::Loop>> of_many;  ///< ranks: one for each state in which rounds begin
  };

  /// All ranks make it together. @param arrays outlive this. @pre cut() was called
  /// @throw Error when ranks would share a GPU, an array lies in other memory, or there is no memory on the device
  DistributedExecutor(const Ranks& ranks, DistributedArrays& arrays, DistributedOptions options = {})
      : ranks_(ranks), arrays_(arrays), on_(detail::DeviceBlockValues::most_objects(arrays), options.result_bytes) {
    if (ranks.count() == 1) return;
    ranks.guard([&] {
      crossing_ = cuda::make_device_transport(ranks, arrays.transport(), on_.stream(), options.uses_nccl);
      steps_.emplace(arrays, options.poisons_stale_ghosts,
                     cuda::make_device_exchange(arrays, *crossing_.transport, on_.stream()));
      values_.emplace(arrays, options.result_bytes);
    });
  }

  [[nodiscard]] Stream stream() const { return on_.stream(); }

  /// @param n of the objects that are here, array.size()
  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    if (ranks_.count() == 1) return on_.run(n, kernel);
    ranks_.guard([&] {
      const HaloSteps::Objects objects = begin(n, kernel, HaloSteps::Way::run);
      for_ranges(objects, [&](index_t first, index_t last) { parallel_for(Cuda{}, first, last, kernel, stream()); });
      steps_->end();
    });
  }

  /// The same by a launch of the program's own: launch(first, last, stream) orders what the kernel does for these
  /// objects.
  template <class Kernel, class Launch>
  void run(index_t n, const Kernel& kernel, const Launch& launch) {
    if (ranks_.count() == 1) return launch(index_t{0}, n, stream());
    ranks_.guard([&] {
      const HaloSteps::Objects objects = begin(n, kernel, HaloSteps::Way::run);
      for_ranges(objects, [&](index_t first, index_t last) { launch(first, last, stream()); });
      steps_->end();
    });
  }

  /// The terms are those of owned objects; `then` is called on all ranks, with the same value.
  template <class Kernel, class Fold, class Then>
  void reduce(index_t n, const Kernel& kernel, Fold fold, const Then& then) {
    if (ranks_.count() == 1) return on_.reduce(n, kernel, fold, then);
    ranks_.guard([&] {
      detail::require_replicated(*steps_, then);
      const HaloSteps::Objects objects = begin(n, kernel, HaloSteps::Way::reduce);
      if (objects.set == nullptr) {
        on_.reduce(n, kernel, fold, then);
      } else {
        values_->begin<Fold, Kernel>(*objects.set);
        for_ranges(objects, [&](index_t first, index_t last) { values_->add<Fold>(first, last, 0, kernel, stream()); });
        drop_ghosts(objects, objects.also, 0, kernel);
        values_->join<Fold, Kernel>(*crossing_.transport, then, stream());
      }
      steps_->end();
    });
  }

  /// As that of HostExecutor's. @throw Error, too, when another step runs between two parts
  template <class Kernel, class Fold, class Then>
  void reduce_part(const PartOfReduction& part, const Kernel& kernel, Fold fold, const Then& then) {
    if (ranks_.count() == 1) return on_.reduce_part(part, kernel, fold, then);
    ranks_.guard([&] {
      detail::require_replicated(*steps_, then);
      part.check();
      const std::vector<HaloSteps::Kernel> kernels = detail::kernels_of(kernel);
      const HaloSteps::Objects objects = steps_->begin_part(kernels, part);
      if (objects.set == nullptr) {
        on_.reduce_part(part, kernel, fold, then);
      } else {
        values_->begin<Fold, Kernel>(*objects.set);
        const auto of_part = [&](index_t object) { return std::clamp(object, part.first, part.first + part.count); };
        const index_t first = of_part(objects.begin), last = of_part(objects.end);
        if (first < last) values_->add<Fold>(first, last, part.first, kernel, stream());
        drop_ghosts(objects, {of_part(objects.also.begin), of_part(objects.also.end)}, part.first, kernel);
        if (part.is_last()) values_->join<Fold, Kernel>(*crossing_.transport, then, stream());
      }
      steps_->end_part(part);
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
      steps_->end();
    });
  }

  /// The same, of what all ranks have, by each of them: nothing crosses, and it need not be a step over a set.
  /// @throw Error when one of the kernel's views is of an array of which ranks have parts
  template <class Work, class Kernel>
  void perform_on_each(const Work& work, const Kernel& kernel) {
    if (ranks_.count() > 1) ranks_.guard([&] { detail::require_replicated(*steps_, kernel); });
    on_.perform(work);
  }

  /// @param done a function object of what all ranks have
  template <class Body, class Done>
  void repeat(Loop& loop, int most, const Body& body, const Done& done) {
    if (ranks_.count() == 1) return on_.repeat(loop.of_one, most, body, done);
    ranks_.guard([&] {
      detail::require_replicated(*steps_, done);
      for (int k = 0; k < most; ++k) {
        const cuda::RoundState before(arrays_);
        const auto fits = [&](const auto& recorded) { return recorded.state == before; };
        const auto fitting = std::ranges::find_if(loop.of_many, fits);
        if (fitting != loop.of_many.end()) return repeat_on_device(*fitting, most - k, body, done);
        const std::size_t needs = cuda::needs_of(arrays_);
        body();
        cuda::tell_whether_done<<<1, 1, 0, stream()>>>(done, reinterpret_cast<int*>(is_done_.data()));
        cuda::check(cudaGetLastError(), "asking whether a loop is done");
        wait();
        if (*reinterpret_cast<const int*>(is_done_.data()) != 0) return;
        // Behind a round in which needs were learnt the next one may ask for lists of ghosts that are not there yet.
        const bool is_alike = cuda::needs_of(arrays_) == needs && cuda::RoundState(arrays_) == before;
        if (is_alike && !loops_on_host_ && crossing_.transport->can_be_captured() &&
            loop.of_many.size() < most_recorded) {
          record(loop, before, body, done);
        }
      }
    });
  }

  void wait() { on_.wait(); }

  /// Of an array of one object, which all ranks have.
  template <class Array>
  [[nodiscard]] typename Array::Value value(const Array& array) {
    if (ranks_.count() > 1) ranks_.guard([&] { detail::require_replicated_value(*steps_, array); });
    return on_.value(array);
  }

  /// See kernels/object_numbers.h. @throw Error when the array is of entries of rows
  template <class Array>
  [[nodiscard]] ObjectNumbers numbers_of(const Array& array) {
    const index_t* const numbers = ranks_.count() == 1 ? nullptr : arrays_.global_numbers(array);
    if (numbers == nullptr) return {};
    Buffer& here = numbers_[numbers];
    const auto bytes = arrays_.objects_of(array).size() * index_t{sizeof(index_t)};
    if (here.bytes() < bytes) {
      here = Buffer(SpaceKind::cuda, bytes, "global numbers");
      copy_memory(here.data(), SpaceKind::cuda, reinterpret_cast<const std::byte*>(numbers), SpaceKind::host, bytes);
    }
    return {reinterpret_cast<const index_t*>(here.data())};
  }

  /// Kernels that the table lacks; see HaloSteps.
  [[nodiscard]] const std::set<std::string>& unknown_kernels() const {
    static const std::set<std::string> none;
    return steps_ ? steps_->unknown() : none;
  }
  /// What has crossed so far, and before this was made.
  [[nodiscard]] const Traffic& traffic() {
    if (!crossing_.transport) return arrays_.transport().traffic();
    if (!counted_.empty()) wait();
    for (cuda::CountedRounds& rounds : counted_) crossing_.transport->count(rounds.take());
    return crossing_.transport->traffic();
  }
  /// "NCCL 2.28.9", or "pinned memory and MPI, since ..."; of one rank "none".
  [[nodiscard]] const std::string& transport_name() const { return crossing_.name; }

 private:
  /// Records the rounds of a loop that leave what they find. @pre such a one has been run: it connected ranks and took
  /// all memory that it needs
  template <class Body, class Done>
  void record(Loop& loop, const cuda::RoundState& state, const Body& body, const Done& done) {
    Transport& transport = *crossing_.transport;
    cuda::RecordedLoop<typename On::Loop> recorded{state};
    const Traffic before = transport.traffic();
    bool is_captured = false;
    std::string why_not;
    try {
      on_.record(recorded.loop, [&] { is_captured = (body(), true); }, done);
    } catch (const Error& error) {
      if (!is_captured) throw;
      why_not = error.what();
    }
    const Traffic of_round = transport.traffic() - before;
    transport.count(Traffic{} - of_round);  // nothing has crossed yet
    why_not = cuda::reason_of_all(why_not, arrays_.transport());
    if (why_not.empty()) {
      recorded.counter = counted_.size();
      counted_.emplace_back(of_round);
      loop.of_many.push_back(std::move(recorded));
      return;
    }
    loops_on_host_ = true;
    if (ranks_.is_first()) {
      std::fprintf(stderr, "physgen: the host waits in every round of loops, which this NCCL has in no graph: %s\n",
                   why_not.c_str());
    }
  }
  template <class Body, class Done>
  void repeat_on_device(cuda::RecordedLoop<typename On::Loop>& recorded, int most, const Body& body, const Done& done) {
    on_.repeat(recorded.loop, most, body, done);
    on_.add_rounds(most, counted_[recorded.counter].number());
  }

  template <class Kernel>
  [[nodiscard]] HaloSteps::Objects begin(index_t n, const Kernel& kernel, HaloSteps::Way way) {
    return steps_->begin(detail::kernels_of(kernel), n, way);
  }
  template <class Call>
  void for_ranges(const HaloSteps::Objects& objects, const Call& call) {
    detail::for_ranges(*steps_, objects, *crossing_.transport, call);
  }
  /// Calls a kernel of a reduction for the ghosts of a range.
  template <class Kernel>
  void drop_ghosts(const HaloSteps::Objects& objects, const HaloSteps::Range& range, index_t shift,
                   const Kernel& kernel) {
    values_->drop(range.begin, std::min(range.end, objects.begin), shift, kernel, stream());
    values_->drop(std::max(range.begin, objects.end), range.end, shift, kernel, stream());
  }

  static constexpr std::size_t most_recorded = 8;  ///< of a loop: a program that swaps two arrays begins in two states

  const Ranks& ranks_;
  DistributedArrays& arrays_;
  On on_;
  bool loops_on_host_ = std::getenv("PHYSGEN_LOOPS_ON_HOST") != nullptr;
  Buffer is_done_{SpaceKind::pinned, sizeof(int), "whether a loop is done"};
  std::map<const index_t*, Buffer> numbers_;  ///< on the device, by those of the host
  cuda::DeviceTransport crossing_{nullptr, "none"};
  std::optional<HaloSteps> steps_;
  std::optional<detail::DeviceBlockValues> values_;
  std::vector<cuda::CountedRounds> counted_;
};

}  // namespace physgen
