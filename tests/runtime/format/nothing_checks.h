// Arrays that prune fields, held against arrays that store all of them: one source for host, pinned and CUDA memory.
#pragma once

#include <physgen/gather.h>
#include <physgen/mirror.h>
#include <physgen/topology.h>

#include "format_checks.h"
#include "nothing_formats.h"

namespace physgen::test {

/// Calls check(k, field) for element numbers 0, 1, ... as code counts them.
template <class Check>
void for_each_element(const UntypedArray& untyped, const Check& check) {
  int k = 0;
  for (const FieldInfo& field : untyped.fields) {
    for (int e = 0; e < field.visible_count(); ++e) check(k++, field);
  }
}

/// Expects that `part` holds what it stores of the objects of `full`, under the same numbers, and refuses the rest by
/// name. Both on the host.
inline void expect_part(const UntypedArray& part, const UntypedArray& full) {
  ASSERT_EQ(part.size, full.size);
  ASSERT_EQ(part.fields.size(), full.fields.size());
  for (index_t i = 0; i < part.size; ++i) {
    for_each_element(part, [&](int k, const FieldInfo& field) {
      if (field.is_stored()) {
        ASSERT_EQ(getdata(part, i, k), getdata(full, i, k)) << field.name << ", element " << k << " of object " << i;
      } else if (i == 0) {
        const std::string name = "nothing is stored of " + std::string(field.name) + ":";
        ASSERT_NE(message_of([&] { (void)getdata(part, 0, k); }).find(name), std::string::npos) << k;
        ASSERT_NE(message_of([&] { putdata(part, 0, k, 1); }).find(name), std::string::npos) << k;
      }
    });
  }
}

/// Expects that of a poisoned array nothing but the stored elements of some objects has been written.
inline void expect_only_stored_elements_written(const UntypedArray& untyped, const std::vector<bool>& objects) {
  std::vector<bool> stored(static_cast<std::size_t>(untyped.bytes()), false);
  for (index_t i = 0; i < untyped.size; ++i) {
    if (!objects[static_cast<std::size_t>(i)]) continue;
    for (const FieldInfo& field : untyped.fields) {
      const int size = element_bytes(field.type);
      for (int k = 0; k < field.count; ++k) {
        const index_t at = address_by_law(field.offset + k * size, i, untyped.pitch, untyped.record_bytes, size);
        for (int b = 0; b < size; ++b) stored[static_cast<std::size_t>(at + b)] = true;
      }
    }
  }
  for (index_t b = 0; b < untyped.bytes(); ++b) {
    if (!stored[static_cast<std::size_t>(b)]) {
      ASSERT_EQ(untyped.base[b], std::byte{0xA5}) << "byte " << b;
    }
  }
}

/// `array` in its formats, where the host reads it.
template <class Object, class Real, class Space, class Layout, class Formats>
Array<Object, Real, Host, Aos, Formats> on_host(const Array<Object, Real, Space, Layout, Formats>& array) {
  Array<Object, Real, Host, Aos, Formats> there(array.size());
  copy(there, array);
  synchronize();
  return there;
}
template <class Part, class Full>
void expect_part_of(const Part& part, const Full& full) {
  expect_part(on_host(part).untyped(), full.untyped());
}

/// Random objects as `Formats` keep them, every field of them stored: `Formats` with what it prunes as in `Full`.
template <class Object, class Real, class Full>
Array<Object, Real, Host, Aos, Full> random_objects(index_t n, std::mt19937& random) {
  Array<Object, Real, Host, Aos> drawn(n);
  randomise(drawn, random);
  Array<Object, Real, Host, Aos, Full> objects(n);
  copy(objects, drawn);
  return objects;
}

/// Copies from arrays that store all fields, and between arrays that store the same part in other layouts.
/// @tparam Full the formats of what `Formats` stores, and any for the rest
template <class Object, class Real, class Space, class Layout, class Formats, class Full>
void check_copies(index_t n, std::mt19937& random) {
  const auto full = random_objects<Object, Real, Full>(n, random);
  Array<Object, Real, Space, Layout, Full> full_there(n);
  copy(full_there, full);
  Array<Object, Real, Host, Soa, Formats> from_host(n);
  copy(from_host, full);
  Array<Object, Real, Space, Layout, Formats> from_full(n), from_there(n), from_part(n);
  copy(from_full, full);
  copy(from_there, full_there);
  copy(from_part, from_host);
  expect_part_of(from_host, full);
  expect_part_of(from_full, full);
  expect_part_of(from_there, full);
  expect_part_of(from_part, full);
  const Array<Object, Real, Space, Layout, Formats> same(from_part);
  expect_part_of(same, full);
  Array<Object, Real, Space, Aosoa<16>, Formats> other_layout(n);
  copy(other_layout, from_full);
  expect_part_of(other_layout, full);
  EXPECT_EQ(losses_of_copy(from_part.untyped(), full_there.untyped()).falsified(), 0U);
}

/// Changes of topology do with what is stored as they do with all.
template <class Object, class Real, class Space, class Layout, class Formats, class Full>
void check_topology(index_t n, std::mt19937& random) {
  auto full = random_objects<Object, Real, Full>(n, random);
  Array<Object, Real, Space, Layout, Formats> part(n);
  copy(part, full);
  const auto both = [&](const auto& change) {
    change(full);
    change(part);
    expect_part_of(part, full);
  };
  std::vector<index_t> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), index_t{0});
  std::shuffle(order.begin(), order.end(), random);
  both([&](auto& array) { permute(array, order); });
  order.resize(order.size() / 2);
  both([&](auto& array) { erase(array, order); });
  both([&](auto& array) { append(array, 37); });
  const auto more = random_objects<Object, Real, Full>(n, random);
  both([&](auto& array) { append(array, more); });
  both([&](auto& array) { append(array, array); });
  both([&](auto& array) { array.resize(n + 70); });
  both([&](auto& array) { array.resize(n / 3); });
}

