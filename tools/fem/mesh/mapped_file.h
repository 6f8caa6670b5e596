// A file as bytes in memory, without a copy: for readers of files of any size.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace physgen::fem {

/// @pre nobody shortens the file meanwhile
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    struct ::stat status{};
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode)) {
      size_ = static_cast<std::size_t>(status.st_size);
      if (size_ > 0) memory_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
      is_open_ = memory_ != MAP_FAILED;
    }
    ::close(file);
  }
  ~MappedFile() {
    if (is_open_ && size_ > 0) ::munmap(memory_, size_);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// Whether it is a file, no folder or pipe, and can be read.
  [[nodiscard]] bool is_open() const { return is_open_; }
  /// @pre is_open()
  [[nodiscard]] std::string_view bytes() const { return {static_cast<const char*>(memory_), size_}; }

 private:
  void* memory_ = nullptr;
  std::size_t size_ = 0;
  bool is_open_ = false;
};

}  // namespace physgen::fem
