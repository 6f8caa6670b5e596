// One run at a time writes into a folder.
#pragma once

#include <filesystem>

namespace physgen::truthcube {

/// Holds a folder for this process while it lives. The file run.lock in it says which process that is; what counts is
/// the system's lock on that file, which ends with its process: a file that was left behind by a kill holds nothing up.
/// On file systems that know no locks nothing is held.
class FolderLock {
 public:
  /// @throws Error when another run holds the folder, naming its process and machine, or when the file cannot be made
  explicit FolderLock(const std::filesystem::path& folder);
  /// Removes the file.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  /// Whether it got the lock. @throws Error as the constructor
  [[nodiscard]] bool try_to_hold();

  std::filesystem::path file_;
  int id_ = -1;
};

}  // namespace physgen::truthcube
