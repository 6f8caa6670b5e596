// Lines of C++ text with the indentation of the block they stand in, and no line longer than it must be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace physgen::emit {

class Printer {
 public:
  static constexpr std::size_t columns = 120;

  /// One line; an empty one has no indentation.
  void line(std::string_view text = {});
  /// A line that begins a block, the lines of which are indented until close().
  void open(std::string_view text);
  /// The same behind a line that was printed otherwise.
  void open();
  void close(std::string_view text);

  /// A line, broken where it is too long: a return statement behind its first "(", anything else behind a " +"
  /// or, where there is none, a ",".
  void wrapped(const std::string& text);
  /// A function, on one line if it is one statement that fits: "signature { statement }".
  void function(std::string_view signature, const std::vector<std::string>& statements);
  /// "head(first, second);" on one line if it fits, else broken before items, which are then aligned behind `head`.
  void list(std::string_view head, const std::vector<std::string>& items, std::string_view tail,
            std::string_view between = ",");
  /// The same, broken behind `head`, with as many items on each further line as fit.
  void filled(std::string_view head, const std::vector<std::string>& items, std::string_view tail,
              std::string_view between = ",");
  /// A comment, each line after `marker` ("//" or "///"), its lines kept where they fit. One that does not is
  /// wrapped, and the rest of its paragraph with it.
  void comment(std::string_view marker, std::string_view text);

  [[nodiscard]] std::string text() && { return std::move(text_); }

 private:
  [[nodiscard]] bool fits(std::size_t length) const { return indent_ + length <= columns; }

  std::string text_;
  std::size_t indent_ = 0;
};

}  // namespace physgen::emit
