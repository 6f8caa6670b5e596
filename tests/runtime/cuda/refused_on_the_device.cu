// Programs for a device that nvcc must refuse, with words that say what to do. refused.py compares them with what it
// reports.
#include <elasticity.physgen.h>
#include <physgen/cuda/executor.h>
#include <physgen/cuda/parallel_for.h>
#include <physgen/cuda/parallel_reduce.h>

#include <array>

using namespace physgen;

using Forces = elasticity::NodeForceArray<float, Cuda>;
using PaddedForces = elasticity::NodeForceArray<float, Cuda, AosPadded>;
using ForcesInTiles = elasticity::NodeForceArray<float, Cuda, Aosoa<1024>>;

struct Mass {
  Forces::ConstView nodes;
  __device__ float operator()(index_t i) const { return nodes[i].f().get().squaredNorm(); }
};

struct Large {
  __device__ std::array<double, 32> operator()(index_t) const { return {}; }
};

/// refused a_reduction_without_a_workspace: a_reduction_on_a_device_needs_a_ReduceWorkspace_as_its_last_argument
double a_reduction_without_a_workspace(const Mass& kernel) { return sum(Cuda{}, kernel.nodes.size(), kernel); }
/// refused a_reduction_of_large_terms: the term of a reduction on a device has about 88 bytes at most
auto a_reduction_of_large_terms(ReduceWorkspace& workspace) { return sum(Cuda{}, 5, Large{}, workspace); }
/// refused storing_to_a_read_only_vector: this array is read-only here
__global__ void storing_to_a_read_only_vector(PaddedForces::ConstView nodes) {
  nodes[0].f() = Eigen::Vector3f(1, 2, 3);
}
/// refused reading_a_large_object: value() reads an object of 4096 bytes at most
auto reading_a_large_object(CudaExecutor& on, const ForcesInTiles& forces) { return on.value(forces); }

// ---- What is not refused ----
double accepted(const Mass& kernel, ReduceWorkspace& workspace) {
  return sum(Cuda{}, kernel.nodes.size(), kernel, workspace);
}
