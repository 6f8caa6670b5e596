// Keeps the models by the names of their rows.
#include "measure/model.h"

#include <map>

namespace physgen::bench {

namespace {

std::map<std::string, std::function<Counters()>>& models() {
  static std::map<std::string, std::function<Counters()>> all;
  return all;
}

}  // namespace

std::function<Counters()> model_of(const Row& row) {
  const std::string key = row.kernel + "/" + row.storage + "/" + row.layout;
  return [key] {
    const auto found = models().find(key);
    return found == models().end() ? Counters() : found->second();
  };
}

bool add_model(const std::string& row, std::function<Counters()> count) {
  models()[row] = std::move(count);
  return true;
}

}  // namespace physgen::bench
