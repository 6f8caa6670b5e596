#include <fem/mesh/gmsh_text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace physgen::fem {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";
constexpr const char* again = "; the file may be cut off or damaged: write it again";

std::string_view trimmed(std::string_view line) {
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(blanks) + 1 - first);
}

// The words of a line; none is empty.
template <class Visit>
void each_word(std::string_view line, const Visit& visit) {
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    visit(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
}

template <class Number>
bool is_number(std::string_view word, Number& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error != std::errc::invalid_argument && end == word.data() + word.size();  // or beyond what doubles hold
}

// The numbers of a section's nodes or elements, of versions before 4: Gmsh keeps one of two with the same number, and
// the other is then missing without a word. Rows that say the same, as of an element in two physical groups, may
// repeat.
class Numbers {
 public:
  /// @param content all of a row but its number and groups
  void add(std::int64_t number, std::string_view content, std::size_t line) {
    rows_.push_back(
        {number, static_cast<std::uint32_t>(std::hash<std::string_view>{}(content)), static_cast<std::uint32_t>(line)});
  }
  /// "node 7 stands in line 9 and, with other values, in line 12"; or nothing
  std::string fault(const char* kind) {
    if (!std::ranges::is_sorted(rows_, {}, &Row::number)) std::ranges::stable_sort(rows_, {}, &Row::number);
    const auto found = std::ranges::adjacent_find(
        rows_, [](const Row& a, const Row& b) { return a.number == b.number && a.content != b.content; });
    if (found == rows_.end()) return "";
    return kind + (" " + std::to_string(found->number)) + " stands in line " + std::to_string(found->line) +
           " and, with other values, in line " + std::to_string((found + 1)->line) +
           "; give each a number of its own, or write the mesh again";
  }

 private:
  struct Row {
    std::int64_t number;
    std::uint32_t content, line;
  };
  std::vector<Row> rows_;
};

class Reader {
 public:
  explicit Reader(std::istream& file) : file_(file) {}

  std::string fault() {
    while (next()) {
      if (!text_.starts_with('$') || text_.starts_with("$End") || text_.starts_with("$END")) continue;  // as Gmsh does
      const std::string name(text_.substr(1));
      const bool is_first_version = name == "NOD" || name == "ELM";
      const std::string end = (is_first_version ? "$END" : "$End") + name;
      const std::size_t start = number_;
      if (name == "MeshFormat" && next()) {
        read_format();
        if (is_binary_) return fault_in_binary();
      }
      const bool counts = is_first_version || name == "Nodes" || name == "Elements";
      std::string found = counts ? fault_in_counted(name, end) : "";
      if (!found.empty()) return found;
      while (text_ != end) {
        if (!next()) return "$" + name + " in line " + std::to_string(start) + " has no " + end + again;
      }
    }
    return "";
  }

 private:
  bool next() {
    if (!std::getline(file_, line_)) return false;
    ++number_;
    text_ = trimmed(line_);
    return true;
  }

  void read_format() {
    std::array<double, 2> words{};
    std::size_t count = 0;
    each_word(text_, [&](std::string_view word) {
      if (count < words.size()) static_cast<void>(is_number(word, words[count++]));
    });
    version_ = words[0];
    is_binary_ = words[1] != 0;
  }

  std::string fault_in_binary() {
    std::string end;
    for (std::array<char, 4096> part{}; file_.read(part.data(), part.size()) || file_.gcount() > 0;) {
      end.append(part.data(), static_cast<std::size_t>(file_.gcount()));
      if (end.size() > 256) end.erase(0, end.size() - 256);
    }
    const std::size_t last = end.find_last_not_of(" \t\r\n");
    const std::size_t line = end.find_last_of("\n", last);
    if (last != std::string::npos && line != std::string::npos && end.compare(line + 1, 4, "$End") == 0) return "";
    return "does not end with the end of a section" + std::string(again);
  }

  // The number of lines that a section must have behind its first. Negative where the first says no numbers.
  [[nodiscard]] std::int64_t lines_of(const std::string& name) const {
    std::vector<std::int64_t> counts;
    each_word(text_, [&](std::string_view word) {
      std::int64_t count = -1;  // stays, beyond what 64 bits hold
      counts.push_back(is_number(word, count) ? count : -1);
    });
    const bool has_blocks = version_ >= 4;
    if (counts.size() < (has_blocks ? 2U : 1U) || std::ranges::any_of(counts, [](auto count) { return count < 0; })) {
      return -1;
    }
    if (!has_blocks) return counts[0];
    constexpr std::int64_t most = std::int64_t{1} << 60;
    if (counts[0] > most || counts[1] > most) return -1;
    const bool apart = name == "Nodes" && version_ > 4.05;  // numbers of nodes and coordinates have lines of their own
    return counts[0] + (apart ? 2 : 1) * counts[1];
  }

  std::string fault_in_counted(const std::string& name, const std::string& end) {
    const std::size_t start = number_;
    const auto place = [&] { return "line " + std::to_string(number_) + ": "; };
    do {
      if (!next()) return "$" + name + " in line " + std::to_string(start) + " has no " + end + again;
    } while (text_.empty());
    const std::int64_t said = lines_of(name);
    if (said < 0)
      return place() + "$" + name + " must begin with the counts of what follows, not with '" + line_of() + "'" + again;
    std::int64_t lines = 0;
    const bool are_nodes = name == "NOD" || name == "Nodes";
    Numbers numbers;
    for (;;) {
      if (!next()) return "$" + name + " in line " + std::to_string(start) + " has no " + end + again;
      if (text_ == end) break;
      if (text_.empty()) continue;
      ++lines;
      std::string wrong;
      each_word(text_, [&](std::string_view word) {
        double number = 0;
        if (wrong.empty() && !is_number(word, number)) wrong = word.substr(0, 40);
      });
      if (!wrong.empty()) return place() + "'" + wrong + "' is not a number" + again;
      if (version_ < 4) add_row(numbers, are_nodes);
    }
    if (lines == said) return numbers.fault(are_nodes ? "node" : "element");
    return "$" + name + " in line " + std::to_string(start) + " should have " + std::to_string(said) +
           " lines by its counts, but has " + std::to_string(lines) + " before " + end + " in line " +
           std::to_string(number_) + again;
  }

  // An element is its number, type, groups and nodes: of the first version two groups and the number of nodes, of the
  // second the number of groups before them.
  void add_row(Numbers& numbers, bool are_nodes) {
    std::int64_t number = 0, groups = 2;
    std::size_t count = 0;
    content_.clear();
    each_word(text_, [&](std::string_view word) {
      const auto k = static_cast<std::int64_t>(count++);
      if (k == 0) static_cast<void>(is_number(word, number));
      if (!are_nodes && version_ >= 2 && k == 2) static_cast<void>(is_number(word, groups));
      const std::int64_t before = are_nodes ? 1 : (version_ >= 2 ? 3 : 2);  // the groups
      const bool is_content = k >= before && k - before >= (are_nodes ? 0 : groups);
      if (is_content || (k == 1 && !are_nodes)) content_.append(word).append(" ");
    });
    numbers.add(number, content_, number_);
  }

  [[nodiscard]] std::string line_of() const { return std::string(text_.substr(0, 40)); }

  std::istream& file_;
  std::string line_;
  std::string_view text_;  // of line_, without blanks around it
  std::string content_;
  std::size_t number_ = 0;
  double version_ = 1;
  bool is_binary_ = false;
};

}  // namespace

std::string fault_in_gmsh_text(std::istream& file) {
  std::string fault = Reader(file).fault();
  std::ranges::replace_if(fault, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');  // as a terminal can show it
  return fault;
}

}  // namespace physgen::fem
