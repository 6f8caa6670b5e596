// A folder for the files of one test, texts of files, and a folder in which nothing can be written.
#pragma once

#include <gtest/gtest.h>
#include <physgen/error.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

namespace physgen::truthcube::testing {

/// The test's own folder, gone after it.
class Scratch : public ::testing::Test {
 public:
  Scratch() { std::filesystem::create_directory(folder_); }
  ~Scratch() override { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::filesystem::path in_folder(const std::string& name) const { return folder_ / name; }

 private:
  static std::string unique_name() {
    return std::string("truthcube_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
           std::to_string(::getpid());
  }
  // In memory where that can be: renaming files on a disk waits for it.
  static std::filesystem::path place() {
    const std::filesystem::path memory = "/dev/shm";
    return ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
  }
  std::filesystem::path folder_ = place() / unique_name();
};

/// Takes away, from this process, the right to write into a folder: root has it everywhere, so it becomes nobody.
class ReadOnly {
 public:
  explicit ReadOnly(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::permissions(folder_, std::filesystem::perms{0555});
    if (was_root_) become(nobody);
  }
  ~ReadOnly() {
    if (was_root_) become(0);
    std::filesystem::permissions(folder_, std::filesystem::perms{0755});
  }
  ReadOnly(const ReadOnly&) = delete;
  ReadOnly& operator=(const ReadOnly&) = delete;

 private:
  static constexpr uid_t nobody = 65534;
  static void become(uid_t user) { EXPECT_EQ(::seteuid(user), 0); }
  std::filesystem::path folder_;
  bool was_root_ = ::geteuid() == 0;
};

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void put_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// The message of an Error; "" when the function throws none.
template <class Run>
std::string error_of(const Run& run) {
  try {
    run();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Expects an Error that says all of these.
template <class Run, class... Parts>
void expect_error(const Run& run, const Parts&... parts) {
  const std::string text = error_of(run);
  EXPECT_NE(text, "") << "no Error";
  const auto expect_part = [&text](const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << '"' << part << "\" is not in: " << text;
  };
  (expect_part(parts), ...);
}

}  // namespace physgen::truthcube::testing