/// An array of which nothing is stored is one of so many objects, and of no bytes.
template <class Space, class Layout>
void check_only_pruned_fields() {
  using Object = elasticity::DeformationSvdObject;
  using Empty = Array<Object, float, Space, Layout, NoSvd>;
  static_assert(Empty::record_bytes == 0 && Empty::elements == 21);
  constexpr index_t of_counters = checked_build ? index_t{sizeof(Losses)} : 0;
  Array<Object, float, Host, Soa> svds(70);
  Empty empty(70);
  EXPECT_EQ(empty.size(), 70);
  EXPECT_EQ(empty.bytes(), of_counters);
  EXPECT_EQ(empty.untyped().bytes(), 0);
  copy(empty, svds);
  Empty duplicate(empty);
  EXPECT_EQ(duplicate.size(), 70);
  copy(duplicate, empty);
  EXPECT_EQ(losses_of_copy(empty.untyped(), svds.untyped()).falsified(), 0U);
  EXPECT_EQ(empty.take_losses().falsified(), 0U);
  empty.resize(1000);
  EXPECT_EQ(empty.size(), 1000);
  EXPECT_EQ(empty.bytes(), of_counters);
  permute(duplicate, inverse(remaining(70, {})));
  append(duplicate, svds);
  EXPECT_EQ(duplicate.size(), 140);
  const std::vector<index_t> erased{3, 139};
  erase(duplicate, erased);
  EXPECT_EQ(duplicate.size(), 138);
  gather_by(duplicate, 33, [&](index_t i) noexcept { return svds.const_view().get(i); });
  EXPECT_EQ(duplicate.size(), 33);
  EXPECT_NE(message_of([&] { (void)empty.getdata(0, 20); }).find("nothing is stored of s:"), std::string::npos);
  EXPECT_NE(message_of([&] { (void)empty.getdata(1000, 0); }).find("there is no object 1000"), std::string::npos);
  EXPECT_THROW(empty.resize(-1), Error);
  empty.resize(0);
  EXPECT_EQ(empty.size(), 0);
  EXPECT_EQ(empty.bytes(), of_counters);
  empty.shrink_to_fit();
  EXPECT_EQ(empty.bytes(), 0);
}

