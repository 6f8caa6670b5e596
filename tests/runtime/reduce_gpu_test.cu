// Reductions on a CUDA device: the checks of the host test, and what is a device's own: results that stay there, and
// graphs.
#include <physgen/cuda/parallel_reduce.h>

#include "gpu_fixture.h"
#include "reduce_checks.h"

namespace physgen::test {
namespace {

class CudaReduce : public GpuTest {};

TEST_F(CudaReduce, sums_have_the_bits_of_the_stated_order) {
  check_sums<Cuda, float, Soa>();
  check_sums<Cuda, double, Aosoa<32>>();
  check_a_sum_of_many_blocks<Cuda>();
}
TEST_F(CudaReduce, extrema_and_conditions_are_those_of_the_range) {
  check_extrema_and_conditions<Cuda, float, Aosoa<32>>();
}
TEST_F(CudaReduce, folds_several_terms_in_one_pass_of_a_kernel_that_stores) {
  check_several_terms_and_stores<Cuda, float, Soa>();
  check_several_terms_and_stores<Cuda, double, AosPadded>();
}
TEST_F(CudaReduce, gives_nan_where_a_term_is_one) {
  check_nan<Cuda, float>();
  check_nan<Cuda, double>();
}

/// Adds the value to one element, and 1 to another.
template <class View>
struct Record {
  View to;
  template <class Value>
  PHYSGEN_FUNCTION void operator()(Value value) const {
    to[0].f()[0] += static_cast<double>(value);
    to[0].f()[1] += 1;
  }
};
using Records = elasticity::NodeForceArray<double, Cuda, Aos>;

struct One {
  PHYSGEN_FUNCTION std::int32_t operator()(index_t /*i*/) const { return 1; }
};

struct OwnStream {
  cudaStream_t stream = nullptr;
  OwnStream() { cuda::check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream"); }
  ~OwnStream() { cudaStreamDestroy(stream); }
};

TEST_F(CudaReduce, hands_the_value_to_then_once_and_uses_its_workspace_again) {
  Records records(1);
  const Record<Records::View> record{records.view()};
  const index_t n = 300007;
  ReduceWorkspace workspace(n);
  for (int k = 0; k < 50; ++k) {
    parallel_reduce(Cuda{}, n, Scattered{}, Sum{}, record, workspace);
    parallel_reduce(Cuda{}, 0, Scattered{}, Sum{}, record, workspace);
    parallel_reduce(Cuda{}, 5, 5 + k, One{}, Sum{}, record, workspace);
  }
  synchronize();
  double wanted = 0;
  const double all = sum(Cuda{}, n, Scattered{}, workspace);
  for (int k = 0; k < 50; ++k) wanted = wanted + all + k;
  EXPECT_EQ(records.getdata(0, 0), wanted);
  EXPECT_EQ(records.getdata(0, 1), 150);
}

struct ScatteredFrom {
  index_t first;
  PHYSGEN_FUNCTION auto operator()(index_t i) const { return Scattered{}(first + i); }
};
TEST_F(CudaReduce, part_by_part_has_the_bits_of_one_reduction_and_calls_then_once) {
  Records records(1);
  const Record<Records::View> record{records.view()};
  const index_t n = 300007;
  ReduceWorkspace workspace(n);
  const double all = sum(Cuda{}, n, Scattered{}, workspace);
  for (const index_t most : {2048, 5 * 2048, 1 << 20}) {
    for (index_t first = 0; first < n; first += most) {
      const PartOfReduction part{first, std::min(most, n - first), n};
      parallel_reduce_part(Cuda{}, part, ScatteredFrom{first}, Sum{}, record, workspace);
    }
  }
  synchronize();
  EXPECT_EQ(records.getdata(0, 0), all + all + all);
  EXPECT_EQ(records.getdata(0, 1), 3);
  EXPECT_THROW(parallel_reduce_part(Cuda{}, {1, 2048, 4096}, ScatteredFrom{1}, Sum{}, record, workspace), Error);
}

TEST_F(CudaReduce, can_be_captured_in_a_graph_and_replayed) {
  const index_t n = 300007;
  ReduceWorkspace workspace(n);
  const double value = sum(Cuda{}, n, Scattered{}, workspace);
  Records records(1);
  synchronize();
  const OwnStream s;
  cuda::check(cudaStreamBeginCapture(s.stream, cudaStreamCaptureModeThreadLocal), "capturing");
  parallel_reduce(Cuda{}, n, Scattered{}, Sum{}, Record<Records::View>{records.view()}, workspace, s.stream);
  EXPECT_NE(message_of([&] { (void)sum(Cuda{}, n, Scattered{}, workspace, s.stream); }).find("captured"),
            std::string::npos);
  cudaGraph_t graph = nullptr;
  cuda::check(cudaStreamEndCapture(s.stream, &graph), "ending the capture");
  cudaGraphExec_t replay = nullptr;
  cuda::check(cudaGraphInstantiate(&replay, graph, 0), "making the graph");
  double wanted = 0;
  for (int k = 0; k < 10; ++k) {
    cuda::check(cudaGraphLaunch(replay, s.stream), "replaying");
    wanted += value;
  }
  synchronize(s.stream);
  EXPECT_EQ(records.getdata(0, 0), wanted);
  EXPECT_EQ(records.getdata(0, 1), 10);
  cudaGraphExecDestroy(replay);
  cudaGraphDestroy(graph);
}

TEST_F(CudaReduce, refuses_a_workspace_that_is_too_small) {
  ReduceWorkspace workspace(100000, 8);
  EXPECT_NO_THROW((void)sum(Cuda{}, 100000, Scattered{}, workspace));
  EXPECT_EQ(message_of([&] { (void)sum(Cuda{}, 1000000, Scattered{}, workspace); }),
            "physgen: a reduction of 1000000 objects to 8 bytes needs a workspace of 4176 bytes, and this one has 656; "
            "make it ReduceWorkspace(1000000, 8)");
  EXPECT_THROW((void)argmax(Cuda{}, 100000, Scattered{}, workspace), Error) << "16 bytes of result";
}

}  // namespace
}  // namespace physgen::test
