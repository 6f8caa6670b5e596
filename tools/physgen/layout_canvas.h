// An SVG document that grows downwards: rectangles, lines and text in it. Knows nothing of layouts.
#pragma once

#include <string>

namespace physgen::command {

/// Width of a text in a plain sans-serif font, rather too wide than too narrow [px].
[[nodiscard]] double text_width(const std::string& text, double size);

class Canvas {
 public:
  struct Style {
    std::string fill = "#000";
    double size = 12;
    const char* anchor = "start";  ///< start, middle or end
    bool bold = false;
  };

  Canvas(int width, std::string title) : width_(width), title_(std::move(title)) {}

  /// @param attributes more of them: stroke="#000"
  void rectangle(double x, double y, double width, double height, const std::string& fill,
                 const std::string& attributes = "");
  void line(double x1, double y1, double x2, double y2, const std::string& stroke);
  /// @param y of the base line
  void text(double x, double y, const std::string& text, const Style& style);
  /// Fill of bytes without data.
  [[nodiscard]] static std::string hatched() { return "url(#padding)"; }

  /// The document, `height` pixels high.
  [[nodiscard]] std::string document(int height) const;

 private:
  int width_;
  std::string title_;
  std::string body_;
};

}  // namespace physgen::command
