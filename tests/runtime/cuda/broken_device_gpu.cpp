// A kernel that traps breaks the device for the rest of the process: a program of its own. The first operation after it
// tells so in one Error, later ones refuse, nothing hangs, and destructors end quietly.
#include <physgen/gather.h>
#include <physgen/mirror.h>
#include <physgen/topology.h>

#include <cstdio>
#include <cstdlib>
#include <functional>

#include "stream_kernels.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

constexpr int skipped = 77;

int failures = 0;

void expect_refused(const char* what, const std::function<void()>& action) {
  const std::string message = message_of(action);
  const bool clear = message.find("this process can use the device no more") != std::string::npos ||
                     message.find("cuda") != std::string::npos;
  std::printf("%-28s %s\n", what, message.c_str());
  if (message == "nothing was thrown" || !clear) ++failures;
}

int run() {
  if (!cuda_available()) return skipped;
  constexpr index_t n = 5000;
  elasticity::NodePositionArray<float, Cuda> device(n), other(n);
  elasticity::NodePositionArray<float, PinnedHost> pinned(n);
  elasticity::NodePositionArray<double, Host, Soa> host(n), second(n);
  elasticity::TetArray<float, Cuda> tets(n);
  Mirror<elasticity::NodePositionArray<float, PinnedHost>, elasticity::NodePositionArray<float, Cuda>> mirror(n);
  (void)mirror.write_device();
  host.putdata(7, 1, 3);
  const std::vector<index_t> some = {1, 2, 3};
  trap(nullptr);
  const std::string first = message_of([&] { copy(host, device); });
  std::printf("%-28s %s\n", "the first operation", first.c_str());
  if (first.find("a kernel has failed, and this process can use the device no more") == std::string::npos) ++failures;
  expect_refused("synchronize", [&] { synchronize(); });
  expect_refused("copy", [&] { copy(host, device); });
  expect_refused("copy on the device", [&] {
    copy(other, device);
    synchronize();
  });
  expect_refused("upload", [&] {
    copy(device, host);
    synchronize();
  });
  expect_refused("resize", [&] { device.resize(n + 1); });
  expect_refused("a new array", [&] { const elasticity::NodePositionArray<float, Cuda> made(10); });
  expect_refused("a new pinned array", [&] { const elasticity::NodePositionArray<float, PinnedHost> made(10); });
  expect_refused("append", [&] { append(device, other); });
  expect_refused("erase", [&] { erase(device, some); });
  expect_refused("renumber", [&] { renumber(tets, "nodes", some); });
  expect_refused("getdata", [&] { (void)device.getdata(0, 0); });
  expect_refused("putdata", [&] { device.putdata(0, 0, 1); });
  expect_refused("getdata of pinned memory", [&] { (void)pinned.getdata(0, 0); });
  expect_refused("losses", [&] { (void)losses_of_copy(host.untyped(), device.untyped()); });
  const auto object = [](index_t) noexcept { return elasticity::NodePosition<float>{}; };
  expect_refused("gather", [&] { gather_by(device, n, object); });
  expect_refused("scatter", [&] { scatter_by(device, [](index_t, const auto&) {}); });
  expect_refused("a mirror", [&] { (void)mirror.read_host(); });
  if (device.size() != n || other.size() != n) ++failures;
  copy(second, host);  // host memory alone is as good as before
  if (second.getdata(7, 1) != 3) ++failures;
  std::printf("%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace physgen::test

int main() {
  std::set_terminate([] {
    std::puts("std::terminate was called");
    std::_Exit(3);
  });
  const int result = physgen::test::run();  // its arrays are destroyed here
  std::puts(result == 77 ? "no CUDA device on this machine" : "the end is reached");
  return result;
}
