#include "sim/inputs/world_content.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/temp_folder.hh"

namespace pongsim::sim {
namespace {

class WorldContentTest : public testing::Test {
 protected:
  std::filesystem::path world(const std::string& mass, const std::string& more = "") const {
    return folder_.write("world.sdf",
                         "<sdf version='1.9'><world name='w'><model name='m'><link name='l'><inertial><mass>" + mass +
                             "</mass></inertial></link></model>" + more + "</world></sdf>");
  }
  const test::TempFolder folder_;
};

TEST_F(WorldContentTest, IsTheSameForTheSameWorld) {
  const auto a = contentOf(world("1"));
  const auto b = contentOf(world("1", "<!-- a comment -->"));
  ASSERT_TRUE(a && b);
  EXPECT_EQ(firstDifference(*a, *b), "");
  EXPECT_EQ(contentOf(folder_.path() / "none.sdf"), std::nullopt);
}

TEST_F(WorldContentTest, NamesTheElementThatDiffers) {
  const auto a = contentOf(world("1"));
  EXPECT_EQ(firstDifference(*a, *contentOf(world("2"))), "world 'w', model 'm', link 'l', inertial, mass: '1' and '2'");
  const std::string found = firstDifference(*a, *contentOf(world("1", "<model name='n'><link name='l'/></model>")));
  EXPECT_NE(found.find("model 'n'"), std::string::npos) << found;
}

TEST_F(WorldContentTest, HasWhatIsIncluded) {
  folder_.write("box/model.config", "<model><name>box</name><sdf version='1.9'>model.sdf</sdf></model>");
  const auto boxOf = [&](const std::string& mass) {
    folder_.write("box/model.sdf", "<sdf version='1.9'><model name='box'><link name='l'><inertial><mass>" + mass +
                                       "</mass></inertial></link></model></sdf>");
    return contentOf(world("1", "<include><uri>box</uri></include>"));
  };
  const auto a = boxOf("1");
  const auto b = boxOf("2");
  ASSERT_TRUE(a && b);
  EXPECT_EQ(firstDifference(*a, *b), "world 'w', model 'box', link 'l', inertial, mass: '1' and '2'");
}

TEST_F(WorldContentTest, NamesAMeshWithAnotherContent) {
  const std::string model =
      "<model name='n'><link name='l'><visual "
      "name='v'><geometry><mesh><uri>a.stl</uri></mesh></geometry></visual></link></model>";
  folder_.write("a.stl", "solid a\nendsolid a\n");
  const auto a = contentOf(world("1", model));
  folder_.write("a.stl", "solid b\nendsolid b\n");
  const auto b = contentOf(world("1", model));
  ASSERT_TRUE(a && b);
  EXPECT_EQ(firstDifference(*a, *b), "file '" + (folder_.path() / "a.stl").string() + "' has another content");
}

}  // namespace
}  // namespace pongsim::sim
