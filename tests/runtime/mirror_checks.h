// Mirrors between host arrays and every layout of one space: one source for host and CUDA memory.
#pragma once

#include <physgen/mirror.h>

#include "range_checks.h"

namespace physgen::test {

/// A mirror whose sides are changed through arrays that share its memory.
template <class Mirror>
class MirrorCheck {
 public:
  MirrorCheck(index_t n, std::mt19937& random) {
    typename Mirror::HostArray objects(n);
    randomise_objects(objects, random);
    model_ = objects_of(objects);
    mirror_ = Mirror(std::move(objects));
  }

  Mirror& mirror() { return mirror_; }

  void write_host(index_t begin, index_t end, double value) {
    const auto view = mirror_.write_host(begin, end);
    put<typename Mirror::HostArray>(view, begin, end, value);
  }
  void write_device(index_t begin, index_t end, double value) {
    const auto view = mirror_.write_device(begin, end);
    put<typename Mirror::DeviceArray>(view, begin, end, value);
  }
  void expect_host_up_to_date() { expect<typename Mirror::HostArray>(mirror_.read_host()); }
  void expect_device_up_to_date() { expect<typename Mirror::DeviceArray>(mirror_.read_device()); }

 private:
  template <class Array, class View>
  static UntypedArray storage_of(const View& view) {
    UntypedArray untyped = Array(view.size()).untyped();  // of the form alone
    untyped.base = const_cast<std::byte*>(view.data());
    return untyped;
  }
  template <class Array, class View>
  void put(const View& view, index_t begin, index_t end, double value) {
    const UntypedArray untyped = storage_of<Array>(view);
    for (const index_t i : {begin, end - 1}) {
      putdata(untyped, i, 1, value);
      model_[static_cast<std::size_t>(i)][1] = value;
    }
  }
  template <class Array, class View>
  void expect(const View& view) {
    Array objects(view.size());
    copy(objects.untyped(), storage_of<Array>(view));
    synchronize();
    EXPECT_EQ(objects_of(objects), model_);
  }

