// Writes, from the catalogue alone, a schema that uses every layout, encoding, shape and element type, the header that
// physgen generates from it, and a program (see checks.h) that stores values of each and reads them back:
//
//   catalog_everything FOLDER [INCLUDE]     INCLUDE: where schemas look for <physgen/schema.h> first
//
// A new row is so in the schema, the header and the program without being named here. Prints the drawing of the shapes.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "emit/emitter.h"
#include "frontend/frontend.h"
#include "layout_boxes.h"
#include "layout_request.h"
#include "plan/plan.h"

namespace physgen {
namespace {

using model::Encoding;
using model::Shape;
using model::Sides;

const char* const head = R"(#include <physgen/schema.h>
/// Everything that there is.
namespace all {
using namespace physgen::schema;
)";

std::string line(const std::string& text) { return "  " + text + "\n"; }

/// The shape as the type of a field, of the least sizes that show all of it.
std::string shape_type(const model::ShapeFacts& row) {
  const std::string sizes = row.sides == Sides::fixed ? "" : row.sides == Sides::any ? "<3, 2>" : "<3>";
  return std::string(row.type) + sizes;
}

std::string layout(const model::LayoutFacts& row) { return model::layout_word({row.key, row.tiled ? 8 : 0}); }

std::string schema_text() {
  std::string text = head;
  text += "struct PHYSGEN_OBJECT() Shapes {\n";
  for (const model::ShapeFacts& row : model::shapes())
    if (!row.type.empty()) text += line(shape_type(row) + " shape_" + std::string(row.word) + ";");
  text += "};\nstruct PHYSGEN_OBJECT() Elements {\n";
  for (const model::ElementFacts& row : model::elements())
    text += line("Vector<2, " + std::string(row.schema) + "> element_" + std::string(row.word) + ";");
  text += "};\nstruct PHYSGEN_OBJECT() Encodings {\n";
  for (const model::EncodingFacts& row : model::encodings()) {
    const bool native = row.key == Encoding::native;
    const std::string word(row.word), stored = native ? "" : ", format(host, " + word + ")";
    text += line("PHYSGEN(range(-2, 6)" + stored + ") Vector<3> encoding_" + word + ";");
    text += line("PHYSGEN(format(host, quaternion(" + (native ? "" : word) + "))) Rotation quaternion_" + word + ";");
  }
  text += "};\n";
  for (const model::LayoutFacts& row : model::layouts())
    text += "struct PHYSGEN_OBJECT(layout(host, " + layout(row) + ")) Layout_" + std::string(row.word) +
            " {\n  Scalar one;\n  Vector<3, double> x;\n  PHYSGEN(format(host, half)) Scalar h;\n  Index n;\n};\n";
  return text + "}\n";
}

/// Largest error of an encoding over -2 to 6 as its row states it: a factor of the value's size, or a difference.
std::string error_of(const model::EncodingFacts& row) {
  if (row.key == Encoding::native) return "{0, 0}";
  if (row.scaling == model::Scaling::interval) return "{0, " + std::to_string(8.0 / (2.0 * row.steps)) + "}";
  return "{" + std::string(row.relative_error) + ", 0}";
}

/// "2e-3", "10 eps": largest error of an entry of a rotation.
std::string rotation_error_of(const model::EncodingFacts& row) {
  const std::string words(row.rotation_error);
  const auto eps = words.find(" eps");
  return eps == std::string::npos ? words : words.substr(0, eps) + " * std::numeric_limits<Real>::epsilon()";
}

std::string accessor(const std::string& field) {
  return "[](const auto& view, auto i) -> decltype(auto) { return view[i]." + field + "(); }";
}

std::string program_text(const model::Schema& schema) {
  std::string text = "#include \"all.physgen.h\"\n#include \"checks.h\"\n\ntemplate <class Real>\nvoid shapes() {\n";
  text += line("all::ShapesArray<Real> array(objects);");
  for (const model::ShapeFacts& row : model::shapes()) {
    if (row.type.empty() || row.key == Shape::scalar) continue;
    const model::Field* field = nullptr;
    for (const model::Field& candidate : schema.objects.at(0).fields)
      if (candidate.shape == row.key) field = &candidate;
    if (field == nullptr) throw std::runtime_error("no field of the shape " + std::string(row.word));
    std::string entries;
    for (int k = 0; k < model::element_count(*field); ++k) {
      const auto [r, c] = row.entry(k, field->rows);
      entries += (k == 0 ? "{" : ", {") + std::to_string(r) + ", " + std::to_string(c) + "}";
    }
    text += line("keeps_shape<Real>(\"" + field->name + "\", array.view(), " + accessor(field->name) + ", {" + entries +
                 "});");
  }
  text += "}\n\ntemplate <class Real>\nvoid elements() {\n" + line("all::ElementsArray<Real> array(objects);");
  for (const model::ElementFacts& row : model::elements())
    text += line("keeps_element<" + std::string(row.type) + ">(\"element_" + std::string(row.word) +
                 "\", array.view(), " + accessor("element_" + std::string(row.word)) + ");");
  text += "}\n\ntemplate <class Real>\nvoid encodings() {\n" + line("all::EncodingsArray<Real> array(objects);");
  int number = 0;  // of the first element, as getdata() counts
  for (const model::EncodingFacts& row : model::encodings()) {
    const std::string word(row.word);
    text += line("keeps_numbers<Real>(\"" + word + "\", array, " + std::to_string(number) + ", " +
                 accessor("encoding_" + word) + ", Error" + error_of(row) + ", " + std::to_string(row.bytes) + ");");
    text += line("keeps_rotations<Real>(\"" + word + "\", array.view(), " + accessor("quaternion_" + word) + ", " +
                 rotation_error_of(row) + ");");
    number += 3 + 9;
  }
  text += "}\n\ntemplate <class Real>\nvoid layouts() {\n";
  const plan::Records records(schema, model::Space::host);
  for (const model::LayoutFacts& row : model::layouts()) {
    const std::string name = "Layout_" + std::string(row.word);
    const int tile = row.tiled ? 8 : 0;
    const plan::Record& record = records.of("all::" + name);
    const plan::Bytes bytes{row.record_bytes(record.bytes.with_float, record.alignment.with_float, tile),
                            row.record_bytes(record.bytes.with_double, record.alignment.with_double, tile)};
    const auto number = [](plan::Bytes of) {
      return "sizeof(Real) == 4 ? " + std::to_string(of.with_float) + " : " + std::to_string(of.with_double);
    };
    text += line("lies_as<Real, all::" + name + "Array<Real>>(\"" + std::string(row.word) +
                 "\", [](physgen::index_t count) { return physgen::index_t{count == 100 ? " +
                 std::to_string(row.pitch(100, tile)) + " : " + std::to_string(row.pitch(512, tile)) + "}; }, " +
                 number(bytes) + ", " + number(record.slots.front().offset) + ", " +
                 number(record.slots.back().offset) + ");");
  }
  text += "}\n\nint main() {\n";
  for (const char* real : {"float", "double"})
    for (const char* part : {"shapes", "elements", "encodings", "layouts"})
      text += line(std::string(part) + "<" + real + ">();");
  return text + line("return report();") + "}\n";
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  if (!(file << text)) throw std::runtime_error("cannot write " + path);
}

int run(int count, char** arguments) {
  if (count < 2) throw std::runtime_error("usage: catalog_everything FOLDER [INCLUDE]");
  const std::string folder = arguments[1];
  write(folder + "/all.h", schema_text());
  frontend::ParseOptions options;
  options.objections = emit::emitters().front().objections;
  if (count > 2) options.include_dirs.emplace_back(arguments[2]);
  const auto result = frontend::parse(folder + "/all.h", options);
  std::cerr << result.diagnostics;
  if (!result.schema) return 1;
  write(folder + "/all.physgen.h", emit::emitters().front().emit(*result.schema));
  write(folder + "/all.cpp", program_text(*result.schema));
  command::LayoutRequest request;
  request.space = "host";
  request.objects = {"Shapes"};
  std::cout << command::layout_text(command::layout_maps(*result.schema, request));
  for (const model::LayoutFacts& row : model::layouts()) {
    request.objects = {"Layout_" + std::string(row.word)};
    std::cout << command::layout_text(command::layout_maps(*result.schema, request));
  }
  return 0;
}

}  // namespace
}  // namespace physgen

int main(int count, char** arguments) {
  try {
    return physgen::run(count, arguments);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
