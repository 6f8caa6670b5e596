// Drawings for other tools: layout_json() of layout_boxes.h.
#include <nlohmann/json.hpp>

#include "layout_boxes.h"

namespace physgen::command {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;             // counts up when an old reader would misread a new file
constexpr int most_named_cells = 32;  // of one box

Json write(const LayoutMap& map, const Accessor& accessor) {
  return {{"name", accessor.name},
          {"elements", accessor.elements()},
          {"format", format_word(accessor, map.precision)},
          {"offset", accessor.offset(0)},
          {"bytes", accessor.elements() * accessor.bytes},
          {"sectors_per_request", {accessor.sectors.fewest, accessor.sectors.most}},
          {"sectors", accessor.sectors.total},
          {"ideal_sectors", accessor.ideal_sectors()}};
}

Json write(const LayoutMap& map, const Box& box) {
  Json json{{"begin", box.begin}, {"end", box.end}, {"text", box.text}};
  if (box.field < 0) return json;
  const Accessor& accessor = map.accessors[static_cast<std::size_t>(box.field)];
  json.update({{"field", box.field}, {"element", box.element}, {"elements", box.elements}});
  json.update({{"object", box.object}, {"objects", box.objects}});
  if (box.elements > 1 && box.elements <= most_named_cells)
    for (int k = 0; k < box.elements; ++k) json["indices"].push_back(element_index(accessor, box.element + k));
  return json;
}

Json write(const LayoutMap& map) {
  Json json{{"object", map.object}};
  for (const model::Space space : map.spaces) json["spaces"].push_back(model::facts(space).word);
  json["layout"] = layout_word(map.layout);
  json["real"] = precision_word(map.precision);
  json["pitch"] = map.pitch;
  json["record_bytes"] = map.record_bytes;
  json["record"] = record_words(map);
  json["warp"] = warp_words(map);
  for (const Accessor& accessor : map.accessors) json["fields"].push_back(write(map, accessor));
  for (const Row& row : layout_rows(map)) {
    Json boxes = Json::array();
    for (const Box& box : row.boxes) boxes.push_back(write(map, box));
    json["rows"].push_back({{"name", row.name}, {"boxes", std::move(boxes)}});
  }
  return json;
}

}  // namespace

std::string layout_json(const std::vector<LayoutMap>& maps) {
  Json json{{"physgen_layout", format}, {"arrays", Json::array()}};
  for (const LayoutMap& map : maps) json["arrays"].push_back(write(map));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace physgen::command
