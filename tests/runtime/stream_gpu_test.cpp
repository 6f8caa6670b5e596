// The rule of streams (storage.h), with a slow kernel in the stream before each operation of the library; and what a
// captured stream refuses.
#include <cuda_runtime_api.h>
#include <physgen/gather.h>
#include <physgen/mirror.h>
#include <physgen/topology.h>

#include "gpu_fixture.h"
#include "stream_kernels.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

constexpr index_t n = 100000;

template <class Space, class Layout = Aos, class Real = float>
using Positions = Array<elasticity::NodePositionObject, Real, Space, Layout>;

struct HalfPositions : elasticity::NodePositionFormats<Host> {
  using x = format::Half<>;
};
template <class Space>
using Halves = Array<elasticity::NodePositionObject, float, Space, Soa, HalfPositions>;

/// x[0] of object i is first + i % 1000, which a half holds.
template <class Tested>
void number(Tested& array, double first) {
  Positions<Host> numbers(array.size());
  for (index_t i = 0; i < array.size(); ++i) {
    numbers.view()[i].x() = Eigen::Vector3f::Constant(static_cast<float>(first + static_cast<double>(i % 1000)));
  }
  copy(array, numbers);
  synchronize();
}

/// Objects of host memory that are not numbered so, as a host view finds them now.
template <class Tested>
index_t wrong(const Tested& array, double first, index_t begin = 0, index_t end = n) {
  index_t count = 0;
  const auto view = array.const_view();
  for (index_t i = begin; i < end; ++i) {
    const auto x = view[i].x().get();
    count += static_cast<double>(x[2]) != first + static_cast<double>((i - begin) % 1000);
  }
  return count;
}

/// The same of any array, once the stream is done.
template <class Tested>
index_t wrong_later(const Tested& array, double first, Stream stream) {
  synchronize(stream);
  Positions<Host> objects(array.size());
  copy(objects, array);
  synchronize();
  return wrong(objects, first, 0, array.size());
}

/// In the default stream, and in one that does not wait for it.
class InAStream : public GpuTest, public ::testing::WithParamInterface<bool> {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    if (IsSkipped()) return;
    if (GetParam()) {
      ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
    }
    device = Positions<Cuda>(n);
    pinned = Positions<PinnedHost>(n);
    host = Positions<Host>(n);
    number(device, 1);
    synchronize();
  }
  void TearDown() override {
    if (stream != nullptr) cudaStreamDestroy(stream);
  }

  /// Behind a slow kernel, the pinned array becomes the device's.
  void download_later() {
    spin(stream);
    copy(pinned, device, stream);
  }
  /// Behind a slow kernel, the device's array becomes the pinned one, numbered from 1 on.
  void upload_later() {
    number(pinned, 1);
    number(device, 500);
    spin(stream);
    copy(device, pinned, stream);
  }

  Stream stream = nullptr;
  Positions<Cuda> device;
  Positions<PinnedHost> pinned;
  Positions<Host> host;
};
INSTANTIATE_TEST_SUITE_P(Streams, InAStream, ::testing::Bool(),
                         [](const auto& parameter) { return parameter.param ? "own" : "standard"; });

TEST_P(InAStream, copies_from_pinned_to_host_memory_see_what_was_ordered_before) {
  download_later();
  copy(host, pinned, stream);
  EXPECT_EQ(wrong(host, 1), 0);
  number(device, 3);
  download_later();
  Positions<Host, Soa, double> other(n);
  copy(other, pinned, stream);
  EXPECT_EQ(wrong(other, 3), 0) << "in another form";
  number(device, 5);
  download_later();
  copy_range(host.storage(), pinned.storage(), 0, n, stream);
  EXPECT_EQ(wrong(host, 5), 0) << "of a range";
}

