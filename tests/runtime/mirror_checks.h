// Copies of ranges and mirrors between host arrays and every layout of one space: one source for host and CUDA memory.
#pragma once

#include <physgen/mirror.h>

#include "topology_checks.h"

namespace physgen::test {

/// Expects the bytes of the objects of a range in the form of one of two arrays, with or without what lies between
/// them: padding of records and the rest of the last tile.
template <class A, class B>
void expect_bytes(index_t bytes, const A& a, const B& b, index_t begin, index_t end) {
  if (begin == end) {
    EXPECT_EQ(bytes, 0);
    return;
  }
  const auto object_bytes = [](const UntypedArray& untyped) {
    index_t elements = 0;
    for (const FieldInfo& field : untyped.fields) elements += field.count * element_bytes(field.type);
    return elements;
  };
  const UntypedArray x = a.untyped(), y = b.untyped();
  const index_t tiles = align_up(end, index_t{64}) - begin / 64 * 64;
  EXPECT_GE(bytes, (end - begin) * std::min(object_bytes(x), object_bytes(y)));
  const bool all = begin == 0 && end == x.size;
  EXPECT_LE(bytes, all ? std::max(x.bytes(), y.bytes()) : tiles * std::max(x.record_bytes, y.record_bytes));
}

/// Copies random ranges both ways; objects of the range arrive, all others stay.
template <class Object, class HostArray, class DeviceArray>
void check_ranges_between(index_t n, std::mt19937& random) {
  Random<HostArray> host(n, random);
  Random<DeviceArray> device(n, random);
  std::uniform_int_distribution<index_t> any(0, n);
  std::vector<std::pair<index_t, index_t>> ranges = {{0, n}, {0, n / 2}, {n / 2, n}, {n / 3, n / 3}, {0, n / 64 * 64}};
  for (int r = 0; r < 4; ++r) ranges.push_back(std::minmax({any(random), any(random)}));
  bool to_device = true;
  for (const auto& [begin, end] : ranges) {
    const auto copy_part = [begin = begin, end = end](const Model& from, Model& to) {
      std::copy(from.begin() + begin, from.begin() + end, to.begin() + begin);
    };
    if (to_device) {
      randomise_objects(host.array, random);
      host.model = objects_of(host.array);
      const index_t bytes = copy_range(device.array.untyped(), host.array.untyped(), begin, end);
      copy_part(host.model, device.model);
      expect_bytes(bytes, host.array, device.array, begin, end);
    } else {
      randomise_objects(device.array, random);
      device.model = objects_of(device.array);
      const index_t bytes = copy_range(host.array.untyped(), device.array.untyped(), begin, end);
      copy_part(device.model, host.model);
      expect_bytes(bytes, host.array, device.array, begin, end);
    }
    synchronize();
    expect_sound(host.array, host.model);
    expect_sound(device.array, device.model);
    to_device = !to_device;
  }
}

template <class Space, class Layout>
void check_ranges() {
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 31, 32, 33, 1000, 5000}) {
    // The same bytes on both sides, then other layouts, then another precision (the values are floats).
    using Tet = elasticity::TetObject;
    check_ranges_between<Tet, Array<Tet, float, Host, Layout>, Array<Tet, float, Space, Layout>>(n, random);
    check_ranges_between<Tet, Array<Tet, float, Host, Aos>, Array<Tet, float, Space, Layout>>(n, random);
    check_ranges_between<Tet, Array<Tet, float, Host, Soa>, Array<Tet, float, Space, Layout>>(n, random);
    using Shape = elasticity::RestShapeObject;
    check_ranges_between<Shape, Array<Shape, double, Host, Aosoa<8>>, Array<Shape, float, Space, Layout>>(n, random);
  }
  for (const index_t n : {33, 500}) {
    using Mixed = tissue::model::ShapesObject;
    check_ranges_between<Mixed, Array<Mixed, float, Host, Layout>, Array<Mixed, float, Space, Layout>>(n, random);
    check_ranges_between<Mixed, Array<Mixed, double, Host, Soa>, Array<Mixed, float, Space, Layout>>(n, random);
    using Derivative = elasticity::StressDerivativeObject;  // of 2, 4 and 8 bytes
    check_ranges_between<Derivative, Array<Derivative, float, Host, Layout, MixedDerivative>,
                         Array<Derivative, float, Space, Layout, MixedDerivative>>(n, random);
    using Nested = tissue::other::PatchObject;
    check_ranges_between<Nested, Array<Nested, float, Host, Aosoa<32>>, Array<Nested, float, Space, Layout>>(n, random);
  }
}

/// Between arrays of different sizes, as Soa pitches then differ.
template <class Space, class Layout>
void check_ranges_of_different_sizes() {
  std::mt19937 random(seed());
  Random<elasticity::TetArray<float, Host, Layout>> host(700, random);
  Random<elasticity::TetArray<float, Space, Layout>> device(1300, random);
  copy_range(device.array.untyped(), host.array.untyped(), 100, 700);
  synchronize();
  std::copy(host.model.begin() + 100, host.model.end(), device.model.begin() + 100);
  expect_sound(device.array, device.model);
  const auto storages = std::pair(device.array.untyped(), host.array.untyped());
  for (const auto& [begin, end] : {std::pair(-1, 3), std::pair(5, 4), std::pair(0, 701)}) {
    EXPECT_THROW(copy_range(storages.first, storages.second, begin, end), Error) << begin << " to " << end;
  }
  expect_sound(device.array, device.model);
}

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
