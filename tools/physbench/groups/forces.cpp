// The product with the assembled stiffness on the CPU: by gathers over incidences, and by its symmetric half.
#include "groups/forces.h"

#include <fem/kernels/symmetric_product_host.h>

#include "measure/host_rows.h"
#include "measure/scene_errors.h"

namespace physgen::bench {

template class OnScene<SymmetricForceDifferential, float>;
template class OnScene<SymmetricForceDifferential, double>;

namespace {

void add_rows(std::vector<Row>& rows, const Sizes& sizes) {
  const auto usual = rows_of_kernel("add_force_differential", "host", sizes);
  rows.insert(rows.end(), usual.begin(), usual.end());
  const auto multiply = [](const auto& product, fem::EdgeSums& sums) {
    fem::multiply(Host{}, product, sums, fem::SumOrder::fixed);
  };
  add_symmetric_row<HostDevice, float>(rows, sizes.host, "symmetric_deterministic", multiply);
  add_symmetric_row<HostDevice, double>(rows, sizes.host, "symmetric_deterministic", multiply);
}

[[maybe_unused]] const bool group =
    add(Group{"forces", "the product with the assembled stiffness: by gathers, by its symmetric half, by cuSPARSE", 5});
[[maybe_unused]] const bool rows = add(Part{"forces", 0, "add_force_differential", "host", add_rows});

}  // namespace

}  // namespace physgen::bench
