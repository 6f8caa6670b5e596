// Saving and loading on several threads where calls of the system move fewer bytes than asked for, are interrupted, or
// fail. The calls of this program come before those of the C library.
#include <elasticity.physgen.h>
#include <physgen/save.h>
#include <physgen/threads.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "saved_files.h"
#include "stored_records.h"

namespace physgen::test {
namespace {

enum class Calls : std::uint8_t { whole, short_and_interrupted, failing };
std::atomic<Calls> behaviour = Calls::whole;
std::atomic<int> made = 0, let_through = 0;

/// What a call for so many bytes of a block of objects does: moves so many, or fails where there are none.
std::size_t bytes_of_call(std::size_t size) {
  constexpr std::size_t of_a_block = 10000;  // HDF5's own calls move fewer
  if (size < of_a_block || behaviour == Calls::whole) return size;
  const int call = made++;
  if (behaviour == Calls::failing) {
    errno = EIO;
    return call < let_through ? size : 0;
  }
  errno = EINTR;
  return call % 3 == 0 ? 0 : size / 2 + 1;
}

}  // namespace
}  // namespace physgen::test

extern "C" {

ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  const size_t moved = physgen::test::bytes_of_call(size);
  return moved == 0 && size > 0 ? -1 : ::syscall(SYS_pwrite64, file, bytes, moved, at);
}
ssize_t pread(int file, void* bytes, size_t size, off_t at) {
  const size_t moved = physgen::test::bytes_of_call(size);
  return moved == 0 && size > 0 ? -1 : ::syscall(SYS_pread64, file, bytes, moved, at);
}
ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) { return pwrite(file, bytes, size, at); }
ssize_t pread64(int file, void* bytes, size_t size, off64_t at) { return pread(file, bytes, size, at); }

}  // extern "C"

namespace physgen::test {
namespace {

using Object = elasticity::StressDerivativeObject;
using Saved = Array<Object, float, Host, Soa>;
using Loading = Array<Object, float, Host, Aosoa<16>>;

constexpr index_t six_blocks = 60000;  // objects

class SavedByCalls : public ::testing::Test {
 protected:
  SavedByCalls() : saved_(six_blocks), expected_(six_blocks) {
    std::mt19937 random(seed());
    copy(saved_, random_objects<Object>(six_blocks, random));
    copy(expected_, saved_);
    set_threads(8);
  }
  ~SavedByCalls() override {
    behaviour = Calls::whole;
    set_threads(0);
  }
  /// The Error of what is done with calls that fail after so many.
  template <class Do>
  std::string failure(int after, const Do& what) {
    made = 0;
    let_through = after;
    behaviour = Calls::failing;
    std::string message = message_of(what);
    behaviour = Calls::whole;
    return message;
  }
  void expect_saved(const Loading& loaded) {
    expect_records(loaded.untyped(), records_of(expected_.untyped()), "load");
  }

  Folder folder_;
  std::filesystem::path file_ = folder_ / "a.h5";
  Saved saved_;
  Loading expected_;
};

TEST_F(SavedByCalls, comes_back_where_calls_are_short_and_interrupted) {
  behaviour = Calls::short_and_interrupted;
  save(file_, {{"a", saved_}});
  EXPECT_GT(made, 100);
  Loading loaded;
  load(file_, "a", loaded);
  expect_saved(loaded);
  poison(loaded);
  load(file_, "a", loaded);
  expect_saved(loaded);
}

TEST_F(SavedByCalls, stays_as_it_was_where_a_call_of_any_thread_fails) {
  save(file_, {{"a", saved_}});
  for (const int after : {0, 1, 37, 71}) {  // of 12 fields of six blocks
    const std::string message = failure(after, [&] { save(file_, {{"a", Saved(six_blocks)}}); });
    EXPECT_NE(message.find("cannot write /a/x"), std::string::npos) << message;
    EXPECT_EQ(folder_.names().size(), 1U);
    Loading loaded;
    load(file_, "a", loaded);
    expect_saved(loaded);
  }
}

TEST_F(SavedByCalls, leaves_the_array_as_it_was_or_says_that_it_does_not_where_a_call_fails) {
  save(file_, {{"a", saved_}});
  for (const index_t n : {six_blocks, index_t{10}}) {
    for (const int after : {0, 37, 71, 72, 143}) {
      Loading array(n);
      poison(array);
      const Records before = records_of(array.untyped());
      const std::string message = failure(after, [&] { load(file_, "a", array); });
      if (after >= 72 && n != six_blocks) {  // which are read once
        EXPECT_EQ(message, "nothing was thrown");
        continue;
      }
      EXPECT_NE(message.find("cannot read /a/x"), std::string::npos) << message;
      EXPECT_EQ(message.find("holds a part") != std::string::npos, after >= 72) << message;
      if (after < 72) expect_records(array.untyped(), before, "a load that fails");
    }
  }
}

}  // namespace
}  // namespace physgen::test
