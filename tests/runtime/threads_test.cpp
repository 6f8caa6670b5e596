// Launches on several threads: what they call, what they throw, and who may launch.
#include <gtest/gtest.h>
#include <physgen/launch/processors.h>
#include <physgen/parallel_reduce.h>
#include <physgen/threads.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace physgen::test {
namespace {

/// More threads than this machine has processors.
class Threads : public testing::Test {
 protected:
  void SetUp() override { set_threads(allowed_processors() + 3); }
  void TearDown() override { set_threads(0); }
};

/// Work that no compiler leaves out, of a microsecond or two: some dozen calls of it are worth several threads.
double work_of(index_t i) {
  double x = static_cast<double>(i % 7) + 1;
  for (int k = 0; k < 300; ++k) x = std::sqrt(x + 1);
  return x;
}

/// The calls that a launch made for each index.
std::vector<int> calls_of(index_t begin, index_t end, bool heavy) {
  std::vector<std::atomic<int>> counts(static_cast<std::size_t>(end));
  parallel_for(Host{}, begin, end, lanes<1>([&](index_t i) {
                 const bool done = !heavy || work_of(i) > 0;
                 counts[static_cast<std::size_t>(i)] += done ? 1 : 100;
               }));
  return {counts.begin(), counts.end()};
}

TEST_F(Threads, call_each_index_of_a_launch_once) {
  for (int repeat = 0; repeat < 20; ++repeat) {
    for (const index_t end : {1, 2, 63, 1000, 4099}) {
      const index_t begin = end / 3;
      std::vector<int> wanted(static_cast<std::size_t>(end), 1);
      std::fill_n(wanted.begin(), begin, 0);
      EXPECT_EQ(calls_of(begin, end, repeat < 3), wanted);
    }
  }
  const std::vector<int> many = calls_of(0, 3000017, false);
  EXPECT_EQ(std::count(many.begin(), many.end(), 1), 3000017);
}

TEST_F(Threads, throw_the_first_exception_when_all_other_calls_are_made) {
  std::atomic<int> calls = 0;
  const auto launch = [&] {
    parallel_for(Host{}, 5000, lanes<1>([&](index_t i) {
                   ++calls;
                   if (work_of(i) > 0 && i % 1000 == 999) throw std::runtime_error("of " + std::to_string(i));
                 }));
  };
  for (int repeat = 1; repeat <= 5; ++repeat) {
    EXPECT_THROW(launch(), std::runtime_error);
    EXPECT_EQ(calls, 5000 * repeat);
  }
}

TEST_F(Threads, may_launch_within_a_launch) {
  for (const index_t outer : {1, 50, 1, 2}) {  // of one call, too, which the thread that launches makes
    std::atomic<index_t> sum = 0;
    parallel_for(Host{}, outer, lanes<1>([&](index_t i) {
                   sum += static_cast<index_t>(work_of(i) > 0);
                   parallel_for(Host{}, 300, lanes<1>([&](index_t k) { sum += work_of(k) > 0 ? k : 0; }));
                 }));
    EXPECT_EQ(sum, outer + outer * (300 * 299 / 2));
  }
}

TEST_F(Threads, may_all_launch_at_once_and_change_the_number_meanwhile) {
  std::vector<std::thread> callers;
  std::atomic<int> wrong = 0;
  for (int t = 0; t < 4; ++t) {
    callers.emplace_back([t, &wrong] {
      for (int repeat = 0; repeat < 30; ++repeat) {
        set_threads(1 + (t + repeat) % 5);
        std::vector<index_t> squares(2000);
        parallel_for(Host{}, 2000,
                     lanes<1>([&](index_t i) { squares[static_cast<std::size_t>(i)] = work_of(i) > 0 ? i * i : 0; }));
        for (index_t i = 0; i < 2000; ++i) wrong += squares[static_cast<std::size_t>(i)] != i * i;
      }
    });
  }
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(wrong, 0);
}

TEST_F(Threads, several_of_them_take_part_in_a_long_launch) {
  std::set<std::thread::id> seen;
  std::mutex mutex;
  // A busy machine may let one thread do all of a launch, but not of all launches.
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (seen.size() < 2 && std::chrono::steady_clock::now() < give_up) {
    parallel_for(Host{}, 20000, lanes<1>([&](index_t i) {
                   if (work_of(i) < 0 || i % 100 != 0) return;
                   const std::lock_guard lock(mutex);
                   seen.insert(std::this_thread::get_id());
                 }));
  }
  EXPECT_GT(seen.size(), 1U);
}

TEST_F(Threads, a_launch_of_little_work_is_done_by_the_thread_that_launches) {
  std::set<std::thread::id> seen;  // no lock
  parallel_for(Host{}, 100, lanes<1>([&](index_t) { seen.insert(std::this_thread::get_id()); }));
  EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

TEST_F(Threads, round_as_the_thread_that_launches) {
  std::atomic<int> others = 0;
  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  for (int repeat = 0; repeat < 20; ++repeat) {
    parallel_for(Host{}, 2000,
                 lanes<1>([&](index_t i) { others += work_of(i) < 0 || std::fegetround() != FE_UPWARD; }));
  }
  ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
  parallel_for(Host{}, 2000,
               lanes<1>([&](index_t i) { others += work_of(i) < 0 || std::fegetround() != FE_TONEAREST; }));
  EXPECT_EQ(others, 0);
}

TEST_F(Threads, a_child_of_fork_launches_on_one_thread) {
  calls_of(0, 5000, true);
  const pid_t child = fork();
  if (child == 0) {
    const std::vector<int> calls = calls_of(0, 5000, true);
    const bool right = threads() == 1 && std::count(calls.begin(), calls.end(), 1) == 5000;
    _exit(right ? 42 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 42);
}

/// Launches when the process ends.
struct LaunchesAtTheEnd {
  ~LaunchesAtTheEnd() {
    const std::vector<int> calls = calls_of(0, 5000, true);
    if (std::count(calls.begin(), calls.end(), 1) == 5000) std::fputs("launched at the end", stderr);
  }
};
TEST_F(Threads, a_destructor_of_a_static_object_may_launch) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto end = [] {
    static const LaunchesAtTheEnd launches;
    calls_of(0, 5000, true);
    std::exit(0);
  };
  EXPECT_EXIT(end(), testing::ExitedWithCode(0), "launched at the end");
}

TEST_F(Threads, have_a_number_from_1_to_4096) {
  set_threads(1);
  EXPECT_EQ(threads(), 1);
  set_threads(4096);
  EXPECT_EQ(threads(), 4096);
  EXPECT_NE(remark_on_threads(), "") << "no machine has as many";
  EXPECT_THROW(set_threads(4097), Error);
  EXPECT_THROW(set_threads(-1), Error);
  EXPECT_EQ(threads(), 4096);
  set_threads(0);
  EXPECT_GE(threads(), 1);
}

}  // namespace
}  // namespace physgen::test
