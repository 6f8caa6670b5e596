// The words of kernels, in packs of all widths and for single objects.
#include <physgen/parallel_for.h>

#include "function_checks.h"

namespace physgen::test {
namespace {

template <int kLanes>
constexpr auto on_host =
    [](index_t begin, index_t end, const auto& kernel) { parallel_for(Host{}, begin, end, lanes<kLanes>(kernel)); };

TEST(Vocabulary, asks_lanes_of_the_range_only_in_packs) {
  check_lanes<float, Host, Soa>(on_host<0>);
  check_lanes<double, Host, Aosoa<16>>(on_host<0>);
  check_lanes<float, Host, Aos>(on_host<4>);
}
TEST(Vocabulary, asks_single_objects) {
  check_lanes<float, Host, Soa>(on_host<1>);
  check_lanes<double, Host, Aos>(on_host<1>);
}
TEST(Vocabulary, has_functions_of_packs) {
  check_functions<float, Host, Soa>(on_host<0>);
  check_functions<double, Host, Soa>(on_host<0>);
}
TEST(Vocabulary, has_functions_of_single_numbers) {
  check_functions<float, Host, Soa>(on_host<1>);
  check_functions<double, Host, Soa>(on_host<1>);
}

}  // namespace
}  // namespace physgen::test
