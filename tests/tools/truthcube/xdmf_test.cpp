// The XDMF file beside a VTKHDF file: each part that it names of each dataset is that of its step, also after restarts.
#include <fem/mesh/boundary.h>
#include <truthcube/output/vtkhdf.h>

#include <sstream>

#include "scratch.h"
#include "vtkhdf_scene.h"

namespace physgen::truthcube {
namespace {

using testing::H5File;
using testing::read_text;
using testing::Scene;
using Numbers = std::vector<hsize_t>;

/// A DataItem: the shape that it is said to have, its dataset, and of parts where they begin, their steps between
/// entries, their shape and that of the dataset.
struct Item {
  Numbers dimensions;
  std::string dataset;
  std::vector<Numbers> part;
};

Numbers numbers_in(const std::string& text) {
  std::istringstream words(text);
  Numbers numbers;
  for (hsize_t number = 0; words >> number;) numbers.push_back(number);
  EXPECT_TRUE(words.eof()) << text;
  return numbers;
}

/// What stands between `before`, looked for from `at` on, and `after`; `at` moves behind it.
std::string between(const std::string& text, std::size_t& at, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before, at) + before.size();
  at = text.find(after, begin);
  return text.substr(begin, at - begin);
}

std::vector<Item> items_in(const std::string& text, const std::string& file) {
  std::vector<Item> items;
  for (std::size_t at = 0; text.find("<DataItem", at) != std::string::npos;) {
    Item item{numbers_in(between(text, at, " Dimensions=\"", "\"")), between(text, at, ">" + file + ":", "</"), {}};
    const std::size_t bar = item.dataset.find('|');
    if (bar != std::string::npos) {
      std::istringstream parts(item.dataset.substr(bar + 1));
      for (std::string part; std::getline(parts, part, ':');) item.part.push_back(numbers_in(part));
      item.dataset.resize(bar);
    }
    items.push_back(item);
  }
  return items;
}

class Xdmf : public testing::Scratch {
 public:
  Scene scene;
  std::filesystem::path path = in_folder("cube.vtkhdf"), xdmf = in_folder("cube.xdmf");

  void expect_steps(int steps) const {
    const std::string text = read_text(xdmf);
    std::size_t at = 0;
    for (int s = 0; s < steps; ++s) EXPECT_EQ(std::stod(between(text, at, "<Time Value=\"", "\"")), Scene::time(s));
    EXPECT_EQ(text.find("<Time", at), std::string::npos);
    EXPECT_TRUE(text.ends_with("</Grid>\n</Grid>\n</Domain>\n</Xdmf>\n"));
    const std::vector<Item> items = items_in(text, "cube.vtkhdf");
    const std::array fields{"Point|displacement", "Point|pressure", "Cell|J", "Cell|stress"};
    ASSERT_EQ(items.size(), (2 + fields.size()) * static_cast<std::size_t>(steps));
    const H5File file(path);
    for (std::size_t k = 0; k < items.size(); ++k) {
      const std::size_t step = k / (2 + fields.size()), which = k % (2 + fields.size());
      const Item& item = items[k];
      if (which < 2) {
        EXPECT_EQ(item.dataset, which == 0 ? "/VTKHDF/Connectivity" : "/VTKHDF/Points");
        EXPECT_EQ(item.dimensions, file.shape(item.dataset));
        EXPECT_TRUE(item.part.empty());
        continue;
      }
      const std::string field = fields[which - 2];
      const std::size_t bar = field.find('|');
      EXPECT_EQ(item.dataset, "/VTKHDF/" + field.substr(0, bar) + "Data/" + field.substr(bar + 1));
      Numbers shape = file.shape(item.dataset), begin(shape.size());
      ASSERT_EQ(item.part.size(), 4U) << item.dataset;
      EXPECT_EQ(item.part[3], shape);
      shape[0] = field.starts_with("Point") ? scene.nodes() : scene.tets();
      begin[0] = shape[0] * step;
      EXPECT_EQ(item.part[0], begin) << item.dataset << " of step " << step;
      EXPECT_EQ(item.part[1], Numbers(shape.size(), 1));
      EXPECT_EQ(item.part[2], shape);
      EXPECT_EQ(item.dimensions, shape);
    }
  }
};

TEST_F(Xdmf, names_the_values_of_every_step) {
  VtkHdfWriter writer = scene.create(path, 0);
  EXPECT_FALSE(std::filesystem::exists(xdmf));
  for (int steps = 1; steps <= 3; ++steps) {
    scene.write_step(writer, steps - 1);
    expect_steps(steps);
  }
}

TEST_F(Xdmf, has_the_steps_alone_that_a_restart_keeps) {
  static_cast<void>(scene.create(path, 4));
  VtkHdfWriter writer = scene.append_to(path, 2);
  expect_steps(2);
  scene.write_step(writer, 2);
  expect_steps(3);
  static_cast<void>(scene.append_to(path, 0));
  EXPECT_FALSE(std::filesystem::exists(xdmf));
  std::size_t files = 0;  // the copy that took the place of a file had none of its own
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path.parent_path())) ++files;
  EXPECT_EQ(files, 1U);
}

