// Linux calls: flock() for the lock, which the system gives back when its process ends.
#include <fcntl.h>
#include <physgen/error.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <truthcube/output/folder_lock.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

namespace physgen::truthcube {

namespace {

std::string this_process() {
  std::array<char, 256> machine{};
  if (::gethostname(machine.data(), machine.size() - 1) != 0) return "process " + std::to_string(::getpid());
  return "process " + std::to_string(::getpid()) + " on " + machine.data();
}

/// The text that the holder wrote; it may be about to write it.
std::string holder(int id) {
  std::array<char, 300> text{};
  const ssize_t length = ::pread(id, text.data(), text.size(), 0);
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : "a process that just began";
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : file_(folder / "run.lock") {
  while (!try_to_hold()) {
  }
  const std::string text = this_process();
  if (::ftruncate(id_, 0) != 0 || ::pwrite(id_, text.data(), text.size(), 0) < 0) {
    const int error = errno;
    ::unlink(file_.c_str());
    ::close(id_);
    throw Error(file_.string() + ": cannot write it: " + std::generic_category().message(error));
  }
}

FolderLock::~FolderLock() {
  ::unlink(file_.c_str());  // first, while nobody else can hold it
  ::close(id_);
}

bool FolderLock::try_to_hold() {
  id_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (id_ < 0) throw Error(file_.string() + ": cannot make it: " + std::generic_category().message(errno));
  if (::flock(id_, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR)) {
    const bool held = errno == EWOULDBLOCK;
    const std::string who = holder(id_);
    ::close(id_);
    if (!held) return false;
    throw Error(file_.parent_path().string() + ": another run writes there, " + who +
                " (run.lock): wait until it has ended, or choose another --out");
  }
  // Its last holder may have removed the file meanwhile; then no name leads to the file that is locked here.
  struct stat own{}, named{};
  if (::fstat(id_, &own) == 0 && ::stat(file_.c_str(), &named) == 0 && own.st_ino == named.st_ino &&
      own.st_dev == named.st_dev) {
    return true;
  }
  ::close(id_);
  return false;
}

}  // namespace physgen::truthcube
