// Races between the steps of a fused kernel, which a checked build finds. This program is compiled with
// PHYSGEN_CHECKED.
#include <elasticity.physgen.h>
#include <gtest/gtest.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>
#include <physgen/row_arrays.h>

#include "test_objects.h"

namespace physgen::test {
namespace {

constexpr index_t shapes = 99;  // the last pack is not whole

/// to[i] = from[i]
template <class From, class To>
struct Copy {
  using Scalar = float;
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    to[i].volume() = from[i].volume().get();
  }
};
template <class From, class To>
Copy(From, To) -> Copy<From, To>;

/// to[i] = from[i + distance[i]], where the distance is that object's volume.
template <class Distances, class From, class To>
struct CopyOther {
  using Scalar = float;
  Distances distances;
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    const lanes_t<float, I> distance = distances[i].volume();
    to[i].volume() = from[numbers(i) + math::to_index(distance)].volume().get();
  }
};
template <class Distances, class From, class To>
CopyOther(Distances, From, To) -> CopyOther<Distances, From, To>;

/// to[i + distance[i]] += from[i]
template <class Distances, class From, class To>
struct AddToOther {
  using Scalar = float;
  Distances distances;
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    const lanes_t<float, I> distance = distances[i].volume();
    add(i, to[numbers(i) + math::to_index(distance)].volume(), from[i].volume().get());
  }
};
template <class Distances, class From, class To>
AddToOther(Distances, From, To) -> AddToOther<Distances, From, To>;

/// Writes another element of the same field.
template <class To>
struct StoreFirst {
  using Scalar = float;
  To to;
  template <class I>
  void operator()(I i) const {
    to[i].dm_inverse()[0] = lanes_t<float, I>(1.0F);
  }
};
template <class To>
StoreFirst(To) -> StoreFirst<To>;
/// Reads one element of object 0.
template <class From, class To>
struct ReadOne {
  using Scalar = float;
  int element;
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    to[i].volume() = from[lanes_t<std::int32_t, I>(0)].dm_inverse()[element].get();
  }
};
template <class From, class To>
ReadOne(int, From, To) -> ReadOne<From, To>;

/// to[i] = the sum of from[entry] over row i
template <class Rows, class From, class To>
struct SumRow {
  using Scalar = float;
  Rows rows;
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    using S = lanes_t<float, I>;
    to[i].volume() = rows.sum(i, S(0.0F), [this](const auto& entry) -> S {
      const lanes_t<std::int32_t, I> object = entry.element();
      return from[object].volume();
    });
  }
};
template <class Rows, class From, class To>
SumRow(Rows, From, To) -> SumRow<Rows, From, To>;

/// to[entry] += from[i] for each entry of row i; where `all` lanes add, those whose rows have ended do, too.
template <class Rows, class From, class To>
struct AddToRow {
  using Scalar = float;
  bool all;
  Rows rows;
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    using S = lanes_t<float, I>;
    const S value = from[i].volume();
    rows.for_each(i, [&](const auto& entry, const auto& active) {
      const lanes_t<std::int32_t, I> object = entry.element();
      using math::select;
      add(i, to[object].volume(), all ? value : S(select(active, value, S(0.0F))));
    });
  }
};
template <class Rows, class From, class To>
AddToRow(bool, Rows, From, To) -> AddToRow<Rows, From, To>;

struct Races : testing::Test {
  using Rows = RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>>;

  elasticity::RestShapeArray<float> first{shapes}, between{shapes}, last{shapes}, distances{shapes};

  Races() {
    for (index_t i = 0; i < shapes; ++i) {
      first.view()[i].volume() = static_cast<float>(i);
      distances.view()[i].volume() = 0;
    }
  }
  /// Rows of 0 to 3 entries that name their own object, but for the last one of row 41.
  static Rows own_rows(std::int32_t last_of_41) {
    std::vector<std::vector<Rows::Value>> rows(shapes);
    for (std::int32_t i = 0; i < shapes; ++i)
      for (std::int32_t k = 0; k < (i + 2) % 4; ++k) rows[static_cast<std::size_t>(i)].push_back({i, k});
    rows[41].back().element = last_of_41;
    return Rows::from_lists({"element", shapes}, rows);
  }
  template <class... Step>
  std::string of(const Step&... step) {
    return message_of([&] { parallel_for(Host{}, shapes, fuse(locals(), step...)); });
  }
};

TEST_F(Races, are_found_where_a_step_reads_what_another_one_writes_for_another_object_in_either_order) {
  const Copy copy{first.const_view(), between.view()};
  const CopyOther other{distances.const_view(), between.const_view(), last.view()};
  EXPECT_EQ(of(copy, other), "nothing was thrown") << "every step reads its own object";
  distances.view()[index_t{41}].volume() = 3;
  EXPECT_EQ(of(copy, other),
            "physgen: elasticity::RestShape: a race in a fused kernel at field volume of object 44: "
            "CopyOther reads it for object 41, and Copy writes "
            "it for object 44; what is found there depends on how threads and packs run, so take one of the two out of "
            "fuse(...)");
  EXPECT_EQ(of(other, copy),
            "physgen: elasticity::RestShape: a race in a fused kernel at field volume of object 44: "
            "Copy writes it for object 44, and CopyOther reads "
            "it for object 41; what is found there depends on how threads and packs run, so take one of the two out of "
            "fuse(...)");
  EXPECT_NO_THROW(parallel_for(Host{}, shapes, copy));
  EXPECT_NO_THROW(parallel_for(Host{}, shapes, other)) << "a launch after the other one";
}

