// Checkpoints: every bit comes back, and a file that does not fit the run is refused with the reason.
#include <truthcube/output/checkpoint.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "h5_read.h"
#include "scratch.h"
#include "writes.h"

namespace physgen::truthcube {
namespace {

using testing::expect_error;
using Limits = std::numeric_limits<double>;

constexpr const char* settings = R"({"material":"neo_hookean","poisson":0.49,"volume":"patches"})";
constexpr std::uint64_t hash = 0xFEDCBA9876543210U;

Checkpoint checkpoint_of(int step) {
  return {.settings = settings,
          .mesh_hash = hash,
          .step = step,
          .compression = 0.1 * step,
          .positions = {-0.0, 0.0, Limits::denorm_min(), -Limits::denorm_min(), Limits::max(), Limits::min() / 3,
                        1. / 3, std::bit_cast<double>(std::uint64_t{0x7FF4000000001234}), -Limits::infinity()},
          .pressures = {-1e-310, 5e3, 0.1 * step}};
}

std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits(values.size());
  std::ranges::transform(values, bits.begin(), [](double x) { return std::bit_cast<std::uint64_t>(x); });
  return bits;
}

void expect_same(const Checkpoint& a, const Checkpoint& b) {
  EXPECT_EQ(a.settings, b.settings);
  EXPECT_EQ(a.mesh_hash, b.mesh_hash);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(bits_of({a.compression}), bits_of({b.compression}));
  EXPECT_EQ(bits_of(a.positions), bits_of(b.positions));
  EXPECT_EQ(bits_of(a.pressures), bits_of(b.pressures));
}

/// Some coordinates at a time, whose memory has others afterwards.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& c, std::size_t at_once = 2) {
  truthcube::write_checkpoint(path, c, c.positions.size(), [&](const TakePositions& take) {
    for (std::size_t first = 0; first < c.positions.size(); first += at_once) {
      const auto part = std::span(c.positions).subspan(first, std::min(at_once, c.positions.size() - first));
      std::vector<double> window(part.begin(), part.end());
      take(window);
      std::ranges::fill(window, Limits::signaling_NaN());
    }
  });
}

class Checkpoints : public testing::Scratch {
 public:
  [[nodiscard]] Checkpoint read() const { return read_checkpoint(path, settings, hash); }
  template <class... Parts>
  void expect_refused(const Parts&... parts) const {
    expect_error([this] { static_cast<void>(read()); }, path.string(), parts...);
  }
  std::filesystem::path path = in_folder("checkpoint.h5");
};

TEST_F(Checkpoints, come_back_bit_for_bit) {
  write_checkpoint(path, checkpoint_of(3));
  expect_same(read(), checkpoint_of(3));
}

TEST_F(Checkpoints, have_the_same_bytes_whatever_comes_at_once) {
  write_checkpoint(path, checkpoint_of(3), 100);
  const std::string wanted = testing::read_text(path);
  for (const std::size_t at_once : {1, 2, 4, 5}) {
    write_checkpoint(path, checkpoint_of(3), at_once);
    EXPECT_TRUE(testing::read_text(path) == wanted) << at_once;
  }
}

TEST_F(Checkpoints, take_as_many_coordinates_as_were_said) {
  write_checkpoint(path, checkpoint_of(1));
  const std::vector<double> three(3);
  for (const auto& [count, what] : {std::pair{2, "more coordinates"}, std::pair{4, "fewer coordinates"}}) {
    expect_error(
        [&, count = static_cast<std::uint64_t>(count)] {
          truthcube::write_checkpoint(path, checkpoint_of(2), count, [&](const TakePositions& take) { take(three); });
        },
        path.string(), what);
  }
  expect_same(read(), checkpoint_of(1));
}

TEST_F(Checkpoints, need_no_pressures) {
  Checkpoint c = checkpoint_of(1);
  c.pressures.clear();
  write_checkpoint(path, c);
  expect_same(read(), c);
}

TEST_F(Checkpoints, replace_older_ones) {
  for (const int step : {1, 2, 3}) write_checkpoint(path, checkpoint_of(step));
  EXPECT_EQ(read().step, 3);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}), 1);  // nothing left beside it
  EXPECT_EQ(H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL), 0);
}

