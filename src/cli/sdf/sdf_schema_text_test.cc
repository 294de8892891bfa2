#include "cli/sdf/sdf_schema_text.hh"

#include <gtest/gtest.h>

namespace pongsim::cli {
namespace {

TEST(SdfSchemaText, KnowsTheVersionsThatAreDescribed) {
  EXPECT_EQ(sdfVersion("1.4"), 4);
  EXPECT_EQ(sdfVersion("1.9"), 9);
  EXPECT_EQ(sdfVersion("1.12"), 12);
  for (const char* other : {"", "1", "1.3", "1.13", "2.0", "joint", "1.x"}) {
    EXPECT_EQ(sdfVersion(other), std::nullopt) << other;
  }
}

TEST(SdfSchemaText, HasAllElementsInTheFormOfFortress) {
  const std::string text = schemaText(9);
  EXPECT_TRUE(text.starts_with("<element name ='sdf' required ='1'>\n  <description><![CDATA[")) << text.substr(0, 200);
  EXPECT_NE(text.find("  <attribute name ='version' type ='string' default ='1.9' required ='1'>\n"),
            std::string::npos);
  EXPECT_NE(text.find("<element name ='gravity' required ='1' type ='vector3' default ='0 0 -9.8'>"),
            std::string::npos);
  EXPECT_NE(text.find("<element copy_data ='true' required ='*'/>"), std::string::npos);
  EXPECT_NE(text.find("<element ref ='model' required ='*'/>"), std::string::npos);
  EXPECT_TRUE(text.ends_with("\n</element>\n"));
}

TEST(SdfSchemaText, LeavesOutWhatAVersionHasNot) {
  const std::string capsule = "<element name ='capsule'";
  EXPECT_NE(schemaText(9).find(capsule), std::string::npos);
  EXPECT_EQ(schemaText(6).find(capsule), std::string::npos);
  EXPECT_NE(schemaText(6).find("default ='1.6'"), std::string::npos);
  const std::string cone = "<element name ='cone'";
  EXPECT_EQ(schemaText(10).find(cone), std::string::npos);
  EXPECT_NE(schemaText(11).find(cone), std::string::npos);
  const std::string upper = "<element name ='upper' required ='1' type ='double' default =";
  EXPECT_NE(schemaText(9).find(upper + "'1e16'"), std::string::npos);
  EXPECT_NE(schemaText(10).find(upper + "'inf'"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::cli
