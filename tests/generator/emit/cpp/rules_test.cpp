// The rules that C++ asks of a schema: names, types that do not clash, sizes of values and of generated code.
#include <gtest/gtest.h>

#include "model/rules_case.h"

namespace physgen::emit::cpp {
namespace {

using test::issues;
using test::nested;
using test::of;
using test::scalar;
using test::with;

TEST(Rules, refuse_names_that_clang_would_not_let_through) {
  EXPECT_NE(issues(with({scalar("")})), "");
  EXPECT_NE(issues(with({scalar("1x")})), "");
  EXPECT_NE(issues(with({scalar("a b")})), "");
  EXPECT_EQ(issues(with({scalar("x"), scalar("x")})), "field 'x' is declared twice; rename or remove one");
}

TEST(Rules, keep_the_names_of_formats_for_generated_code) {
  const std::string reserved = " is a name that generated code needs for itself; choose another name";
  EXPECT_EQ(issues(with({scalar("Formats")})), "field name 'Formats'" + reserved);
  EXPECT_EQ(issues(with({scalar("Space")})), "field name 'Space'" + reserved);
  EXPECT_EQ(issues(with({scalar("AFormats")})),
            "field name 'AFormats' is also the name of a type generated for object 'A'; choose another name");
}

// Its record says BObject, its formats BFormats, its value B: fields of these names would change the meaning.
TEST(Rules, refuse_fields_named_as_a_type_of_a_nested_object_that_is_said_beside_them) {
  for (const char* ending : {"", "Formats", "Object", "Probe", "Record", "Ref"}) {
    model::Schema schema = with({scalar("x")});
    schema.objects[0].name = "B";
    schema.objects.push_back(schema.objects[0]);
    schema.objects[1].name = "A";
    schema.objects[1].fields = {nested("b", "m::B"), scalar(std::string("B") + ending)};
    EXPECT_EQ(issues(schema), "field name 'B" + std::string(ending) + "' is also the name of the object type 'm::B" +
                                  ending + "' nested here; choose another name");
  }
}

// Eigen keeps at most 128 KiB on the stack: 128 x 128 doubles.
TEST(Rules, refuse_fields_whose_value_is_too_large_for_the_stack) {
  EXPECT_EQ(issues(with({of("x", model::Shape::matrix, 128, 128)})), "");
  EXPECT_EQ(issues(with({of("x", model::Shape::diagonal, 1024, 1024)})), "");
  for (const model::Shape shape : {model::Shape::symmetric, model::Shape::skew}) {
    EXPECT_EQ(issues(with({of("x", shape, 128, 128)})), "");
    EXPECT_NE(issues(with({of("x", shape, 129, 129)})).find("whose value takes 133128 bytes in double"),
              std::string::npos);
  }
  model::Field narrow = of("x", model::Shape::matrix, 256, 128);
  for (const model::Element element : {model::Element::float32, model::Element::index, model::Element::int32}) {
    narrow.element = element;
    EXPECT_EQ(issues(with({narrow})), "");
  }
  narrow.rows = 257;
  EXPECT_EQ(issues(with({narrow})),
            "field 'x' has the type Matrix<257, 128>, whose value takes 131584 bytes, and Eigen keeps no more than "
            "131072 on the stack; write blocks, such as 'Matrix<64, 64> x[...]'");
}

// Names of physics must pass: moduli, invariants, coefficients of Mooney and Rivlin, components of strain.
TEST(Rules, refuse_names_of_macros_and_of_nothing_else) {
  for (const char* name : {"M_PI", "INT_MAX", "CHAR_BIT", "RAND_MAX", "FP_NAN", "HUGE_VAL", "UINT8_MAX",
                           "CLOCKS_PER_SEC", "EIGEN_WORLD_VERSION", "EXIT_FAILURE", "SEEK_SET"})
    EXPECT_NE(issues(with({scalar(name)})).find("is written as the macros of system headers are"), std::string::npos)
        << name << ": " << issues(with({scalar(name)}));
  for (const char* name :
       {"EDOM",   "ERANGE", "EOF",    "NAN",     "INFINITY", "BUFSIZ", "L_tmpnam",         "offsetof", "errno",
        "assert", "M_PIl",  "PRIu64", "SIGINT",  "stdin",    "va_arg", "cudaStreamLegacy", "linux",    "I",
        "CMPLX",  "major",  "minor",  "makedev", "MAX",      "HZ",     "roundup"})
    EXPECT_NE(issues(with({scalar(name)})).find("is a macro of a header"), std::string::npos) << name;
  for (const char* name : {"F",  "U",  "V",   "J",     "P",   "E", "K",    "G",    "J0",  "J2",  "I1",  "C10", "A11",
                           "EA", "EI", "EXX", "SIGMA", "EPS", "W", "dPdF", "K_Ic", "M_b", "T_c", "SCN", "PRI", "cu"})
    EXPECT_EQ(issues(with({scalar(name)})), "") << name;
  EXPECT_EQ(issues(with({scalar("K_IC")})),
            "field name 'K_IC' is written as the macros of system headers are, in capitals with an underscore; write "
            "'K_ic' or another name with a small letter");
  EXPECT_NE(issues(with({scalar("NU_12")})).find("write 'nu_12'"), std::string::npos);
}

TEST(Rules, refuse_the_words_of_the_language_that_schemas_are_parsed_without) {
  for (const char* name :
       {"and", "or", "not", "xor", "bitand", "bitor", "compl", "and_eq", "or_eq", "xor_eq", "not_eq", "char8_t"}) {
    const std::string problem = " is a keyword of C++20; choose another name";
    EXPECT_EQ(issues(with({scalar(name)})), "field name '" + std::string(name) + "'" + problem);
    model::Schema schema = with({scalar("x")});
    schema.objects[0].scope = name;
    EXPECT_EQ(issues(schema), "namespace '" + std::string(name) + "'" + problem);
    schema.objects[0].scope = "m";
    schema.objects[0].name = name;
    EXPECT_EQ(issues(schema), "object name '" + std::string(name) + "'" + problem);
  }
}

TEST(Rules, refuse_objects_outside_all_namespaces_and_namespaces_of_the_c_library) {
  model::Schema schema = with({scalar("x")});
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
    model::Schema schema = with({scalar("x")});
    schema.objects.push_back(schema.objects[0]);
    schema.objects[1].name = "B";
    schema.objects[1].scope = "m::A" + std::string(ending) + "::n";
    EXPECT_EQ(issues(schema), "object 'B' is in a namespace 'A" + std::string(ending) +
                                  "', beside object 'A', which would generate a type of that name; rename one of them");
    EXPECT_EQ(objections(schema).at(0).other.object, 0);
    std::swap(schema.objects[0], schema.objects[1]);
    EXPECT_EQ(issues(schema), "object 'A' would generate a type 'A" + std::string(ending) +
                                  "' beside the namespace of that name; rename one of them");
    schema.objects[0].scope = "other::A" + std::string(ending);
    EXPECT_EQ(issues(schema), "") << "of another scope";
  }
}

TEST(Rules, refuse_objects_of_too_many_fields_of_their_own) {
  model::Schema schema = with({});
  for (int f = 0; f < 10000; ++f) schema.objects[0].fields.push_back(scalar("x" + std::to_string(f)));
  ASSERT_EQ(objections(schema).size(), 1U);
  EXPECT_EQ(objections(schema)[0].place, (model::Place{false, 0, -1}));
  EXPECT_NE(issues(schema).find("of generated code, and the limit is 2 MiB; split it into several objects"),
            std::string::npos);
  schema.imported.swap(schema.objects);  // somebody else's header
  schema.objects = {with({nested("a", "m::A")}).objects[0]};
  schema.objects[0].name = "B";
  EXPECT_NE(issues(schema).find("'B' would have 10000 fields, and the limit is 4000; "), std::string::npos);
  schema.objects[0].fields = {scalar("x")};
  EXPECT_EQ(issues(schema), "");
}

}  // namespace
}  // namespace physgen::emit::cpp
