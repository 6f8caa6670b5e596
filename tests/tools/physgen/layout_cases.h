// Object types whose layouts are drawn.
#pragma once

#include <random>

#include "models.h"

namespace physgen::command {

using model::Element;
using model::Encoding;
using model::Format;
using model::LayoutKind;
using model::Shape;
using model::Space;
using test::array;
using test::field;
using test::nested;
using test::object;
using test::scalar;
using test::schema;

inline constexpr model::Layout aos{LayoutKind::aos, 0}, aos_padded{LayoutKind::aos_padded, 0}, soa{LayoutKind::soa, 0};
constexpr model::Layout aosoa(int tile) { return {LayoutKind::aosoa, tile}; }

/// Random object types; later ones nest earlier ones.
inline model::Schema random_schema(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<model::Object> objects;
  for (int o = 0; o < 4; ++o) {
    std::vector<model::Field> fields;
    const int count = 1 + below(6);
    for (int f = 0; f < count; ++f) {
      const std::string name = "f" + std::to_string(f);
      if (o > 0 && below(4) == 0) {
        fields.push_back(nested(name, "test::O" + std::to_string(below(o))));
      } else {
        constexpr Shape shapes[] = {Shape::scalar,   Shape::vector, Shape::matrix,  Shape::symmetric,
                                    Shape::diagonal, Shape::skew,   Shape::rotation};
        constexpr Element elements[] = {Element::real, Element::index, Element::float32, Element::float64};
        const Shape shape = shapes[below(7)];
        const int n = shape == Shape::scalar ? 1 : 3;
        fields.push_back(field(name, shape, n, shape == Shape::scalar || shape == Shape::vector ? 1 : n));
        if (shape != Shape::rotation) fields.back().element = elements[below(4)];
        for (Format* format : {&fields.back().host_format, &fields.back().cuda_format})
          if (fields.back().element != Element::index)
            *format = {static_cast<Encoding>(below(6)), shape == Shape::rotation && below(2) == 0};
      }
      if (below(4) == 0) fields.back().array_extent = 1 + below(4);
    }
    objects.push_back(object("O" + std::to_string(o), fields));
    if (below(4) == 0) objects.back().alignment = 32;
  }
  return schema(objects);
}

}  // namespace physgen::command
