// The number of threads that the environment says, and what a program tells its user of it.
#include <gtest/gtest.h>
#include <thread_environment.h>

namespace physgen::detail {
namespace {

TEST(ThreadEnvironment, without_variables_there_is_a_thread_for_each_processor) {
  const ThreadEnvironment read = read_thread_environment(nullptr, nullptr, 6);
  EXPECT_EQ(read.count, 6);
  EXPECT_EQ(remark_on(read, 0, read.count), "");
  EXPECT_EQ(read_thread_environment("", "", 6).count, 6);
}

TEST(ThreadEnvironment, the_first_of_several_numbers_counts_and_spaces_do_not) {
  EXPECT_EQ(read_thread_environment("3", nullptr, 6).count, 3);
  EXPECT_EQ(read_thread_environment(" 4 , 2", nullptr, 6).count, 4);
  EXPECT_EQ(read_thread_environment("99999", nullptr, 6).count, 4096) << "what set_threads() takes at most";
}

TEST(ThreadEnvironment, a_limit_holds_and_a_number_beyond_it_is_remarked) {
  const ThreadEnvironment limited = read_thread_environment(nullptr, "2", 6);
  EXPECT_EQ(limited.count, 2);
  EXPECT_EQ(limited.remark, "");
  const ThreadEnvironment both = read_thread_environment("5", "2", 6);
  EXPECT_EQ(both.count, 2);
  EXPECT_EQ(both.remark, "OMP_NUM_THREADS=5 is more than OMP_THREAD_LIMIT=2, which wins");
  EXPECT_EQ(read_thread_environment("2", "5", 6).count, 2);
}

TEST(ThreadEnvironment, words_that_are_no_numbers_do_not_count_and_are_remarked) {
  for (const char* word : {"many", "0", "-3", "2x", "1e3", ",2", " "}) {
    const ThreadEnvironment read = read_thread_environment(word, nullptr, 6);
    EXPECT_EQ(read.count, 6) << word;
    EXPECT_EQ(read.remark, std::string("OMP_NUM_THREADS=") + word + " is not a number of threads and is ignored");
  }
  const ThreadEnvironment both = read_thread_environment("a", "b", 6);
  EXPECT_EQ(
      both.remark,
      "OMP_NUM_THREADS=a is not a number of threads and is ignored; OMP_THREAD_LIMIT=b is not a number of threads "
      "and is ignored");
}

TEST(ThreadEnvironment, a_programs_own_number_goes_before_and_more_threads_than_processors_are_remarked_once) {
  const ThreadEnvironment read = read_thread_environment("a", nullptr, 2);
  EXPECT_EQ(remark_on(read, 2, 2), "") << "the variable does not matter";
  const std::string wait =
      "3 threads share the 2 processors that this process may use (its affinity and its control groups say so): more "
      "threads are no faster";
  EXPECT_EQ(remark_on(read, 3, 3), wait);
  EXPECT_EQ(remark_on(read_thread_environment("3", nullptr, 2), 0, 3), wait);
}

}  // namespace
}  // namespace physgen::detail
