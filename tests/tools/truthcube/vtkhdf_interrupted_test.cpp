// A kill or a full disk at any moment of writing: earlier steps stay readable, and the run can go on.
#include <files/disk.h>
#include <truthcube/output/vtkhdf.h>

#include <cstdlib>
#include <utility>

#include "scratch.h"
#include "vtkhdf_scene.h"
#include "writes.h"

namespace physgen::truthcube {
namespace {

using testing::At;
using testing::H5File;
using testing::Scene;

class InterruptedVtkHdf : public testing::Scratch {
 public:
  // A copy of a file that has some steps.
  std::filesystem::path copy_with_steps(int steps) {
    const std::filesystem::path original = in_folder(std::to_string(steps)), path = in_folder("cube.vtkhdf");
    if (!std::filesystem::exists(original)) static_cast<void>(scene.create(original, steps));
    std::filesystem::copy_file(original, path, std::filesystem::copy_options::overwrite_existing);
    return path;
  }

  Scene scene;
};

// Viewers allocate memory for NSteps times and read all of Values into it.
void expect_no_more_times_than_steps(const std::filesystem::path& path) {
  const H5File file(path);
  EXPECT_LE(file.shape("/VTKHDF/Steps/Values")[0],
            static_cast<hsize_t>(file.integers("/VTKHDF/Steps", "NSteps").front()));
}

// The XDMF file is the old one or the new one.
void expect_whole_xdmf(std::filesystem::path path) {
  const std::string text = testing::read_text(path.replace_extension(".xdmf"));
  EXPECT_TRUE(text.ends_with("</Domain>\n</Xdmf>\n")) << text;
}

TEST_F(InterruptedVtkHdf, kill_or_failure_at_any_write_of_a_step_leaves_the_steps_before) {
  for (const auto& [what, rows_at_once] :
       {std::pair{At::Kill, 0}, std::pair{At::Failure, 0}, std::pair{At::FailureToGrow, 0}, std::pair{At::Kill, 5}}) {
    scene.rows_at_once = static_cast<std::size_t>(rows_at_once);
    int writes = 0;
    for (bool interrupted = true; interrupted; ++writes) {
      SCOPED_TRACE("way " + std::to_string(static_cast<int>(what)) + " at write " + std::to_string(writes));
      const std::filesystem::path path = copy_with_steps(2);
      static_cast<void>(scene.append_to(path, 2));
      interrupted = testing::interrupted(what, writes, [&] {
        VtkHdfWriter writer = scene.append_to(path, 2);
        scene.write_step(writer, 2);
      });
      scene.expect_steps(path, 2);
      expect_no_more_times_than_steps(path);
      expect_whole_xdmf(path);
      VtkHdfWriter writer = scene.append_to(path, 2);
      scene.write_step(writer, 2);
      scene.write_step(writer, 3);
      scene.expect_only_steps(path, 4);
      if (HasFailure()) return;
    }
    EXPECT_GT(writes, 5);
  }
}

TEST_F(InterruptedVtkHdf, kill_or_failure_at_any_write_of_a_restart_leaves_the_steps_it_keeps) {
  for (const At what : {At::Kill, At::Failure, At::FailureToGrow}) {
    int writes = 0;
    for (bool interrupted = true; interrupted; ++writes) {
      SCOPED_TRACE("way " + std::to_string(static_cast<int>(what)) + " at write " + std::to_string(writes));
      const std::filesystem::path path = copy_with_steps(3);
      interrupted = testing::interrupted(what, writes, [&] { static_cast<void>(scene.append_to(path, 2)); });
      scene.expect_only_steps(path, interrupted ? 3 : 2);
      static_cast<void>(scene.append_to(path, 2));
      scene.expect_only_steps(path, 2);
      if (HasFailure()) return;
    }
    EXPECT_GT(writes, 5);
  }
}

TEST_F(InterruptedVtkHdf, failure_of_any_write_of_a_step_lets_the_process_end_by_itself) {
  const std::filesystem::path path = copy_with_steps(2);
  constexpr int status = 7;
  for (int writes = 0; writes < 12; ++writes) {
    const auto fail_and_end = [&] {
      testing::stop_writes(At::Failure, writes);
      static_cast<void>(testing::error_of([&] {
        VtkHdfWriter writer = scene.append_to(path, 2);
        scene.write_step(writer, 2);
      }));
      std::exit(status);
    };
    EXPECT_EXIT(fail_and_end(), ::testing::ExitedWithCode(status), "") << "write " << writes;
  }
}

TEST_F(InterruptedVtkHdf, kill_in_the_first_step_leaves_a_file_that_can_begin_anew) {
  int writes = 0;
  for (bool killed = true; killed; ++writes) {
    SCOPED_TRACE("killed at write " + std::to_string(writes));
    const std::filesystem::path path = copy_with_steps(0);
    killed = testing::interrupted(At::Kill, writes, [&] {
      VtkHdfWriter writer = scene.append_to(path, 0);
      scene.write_step(writer, 0);
    });
    VtkHdfWriter writer = scene.append_to(path, 0);
    scene.write_step(writer, 0);
    scene.expect_only_steps(path, 1);
    if (HasFailure()) return;
  }
  EXPECT_GT(writes, 5);
}

TEST_F(InterruptedVtkHdf, full_disk_is_said_before_anything_is_written) {
  const std::filesystem::path path = copy_with_steps(0);
  VtkHdfWriter writer = scene.create(path, 1);
  const std::string bytes_before = testing::read_text(path);
  testing::set_disk_full(true);
  const std::string error = testing::error_of([&] { scene.write_step(writer, 1); });
  testing::set_disk_full(false);
  for (const std::string& part : {path.string() + ": needs ", std::string(" bytes more, "), std::string(" are free")}) {
    EXPECT_NE(error.find(part), std::string::npos) << error;
  }
  EXPECT_TRUE(testing::read_text(path) == bytes_before);
  scene.write_step(writer, 1);
  scene.expect_only_steps(path, 2);
}

TEST_F(InterruptedVtkHdf, more_bytes_than_any_disk_has_are_refused_by_the_system) {
  const std::filesystem::path path = copy_with_steps(0);
  testing::expect_error([&] { disk::reserve_space(path, std::uint64_t{1} << 60U); }, path.string(),
                        "1152921504606846976");
  scene.expect_only_steps(copy_with_steps(1), 1);
}

}  // namespace
}  // namespace physgen::truthcube
