// See printer.h.
#include "emit/printer.h"

#include <algorithm>

namespace physgen::emit {
namespace {

constexpr std::size_t step = 2;

// A backslash at the end of a line comment would pull the next line into it.
std::string_view without_end(std::string_view line) {
  while (!line.empty() && (line.back() == ' ' || line.back() == '\t' || line.back() == '\r' || line.back() == '\\')) {
    line.remove_suffix(1);
  }
  return line;
}

}  // namespace

void Printer::line(std::string_view text) {
  if (!text.empty()) text_.append(indent_, ' ').append(text);
  text_ += '\n';
}

void Printer::label(std::string_view text) {
  text_.append(indent_ - step + 1, ' ').append(text);
  text_ += '\n';
}

void Printer::open(std::string_view text) {
  line(text);
  indent_ += step;
}

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

void Printer::list(std::string_view head, const std::vector<std::string>& items, std::string_view tail) {
  std::string current(head);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool first = i == 0, last = i + 1 == items.size();
    const std::string item = items[i] + (last ? std::string(tail) : ",");
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
  std::size_t end = text.size();
  if (text.compare(begin, 7, "return ") == 0 && call < room) {
    end = call + 1;
  } else if (sum != std::string::npos && sum > begin) {
    end = sum + 2;
  }
  line(text.substr(0, end));
  if (end == text.size()) return;
  wrapped(std::string(begin + 2 * step, ' ') + text.substr(text[end] == ' ' ? end + 1 : end));
}

void Printer::comment(std::string_view marker, std::string_view text) {
  const std::string start(marker);
  while (true) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view rest = without_end(text.substr(0, end));
    do {
      std::size_t length = rest.size();
      if (!fits(start.size() + 1 + length)) {
        const std::size_t room = columns - std::min(columns, indent_ + start.size() + 1);
        length = rest.rfind(' ', room);
        if (length == std::string_view::npos || rest.find_first_not_of(' ') > length) length = rest.find(' ', room);
        length = std::min(length, rest.size());
      }
      const std::string_view piece = without_end(rest.substr(0, length));
      line(piece.empty() ? start : start + " " + std::string(piece));
      rest.remove_prefix(length);
      rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    } while (!rest.empty());
    if (end == text.size()) return;
    text.remove_prefix(end + 1);
  }
}

}  // namespace physgen::emit
