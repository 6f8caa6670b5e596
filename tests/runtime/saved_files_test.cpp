// Files that are truncated, damaged, foreign or newer, and places that cannot be written to.
#include "saved_files.h"

#include <elasticity.physgen.h>
#include <hdf5/h5.h>
#include <physgen/save.h>
#include <physgen/version.h>
#include <sys/resource.h>
#include <unistd.h>

#include "stored_records.h"

namespace physgen::test {
namespace {

using Svd = Array<elasticity::DeformationSvdObject, float, Host, Soa>;

class SavedFile : public ::testing::Test {
 protected:
  SavedFile() : saved_(19), array_(7) {
    std::mt19937 random(seed());
    copy(saved_, random_objects<elasticity::DeformationSvdObject>(19, random));
    save(file_, {{"svd", saved_}});
    bytes_ = bytes_of_file(file_);
  }
  /// The Error of a load, which leaves the array as it was; empty where the objects were loaded as they were saved.
  std::string refusal() {
    Svd array = array_;
    std::string message;
    try {
      load(file_, "svd", array);
    } catch (const Error& error) {
      message = error.what();
    }
    EXPECT_EQ(count_wrong(array.untyped(), records_of(message.empty() ? saved_.untyped() : array_.untyped())), 0);
    return message;
  }
  void expect_refusal(const std::string& part) {
    const std::string message = refusal();
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find(file_.string()), std::string::npos) << message;
  }
  /// The Error of a save, after which the old file is there alone.
  std::string failed_save(const std::filesystem::path& file, const Svd& array) {
    const std::string message = message_of([&] { save(file, {{"svd", array}}); });
    EXPECT_EQ(bytes_of_file(file_), bytes_);
    EXPECT_EQ(folder_.names().size(), std::filesystem::exists(folder_ / "folder") ? 2 : 1);
    return message;
  }

