// Copies of arrays on a device for the host.
#include <physgen/distributed/host_image.h>
#include <physgen/memory/buffer.h>

#include "../backend/memory.h"

namespace physgen::detail {

HostImage::HostImage(const UntypedArray& of) : of_(of), image_(of) {
  if (host_accessible(of.space) || of.bytes() == 0) return;
  bytes_.resize(static_cast<std::size_t>(of.bytes()));
  copy_memory(bytes_.data(), SpaceKind::host, of.base, of.space, of.bytes());
  image_.base = bytes_.data();
  image_.space = SpaceKind::host;
}

void HostImage::store() const {
  if (!bytes_.empty()) copy_memory(of_.base, of_.space, image_.base, SpaceKind::host, of_.bytes());
}

void wait_for_device(SpaceKind space) {
  if (space == SpaceKind::cuda) backend::synchronize_device();
}

}  // namespace physgen::detail
