// NaN in some objects of one field, for tests of what a digest says of it.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/executor.h>

#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>

namespace physgen::test {

using Objects = std::set<index_t>;

/// Calls a function after every step.
struct Interrupted : HostExecutor {
  std::function<void()> after;
  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    HostExecutor::run(n, kernel);
    after();
  }
};

/// A digest's word on every field of numbers: whether something reads it, or the caller.
/// @param digest the file, X.digest
inline std::map<std::pair<std::string, std::string>, bool> reads_of(const std::string& digest) {
  std::ifstream in(digest);
  std::map<std::pair<std::string, std::string>, bool> reads;
  std::string line, array;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string what, name, type, word;
    words >> what >> name >> type;
    if (what == "array") array = name;
    if (what != "field" || !type.starts_with("float")) continue;
    bool& is_read = reads[{array, name}];
    while (words >> word) is_read = is_read || word == "read" || word == "output";
  }
  return reads;
}

inline void plant_nan(const UntypedArray& array, const std::string& name, const Objects& objects) {
  for (const FieldInfo& field : array.fields) {
    if (field.name != name) continue;
    const std::uint64_t bits = bits_of_no_value(field.type);
    const int size = element_bytes(field.type);
    for (const index_t i : objects)
      for (int k = 0; k < field.count; ++k)
        std::memcpy(array.address(i, field.offset + k * size, size), &bits, static_cast<std::size_t>(size));
  }
}

/// Some of `size` objects, one at least: a half of them, some, or few.
inline Objects some_of(index_t size, unsigned seed) {
  std::mt19937 random(seed);
  Objects objects = {static_cast<index_t>(random() % static_cast<unsigned>(size))};
  const unsigned one_of = 2U << (seed % 4 * 2);
  for (index_t i = 0; i < size; ++i)
    if (random() % one_of == 0) objects.insert(i);
  return objects;
}

inline std::string listed(const Objects& objects) {
  std::string text;
  for (const index_t i : objects) text += std::to_string(i) + " ";
  return text;
}

}  // namespace physgen::test
