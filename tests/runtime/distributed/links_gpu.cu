// What crossing between GPUs costs: exchanges of two neighbours and gathers of all ranks, of 16 B, 12 kB, 336 kB and 4
// MB, by NCCL step by step and in a replayed graph of four rounds, and through pinned memory and MPI. Every byte is
// compared. Prints a line of JSON for each, with the median of five series.
//
//   --devices       says how many there are, and no more
//   --conditional   tries NCCL in the body of a loop whose rounds the device decides on
// Exit status: 77 where there is no CUDA device, or one rank.
#include <physgen/cuda/executor.h>
#include <physgen/distributed/cuda/device.h>
#include <physgen/distributed/cuda/transports.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace physgen;

constexpr int rounds_of_graph = 4, series = 5;

/// What a rank sends in byte k.
__host__ __device__ unsigned char byte_of(int rank, index_t k) {
  return static_cast<unsigned char>(k * 131 + rank * 17 + (k >> 8) * 7 + 3);
}

struct Fill {
  std::byte* bytes;
  int rank;
  __device__ void operator()(index_t k) const { bytes[k] = std::byte{byte_of(rank, k)}; }
};
struct CountWrong {
  const std::byte* bytes;
  int rank;
  __device__ bool operator()(index_t k) const { return bytes[k] != std::byte{byte_of(rank, k)}; }
};
struct IsDone {
  __device__ bool operator()() const { return false; }
};

class Links {
 public:
  Links(const Ranks& ranks, cuda::DeviceTransport& by, CudaExecutor& on, index_t bytes)
      : ranks_(ranks),
        by_(by),
        on_(on),
        bytes_(bytes),
        sent_(SpaceKind::cuda, bytes, "sent"),
        received_(SpaceKind::cuda, bytes * ranks.count(), "received"),
        workspace_(bytes) {
    parallel_for(Cuda{}, bytes, Fill{sent_.data(), ranks.rank()}, stream());
  }

  void exchange() {
    const int peer = ranks_.rank() ^ 1;
    std::vector<Message> messages;
    const auto count = static_cast<std::size_t>(bytes_);
    if (peer < ranks_.count())
      messages.push_back({peer, {sent_.data(), count}, {received_.data() + peer * bytes_, count}});
    by_.transport->begin(messages);
    by_.transport->end();
  }
  void gather() {
    const auto count = static_cast<std::size_t>(bytes_);
    const std::vector<index_t> sizes(static_cast<std::size_t>(ranks_.count()), bytes_);
    by_.transport->gather({sent_.data(), count}, sizes, {received_.data(), count * sizes.size()});
  }

  /// Times call(), which does `rounds` rounds, and prints the line. @param from_all whether all ranks' bytes come
  void measure(const char* what, const char* how, int rounds, bool from_all, const std::function<void()>& call) {
    const int calls = std::max(4, static_cast<int>((bytes_ < 100'000 ? 800 : 200) / rounds));
    check(cudaMemsetAsync(received_.data(), 0xA5, static_cast<std::size_t>(received_.bytes()), stream()));
    for (int k = 0; k < 8; ++k) call();
    for (int r = 0; r < ranks_.count(); ++r) {
      if (from_all || r == (ranks_.rank() ^ 1)) require_right(r);
    }
    std::vector<double> times;
    for (int s = 0; s < series; ++s) {
      on_.wait();
      const auto start = std::chrono::steady_clock::now();
      for (int k = 0; k < calls; ++k) call();
      on_.wait();
      const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
      times.push_back(time.count() / calls / rounds);
    }
    std::ranges::sort(times);
    if (!ranks_.is_first()) return;
    std::printf(R"({"what": "%s", "how": "%s", "by": "%s", "ranks": %d, "bytes": %lld, "us": %.2f, "least_us": %.2f})"
                "\n",
                what, how, by_.name.c_str(), ranks_.count(), static_cast<long long>(bytes_), times[series / 2],
                times[0]);
    std::fflush(stdout);
  }

  /// The same of a graph of four rounds.
  void measure_graph(const char* what, bool from_all, const std::function<void()>& round) {
    cudaGraph_t graph = nullptr;
    cudaGraphExec_t executable = nullptr;
    round();  // connects ranks, before it is recorded
    on_.wait();
    check(cudaStreamBeginCapture(stream(), cudaStreamCaptureModeThreadLocal));
    for (int k = 0; k < rounds_of_graph; ++k) round();
    check(cudaStreamEndCapture(stream(), &graph));
    check(cudaGraphInstantiate(&executable, graph, 0));
    measure(what, "graph of 4 rounds", rounds_of_graph, from_all,
            [&] { check(cudaGraphLaunch(executable, stream())); });
    cudaGraphExecDestroy(executable);
    cudaGraphDestroy(graph);
  }

  void try_conditional() {
    CudaExecutor::Loop loop;
    exchange();
    measure("exchange", "conditional body", rounds_of_graph, false,
            [&] { on_.repeat(loop, rounds_of_graph, [&] { exchange(); }, IsDone{}); });
  }

  static void check(cudaError_t status) { cuda::check(status, "measuring links"); }

 private:
  [[nodiscard]] Stream stream() const { return on_.stream(); }
  void require_right(int rank) {
    const auto wrong = count(Cuda{}, bytes_, CountWrong{received_.data() + rank * bytes_, rank}, workspace_, stream());
    if (wrong > 0) {
      throw Error(std::to_string(wrong) + " of " + std::to_string(bytes_) + " bytes from rank " + std::to_string(rank) +
                  " are wrong, by " + by_.name);
    }
  }

  const Ranks& ranks_;
  cuda::DeviceTransport& by_;
  CudaExecutor& on_;
  index_t bytes_;
  Buffer sent_, received_;
  ReduceWorkspace workspace_;
};

int run(int argc, char** argv) {
  const Ranks ranks(argc, argv);
  const std::string option = argc > 1 ? argv[1] : "";
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess) devices = 0;
  if (option == "--devices") {
    std::printf("%d\n", devices);
    return 0;
  }
  if (devices == 0 || ranks.count() == 1) {
    std::printf("skipped: this measures between ranks that have a CUDA device each\n");
    return 77;
  }
  const std::unique_ptr<Transport> host = make_transport(ranks);
  ranks.guard([&] {
    (void)cuda::take_device(ranks, *host);
    for (const bool uses_nccl : {true, false}) {
      CudaExecutor on(1);
      cuda::DeviceTransport by = cuda::make_device_transport(ranks, *host, on.stream(), uses_nccl);
      const bool is_nccl = by.name.starts_with("NCCL");
      if (uses_nccl && !is_nccl) continue;
      for (const index_t bytes : {index_t{16}, index_t{12'000}, index_t{336'000}, index_t{4'000'000}}) {
        Links links(ranks, by, on, bytes);
        if (option == "--conditional") {
          if (is_nccl) links.try_conditional();
          continue;
        }
        links.measure("exchange", "step by step", 1, false, [&] { links.exchange(); });
        links.measure("gather", "step by step", 1, true, [&] { links.gather(); });
        if (is_nccl) {
          links.measure_graph("exchange", false, [&] { links.exchange(); });
          links.measure_graph("gather", true, [&] { links.gather(); });
        }
        on.wait();
      }
    }
  });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
