// Copies between layouts on the CPU.
#include "groups/conversions.h"

#include "measure/host.h"

namespace physgen::bench {

namespace {

template <class Type>
void add_type(std::vector<Row>& rows, index_t objects) {
  add_copy<HostDevice, Type, Aos, Soa>(rows, objects);
  add_copy<HostDevice, Type, Aos, Aosoa<16>>(rows, objects);
  add_copy<HostDevice, Type, Soa, Aos>(rows, objects);
  add_copy<HostDevice, Type, Soa, Aosoa<16>>(rows, objects);
  add_copy<HostDevice, Type, Aosoa<16>, Aos>(rows, objects);
  add_copy<HostDevice, Type, Aosoa<16>, Soa>(rows, objects);
}

[[maybe_unused]] const bool group =
    add(Group{"conversions", "copies between layouts and formats, and between host and device", 3});
[[maybe_unused]] const bool rows =
    add(Part{"conversions", 0, "", "host", [](std::vector<Row>& rows, const Sizes& sizes) {
               add_type<Bytes36>(rows, sizes.host);
               add_type<Bytes48>(rows, sizes.host);
             }});

}  // namespace

}  // namespace physgen::bench