TEST_P(InAStream, copies_from_pinned_to_pinned_and_to_device_memory_see_what_was_ordered_before) {
  Positions<PinnedHost> same(n);
  Positions<PinnedHost, Soa, double> other(n);
  download_later();
  copy(same, pinned, stream);
  EXPECT_EQ(wrong(same, 1), 0);
  number(device, 3);
  download_later();
  copy(other, pinned, stream);
  EXPECT_EQ(wrong(other, 3), 0);
  Positions<Cuda> there(n);
  Halves<Cuda> halves(n);
  number(device, 5);
  download_later();
  copy(there, pinned, stream);
  copy(halves, pinned, stream);
  EXPECT_EQ(wrong_later(there, 5, stream), 0);
  EXPECT_EQ(wrong_later(halves, 5, stream), 0);
}

TEST_P(InAStream, copies_from_the_device_see_what_was_ordered_before) {
  upload_later();
  copy(host, device, stream);
  EXPECT_EQ(wrong(host, 1), 0);
  upload_later();
  Positions<Host, Soa, double> other(n);
  copy(other, device, stream);
  EXPECT_EQ(wrong(other, 1), 0);
  upload_later();
  Positions<Cuda, Aosoa<32>> tiles(n);
  copy(tiles, device, stream);
  EXPECT_EQ(wrong_later(tiles, 1, stream), 0);
  upload_later();
  Halves<PinnedHost> halves(n);
  copy(halves, device, stream);
  synchronize(stream);
  EXPECT_EQ(wrong(halves, 1), 0);
}

TEST_P(InAStream, copies_to_pinned_and_device_memory_come_after_what_was_ordered_before) {
  number(host, 700);
  upload_later();
  copy(pinned, host, stream);
  EXPECT_EQ(wrong(pinned, 700), 0);
  EXPECT_EQ(wrong_later(device, 1, stream), 0);
  download_later();
  copy(device, host, stream);
  EXPECT_EQ(wrong_later(pinned, 1, stream), 0);
  EXPECT_EQ(wrong_later(device, 700, stream), 0);
}

TEST_P(InAStream, scattered_objects_are_those_of_the_stream) {
  std::vector<float> seen(n);
  const auto set = [&](index_t i, const auto& value) { seen[static_cast<std::size_t>(i)] = value.x[2]; };
  const auto missed = [&](double first) {
    index_t count = 0;
    for (index_t i = 0; i < n; ++i) count += seen[static_cast<std::size_t>(i)] != first + static_cast<double>(i % 1000);
    return count;
  };
  download_later();
  scatter_by(pinned, set, stream);
  EXPECT_EQ(missed(1), 0) << "from pinned memory";
  std::fill(seen.begin(), seen.end(), 0.0F);
  upload_later();
  scatter_by(device, set, stream);
  EXPECT_EQ(missed(1), 0) << "from the device";
  std::vector<elasticity::NodePosition<float>> objects(n);
  std::vector<elasticity::NodePosition<float>*> pointers;
  for (auto& object : objects) pointers.push_back(&object);
  number(device, 9);
  download_later();
  scatter(pinned, pointers, [](auto& object, const auto& value) { object = value; }, stream);
  for (index_t i = 0; i < n; ++i) seen[static_cast<std::size_t>(i)] = objects[static_cast<std::size_t>(i)].x[2];
  EXPECT_EQ(missed(9), 0) << "to pointers";
}

TEST_P(InAStream, objects_are_gathered_after_what_was_ordered_before) {
  const auto object = [](index_t i) noexcept {
    return elasticity::NodePosition<float>{Eigen::Vector3f::Constant(static_cast<float>(900 + i % 1000))};
  };
  upload_later();
  gather_by(n, pinned, object, stream);
  EXPECT_EQ(wrong(pinned, 900), 0);
  EXPECT_EQ(wrong_later(device, 1, stream), 0) << "the upload took what was there before";
  download_later();
  gather_by(n, device, object, stream);
  EXPECT_EQ(wrong_later(pinned, 1, stream), 0) << "the download took what was there before";
  EXPECT_EQ(wrong_later(device, 900, stream), 0);
}

TEST_P(InAStream, losses_are_those_of_the_objects_that_arrive) {
  const Halves<PinnedHost> halves(n);
  number(device, 1e6);
  download_later();
  EXPECT_EQ(losses_of_copy(halves.storage(), pinned.storage(), stream).out_of_range, 3U * n);
}

