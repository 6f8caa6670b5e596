// Files of Gmsh's format in a folder of each test's own, and what a reader says of them.
#pragma once

#include <fem/mesh/gmsh_file.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "gmsh_format.h"
#include "mesh_cases.h"

namespace physgen::fem {

using gmsh_format::Element, gmsh_format::File, gmsh_format::Tags;
using gmsh_format::in_version_1, gmsh_format::in_version_2, gmsh_format::in_version_4;

// In all versions, and binary ones.
inline std::vector<std::string> in_all_forms(const File& file) {
  return {in_version_1(file), in_version_2(file), in_version_4(file), gmsh_format::in_binary_version_2(file),
          gmsh_format::in_binary_version_4(file)};
}

// A folder of this test's own, with a blank in its name.
class GmshFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("gmsh file ") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path write(const std::string& text, const std::string& name = "mesh.msh") const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  // The message of read_gmsh() on a file, after its name; "accepted" if it reads it.
  [[nodiscard]] static std::string refusal(const std::filesystem::path& path) {
    try {
      static_cast<void>(read_gmsh(path));
    } catch (const Error& error) {
      const std::string what = error.what(), start = "physgen: mesh file " + path.string() + ": ";
      return what.starts_with(start) ? what.substr(start.size()) : "the file is not named: " + what;
    }
    return "accepted";
  }

  std::filesystem::path folder_;
};

// A mesh under tags with gaps, in random order.
inline File file_of(const reference::MeshCase& given, std::uint64_t stream) {
  auto random = reference::random_stream(stream);
  const auto tags = [&random](std::size_t count) {
    Tags all(3 * count + 5);
    std::iota(all.begin(), all.end(), std::size_t{1});
    std::ranges::shuffle(all, random);
    all.resize(count);
    return all;
  };
  File file;
  const Tags node_tags = tags(given.rest.size()), tet_tags = tags(given.mesh.tets.size());
  for (std::size_t n = 0; n < node_tags.size(); ++n) file.nodes.emplace_back(node_tags[n], given.rest[n]);
  for (std::size_t t = 0; t < tet_tags.size(); ++t) {
    Element element{tet_tags[t], 4, {}};
    for (const Index node : given.mesh.tets[t]) element.nodes.push_back(node_tags[static_cast<std::size_t>(node)]);
    file.elements.push_back(element);
  }
  return file;
}

inline std::string cut_before(const std::string& text, const std::string& mark) { return text.substr(text.find(mark)); }

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

inline File one_tet() {
  return {{{10, {0, 0, 0}}, {20, {1, 0, 0}}, {30, {0, 1, 0}}, {40, {0, 0, 1}}}, {{7, 4, {10, 20, 30, 40}}}};
}

}  // namespace physgen::fem
