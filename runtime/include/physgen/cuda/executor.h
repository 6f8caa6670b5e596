// Runs the steps of a program over arrays on a CUDA device; see executor.h. Included by CUDA translation units only.
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/cuda/check.h>
#include <physgen/cuda/parallel_for.h>
#include <physgen/cuda/parallel_reduce.h>

#include <cstdlib>
#include <utility>

namespace physgen {

namespace cuda {

template <class Done>
__global__ void tell_whether_done(Done done, int* is_done) {
  *is_done = done() ? 1 : 0;
}

template <class Count>
__global__ void begin_rounds(Count* rounds_left, Count most) {
  *rounds_left = most;
}

template <class Count>
__global__ void add_rounds(const Count* rounds_left, Count most, Count* sum) {
  *sum += most - *rounds_left;
}

template <class Done>
__global__ void decide_to_go_on(cudaGraphConditionalHandle go_on, Done done, int* rounds_left) {
  const int left = *rounds_left - 1;
  *rounds_left = left;
  cudaGraphSetConditional(go_on, !done() && left > 0 ? 1 : 0);
}

}  // namespace cuda

/// The current CUDA device, in a stream of its own. Nothing waits but wait() and value(). With PHYSGEN_LOOPS_ON_HOST in
/// the environment the host runs loops, and waits in every round: for tools that cannot follow graphs whose rounds the
/// device decides on, such as compute-sanitizer.
class CudaExecutor {
 public:
  using Space = Cuda;

  /// A loop, once it has been run: a graph whose rounds the device itself decides on. It is run again as it was
  /// recorded: with the same arrays, kernels and their parameters.
  class Loop {
   public:
    Loop() = default;
    Loop(Loop&& other) noexcept : graph_(std::exchange(other.graph_, nullptr)) {}
    Loop& operator=(Loop&& other) noexcept {
      std::swap(graph_, other.graph_);
      return *this;
    }
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
    ~Loop() {
      if (graph_ != nullptr) cudaGraphExecDestroy(graph_);
    }
    [[nodiscard]] bool is_recorded() const { return graph_ != nullptr; }

   private:
    friend class CudaExecutor;
    cudaGraphExec_t graph_ = nullptr;
  };

  /// @param objects in the longest range that is reduced
  /// @param value_bytes of the largest result of a reduction
  /// @throw Error when there is no device, or no memory on it
  explicit CudaExecutor(index_t objects, index_t value_bytes = 64)
      : workspace_(objects, value_bytes),
        rounds_(SpaceKind::cuda, sizeof(int), "the rounds of a loop"),
        object_(SpaceKind::pinned, most_object_bytes, "an object read from the device") {
    cuda::check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "making a stream");
  }
  CudaExecutor(const CudaExecutor&) = delete;
  CudaExecutor& operator=(const CudaExecutor&) = delete;
  ~CudaExecutor() { cudaStreamDestroy(stream_); }

  [[nodiscard]] Stream stream() const { return stream_; }

