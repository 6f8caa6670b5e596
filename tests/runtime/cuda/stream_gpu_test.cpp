// The rule of streams (device.h), with a slow kernel in the stream before each operation of the library.
#include <cuda_runtime_api.h>
#include <physgen/gather.h>
#include <physgen/mirror.h>
#include <physgen/topology.h>

#include "stream_checks.h"
#include "stream_kernels.h"

namespace physgen::test {
namespace {

constexpr index_t n = stream_objects;

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
  copy_range(host.untyped(), pinned.untyped(), 0, n, stream);
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
  scatter(pointers, pinned, [](auto& object, const auto& value) { object = value; }, stream);
  for (index_t i = 0; i < n; ++i) seen[static_cast<std::size_t>(i)] = objects[static_cast<std::size_t>(i)].x[2];
  EXPECT_EQ(missed(9), 0) << "to pointers";
}

TEST_P(InAStream, objects_are_gathered_after_what_was_ordered_before) {
  const auto object = [](index_t i) noexcept {
    return elasticity::NodePosition<float>{Eigen::Vector3f::Constant(static_cast<float>(900 + i % 1000))};
  };
  upload_later();
  gather_by(pinned, n, object, stream);
  EXPECT_EQ(wrong(pinned, 900), 0);
  EXPECT_EQ(wrong_later(device, 1, stream), 0) << "the upload took what was there before";
  download_later();
  gather_by(device, n, object, stream);
  EXPECT_EQ(wrong_later(pinned, 1, stream), 0) << "the download took what was there before";
  EXPECT_EQ(wrong_later(device, 900, stream), 0);
}

TEST_P(InAStream, losses_are_those_of_the_objects_that_arrive) {
  const Halves<PinnedHost> halves(n);
  number(device, 1e6);
  download_later();
  EXPECT_EQ(losses_of_copy(halves.untyped(), pinned.untyped(), stream).out_of_range, 3U * n);
}

TEST_P(InAStream, mirrors_read_what_kernels_of_the_stream_have_written) {
  Mirror<Positions<PinnedHost>, Positions<Cuda>> mirror(n);
  Mirror<Positions<Host, Soa, double>, Positions<Cuda>> pageable(n);
  const auto write = [&](auto& tested) {
    UntypedArray there = device.untyped();
    there.base = tested.write_device().data();
    spin(stream);
    copy(there, device.untyped(), stream);
  };
  write(mirror);
  EXPECT_EQ(mirror.read_host(stream)[n - 1].x().get()[0], static_cast<float>(1 + (n - 1) % 1000));
  write(pageable);
  EXPECT_EQ(pageable.read_host(stream)[n - 1].x().get()[0], static_cast<double>(1 + (n - 1) % 1000));
}

/// Operations that work in the default stream alone.
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
  copy_memory(host.untyped().base, SpaceKind::host, pinned.untyped().base, SpaceKind::pinned, pinned.untyped().bytes());
  EXPECT_EQ(wrong(host, 3), 0);
}

class Transfers : public GpuTest {};

TEST_F(Transfers, of_no_objects_need_no_memory) {
  elasticity::NodePositionArray<float, Cuda> none;
  EXPECT_NO_THROW(gather_by(none, 0, [](index_t) { return elasticity::NodePosition<float>{}; }));
  EXPECT_NO_THROW(scatter_by(none, [](index_t, const auto&) {}));
  EXPECT_EQ(none.size(), 0);
}

}  // namespace
}  // namespace physgen::test
