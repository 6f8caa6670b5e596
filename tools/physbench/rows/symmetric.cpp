// Rows of the CPU: the product with the assembled stiffness, by gathers over incidences and by its symmetric half.
#include "../symmetric.h"

#include <fem/symmetric_product_host.h>

#include "../groups.h"
#include "../host_rows.h"

namespace physgen::bench {

namespace {

template <class Real>
class HostSymmetricCase final : public TimedHostCase {
 public:
  HostSymmetricCase(Dataset& data, double bytes) : TimedHostCase(bytes), data_(data), operands_(data) {}
  double run() override {
    const Stopwatch watch;
    fem::multiply(Host{}, operands_.product(), operands_.sums, fem::SumOrder::fixed);
    return watch.seconds();
  }
  Accuracy check() override {
    poison(operands_.differentials.storage());
    run();
    Result<AddForceDifferential, Real> result(operands_.differentials.size());
    physgen::copy(result, operands_.differentials);
    return HostKernel<AddForceDifferential>::check(data_, result.storage());
  }

 private:
  Dataset& data_;
  SymmetricOperands<Real, Host> operands_;
};

}  // namespace

void add_host_force_rows(std::vector<Row>& rows, Dataset& data) {
  HostKernel<AddForceDifferential>::add_rows(rows, data);
  const auto add = [&]<class Real>(Real /*storage*/) {
    Row row = symmetric_row<Real>("symmetric_deterministic", SpaceKind::host, data);
    const double bytes = row.bytes_per_object * static_cast<double>(row.objects);
    row.make = [&data, bytes] { return std::make_unique<HostSymmetricCase<Real>>(data, bytes); };
    rows.push_back(std::move(row));
  };
  add(float());
  add(double());
}

}  // namespace physgen::bench
