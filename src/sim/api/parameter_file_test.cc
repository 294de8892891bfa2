#include "pongsim/files/parameter_file.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "support/environment_variable.hh"
#include "support/temp_folder.hh"

namespace pongsim {
namespace {

class ParameterFileTest : public testing::Test {
 protected:
  ParameterFileTest() {
    std::filesystem::create_directory(folder_.path() / "worlds");
    std::filesystem::create_directory(folder_.path() / "models");
    std::ofstream(folder_.path() / "worlds" / "data.csv") << "beside the world";
    std::ofstream(folder_.path() / "models" / "other.csv") << "in a resource folder";
  }

  /// @return The content of the file, or what is wrong with it.
  std::string read(const std::string& address, std::uint64_t largest = 100) const {
    Element element{.name = "data", .text = address, .attributes = {}, .children = {}, .position = {}};
    element.position.file = std::make_shared<const std::string>((folder_.path() / "worlds" / "world.sdf").string());
    try {
      return parameterFile(element, largest);
    } catch (const Error& error) {
      EXPECT_EQ(error.diagnostic().position.file, element.position.file);
      return error.diagnostic().message;
    }
  }

  test::TempFolder folder_;
};

TEST_F(ParameterFileTest, IsBesideTheFileThatNamesIt) {
  EXPECT_EQ(read("data.csv"), "beside the world");
  EXPECT_EQ(read((folder_.path() / "worlds" / "data.csv").string()), "beside the world");
}

TEST_F(ParameterFileTest, IsInAResourceFolder) {
  EXPECT_EQ(read("other.csv"), "'other.csv' is not found");
  const test::EnvironmentVariable path("PONGSIM_RESOURCE_PATH", (folder_.path() / "models").string());
  EXPECT_EQ(read("other.csv"), "in a resource folder");
}

TEST_F(ParameterFileTest, IsARegularFileThatIsNotTooLarge) {
  EXPECT_EQ(read("data.csv", 16), "beside the world");
  EXPECT_NE(read("data.csv", 15).find("'data.csv' is larger than"), std::string::npos) << read("data.csv", 15);
  EXPECT_EQ(read("../worlds"), "'../worlds' is a folder, not a file");
  EXPECT_EQ(read("none.csv"), "'none.csv' is not found");
}

}  // namespace
}  // namespace pongsim
