// Arrays of scenes on several ranks: the header of several groups, letter by letter, and what cannot have one, with the
// remedy. The header of a real scene stands in golden/relax.distributed.h.
#include "scenes/distribution.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "by_hand.h"
#include "scenes/report_halos.h"

namespace physgen::test {
namespace {

using scenes::Field;
using scenes::Needs;
using scenes::Scene;

const Field index_of_two{"nodes", "int32", 2, 8, false}, number{"code", "int32", 1, 4, false};

/// Edges name nodes and follow them; the rows of nodes have ends, which name edges. And numbers that all ranks keep.
Scene distributed_springs() {
  Scene scene;
  scene.name = "springs";
  scene.scope = "scenes";
  scene.include = "scenes/springs.h";
  scene.real = "float";
  scenes::Group body{"Body", "body", "", {}, {}};
  body.arrays = {
      array("x", "m::Position", "node", {{"x", "float32", 3, 12, false}}),
      array("edges", "m::Edge", "edge", {index_of_two}),
      array("ranges", "m::Range", "node", {{"begin", "int32", 1, 4, false}, {"end", "int32", 1, 4, false}}),
      array("ends", "m::End", "end", {number}),
      array("state", "m::State", "", {{"sum", "float64", 1, 8, false}}),
  };
  for (const std::size_t input : {0, 1, 2, 3}) body.arrays[input].input = scenes::Selection{true, {}, {}};
  body.arrays[1].names = {{"nodes", "node", 0, {}}};
  body.arrays[1].follows = "node";
  body.arrays[3].names = {{"code", "edge", 2, {}}};
  body.arrays[4].count = 1;
  scene.groups.push_back(std::move(body));
  return scene;
}

/// Needs of a program that reads all fields.
Needs needs_of(const Scene& scene,
               std::vector<std::pair<std::string, std::string>> rows = {{"body.ranges", "body.ends"}}) {
  Needs needs;
  for (const scenes::Group& group : scene.groups)
    for (const scenes::Array& one : group.arrays) {
      needs.arrays.push_back({group.full_name(one), {}, false, {}, -1});
      for (const Field& field : one.fields) needs.arrays.back().fields.push_back({field, true, {}, {}, ""});
    }
  needs.halos.stated = true;
  needs.halos.rows = std::move(rows);
  return needs;
}

std::string refused(const Scene& scene,
                    std::vector<std::pair<std::string, std::string>> rows = {{"body.ranges", "body.ends"}}) {
  return scenes::find_distribution(scene, needs_of(scene, std::move(rows))).refused;
}

TEST(Distribution, is_sets_and_what_names_what) {
  const scenes::Distribution found = scenes::find_distribution(distributed_springs(), needs_of(distributed_springs()));
  EXPECT_EQ(found.refused, "");
  EXPECT_EQ(found.sets,
            (std::vector<scenes::Distribution::Set>{{"node", "", false}, {"edge", "node", false}, {"end", "", true}}));
  EXPECT_EQ(found.names, (std::vector<scenes::Distribution::IndexField>{{"body.edges", "nodes", "node"}}));
  EXPECT_EQ(found.rows, (std::vector<scenes::Distribution::Rows>{{"body.ranges", "body.ends", "code", "edge", 2}}));
}

TEST(Distribution, of_several_groups_has_them_as_members) {
  Scene scene = distributed_springs();
  scene.real.clear();
  scenes::Group work{"Work", "work", "", {array("f", "m::Force", "node", {{"f", "float32", 3, 12, false}})}, {}};
  scene.groups.push_back(std::move(work));
  const Needs needs = needs_of(scene);
  EXPECT_EQ(
      scenes::distributed_header(scene, needs, scenes::find_distribution(scene, needs)),
      R"(// Arrays of the scene springs for several ranks. Written by physgen from scenes/springs.h and the kernels that it runs:
// change these, not this file.
#pragma once

#include <physgen/distributed/distributed_scene.h>

#include <utility>

#include "springs.halos.h"
#include "springs.program.h"

namespace scenes::springs_scene {

/// The arrays of this rank, and what crosses to others: the scene's groups, with the functions of
/// physgen::DistributedScene.
template <class Space_ = physgen::Host, class Stored_ = physgen::StoredAsDeclared>
  requires physgen::SpaceOfRanks<Space_>
struct Distributed : physgen::DistributedScene {
  Body<Space_, Stored_> body;
  Work<Space_, Stored_> work;

  /// How many objects all ranks together have of each kind.
  struct Counts {
    physgen::index_t node = not_given;
    physgen::index_t edge = not_given;
    /// Of entries; if given, it is compared with the rows.
    physgen::index_t end = not_given;
  };

  /// @throw physgen::Error when a number of objects is not given or is negative
  Distributed(const physgen::Ranks& ranks, const Counts& counts) : DistributedScene(ranks, halos) {
    scene_.add_set("node", counts.node);
    scene_.add_set("edge", counts.edge);
    scene_.follow("edge", "node");
    scene_.add_array("body.x", "node", this->body.x);
    scene_.add_array("body.edges", "edge", this->body.edges);
    scene_.add_array("body.ranges", "node", this->body.ranges);
    scene_.add_array("body.state", scene_.set_of_all(1), this->body.state, {"sum"});
    scene_.add_array("work.f", "node", this->work.f, {"f"});
    scene_.names(this->body.edges, "nodes", "node");
    scene_.rows(this->body.ranges, "body.ends", this->body.ends, "code", "edge", 2, counts.end);
  }
};

/// The scene's program over them; `on` is a DistributedExecutor of theirs.
template <class On, class Space, class Stored, class... Parameters>
void program(On& on, Distributed<Space, Stored>& all, Parameters&&... parameters) {
  fused::program(on, all.body, all.work, std::forward<Parameters>(parameters)...);
}

}  // namespace scenes::springs_scene
)");
}

TEST(Distribution, has_nothing_of_fields_that_the_program_does_not_read) {
  const Scene scene = distributed_springs();
  Needs needs = needs_of(scene, {});
  needs.arrays[3].fields[0].kept = false;
  const scenes::Distribution found = scenes::find_distribution(scene, needs);
  EXPECT_EQ(found.refused, "");
  EXPECT_EQ(found.sets.back(), (scenes::Distribution::Set{"end", "", false}));
  EXPECT_EQ(found.names.size(), 1U);
  EXPECT_TRUE(found.rows.empty());
  needs.arrays[1].fields[0].kept = false;
  EXPECT_EQ(scenes::find_distribution(scene, needs).refused,
            "set edge follows node, and no index field that the program reads names objects of node for each edge; let "
            "one name them, names(\"...\", \"node\")");
}

TEST(Distribution, is_not_where_ranks_cannot_have_the_arrays_and_the_report_says_why) {
  Scene scene = distributed_springs();
  std::vector<scenes::Array>* arrays = &scene.groups[0].arrays;
  const auto expect = [&](const std::string& why) {
    EXPECT_EQ(refused(scene), why);
    scene = distributed_springs();
    arrays = &scene.groups[0].arrays;
  };
  (*arrays)[1].names.push_back({"nodes", "edge", 0, {}});
  expect(
      "field nodes of body.edges names objects of node and edge, and ranks number each set by itself; let it name "
      "objects of one set");
  (*arrays)[1].names[0].shift = 1;
  expect(
      "field nodes of body.edges has the numbers of node above other bits, which several ranks know of entries of rows "
      "alone; give the numbers a field of their own");
  (*arrays)[1].names[0].set = "end";
  expect(
      "field nodes of body.edges names objects of end, which are entries of rows and have no numbers that all ranks "
      "know; name what the entries name");
  (*arrays)[4].fields.push_back(number);
  (*arrays)[4].names = {{"code", "node", 0, {}}};
  expect(
      "field code of body.state, of which all ranks have all objects, names objects of node, of which they have parts; "
      "let an array per(\"...\") of a set name them");
  (*arrays)[3].names.clear();
  expect(
      "the entries body.ends name objects by no field that the program reads, and rows of several ranks have one; "
      "write names(...) of one field");
  (*arrays)[4].set = "end";
  expect(
      "body.state is per end, as the entries body.ends of rows are, of which a rank has those of its rows alone; give "
      "the "
      "entries a set of their own");
  (*arrays)[3].follows = "node";
  expect("set end follows node, and its objects are entries, which are where their rows are; remove follows(...)");
  (*arrays)[0].follows = "edge";
  expect("set node follows edge, which follows node; let a set follow one that follows none");
  (*arrays)[1].follows = "end";
  expect("set edge follows end, whose objects are entries of rows; let it follow a set of objects");
  arrays->push_back(array("faces", "m::Edge", "edge", {index_of_two}));
  arrays->back().follows = "face";
  expect("set edge follows node and face; let it follow one of them");
  (*arrays)[0].name = "fill";
  expect("array body.fill has the name of a member that the arrays of ranks have; give it another name");
  (*arrays)[0].name = "halos";
  expect("array body.halos has the name of a member that the arrays of ranks have; give it another name");
  scene.groups[0].name = "Counts";
  expect("group Counts has the name of a member that the arrays of ranks have; give it another name");
  (*arrays)[4].set = "not_given";
  expect("set not_given has the name of a member that the arrays of ranks have; give it another name");
  scene.groups[0].name = "Distributed";
  expect("group Distributed has the name of its struct; give it another name");
  (*arrays)[2].set.clear();
  (*arrays)[2].count = 3;
  expect(
      "the rows of body.ranges are the same on all ranks; let it be per(\"...\") of a set, and body.ends of another");
  EXPECT_EQ(
      refused(scene, {{"body.ranges", "body.ends"}, {"body.x", "body.ends"}}),
      "the rows of body.ranges and body.x and the entries body.ends are not one to one; give each array of ranges "
      "entries of its own");

  Needs needs = needs_of(scene);
  needs.halos.outside = "body.x.x at springs.h:20:7";
  EXPECT_EQ(scenes::find_distribution(scene, needs).refused,
            "the program itself uses body.x.x at springs.h:20:7, of whose objects ranks have parts under other "
            "numbers; let a kernel use it, and reduce what the host needs of it into an array per(1)");

  scenes::Halos halos;
  halos.stated = true;
  halos.no_arrays = "why";
  EXPECT_EQ(scenes::halos_text(halos),
            "\nHalos:\n  no step reads other objects than its own\n  no header of arrays for several ranks: why\n");
  nlohmann::ordered_json json;
  scenes::add_halos(halos, json);
  EXPECT_EQ(json["halos"]["no_arrays"], "why");
}

}  // namespace
}  // namespace physgen::test