  Folder folder_;
  std::filesystem::path file_ = folder_ / "a.h5";
  Svd saved_, array_;
  std::string bytes_;
};

/// Stores a dataset of floats anew, in chunks of 5 rows, packed or not, as other programs do; all that is noted of it
/// stays.
void cut_into_chunks(const std::filesystem::path& path, const std::string& dataset, bool packed) {
  const h5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const h5::Handle old(H5Dopen2(file.id(), dataset.c_str(), H5P_DEFAULT), H5Dclose);
  const h5::Handle type(H5Dget_type(old.id()), H5Tclose), space(H5Dget_space(old.id()), H5Sclose);
  const h5::Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  hsize_t shape[2];
  ASSERT_EQ(H5Sget_simple_extent_dims(space.id(), shape, nullptr), 2);
  std::vector<float> values(shape[0] * shape[1]);
  ASSERT_GE(H5Dread(old.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  shape[0] = 5;
  ASSERT_GE(H5Pset_chunk(properties.id(), 2, shape), 0);
  if (packed) {
    ASSERT_GE(H5Pset_deflate(properties.id(), 9), 0);
  }
  const h5::Handle made(H5Dcreate2(file.id(), "/new", type.id(), space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                        H5Dclose);
  ASSERT_GE(H5Dwrite(made.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  for (hsize_t k = 0; k < static_cast<hsize_t>(H5Aget_num_attrs(old.id())); ++k) {
    const h5::Handle noted(H5Aopen_by_idx(old.id(), ".", H5_INDEX_NAME, H5_ITER_INC, k, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    const h5::Handle of_it(H5Aget_type(noted.id()), H5Tclose), size(H5Aget_space(noted.id()), H5Sclose);
    char name[100], bytes[1000];
    ASSERT_GT(H5Aget_name(noted.id(), sizeof name, name), 0);
    ASSERT_GE(H5Aread(noted.id(), of_it.id(), bytes), 0);
    const h5::Handle copy(H5Acreate2(made.id(), name, of_it.id(), size.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    ASSERT_GE(H5Awrite(copy.id(), of_it.id(), bytes), 0);
  }
  ASSERT_GE(H5Ldelete(file.id(), dataset.c_str(), H5P_DEFAULT), 0);
  ASSERT_GE(H5Lmove(file.id(), "/new", file.id(), dataset.c_str(), H5P_DEFAULT, H5P_DEFAULT), 0);
}

TEST_F(SavedFile, whose_datasets_another_program_has_cut_into_chunks_is_loaded_and_its_damage_found) {
  cut_into_chunks(file_, "/svd/s", false);
  EXPECT_EQ(refusal(), "");
  bytes_ = bytes_of_file(file_);
  const float element = saved_.view()[3].s()[1];
  const std::size_t at = bytes_.rfind(std::string(reinterpret_cast<const char*>(&element), sizeof element));
  bytes_[at] = static_cast<char>(bytes_[at] ^ 1);  // the last of the two: the old dataset may still lie in the file
  write_file(file_, bytes_);
  expect_refusal("'svd' /svd/s is damaged");
}
TEST_F(SavedFile, whose_datasets_another_program_has_packed_is_loaded) {
  saved_ = Svd(19);
  for (index_t i = 0; i < 19; ++i) saved_.putdata(i, 20, 3);  // the last of s; all that is equal takes few bytes
  save(file_, {{"svd", saved_}});
  cut_into_chunks(file_, "/svd/s", true);
  EXPECT_EQ(refusal(), "");
}
TEST_F(SavedFile, is_loaded_whose_datasets_lie_in_another_file_behind_a_link) {
  std::filesystem::rename(file_, folder_ / "other.h5");
  save(file_, {{"svd", Svd(19)}});
  {
    const h5::Handle file(H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    for (const char* dataset : {"/svd/U", "/svd/V", "/svd/s"}) {
      ASSERT_GE(H5Ldelete(file.id(), dataset, H5P_DEFAULT), 0);
      ASSERT_GE(H5Lcreate_external("other.h5", dataset, file.id(), dataset, H5P_DEFAULT, H5P_DEFAULT), 0);
    }
  }
  EXPECT_EQ(refusal(), "");
}
TEST_F(SavedFile, does_not_depend_on_when_it_was_saved) {
  const h5::Handle file(H5Fopen(file_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  for (const char* object : {"/", "/svd", "/svd/s"}) {
    H5O_info_t info;
    ASSERT_GE(H5Oget_info_by_name(file.id(), object, &info, H5P_DEFAULT), 0);
    EXPECT_TRUE(info.btime == 0 && info.ctime == 0 && info.mtime == 0 && info.atime == 0) << object;
  }
}

TEST_F(SavedFile, with_any_wrong_bit_is_refused_or_gives_what_was_saved) {
  std::size_t refused = 0;
  for (std::size_t at = seed() % 3; at < bytes_.size(); at += 3) {
    std::string damaged = bytes_;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at / 3 % 8)));
    write_file(file_, damaged);
    refused += refusal().empty() ? 0 : 1;
    ASSERT_FALSE(HasFailure()) << "byte " << at << " of " << bytes_.size();
  }
  EXPECT_GT(refused, std::size_t{19 * 21 * 4 / 3});  // at least all elements; what lies between is not used
}
TEST_F(SavedFile, with_a_wrong_element_is_refused_as_damaged) {
  const float element = saved_.view()[3].s()[1];
  const std::size_t at = bytes_.find(std::string(reinterpret_cast<const char*>(&element), sizeof element));
  ASSERT_NE(at, std::string::npos);
  bytes_[at] = static_cast<char>(bytes_[at] ^ 1);
  write_file(file_, bytes_);
  expect_refusal("'svd' /svd/s is damaged");
}
TEST_F(SavedFile, that_is_truncated_anywhere_is_refused) {
  for (std::size_t size = 0; size < bytes_.size(); size += 97) {
    write_file(file_, bytes_.substr(0, size));
    ASSERT_NE(refusal(), "") << size << " of " << bytes_.size() << " bytes";
  }
  write_file(file_, bytes_.substr(0, bytes_.size() / 2));
  expect_refusal("truncated file");
}
TEST_F(SavedFile, of_another_program_is_refused) {
  std::filesystem::remove(file_);
  expect_refusal("No such file");
  write_file(file_, std::string(5000, 'x'));
  expect_refusal("cannot open it");
  h5::File foreign = h5::File::create(file_, 0);
  foreign.make_group("/svd");
  foreign.close();
  expect_refusal("is an HDF5 file, but none that physgen::save() wrote");
  h5::File half = h5::File::open(file_, true);  // and one that looks like save()'s but has no objects
  half.write_attribute("/", "physgen_file", h5::one(std::int32_t{1}));
  half.close();
  expect_refusal("cannot find the attribute object");
}
TEST_F(SavedFile, of_a_newer_version_is_refused_with_both_versions) {
  h5::File file = h5::File::open(file_, true);
  file.write_attribute("/", "physgen_file", h5::one(std::int32_t{2}));
  file.close();
  expect_refusal("is a file of version 2, written by physgen " PHYSGEN_VERSION "; this library reads version 1");
}
TEST_F(SavedFile, with_another_count_of_objects_is_refused) {
  h5::File file = h5::File::open(file_, true);
  file.write_attribute("/svd", "count", h5::one(std::uint64_t{1} << 40U));
  file.close();
  expect_refusal("has 19 rows for 1099511627776 objects");
}
TEST_F(SavedFile, stays_as_it_was_where_a_new_one_cannot_be_written) {
  EXPECT_NE(failed_save(folder_ / "none/a.h5", saved_).find("No such file or directory"), std::string::npos);
  std::filesystem::create_directory(folder_ / "folder");
  EXPECT_NE(failed_save(folder_ / "folder", saved_).find("cannot take the place of its old version"),
            std::string::npos);
  if (::geteuid() == 0) return;  // who may write anywhere
  std::filesystem::permissions(folder_.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_NE(failed_save(file_, saved_).find("Permission denied"), std::string::npos);
  std::filesystem::permissions(folder_.path(), std::filesystem::perms::owner_all);
}
TEST_F(SavedFile, stays_as_it_was_where_there_is_no_room_for_a_new_one) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{100000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = failed_save(file_, Svd(100000));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_NE(message.find("bytes more, and this process may write files of 100000 bytes at most"), std::string::npos)
      << message;
}

}  // namespace
}  // namespace physgen::test