TEST_F(Checkpoints, that_are_missing_are_an_error) {
  expect_refused("this checkpoint does not exist", "remove --restart");
}

TEST_F(Checkpoints, of_another_version_are_refused) {
  write_checkpoint(path, checkpoint_of(1));
  testing::H5File(path, true).set_integer("/", "version", 2);
  expect_refused("has version 2", "reads version 1");
}

TEST_F(Checkpoints, of_another_mesh_are_refused) {
  write_checkpoint(path, checkpoint_of(1));
  expect_error([&] { static_cast<void>(read_checkpoint(path, settings, hash + 1)); }, path.string(), "another mesh",
               "3 positions");
}

TEST_F(Checkpoints, of_another_order_are_refused_with_the_flag_to_add) {
  Checkpoint c = checkpoint_of(1);
  c.order = {"metis", 7};
  write_checkpoint(path, c);
  EXPECT_EQ(read_checkpoint(path, settings, hash, {"metis", 7}).order, c.order);
  require_order(path, "metis");
  expect_refused("--order metis and not mesh; add --order metis");
  expect_error([&] { require_order(path, "mesh"); }, path.string(), "--order metis and not mesh; add --order metis");
  expect_error([&] { static_cast<void>(read_checkpoint(path, settings, hash, {"metis", 8})); }, path.string(),
               "another order of the mesh", "remove --restart");
  write_checkpoint(path, checkpoint_of(1));
  expect_error([&] { static_cast<void>(read_checkpoint(path, settings, hash, {"metis", 7})); }, path.string(),
               "add --order mesh");
  require_order(in_folder("absent.h5"), "metis");
}

TEST_F(Checkpoints, of_versions_without_an_order_are_of_the_meshs_own) {
  write_checkpoint(path, checkpoint_of(1));
  {
    const testing::H5File file(path, true);
    EXPECT_GE(H5Adelete(file.id(), "order"), 0);
    EXPECT_GE(H5Adelete(file.id(), "order_digest"), 0);
  }
  expect_same(read(), checkpoint_of(1));
}

TEST_F(Checkpoints, of_other_settings_are_refused_with_each_key_that_differs) {
  write_checkpoint(path, checkpoint_of(1));
  const auto read_with = [&](const char* now) {
    return [this, now] { static_cast<void>(read_checkpoint(path, now, hash)); };
  };
  read_with(R"({"volume": "patches", "poisson": 4.9e-1, "material": "neo_hookean"})")();  // the same
  expect_error(read_with(R"({"material":"corotated","poisson":0.49,"volume":"patches"})"), path.string(),
               R"(settings: material: "neo_hookean" in the checkpoint, "corotated" in this run)");
  expect_error(read_with(R"({"material":"neo_hookean","poisson":0.45,"top":"bonded"})"),
               "settings: poisson: 0.49 in the checkpoint, 0.45 in this run; "
               R"(top: not set in the checkpoint, "bonded" in this run; )"
               R"(volume: "patches" in the checkpoint, not set in this run)");
  expect_error(read_with("no JSON"), "not a JSON object");
}

/// As a cube's run without flags had them, when there were no scenes, when that of equilibria had another name, and
/// when their arrays were said.
TEST_F(Checkpoints, of_older_versions_are_refused_with_their_settings_and_what_to_do) {
  const std::string
      rest =
          R"("cells":16,"historical":false,"material":"neo-hookean","plates":"held","poisson":0.49,"precision":"half",)"
          R"("preconditioner":"multigrid","product":"assembled",)",
      last = R"("stepping":"nested","tolerance":1e-06,"top":"bonded","volume":"patches","young":15000.0})";
  const std::string now = R"({"arrays":"everything",)" + rest + R"("scene":"everything",)" + last;
  const auto expect_said = [&](const std::string& then, const auto&... parts) {
    Checkpoint c = checkpoint_of(1);
    c.settings = then;
    write_checkpoint(path, c);
    expect_error([&] { static_cast<void>(read_checkpoint(path, now, hash)); }, path.string(), parts...,
                 "older version of truthcube", "remove --restart to start from the beginning");
  };
  expect_said("{" + rest + last, R"(settings: arrays: not set in the checkpoint, "everything" in this run; )"
                                 R"(scene: not set in the checkpoint, "everything" in this run; continue it with)");
  expect_said("{" + rest + R"("scene":"quasistatic",)" + last,
              R"(settings: arrays: not set in the checkpoint, "everything" in this run; )"
              R"(scene: "quasistatic" in the checkpoint, "everything" in this run; continue it with)");
  Checkpoint c = checkpoint_of(1);
  c.settings = now;
  write_checkpoint(path, c);
  expect_same(read_checkpoint(path, now, hash), c);
}

