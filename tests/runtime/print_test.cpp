// Objects as text, and channels as plain ranges.
#include <everything.physgen.h>
#include <physgen/channel.h>
#include <physgen/print.h>

#include <numeric>
#include <sstream>

#include "test_objects.h"

namespace physgen::test {
namespace {

template <class T>
std::string text_of(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

template <class L>
class PrintIn : public ::testing::Test {};
TYPED_TEST_SUITE(PrintIn, AllLayouts, LayoutName);

struct Compact : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<>;
  using s = format::Half<>;
};

TYPED_TEST(PrintIn, writes_fields_with_units_in_every_layout_and_format) {
  elasticity::NodePositionArray<float, Host, TypeParam> nodes(33);
  nodes[32].x() = Eigen::Vector3f(1, -2.5F, 3);
  EXPECT_EQ(text_of(nodes[32]), "{x [m] = {1, -2.5, 3}}");
  EXPECT_EQ(text_of(std::as_const(nodes)[31]), "{x [m] = {0, 0, 0}}");
  Array<elasticity::DeformationSvdObject, float, Host, TypeParam, Compact> svd(3);
  svd[1].s() = Eigen::Vector3f(1, 2, 0.5F);
  EXPECT_EQ(text_of(svd[1]),
            "{U = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, V = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, s [1] = {1, 2, 0.5}}");
  elasticity::TetArray<float, Host, TypeParam> tets(1);
  tets[0].nodes() = Eigen::Vector4i(4, 3, 2, 1);
  EXPECT_EQ(text_of(tets[0]), "{nodes = {4, 3, 2, 1}}");
  elasticity::TetStiffnessArray<float, Host, TypeParam> stiffness(1);
  EXPECT_NE(text_of(stiffness[0]).find("{k [N/m] = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0"), std::string::npos)
      << text_of(stiffness[0]);
}

TEST(Print, writes_the_first_objects_of_an_array_and_says_that_there_are_more) {
  elasticity::NodePositionArray<double> nodes(2);
  EXPECT_EQ(text_of(nodes), "2 elasticity::NodePosition = {{x [m] = {0, 0, 0}}, {x [m] = {0, 0, 0}}}");
  nodes.resize(11);
  nodes[10].x() = Eigen::Vector3d(7, 7, 7);
  const std::string text = text_of(nodes);
  EXPECT_EQ(text.find('7'), std::string::npos);
  EXPECT_TRUE(text.ends_with("}} and more")) << text;
  EXPECT_EQ(text_of(elasticity::NodePositionArray<double>()), "0 elasticity::NodePosition = {}");
}

TEST(Print, refuses_objects_that_are_not_there) {
  const elasticity::NodePositionArray<double> nodes(2);
  std::ostringstream out;
  EXPECT_NE(message_of([&] { print(out, nodes, 1, 3); }).find("NodePosition[2] has no objects 1 up to 3"),
            std::string::npos);
  print(out, nodes, 1, 2);
  EXPECT_EQ(out.str(), "{{x [m] = {0, 0, 0}}}");
}

TEST(Channel, is_an_element_of_all_objects) {
  elasticity::NodePositionArray<float, Host, Soa> nodes;
  nodes.reserve(1000);
  nodes.resize(77);
  for (index_t i = 0; i < 77; ++i) nodes[i].x() = Eigen::Vector3f(0, static_cast<float>(i), 1);
  const std::span<float> y = channel<"x">(nodes, 1);
  ASSERT_EQ(y.size(), 77U);
  EXPECT_EQ(std::accumulate(y.begin(), y.end(), 0.0F), 76 * 77 / 2);
  y[5] = -1;
  EXPECT_EQ(nodes[5].x()[1], -1);
  const auto& constant = nodes;
  const std::span<const float> z = channel<"x">(constant, 2);
  EXPECT_EQ(z[76], 1);
  elasticity::TetArray<float, Host, Soa> tets(3);
  tets[2].nodes() = Eigen::Vector4i(1, 2, 3, 4);
  const std::span<std::int32_t> last = channel<"nodes">(tets, 3);
  EXPECT_EQ(last[2], 4);
  EXPECT_NE(message_of([&] { (void)channel<"x">(nodes, 3); }).find("NodePosition::x has elements 0 to 2, not 3"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)channel<"x">(nodes, -1); }).find("not -1"), std::string::npos);
  elasticity::NodePositionArray<float, Host, Soa> none;
  EXPECT_TRUE(channel<"x">(none).empty());
}

}  // namespace
}  // namespace physgen::test
