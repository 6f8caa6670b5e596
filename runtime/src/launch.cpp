// See detail/launch.h. Threads are those of oneTBB: they look for work for some microseconds, then sleep until a launch
// wakes them, and take parts as they come, which are split while others have nothing to do, so that a thread whose
// processor is busy with other programs holds nobody up.
#include <physgen/detail/launch.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>

#include "thread_pool.h"

namespace physgen::detail {

namespace {

// Less work does not pay for waking a thread, which takes some 5 us, and up to 50 us where its processor sleeps.
constexpr float worth_threads = 20e3F;  // [ns]
// A part is long beside taking it (some 0.1 us), and short beside a launch that is worth threads.
constexpr float part_takes = 10e3F;  // [ns]
// A time below this has much of the clock and of the call in it.
constexpr float measurable = 1e3F;  // [ns]
// A part that other programs interrupt seems to take a thousand times as long.
constexpr float most_rise = 4;
// Launches that did nothing must not hide for long that the next ones do something.
constexpr float least_cost = 0.5F;  // [ns]

thread_local bool in_a_part = false;

class InAPart {
 public:
  InAPart() : before_(in_a_part) { in_a_part = true; }
  ~InAPart() { in_a_part = before_; }
  InAPart(const InAPart&) = delete;
  InAPart& operator=(const InAPart&) = delete;

 private:
  bool before_;
};

/// Runs a part, and moves the cost towards what it took.
void run_part(LoopCost& cost, const Body& body, index_t begin, index_t end) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  body.call(body.what, begin, end);
  const float took = std::chrono::duration<float, std::nano>(Clock::now() - start).count();
  const float before = cost.ns.load(std::memory_order_relaxed), now = took / static_cast<float>(end - begin);
  if (now > before && took < measurable) return;
  cost.ns.store(std::max(least_cost, (before + std::min(now, most_rise * before)) / 2), std::memory_order_relaxed);
}

}  // namespace

void run_parts(index_t count, LoopCost& cost, const Body& body) {
  if (count <= 0) return;
  if (in_a_part) return body.call(body.what, 0, count);
  const float each = cost.ns.load(std::memory_order_relaxed);
  tbb::task_arena* arena = each * static_cast<float>(count) < worth_threads ? nullptr : arena_of_launches();
  // This is no part beside others: a launch within it may have all threads.
  if (arena == nullptr) return run_part(cost, body, 0, count);

  const auto grain = static_cast<std::size_t>(std::clamp(part_takes / each, 1.0F, static_cast<float>(count)));
  // Rounding and the like are those of the thread that launches, as it is here: results do not depend on who computes
  // them, and execute() has those of the thread that made the arena.
  tbb::task_group_context context(tbb::task_group_context::isolated,
                                  tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  arena->execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<index_t>(0, count, grain),
        [&](const tbb::blocked_range<index_t>& part) {
          const InAPart guard;
          run_part(cost, body, part.begin(), part.end());
        },
        tbb::auto_partitioner(), context);
  });
}

}  // namespace physgen::detail
