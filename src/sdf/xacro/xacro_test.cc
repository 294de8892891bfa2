#include "sdf/xacro/xacro.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::sdf {
namespace {

constexpr const char* kMacros = "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro name='m'/></robot>";

TEST(Xacro, IsKnownByNameOrMacros) {
  EXPECT_TRUE(isXacro("robot.urdf.xacro", "<robot/>"));
  // of gz_ros2_control's demos
  EXPECT_TRUE(isXacro("robot.xacro.urdf", "<robot/>"));
  EXPECT_TRUE(isXacro("robot.urdf", kMacros));
  EXPECT_FALSE(isXacro("robot.urdf", "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'/>"));
}

TEST(Xacro, IsNotRunForModelsFromOutside) {
  const pongsim::test::TempFolder folder;
  const auto name = std::make_shared<const std::string>("robot.urdf");
  const std::filesystem::path file = folder.write("robot.urdf", kMacros);
  Diagnostics diagnostics;
  EXPECT_FALSE(readExpandedText(file, name, NamedBy::kContent, false, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_NE(diagnostics.all()[0].message.find("is not expanded"), std::string::npos);
  // what needs no xacro is read
  const auto text = readExpandedText(folder.write("plain", "<robot/>"), name, NamedBy::kContent, false, diagnostics);
  ASSERT_TRUE(text);
  EXPECT_EQ(text->text, "<robot/>");
  EXPECT_EQ(text->name, name);
}

}  // namespace
}  // namespace pongsim::sdf
