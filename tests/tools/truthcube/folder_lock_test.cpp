// One run at a time writes into a folder, whatever became of the one before.
#include <sys/wait.h>
#include <truthcube/output/folder_lock.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <string>

#include "scratch.h"

namespace physgen::truthcube {
namespace {

using testing::expect_error;
using testing::put_text;
using testing::read_text;

class RunLock : public testing::Scratch {
 public:
  std::filesystem::path folder = in_folder("");
  std::filesystem::path file = in_folder("run.lock");

  /// A process that holds the folder until it is killed. @return its number
  [[nodiscard]] pid_t hold_elsewhere() const {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      const FolderLock lock(folder);
      [[maybe_unused]] const ssize_t told = ::write(ready[1], "x", 1);
      for (;;) ::pause();
    }
    char byte = 0;
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
    return child;
  }
  static void kill(pid_t process) {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
  }
};

TEST_F(RunLock, names_its_process_and_machine_and_is_gone_afterwards) {
  {
    const FolderLock lock(folder);
    EXPECT_NE(read_text(file).find("process " + std::to_string(::getpid()) + " on "), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(RunLock, refuses_a_second_run_and_names_the_first_and_what_to_do) {
  const pid_t other = hold_elsewhere();
  for (int k = 0; k < 2; ++k) {  // a refused run leaves the lock as it was
    expect_error([&] { const FolderLock lock(folder); }, folder.parent_path().string(),
                 "process " + std::to_string(other) + " on ", "wait until it has ended, or choose another --out");
  }
  kill(other);
}

TEST_F(RunLock, of_a_killed_process_holds_nothing_up) {
  const pid_t other = hold_elsewhere();
  kill(other);
  ASSERT_TRUE(std::filesystem::exists(file));
  {
    const FolderLock lock(folder);
    const std::string text = read_text(file);
    EXPECT_EQ(text.rfind("process " + std::to_string(::getpid()), 0), 0U) << text;
    EXPECT_EQ(text.find(std::to_string(other)), std::string::npos) << text;
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(RunLock, is_held_by_one_run_after_another) {
  std::optional<FolderLock> lock(std::in_place, folder);
  expect_error([&] { const FolderLock second(folder); }, "another run writes there");
  lock.reset();
  EXPECT_EQ(testing::error_of([&] { const FolderLock second(folder); }), "");
}

TEST_F(RunLock, that_cannot_be_made_is_said_with_the_reason) {
  expect_error([&] { const FolderLock lock(in_folder("absent")); }, "absent/run.lock: cannot make it", "No such file");
}

}  // namespace
}  // namespace physgen::truthcube
