// See thread_pool.h. An arena for each number of threads that was ever asked for stays, because a launch may be in it.
#include "thread_pool.h"

#include <physgen/error.h>
#include <physgen/threads.h>
#include <pthread.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "thread_environment.h"

namespace physgen {

namespace {

std::atomic<int> asked{0};  // by set_threads()
std::atomic<bool> forked{false};

struct Pool {
  std::mutex mutex;
  std::map<int, std::unique_ptr<tbb::task_arena>> arenas;
  std::unique_ptr<tbb::global_control> limit;  // above oneTBB's own, the number of processors
  int most = tbb::info::default_concurrency();

  Pool() {
    // A child of fork() has none of the threads, and locks that they held at that moment stay locked.
    pthread_atfork(nullptr, nullptr, [] { forked = true; });
  }

  tbb::task_arena* arena_of(int count) {
    const std::lock_guard lock(mutex);
    std::unique_ptr<tbb::task_arena>& arena = arenas[count];
    if (!arena) arena = std::make_unique<tbb::task_arena>(count);
    if (count > most) {
      limit.reset();  // of several limits the smallest holds
      limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(count));
      most = count;
    }
    return arena.get();
  }
};

struct NumberedArena {
  int count;
  tbb::task_arena* arena;
};

}  // namespace

int threads() {
  if (forked) return 1;
  const int count = asked;
  return count > 0 ? count : detail::thread_environment().count;
}

void set_threads(int count) {
  if (count < 0 || count > detail::most_threads) {
    throw Error("set_threads(" + std::to_string(count) + "): give a number of threads from 1 to " +
                std::to_string(detail::most_threads) + ", or 0 to follow the environment and the processors");
  }
  asked = count;
}

std::string remark_on_threads() { return detail::remark_on(detail::thread_environment(), asked, threads()); }

namespace detail {

tbb::task_arena* arena_of_launches() {
  const int count = threads();
  if (count == 1) return nullptr;
  static Pool* const pool = new Pool;  // never destroyed: destructors of other objects may launch
  thread_local NumberedArena last{0, nullptr};
  if (last.count != count) last = {count, pool->arena_of(count)};
  return last.arena;
}

}  // namespace detail

}  // namespace physgen
