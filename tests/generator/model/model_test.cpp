// The model by itself: element counts, and what is written of it as JSON.
#include "model/model.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "model/json.h"
#include "rules_case.h"

namespace physgen::model {
namespace {

using nlohmann::json;
using test::nested;
using test::of;
using test::scalar;
using test::with;

/// A schema that uses every member of the model.
Schema everything() {
  Schema schema = with({scalar("x"), of("F", Shape::matrix, 3, 2), nested("corner", "shape::Corner")});
  Object& object = schema.objects[0];
  object.scope = "a::b";
  object.doc = "Doc with \"quotes\",\na second line and \xc2\xb5.";
  object.host_layout = Layout{LayoutKind::aosoa, 16};
  object.cuda_layout = Layout{LayoutKind::aos_padded, 0};
  object.alignment = 64;
  object.location = {"a.h", 12, 8};
  object.fields[0].element = Element::int32;
  object.fields[0].unit = "1/m";
  object.fields[0].range = Range{-0.1, 1e300};
  object.fields[0].initial = 0;
  object.fields[0].location = {"a.h", 13, 10};
  object.fields[1].host_format = {Encoding::half, false};
  object.fields[1].cuda_format = {Encoding::bfloat16, false};
  object.fields[2].array_extent = 4;
  object.fields.push_back(of("R", Shape::rotation, 3, 3));
  object.fields[3].cuda_format = {Encoding::snorm16, true};
  Object corner;
  corner.name = "Corner";
  corner.scope = "shape";
  corner.schema = "shape.h";
  corner.fields = {scalar("y")};
  schema.imported.push_back(corner);
  return schema;
}

TEST(Model, counts_stored_elements) {
  EXPECT_EQ(element_count(scalar("x")), 1);
  EXPECT_EQ(element_count(of("x", Shape::vector, 4, 1)), 4);
  EXPECT_EQ(element_count(of("x", Shape::matrix, 3, 2)), 6);
  EXPECT_EQ(element_count(of("x", Shape::symmetric, 3, 3)), 6);
  EXPECT_EQ(element_count(of("x", Shape::diagonal, 3, 3)), 3);
  EXPECT_EQ(element_count(of("x", Shape::skew, 3, 3)), 3);
  EXPECT_EQ(element_count(of("x", Shape::rotation, 3, 3)), 9);
  EXPECT_THROW((void)element_count(nested("x", "A")), std::invalid_argument);
}

TEST(Json, writes_every_member_that_is_not_its_default) {
  ASSERT_EQ(test::issues(everything()), "");
  const json written = json::parse(to_json(everything()));
  EXPECT_EQ(written.at("physgen_model"), 2);
  EXPECT_EQ(written.at("file"), "a.h");
  EXPECT_EQ(written.at("imported"), json::parse(R"([{"name": "Corner", "scope": "shape", "schema": "shape.h",
                                                    "fields": [{"name": "y", "shape": "scalar", "element": "real"}]}])"));
  const json& object = written.at("objects").at(0);
  EXPECT_EQ(object.at("scope"), "a::b");
  EXPECT_EQ(object.at("doc"), everything().objects[0].doc);
  EXPECT_EQ(object.at("host_layout"), json::parse(R"({"kind": "aosoa", "tile": 16})"));
  EXPECT_EQ(object.at("cuda_layout"), json::parse(R"({"kind": "aos_padded"})"));
  EXPECT_EQ(object.at("alignment"), 64);
  EXPECT_EQ(object.at("location"), json::parse(R"({"file": "a.h", "line": 12, "column": 8})"));
  EXPECT_EQ(object.at("fields"),
            json::parse(R"([{"name": "x", "shape": "scalar", "element": "int32", "unit": "1/m", "range": [-0.1, 1e300],
                             "initial": 0.0, "location": {"file": "a.h", "line": 13, "column": 10}},
                            {"name": "F", "shape": "matrix", "element": "real", "rows": 3, "cols": 2,
                             "host_format": {"encoding": "half"}, "cuda_format": {"encoding": "bfloat16"}},
                            {"name": "corner", "shape": "object", "object": "shape::Corner", "array_extent": 4},
                            {"name": "R", "shape": "rotation", "element": "real", "rows": 3, "cols": 3,
                             "cuda_format": {"encoding": "snorm16", "quaternion": true}}])"));
}

TEST(Json, names_every_shape_element_and_encoding_as_the_catalogue_does) {
  for (const ShapeFacts& shape : shapes()) {
    Field field = scalar("x");
    field.shape = shape.key;
    EXPECT_EQ(json::parse(to_json(with({field})))["objects"][0]["fields"][0]["shape"], shape.word);
  }
  for (const ElementFacts& element : elements())
    EXPECT_EQ(json::parse(to_json(with({scalar("x", element.key)})))["objects"][0]["fields"][0]["element"],
              element.word);
  for (const EncodingFacts& encoding : encodings()) {
    const Field field = test::stored_on_host(of("R", Shape::rotation, 3, 3), encoding.key, true);
    EXPECT_EQ(json::parse(to_json(with({field})))["objects"][0]["fields"][0]["host_format"]["encoding"], encoding.word);
  }
}

TEST(Json, is_the_same_text_for_the_same_model) { EXPECT_EQ(to_json(everything()), to_json(everything())); }

TEST(Json, writes_text_that_is_not_utf8_with_replacements) {
  Schema schema = with({scalar("x")});
  schema.objects[0].doc = "20 \xb0 C";
  EXPECT_EQ(json::parse(to_json(schema))["objects"][0]["doc"], "20 \xef\xbf\xbd C");
}

}  // namespace
}  // namespace physgen::model
