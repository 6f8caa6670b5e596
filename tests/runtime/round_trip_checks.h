// Round trips through every layout of one space: one source for host, pinned and CUDA memory.
#pragma once

#include "precision_by_layout.h"

namespace physgen::test {

/// Sends random objects from a host Aos array to `Layout` in `Space` and back; every element must return bit for bit,
/// and elements looked at on the way must stand where the law of addresses puts them.
template <class Object, class Real, class Space, class Layout>
void check_round_trip(index_t n, std::mt19937& random) {
  using HostAos = Array<Object, Real, Host, Aos>;
  HostAos source(n);
  randomise(source, random);
  Array<Object, Real, Space, Layout> middle(n);
  copy(middle, source);
  HostAos back(n);
  poison(back);
  copy(back, middle);
  synchronize();
  ASSERT_EQ(count_different(source, back), 0)
      << Object::name << " n = " << n << " layout " << Layout::name << " space " << name(Space::kind);
  if (n == 0) return;
  for (const index_t i : {index_t{0}, n / 2, n - 1}) {
    for (int k = 0; k < HostAos::elements; ++k) ASSERT_EQ(source.getdata(i, k), middle.getdata(i, k));
  }
}

template <class Space, class Layout>
void check_round_trips_of_all_object_types() {
  using Even = EvenReal<Layout>;
  using Odd = OddReal<Layout>;
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 31, 32, 33, 1000003}) {
    check_round_trip<elasticity::NodePositionObject, Even, Space, Layout>(n, random);
    check_round_trip<elasticity::NodeStiffnessObject, Odd, Space, Layout>(n, random);
    check_round_trip<elasticity::TetObject, float, Space, Layout>(n, random);  // the same in both precisions
    check_round_trip<elasticity::IncidenceObject, float, Space, Layout>(n, random);
  }
  for (const index_t n : {0, 1, 31, 32, 33, 1003}) {
    check_round_trip<elasticity::DeformationSvdObject, Even, Space, Layout>(n, random);
    check_round_trip<elasticity::StressDerivativeObject, Odd, Space, Layout>(n, random);
    check_round_trip<elasticity::TetStiffnessObject, Even, Space, Layout>(n, random);
    check_round_trip<elasticity::RestShapeObject, Odd, Space, Layout>(n, random);
  }
}

/// Narrows double to float on the way and widens on the way back: what returns is the float nearest to the source.
template <class Space, class Layout>
void check_conversion_of_precision() {
  std::mt19937 random(seed());
  const index_t n = 1003;
  Array<elasticity::RestShapeObject, double, Host, Soa> source(n);
  std::uniform_real_distribution<double> value(-3, 3);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) source.putdata(i, k, value(random));
  }
  Array<elasticity::RestShapeObject, float, Space, Layout> narrow(n);
  copy(narrow, source);
  Array<elasticity::RestShapeObject, double, Host, Aos> back(n);
  poison(back);
  copy(back, narrow);
  synchronize();
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) {
      ASSERT_EQ(back.getdata(i, k), static_cast<double>(static_cast<float>(source.getdata(i, k))));
    }
  }
}

/// Converts between two layouts of one space directly.
template <class Space, class From, class To>
void check_layout_pair() {
  std::mt19937 random(seed());
  for (const index_t n : {1, 33, 517}) {
    using Object = elasticity::DeformationSvdObject;
    Array<Object, float, Host, Aos> source(n);
    randomise(source, random);
    Array<Object, float, Space, From> from(n);
    Array<Object, float, Space, To> to(n);
    copy(from, source);
    copy(to, from);
    Array<Object, float, Host, Aos> back(n);
    poison(back);
    copy(back, to);
    synchronize();
    ASSERT_EQ(count_different(source, back), 0) << From::name << " to " << To::name << " n = " << n;
  }
}

template <class Space, class From>
void check_all_pairs_from() {
  check_layout_pair<Space, From, Aos>();
  check_layout_pair<Space, From, AosPadded>();
  check_layout_pair<Space, From, Soa>();
  check_layout_pair<Space, From, Aosoa<8>>();
  check_layout_pair<Space, From, Aosoa<32>>();
}

/// Growing keeps the old objects and gives new ones initial values, also in memory that held others before.
template <class Space, class Layout>
void check_resize() {
  std::mt19937 random(seed());
  Array<elasticity::DeformationSvdObject, double, Host, Aos> source(45);
  randomise(source, random);
  Array<elasticity::DeformationSvdObject, double, Space, Layout> array(45);
  copy(array, source);
  array.resize(33);
  array.resize(1000);
  synchronize();
  ASSERT_EQ(array.size(), 1000);
  for (const index_t i : {0, 16, 31, 32}) {
    for (int k = 0; k < array.elements; ++k) ASSERT_EQ(array.getdata(i, k), source.getdata(i, k));
  }
  for (const index_t i : {33, 34, 44, 45, 999}) {
    for (int k = 0; k < array.elements; ++k) {  // U and V are the identity
      ASSERT_EQ(array.getdata(i, k), k < 18 && k % 9 % 4 == 0 ? 1.0 : 0.0) << "object " << i << " element " << k;
    }
  }
}

}  // namespace physgen::test
