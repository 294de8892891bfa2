#include "log/record/resources.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

/// @return The text with brackets around the addresses.
std::string marked(std::string_view sdf) {
  return withAddresses(sdf, [](const std::string& address) { return "[" + address + "]"; });
}

TEST(WithAddresses, FindsThoseThatAreAnElementsWholeText) {
  EXPECT_EQ(marked("<mesh><uri>model://a/b.dae</uri></mesh>"), "<mesh><uri>[model://a/b.dae]</uri></mesh>");
  EXPECT_EQ(marked("<albedo_map>a.png</albedo_map><normal>b.png</normal>"),
            "<albedo_map>[a.png]</albedo_map><normal>[b.png]</normal>");
  // other elements, and elements without text
  for (const char* same : {"<name>uri</name>", "<uri></uri>", "<uri> \n</uri>", "<uri><a/></uri>", "<a b='<uri'>x",
                           "<uri>x", "no markup", ""}) {
    EXPECT_EQ(marked(same), same);
  }
}

class ResourceCopiesTest : public testing::Test {
 protected:
  /// Path of a file's copy.
  fs::path copyOf(const fs::path& file) const { return recording_ / file.relative_path(); }

  test::TempFolder folder_;
  const fs::path recording_ = folder_.path() / "rec";
  ResourceCopies copies_{recording_};
};

TEST_F(ResourceCopiesTest, AreBelowTheWholePathOfTheFile) {
  const fs::path mesh = folder_.write("meshes/wheel.obj", "mesh"), look = folder_.write("meshes/wheel.mtl", "look"),
                 other = folder_.write("meshes/notes.txt", "other");
  copies_.add(mesh);
  EXPECT_TRUE(fs::exists(copyOf(mesh)));
  EXPECT_TRUE(fs::exists(copyOf(look)));
  EXPECT_FALSE(fs::exists(copyOf(other)));
  copies_.add(folder_.path() / "meshes/none.obj");
  copies_.add("");
  EXPECT_FALSE(fs::exists(copyOf(folder_.path() / "meshes/none.obj")));
}

TEST_F(ResourceCopiesTest, AreOfAModelsWholeFolder) {
  folder_.write("robot/model.config", "");
  const fs::path mesh = folder_.write("robot/meshes/wheel.obj", ""), other = folder_.write("robot/notes.txt", "");
  copies_.add(mesh);
  EXPECT_TRUE(fs::exists(copyOf(mesh)));
  EXPECT_TRUE(fs::exists(copyOf(other)));
}

TEST_F(ResourceCopiesTest, FailWhereTheyCannotBeWritten) {
  const fs::path mesh = folder_.write("wheel.obj", "");
  folder_.write("rec", "a file where the recording should be");
  EXPECT_THROW(copies_.add(mesh), Failure);
}

}  // namespace
}  // namespace pongsim::log
