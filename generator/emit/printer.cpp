// See printer.h.
#include "emit/printer.h"

#include <algorithm>
#include <cctype>

namespace physgen::emit {
namespace {

constexpr std::size_t step = 2;

// A backslash at the end of a line comment would pull the next line into it; compilers warn of its trigraph.
std::string_view without_end(std::string_view line) {
  while (!line.empty()) {
    const bool trigraph = line.ends_with("?\?/");
    if (!trigraph && std::string_view(" \t\r\\").find(line.back()) == std::string_view::npos) break;
    line.remove_suffix(trigraph ? 3 : 1);
  }
  return line;
}

bool begins_with_a_word(std::string_view line) {
  return !line.empty() && (std::isalnum(static_cast<unsigned char>(line.front())) != 0 || line.front() == '(');
}

}  // namespace

void Printer::line(std::string_view text) {
  if (!text.empty()) text_.append(indent_, ' ').append(text);
  text_ += '\n';
}

void Printer::open(std::string_view text) {
  line(text);
  open();
}

void Printer::open() { indent_ += step; }

void Printer::close(std::string_view text) {
  indent_ -= step;
  line(text);
}

void Printer::function(std::string_view signature, const std::vector<std::string>& statements) {
  const std::string head = std::string(signature) + " {";
  if (statements.size() == 1 && fits(head.size() + statements.front().size() + 3)) {
    line(head + " " + statements.front() + " }");
    return;
  }
  open(head);
  for (const std::string& statement : statements) wrapped(statement);
  close("}");
}

void Printer::list(std::string_view head, const std::vector<std::string>& items, std::string_view tail,
                   std::string_view between) {
  std::string current(head);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool first = i == 0, last = i + 1 == items.size();
    const std::string item = items[i] + std::string(last ? tail : between);
    if (!first && !fits(current.size() + 1 + item.size())) {
      wrapped(current);
      current = std::string(head.size(), ' ') + item;
    } else {
      current += (first ? "" : " ") + item;
    }
  }
  wrapped(current);
}

void Printer::wrapped(const std::string& text) {
  if (fits(text.size())) {
    line(text);
    return;
  }
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t room = columns - std::min(columns, indent_);
  const std::size_t call = text.find('(', begin);
  const std::size_t sum = text.rfind(" + ", room - std::min<std::size_t>(room, 2));
  const std::size_t comma = text.rfind(", ", room - std::min<std::size_t>(room, 1));
  std::size_t end = text.size();
  if (text.compare(begin, 7, "return ") == 0 && call < room) {
    end = call + 1;
  } else if (sum != std::string::npos && sum > begin) {
    end = sum + 2;
  } else if (comma != std::string::npos && comma > begin) {
    end = comma + 1;
  }
  line(text.substr(0, end));
  if (end == text.size()) return;
  wrapped(std::string(begin + 2 * step, ' ') + text.substr(text[end] == ' ' ? end + 1 : end));
}

void Printer::filled(std::string_view head, const std::vector<std::string>& items, std::string_view tail,
                     std::string_view between) {
  std::string whole(head);
  for (std::size_t i = 0; i < items.size(); ++i) whole += (i == 0 ? "" : std::string(between) + " ") + items[i];
  whole += tail;
  if (fits(whole.size())) return line(whole);
  wrapped(std::string(without_end(head)));
  list("    ", items, tail, between);
}

void Printer::comment(std::string_view marker, std::string_view text) {
  const std::string start(marker);
  std::string rest;  // of a line that was too long; it goes on in the next line of the same paragraph
  while (true) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view next = without_end(text.substr(0, end));
    if (!rest.empty() && begins_with_a_word(next)) {
      rest += ' ';
    } else if (!rest.empty()) {
      line(start + " " + rest);
      rest.clear();
    }
    rest += next;
    bool wrapped = false;
    for (; !fits(start.size() + 1 + rest.size()); wrapped = true) {
      const std::size_t room = columns - std::min(columns, indent_ + start.size() + 1);
      const std::size_t text_begin = rest.find_first_not_of(' ');
      std::size_t length = rest.rfind(' ', room);
      if (length == std::string::npos || length < text_begin) length = rest.find(' ', text_begin);
      if (length == std::string::npos) break;
      line(start + " " + std::string(without_end(rest.substr(0, length))));
      rest.erase(0, rest.find_first_not_of(' ', length));
    }
    if (!wrapped || end == text.size()) {
      line(rest.empty() ? start : start + " " + rest);
      rest.clear();
    }
    if (end == text.size()) return;
    text.remove_prefix(end + 1);
  }
}

}  // namespace physgen::emit
