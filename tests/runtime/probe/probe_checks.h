// The common part of the tests of probes: arrays by their tags, and the finds as words.
#pragma once

#include <elasticity.physgen.h>
#include <gtest/gtest.h>
#include <physgen/kernel.h>
#include <physgen/probe.h>

#include <set>
#include <string>

namespace physgen::test {

using Fields = std::set<std::string>;

/// "x R", "y W", "z RW", "n RW&", of the array of this name.
inline Fields fields_of(const std::string& array) {
  Fields fields;
  for (const probe::FieldAccess& row : probe::registered()) {
    if (row.array != array) continue;
    fields.insert(row.field + (row.read ? " R" : " ") + (row.written ? "W" : "") + (row.address_taken ? "&" : ""));
  }
  return fields;
}

/// A tag for each array of each test: what is found is found of all code in this file.
#define PHYSGEN_TEST_ARRAY(Tag)               \
  struct Tag {                                \
    static constexpr const char* name = #Tag; \
  }

template <class Tag>
using Svds = ProbeOf<elasticity::DeformationSvdArray<float>, Tag>;
template <class Tag>
using Derivatives = ProbeOf<elasticity::StressDerivativeArray<float>, Tag>;
template <class Tag>
using Shapes = ProbeOf<elasticity::RestShapeArray<float>, Tag>;
template <class Tag>
using Tets = ProbeOf<elasticity::TetArray<float>, Tag>;
template <class Tag>
using Forces = ProbeOf<elasticity::NodeForceArray<float>, Tag>;

inline const Fields all_of_svd{"U R", "V R", "s R"};

/// Names a kernel of single objects alone.
struct Perform {
  template <class Kernel>
  void operator()(const Kernel& kernel) const {
    ProbeExecutor<Host>().perform([&](Stream /*stream*/) { kernel(index_t{0}); });
  }
};

}  // namespace physgen::test
