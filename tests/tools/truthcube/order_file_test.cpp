// Files of orders: all numbers come back, and a file of another mesh, or a damaged one, is refused.
#include <truthcube/output/order_file.h>

#include "scratch.h"
#include "writes.h"

namespace physgen::truthcube {
namespace {

using testing::expect_error;

MeshOrder order_of(fem::Index first) {
  return {0xFEDCBA9876543210U, {{first, 3 - first, 1, 0, 4}, {first + 3, first, 7}}};
}

class OrderFiles : public testing::Scratch {
 public:
  [[nodiscard]] MeshOrder read() const { return read_order(path, order_of(0).mesh_hash); }
  template <class... Parts>
  void expect_refused(const Parts&... parts) const {
    expect_error([this] { static_cast<void>(read()); }, path.string(), parts...);
  }
  std::filesystem::path path = in_folder("order.h5");
};

TEST_F(OrderFiles, come_back_and_have_digests_of_their_own) {
  write_order(path, order_of(2));
  EXPECT_EQ(read(), order_of(2));
  EXPECT_EQ(read().digest(), order_of(2).digest());
  EXPECT_NE(order_of(2).digest(), order_of(1).digest());
  EXPECT_EQ(MeshOrder{}.digest(), 0U);
  MeshOrder other_tets = order_of(2);
  std::swap(other_tets.numbers.tet_order[0], other_tets.numbers.tet_order[1]);
  EXPECT_NE(other_tets.digest(), order_of(2).digest());
}

TEST_F(OrderFiles, that_are_missing_or_of_another_mesh_are_refused_with_the_remedy) {
  expect_refused("does not exist; remove --restart");
  write_order(path, order_of(2));
  expect_error([&] { static_cast<void>(read_order(path, order_of(2).mesh_hash + 1)); }, path.string(),
               "belongs to another mesh, of 5 nodes and 3 tets; give the --mesh of that run, or remove --restart");
}

TEST_F(OrderFiles, that_are_cut_off_changed_or_other_files_are_refused) {
  testing::put_text(path, std::string(5000, 'x'));
  expect_refused("is damaged, or is not the order of a mesh");
  write_order(path, order_of(2));
  const std::string complete = testing::read_text(path);
  for (std::size_t size = 0; size < complete.size(); size += 97) {
    testing::put_text(path, complete.substr(0, size));
    expect_refused("damaged");
  }
  const MeshOrder written = order_of(2);
  const std::string nodes(reinterpret_cast<const char*>(written.numbers.node_order.data()), 5 * sizeof(fem::Index));
  const std::size_t place = complete.find(nodes);
  ASSERT_NE(place, std::string::npos);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::string damaged = complete;
    damaged[place + i] = static_cast<char>(damaged[place + i] ^ (1 << (i % 8)));
    testing::put_text(path, damaged);
    expect_refused("is damaged: its checksum is not that of its contents");
  }
}

TEST_F(OrderFiles, killed_at_any_write_leave_the_old_or_the_new_one) {
  int writes = 0;
  for (bool killed = true; killed; ++writes) {
    write_order(path, order_of(1));
    killed = testing::interrupted(testing::At::Kill, writes, [&] { write_order(path, order_of(2)); });
    EXPECT_EQ(read(), order_of(killed ? 1 : 2));
  }
  EXPECT_GT(writes, 5);
}

}  // namespace
}  // namespace physgen::truthcube
