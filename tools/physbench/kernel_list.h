// The list of all kernels, in the order in which they run and are printed: the paper's three first.
#pragma once

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
