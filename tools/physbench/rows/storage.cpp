// Rows of the CPU: dP from dF in every storage scheme.
#include <limits>

#include "../groups.h"
#include "../host_rows.h"
#include "../schemes.h"

namespace physgen::bench {

namespace {

template <class Scheme, class Layout>
void add_row(std::vector<Row>& rows, Dataset& data, const char* layout) {
  Row row = describe<DpFromDf, float>(layout, SpaceKind::host, data);
  row.storage = Scheme::name;
  row.bytes_per_object = Scheme::template bytes<float>();
  const double bytes = row.bytes_per_object * static_cast<double>(row.objects);
  row.make = [&data, bytes] {
    return std::make_unique<detail::HostCase<DpFromDf, float, Layout, 0, Scheme>>(data, bytes);
  };
  rows.push_back(std::move(row));
}

}  // namespace

void load_records(Dataset& data, elasticity::ElementRecordArray<float>& records) {
  const auto view = records.view();
  const auto svd = data.svds().view();
  const auto derivative = data.stress_derivatives().view();
  const auto differential = data.differentials().view();
  using Matrix = Eigen::Matrix3f;
#pragma omp parallel for
  for (index_t i = 0; i < view.size(); ++i) {
    const elasticity::StressDerivative<double> x = derivative.get(i);
    const auto rounded = [](double value) { return static_cast<float>(value); };
    const Matrix U = svd.get(i).U.cast<float>(), V = svd.get(i).V.cast<float>();
    const Matrix dF = differential.get(i).dF.cast<float>();
    view.put(i, {U, V, rounded(x.x1111), rounded(x.x2211), rounded(x.x3311), rounded(x.x2222), rounded(x.x3322),
                 rounded(x.x3333), rounded(x.x2121), rounded(x.x2112), rounded(x.x3131), rounded(x.x3113),
                 rounded(x.x3232), rounded(x.x3223), dF, Matrix::Constant(std::numeric_limits<float>::quiet_NaN())});
  }
}

void add_host_storage_rows(std::vector<Row>& rows, Dataset& data) {
  detail::HostRows<DpFromDf, float>{rows, data}
      .add<detail::HostCopyCase<DpFromDf, float>>("copy")
      .aos()
      .layout<Aosoa<16>>("aosoa16");
  detail::HostRows<DpFromDf, double>{rows, data}.layout<Aosoa<16>>("aosoa16");
  AllSchemes::for_each([&]<class Scheme>() { add_row<Scheme, Aosoa<16>>(rows, data, "aosoa16"); });
}

}  // namespace physgen::bench
