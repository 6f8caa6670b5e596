// The part that the command lines of truthcube's programs share: choices by name, and flags that do not exist. Includes
// CLI11, which is much to compile.
#pragma once

#include <physgen/error.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "names.h"

namespace physgen::truthcube {

/// The value of a name. @param kind what the names are of: "material" @throw Error naming what there is
template <class Value>
[[nodiscard]] Value value_of(const std::string& flag, const std::string& kind, const Names<Value>& names,
                             const std::string& word) {
  for (const auto& [name, value] : names) {
    if (name == word) return value;
  }
  throw Error(flag + ": " + unknown(kind, word, words_of(names)) + " This build has " + joined(words_of(names)));
}

/// A choice by name.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& flag, Value& value, const Names<Value>& names,
                        const std::string& kind, const std::string& help) {
  const auto choose = [&value, names, flag, kind](const std::string& word) {
    value = value_of(flag, kind, names, word);
  };
  return app.add_option_function<std::string>(flag, choose, help)
      ->type_name("{" + joined(words_of(names)) + "}")
      ->default_str(name_of(names, value));
}

/// One or more choices by name.
template <class Value>
CLI::Option* add_choices(CLI::App& app, const std::string& flag, std::vector<Value>& values, const Names<Value>& names,
                         const std::string& kind, const std::string& help) {
  const auto choose = [&values, names, flag, kind](const std::vector<std::string>& words) {
    values.clear();
    values.reserve(words.size());
    for (const std::string& word : words) values.push_back(value_of(flag, kind, names, word));
  };
  std::vector<std::string> chosen;
  chosen.reserve(values.size());
  for (const Value& value : values) chosen.push_back(name_of(names, value));
  return app.add_option_function<std::vector<std::string>>(flag, choose, help)
      ->type_name("{" + joined(words_of(names)) + "} ...")
      ->default_str(joined(chosen));
}

/// That a value is a whole number of a range.
[[nodiscard]] inline CLI::Validator whole_number(int least, int most) {
  const auto check = [least, most](const std::string& word) -> std::string {
    int value = 0;
    if (CLI::detail::lexical_cast(word, value) && value >= least && value <= most) return {};
    return "Value " + word + " not in range " + std::to_string(least) + " to " + std::to_string(most) +
           " of whole numbers";
  };
  return {check, "INT in [" + std::to_string(least) + " - " + std::to_string(most) + "]"};
}

/// An empty word would be the number 0, or a file without a name. @throw Error naming the flag that it belongs to
inline void refuse_empty_words(const std::vector<std::string>& arguments) {
  std::string flag;
  for (const std::string& word : arguments) {
    const bool is_flag = word.starts_with('-');
    if (is_flag) flag = word.substr(0, word.find('='));
    if (!word.empty() && !(is_flag && word.ends_with('='))) continue;
    throw Error((flag.empty() ? "" : flag + ": ") +
                "a word is empty, perhaps because a shell variable is not set; leave the flag out, or give a value");
  }
}

/// @throw Error for the first word that looks like a flag and is none
inline void refuse_unknown_flags(const CLI::App& app, const std::vector<std::string>& arguments) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  for (const std::string& word : arguments) {
    const std::string flag = word.substr(0, word.find('='));
    if (flag.starts_with("--") && std::ranges::find(flags, flag) == flags.end()) {
      throw Error(unknown("flag", flag, flags));
    }
  }
}

/// Parses the words behind a program's name. @return the help text where it was asked for, else nothing
/// @throw Error for what is not understood
[[nodiscard]] inline std::string parse_words(CLI::App& app, const std::vector<std::string>& arguments) {
  try {
    refuse_unknown_flags(app, arguments);
    refuse_empty_words(arguments);
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    app.parse(std::move(reversed));
  } catch (const CLI::CallForHelp&) {
    return app.help();
  } catch (const CLI::ConversionError& error) {  // names are converted by value_of()
    throw Error(error.what() + std::string("; give a number there"));
  } catch (const CLI::ParseError& error) {
    throw Error(error.what());
  }
  return {};
}

}  // namespace physgen::truthcube
