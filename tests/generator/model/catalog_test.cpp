// The catalogue by itself: what its readers rely on. What its rows say is compared with the runtime, by a program that
// uses all of them, in catalog/.
#include <gtest/gtest.h>

#include <set>

#include "model/facts.h"
#include "model/text.h"

namespace physgen::model {
namespace {

template <class Facts>
void expect_words_that_find_their_rows(std::span<const Facts> rows) {
  std::set<std::string_view> words;
  for (const Facts& row : rows) {
    EXPECT_TRUE(words.insert(row.word).second) << row.word << " stands there twice";
    EXPECT_EQ(find_word(rows, row.word), &row);
    EXPECT_EQ(&facts(row.key), &row) << row.word;
  }
  EXPECT_EQ(find_word(rows, "absent"), nullptr);
}

TEST(Catalog, rows_are_found_by_their_words_and_by_their_enumerators) {
  expect_words_that_find_their_rows(spaces());
  expect_words_that_find_their_rows(layouts());
  expect_words_that_find_their_rows(encodings());
  expect_words_that_find_their_rows(shapes());
  expect_words_that_find_their_rows(elements());
}

TEST(Catalog, refuses_numbers_that_are_no_enumerators) {
  EXPECT_THROW((void)facts(static_cast<Encoding>(99)), std::invalid_argument);
  EXPECT_THROW((void)facts(static_cast<LayoutKind>(-1)), std::invalid_argument);
}

TEST(Catalog, standard_layouts_are_tiles_of_two_packs_on_the_host_and_of_a_warp_on_cuda) {
  EXPECT_EQ(layout_word(facts(Space::host).standard), "aosoa(16)");
  EXPECT_EQ(layout_word(facts(Space::cuda).standard), "aosoa(32)");
}

TEST(Catalog, lists_what_schemas_can_say) {
  EXPECT_EQ(joined(layout_words("W"), " or "), "aos, aos_padded, soa or aosoa(W)");
  EXPECT_EQ(joined(encoding_words()), "float32, float64, half, bfloat16, snorm16");
  EXPECT_EQ(joined(field_types()),
            "Scalar, Vector<N>, Matrix<R, C>, Symmetric<N>, Diagonal<N>, Skew<N>, Rotation, Index, float, double, int, "
            "std::int64_t, std::uint64_t, bool");
  EXPECT_EQ(joined(element_types(true), " or "), "Index, int, std::int64_t, std::uint64_t or bool");
  EXPECT_EQ(joined({"one"}, " or "), "one");
}

TEST(Catalog, elements_of_shapes_stand_at_entries_of_their_own) {
  for (const ShapeFacts& row : shapes()) {
    if (row.count == nullptr) continue;
    const int rows = row.sides == Sides::fixed ? row.side : 4;
    const int cols = row.sides == Sides::fixed ? row.side : row.sides == Sides::column ? 1 : 4;
    std::set<std::pair<int, int>> entries;
    for (int k = 0; k < row.count(rows, cols); ++k) {
      const auto [r, c] = row.entry(k, rows);
      EXPECT_TRUE(r >= 0 && r < rows && c >= 0 && c < (row.column ? 1 : cols)) << row.word << ", element " << k;
      EXPECT_TRUE(entries.emplace(r, c).second) << row.word << ", element " << k;
    }
  }
}

}  // namespace
}  // namespace physgen::model
