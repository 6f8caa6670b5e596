// The model of coalescing for every kernel and storage scheme, over a small mesh: what it counts does not depend on
// size.
#include "../coalescing.h"

#include "../kernels.h"
#include "../schemes.h"
#include "../sector_model.h"

namespace physgen::bench {

namespace {

Dataset& small_mesh() {
  static Dataset data(20000);
  return data;
}

template <class Kernel, class Layout, class Scheme = SchemaFormats>
Sectors model() {
  Operands<Kernel, float, Host, Traced<Layout>, Scheme> operands(small_mesh());
  const auto kernel = operands.kernel();
  return count_sectors(kernel, operands.output().size());
}

template <class Kernel, class Scheme = SchemaFormats>
std::optional<Sectors> model_of(const std::string& layout) {
  if (layout == "aos") return model<Kernel, Aos, Scheme>();
  if (layout == "soa") return model<Kernel, Soa, Scheme>();
  if (layout == "aosoa32") return model<Kernel, Aosoa<32>, Scheme>();
  if (layout == "aosoa64") return model<Kernel, Aosoa<64>, Scheme>();
  return std::nullopt;
}

Sectors model_of_records() {
  Array<elasticity::ElementRecordObject, float, Host, Traced<Aos>> records(4096);
  const auto kernel = DpFromDfRecords::make(records.view());
  return count_sectors(kernel, records.size());
}

}  // namespace

std::optional<Sectors> model_sectors(const Row& row) {
  if (row.space != "cuda" || !row.set.empty()) return std::nullopt;
  std::optional<Sectors> found;
  if (row.storage == "float") {
    AllKernels::for_each([&]<class Kernel>() {
      if (row.kernel == Kernel::name) found = model_of<Kernel>(row.layout);
    });
    if (row.kernel == DpFromDf::name && row.layout == "record") found = model_of_records();
  } else if (row.kernel == DpFromDf::name) {
    AllSchemes::for_each([&]<class Scheme>() {
      if (row.storage == Scheme::name) found = model_of<DpFromDf, Scheme>(row.layout);
    });
  }
  return found;
}

}  // namespace physgen::bench
