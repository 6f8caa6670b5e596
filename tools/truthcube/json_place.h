// A value of a file in JSON and where it stands, so that what is wrong with it is said with its place.
#pragma once

#include <fem/mesh/mesh.h>
#include <fem/mesh/nearest_name.h>
#include <physgen/error.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "names.h"

namespace physgen::truthcube {

using Json = nlohmann::ordered_json;

/// A value and where it stands.
class Place {
 public:
  Place(const std::string& file, std::string name, const Json& json)
      : file_(&file), name_(std::move(name)), json_(&json) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error("case " + *file_ + ": " + (name_.empty() ? "" : name_ + ": ") + what);
  }

  /// An object. @throw Error for keys that it has not
  const Place& with_keys(const std::vector<std::string>& keys) const {
    if (!json_->is_object()) refuse("this must be an object with " + joined(keys) + ", not " + shown());
    for (const auto& [key, value] : json_->items()) {
      if (std::ranges::find(keys, key) != keys.end()) continue;
      const std::string near = fem::nearest_name(key, keys);
      refuse("there is no key '" + key + "' here" + (near.empty() ? "; " : "; did you mean '" + near + "'? ") +
             "there are " + joined(keys));
    }
    return *this;
  }
  [[nodiscard]] bool has(const char* key) const { return json_->contains(key); }
  [[nodiscard]] Place at(const char* key) const {
    if (!has(key)) refuse(std::string("the key '") + key + "' is missing");
    return {*file_, name_.empty() ? key : name_ + "." + key, json_->at(key)};
  }
  [[nodiscard]] std::vector<Place> list() const {
    if (!json_->is_array()) refuse("this must be a list in brackets, not " + shown());
    std::vector<Place> all;
    for (std::size_t k = 0; k < json_->size(); ++k)
      all.emplace_back(*file_, name_ + "[" + std::to_string(k) + "]", (*json_)[k]);
    return all;
  }
  /// The members of an object, under their keys.
  [[nodiscard]] std::vector<std::pair<std::string, Place>> members() const {
    if (!json_->is_object()) refuse("this must be an object in braces, not " + shown());
    std::vector<std::pair<std::string, Place>> all;
    for (const auto& [key, value] : json_->items()) all.emplace_back(key, Place(*file_, name_ + "." + key, value));
    return all;
  }
  [[nodiscard]] bool truth() const {
    if (!json_->is_boolean()) refuse("this must be true or false, not " + shown());
    return json_->get<bool>();
  }
  [[nodiscard]] double number() const {
    if (!json_->is_number()) refuse("this must be a number, not " + shown());
    return json_->get<double>();
  }
  /// @param holds what the value must be, as `what` says
  [[nodiscard]] double number(const char* what, bool (*holds)(double)) const {
    const double value = number();
    if (!holds(value)) refuse(truthcube::number(value) + " must be " + what);
    return value;
  }
  [[nodiscard]] bool is_word() const { return json_->is_string(); }
  [[nodiscard]] std::string word() const {
    if (!json_->is_string() || json_->get<std::string>().empty())
      refuse("this must be a text in quotes, not " + shown());
    return json_->get<std::string>();
  }
  [[nodiscard]] fem::Point vector() const {
    const auto numbers = list();
    if (numbers.size() != 3) refuse("this must be 3 numbers, along x, y and z, not " + std::to_string(numbers.size()));
    return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
  }

 private:
  [[nodiscard]] std::string shown() const { return json_->dump().substr(0, 40); }

  const std::string* file_;
  std::string name_;
  const Json* json_;
};

}  // namespace physgen::truthcube
