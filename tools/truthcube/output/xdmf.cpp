#include "xdmf.h"

#include <physgen/error.h>

#include <cstdio>
#include <fstream>

namespace physgen::truthcube {

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string exact(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.17g", number);
  return text;
}

// Columns of a dataset behind its rows: those of 1 component have none.
std::string rows_of(std::uint64_t rows, int components) {
  return std::to_string(rows) + (components == 1 ? "" : " " + std::to_string(components));
}

/// What stands before the name of a dataset.
std::string prefix_of(const std::filesystem::path& file) { return escaped(file.filename().string()) + ":/VTKHDF/"; }

}  // namespace

void require_none_of_others(const std::filesystem::path& xdmf, const std::filesystem::path& file) {
  if (!std::filesystem::exists(xdmf)) return;
  const std::string name = prefix_of(file);
  std::string begin(4096 + name.size(), ' ');  // the first dataset is named at once
  std::ifstream in(xdmf, std::ios::binary);
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin.find(">" + name) != std::string::npos) return;
  throw Error(xdmf.string() + ": names no values of " + file.filename().string() +
              ", so another program wrote it, and it is not replaced; move it away, or write to another folder");
}

std::string xdmf_text(const std::filesystem::path& file, const XdmfMesh& mesh, std::span<const XdmfArray> arrays,
                      std::span<const double> times) {
  const std::string dataset = prefix_of(file);
  const auto item = [](const char* type, int bytes, const std::string& dimensions, const std::string& values) {
    return "<DataItem Format=\"HDF\" NumberType=\"" + std::string(type) + "\" Precision=\"" + std::to_string(bytes) +
           "\" Dimensions=\"" + dimensions + "\">" + values + "</DataItem>";
  };
  std::string of_all_steps =
      "<Topology TopologyType=\"" + std::string(mesh.corners_of_cell == 4 ? "Tetrahedron" : "Triangle") +
      "\" NumberOfElements=\"" + std::to_string(mesh.cells) + "\">" +
      item("Int", 8, std::to_string(mesh.corners_of_cell * mesh.cells), dataset + "Connectivity") +
      "</Topology>\n<Geometry GeometryType=\"XYZ\">" + item("Float", 8, rows_of(mesh.points, 3), dataset + "Points") +
      "</Geometry>\n";
  for (const std::string& group : mesh.groups) {
    of_all_steps += "<Attribute Name=\"" + escaped(group) + "\" AttributeType=\"Scalar\" Center=\"Cell\">" +
                    item("UChar", 1, std::to_string(mesh.cells), dataset + escaped("CellData/" + group)) +
                    "</Attribute>\n";
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"steps\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t step = 0; step < times.size(); ++step) {
    text += "<Grid Name=\"mesh\" GridType=\"Uniform\">\n<Time Value=\"" + exact(times[step]) + "\"/>\n" + of_all_steps;
    for (const auto& [what, name, rows, components] : arrays) {
      // A part of a dataset: where it begins, the steps between its entries, its size, and that of the dataset.
      const bool one = components == 1;
      const std::string size = rows_of(rows, components);
      const std::string part = std::to_string(step * rows) + (one ? ":1:" : " 0:1 1:") + size + ":" +
                               rows_of(times.size() * rows, components);
      text += "<Attribute Name=\"" + escaped(name) + "\" AttributeType=\"" +
              (one               ? "Scalar"
               : components == 3 ? "Vector"
                                 : "Matrix") +
              "\" Center=\"" + (what == "Point" ? "Node" : "Cell") + "\">" +
              item("Float", 4, size, dataset + escaped(what + "Data/" + name) + "|" + part) + "</Attribute>\n";
    }
    text += "</Grid>\n";
  }
  return text + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace physgen::truthcube