TEST_F(Checkpoints, with_settings_that_are_no_object_are_not_written) {
  Checkpoint c = checkpoint_of(1);
  c.settings = "[]";
  expect_error([&] { write_checkpoint(path, c); }, path.string(), "not a JSON object");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(Checkpoints, that_are_other_files_are_refused) {
  testing::put_text(path, "");
  expect_refused("is damaged, or is not a checkpoint");
  testing::put_text(path, std::string(5000, 'x'));
  expect_refused("is damaged, or is not a checkpoint");
  H5Fclose(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expect_refused("this is not a checkpoint of truthcube");
}

TEST_F(Checkpoints, that_are_cut_off_are_refused) {
  write_checkpoint(path, checkpoint_of(1));
  const std::string complete = testing::read_text(path);
  for (std::size_t size = 0; size < complete.size(); size += 97) {
    testing::put_text(path, complete.substr(0, size));
    expect_refused("damaged");
  }
}

TEST_F(Checkpoints, with_a_changed_bit_in_their_values_are_refused) {
  const Checkpoint written = checkpoint_of(1);
  write_checkpoint(path, written);
  const std::string complete = testing::read_text(path);
  const auto flip_bits_of = [&](const void* bytes, std::size_t count) {
    const std::string pattern(static_cast<const char*>(bytes), count);
    const std::size_t place = complete.find(pattern);
    ASSERT_NE(place, std::string::npos);
    for (std::size_t i = 0; i < count; ++i) {
      std::string damaged = complete;
      damaged[place + i] = static_cast<char>(damaged[place + i] ^ (1 << (i % 8)));
      testing::put_text(path, damaged);
      expect_refused("damaged");
    }
  };
  flip_bits_of(written.positions.data(), written.positions.size() * sizeof(double));
  flip_bits_of(written.pressures.data(), written.pressures.size() * sizeof(double));
  flip_bits_of(written.settings.data(), written.settings.size());
  flip_bits_of(&written.compression, sizeof(double));
}

TEST_F(Checkpoints, killed_at_any_write_leave_the_old_or_the_new_one) {
  int writes = 0;
  for (bool killed = true; killed; ++writes) {
    write_checkpoint(path, checkpoint_of(1));
    killed = testing::interrupted(testing::At::Kill, writes, [&] { write_checkpoint(path, checkpoint_of(2)); });
    expect_same(read(), checkpoint_of(killed ? 1 : 2));
  }
  EXPECT_GT(writes, 5);
}

TEST_F(Checkpoints, on_a_full_disk_leave_the_old_one) {
  int writes = 0;
  for (bool failed = true; failed; ++writes) {
    write_checkpoint(path, checkpoint_of(1));
    failed = testing::interrupted(testing::At::Failure, writes, [&] { write_checkpoint(path, checkpoint_of(2)); });
    expect_same(read(), checkpoint_of(failed ? 1 : 2));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}), 1);
    ASSERT_FALSE(HasFailure()) << "write " << writes;
  }
  EXPECT_GT(writes, 5);
  testing::set_disk_full(true);
  const std::string error = testing::error_of([&] { write_checkpoint(path, checkpoint_of(3)); });
  testing::set_disk_full(false);
  for (const char* part : {": needs ", " bytes more, ", " are free there: "}) {
    EXPECT_NE(error.find(part), std::string::npos) << error;
  }
  write_checkpoint(path, checkpoint_of(3));
  expect_same(read(), checkpoint_of(3));
}

TEST_F(Checkpoints, in_a_folder_that_cannot_be_written_are_an_error) {
  const testing::ReadOnly read_only(path.parent_path());
  expect_error([&] { write_checkpoint(path, checkpoint_of(1)); }, path.string(), "Permission denied");
}

}  // namespace
}  // namespace physgen::truthcube
