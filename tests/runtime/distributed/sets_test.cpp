// Runs, local numbers, and what is found in kernels.
#include <gtest/gtest.h>
#include <physgen/detail/reduction.h>
#include <physgen/distributed/kernel_members.h>
#include <physgen/distributed/local_set.h>

#include <algorithm>
#include <random>

#include "springs.h"

namespace physgen {
namespace {

static_assert(Runs::block == detail::reduce_block);

std::string message_of(const auto& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

/// Runs cover all objects, once, and begin with blocks.
void expect_runs(const Runs& runs, index_t size) {
  EXPECT_EQ(runs.begin(0), 0);
  EXPECT_EQ(runs.size(), size);
  for (int r = 0; r < runs.ranks(); ++r) {
    EXPECT_LE(runs.begin(r), runs.end(r));
    const bool has_objects = runs.begin(r) < runs.end(r);
    EXPECT_TRUE(!has_objects || runs.begin(r) % Runs::block == 0) << "rank " << r;
  }
  for (const index_t object : {index_t{0}, size / 2, size - 1}) {
    EXPECT_TRUE(object < 0 || object >= size || runs.owns(runs.owner(object), object));
  }
}

TEST(Runs, are_whole_blocks_that_differ_by_one_at_most) {
  for (const index_t size : {0, 1, 2047, 2048, 2049, 20000, 1000000}) {
    for (const int ranks : {1, 2, 3, 8, 17}) {
      const Runs runs = Runs::of_blocks(size, ranks);
      expect_runs(runs, size);
      const index_t blocks = (size + Runs::block - 1) / Runs::block;
      for (int r = 0; r < ranks; ++r) {
        const index_t own = (runs.end(r) - runs.begin(r) + Runs::block - 1) / Runs::block;
        EXPECT_GE(own, blocks / ranks);
        EXPECT_LE(own, (blocks + ranks - 1) / ranks);
      }
    }
  }
}

TEST(Runs, begin_at_the_block_nearest_to_a_cut) {
  const std::vector<index_t> cuts{0, 3000, 3100, 11000, 60000};
  const Runs runs = Runs::near(20000, cuts);
  expect_runs(runs, 20000);
  EXPECT_EQ(runs.begin(1), 2048);
  EXPECT_EQ(runs.begin(2), 4096);
  EXPECT_EQ(runs.begin(3), 10240);
  EXPECT_EQ(runs.begin(4), 20000) << "nothing is left";
  EXPECT_EQ(message_of([&] { (void)runs.owner(20000); }),
            "physgen: object 20000 is none of a set of 20000; name one of 0 .. size-1");
  EXPECT_EQ(
      message_of([] { (void)Runs::of_blocks(-1, 2); }),
      "physgen: runs of -1 objects on 2 ranks cannot exist; give a size that is not negative and one rank at least");
}

TEST(Runs, begin_where_they_are_cut_when_no_reduction_goes_by_them) {
  const std::vector<index_t> cuts{5, 30, 20, 300};
  const Runs runs = Runs::at(100, cuts);
  EXPECT_EQ(runs.size(), 100);
  EXPECT_EQ(runs.begin(0), 0);
  EXPECT_EQ(runs.begin(1), 30);
  EXPECT_EQ(runs.begin(2), 30) << "none is below the one before";
  EXPECT_EQ(runs.begin(3), 100);
  EXPECT_EQ(runs.owner(29), 0);
  EXPECT_EQ(runs.owner(30), 2);
}

TEST(LocalSet, local_numbers_ascend_with_global_ones_and_owned_objects_begin_with_a_block) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (const index_t size : {1, 5000, 30000}) {
    for (int rank = 0; rank < 4; ++rank) {
      const Runs runs = Runs::of_blocks(size, 4);
      std::vector<index_t> ghosts;
      for (index_t i = 0; i < size; ++i) {
        // Some, all and none.
        const bool is_ghost = i / 700 % 3 == 0 ? random() % 7 == 0 : i / 700 % 3 == 1;
        if (!runs.owns(rank, i) && is_ghost) ghosts.push_back(i);
      }
      const LocalSet set(runs, rank, ghosts);
      EXPECT_EQ(set.begin() % Runs::block, 0);
      EXPECT_GE(set.size(), 1);
      index_t before = -1, here = 0;
      for (index_t i = 0; i < set.size(); ++i) {
        const index_t global = set.global(i);
        if (i < set.first() || i >= set.last()) {
          EXPECT_EQ(global, -1);
          continue;
        }
        ++here;
        EXPECT_GT(global, before);
        EXPECT_EQ(set.local(global), i);
        EXPECT_EQ(runs.owns(rank, global), set.begin() <= i && i < set.end());
        before = global;
      }
      EXPECT_EQ(here, set.owned() + static_cast<index_t>(ghosts.size()));
      for (index_t i = 0; i < size; ++i) {
        const bool is_here = runs.owns(rank, i) || std::ranges::binary_search(ghosts, i);
        EXPECT_EQ(set.local(i) >= 0, is_here) << "object " << i;
      }
      for (std::size_t g = 0; g < ghosts.size(); ++g) EXPECT_EQ(set.global(set.ghost(g)), ghosts[g]);
    }
  }
  EXPECT_EQ(message_of([] { (void)LocalSet(Runs::of_blocks(9000, 2), 0, {8000, 7000}); }),
            "physgen: ghost 1 of rank 0 is object 7000 of 9000; list objects that other ranks own, in ascending order, "
            "each once");
}

template <class View, class Others>
struct Nested {
  struct Numbers {
    double a;
    Eigen::Vector3f b;
  };
  struct Inner {
    int number;
    View view;
  };
  using Scalar = float;
  Inner inner;
  std::array<View, 2> two;
  Numbers numbers;
  Others rows;
  template <class I>
  void operator()(I) const {}
};

TEST(KernelMembers, views_are_found_in_members_of_members_in_their_order) {
  elasticity::NodeForceArray<float> forces(3), others(4);
  elasticity::IncidenceRangeArray<float> ranges(5);
  elasticity::IncidenceArray<float> entries(6);
  const Rows rows(ranges.const_view(), entries.const_view(), 3);
  using Kernel = Nested<decltype(forces.view()), Rows<decltype(ranges.const_view()), decltype(entries.const_view())>>;
  const Kernel kernel{{1, forces.view()}, {others.view(), forces.view()}, {2, {}}, rows};
  std::vector<index_t> sizes;
  std::vector<bool> written;
  for_each_view(kernel, [&](const KernelView& view) {
    sizes.push_back(view.size);
    written.push_back(view.is_written);
  });
  EXPECT_EQ(sizes, (std::vector<index_t>{3, 4, 3, 5, 6}));
  EXPECT_EQ(written, (std::vector<bool>{true, true, true, false, false}));
  EXPECT_EQ(name_of_kernel<Kernel>(), "physgen::(anonymous namespace)::Nested");
}

TEST(KernelMembers, a_local_of_a_fused_kernel_has_a_number_and_no_memory) {
  elasticity::NodeForceArray<float> forces(3);
  const auto pulls = local<elasticity::NodeForceObject, float, FormatsOfSpace, struct Pulls>();
  std::vector<bool> stored;
  for_each_view(springs::Move{pulls, forces.view(), 1.0F, -1},
                [&](const KernelView& view) { stored.push_back(view.base != nullptr); });
  EXPECT_EQ(stored, (std::vector<bool>{false, true}));
}

TEST(KernelMembers, fused_kernels_are_their_steps_and_lanes_are_no_part_of_a_name) {
  elasticity::NodeForceArray<float> forces(3);
  elasticity::NodePositionArray<float> positions(3);
  const springs::Move move{forces.const_view(), positions.view(), 1.0F, -1};
  std::vector<std::string> names;
  for_each_kernel(lanes<1>(fuse(locals(), move, move)),
                  [&](const auto& one) { names.push_back(name_of_kernel<std::remove_cvref_t<decltype(one)>>()); });
  EXPECT_EQ(names, (std::vector<std::string>{"springs::Move", "springs::Move"}));
}

}  // namespace
}  // namespace physgen
