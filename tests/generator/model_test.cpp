// The model by itself: element counts, names of headers, JSON in and out, and the rules that JSON models must keep too.
#include "model/model.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "model/json.h"
#include "model/validate.h"

namespace physgen::model {
namespace {

Field scalar(const std::string& name) {
  Field field;
  field.name = name;
  return field;
}

Field of(const std::string& name, Shape shape, int rows, int cols) {
  Field field = scalar(name);
  field.shape = shape;
  field.rows = rows;
  field.cols = cols;
  return field;
}

Field nested(const std::string& name, const std::string& object) {
  Field field = scalar(name);
  field.shape = Shape::object;
  field.object = object;
  return field;
}

Schema with(std::vector<Field> fields) {
  Schema schema;
  schema.file = "a.h";
  schema.objects.push_back({});
  schema.objects[0].name = "A";
  schema.objects[0].scope = "m";
  schema.objects[0].fields = std::move(fields);
  return schema;
}

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
  corner.header = "shape.physgen.h";
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

TEST(Model, names_generated_headers_after_their_schemas) {
  EXPECT_EQ(generated_header("elasticity.h"), "elasticity.physgen.h");
  EXPECT_EQ(generated_header("some.folder/tissue.model.hpp"), "tissue.model.physgen.h");
  EXPECT_EQ(generated_header("folder.d/plain"), "plain.physgen.h");
  EXPECT_EQ(generated_header(".hidden"), ".hidden.physgen.h");
}

TEST(Json, returns_the_same_model) {
  const Schema schema = everything();
  ASSERT_TRUE(validate(schema).empty()) << validate(schema)[0].message;
  EXPECT_EQ(from_json(to_json(schema)), schema);
  EXPECT_EQ(to_json(from_json(to_json(schema))), to_json(schema));
}

TEST(Json, returns_the_same_model_for_every_shape_and_element) {
  std::vector<Field> fields = {scalar("a"),
                               of("b", Shape::vector, 4, 1),
                               of("c", Shape::matrix, 3, 2),
                               of("d", Shape::symmetric, 3, 3),
                               of("e", Shape::diagonal, 3, 3),
                               of("f", Shape::skew, 3, 3),
                               of("g", Shape::rotation, 3, 3)};
  for (const Element element : {Element::real, Element::float32, Element::float64, Element::index, Element::int32}) {
    if (element == Element::index) fields.pop_back();  // there are no rotations of integers
    for (Field& field : fields) field.element = element;
    EXPECT_EQ(from_json(to_json(with(fields))), with(fields));
  }
}

TEST(Json, returns_the_same_formats) {
  for (const Encoding encoding : {Encoding::native, Encoding::float32, Encoding::float64, Encoding::half,
                                  Encoding::bfloat16, Encoding::snorm16}) {
    for (const bool quaternion : {false, true}) {
      Field turn = of("R", Shape::rotation, 3, 3);
      turn.host_format = {encoding, quaternion};
      EXPECT_EQ(from_json(to_json(with({turn}))), with({turn}));
      std::swap(turn.host_format, turn.cuda_format);
      EXPECT_EQ(from_json(to_json(with({turn}))), with({turn}));
    }
  }
  EXPECT_EQ(to_json(with({scalar("x")})).find("format\""), std::string::npos) << "what the schema does not say";
}

TEST(Json, writes_text_that_is_not_utf8_with_replacements) {
  Schema schema = with({scalar("x")});
  schema.objects[0].doc = "20 \xb0 C";
  EXPECT_EQ(from_json(to_json(schema)).objects[0].doc, "20 \xef\xbf\xbd C");
}

/// What from_json says about the JSON of `everything` with `from` replaced by `to`.
std::string complaint(const std::string& from, const std::string& to) {
  std::string text = to_json(everything());
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  text.replace(place, from.size(), to);
  try {
    (void)from_json(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Json, names_the_place_of_what_it_cannot_read) {
  EXPECT_EQ(
      complaint("\"shape\": \"matrix\"", "\"shape\": \"tensor\""),
      "objects[0].fields[1].shape: must be one of scalar, vector, matrix, symmetric, diagonal, skew, rotation, object, "
      "not 'tensor'");
  EXPECT_EQ(complaint("\"rows\": 3", "\"rows\": 3.5"), "objects[0].fields[1].rows: must be an integer, not 3.5");
  EXPECT_EQ(complaint("\"rows\": 3", "\"rows\": 3000000000"),
            "objects[0].fields[1].rows: must be a 32-bit integer, not 3000000000");
  EXPECT_EQ(complaint("\"unit\": \"1/m\"", "\"unit\": 1"), "objects[0].fields[0].unit: must be a string, not number");
  EXPECT_EQ(complaint("\"unit\"", "\"units\""), "objects[0].fields[0]: has an unknown member 'units'");
  EXPECT_EQ(complaint("\"encoding\": \"half\"", "\"encoding\": \"float16\""),
            "objects[0].fields[1].host_format.encoding: must be one of native, float32, float64, half, bfloat16, "
            "snorm16, not 'float16'");
  EXPECT_EQ(complaint("\"encoding\": \"half\"", "\"quaternion\": false"),
            "objects[0].fields[1].host_format: has no member 'encoding'");
  EXPECT_EQ(complaint("\"quaternion\": true", "\"quaternion\": 1"),
            "objects[0].fields[3].cuda_format.quaternion: must be true or false, not 1");
  EXPECT_EQ(complaint("\"quaternion\": true", "\"quaternions\": true"),
            "objects[0].fields[3].cuda_format: has an unknown member 'quaternions'");
  EXPECT_EQ(complaint("\"cuda_format\": {", "\"cuda_format\": \"half\", \"x\": {").substr(0, 45),
            "objects[0].fields[1]: has an unknown member '");
  EXPECT_EQ(complaint("\"file\": \"a.h\"", "\"doc\": \"\""), "model: has an unknown member 'doc'");
  EXPECT_EQ(complaint("\"name\": \"Corner\",", ""), "imported[0]: has no member 'name'");
  EXPECT_EQ(complaint("\"physgen_model\": 1", "\"physgen_model\": 2"),
            "physgen_model: format 2 is not the format 1 that this physgen reads");
  EXPECT_EQ(complaint("{", "").substr(0, 16), "model: not JSON:");
}

TEST(Json, refuses_a_model_that_breaks_the_rules) {
  EXPECT_EQ(complaint("\"tile\": 16", "\"tile\": 17"),
            "objects[0]: tile 17 is not a power of two from 2 to 1024; write one, such as aosoa(32)");
  EXPECT_EQ(complaint("\"name\": \"x\"", "\"name\": \"double\""),
            "objects[0].fields[0]: field name 'double' is a keyword of C++; choose another name");
}

/// The messages of validate, one per line.
std::string issues(const Schema& schema) {
  std::string text;
  for (const Issue& issue : validate(schema)) text += (text.empty() ? "" : "\n") + issue.message;
  return text;
}

TEST(Rules, refuse_sizes_that_do_not_fit_the_shape) {
  EXPECT_EQ(issues(with({of("x", Shape::rotation, 2, 2)})),
            "field 'x' has the type Rotation, but rows and cols are not 3");
  EXPECT_EQ(issues(with({of("x", Shape::symmetric, 3, 2)})),
            "field 'x' has the type Symmetric<3>, but rows and cols differ");
  EXPECT_EQ(issues(with({of("x", Shape::vector, 3, 3)})), "field 'x' has the type Vector<3>, but cols is not 1");
  EXPECT_EQ(issues(with({of("x", Shape::scalar, 2, 1)})), "field 'x' has the type Scalar, but rows and cols are not 1");
  Field rotation = of("x", Shape::rotation, 3, 3);
  rotation.element = Element::index;
  EXPECT_EQ(issues(with({rotation})), "field 'x' has the type Rotation, whose elements must be real");
}

TEST(Rules, refuse_names_that_clang_would_not_let_through) {
  EXPECT_NE(issues(with({scalar("")})), "");
  EXPECT_NE(issues(with({scalar("1x")})), "");
  EXPECT_NE(issues(with({scalar("a b")})), "");
  EXPECT_EQ(issues(with({scalar("x"), scalar("x")})), "field 'x' is declared twice; rename or remove one");
}

TEST(Rules, refuse_nesting_that_does_not_end) {
  EXPECT_EQ(issues(with({nested("a", "m::A")})),
            "object 'A' contains itself; store an 'Index' of the other object instead");
  Schema both = with({nested("b", "m::B")});
  both.objects.push_back(both.objects[0]);
  both.objects[1].name = "B";
  both.objects[1].fields = {nested("a", "m::A")};
  EXPECT_EQ(
      issues(both),
      "field 'b' nests 'm::B', which is not declared before it; declare that object first (objects cannot nest each "
      "other)");
}

TEST(Rules, count_the_elements_of_nested_objects) {
  Schema schema = with({of("m", Shape::matrix, 128, 128)});
  schema.objects[0].fields[0].array_extent = 32;
  schema.objects.push_back(schema.objects[0]);
  schema.objects[1].name = "B";
  schema.objects[1].fields = {nested("a", "m::A")};
  schema.objects[1].fields[0].array_extent = 3;
  ASSERT_EQ(validate(schema).size(), 1u) << issues(schema);
  EXPECT_EQ(validate(schema)[0].place, (Place{false, 1, -1}));
}

Field stored(Field field, Encoding encoding, bool quaternion = false) {
  field.host_format = {encoding, quaternion};
  return field;
}

TEST(Rules, refuse_formats_of_integers) {
  Field index = stored(scalar("i"), Encoding::half);
  for (const Element element : {Element::index, Element::int32}) {
    index.element = element;
    EXPECT_EQ(issues(with({index})), "the elements of 'i' are integers, which have no other format; leave it out");
  }
}

TEST(Rules, refuse_quaternions_of_what_is_no_rotation) {
  EXPECT_EQ(issues(with({stored(of("F", Shape::matrix, 3, 3), Encoding::native, true)})),
            "only a Rotation can be stored as a quaternion; 'F' is a Matrix<3, 3>");
  EXPECT_EQ(issues(with({stored(of("q", Shape::vector, 4, 1), Encoding::half, true)})),
            "only a Rotation can be stored as a quaternion; 'q' is a Vector<4>");
  EXPECT_EQ(issues(with({stored(of("R", Shape::rotation, 3, 3), Encoding::half, true)})), "");
}

TEST(Rules, refuse_equal_steps_without_a_range_to_take_them_over) {
  Field angle = stored(scalar("angle"), Encoding::snorm16);
  EXPECT_EQ(issues(with({angle})),
            "snorm16 has equal steps over a range, and 'angle' states none; add one, such as range(-1, 1)");
  angle.range = Range{2, 2};
  EXPECT_EQ(issues(with({angle})),
            "snorm16 has equal steps over a range of more than one value; widen the range of 'angle'");
  angle.range = Range{2, 3};
  EXPECT_EQ(issues(with({angle})), "");
  EXPECT_EQ(issues(with({stored(of("R", Shape::rotation, 3, 3), Encoding::snorm16)})), "") << "from -1 to 1";
}

TEST(Rules, refuse_an_initial_value_that_no_half_holds) {
  Field load = stored(scalar("load"), Encoding::half);
  load.initial = -65505;
  EXPECT_EQ(issues(with({load})),
            "initial(-65505) is no half, which ends at 65504; state the range of 'load', and it is scaled");
  load.range = Range{-1e6, 0};
  EXPECT_EQ(issues(with({load})), "");
  load.range.reset();
  load.initial = 65504;
  EXPECT_EQ(issues(with({load})), "");
}

// The largest power of two that each format holds passes, the next one is refused.
TEST(Rules, refuse_ranges_and_initial_values_beyond_what_a_format_holds) {
  const auto issues_of = [](Encoding encoding, double size, Element element = Element::real) {
    Field field = stored(scalar("E"), encoding);
    field.element = element;
    field.range = Range{-size, size / 2};
    return issues(with({field}));
  };
  EXPECT_EQ(issues_of(Encoding::half, 0x1p115), "");
  EXPECT_EQ(issues_of(Encoding::half, 0x1p116),
            "the range of 'E' is beyond what this format holds, sizes up to 4.15e+34; choose float64");
  EXPECT_EQ(issues_of(Encoding::half, 0x1p-86), "");
  EXPECT_EQ(issues_of(Encoding::half, 0x1p-87),
            "the range of 'E' is beyond what this format holds, ranges that end above 1.3e-26; choose float64");
  for (const Encoding encoding : {Encoding::bfloat16, Encoding::float32, Encoding::snorm16}) {
    EXPECT_EQ(issues_of(encoding, 0x1p127), "");
    EXPECT_NE(issues_of(encoding, 0x1p128), "");
  }
  for (const Encoding encoding : {Encoding::native, Encoding::float64}) EXPECT_EQ(issues_of(encoding, 0x1p1000), "");
  EXPECT_EQ(issues_of(Encoding::snorm16, 0x1p1000, Element::float64), "") << "its steps are computed in double";
  Field initial = stored(scalar("E"), Encoding::bfloat16);
  initial.initial = -3.4e38;  // a float
  EXPECT_EQ(issues(with({initial})),
            "the initial value of 'E' is beyond what this format holds, sizes up to 3.38e+38; choose float64");
}

TEST(Rules, refuse_formats_of_nested_objects) {
  Schema schema = with({scalar("x")});
  schema.objects.push_back(schema.objects[0]);
  schema.objects[1].name = "B";
  schema.objects[1].fields = {stored(nested("a", "m::A"), Encoding::half)};
  EXPECT_EQ(issues(schema), "format() has no meaning for nested object 'a'; write it at the fields of 'm::A'");
}

TEST(Rules, place_an_issue_at_the_format_of_its_space) {
  Field field = stored(of("F", Shape::matrix, 3, 3), Encoding::native, true);
  EXPECT_EQ(validate(with({field})).at(0).aspect, Aspect::host_format);
  std::swap(field.host_format, field.cuda_format);
  EXPECT_EQ(validate(with({field})).at(0).aspect, Aspect::cuda_format);
}

TEST(Rules, keep_the_names_of_formats_for_generated_code) {
  const std::string reserved = " is a name that generated code needs for itself; choose another name";
  EXPECT_EQ(issues(with({scalar("Formats")})), "field name 'Formats'" + reserved);
  EXPECT_EQ(issues(with({scalar("Space")})), "field name 'Space'" + reserved);
  EXPECT_EQ(issues(with({scalar("AFormats")})),
            "field name 'AFormats' is also the name of a type generated for object 'A'; choose another name");
}

// Its record says BRecord, its formats BFormats, its references BRef: fields of these names would change the meaning.
TEST(Rules, refuse_fields_named_as_a_type_of_a_nested_object_that_is_said_beside_them) {
  for (const char* ending : {"", "Formats", "Probe", "Record", "Ref"}) {
    Schema schema = with({scalar("x")});
    schema.objects[0].name = "B";
    schema.objects.push_back(schema.objects[0]);
    schema.objects[1].name = "A";
    schema.objects[1].fields = {nested("b", "m::B"), scalar(std::string("B") + ending)};
    EXPECT_EQ(issues(schema), "field name 'B" + std::string(ending) + "' is also the name of the object type 'm::B" +
                                  ending + "' nested here; choose another name");
  }
}

// What Eigen keeps on the stack is 128 KiB: 128 x 128 doubles.
TEST(Rules, refuse_fields_whose_value_is_too_large_for_the_stack) {
  EXPECT_EQ(issues(with({of("x", Shape::matrix, 128, 128)})), "");
  EXPECT_EQ(issues(with({of("x", Shape::diagonal, 1024, 1024)})), "");
  for (const Shape shape : {Shape::symmetric, Shape::skew}) {
    EXPECT_EQ(issues(with({of("x", shape, 128, 128)})), "");
    EXPECT_NE(issues(with({of("x", shape, 129, 129)})).find("whose value takes 133128 bytes in double"),
              std::string::npos);
  }
  Field narrow = of("x", Shape::matrix, 256, 128);
  for (const Element element : {Element::float32, Element::index, Element::int32}) {
    narrow.element = element;
    EXPECT_EQ(issues(with({narrow})), "");
  }
  narrow.rows = 257;
  EXPECT_EQ(issues(with({narrow})),
            "field 'x' has the type Matrix<257, 128>, whose value takes 131584 bytes, and Eigen keeps no more than "
            "131072 on the stack; write blocks, such as 'Matrix<64, 64> x[...]'");
}

TEST(Rules, refuse_initial_values_that_become_0_as_floats) {
  Field field = scalar("a");
  field.initial = -1e-60;
  for (const Element element : {Element::real, Element::float32}) {
    field.element = element;
    EXPECT_EQ(issues(with({field})),
              "initial(-1e-60) is 0 as a float, as the elements of 'a' are or can be; write 0 or a size from 1.5e-45 "
              "on, or declare it double");
  }
  field.element = Element::float64;
  EXPECT_EQ(issues(with({field})), "");
  field.element = Element::real;
  for (const double held : {0.0, -0.0, 1.5e-45, -1e-40}) {
    field.initial = held;
    EXPECT_EQ(issues(with({field})), "");
  }
}

// Names of physics must pass: moduli, invariants, coefficients of Mooney and Rivlin, components of strain.
TEST(Rules, refuse_names_of_macros_and_of_nothing_else) {
  for (const char* name : {"M_PI", "INT_MAX", "CHAR_BIT", "RAND_MAX", "FP_NAN", "HUGE_VAL", "UINT8_MAX",
                           "CLOCKS_PER_SEC", "EIGEN_WORLD_VERSION", "EXIT_FAILURE", "SEEK_SET"})
    EXPECT_NE(issues(with({scalar(name)})).find("is written as the macros of system headers are"), std::string::npos)
        << name << ": " << issues(with({scalar(name)}));
  for (const char* name : {"EDOM", "ERANGE", "EOF", "NAN", "INFINITY", "BUFSIZ", "L_tmpnam", "offsetof", "errno",
                           "assert", "M_PIl", "PRIu64", "SIGINT", "stdin", "va_arg", "cudaStreamLegacy", "linux"})
    EXPECT_NE(issues(with({scalar(name)})).find("is a macro of a header"), std::string::npos) << name;
  for (const char* name : {"F",  "U",  "V",   "J",     "P",   "E", "K",    "G",    "J0",  "J2",  "I1",  "C10", "A11",
                           "EA", "EI", "EXX", "SIGMA", "EPS", "W", "dPdF", "K_Ic", "M_b", "T_c", "SCN", "PRI", "cu"})
    EXPECT_EQ(issues(with({scalar(name)})), "") << name;
  EXPECT_EQ(issues(with({scalar("K_IC")})),
            "field name 'K_IC' is written as the macros of system headers are, in capitals with an underscore; write "
            "'K_ic' or another name with a small letter");
  EXPECT_NE(issues(with({scalar("NU_12")})).find("write 'nu_12'"), std::string::npos);
}

TEST(Rules, refuse_objects_outside_all_namespaces_and_namespaces_of_the_c_library) {
  Schema schema = with({scalar("x")});
  schema.objects[0].scope = "";
  EXPECT_EQ(issues(schema),
            "object 'A' stands outside all namespaces, where the C library has names such as index, time and link; "
            "write 'namespace some_name { ... }' around it");
  for (const char* name : {"index", "time", "stat", "div", "tm", "sinf", "size_t", "y0"}) {
    schema.objects[0].scope = name;
    EXPECT_EQ(issues(schema), "namespace '" + std::string(name) +
                                  "' has the name of something in the C library, which stands outside all namespaces, "
                                  "too; choose another name");
    schema.objects[0].scope = std::string("m::") + name;
    EXPECT_EQ(issues(schema), "") << "within another namespace, nothing is in its way";
  }
}

TEST(Rules, refuse_objects_whose_generated_types_are_namespaces) {
  for (const char* ending : {"", "Formats", "Probe", "Record", "Ref", "Object", "View", "Array"}) {
    Schema schema = with({scalar("x")});
    schema.objects.push_back(schema.objects[0]);
    schema.objects[1].name = "B";
    schema.objects[1].scope = "m::A" + std::string(ending) + "::n";
    EXPECT_EQ(issues(schema), "object 'B' is in a namespace 'A" + std::string(ending) +
                                  "', beside object 'A', which would generate a type of that name; rename one of them");
    EXPECT_EQ(validate(schema).at(0).other.object, 0);
    std::swap(schema.objects[0], schema.objects[1]);
    EXPECT_EQ(issues(schema), "object 'A' would generate a type 'A" + std::string(ending) +
                                  "' beside the namespace of that name; rename one of them");
    schema.objects[0].scope = "other::A" + std::string(ending);
    EXPECT_EQ(issues(schema), "") << "of another scope";
  }
}

TEST(Rules, refuse_objects_of_too_many_fields_of_their_own) {
  Schema schema = with({});
  for (int f = 0; f < 10000; ++f) schema.objects[0].fields.push_back(scalar("x" + std::to_string(f)));
  ASSERT_EQ(validate(schema).size(), 1U);
  EXPECT_EQ(validate(schema)[0].place, (Place{false, 0, -1}));
  EXPECT_NE(issues(schema).find("of generated code, and the limit is 2 MiB; split it into several objects"),
            std::string::npos);
  schema.imported.swap(schema.objects);  // somebody else's header
  schema.objects = {with({nested("a", "m::A")}).objects[0]};
  schema.objects[0].name = "B";
  EXPECT_NE(issues(schema).find("'B' would become"), std::string::npos);
  schema.objects[0].fields = {scalar("x")};
  EXPECT_EQ(issues(schema), "");
}

TEST(Rules, refuse_a_schema_without_objects) { EXPECT_EQ(validate(Schema{}).size(), 1u); }

}  // namespace
}  // namespace physgen::model
