// The case of rows that sum: the dot product of two fields of vectors, beside a pass that only reads as many bytes.
#pragma once

#include <elasticity.physgen.h>
#include <fem/scalar.h>
#include <physgen/error.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "row.h"

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
  [[nodiscard]] index_t bytes() const { return a.storage().bytes(); }  ///< of each
  /// @throw Error when `sum` is not the dot product
  [[nodiscard]] Accuracy check(double sum) const {
    Accuracy accuracy;
    const double error = std::abs(sum - exact) / exact;
    if (!(error <= 1e-6)) throw Error("a dot product is off by " + std::to_string(error));
    accuracy.errors = {error, error, error, error, 1, 0, 0};
    return accuracy;
  }
};

inline constexpr std::array<index_t, 4> dot_sizes{1 << 18, 1 << 20, 1 << 22, 1 << 24};

/// @param make make(n) is the case of a row
template <class Real, class Make>
void add_dot_rows(std::vector<Row>& rows, const char* layout, SpaceKind space, index_t largest, const Make& make) {
  for (const index_t n : dot_sizes) {
    if (n > largest) continue;
    Row row;
    row.kernel = "dot_product";
    row.layout = layout;
    row.storage = sizeof(Real) == 4 ? "float" : "double";
    row.space = name(space);
    row.objects = n;
    row.bytes_per_object = 6 * sizeof(Real);
    row.make = [n, make]() -> std::unique_ptr<Case> { return make(n); };
    rows.push_back(std::move(row));
  }
}

}  // namespace physgen::bench
