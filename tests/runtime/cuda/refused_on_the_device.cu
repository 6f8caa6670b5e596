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

/// refused a_double_beside_a_float_of_a_generic_kernel: so_write_S_of_it
template <class View>
struct ADoubleBesideAFloatOfAGenericKernel {
  using Scalar = typename View::Precision;
  View nodes;
  template <class I>
  __device__ void operator()(I i) const {
    const lanes_t<Scalar, I> x = nodes[i].f()[0];
    nodes[i].f()[1] = lanes_t<Scalar, I>(x * 0.1);
  }
};
void a_double_beside_a_float_of_a_generic_kernel(const Forces::View& nodes) {
  parallel_for(Cuda{}, nodes.size(), ADoubleBesideAFloatOfAGenericKernel<Forces::View>{nodes});
}
/// refused a_double_beside_a_term_of_a_reduction: so_write_S_of_it
template <class View>
struct ADoubleBesideATermOfAReduction {
  using Scalar = typename View::Precision;
  View nodes;
  template <class I>
  PHYSGEN_FUNCTION lanes_t<Scalar, I> operator()(I i) const {
    return nodes[i].f()[0] > 0.1 ? lanes_t<Scalar, I>(1) : nodes[i].f()[1];
  }
};
auto a_double_beside_a_term_of_a_reduction(const Forces::ConstView& nodes, ReduceWorkspace& workspace) {
  return sum(Cuda{}, nodes.size(), ADoubleBesideATermOfAReduction<Forces::ConstView>{nodes}, workspace);
}

// ---- What is not refused ----
template <class View>
struct Accepted {
  using Scalar = typename View::Precision;
  View nodes;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const S x = nodes[i].f()[0];
    nodes[i].f() = Eigen::Matrix<S, 3, 1>(x * S(0.1), math::max(x, 0.0), x * 2);
  }
};
void accepted_of_a_generic_kernel(const Forces::View& nodes) {
  parallel_for(Cuda{}, nodes.size(), Accepted<Forces::View>{nodes});
}
double accepted(const Mass& kernel, ReduceWorkspace& workspace) {
  return sum(Cuda{}, kernel.nodes.size(), kernel, workspace);
}
