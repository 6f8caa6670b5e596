// Fused groups of kernels on the CPU, in packs and one object at a time: see fused_checks.h.
#include <physgen/parallel_for.h>

#include "fused_checks.h"

namespace physgen::fem {
namespace {

template <int kLanes>
struct OnHost {
  template <class Kernel>
  static void over(index_t begin, index_t end, const Kernel& kernel) {
    parallel_for(Host{}, begin, end, lanes<kLanes>(kernel));
  }
  template <class Kernel>
  static void one_by_one(index_t size, const Kernel& kernel) {
    parallel_for(Host{}, size, lanes<1>(kernel));
  }
};

TEST(FusedKernels, have_the_bits_of_separate_ones_in_packs_of_floats) {
  check_materials<FusedCase<float, Host, Aosoa<16>, OnHost<0>>>();
}
TEST(FusedKernels, have_the_bits_of_separate_ones_in_packs_of_doubles) {
  check_materials<FusedCase<double, Host, Soa, OnHost<0>>>();
}
TEST(FusedKernels, have_the_bits_of_separate_ones_for_single_objects) {
  check_materials<FusedCase<float, Host, Aosoa<16>, OnHost<1>>>();
  check_materials<FusedCase<double, Host, Soa, OnHost<1>>>();
}
TEST(FusedKernels, sum_at_nodes_what_gathers_sum) {
  check_sums<FusedCase<float, Host, Aosoa<16>, OnHost<0>>>();
  check_sums<FusedCase<double, Host, Soa, OnHost<1>>>();
}

}  // namespace
}  // namespace physgen::fem
