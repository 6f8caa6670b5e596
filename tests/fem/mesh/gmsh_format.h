// Writes meshes in Gmsh's format, in three versions, as text and binary, and without Gmsh, for the tests of what reads
// them.
#pragma once

#include <fem/mesh/mesh.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace physgen::fem::gmsh_format {

using Tags = std::vector<std::size_t>;

// An element as a file has it: its type in Gmsh's numbers (2: triangle, 4: tet, 11: tet of order 2, 15: point).
struct Element {
  std::size_t tag;
  int type;
  Tags nodes;
};

struct File {
  std::vector<std::pair<std::size_t, Point>> nodes;
  std::vector<Element> elements;
};

inline int dimension_of(int type) { return type == 15 ? 0 : type == 2 ? 2 : 3; }

inline std::string in_version_1(const File& file) {
  std::ostringstream out;
  out.precision(17);
  out << "$NOD\n" << file.nodes.size() << "\n";
  for (const auto& [tag, x] : file.nodes) out << tag << " " << x[0] << " " << x[1] << " " << x[2] << "\n";
  out << "$ENDNOD\n$ELM\n" << file.elements.size() << "\n";
  for (const Element& element : file.elements) {
    out << element.tag << " " << element.type << " 1 1 " << element.nodes.size();
    for (const std::size_t node : element.nodes) out << " " << node;
    out << "\n";
  }
  out << "$ENDELM\n";
  return out.str();
}

inline std::string in_version_2(const File& file) {
  std::ostringstream out;
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << file.nodes.size() << "\n";
  for (const auto& [tag, x] : file.nodes) out << tag << " " << x[0] << " " << x[1] << " " << x[2] << "\n";
  out << "$EndNodes\n$Elements\n" << file.elements.size() << "\n";
  for (const Element& element : file.elements) {
    out << element.tag << " " << element.type << " 2 0 1";
    for (const std::size_t node : element.nodes) out << " " << node;
    out << "\n";
  }
  out << "$EndElements\n";
  return out.str();
}

// One point, surface and volume, with a block of elements for each type; all nodes on the volume.
inline std::string in_version_4(const File& file) {
  std::ostringstream out;
  out.precision(17);
  const auto [low, high] = std::ranges::minmax(file.nodes, {}, [](const auto& node) { return node.first; });
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 0 1 1\n1 0 0 0 0\n1 0 0 0 1 1 1 0 0\n1 0 0 0 1 1 1 0 0\n"
      << "$EndEntities\n$Nodes\n1 " << file.nodes.size() << " " << low.first << " " << high.first << "\n3 1 0 "
      << file.nodes.size() << "\n";
  for (const auto& node : file.nodes) out << node.first << "\n";
  for (const auto& node : file.nodes) {
    out << node.second[0] << " " << node.second[1] << " " << node.second[2] << "\n";
  }
  std::size_t blocks = 0;
  std::ostringstream lists;
  for (const int type : {15, 2, 4, 11}) {
    const auto count = std::ranges::count(file.elements, type, &Element::type);
    if (count == 0) continue;
    ++blocks;
    lists << dimension_of(type) << " 1 " << type << " " << count << "\n";
    for (const Element& element : file.elements) {
      if (element.type != type) continue;
      lists << element.tag;
      for (const std::size_t node : element.nodes) lists << " " << node;
      lists << "\n";
    }
  }
  out << "$EndNodes\n$Elements\n"
      << blocks << " " << file.elements.size() << " 1 1000000\n"
      << lists.str() << "$EndElements\n";
  return out.str();
}

template <class Value>
void put_bytes(std::string& out, const Value& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// The same in the binary form of version 2, a block for each element.
inline std::string in_binary_version_2(const File& file) {
  std::string out = "$MeshFormat\n2.2 1 8\n";
  const auto put = [&out](const auto& value) { put_bytes(out, value); };
  const auto put_int = [&put](std::size_t value) { put(static_cast<int>(value)); };
  put_int(1);
  out += "\n$EndMeshFormat\n$Nodes\n" + std::to_string(file.nodes.size()) + "\n";
  for (const auto& [tag, x] : file.nodes) {
    put_int(tag);
    for (const double coordinate : x) put(coordinate);
  }
  out += "\n$EndNodes\n$Elements\n" + std::to_string(file.elements.size()) + "\n";
  for (const Element& element : file.elements) {
    for (const std::size_t value : {static_cast<std::size_t>(element.type), std::size_t{1}, std::size_t{2}, element.tag,
                                    std::size_t{0}, std::size_t{1}}) {
      put_int(value);
    }
    for (const std::size_t node : element.nodes) put_int(node);
  }
  return out + "\n$EndElements\n";
}

// The same in the binary form of version 4.1, in blocks of up to so many elements of one type.
inline std::string in_binary_version_4(const File& file, std::size_t most = 1) {
  std::vector<std::size_t> begins;  // of blocks
  for (std::size_t e = 0; e < file.elements.size(); ++e) {
    const bool goes_on =
        !begins.empty() && e - begins.back() < most && file.elements[e].type == file.elements[begins.back()].type;
    if (!goes_on) begins.push_back(e);
  }
  std::string out = "$MeshFormat\n4.1 1 8\n";
  const auto put_int = [&out](int value) { put_bytes(out, value); };
  const auto put_size = [&out](std::size_t value) { put_bytes(out, value); };
  put_int(1);
  out += "\n$EndMeshFormat\n$Nodes\n";
  for (const std::size_t value : {std::size_t{1}, file.nodes.size(), std::size_t{1}, std::size_t{1}}) put_size(value);
  for (const int value : {3, 1, 0}) put_int(value);
  put_size(file.nodes.size());
  for (const auto& node : file.nodes) put_size(node.first);
  for (const auto& node : file.nodes) put_bytes(out, node.second);
  out += "\n$EndNodes\n$Elements\n";
  for (const std::size_t value : {begins.size(), file.elements.size(), std::size_t{1}, std::size_t{1}}) {
    put_size(value);
  }
  begins.push_back(file.elements.size());
  for (std::size_t b = 0; b + 1 < begins.size(); ++b) {
    const int type = file.elements[begins[b]].type;
    for (const int value : {dimension_of(type), 1, type}) put_int(value);
    put_size(begins[b + 1] - begins[b]);
    for (std::size_t e = begins[b]; e < begins[b + 1]; ++e) {
      put_size(file.elements[e].tag);
      for (const std::size_t node : file.elements[e].nodes) put_size(node);
    }
  }
  return out + "\n$EndElements\n";
}

}  // namespace physgen::fem::gmsh_format