  Mirror mirror_;
  Model model_;
};

template <class Space, class Layout, class HostLayout>
void check_mirror_moves_only_what_changed() {
  using Position = elasticity::NodePositionObject;
  using Tested = Mirror<Array<Position, float, Host, HostLayout>, Array<Position, float, Space, Layout>>;
  std::mt19937 random(seed());
  const index_t n = 5 * mirror_block + 77;
  MirrorCheck<Tested> check(n, random);
  Tested& mirror = check.mirror();
  const typename Tested::HostArray form(n);
  index_t moved = 0;  // so far
  const auto expect_moved = [&](index_t begin, index_t end) {
    expect_bytes(mirror.bytes_moved() - moved, form, form, begin, end);
    moved = mirror.bytes_moved();
  };

  expect_moved(0, 0);
  check.expect_host_up_to_date();  // all is newer on the host, so reading there moves nothing
  expect_moved(0, 0);
  check.expect_device_up_to_date();
  expect_moved(0, n);
  check.expect_device_up_to_date();
  expect_moved(0, 0);

  check.write_host(mirror_block + 5, mirror_block + 6, 17);
  expect_moved(0, 0);  // only reading on the other side moves
  check.expect_device_up_to_date();
  expect_moved(mirror_block, 2 * mirror_block);

  check.write_device(n - 1, n, 18);
  check.expect_host_up_to_date();
  expect_moved(5 * mirror_block, n);

  // Both sides in different blocks; two that touch, one that does not. And both in one block, of which parts move.
  check.write_host(0, 3, 19);
  check.write_device(2 * mirror_block - 1, 2 * mirror_block + 1, 20);
  check.write_device(4 * mirror_block, 5 * mirror_block, 21);
  check.expect_host_up_to_date();
  expect_moved(0, 3 * mirror_block);  // three blocks
  check.expect_device_up_to_date();
  expect_moved(0, mirror_block);
  check.write_host(100, 110, 23);
  check.write_device(300, 310, 24);
  check.write_host(500, 510, 25);
  check.expect_device_up_to_date();
  check.expect_host_up_to_date();
  EXPECT_LE(mirror.bytes_moved() - moved, 2 * mirror_block * form.record_bytes);
  moved = mirror.bytes_moved();

  // Only what is read moves.
  check.write_device(0, n, 22);
  (void)mirror.read_host(mirror_block, mirror_block + 1);
  expect_moved(mirror_block, 2 * mirror_block);
  (void)mirror.read_host(0, 0);
  expect_moved(0, 0);
  check.expect_host_up_to_date();
  expect_moved(mirror_block, n);  // all other blocks
}

template <class Space, class Layout>
void check_mirror_refuses_objects_that_changed_on_both_sides() {
  using Position = elasticity::NodePositionObject;
  using Tested = Mirror<Array<Position, float, Host, AosPadded>, Array<Position, float, Space, Layout>>;
  std::mt19937 random(seed());
  const index_t n = 3 * mirror_block;
  MirrorCheck<Tested> check(n, random);
  check.expect_device_up_to_date();
  check.write_host(mirror_block + 7, mirror_block + 8, 3);
  const std::string message = message_of([&] { (void)check.mirror().write_device(); });
  EXPECT_NE(message.find("elasticity::NodePosition[12288]: objects 4103 to 4103 were changed on the host and cannot be "
                         "changed on the device as well; read_device() first"),
            std::string::npos)
      << message;
  const index_t before = check.mirror().bytes_moved();
  check.expect_host_up_to_date();  // the refused call noted nothing
  EXPECT_EQ(check.mirror().bytes_moved(), before);
  check.write_device(0, mirror_block, 4);
  check.expect_device_up_to_date();
  check.write_device(mirror_block, 2 * mirror_block, 5);
  const std::string other_side = message_of([&] { (void)check.mirror().write_host(7, 12); });
  EXPECT_NE(other_side.find("objects 7 to 11 were changed on the device"), std::string::npos) << other_side;
  check.expect_host_up_to_date();
  for (const auto& [begin, end] : {std::pair<index_t, index_t>(-1, 3), {5, 4}, {0, n + 1}}) {
    EXPECT_THROW((void)check.mirror().write_host(begin, end), Error);
    EXPECT_THROW((void)check.mirror().read_device(begin, end), Error);
  }
  check.expect_device_up_to_date();
}

/// Objects that nobody wrote keep every bit on both sides, whatever precisions and formats these have.
/// @tparam Written, Kept arrays of one object type, the latter of numbers that the former cannot hold
template <class Mirror, class Written, class Kept>
void check_mirror_keeps_what_nobody_wrote(Side kept_side, index_t n) {
  std::mt19937 random(seed());
  Mirror mirror(n);
  const auto tenths = [&](const UntypedArray& untyped) {
    Kept values(n);
    for (index_t i = 0; i < n; ++i) {
      for (int k = 0; k < values.elements; ++k) values.putdata(i, k, 0.1 * static_cast<double>(3 * i + k + 1));
    }
    copy(untyped, values.untyped());
    synchronize();
  };
  const auto storage_of = [&](const auto& view, UntypedArray form) {
    form.base = const_cast<std::byte*>(view.data());
    return form;
  };
  const UntypedArray kept_form = Kept(n).untyped(), written_form = Written(n).untyped();
  UntypedArray kept, written;
  if (kept_side == Side::host) {
    kept = storage_of(mirror.write_host(), kept_form);
    tenths(kept);
    written = storage_of(mirror.read_device(), written_form);
  } else {
    kept = storage_of(mirror.write_device(), kept_form);
    tenths(kept);
    written = storage_of(mirror.read_host(), written_form);
  }
  const auto write = [&](index_t begin, index_t end) {
    if (kept_side == Side::host) {
      (void)mirror.write_device(begin, end);
    } else {
      (void)mirror.write_host(begin, end);
    }
  };
  const auto read = [&](index_t begin, index_t end) {
    if (kept_side == Side::host) {
      (void)mirror.read_host(begin, end);
    } else {
      (void)mirror.read_device(begin, end);
    }
  };
  std::vector<bool> touched(static_cast<std::size_t>(n), false);
  for (int step = 0; step < 20; ++step) {
    const index_t begin = std::uniform_int_distribution<index_t>(0, n - 1)(random);
    const index_t end = std::min(n, begin + 1 + static_cast<index_t>(random() % (step % 3 == 0 ? 70 : 3)));
    write(begin, end);
    for (index_t i = begin; i < end; ++i) {
      putdata(written, i, 1, 2048);
      touched[static_cast<std::size_t>(i)] = true;
    }
    if (step % 4 == 3) read(begin, std::min(n, begin + 5));
  }
  read(0, n);
  index_t changed = 0, missed = 0;
  Kept now(n);
  copy(now.untyped(), kept);
  synchronize();
  for (index_t i = 0; i < n; ++i) {
    if (touched[static_cast<std::size_t>(i)]) {
      missed += now.getdata(i, 1) != 2048;
      continue;
    }
    for (int k = 0; k < now.elements; ++k) changed += now.getdata(i, k) != 0.1 * static_cast<double>(3 * i + k + 1);
  }
  EXPECT_EQ(changed, 0) << "elements of objects that nobody wrote";
  EXPECT_EQ(missed, 0) << "objects that were written";
}

struct HalfPositions : elasticity::NodePositionFormats<Host> {
  using x = format::Half<>;
};

template <class Space, class Layout>
void check_mirrors_of_different_formats() {
  using Position = elasticity::NodePositionObject;
  using Doubles = Array<Position, double, Host, Aos>;
  using Floats = Array<Position, float, Space, Layout>;
  using Halves = Array<Position, double, Space, Layout, HalfPositions>;
  for (const index_t n : {index_t{40}, mirror_block + 100}) {
    check_mirror_keeps_what_nobody_wrote<Mirror<Doubles, Floats>, Floats, Doubles>(Side::host, n);
    check_mirror_keeps_what_nobody_wrote<Mirror<Doubles, Halves>, Halves, Doubles>(Side::host, n);
    using HostFloats = Array<Position, float, Host, Soa>;
    using DeviceDoubles = Array<Position, double, Space, Layout>;
    check_mirror_keeps_what_nobody_wrote<Mirror<HostFloats, DeviceDoubles>, HostFloats, DeviceDoubles>(Side::device, n);
  }
}

/// Random writes and reads of ranges on both sides; whatever is read is what was last written.
template <class Space, class Layout>
void check_mirror_under_random_use() {
  using Object = elasticity::RestShapeObject;
  using Tested = Mirror<Array<Object, double, Host, Soa>, Array<Object, float, Space, Layout>>;
  std::mt19937 random(seed());
  for (const index_t n : {1, 31, 32, 33, 1000, 20000}) {
    MirrorCheck<Tested> check(n, random);
    std::uniform_int_distribution<index_t> any(0, n - 1);
    for (int step = 0; step < 12; ++step) {
      const index_t begin = any(random);
      const index_t end = std::min(n, begin + 1 + any(random) / 4);
      if (random() % 2 == 0) {
        (void)check.mirror().read_host(begin, end);
        check.write_host(begin, end, step);
      } else {
        (void)check.mirror().read_device(begin, end);
        check.write_device(begin, end, step);
      }
      if (step % 4 == 3) check.expect_host_up_to_date();
    }
    check.expect_device_up_to_date();
  }
}

/// The host array leaves the mirror, is changed, and comes back with another number of objects.
template <class Space, class Layout>
void check_mirror_of_objects_that_change_topology() {
  using Tested = Mirror<elasticity::TetArray<float, Host, Aosoa<8>>, elasticity::TetArray<float, Space, Layout>>;
  std::mt19937 random(seed());
  const index_t n = mirror_block + 100;
  Random<typename Tested::HostArray> tets(n, random);
  Tested mirror(tets.array);
  (void)mirror.read_device();
  (void)mirror.write_device();
  auto released = mirror.release_host();
  EXPECT_EQ(mirror.size(), 0);
  expect_sound(released, tets.model);
  const std::vector<index_t> erased = random_part(n, random);
  erase(released, erased);
  mirror = Tested(std::move(released));
  (void)mirror.read_device();
  (void)mirror.write_device();  // so that what comes back is the device's
  const Model expected = picked(tets.model, remaining(n, erased));
  expect_sound(mirror.release_host(), expected);
}

}  // namespace physgen::test
