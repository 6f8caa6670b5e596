// The context of a GPU takes some 0.3 s to make: it is made on a thread while the host reads meshes and makes lists.
#pragma once

#include <cstdint>
#include <future>

namespace physgen::truthcube {

/// Begins when it is made; waits at its end.
class DeviceStart {
 public:
  /// @param wanted otherwise nothing is begun
  explicit DeviceStart(bool wanted);

  /// Waits for the context. @return bytes that were free in the GPU then
  /// @throw Error as cuda_memory() does. @pre wanted
  [[nodiscard]] std::int64_t free_bytes() const { return free_.get(); }

 private:
  std::shared_future<std::int64_t> free_;
};

}  // namespace physgen::truthcube
