// See layout_canvas.h.
#include "layout_canvas.h"

#include <cstdio>
#include <string_view>

namespace physgen::command {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
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

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  std::string result = text;
  if (result.ends_with(".0")) result.resize(result.size() - 2);
  return result;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

}  // namespace

double text_width(const std::string& text, double size) {
  constexpr std::string_view narrow = "()[].,:;|ijl ";
  double width = 0;
  for (const char c : text)
    width += narrow.find(c) != std::string_view::npos ? 0.4 : c == 'm' || c == 'w' ? 0.95 : 0.64;
  return width * size;
}

void Canvas::rectangle(double x, double y, double width, double height, const std::string& fill,
                       const std::string& attributes) {
  body_ += "<rect" + attribute("x", number(x)) + attribute("y", number(y)) + attribute("width", number(width)) +
           attribute("height", number(height)) + attribute("fill", fill) + (attributes.empty() ? "" : " ") +
           attributes + "/>\n";
}

void Canvas::line(double x1, double y1, double x2, double y2, const std::string& stroke) {
  body_ += "<line" + attribute("x1", number(x1)) + attribute("y1", number(y1)) + attribute("x2", number(x2)) +
           attribute("y2", number(y2)) + attribute("stroke", stroke) + "/>\n";
}

void Canvas::text(double x, double y, const std::string& text, const Style& style) {
  body_ += "<text" + attribute("x", number(x)) + attribute("y", number(y)) +
           attribute("font-size", number(style.size)) + attribute("fill", style.fill);
  if (std::string_view(style.anchor) != "start") body_ += attribute("text-anchor", style.anchor);
  if (style.bold) body_ += attribute("font-weight", "bold");
  body_ += ">" + escaped(text) + "</text>\n";
}

std::string Canvas::document(int height) const {
  const std::string w = std::to_string(width_);
  const std::string h = std::to_string(height);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
         w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h +
         "\" font-family=\"DejaVu Sans, Verdana, Helvetica, Arial, sans-serif\">\n"
         "<title>" +
         escaped(title_) +
         "</title>\n"
         "<defs><pattern id=\"padding\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
         "patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" fill=\"#f2f2f2\"/>"
         "<rect width=\"1.5\" height=\"6\" fill=\"#999\"/></pattern></defs>\n"
         "<rect width=\"" +
         w + "\" height=\"" + h + "\" fill=\"#fff\"/>\n" + body_ + "</svg>\n";
}

}  // namespace physgen::command