TEST_F(Xdmf, of_another_program_is_neither_replaced_nor_removed) {
  const std::string others = "<Xdmf><DataItem Format=\"HDF\">mycube.vtkhdf:/VTKHDF/Points</DataItem></Xdmf>\n";
  const auto refused = [&](const auto& write) {
    std::ofstream(xdmf) << others;
    try {
      write();
      ADD_FAILURE() << "replaced";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()), "physgen: " + xdmf.string() +
                                               ": names no values of cube.vtkhdf, so another program wrote it, and it "
                                               "is not replaced; move it away, or write to another folder");
    }
    EXPECT_EQ(read_text(xdmf), others);
  };
  refused([&] { static_cast<void>(scene.create(path, 0)); });
  EXPECT_FALSE(std::filesystem::exists(path));
  std::filesystem::remove(xdmf);
  static_cast<void>(scene.create(path, 2));
  const std::string before = read_text(path);
  for (const int steps : {0, 1, 2}) refused([&] { static_cast<void>(scene.append_to(path, steps)); });
  EXPECT_EQ(read_text(path), before);
}

TEST_F(Xdmf, surfaces_are_triangles_whose_groups_are_those_of_all_steps) {
  const std::vector<fem::Face> triangles{{0, 1, 2}, {2, 1, 3}, {5, 4, 3}};
  const std::vector<CellGroup> groups{{"group_a", {1, 0, 1}}};
  VtkHdfWriter writer(path, {scene.points, triangles, groups});
  const std::vector<double> values(3);
  for (int step = 0; step < 2; ++step) writer.write_step(Scene::time(step), {}, std::array{Field{"J", 1, values}});
  const std::string text = read_text(xdmf);
  const std::vector<Item> items = items_in(text, "cube.vtkhdf");
  ASSERT_EQ(items.size(), 8U);
  const H5File file(path);
  for (const std::size_t k : {0, 4}) {
    EXPECT_EQ(items[k].dataset, "/VTKHDF/Connectivity");
    EXPECT_EQ(items[k].dimensions, Numbers{9});
    EXPECT_EQ(items[k + 2].dataset, "/VTKHDF/CellData/group_a");
    EXPECT_EQ(items[k + 2].dimensions, file.shape("/VTKHDF/CellData/group_a"));
    EXPECT_TRUE(items[k + 2].part.empty());
    EXPECT_EQ(items[k + 3].part[3], file.shape("/VTKHDF/CellData/J"));
  }
  EXPECT_NE(text.find("TopologyType=\"Triangle\" NumberOfElements=\"3\""), std::string::npos) << text;
  EXPECT_NE(text.find("NumberType=\"UChar\" Precision=\"1\" Dimensions=\"3\""), std::string::npos) << text;
}

TEST_F(Xdmf, names_of_fields_are_escaped) {
  VtkHdfWriter writer = scene.create(path, 0);
  const std::vector<double> values(scene.tets());
  writer.write_step(0, {}, std::array{Field{"a<b & \"c\"", 1, values}});
  const std::string text = read_text(xdmf);
  EXPECT_NE(text.find("Name=\"a&lt;b &amp; &quot;c&quot;\""), std::string::npos) << text;
  EXPECT_NE(text.find(":/VTKHDF/CellData/a&lt;b &amp; &quot;c&quot;|"), std::string::npos) << text;
}

}  // namespace
}  // namespace physgen::truthcube