TEST_P(InAStream, mirrors_read_what_kernels_of_the_stream_have_written) {
  Mirror<Positions<PinnedHost>, Positions<Cuda>> mirror(n);
  Mirror<Positions<Host, Soa, double>, Positions<Cuda>> pageable(n);
  const auto write = [&](auto& tested) {
    Storage there = device.storage();
    there.base = tested.write_device().data();
    spin(stream);
    copy(there, device.storage(), stream);
  };
  write(mirror);
  EXPECT_EQ(mirror.read_host(stream)[n - 1].x().get()[0], static_cast<float>(1 + (n - 1) % 1000));
  write(pageable);
  EXPECT_EQ(pageable.read_host(stream)[n - 1].x().get()[0], static_cast<double>(1 + (n - 1) % 1000));
}

/// What works in the default stream alone.
class InTheDefaultStream : public InAStream {};
INSTANTIATE_TEST_SUITE_P(Streams, InTheDefaultStream, ::testing::Values(false));

TEST_P(InTheDefaultStream, appended_objects_are_those_of_the_stream) {
  Positions<Host> same(0);
  Positions<Host, Soa, double> other(0);
  Positions<Cuda> there(0);
  Positions<PinnedHost> target(3);
  download_later();
  append(same, pinned);
  EXPECT_EQ(wrong(same, 1), 0) << "to host memory";
  number(device, 3);
  download_later();
  append(other, pinned);
  EXPECT_EQ(wrong(other, 3), 0) << "in another form";
  number(device, 5);
  download_later();
  append(there, pinned);
  EXPECT_EQ(wrong_later(there, 5, nullptr), 0) << "to the device";
  number(device, 7);
  download_later();
  append(target, pinned);
  EXPECT_EQ(wrong(target, 7, 3, n + 3), 0) << "to pinned memory";
  number(device, 9);
  download_later();
  append(pinned, pinned);
  EXPECT_EQ(wrong(pinned, 9), 0);
  EXPECT_EQ(wrong(pinned, 9, n, 2 * n), 0) << "to itself";
}

TEST_P(InTheDefaultStream, arrays_change_after_what_was_ordered_before) {
  std::vector<index_t> backwards(n), evens;
  for (index_t i = 0; i < n; ++i) backwards[static_cast<std::size_t>(i)] = n - 1 - i;
  for (index_t i = 0; i < n; i += 2) evens.push_back(i);
  const auto value = [&](index_t i) { return pinned.const_view()[i].x().get()[0]; };
  download_later();
  permute(pinned, backwards);
  EXPECT_EQ(value(0), static_cast<float>(1 + (n - 1) % 1000));
  EXPECT_EQ(value(n - 1), 1);
  download_later();
  Positions<PinnedHost> copied(pinned);
  EXPECT_EQ(wrong(copied, 1), 0) << "a copy";
  number(device, 3);
  download_later();
  pinned.resize(n + 10);
  EXPECT_EQ(wrong(pinned, 3), 0) << "resized";
  pinned.resize(n);
  number(device, 5);
  download_later();
  append(pinned, 10);
  EXPECT_EQ(wrong(pinned, 5), 0) << "new objects appended";
  pinned.resize(n);
  number(device, 7);
  download_later();
  erase(pinned, evens);
  EXPECT_EQ(value(0), 8) << "erased";
  pinned = Positions<PinnedHost>(n);
  download_later();
  compact(pinned, evens);
  EXPECT_EQ(value(1), 9) << "compacted";
}

