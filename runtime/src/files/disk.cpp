// Linux calls: fallocate() for room, fsync() and rename() for replacement.
#include "disk.h"

#include <fcntl.h>
#include <physgen/error.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace physgen::disk {

namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags, const char* asked) : id_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (id_ < 0) throw Error(file.string() + ": cannot " + asked + ": " + reason(errno));
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (id_ >= 0) ::close(id_);
  }
  [[nodiscard]] int id() const { return id_; }
  /// Whether the system reports that all was written.
  [[nodiscard]] bool close() { return ::close(std::exchange(id_, -1)) == 0; }

 private:
  int id_;
};

// Writes the text; gives the error, or 0.
int write_all(const Descriptor& descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor.id(), text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

}  // namespace

void reserve_space(const fs::path& file, std::uint64_t bytes) {
  const Descriptor descriptor(file, O_WRONLY, "open it for writing");
  struct stat status{};
  if (::fstat(descriptor.id(), &status) != 0) throw Error(file.string() + ": cannot tell its size: " + reason(errno));
  if (bytes == 0) return;
  rlimit own{};
  if (::getrlimit(RLIMIT_FSIZE, &own) == 0 && own.rlim_cur != RLIM_INFINITY &&
      static_cast<std::uint64_t>(status.st_size) + bytes > own.rlim_cur) {
    throw Error(file.string() + ": needs " + std::to_string(bytes) +
                " bytes more, and this process may write files of " + std::to_string(own.rlim_cur) +
                " bytes at most (ulimit -f)");
  }
  int error = 0;
  do {
    error =
        ::fallocate(descriptor.id(), FALLOC_FL_KEEP_SIZE, status.st_size, static_cast<off_t>(bytes)) == 0 ? 0 : errno;
  } while (error == EINTR);
  if (error == 0) return;
  // A part may have been allocated, which this frees. When it cannot, the error below is the news.
  [[maybe_unused]] const int ignored = ::ftruncate(descriptor.id(), status.st_size);
  std::error_code no_space_known;
  const std::uintmax_t free = fs::space(folder_of(file), no_space_known).available;
  const bool unsupported = error == EOPNOTSUPP || error == ENOSYS;
  if (unsupported && (no_space_known || free >= bytes)) return;
  throw Error(file.string() + ": needs " + std::to_string(bytes) + " bytes more, " +
              (no_space_known ? "an unknown number" : std::to_string(free)) +
              " are free there: " + reason(unsupported ? ENOSPC : error));
}

fs::path new_name(const fs::path& file) {
  static std::atomic<std::uint64_t> count = 0;
  return file.string() + "." + std::to_string(::getpid()) + "-" + std::to_string(++count) + ".new";
}

void replace_file(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  replace_file(file, file.string() + ".new", write);
}

void replace_file(const fs::path& file, const fs::path& written, const std::function<void(const fs::path&)>& write) {
  try {
    write(written);
    const Descriptor descriptor(written, O_RDONLY, "open it");
    if (::fsync(descriptor.id()) != 0) throw Error(written.string() + ": cannot be written to disk: " + reason(errno));
    if (::rename(written.c_str(), file.c_str()) != 0) {
      throw Error(file.string() + ": cannot take the place of its old version: " + reason(errno));
    }
  } catch (...) {
    ::unlink(written.c_str());
    throw;
  }
  const Descriptor folder(folder_of(file), O_RDONLY | O_DIRECTORY, "open its folder");
  [[maybe_unused]] const int ignored = ::fsync(folder.id());  // some file systems cannot; the new version is in place
}

void write_text(const fs::path& file, std::string_view text) {
  replace_file(file, [text](const fs::path& written) {
    Descriptor descriptor(written, O_WRONLY | O_CREAT | O_TRUNC, "create it");
    int error = write_all(descriptor, text);
    if (!descriptor.close() && error == 0) error = errno;
    if (error != 0) {
      throw Error(written.string() + ": cannot write " + std::to_string(text.size()) + " bytes: " + reason(error));
    }
  });
}

void append_text(const fs::path& file, std::string_view text) {
  Descriptor descriptor(file, O_WRONLY | O_APPEND, "open it for writing");
  const off_t old_size = ::lseek(descriptor.id(), 0, SEEK_END);
  const int error = old_size < 0 ? errno : write_all(descriptor, text);
  if (error != 0) {
    [[maybe_unused]] const int ignored = ::ftruncate(descriptor.id(), old_size);  // the error below is the news
    throw Error(file.string() + ": cannot append " + std::to_string(text.size()) + " bytes: " + reason(error));
  }
  if (!descriptor.close()) throw Error(file.string() + ": cannot be closed: " + reason(errno));
}

}  // namespace physgen::disk
