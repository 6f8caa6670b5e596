// Vocabularies of other versions, which -I can put before the built-in one.
#include <gtest/gtest.h>

#include <iterator>

#include "case.h"

namespace physgen::test {
namespace {

/// The built-in vocabulary with each of these texts, which must be there, replaced by another one.
std::string vocabulary_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::ifstream file(PHYSGEN_VOCABULARY, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [from, to] : changes) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
  }
  return text;
}

frontend::Result parse_with(const std::string& vocabulary, const std::string& text) {
  const Folder folder;
  folder.write("include/physgen/schema.h", vocabulary);
  return parse_file(folder.write("schema.h", text), {folder / "include"});
}

const std::string all_enumerations = schema_of(
    "struct PHYSGEN_OBJECT(layout(host, soa), layout(cuda, aosoa(8))) A {\n"
    "  PHYSGEN(format(host, half), format(cuda, bfloat16)) Scalar x;\n"
    "  PHYSGEN(format(host, float64), format(cuda, float32)) Scalar y;\n"
    "  PHYSGEN(format(host, quaternion()), format(cuda, snorm16)) Rotation R;\n};\n"
    "struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos_padded)) B { Scalar x; };\n");

TEST(Frontend, reads_the_same_from_a_vocabulary_that_lists_its_enumerators_in_another_order) {
  const auto expected = parse_text(all_enumerations);
  const auto found = parse_with(vocabulary_with({{"Space { host, cuda }", "Space { cuda, host }"},
                                                 {"{ aos, aos_padded, soa, aosoa }", "{ aosoa, soa, aos, aos_padded }"},
                                                 {"{ native, float32, float64, half, bfloat16, snorm16 }",
                                                  "{ snorm16, half, bfloat16, native, float64, float32 }"}}),
                                all_enumerations);
  ASSERT_TRUE(expected.schema && found.schema) << expected.diagnostics << found.diagnostics;
  EXPECT_EQ(*found.schema, *expected.schema);
  EXPECT_EQ(found.schema->objects.at(0).host_layout, (model::Layout{model::LayoutKind::soa, 0}));
}

TEST(Frontend, reports_enumerators_and_types_that_only_another_version_has) {
  const std::string vocabulary =
      vocabulary_with({{"Space { host, cuda }", "Space { host, cuda, disk }"},
                       {"{ aos, aos_padded, soa, aosoa }", "{ aos, curve, aos_padded, soa, aosoa }"},
                       {"{ native, float32, ", "{ native, posit16, float32, "},
                       {"// ---- Options of objects ----",
                        "inline constexpr detail::Space disk = detail::Space::disk;\n"
                        "inline constexpr detail::Pattern curve{detail::Arrangement::curve, 0};\n"
                        "inline constexpr detail::StorageFormat posit16{detail::Encoding::posit16, 0};\n"
                        "template <int Size, class Element = Scalar> struct Hankel {};\n"}});
  const auto result = parse_with(vocabulary, schema_of("struct PHYSGEN_OBJECT(layout(host, curve)) A {\n"
                                                       "  PHYSGEN(format(cuda, posit16)) Scalar x;\n"
                                                       "  PHYSGEN(format(disk, half)) Scalar y;\n"
                                                       "  Hankel<3> h;\n};\n"));
  EXPECT_FALSE(result.schema.has_value());
  const std::string version = " of <physgen/schema.h>, which is for another version; it knows ";
  EXPECT_EQ(
      headlines(result.diagnostics),
      (std::vector<std::string>{
          "3:23: error: this physgen does not know the layout 'curve'" + version + "aos, aos_padded, soa and aosoa",
          "4:11: error: this physgen does not know the encoding 'posit16'" + version +
              "native, float32, float64, half, bfloat16 and snorm16",
          "5:11: error: this physgen does not know the memory space 'disk'" + version + "host and cuda",
          "6:3: error: field 'h' has the type 'Hankel' of a <physgen/schema.h> for another version, which this "
          "physgen does not know; write Scalar, Vector<N>, Matrix<R, C>, Symmetric<N>, Diagonal<N>, Skew<N>, "
          "Rotation, Index, float, double, int, std::int64_t, std::uint64_t, bool or an object"}))
      << result.diagnostics;
  EXPECT_NE(result.diagnostics.find("PHYSGEN_OBJECT(layout(host, curve)) A {\n"), std::string::npos) << "with a caret";
  EXPECT_NE(result.diagnostics.find("                      ^~~~~~~~~~~~~~~~~~~\n"), std::string::npos)
      << result.diagnostics;
}

}  // namespace
}  // namespace physgen::test
