#include "sdf/text/degrees.hh"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <utility>

namespace pongsim::sdf {
namespace {

using Attributes = std::initializer_list<std::pair<const char*, const char*>>;

/// @return A model with this pose.
Element modelWith(const std::string& text, Attributes attributes = {}, const char* holder = "model") {
  Element pose;
  pose.name = "pose";
  pose.text = text;
  for (const auto& [name, value] : attributes) pose.attributes.push_back({name, value, {}});
  Element model;
  model.name = holder;
  model.children = {pose};
  Element root;
  root.children = {model};
  return root;
}

std::string turned(Element root, const DegreeOptions& options = {}) {
  turnToDegrees(root, options);
  return root.children[0].children[0].text;
}

TEST(Degrees, TakeThePlaceOfRadians) {
  Element root = modelWith("1 -2 3 0 1.5707963 -0.5", {{"relative_to", "f"}});
  turnToDegrees(root, {});
  const Element& pose = root.children[0].children[0];
  EXPECT_EQ(pose.text, "1 -2 3   0 90 -28.6479");
  EXPECT_EQ(pose.attributeOr("degrees", ""), "true");
  EXPECT_EQ(pose.attributeOr("rotation_format", ""), "euler_rpy");
  EXPECT_EQ(pose.attributeOr("relative_to", ""), "f");
}

TEST(Degrees, StayWhereTheyAreGiven) {
  EXPECT_EQ(turned(modelWith("0 0 0 10 20 30", {{"degrees", "true"}})), "0 0 0   10 20 30");
}

TEST(Degrees, ComeOfQuaternionsToo) {
  EXPECT_EQ(turned(modelWith("0 0 1 0 0 0.7071068 0.7071068", {{"rotation_format", "quat_xyzw"}})), "0 0 1   0 0 90");
}

TEST(Degrees, SnapWithinTheTolerance) {
  const Element root = modelWith("0 0 0 0.001 0.5 1.57");
  EXPECT_EQ(turned(root, {.snapTo = 45, .tolerance = 0.1}), "0 0 0   0 28.6479 90");
  EXPECT_EQ(turned(root, {.snapTo = 45, .tolerance = 0.01}), "0 0 0   0.0572958 28.6479 89.9544");
}

TEST(Degrees, AreNotPutIntoPluginsNorIntoWhatIsNoPose) {
  EXPECT_EQ(turned(modelWith("0 0 0 1 0 0", {}, "plugin")), "0 0 0 1 0 0");
  EXPECT_EQ(turned(modelWith("nonsense")), "nonsense");
  EXPECT_EQ(turned(modelWith("")), "0 0 0   0 0 0");
}

}  // namespace
}  // namespace pongsim::sdf
