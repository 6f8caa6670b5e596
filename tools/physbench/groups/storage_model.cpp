// The model of coalescing for the storage schemes, and for records of whole elements.
#include "coalescing/kernel_model.h"
#include "groups/schemes.h"

namespace physgen::bench {

namespace {

[[maybe_unused]] const bool schemes = [] {
  AllSchemes::for_each([]<class Scheme>() { add_layout_model<DpFromDf, Aosoa<32>, Scheme>("aosoa32", Scheme::name); });
  add_layout_model<DpFromDf, Aosoa<64>, scheme::AllHalf>("aosoa64", scheme::AllHalf::name);
  return add_model("dp_from_df/float/record", [] {
    Array<elasticity::ElementRecordObject, float, Host, Traced<Aos>> records(4096);
    const auto view = records.view();
    return counters_of(count_sectors(fem::ComputeStressDifferential{view, view, view, view}, records.size()));
  });
}();

}  // namespace

}  // namespace physgen::bench
