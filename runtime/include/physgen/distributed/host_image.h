// The bytes of an array that may lie on a device, for the host.
#pragma once

#include <physgen/arrays/untyped_array.h>

#include <vector>

namespace physgen::detail {

/// The bytes of an array where the host reaches them: its own, or a copy of those on a device.
class HostImage {
 public:
  explicit HostImage(const UntypedArray& of);
  [[nodiscard]] const UntypedArray& array() const { return image_; }
  /// What was written comes back to the array.
  void store() const;

 private:
  UntypedArray of_, image_;
  std::vector<std::byte> bytes_;
};

/// Waits for all streams of the device where an array lies there.
void wait_for_device(SpaceKind space);

}  // namespace physgen::detail
