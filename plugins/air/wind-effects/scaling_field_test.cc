#include "scaling_field.hh"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "pongsim/diagnostic.hh"

namespace pongsim::scaling_field_test {
namespace {

Element element(const std::string& name, const std::string& text,
                std::vector<std::pair<std::string, std::string>> attributes = {}) {
  Element made;
  made.name = name;
  made.text = text;
  for (auto& [key, value] : attributes) made.attributes.push_back({key, value, {}});
  return made;
}

Element field(std::vector<Element> children, std::vector<std::pair<std::string, std::string>> attributes = {},
              const std::string& name = "force_approximation_scaling_factor") {
  Element made = element(name, "", std::move(attributes));
  made.children = std::move(children);
  return made;
}

TEST(ScalingField, IsASumOfPolynomials) {
  const ScalingField everywhere(
      field({element("k", "0.5"), element("px", "1 0 1 0"), element("qy", "0 1 0 1"), element("rz", "0 0 2 0.25")}));
  // p = x^3 + x, q = y^2 + 1, r = 2 z + 0.25
  EXPECT_DOUBLE_EQ(everywhere.at({2, 3, 4}), 0.5 * (8 + 2 + 9 + 1 + 8 + 0.25));
  // what is not given is 0
  EXPECT_DOUBLE_EQ(ScalingField(field({element("rz", "0 0 0 3")})).at({9, 9, 9}), 3);
}

// the world of Gazebo's test: nothing below the sea, a layer, and vortices above
TEST(ScalingField, DiffersByRegion) {
  const ScalingField sea(field({element("when", "0.2", {{"zgt", "0"}, {"zlt", "5"}}),
                                field({element("k", "0.5"), element("px", "0 0.01 0 0"), element("qy", "0 0.01 0 0"),
                                       element("rz", "0 0 0.01 0.45")},
                                      {{"zge", "5"}}, "when")}));
  EXPECT_EQ(sea.at({1, 1, -1}), 0);
  EXPECT_EQ(sea.at({1, 1, 0}), 0);
  EXPECT_DOUBLE_EQ(sea.at({1, 1, 0.1}), 0.2);
  EXPECT_DOUBLE_EQ(sea.at({10, 20, 5}), 0.5 * (1 + 4 + 0.05 + 0.45));
}

TEST(ScalingField, HasHalfSpacesWithAndWithoutTheirBorder) {
  const ScalingField octant(field({element("when", "1", {{"xge", "0"}, {"yle", "0"}, {"zlt", "2"}})}));
  EXPECT_EQ(octant.at({0, 0, 1}), 1);
  EXPECT_EQ(octant.at({-0.1, 0, 1}), 0);
  EXPECT_EQ(octant.at({0, 0.1, 1}), 0);
  EXPECT_EQ(octant.at({0, 0, 2}), 0);
}

TEST(ScalingField, IsNeverNegative) {
  EXPECT_EQ(ScalingField(field({element("when", "-1", {{"xge", "0"}})})).at({1, 0, 0}), 0);
}

TEST(ScalingField, RefusesWhatMakesNoSense) {
  const auto fault = [](const Element& wrong) -> std::string {
    try {
      const ScalingField made(wrong);
      return "";
    } catch (const Error& error) {
      return error.diagnostic().message;
    }
  };
  EXPECT_EQ(fault(field({element("px", "1 2 3")})), "<px> needs four numbers");
  EXPECT_EQ(fault(field({element("k", "inf")})), "<k> must be a finite number");
  EXPECT_NE(fault(field({element("when", "much")})), "");
  EXPECT_NE(fault(field({element("when", "1", {{"xge", "left"}})})), "");
  EXPECT_EQ(fault(field({element("when", "1", {{"xge", "0"}, {"xgt", "0"}})})),
            "<when> has xge and xgt: one of them is enough");
}

}  // namespace
}  // namespace pongsim::scaling_field_test
