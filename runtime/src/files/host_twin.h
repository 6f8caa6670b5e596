// An array as the host reads it: itself, or a copy of what lies in memory of the device.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/device.h>
#include <physgen/memory/buffer.h>

namespace physgen::detail {

class HostTwin {
 public:
  explicit HostTwin(const UntypedArray& array) : array_(array) {
    wait_for_host_work(array.space);
    if (host_accessible(array.space)) return;
    memory_ = Buffer(SpaceKind::host, array.bytes(), std::string(array.object) + " on the host");
    copy_memory(memory_.data(), SpaceKind::host, array.base, array.space, array.bytes());
    array_.base = memory_.data();
    array_.space = SpaceKind::host;
  }
  [[nodiscard]] const UntypedArray& array() const { return array_; }
  [[nodiscard]] bool is_copy() const { return memory_.data() != nullptr; }
  /// Gives `original`, which this is the twin of, all that the twin holds.
  void copy_back(const UntypedArray& original) const {
    if (!host_accessible(original.space))
      copy_memory(original.base, original.space, memory_.data(), SpaceKind::host, original.bytes());
  }

 private:
  UntypedArray array_;
  Buffer memory_;
};

}  // namespace physgen::detail
