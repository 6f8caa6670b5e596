// The frame of truthcube's programs: they read the command line, and turn errors into text and an exit status.
#pragma once

#include <fcntl.h>
#include <physgen/distributed/ranks.h>
#include <physgen/threads.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace physgen::truthcube {

/// The text of an error for a user: without the library's name before it.
[[nodiscard]] inline std::string text_of(const std::exception& error) {
  const std::string text = error.what(), prefix = "physgen: ";
  return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

/// Takes the descriptors of standard streams that are closed: else the next file to be opened would have one of them,
/// and what is printed would be written into that file.
inline void open_standard_streams() {
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) file = ::open("/dev/null", O_RDWR);
  if (file >= 0) ::close(file);
}

/// The word as a shell takes it.
[[nodiscard]] inline std::string quoted(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// @return the status, or 1 where what was printed cannot be written, which it then says
[[nodiscard]] inline int status_of_output(const std::string& name, int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  std::fprintf(stderr, "%s: cannot write all of the standard output; is the disk full?\n", name.c_str());
  return status == 0 ? 1 : status;
}

/// What run_program() does on one of the ranks, of which the first prints.
template <class Parse, class Run>
[[nodiscard]] int run_on(const Ranks& ranks, const std::string& name, const std::vector<std::string>& arguments,
                         const Parse& parse, const Run& run) {
  std::string command = name;
  for (const std::string& word : arguments) command += " " + quoted(word);
  ranks.agree("command", command);  // first: where one rank alone refused its words, the others would wait for it
  decltype(parse(arguments)) options;
  std::string wrong;
  try {
    options = parse(arguments);
  } catch (const std::exception& error) {
    wrong = text_of(error);
  }
  ranks.agree("error in its command", wrong.empty() ? "none" : wrong);  // such as a file that others have
  if (!wrong.empty()) {
    if (!ranks.is_first()) return 2;
    std::fprintf(stderr, "%s: %s\n%s --help lists all flags.\n", name.c_str(), wrong.c_str(), name.c_str());
    return 2;
  }
  if (!options.help.empty()) {
    if (ranks.is_first()) std::printf("%s", options.help.c_str());
    return status_of_output(name, 0);
  }
  set_threads(options.threads);
  if (const std::string remark = remark_on_threads(); ranks.is_first() && !remark.empty()) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), remark.c_str());
  }
  try {
    return status_of_output(name, run(std::move(options), command, ranks));
  } catch (const std::exception& error) {
    if (ranks.count() == 1) throw;
    ranks.fail(text_of(error));
  }
}

/// @param parse makes options, with `help` and `threads`, of the words behind the program's name
/// @param run takes the options, the command as it was typed and the ranks, and gives the exit status
/// @return the exit status: 2 for a command line that is not understood, 1 where run() throws or output cannot be
/// written; with several ranks, what is thrown on one ends all
template <class Parse, class Run>
[[nodiscard]] int run_program(const std::string& name, int count, char** words, const Parse& parse, const Run& run) {
  open_standard_streams();
  try {
    const Ranks ranks(count, words);
    return run_on(ranks, name, {words + 1, words + count}, parse, run);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), text_of(error).c_str());
    return 1;
  }
}

}  // namespace physgen::truthcube
