// The numbers of a file in Gmsh's format one after the other, from lines of text or from bytes, with the place of each:
// what is alike in both forms of the format. For gmsh_sections.cpp.
#pragma once

#include <physgen/error.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace physgen::fem {

/// Reads rows: in text a row is a line that is not blank, in bytes it has no mark. A section's last row comes before a
/// line with the section's end.
class GmshInput {
 public:
  static constexpr const char* again = "; the file may be cut off or damaged: write it again";

  /// @param name of the file, for messages
  GmshInput(std::string name, std::string_view bytes)
      : name_(std::move(name)), begin_(bytes.data()), at_(begin_), end_(begin_ + bytes.size()) {}

  /// The same input from a place on.
  GmshInput(const GmshInput& other, const char* at) : GmshInput(other) { at_ = at; }

  bool is_binary = false;

  [[nodiscard]] const char* at() const { return at_; }
  [[nodiscard]] std::uint64_t bytes_left() const { return static_cast<std::uint64_t>(end_ - at_); }
  [[nodiscard]] std::uint64_t offset_of(const char* place) const { return static_cast<std::uint64_t>(place - begin_); }

  /// "in line 7", or "at byte 120" where the file is not text.
  [[nodiscard]] std::string place(const char* of) const {
    if (is_binary) return "at byte " + std::to_string(of - begin_);
    return "in line " + std::to_string(1 + std::count(begin_, of, '\n'));
  }
  [[nodiscard]] std::string place_at(std::uint64_t offset) const { return place(begin_ + offset); }
  /// @throw Error with the file's name. Characters that a terminal would obey are shown as '?'.
  [[noreturn]] void refuse(std::string what) const {
    std::ranges::replace_if(what, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
    throw Error("mesh file " + name_ + ": " + what);
  }
  [[noreturn]] void refuse_at(const char* of, const std::string& what) const {
    refuse(place(of).substr(3) + ": " + what + again);  // without "in " or "at "
  }

  /// The next line that is not blank, without blanks around it; an empty one at the end of the file.
  std::string_view line() {
    do {
      const auto* newline = at_ < end_ ? static_cast<const char*>(std::memchr(at_, '\n', bytes_left())) : nullptr;
      row_ = at_;
      row_end_ = newline != nullptr ? newline : end_;
      at_ = newline != nullptr ? newline + 1 : end_;
      while (row_ < row_end_ && is_blank(*row_)) ++row_;
      while (row_ < row_end_ && is_blank(row_end_[-1])) --row_end_;
    } while (row_ == row_end_ && at_ < end_);
    return {row_, static_cast<std::size_t>(row_end_ - row_)};
  }

  /// Begins a row of a section; in text false where the section or the file ends.
  bool row(std::string_view end_of_section) {
    if (is_binary) return true;
    const std::string_view next = line();
    return !next.empty() && next != end_of_section;
  }
  /// The place of what is read next.
  [[nodiscard]] const char* here() const { return is_binary ? at_ : row_; }

  /// Passes over so many bytes of a binary file. @return the first of them
  const char* skip(std::uint64_t count) {
    if (bytes_left() < count) refuse_at(at_, "the file ends here in the middle of a section");
    at_ += count;
    return at_ - count;
  }

  /// A number of a node or an element, or a count; in bytes of the given type.
  template <class Stored>
  std::uint64_t natural() {
    const char* place = here();
    if (is_binary) {
      const auto number = bytes<Stored>();
      if (std::cmp_less(number, 0)) refuse_at(place, "'" + std::to_string(number) + "' is less than 0");
      return static_cast<std::uint64_t>(number);
    }
    return word<std::uint64_t>("a natural number");
  }
  std::int64_t integer() { return is_binary ? bytes<std::int32_t>() : word<std::int64_t>("an integer"); }
  double real() { return is_binary ? bytes<double>() : word<double>("a number"); }

  /// @throw Error when a line has more numbers than were read
  void end_row() {
    if (is_binary) return;
    while (row_ < row_end_ && is_blank(*row_)) ++row_;
    if (row_ < row_end_) refuse_at(row_, "'" + shown() + "' is more than the numbers of this line");
  }

  /// Leaves a section by its end. Text before it is passed over where `skips` is set.
  /// @return false where there is none
  bool pass(std::string_view end_of_section, bool skips) {
    while (skips && at_ < end_) {
      const auto* found =
          static_cast<const char*>(::memmem(at_, bytes_left(), end_of_section.data(), end_of_section.size()));
      if (found == nullptr) return false;
      const char* start = found;
      while (start > at_ && is_blank(start[-1])) --start;
      at_ = start;
      if (start == begin_ || start[-1] == '\n') {
        if (line() == end_of_section) return true;
      } else {
        at_ = found + 1;
      }
    }
    return line() == end_of_section;
  }

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

  [[nodiscard]] std::string shown() const {
    const char* end = row_;
    while (end < row_end_ && !is_blank(*end) && end - row_ < 40) ++end;
    return {row_, end};
  }

  template <class Stored>
  Stored bytes() {
    Stored number{};
    std::memcpy(&number, skip(sizeof number), sizeof number);
    return number;
  }

  template <class Number>
  Number word(const char* what) {
    while (row_ < row_end_ && is_blank(*row_)) ++row_;
    if (row_ == row_end_) refuse_at(row_, "the line has too few numbers");
    Number number{};
    const char* start = row_ + (*row_ == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(start, row_end_, number);
    if (error == std::errc::invalid_argument || (end < row_end_ && !is_blank(*end))) refuse_word(what);
    if (error == std::errc::result_out_of_range) {
      if constexpr (std::is_same_v<Number, double>) {
        const std::string_view digits(start, static_cast<std::size_t>(end - start));
        const bool is_small = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
        number = is_small ? 0 : std::numeric_limits<double>::infinity();
      } else {
        refuse_word(what);
      }
    }
    row_ = end;
    return number;
  }
  [[noreturn]] void refuse_word(const char* what) const {
    double number = 0;
    const std::string word = shown();
    const bool is_number = std::from_chars(word.data(), word.data() + word.size(), number).ec == std::errc();
    refuse_at(row_, "'" + word + "' is not " + (is_number ? what : "a number"));
  }

  std::string name_;
  const char *begin_, *at_, *end_;
  const char *row_ = begin_, *row_end_ = begin_;  // what is left of a line
};

}  // namespace physgen::fem
