// What the rows of conversions share: objects of 36 and of 48 bytes, and the check that a copy arrived.
#pragma once

#include <elasticity.physgen.h>
#include <physgen/error.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "row.h"

namespace physgen::bench {

/// Object types that are converted: 9 and 12 scalars.
struct Bytes36 {
  using Object = elasticity::DeformationGradientObject;
  static constexpr const char* suffix = "36";
};
struct Bytes48 {
  using Object = elasticity::StressDerivativeObject;
  static constexpr const char* suffix = "48";
};

template <class Layout>
std::string layout_name() {
  if constexpr (requires { Layout::tile; }) {
    return Layout::name + std::to_string(Layout::tile);
  } else {
    return Layout::name;
  }
}

/// Random objects.
template <class Array>
void fill_random(Array& array) {
  const auto view = array.view();
  constexpr int elements = Array::elements;
#pragma omp parallel
  {
    std::mt19937 random(1);
#pragma omp for schedule(static)
    for (index_t i = 0; i < view.size(); ++i) {
      random.seed(static_cast<unsigned>(i));
      for (int k = 0; k < elements; ++k) array.putdata(i, k, static_cast<double>(random()) * 0x1p-31 - 1);
    }
  }
}

/// The largest error of an element of each object; elements lie between -1 and 1. Both on the host.
template <class A, class B>
Accuracy compare_copies(const A& result, const B& expected) {
  std::vector<double> errors(static_cast<std::size_t>(result.size()));
#pragma omp parallel for schedule(static)
  for (index_t i = 0; i < result.size(); ++i) {
    double worst = 0;
    for (int k = 0; k < A::elements; ++k) {
      const double error = std::abs(result.getdata(i, k) - expected.getdata(i, k));
      if (!(error <= worst)) worst = error;
    }
    errors[static_cast<std::size_t>(i)] = worst;
  }
  fem::reference::ErrorDistribution distribution;
  distribution.reserve(errors.size());
  for (const double error : errors) distribution.add(error);
  Accuracy accuracy;
  accuracy.errors = distribution.summary();
  if (!(accuracy.errors.max <= 1e-2))
    throw Error("a copy did not arrive: an element is off by " + std::to_string(accuracy.errors.max));
  return accuracy;
}

/// The row of a conversion. @param bytes that are read and written per object
template <class Type>
Row conversion_row(const std::string& kernel, const std::string& layouts, const char* storage, SpaceKind space,
                   index_t objects, double bytes) {
  Row row;
  row.kernel = kernel + Type::suffix;
  row.layout = layouts;
  row.storage = storage;
  row.space = name(space);
  row.objects = objects;
  row.bytes_per_object = bytes;
  return row;
}

}  // namespace physgen::bench
