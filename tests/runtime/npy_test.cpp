// Arrays as .npy files: bits that come back, fields by name, and files and folders that are refused.
#include <everything.physgen.h>
#include <physgen/save_npy.h>

#include "saved_files.h"
#include "stored_records.h"

namespace physgen::test {
namespace {

using tissue::model::MarksArray;
using Tets = elasticity::TetArray<float, Host, Aosoa<4>>;

Tets tets(index_t n) {
  std::mt19937 random(seed());
  Tets array(n);
  copy(array, random_objects<elasticity::TetObject>(n, random));
  return array;
}

TEST(NpyFiles, bring_back_arrays_of_every_shape_in_other_layouts) {
  const Folder folder;
  std::mt19937 random(seed());
  for (const index_t n : {0, 33, 3000}) {
    MarksArray<float, Host, Soa> marks(n);
    copy(marks, random_objects<tissue::model::MarksObject>(n, random));
    save_npy(marks, folder / "marks");
    MarksArray<float, Host, Aosoa<4>> loaded(7), expected(n);
    EXPECT_TRUE(load_npy(folder / "marks", loaded).complete());
    copy(expected, marks);
    expect_records(loaded.untyped(), records_of(expected.untyped()), "saving and loading");
  }
  const Folder other;
  tissue::model::ShapesArray<float> shapes(40);
  copy(shapes, random_objects<tissue::model::ShapesObject>(40, random));
  save_npy(shapes, other.path());  // a folder that is there
  tissue::model::ShapesArray<float, Host, AosPadded> back;
  EXPECT_TRUE(load_npy(other.path(), back).complete());
  tissue::model::ShapesArray<float> again(40);
  copy(again, back);
  expect_records(again.untyped(), records_of(shapes.untyped()), "saving and loading shapes");
}

TEST(NpyFiles, are_matched_by_name_and_leave_nothing_else_in_the_folder) {
  const Folder folder;
  save_npy(tets(9), folder / "tets");
  save_npy(tets(10), folder / "tets");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "tets"), {}), 1);
  MarksArray<float> marks(10);
  EXPECT_NE(message_of([&] {
              load_npy(folder / "tets", marks);
            }).find("has no .npy file of a field of the array; it has 'key', 'alive'"),
            std::string::npos);
  save_npy(marks, folder / "tets");
  Tets array;
  const Loaded loaded = load_npy(folder / "tets", array);
  EXPECT_EQ(loaded.fields, std::vector<std::string>{"nodes"});
  EXPECT_EQ(loaded.left_out.size(), 11U);
  EXPECT_EQ(array.size(), 10);
  EXPECT_NE(
      message_of([&] { load_npy(folder / "tets", array, {"node"}); }).find("has no file 'node.npy'; it has 'nodes'"),
      std::string::npos);
}

TEST(NpyFiles, that_are_damaged_are_refused_and_leave_the_array) {
  const Folder folder;
  const Tets saved = tets(100);
  save_npy(saved, folder.path());
  const std::filesystem::path file = folder / "nodes.npy";
  const std::string good = bytes_of_file(file);
  ASSERT_EQ(good.size(), 128U + 100 * 16);
  Tets array = tets(5);
  const Records before = records_of(array.untyped());
  const auto refusal = [&](const std::string& bytes) {
    write_file(file, bytes);
    const std::string message = message_of([&] { load_npy(folder.path(), array); });
    expect_records(array.untyped(), before, "a load that is refused");
    return message;
  };
  const auto with = [&](const std::string& old, const std::string& other) {
    return std::string(good).replace(good.find(old), old.size(), other);
  };
  for (const std::size_t length : {0U, 5U, 9U, 60U})
    EXPECT_NE(refusal(good.substr(0, length)).find("ends within its header"), std::string::npos) << length;
  EXPECT_NE(refusal(good.substr(0, good.size() - 1)).find("it is truncated"), std::string::npos);
  EXPECT_NE(refusal(good + "x").find("has 1601 bytes of numbers, and its header says 100 rows of 16"),
            std::string::npos);
  EXPECT_NE(refusal(with("NUMPY", "NUMPI")).find("is no .npy file"), std::string::npos);
  EXPECT_NE(
      refusal(with(std::string("\x01\x00v", 3), std::string("\x04\x00v", 3))).find("of version 4; this library reads"),
      std::string::npos);
  EXPECT_NE(refusal(with("'descr'", "'desc_'")).find("its header has no descr"), std::string::npos);
  EXPECT_NE(refusal(with("'<i4'", "'|O8'")).find("holds numbers of type '|O8'"), std::string::npos);
  EXPECT_NE(refusal(with("(100,", "(-10,")).find("a shape of no numbers"), std::string::npos);
  EXPECT_NE(refusal(with("(100,", "(999,")).find("its header says 999 rows"), std::string::npos);
  EXPECT_NE(refusal(with("'<i4'", "'<f4'")).find("has real numbers in the file and integers in the array"),
            std::string::npos);
  write_file(file, good);
  EXPECT_TRUE(load_npy(folder.path(), array).complete());
  expect_records(array.untyped(), records_of(saved.untyped()), "loading");
}

TEST(NpyFiles, are_refused_where_there_is_no_folder_for_them) {
  const Folder folder;
  write_file(folder / "file", "text");
  EXPECT_NE(message_of([&] { save_npy(tets(3), folder / "file"); }).find("cannot be a folder of .npy files"),
            std::string::npos);
  Tets array(2);
  EXPECT_NE(message_of([&] { load_npy(folder / "none", array); }).find("cannot be read as a folder"),
            std::string::npos);
  std::filesystem::create_directories(folder / "taken/nodes.npy/inner");  // a name that no file can take
  EXPECT_NE(message_of([&] { save_npy(tets(3), folder / "taken"); }).find("cannot take the place"), std::string::npos);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "taken"), {}), 1);
}

}  // namespace
}  // namespace physgen::test
