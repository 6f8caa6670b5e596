// Definitions of the C library's functions in the program come before its own, for HDF5 as well.
#include "writes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <cerrno>

namespace physgen::truthcube::testing {
namespace {

At what = At::Nothing;
int allowed = 0;
int calls = 0;
bool fallocate_fails = false;

// Whether a call that writes up to byte `end` of a file is to fail.
bool fails(int file, off_t end) {
  const bool stopped = calls++ >= allowed;
  if (!stopped || what == At::Nothing) return false;
  if (what == At::Kill) ::kill(::getpid(), SIGKILL);
  if (what == At::FailureToGrow) {
    struct stat status{};
    if (::fstat(file, &status) != 0 || end <= status.st_size) return false;
  }
  errno = ENOSPC;
  return true;
}

// Counts a call that needs no room on the disk.
void count() {
  if (calls++ >= allowed && what == At::Kill) ::kill(::getpid(), SIGKILL);
}

}  // namespace

void stop_writes(At at, int number) {
  what = at;
  allowed = number;
  calls = 0;
}

void set_disk_full(bool full) { fallocate_fails = full; }

void resume_writes() { what = At::Nothing; }

}  // namespace physgen::truthcube::testing

using physgen::truthcube::testing::count;
using physgen::truthcube::testing::fails;
using physgen::truthcube::testing::fallocate_fails;

extern "C" {

ssize_t write(int file, const void* bytes, size_t size) {
  if (file > 2 && fails(file, ::lseek(file, 0, SEEK_CUR) + static_cast<off_t>(size))) return -1;
  return ::syscall(SYS_write, file, bytes, size);
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset) {
  if (fails(file, offset + static_cast<off_t>(size))) return -1;
  return ::syscall(SYS_pwrite64, file, bytes, size, offset);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t offset) { return pwrite(file, bytes, size, offset); }

int ftruncate(int file, off_t length) noexcept {
  count();
  return static_cast<int>(::syscall(SYS_ftruncate, file, length));
}

int rename(const char* from, const char* to) noexcept {
  count();
  return static_cast<int>(::syscall(SYS_rename, from, to));
}

// A killed process cannot take back bytes that the system has: only power could, and waiting for the disk takes long.
int fsync(int /*file*/) { return 0; }

int fallocate(int file, int mode, off_t offset, off_t length) {
  if (fallocate_fails) {
    errno = ENOSPC;
    return -1;
  }
  return static_cast<int>(::syscall(SYS_fallocate, file, mode, offset, length));
}

}  // extern "C"
