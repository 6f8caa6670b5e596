// A stream that is captured in a graph: the work that it captures, and the work that it refuses (device.h).
#include <cuda_runtime_api.h>
#include <physgen/gather.h>
#include <physgen/mirror.h>
#include <physgen/topology.h>

#include "stream_checks.h"

namespace physgen::test {
namespace {

class InACapturedStream : public GpuTest {
 protected:
  template <class Action>
  void refused(const Action& action, const char* what) {
    const std::string message = message_of(action);
    EXPECT_NE(message.find("being captured"), std::string::npos) << what << ": " << message;
  }
};

TEST_F(InACapturedStream, what_must_wait_or_allocate_is_refused_and_the_rest_is_captured) {
  Positions<Cuda> device(stream_objects), second(stream_objects);
  Positions<Cuda, Aosoa<32>> tiles(stream_objects);
  Positions<PinnedHost> pinned(stream_objects), from_second(stream_objects);
  Positions<Host> host(stream_objects);
  Halves<Cuda> halves(stream_objects);
  Mirror<Positions<PinnedHost>, Positions<Cuda>> mirror(stream_objects);
  (void)mirror.write_device();
  number(device, 1);
  Stream stream = nullptr;
  ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
  ASSERT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
  refused([&] { synchronize(stream); }, "waiting");
  refused([&] { copy(host, device, stream); }, "to host memory");
  refused([&] { copy(device, host, stream); }, "from host memory");
  refused([&] { copy(host, pinned, stream); }, "from pinned to host memory");
  refused([&] { copy(pinned, host, stream); }, "from host to pinned memory");
  refused([&] { copy(pinned, tiles, stream); }, "in another layout to pinned memory");
  refused([&] { copy(halves, pinned, stream); }, "in another format from pinned memory");
  refused([&] { (void)losses_of_copy(halves.untyped(), device.untyped(), stream); }, "losses");
  refused([&] { (void)mirror.read_host(stream); }, "a mirror");
  const auto object = [](index_t) noexcept { return elasticity::NodePosition<float>{}; };
  refused([&] { gather_by(pinned, stream_objects, object, stream); }, "gathering to pinned memory");
  refused([&] { gather_by(device, stream_objects, object, stream); }, "gathering to the device");
  refused([&] { scatter_by(pinned, [](index_t, const auto&) {}, stream); }, "scattering from pinned memory");
  refused([&] { scatter_by(device, [](index_t, const auto&) {}, stream); }, "scattering from the device");
  EXPECT_NO_THROW(copy(second, device, stream));
  EXPECT_NO_THROW(copy(tiles, second, stream));
  EXPECT_NO_THROW(copy(halves, tiles, stream));
  EXPECT_NO_THROW(copy(from_second, second, stream));
  cudaGraph_t graph = nullptr;
  ASSERT_EQ(cudaStreamEndCapture(stream, &graph), cudaSuccess) << "what was refused has not ended the capture";
  cudaGraphExec_t ready = nullptr;
  ASSERT_EQ(cudaGraphInstantiate(&ready, graph, 0), cudaSuccess);
  number(device, 7);  // known when it runs, not when it was captured
  ASSERT_EQ(cudaGraphLaunch(ready, stream), cudaSuccess);
  synchronize(stream);
  EXPECT_EQ(wrong(from_second, 7), 0);
  EXPECT_EQ(wrong_later(tiles, 7, stream), 0);
  EXPECT_EQ(wrong_later(halves, 7, stream), 0);
  EXPECT_NO_THROW(copy(host, device, stream));
  cudaGraphExecDestroy(ready);
  cudaGraphDestroy(graph);
  cudaStreamDestroy(stream);
}

TEST_F(InACapturedStream, what_works_in_the_default_stream_is_refused_while_one_that_waits_for_it_is_captured) {
  Positions<Cuda> device(stream_objects);
  Positions<PinnedHost> pinned(stream_objects);
  number(device, 1);
  Stream stream = nullptr;
  ASSERT_EQ(cudaStreamCreate(&stream), cudaSuccess);
  ASSERT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
  refused([&] { device.resize(stream_objects + 1); }, "resize");
  refused([&] { pinned.resize(stream_objects + 1); }, "resize in pinned memory");
  refused([&] { append(device, 1); }, "append");
  refused([&] { (void)device.getdata(0, 0); }, "getdata");
  refused([&] { pinned.putdata(0, 0, 1); }, "putdata");
  EXPECT_NO_THROW(copy(pinned, device, stream));
  cudaGraph_t graph = nullptr;
  ASSERT_EQ(cudaStreamEndCapture(stream, &graph), cudaSuccess);
  EXPECT_EQ(device.size(), stream_objects);
  EXPECT_EQ(wrong_later(device, 1, nullptr), 0);
  cudaGraphDestroy(graph);
  cudaStreamDestroy(stream);
}

}  // namespace
}  // namespace physgen::test