  /// @throw Error when the launch fails
  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    parallel_for(Cuda{}, n, kernel, stream_);
  }

  /// @throw Error when the launch fails
  template <class Kernel, class Fold, class Then>
  void reduce(index_t n, const Kernel& kernel, Fold fold, const Then& then) {
    parallel_reduce(Cuda{}, 0, n, kernel, fold, then, workspace_, stream_);
  }

  /// @throw Error when the part does not begin and end with whole blocks, or the launch fails
  template <class Kernel, class Fold, class Then>
  void reduce_part(const PartOfReduction& part, const Kernel& kernel, Fold fold, const Then& then) {
    parallel_reduce_part(Cuda{}, part, kernel, fold, then, workspace_, stream_);
  }

  /// @param work orders what it does in the stream that it is given
  /// @throw what it throws
  template <class Work>
  void perform(const Work& work) {
    work(stream());
  }

  /// @param most rounds, of this call
  /// @param body is called once, when the loop is recorded: it must run the same steps each time
  /// @param done a function object of what arrays hold, which the device calls
  /// @throw Error when the steps cannot be recorded or launched
  template <class Body, class Done>
  void repeat(Loop& loop, int most, const Body& body, const Done& done) {
    if (most <= 0) return;
    if (loops_on_host_) return repeat_on_host(most, body, done);
    if (!loop.is_recorded()) record(loop, body, done);
    cuda::begin_rounds<<<1, 1, 0, stream_>>>(rounds_left(), most);
    cuda::check(cudaGetLastError(), "beginning a loop");
    cuda::check(cudaGraphLaunch(loop.graph_, stream_), "launching a loop");
  }

  /// What the first repeat() of a loop does before its rounds: records them, and runs nothing.
  /// @throw Error when the steps cannot be recorded; the loop is none then
  template <class Body, class Done>
  void record(Loop& loop, const Body& body, const Done& done) {
    struct Graph {
      cudaGraph_t graph = nullptr;
      ~Graph() {
        if (graph != nullptr) cudaGraphDestroy(graph);
      }
    } outer;
    cuda::check(cudaGraphCreate(&outer.graph, 0), "recording a loop");
    cudaGraphConditionalHandle go_on{};
    cuda::check(cudaGraphConditionalHandleCreate(&go_on, outer.graph, 1, cudaGraphCondAssignDefault),
                "recording a loop");
    cudaGraphNodeParams parameters{};
    parameters.type = cudaGraphNodeTypeConditional;
    parameters.conditional.handle = go_on;
    parameters.conditional.type = cudaGraphCondTypeWhile;
    parameters.conditional.size = 1;
    cudaGraphNode_t node{};
#if CUDART_VERSION >= 13000
    cuda::check(cudaGraphAddNode(&node, outer.graph, nullptr, nullptr, 0, &parameters), "recording a loop");
#else
    cuda::check(cudaGraphAddNode(&node, outer.graph, nullptr, 0, &parameters), "recording a loop");
#endif
    cuda::check(cudaStreamBeginCaptureToGraph(stream_, parameters.conditional.phGraph_out[0], nullptr, nullptr, 0,
                                              cudaStreamCaptureModeThreadLocal),
                "recording a loop");
    try {
      body();
      cuda::decide_to_go_on<<<1, 1, 0, stream_>>>(go_on, done, rounds_left());
      cuda::check(cudaGetLastError(), "recording a loop");
    } catch (...) {
      cudaGraph_t abandoned = nullptr;
      cudaStreamEndCapture(stream_, &abandoned);
      throw;
    }
    cudaGraph_t captured = nullptr;
    cuda::check(cudaStreamEndCapture(stream_, &captured), "recording a loop");
    cuda::check(cudaGraphInstantiate(&loop.graph_, outer.graph, 0), "recording a loop");
  }

  /// Adds to `sum`, in pinned or device memory, how many rounds the last repeat() had, of `most`.
  void add_rounds(int most, int* sum) {
    cuda::add_rounds<<<1, 1, 0, stream_>>>(rounds_left(), most, sum);
    cuda::check(cudaGetLastError(), "counting the rounds of a loop");
  }

  /// @throw Error when something that was given to the device has failed
  void wait() { cuda::check(cudaStreamSynchronize(stream_), "waiting for the device"); }

  template <class Object, class Real, class Layout, class Formats>
  [[nodiscard]] auto value(const Array<Object, Real, Cuda, Layout, Formats>& array) {
    using OnDevice = Array<Object, Real, Cuda, Layout, Formats>;
    constexpr index_t bytes = Layout::padded(1) * OnDevice::record_bytes;
    static_assert(bytes <= most_object_bytes,
                  "value() reads an object of 4096 bytes at most with its padding; copy the array to the host instead");
    if (array.size() != 1) {
      throw Error(std::string(Object::name) + ": value() is of an array of one object; this one has " +
                  std::to_string(array.size()));
    }
    cuda::check(cudaMemcpyAsync(object_.data(), array.untyped().base, bytes, cudaMemcpyDeviceToHost, stream_),
                "reading an object");
    wait();
    const View<Object, const Real, Layout, Formats, PinnedHost> view(object_.data(), 1, Layout::pitch(1));
    return view.get(index_t{0});
  }

 private:
  template <class Body, class Done>
  void repeat_on_host(int most, const Body& body, const Done& done) {
    for (int k = 0; k < most; ++k) {
      body();
      int* is_done = reinterpret_cast<int*>(object_.data());
      cuda::tell_whether_done<<<1, 1, 0, stream_>>>(done, is_done);
      cuda::check(cudaGetLastError(), "asking whether a loop is done");
      wait();
      if (*is_done != 0) return;
    }
  }

  [[nodiscard]] int* rounds_left() { return reinterpret_cast<int*>(rounds_.data()); }

  static constexpr index_t most_object_bytes = 4096;
  ReduceWorkspace workspace_;
  Buffer rounds_, object_;
  bool loops_on_host_ = std::getenv("PHYSGEN_LOOPS_ON_HOST") != nullptr;
  cudaStream_t stream_ = nullptr;
};

}  // namespace physgen
