#include "json_place.h"

#include <set>

namespace physgen::truthcube {

Json parsed_json(const std::string& file, std::istream& stream) {
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  std::string repeated;
  const auto see = [&](int /*depth*/, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second) {
      repeated = value.get<std::string>();
    }
    return true;
  };
  Json json;
  try {
    json = Json::parse(stream, see, true, true);
  } catch (const Json::exception& error) {
    std::string said = error.what();
    said = said.substr(said.find("] ") == said.npos ? 0 : said.find("] ") + 2);
    std::ranges::replace_if(said, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
    throw Error("case " + file + ": this is not JSON: " + said);
  }
  if (!repeated.empty())
    throw Error("case " + file + ": the key '" + repeated + "' stands twice in one object; remove one");
  return json;
}

}  // namespace physgen::truthcube
