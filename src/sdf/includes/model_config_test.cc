#include "sdf/includes/model_config.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::sdf {
namespace {

/// @return The file's name, or the messages if there is none.
std::string chosen(const std::string& content) {
  const pongsim::test::TempFolder folder;
  const std::filesystem::path file = folder.write("model.config", content);
  Diagnostics diagnostics;
  const auto found = readModelConfig(file, std::make_shared<const std::string>("c"), diagnostics);
  if (found) return found->lexically_relative(folder.path()).string();
  return diagnostics.all().size() == 1 ? format(diagnostics.all()[0]) : "no error, or too many";
}

std::string sdf(const std::string& version, const std::string& file) {
  return "<sdf version='" + version + "'>" + file + "</sdf>";
}

TEST(ModelConfig, NamesTheFileOfTheNewestVersionThatFortressReads) {
  EXPECT_EQ(chosen("<model><name>m</name>" + sdf("1.5", "a") + sdf("1.9", "b") + sdf("1.10", "c") + sdf("1.7", "d") +
                   "</model>"),
            "b");
  EXPECT_EQ(chosen("<model>" + sdf("1.10", "a") + sdf("1.4", "b") + "</model>"), "b");
}

TEST(ModelConfig, NamesTheNewestSupportedFileWhereFortressReadsNone) {
  EXPECT_EQ(chosen("<model>" + sdf("1.10", "a") + sdf("1.12", "b") + sdf("1.11", "c") + sdf("1.13", "d") + "</model>"),
            "b");
}

TEST(ModelConfig, NamesTheFirstFileWhereNoVersionIsSupportedOrKnown) {
  EXPECT_EQ(chosen("<model>" + sdf("1.14", "a") + sdf("1.13", "b") + "</model>"), "a");
  EXPECT_EQ(chosen("<model><sdf>sub/a.sdf</sdf><sdf version='x'>b</sdf></model>"), "sub/a.sdf");
}

TEST(ModelConfig, SaysWhereItNamesNone) {
  EXPECT_EQ(chosen("<model>\n<sdf version='1.9'/></model>"),
            "c:1:1: error: the model has no <sdf>\n  hint: write <sdf version=\"1.9\">model.sdf</sdf>");
  EXPECT_EQ(chosen("<model>"), "c:1:1: error: <model> is not closed\n  hint: the file ends before its </model>");
  EXPECT_EQ(chosen(""), "c: error: the file is empty");
}

}  // namespace
}  // namespace pongsim::sdf
