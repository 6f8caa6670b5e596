// beads.csv is written a step at a time, and the file is closed in between.
#include <files/disk.h>
#include <physgen/error.h>
#include <truthcube/output/beads.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <system_error>

namespace physgen::truthcube {

namespace {

constexpr std::string_view header = "compression,x,y,z,ux,uy,uz\n";

void add_number(std::string& line, double value, char end) {
  std::array<char, 32> text{};
  const auto [last, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 17);
  line.append(text.data(), last);
  line += end;
}

// Where line number `lines`, counted from 1, ends; npos where there are fewer complete lines.
std::size_t end_of_line(std::string_view text, std::size_t lines) {
  std::size_t end = 0;
  for (std::size_t l = 0; l < lines; ++l) {
    const std::size_t newline = text.find('\n', end);
    if (newline == std::string_view::npos) return newline;
    end = newline + 1;
  }
  return end;
}

}  // namespace

std::vector<fem::Point> bead_positions() {
  std::vector<fem::Point> beads;
  beads.reserve(bead_count);
  for (int i = 1; i <= 7; ++i) {
    for (int j = 1; j <= 7; ++j) {
      for (int k = 1; k <= 7; ++k) beads.push_back({i * 0.01, j * 0.01, k * 0.01});
    }
  }
  return beads;
}

std::vector<fem::Index> corners_of(std::span<const fem::Location> locations, const fem::TetMesh& mesh) {
  std::vector<fem::Index> corners;
  for (const fem::Location& location : locations) {
    const auto& tet = mesh.tets[static_cast<std::size_t>(location.tet)];
    corners.insert(corners.end(), tet.begin(), tet.end());
  }
  return corners;
}

std::vector<fem::Point> interpolate_displacements(std::span<const fem::Location> locations, const fem::TetMesh& mesh,
                                                  std::span<const fem::Point> rest,
                                                  std::span<const fem::Point> corners) {
  const std::vector<fem::Index> nodes = corners_of(locations, mesh);
  if (rest.size() != static_cast<std::size_t>(mesh.nodes) || corners.size() != nodes.size()) {
    throw Error("beads: " + std::to_string(rest.size()) + " rest positions for " + std::to_string(mesh.nodes) +
                " nodes, and " + std::to_string(corners.size()) + " positions for " + std::to_string(nodes.size()) +
                " corners");
  }
  std::vector<fem::Point> displacements(locations.size(), fem::Point{});
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const fem::Point& at_rest = rest[static_cast<std::size_t>(nodes[i])];
    for (std::size_t k = 0; k < 3; ++k) {
      displacements[i / 4][k] += locations[i / 4].weights[i % 4] * (corners[i][k] - at_rest[k]);
    }
  }
  return displacements;
}

BeadFile::BeadFile(std::filesystem::path path) : path_(std::move(path)) { disk::write_text(path_, header); }

BeadFile BeadFile::append_to(std::filesystem::path path, int steps) {
  if (steps <= 0) return BeadFile(std::move(path));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path.string() + ": cannot be opened to continue after step " + std::to_string(steps));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!text.starts_with(header)) throw Error(path.string() + ": does not begin with the header of a bead file");
  const std::size_t end = end_of_line(text, 1 + bead_count * static_cast<std::size_t>(steps));
  if (end == std::string::npos) {
    throw Error(path.string() + ": has fewer rows than the " + std::to_string(bead_count) + " of each of " +
                std::to_string(steps) + " steps");
  }
  const std::string_view kept = std::string_view(text).substr(0, end);
  if (const std::size_t stray = kept.find_first_not_of("0123456789+-.e,\n", header.size()); stray != kept.npos) {
    throw Error(path.string() + ":" + std::to_string(1 + std::ranges::count(kept.substr(0, stray), '\n')) +
                ": this is not a row of numbers, so the file is damaged; run again without --restart");
  }
  disk::write_text(path, kept);
  return {std::move(path), Existing{}};
}

void BeadFile::write_step(double compression, std::span<const fem::Point> displacements) {
  if (displacements.size() != bead_count) {
    throw Error(path_.string() + ": " + std::to_string(displacements.size()) + " displacements for " +
                std::to_string(bead_count) + " beads");
  }
  const std::vector<fem::Point> rest = bead_positions();
  std::string rows;
  for (std::size_t b = 0; b < bead_count; ++b) {
    add_number(rows, compression, ',');
    for (const double x : rest[b]) add_number(rows, x, ',');
    for (std::size_t k = 0; k < 3; ++k) add_number(rows, displacements[b][k], k < 2 ? ',' : '\n');
  }
  disk::append_text(path_, rows);
}

}  // namespace physgen::truthcube
