// The arrays of a scene on several ranks, as physgen writes them: what they know, and wrong calls, with the remedy.
#include <gtest/gtest.h>
#include <physgen/arrays/local_array.h>
#include <physgen/row_arrays.h>
#include <relax.distributed.h>

namespace physgen {
namespace {

using Relax = scenes::relax_scene::Distributed<>;
using EndsOfNodes = RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>>;
using End = elasticity::Incidence<float>;

std::string message_of(const auto& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

/// A chain of nodes, each tied to the next.
class ScenesOfRanks : public testing::Test {
 protected:
  static constexpr index_t nodes = 5, edges = 4;
  static std::vector<End> row(index_t node) {
    std::vector<End> ends;
    for (const index_t edge : {node - 1, node}) {
      if (edge < 0 || edge >= edges) continue;
      ends.emplace_back();
      ends.back().element = static_cast<std::int32_t>(edge);
      ends.back().local = edge == node ? 0 : 1;
    }
    return ends;
  }
  static elasticity::NodePosition<float> position(index_t node) {
    elasticity::NodePosition<float> value{};
    value.x[0] = static_cast<float>(node);
    return value;
  }
  void connect(Relax& to) const {
    to.connect(to.edges, [](index_t e) { return std::array{e, e + 1}; });
    to.connect(to.ranges, to.ends, row);
  }

  int argc = 0;
  char** argv = nullptr;
  Ranks ranks{argc, argv};
  Relax body{ranks, {.node = nodes, .edge = edges, .end = 2 * edges}};
};

TEST_F(ScenesOfRanks, know_sets_fields_and_rows_by_the_arrays) {
  connect(body);
  body.cut();
  EXPECT_EQ(body.positions.size(), nodes);
  EXPECT_EQ(body.springs.size(), edges);
  EXPECT_EQ(body.ends.size(), 2 * edges);
  EXPECT_EQ(body.state.size(), 1);
  EXPECT_EQ(body.objects_of(body.springs).owned(), edges);
  for (index_t e = 0; e < edges; ++e) {
    EXPECT_EQ(body.edges.const_view()[e].nodes()[0], e);
    EXPECT_EQ(body.edges.const_view()[e].nodes()[1], e + 1);
  }
  EXPECT_EQ(body.ranges.const_view()[index_t{1}].begin(), 1);
  EXPECT_EQ(body.ranges.const_view()[index_t{1}].end(), 3);
  EXPECT_EQ(body.ends.const_view()[index_t{2}].element(), 1);
  const DistributedArrays& arrays = body;
  EXPECT_EQ(arrays.sets().size(), 4U) << "node, edge, 1 object and the ends";
  EXPECT_EQ(arrays.uses().size(), std::size(scenes::relax_scene::halos));
}

TEST_F(ScenesOfRanks, take_and_give_values_of_all_objects) {
  connect(body);
  body.cut();
  body.fill(body.positions, position);
  index_t seen = 0;
  body.each_block(body.positions, [&](index_t first, auto view) {
    for (index_t i = 0; i < view.size(); ++i) EXPECT_EQ(view[i].x()[0], static_cast<float>(first + i));
    seen += view.size();
  });
  EXPECT_EQ(seen, nodes);
  elasticity::NodePositionArray<double> all(nodes);
  for (index_t i = 0; i < nodes; ++i) all[i].x()[0] = 10.0 * static_cast<double>(i);
  body.fill(body.positions, all);
  EXPECT_EQ(body.whole(body.positions)[index_t{3}].x()[0], 30.0F);
  EXPECT_EQ(body.whole(body.edges).size(), edges);
  body.state[index_t{0}].f()[1] = 7.0;
  body.each_block(body.state, [](index_t, auto view) { EXPECT_EQ(view[index_t{0}].f()[1], 7.0); });
}

TEST_F(ScenesOfRanks, take_rows_from_arrays_of_rows) {
  std::vector<std::vector<End>> lists;
  for (index_t node = 0; node < nodes; ++node) lists.push_back(row(node));
  const EndsOfNodes rows = EndsOfNodes::from_lists({"element", edges}, lists);
  body.connect(body.edges, [](index_t e) { return std::array{e, e + 1}; });
  const EndsOfNodes few = EndsOfNodes::from_lists({"element", edges}, std::span(lists).first(2));
  EXPECT_EQ(message_of([&] { body.connect(body.ranges, body.ends, few); }),
            "physgen: body.ranges: 2 rows are given for a set node of 5 objects; give the rows of all objects");
  body.connect(body.ranges, body.ends, rows);
  body.cut();
  for (index_t i = 0; i < nodes; ++i) {
    EXPECT_EQ(body.ranges.const_view()[i].begin(), rows.ranges()[i].begin());
    EXPECT_EQ(body.ranges.const_view()[i].end(), rows.ranges()[i].end());
  }
  for (index_t k = 0; k < rows.entries().size(); ++k) {
    EXPECT_EQ(body.ends.const_view()[k].element(), rows.entries()[k].element());
    EXPECT_EQ(body.ends.const_view()[k].local(), rows.entries()[k].local());
  }
}

TEST_F(ScenesOfRanks, keep_rows_that_are_given_as_a_temporary) {
  const auto rows = [](index_t first) {
    std::vector<std::vector<End>> lists;
    for (index_t node = 0; node < nodes; ++node) lists.push_back(row(first + node));
    return EndsOfNodes::from_lists({"element", edges}, lists);
  };
  const EndsOfNodes wanted = rows(0);
  body.connect(body.edges, [](index_t e) { return std::array{e, e + 1}; });
  body.connect(body.ranges, body.ends, rows(0));
  std::vector<EndsOfNodes> others(4);  // in the memory that a temporary would leave
  for (EndsOfNodes& other : others) other = rows(2);
  body.cut();
  for (index_t i = 0; i < nodes; ++i) EXPECT_EQ(body.ranges.const_view()[i].end(), wanted.ranges()[i].end());
}

TEST_F(ScenesOfRanks, may_have_no_objects_but_not_a_number_that_is_not_given) {
  Relax none(ranks, {.node = 0, .edge = 0});
  connect(none);
  none.cut();
  EXPECT_EQ(none.positions.size(), 0);
  EXPECT_EQ(none.whole(none.positions).size(), 0);
  EXPECT_EQ(message_of([&] { Relax(ranks, {.node = 3}); }),
            "physgen: the number of objects of set edge is not given; give it with the others, {.edge = ...}");
  EXPECT_EQ(message_of([&] { Relax(ranks, {.node = -3, .edge = 1}); }),
            "physgen: set node has -3 objects; give a number that is not negative");
}

TEST_F(ScenesOfRanks, refuse_calls_out_of_order_with_the_remedy) {
  const auto two = [](index_t e) { return std::array{e, e + 1}; };
  EXPECT_EQ(message_of([&] { body.cut(); }),
            "physgen: body.edges.nodes names objects of node, and it is not known which; call connect(body.edges, ...) "
            "before cut()");
  body.connect(body.edges, two);
  EXPECT_EQ(
      message_of([&] { body.cut(); }),
      "physgen: the rows of body.ranges name objects of edge, and it is not known which; call connect(body.ranges, "
      "body.ends, ...) before cut()");
  EXPECT_EQ(message_of([&] { body.connect(body.edges, two); }),
            "physgen: body.edges.nodes is connected a second time; connect each field once");
  EXPECT_EQ(message_of([&] { body.connect(body.edges, "node", two); }),
            "physgen: body.edges names no objects by a field node; it does by nodes");
  EXPECT_EQ(
      message_of([&] { body.connect(body.forces, two); }),
      "physgen: body.forces names no objects by a field that the program reads; write names(\"...\", \"...\") where "
      "the scene declares it, or do not connect it");
  EXPECT_EQ(
      message_of([&] { body.connect(body.ends, two); }),
      "physgen: body.ends are the entries of the rows of body.ranges; connect both, connect(body.ranges, body.ends, "
      "...)");
  EXPECT_EQ(
      message_of([&] { body.connect(body.forces, body.ends, row); }),
      "physgen: body.forces and body.ends are no rows that the program reads; it reads body.ranges with body.ends");
  const elasticity::EdgeArray<float> other(1);
  EXPECT_EQ(message_of([&] { body.connect(other, two); }),
            "physgen: an array is none of those of the scene; give a member of the struct whose function this is");
  body.connect(body.ranges, body.ends, row);
  EXPECT_EQ(message_of([&] { body.connect(body.ranges, body.ends, row); }),
            "physgen: body.ends are connected a second time; connect the rows once");
  EXPECT_EQ(message_of([&] { body.fill(body.positions, position); }),
            "physgen: set node has no local numbers; call cut() first, and ask for sets of objects");
  EXPECT_EQ(message_of([&] { DistributedExecutor<HostExecutor>(ranks, body); }),
            "physgen: the arrays of ranks have no objects before cut(); call cut() behind the last connect(), and then "
            "make the executor");
  body.cut();
  EXPECT_EQ(message_of([&] { body.connect(body.edges, two); }),
            "physgen: body.edges is connected behind cut(); connect all arrays before it");
  EXPECT_EQ(message_of([&] { body.connect(body.ranges, body.ends, row); }),
            "physgen: body.ends are connected behind cut(); connect all arrays before it");
  EXPECT_EQ(message_of([&] { body.cut(); }), "physgen: cut() was called a second time; make other arrays");
}

TEST_F(ScenesOfRanks, compare_rows_with_the_number_of_their_entries) {
  Relax other(ranks, {.node = nodes, .edge = edges, .end = 9});
  connect(other);
  EXPECT_EQ(message_of([&] { other.cut(); }),
            "physgen: the rows of body.ranges have 8 entries, and body.ends was said to have 9; correct one of them");
}

/// As physgen writes it of a scene whose edges have one length, and forces that only joined steps use.
struct OfOneLength : DistributedScene {
  elasticity::EdgeArray<float> edges;
  UniformArray<elasticity::RestShapeArray<float>> rest;
  LocalArray<elasticity::NodeForceArray<float>, OfOneLength> local;
  static constexpr HaloUse uses[] = {{"Volumes", 0, "volume", {.reads_own = true}}};
  explicit OfOneLength(const Ranks& ranks) : DistributedScene(ranks, uses) {
    scene_.add_set("edge", 70);
    scene_.add_set("node", 71);
    scene_.add_array("body.edges", "edge", edges);
    scene_.add_array("body.rest", "edge", rest);
    scene_.add_array("body.local", "edge", local);
    scene_.names(edges, "nodes", "node");
  }
};

TEST_F(ScenesOfRanks, give_arrays_that_hold_no_objects_the_size_of_their_set) {
  OfOneLength one(ranks);
  one.connect(one.edges, "nodes", [](index_t e) { return std::array{e, e + 1}; });
  one.cut();
  EXPECT_EQ(one.rest.size(), 70);
  EXPECT_EQ(one.local.size(), 70);
  one.fill(one.rest, [](index_t) {
    elasticity::RestShape<float> value{};
    value.volume = 0.5F;
    return value;
  });
  EXPECT_EQ(one.rest.const_view()[index_t{69}].volume(), 0.5F);
  // A step of one record is over the set that has it, of which each rank does its own part.
  const auto view = one.rest.const_view();
  for (const std::string name : {"Volumes", "not in the table"}) {
    HaloSteps steps(one, true);
    const HaloSteps::Kernel kernel{&name, {{view.untyped().base, view.size(), false, "rest"}}};
    EXPECT_EQ(steps.begin(std::span(&kernel, 1), 70, HaloSteps::Way::reduce).set, &one.objects_of(one.edges)) << name;
  }
}

}  // namespace
}  // namespace physgen