/// A field written on one side of a mirror arrives on the other as far as that stores it; one that it does not store
/// never comes back.
template <class DeviceSpace, class Layout>
void check_mirror() {
  using Object = elasticity::DeformationSvdObject;
  std::mt19937 random(seed());
  const auto full = random_objects<Object, float, elasticity::DeformationSvdFormats<Host>>(100, random);
  Mirror<Array<Object, float, Host, Aos>, Array<Object, float, DeviceSpace, Layout, StretchesOnly>> mirror{
      Array<Object, float, Host, Aos>(full)};
  (void)mirror.read_device();
  EXPECT_GE(mirror.bytes_moved(), 100 * 12);
  EXPECT_NO_THROW((void)mirror.read_host()) << "nothing is newer on the device";
  (void)mirror.write_device(3, 5);
  const std::string refused = message_of([&] { (void)mirror.read_host(); });
  EXPECT_NE(refused.find("U is stored in the target of the copy"), std::string::npos) << refused;
  Mirror<Array<Object, float, Host, Aos, StretchesOnly>, Array<Object, float, DeviceSpace, Layout, StretchesOnly>> both(
      40);
  both.write_host(7, 8)[7].s() = Eigen::Vector3f(1, 2, 3);
  (void)both.read_device();
  (void)both.write_device(7, 8);
  const Eigen::Vector3f s = both.read_host()[7].s();
  EXPECT_EQ(s, Eigen::Vector3f(1, 2, 3));
}

/// Gathered objects leave out what the array prunes.
template <class Space, class Layout>
void check_gather() {
  using Object = elasticity::DeformationSvdObject;
  std::mt19937 random(seed());
  const auto full = random_objects<Object, float, elasticity::DeformationSvdFormats<Host>>(1003, random);
  Array<Object, float, Space, Layout, StretchesOnly> part;
  gather_by(part, full.size(), [&](index_t i) noexcept { return full.const_view().get(i); });
  expect_part_of(part, full);
  gather_by(part, full.size(), [&](index_t i) noexcept { return full.const_view().get(full.size() - 1 - i); });
  std::vector<index_t> backwards(1003);
  for (std::size_t i = 0; i < backwards.size(); ++i) backwards[i] = 1002 - static_cast<index_t>(i);
  auto turned = full;
  permute(turned, backwards);
  expect_part_of(part, turned);
}

/// Every way over arrays without their types refuses what it would have to make up or to lose, before it changes any.
template <class Space>
void check_refusals() {
  using Object = elasticity::DeformationSvdObject;
  elasticity::DeformationSvdArray<float, Host, Soa> full(40);
  Array<Object, float, Space, Aosoa<32>> full_there(40);
  Array<Object, float, Space, Aosoa<32>, StretchesOnly> part(40);
  Array<Object, float, Space, Aosoa<32>, LostStretches> lost(40);
  const auto refuses = [](const auto& action, const std::string& words) {
    const std::string message = message_of(action);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  for (const UntypedArray& whole : {full.untyped(), full_there.untyped()}) {
    if (host_accessible(whole.space)) poison(whole);
    const std::string from_part = "cannot copy elasticity::DeformationSvd[40] in " + std::string(name(Space::kind)) +
                                  " memory to elasticity::DeformationSvd[40] in " + std::string(name(whole.space)) +
                                  " memory: U is stored in the target of the copy";
    refuses([&] { copy(whole, part.untyped()); }, from_part);
    refuses([&] { copy_range(whole, part.untyped(), 3, 4); }, from_part);
    refuses([&] { copy_range(whole, part.untyped(), 3, 3); }, from_part);
    refuses([&] { copy_range(whole, part.untyped(), 0, 3); }, from_part);
    refuses([&] { (void)losses_of_copy(whole, part.untyped()); }, from_part);
    const std::string would_be_lost = "s would be lost: the target of the copy does not store it";
    refuses([&] { copy(lost.untyped(), whole); }, would_be_lost);
    refuses([&] { copy_range(lost.untyped(), whole, 3, 4); }, would_be_lost);
    refuses([&] { (void)losses_of_copy(lost.untyped(), whole); }, would_be_lost);
    if (host_accessible(whole.space)) {
      for (index_t b = 0; b < whole.bytes(); ++b) ASSERT_EQ(whole.base[b], std::byte{0xA5});
    }
  }
  EXPECT_NO_THROW(copy(part.untyped(), full.untyped()));
  const auto another = lost;  // of an array of its own kind nothing is lost
  EXPECT_EQ(another.size(), 40);
  refuses([&] { renumber(part, "U", remaining(40, {})); }, "nothing is stored of U");
  Array<elasticity::TetObject, float, Space, Aosoa<32>, NoNodes> tets(4);
  refuses([&] { renumber(tets, "nodes", remaining(4, {})); },
          "elasticity::Tet[4] in " + std::string(name(Space::kind)) +
              " memory: its indices are needed, but nothing is stored of nodes: ");
  refuses([&] { renumber(tets, "corners", remaining(4, {})); }, "there is no field of indices \"corners\"");
}

}  // namespace physgen::test
