// Rows of the sets of inputs: one kernel of variants.h, on the CPU or on the GPU, with the errors of its results.
#pragma once

#include <string>
#include <vector>

#include "arrays.h"
#include "input_sets.h"

namespace physgen::bench {

/// The part of a row that its kernel, storage and set decide.
template <class Variant, class Real>
Row describe(const char* layout, SpaceKind space, InputSet set, index_t objects) {
  Row row;
  row.kernel = Variant::name;
  row.layout = layout;
  row.storage = sizeof(Real) == sizeof(float) ? "float" : "double";
  row.space = physgen::name(space);
  row.set = name(set);
  row.errors_in_eps = true;
  row.objects = objects;
  row.bytes_per_object = bytes_moved<Variant, Real>(1);
  return row;
}

/// A kernel on the CPU, and what rows of all spaces need of it. Defined in host_set_rows.h, instantiated once in
/// rows/accuracy_*.cpp.
template <class Variant, class Real>
struct HostVariant {
  using Inputs = HostArrays<typename Variant::Reads, Real>;
  using Outputs = HostArrays<typename Variant::Writes, Real>;

  static void add_rows(std::vector<Row>& rows, InputSets& sets);
  /// Inputs of all objects.
  static Inputs inputs(InputSets& sets, InputSet set);
  /// Errors of the outputs of the samples. What a kernel did not write is a failure, when it was poisoned.
  static Accuracy check(InputSets& sets, InputSet set, const Outputs& outputs);
  /// Runs the kernel on one input everywhere. @return what replay prints
  /// @throw Error when the words are not the numbers of an input
  static std::string replay(const std::vector<std::string>& words);
};

/// The same kernel on the GPU. Defined in cuda_set_rows.h, instantiated once in rows/accuracy_*.cu.
template <class Variant, class Real>
struct CudaVariant {
  static void add_rows(std::vector<Row>& rows, InputSets& sets);
  static typename HostVariant<Variant, Real>::Outputs run(const typename HostVariant<Variant, Real>::Inputs& inputs);
};

}  // namespace physgen::bench