TEST_P(InTheDefaultStream, indices_are_renumbered_after_what_was_ordered_before) {
  elasticity::TetArray<float, PinnedHost> tets(n);
  elasticity::TetArray<float, Cuda, Aosoa<16>> there(n);
  elasticity::TetArray<float, Host> plain(n), result(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < 4; ++k) plain.putdata(i, k, k);
  }
  const auto count_wrong = [](const auto& array, int first, int step) {
    index_t count = 0;
    for (index_t i = 0; i < n; ++i) {
      const auto nodes = array.const_view()[i].nodes().get();
      for (int k = 0; k < 4; ++k) count += nodes[k] != first + k * step;
    }
    return count;
  };
  const std::vector<index_t> backwards = {3, 2, 1, 0};
  copy(tets, plain);
  spin(nullptr);
  copy(there, tets);
  renumber(tets, "nodes", backwards);
  copy(result, there);
  EXPECT_EQ(count_wrong(result, 0, 1), 0) << "the upload took what was there before";
  EXPECT_EQ(count_wrong(tets, 3, -1), 0);
  spin(nullptr);
  copy(tets, there);
  renumber(tets, "nodes", backwards);
  EXPECT_EQ(count_wrong(tets, 3, -1), 0) << "what has arrived is renumbered";
}

TEST_P(InTheDefaultStream, single_elements_and_bytes_are_those_of_the_stream) {
  download_later();
  EXPECT_EQ(pinned.getdata(n - 1, 2), static_cast<double>(1 + (n - 1) % 1000));
  upload_later();
  pinned.putdata(n - 1, 2, 12345);
  EXPECT_EQ(wrong_later(device, 1, nullptr), 0);
  EXPECT_EQ(pinned.getdata(n - 1, 2), 12345);
  number(device, 3);
  download_later();
  copy_memory(host.storage().base, SpaceKind::host, pinned.storage().base, SpaceKind::pinned, pinned.storage().bytes());
  EXPECT_EQ(wrong(host, 3), 0);
}

class Transfers : public GpuTest {};

TEST_F(Transfers, of_no_objects_need_no_memory) {
  elasticity::NodePositionArray<float, Cuda> none;
  EXPECT_NO_THROW(gather_by(0, none, [](index_t) { return elasticity::NodePosition<float>{}; }));
  EXPECT_NO_THROW(scatter_by(none, [](index_t, const auto&) {}));
  EXPECT_EQ(none.size(), 0);
}

class InACapturedStream : public GpuTest {
 protected:
  template <class Action>
  void refused(const Action& action, const char* what) {
    const std::string message = message_of(action);
    EXPECT_NE(message.find("being captured"), std::string::npos) << what << ": " << message;
  }
};

TEST_F(InACapturedStream, what_must_wait_or_allocate_is_refused_and_the_rest_is_captured) {
  Positions<Cuda> device(n), second(n);
  Positions<Cuda, Aosoa<32>> tiles(n);
  Positions<PinnedHost> pinned(n), from_second(n);
  Positions<Host> host(n);
  Halves<Cuda> halves(n);
  Mirror<Positions<PinnedHost>, Positions<Cuda>> mirror(n);
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
  refused([&] { (void)losses_of_copy(halves.storage(), device.storage(), stream); }, "losses");
  refused([&] { (void)mirror.read_host(stream); }, "a mirror");
  const auto object = [](index_t) noexcept { return elasticity::NodePosition<float>{}; };
  refused([&] { gather_by(n, pinned, object, stream); }, "gathering to pinned memory");
  refused([&] { gather_by(n, device, object, stream); }, "gathering to the device");
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
  Positions<Cuda> device(n);
  Positions<PinnedHost> pinned(n);
  number(device, 1);
  Stream stream = nullptr;
  ASSERT_EQ(cudaStreamCreate(&stream), cudaSuccess);
  ASSERT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
  refused([&] { device.resize(n + 1); }, "resize");
  refused([&] { pinned.resize(n + 1); }, "resize in pinned memory");
  refused([&] { append(device, 1); }, "append");
  refused([&] { (void)device.getdata(0, 0); }, "getdata");
  refused([&] { pinned.putdata(0, 0, 1); }, "putdata");
  EXPECT_NO_THROW(copy(pinned, device, stream));
  cudaGraph_t graph = nullptr;
  ASSERT_EQ(cudaStreamEndCapture(stream, &graph), cudaSuccess);
  EXPECT_EQ(device.size(), n);
  EXPECT_EQ(wrong_later(device, 1, nullptr), 0);
  cudaGraphDestroy(graph);
  cudaStreamDestroy(stream);
}

}  // namespace
}  // namespace physgen::test
