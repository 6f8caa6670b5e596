// The case of rows that sum: the dot product of two fields of vectors, beside a pass that only reads as many bytes.
#pragma once

#include <elasticity.physgen.h>
#include <fem/numerics/scalar.h>
#include <physgen/error.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "measure/registry.h"

namespace physgen::bench {

template <class View>
struct DotProduct {
  using Scalar = typename View::Precision;
  View a, b;
  template <class I>
  PHYSGEN_FUNCTION lanes_t<Scalar, I> operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const fem::Vector3<S> x = a[i].f(), y = b[i].f();
    return fem::dot3<S>(x, y);
  }
};

/// Two fields that are sums of small fractions, whose dot product is known.
template <class Real, class Space, class Layout>
struct DotOperands {
  Array<elasticity::NodeForceObject, Real, Space, Layout> a, b;
  double exact = 0;

  explicit DotOperands(index_t n) : a(n), b(n) {
    Array<elasticity::NodeForceObject, Real, Host, Layout> x(n), y(n);
    for (index_t i = 0; i < n; ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto fraction = static_cast<Real>(i * 37 % 61 + k) / 64, other = static_cast<Real>(i * 53 % 59 - k) / 64;
        x.view()[i].f()[k] = fraction;
        y.view()[i].f()[k] = other;
        exact += static_cast<double>(fraction) * static_cast<double>(other);
      }
    }
    copy(a, x);
    copy(b, y);
    synchronize();
  }
  [[nodiscard]] auto kernel() const { return DotProduct<decltype(a.const_view())>{a.const_view(), b.const_view()}; }
  [[nodiscard]] index_t bytes() const { return a.untyped().bytes(); }  ///< of each
  /// @throw Error when `sum` is not the dot product
  [[nodiscard]] Accuracy check(double sum) const {
    Accuracy accuracy;
    const double error = std::abs(sum - exact) / exact;
    if (!(error <= 1e-6)) throw Error("a dot product is off by " + std::to_string(error));
    accuracy.errors = {error, error, error, error, 1, 0};
    return accuracy;
  }
};

/// The rows of one layout on one device.
/// @tparam Sum `Sum<Real, Layout>(n)` has add(), a dot product, read(), a pass that only reads as much, and operands
template <template <class, class> class Sum, class Real, class Layout>
void add_dot_rows(std::vector<Row>& rows, const char* layout, SpaceKind space, index_t largest) {
  for (const index_t n : {1 << 18, 1 << 20, 1 << 22, 1 << 24}) {
    if (n > largest) continue;
    const double bytes = 6.0 * sizeof(Real) * static_cast<double>(n);
    Row row;
    row.kernel = "dot_product";
    row.layout = layout;
    row.storage = storage_name<Real>();
    row.space = name(space);
    row.objects = n;
    row.host_bytes = 2 * bytes;
    row.device_bytes = space == SpaceKind::cuda ? bytes : 0;
    row.make = [n, bytes] {
      const auto sum = std::make_shared<Sum<Real, Layout>>(n);
      Case made;
      made.bytes = bytes;
      made.run = [sum] { return sum->add(); };
      made.copy = [sum] { return sum->read(); };
      made.check = [sum] {
        sum->add();
        return sum->operands.check(sum->value());
      };
      return made;
    };
    rows.push_back(std::move(row));
  }
}

/// All rows of one device.
template <template <class, class> class Sum>
void add_all_dot_rows(std::vector<Row>& rows, SpaceKind space, index_t largest) {
  add_dot_rows<Sum, float, Soa>(rows, "soa", space, largest);
  add_dot_rows<Sum, float, Aosoa<32>>(rows, "aosoa32", space, largest);
  add_dot_rows<Sum, double, Soa>(rows, "soa", space, largest);
  add_dot_rows<Sum, double, Aosoa<32>>(rows, "aosoa32", space, largest);
}

}  // namespace physgen::bench
