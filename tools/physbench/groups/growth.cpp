// dP from dF over ever more objects: launches and thread starts show at the small end.
#include <algorithm>
#include <iterator>

#include "measure/registry.h"

namespace physgen::bench {

namespace {

void add_sizes(std::vector<Row>& rows, const std::string& space, int largest) {
  for (int power = 10; power <= largest; ++power) {
    const index_t n = index_t{1} << power;
    auto some =
        rows_of_kernel("dp_from_df", space, {n, n, n, true},
                       {"float/copy", "float/aos_scalar", "float/aos", "float/soa", "float/aosoa16", "float/aosoa32"});
    std::ranges::move(some, std::back_inserter(rows));
  }
}

[[maybe_unused]] const bool group =
    add(Group{"growth", "dP from dF from 2^10 to 2^24 objects (to 2^22 on the CPU)", 6});
[[maybe_unused]] const bool host =
    add(Part{"growth", 0, "dp_from_df", "host",
             [](std::vector<Row>& rows, const Sizes& /*sizes*/) { add_sizes(rows, "host", 22); }});
[[maybe_unused]] const bool cuda =
    add(Part{"growth", 0, "dp_from_df", "cuda",
             [](std::vector<Row>& rows, const Sizes& /*sizes*/) { add_sizes(rows, "cuda", 24); }});

}  // namespace

}  // namespace physgen::bench
