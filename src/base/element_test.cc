#include "pongsim/element.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim {
namespace {

Element leaf(std::string name, std::string text) {
  Element element;
  element.name = std::move(name);
  element.text = std::move(text);
  element.position = {std::make_shared<const std::string>("world.sdf"), 7, 3};
  return element;
}

class ElementTest : public testing::Test {
 protected:
  ElementTest() {
    plugin_.name = "plugin";
    plugin_.attributes.push_back({"filename", "diff-drive", {}});
    plugin_.children = {leaf("left_joint", "a"), leaf("left_joint", "b"),         leaf("radius", "0.4"),
                        leaf("enabled", "true"), leaf("offset", " 1 -2\n 3e-1 "), leaf("count", "12"),
                        leaf("empty", "")};
  }
  Element plugin_;
};

TEST_F(ElementTest, FindsChildrenByName) {
  ASSERT_NE(plugin_.child("left_joint"), nullptr);
  EXPECT_EQ(plugin_.child("left_joint")->text, "a");
  EXPECT_EQ(plugin_.childrenNamed("left_joint").size(), 2U);
  EXPECT_EQ(plugin_.child("right_joint"), nullptr);
}

TEST_F(ElementTest, FindsAttributes) {
  EXPECT_EQ(plugin_.attributeOr("filename", "none"), "diff-drive");
  EXPECT_EQ(plugin_.attributeOr("name", "none"), "none");
  EXPECT_EQ(plugin_.attribute("name"), nullptr);
}

TEST_F(ElementTest, ReadsValuesOfEachType) {
  EXPECT_EQ(plugin_.get("radius", 0.0), 0.4);
  EXPECT_EQ(plugin_.get("enabled", false), true);
  EXPECT_EQ(plugin_.get("count", 0), 12);
  EXPECT_EQ(plugin_.get<std::string>("left_joint", ""), "a");
  EXPECT_EQ(plugin_.get("offset", Vector3(0, 0, 0)), Vector3(1, -2, 0.3));
}

TEST_F(ElementTest, FallsBackWhereThereIsNoValue) {
  EXPECT_EQ(plugin_.get("nothing", 2.5), 2.5);
  EXPECT_EQ(plugin_.get("empty", 2.5), 2.5);
  EXPECT_FALSE(plugin_.find<double>("empty").has_value());
}

template <class T>
std::string errorOf(const std::string& text) {
  try {
    static_cast<void>(leaf("value", text).as<T>());
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(ElementTest, NamesThePositionAndTheTextOfAWrongValue) {
  EXPECT_EQ(errorOf<double>("0.4m"), "world.sdf:7:3: error: <value> is '0.4m', which is not a number");
  EXPECT_EQ(errorOf<bool>("yes"), "world.sdf:7:3: error: <value> is 'yes', which is not 'true' or 'false'");
  EXPECT_EQ(errorOf<int>("1.5"), "world.sdf:7:3: error: <value> is '1.5', which is not an integer");
  EXPECT_EQ(errorOf<int>("3000000000"), "world.sdf:7:3: error: <value> is '3000000000', which is not an integer");
  EXPECT_EQ(errorOf<Vector3>("1 2"), "world.sdf:7:3: error: <value> is '1 2', which is not three numbers");
}

}  // namespace
}  // namespace pongsim
