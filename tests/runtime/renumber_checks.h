// Index fields under changes of topology in every layout of one space: one source for host, pinned and CUDA memory.
#pragma once

#include "topology_checks.h"

namespace physgen::test {

/// Tets over nodes: after a change of the nodes, renumbered tets have the same nodes as before.
template <class Space, class Layout>
void check_renumber() {
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 31, 32, 33, 1000, 5000}) {
    const index_t nodes = 2 * n + 3;
    elasticity::TetArray<double, Host, Aos> plain(n);
    std::uniform_int_distribution<int> node(0, static_cast<int>(nodes) - 1);
    for (index_t i = 0; i < n; ++i) {
      for (int k = 0; k < 4; ++k) plain.putdata(i, k, node(random));
    }
    elasticity::TetArray<double, Space, Layout> tets(n);
    copy(tets, plain);
    Model model = objects_of(tets);

    const std::vector<index_t> order = random_order(nodes, random);
    renumber(tets, "nodes", inverse(order));
    for (auto& tet : model) {
      for (double& v : tet) v = static_cast<double>(std::find(order.begin(), order.end(), v) - order.begin());
    }
    expect_sound(tets, model);

    // Nodes that no tet has go.
    std::vector<bool> used(static_cast<std::size_t>(nodes), false);
    for (const auto& tet : model) {
      for (const double v : tet) used[static_cast<std::size_t>(v)] = true;
    }
    std::vector<index_t> kept;
    for (index_t v = 0; v < nodes; ++v) {
      if (used[static_cast<std::size_t>(v)]) kept.push_back(v);
    }
    renumber(tets, "nodes", new_numbers(kept, nodes));
    for (auto& tet : model) {
      for (double& v : tet) v = static_cast<double>(std::lower_bound(kept.begin(), kept.end(), v) - kept.begin());
    }
    expect_sound(tets, model);
  }
}

/// A field among others of other sizes is renumbered; its neighbours stay.
template <class Space, class Layout>
void check_renumber_of_one_field_among_many() {
  std::mt19937 random(seed());
  const index_t n = 100;
  using Object = tissue::model::ShapesObject;
  Array<Object, float, Host, Aos> plain(n);
  randomise(plain, random);
  constexpr int first = 4;  // of nodes: behind a and v
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < 4; ++k) plain.putdata(i, first + k, static_cast<double>((i + k) % n));
  }
  Array<Object, float, Space, Layout> array(n);
  copy(array, plain);
  Model model = objects_of(array);
  const std::vector<index_t> numbers = random_order(n, random);
  renumber(array, "nodes", numbers);
  for (auto& object : model) {
    for (std::size_t k = first; k < first + 4; ++k) {
      object[k] = static_cast<double>(numbers[static_cast<std::size_t>(object[k])]);
    }
  }
  expect_sound(array, model);
}

/// An index behind rotations, which code counts as 9 elements and quaternions store as 4.
template <class Space, class Layout>
void check_renumber_behind_quaternions() {
  Array<IndexedFrameObject, float, Space, Layout> frames(40);
  for (index_t i = 0; i < 40; ++i) frames.putdata(i, 9, static_cast<double>(i));
  std::vector<index_t> numbers(40);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = 39 - static_cast<index_t>(i);
  renumber(frames, "node", numbers);
  for (index_t i = 0; i < 40; ++i) {
    EXPECT_EQ(frames.getdata(i, 9), static_cast<double>(39 - i));
    EXPECT_EQ(frames.getdata(i, 4), 1) << "the identity";
  }
  frames.putdata(17, 9, 40);
  EXPECT_NE(message_of([&] {
              renumber(frames, "node", numbers);
            }).find("object 17 has the index 40 as element 0 of 1: there are new numbers for 40 objects only"),
            std::string::npos);
}

template <class Space, class Layout>
void check_refused_renumbering() {
  elasticity::TetArray<float, Space, Layout> tets(5000);
  tets.putdata(4711, 2, 7);
  tets.putdata(4712, 0, 8);
  const Model model = objects_of(tets);
  std::vector<index_t> numbers(9, 3);
  const auto expect = [&](std::string_view field, const std::string& part) {
    const std::string message = message_of([&] { renumber(tets, field, numbers); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
    expect_sound(tets, model);
  };
  expect("corners", "there is no field of indices \"corners\"; there are: nodes");
  numbers[7] = -1;
  expect("nodes", "object 4711 has the index 7 as element 2 of 4: that object is gone");
  numbers[7] = index_t{1} << 31;
  expect("nodes",
         "object 4711 has the index 7 as element 2 of 4: its new number 2147483648 is more than an index can hold");
  numbers.resize(7);
  expect("nodes", "object 4711 has the index 7 as element 2 of 4: there are new numbers for 7 objects only");
  tets.putdata(17, 3, -1);
  EXPECT_NE(message_of([&] { renumber(tets, "nodes", numbers); }).find("object 17 has the index -1 as element 3 of 4"),
            std::string::npos);
  elasticity::NodePositionArray<float, Space, Layout> nodes(3);
  EXPECT_NE(message_of([&] { renumber(nodes, "x", numbers); }).find("the object has none"), std::string::npos);
}

}  // namespace physgen::test
