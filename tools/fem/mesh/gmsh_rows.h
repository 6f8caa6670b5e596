// The rows of a section of a file in Gmsh's format: as many as its first row counts, no more and no fewer. For
// gmsh_sections.cpp.
#pragma once

#include <fem/mesh/gmsh_input.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace physgen::fem {

class GmshRows {
 protected:
  explicit GmshRows(GmshInput& input) : input_(input) {}

  [[nodiscard]] bool is_of_blocks() const { return version_ >= 4; }
  [[nodiscard]] std::string section() const { return name_ + " " + input_.place(start_); }

  void require_version() const {
    if ((name_ != "$NOD" && name_ != "$ELM") == (version_ >= 2)) return;
    input_.refuse_at(start_,
                     name_ + " is not of version " + (version_ < 2 ? "1" : "2 or 4.1") + ", as which the file begins");
  }

  // The numbers of a section's first row.
  std::array<std::uint64_t, 2> counts() {
    if (input_.is_binary && is_of_blocks()) {
      std::array<std::uint64_t, 2> numbers{};
      for (std::uint64_t& number : numbers) number = input_.natural<std::uint64_t>();
      for (int k = 0; k < 2; ++k) input_.natural<std::uint64_t>();  // the lowest and the highest tag
      return numbers;
    }
    const std::string_view line = input_.line();
    if (line.empty()) refuse_end();
    constexpr std::uint64_t most = std::uint64_t{1} << 60;
    std::array<std::uint64_t, 2> numbers{};
    const char *at = line.data(), *end = at + line.size();
    for (std::size_t k = 0; k < (is_of_blocks() ? 2 : 1); ++k) {
      while (at < end && (*at == ' ' || *at == '\t')) ++at;
      const auto [next, error] = std::from_chars(at, end, numbers.at(k));
      if (error != std::errc() || numbers.at(k) > most || (next < end && *next != ' ' && *next != '\t')) {
        input_.refuse_at(line.data(), name_ + " must begin with the counts of what follows, not with '" +
                                          std::string(line.substr(0, 40)) + "'");
      }
      at = next;
    }
    return numbers;
  }

  // ---- Rows

  void row() {
    if (!input_.row(end_)) refuse_rows();
  }

  /// @throw Error when there cannot be as many rows, of so many bytes in a binary file, in what is left of it
  void require_rows(std::uint64_t count, std::uint64_t bytes) const {
    if (!input_.is_binary || count <= input_.bytes_left() / bytes) return;
    input_.refuse_at(input_.at(), name_ + " has " + std::to_string(count) + " rows of " + std::to_string(bytes) +
                                      " bytes from here on by its counts, and the file ends after " +
                                      std::to_string(input_.bytes_left()) + " bytes");
  }

  /// How many rows to make room for: no more than a file of this size can have.
  [[nodiscard]] std::size_t room_for(std::uint64_t count) const { return std::min(count, input_.bytes_left() / 8); }

  [[noreturn]] void refuse_end() const { input_.refuse(section() + " has no " + end_ + GmshInput::again); }

  // For a section that does not end where it should.
  [[noreturn]] void refuse_rows() const {
    GmshInput again(input_, start_);
    again.line();  // the section's name
    if (input_.is_binary) {
      if (!again.pass(end_, true)) refuse_end();
      input_.refuse_at(input_.at(), section() + " has other rows than it counts");
    }
    again.line();  // the counts
    std::uint64_t lines = 0;
    std::string_view line = again.line();
    for (; !line.empty() && line != end_; line = again.line()) ++lines;
    if (line.empty()) refuse_end();
    if (lines == said_) {
      input_.refuse(section() + " has blocks that have other sums than its first counts" + GmshInput::again);
    }
    input_.refuse(section() + " should have " + std::to_string(said_) + " lines by its counts, but has " +
                  std::to_string(lines) + " before " + end_ + " " + input_.place(line.data()) + GmshInput::again);
  }

  // The rows of a block, taken from those that are left of a section.
  std::uint64_t take(std::uint64_t rows, std::uint64_t& left) const {
    if (rows > left) refuse_rows();
    left -= rows;
    return rows;
  }

  GmshInput& input_;
  double version_ = 1;
  // The section that is being read.
  const char* start_ = nullptr;
  std::string name_, end_;
  std::uint64_t said_ = 0;  // lines behind the first one, as that says
};

}  // namespace physgen::fem
