// Nodes gathered on the CPU.
#include "groups/gathers.h"

#include "measure/host_rows.h"
#include "measure/scene_errors.h"

namespace physgen::bench {

template class OnScene<GatherNodes, float>;

namespace {

[[maybe_unused]] const bool group = add(Group{
    "gathers", "nodes gathered under an ordered, a random and a renumbered mesh, in every layout of the nodes", 4});
[[maybe_unused]] const bool rows =
    add(Part{"gathers", 0, "gather_nodes", "host", [](std::vector<Row>& rows, const Sizes& sizes) {
               add_gather_rows<HostDevice, Aos>(rows, sizes.host, "aos");
               add_gather_rows<HostDevice, AosPadded>(rows, sizes.host, "aos_padded");
               add_gather_rows<HostDevice, Soa>(rows, sizes.host, "soa");
               add_gather_rows<HostDevice, Aosoa<16>>(rows, sizes.host, "aosoa16");
             }});

}  // namespace

}  // namespace physgen::bench
