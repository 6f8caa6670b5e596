// A reduction on a device that is not handed its memory: what compilers say must tell the cure.
#include <elasticity.physgen.h>
#include <physgen/cuda/parallel_reduce.h>

struct Mass {
  elasticity::NodeForceArray<float, physgen::Cuda>::ConstView nodes;
  __device__ float operator()(physgen::index_t i) const { return nodes[i].f().get().squaredNorm(); }
};

double total(const Mass& kernel) { return physgen::sum(physgen::Cuda{}, kernel.nodes.size(), kernel); }
