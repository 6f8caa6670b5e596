// The list of all kernels, in the order in which they run and are printed: the paper's three first.
#pragma once

#include <physgen/storage.h>

#include <vector>

#include "row.h"

namespace physgen::bench {

struct DpFromDf;
struct StressDerivative;
struct AddForceDifferential;
struct DeformationGradient;
struct Svd;
struct Stress;
struct ElasticForce;
struct GatherForces;
struct TetStiffness;
struct NodeStiffness;
struct EdgeStiffness;
struct ElementForceDifferential;

/// Rows of one kernel on the CPU. Defined in host_rows.h, instantiated once in rows/*.cpp.
template <class Kernel>
struct HostKernel {
  static void add_rows(std::vector<Row>& rows, Dataset& data);
  /// Compares an output with the reference, for rows of all spaces.
  /// @param result in the form of operands.h's Result, float or double
  /// @throw Error when an element is not a number, as after poison() when it was not written
  static Accuracy check(Dataset& data, const Storage& result);
};

/// Rows of one kernel on the GPU. Defined in cuda_rows.h, instantiated once in rows/*.cu.
template <class Kernel>
struct CudaKernel {
  static void add_rows(std::vector<Row>& rows, Dataset& data);
};

template <class... Kernel>
struct KernelList {
  /// Calls visit.template operator()<Kernel>() for each.
  template <class Visit>
  static void for_each(const Visit& visit) {
    (visit.template operator()<Kernel>(), ...);
  }
};
using AllKernels =
    KernelList<DpFromDf, StressDerivative, AddForceDifferential, DeformationGradient, Svd, Stress, ElasticForce,
               GatherForces, TetStiffness, NodeStiffness, EdgeStiffness, ElementForceDifferential>;

}  // namespace physgen::bench
