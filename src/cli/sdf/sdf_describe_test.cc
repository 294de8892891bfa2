#include "cli/sdf/sdf_describe.hh"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace pongsim::cli {
namespace {

std::string described(const char* path) { return describe(std::get<sdf::NamedPart>(sdf::findPart(path))); }

TEST(SdfDescribe, TellsAllOfAnElement) {
  EXPECT_EQ(described("joint/axis/xyz"),
            "<xyz> in joint/axis\n"
            "  Represents the x,y,z components of the axis unit vector. The axis is expressed in the joint frame\n"
            "  unless a different frame is expressed in the expressed_in attribute. The vector should be\n"
            "  normalized.\n"
            "\n"
            "  type        vector3\n"
            "  default     0 0 1\n"
            "  how often   once\n"
            "  versions    since SDF 1.2\n"
            "  in pongsim  read\n"
            "\n"
            "attributes:\n"
            "  @expressed_in  string  \"\"  optional  Name of frame in whose coordinates the xyz unit vector is...\n");
}

TEST(SdfDescribe, TellsWhereASharedElementStands) {
  EXPECT_TRUE(described("box").starts_with("<box> in geometry, population\n")) << described("box");
  EXPECT_TRUE(described("sdf").starts_with("<sdf>\n"));
  EXPECT_NE(described("plugin").find("(anything)"), std::string::npos);
}

TEST(SdfDescribe, TellsOfWhatIsGone) {
  EXPECT_NE(described("joint/axis/use_parent_model_frame").find("versions    SDF 1.5 to 1.6\n"), std::string::npos);
  EXPECT_NE(described("inertial/pose/@relative_to").find("versions    SDF 1.7 only\n"), std::string::npos);
  EXPECT_NE(described("world/gui").find("in pongsim  kept as it is\n"), std::string::npos);
  EXPECT_NE(described("battery").find("in pongsim  known, but unused\n"), std::string::npos);
}

TEST(SdfDescribe, KeepsToTheWidthOfAScreen) {
  for (const auto& part : sdf::Schema::instance().allShared()) {
    std::istringstream lines(describe({&part, false, {}}));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120U) << line;
  }
}

}  // namespace
}  // namespace pongsim::cli