TEST_F(Races, are_found_behind_the_objects_of_whole_packs_and_within_nested_groups) {
  const Copy copy{first.const_view(), between.view()};
  const CopyOther other{distances.const_view(), between.const_view(), last.view()};
  distances.view()[index_t{97}].volume() = 1;
  EXPECT_NE(of(copy, other).find("object 98: "), std::string::npos) << of(copy, other);
  EXPECT_NE(of(fuse(locals(), copy), fuse(locals(), other)).find("object 98: "), std::string::npos);
  EXPECT_EQ(message_of([&] { parallel_for(Host{}, 0, 97, fuse(locals(), copy, other)); }), "nothing was thrown");
  EXPECT_NE(message_of([&] { parallel_for(Host{}, 97, 99, fuse(locals(), copy, other)); }).find("for object 97"),
            std::string::npos);
}

TEST_F(Races, are_no_sums_but_what_reads_or_writes_them_for_another_object) {
  const AddToOther sum{distances.const_view(), first.const_view(), between.view()};
  distances.view()[index_t{10}].volume() = 5;
  distances.view()[index_t{20}].volume() = -5;
  EXPECT_EQ(of(sum, sum), "nothing was thrown") << "three objects add to object 15";
  const std::string found = of(sum, Copy{between.const_view(), last.view()});
  EXPECT_NE(found.find("field volume of object 15: "), std::string::npos) << found;
  EXPECT_NE(found.find("Copy reads it for object 15, and"), std::string::npos) << found;
  EXPECT_NE(found.find("AddToOther adds to it for object "), std::string::npos) << found;
  EXPECT_NE(of(Copy{last.const_view(), between.view()}, sum).find("field volume of object 15: "), std::string::npos);
}

TEST_F(Races, are_of_elements_not_of_objects_or_fields) {
  const StoreFirst store{between.view()};
  EXPECT_EQ(of(store, ReadOne{8, between.const_view(), between.view()}), "nothing was thrown");
  const std::string found = of(store, ReadOne{0, between.const_view(), between.view()});
  EXPECT_NE(found.find("field dm_inverse of object 0: ReadOne reads it for object "), std::string::npos) << found;
}

TEST_F(Races, are_none_of_lanes_whose_rows_have_ended_and_are_of_those_whose_rows_have_not) {
  const Copy copy{first.const_view(), between.view()};
  for (const bool sums : {false, true}) {
    const auto found = [&](const Rows& rows, bool all) {
      return sums ? of(AddToRow{all, rows.const_view(), first.const_view(), between.view()},
                       Copy{between.const_view(), last.view()})
                  : of(copy, SumRow{rows.const_view(), between.const_view(), last.view()});
    };
    EXPECT_EQ(found(own_rows(41), false), "nothing was thrown");
    const std::string race = found(own_rows(43), false);
    EXPECT_NE(race.find("field volume of object 43: "), std::string::npos) << race;
    EXPECT_NE(race.find(sums ? "AddToRow adds to it for object 41" : "SumRow reads it for object 41"),
              std::string::npos)
        << race;
    if (sums) {
      EXPECT_NE(found(own_rows(41), true).find("AddToRow adds to it for object "), std::string::npos)
          << "what a lane adds although its row has ended is there";
    }
  }
}

TEST(RacesOfViews, are_found_behind_the_objects_of_a_shorter_view_of_the_same_array) {
  constexpr index_t many = 2'000'000, few = 32;  // so far behind what a shorter one needs, no memory is
  elasticity::RestShapeArray<float> shapes_of(many), last(few), distances(few);
  for (index_t i = 0; i < few; ++i) {
    distances.view()[i].volume() = static_cast<float>(many - few);
    shapes_of.view()[i].volume() = static_cast<float>(i);
    shapes_of.view()[many - few + i].volume() = static_cast<float>(2 * i);
  }
  const auto whole = shapes_of.view();
  const decltype(whole) beginning(whole.data(), few, whole.pitch(), whole.losses());
  const Copy first_step{beginning, last.view()};
  const CopyOther far{distances.const_view(), whole, last.view()};
  EXPECT_EQ(message_of([&] { parallel_for(Host{}, few, fuse(locals(), first_step, far)); }), "nothing was thrown");
  for (index_t i = 0; i < few; ++i) EXPECT_EQ(last.view()[i].volume(), static_cast<float>(2 * i));
  const Copy writes_it{last.const_view(), whole};
  const auto of_end = [&] { parallel_for(Host{}, few, fuse(locals(), first_step, far, writes_it)); };
  EXPECT_NO_THROW(of_end()) << "it writes the beginning, and others read the end";
  distances.view()[index_t{5}].volume() = 9;
  EXPECT_NE(message_of(of_end).find("field volume of object 14: "), std::string::npos) << message_of(of_end);
}

TEST(RacesOfThreads, are_found_between_objects_of_different_threads) {
  constexpr index_t many = 20000;
  elasticity::RestShapeArray<float> first(many), between(many), last(many), distances(many);
  for (index_t i = 0; i < many; ++i) distances.view()[i].volume() = 0;
  distances.view()[index_t{77}].volume() = 19000;
  const Copy copy{first.const_view(), between.view()};
  const CopyOther other{distances.const_view(), between.const_view(), last.view()};
  for (int run = 0; run < 4; ++run) {
    const std::string found = message_of([&] { parallel_for(Host{}, many, fuse(locals(), copy, other)); });
    EXPECT_NE(found.find("field volume of object 19077: "), std::string::npos) << found;
  }
}

}  // namespace
}  // namespace physgen::test
