#include "web/assets/assets.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/scene.pb.h>

#include <filesystem>
#include <string>

#include "support/temp_folder.hh"

namespace pongsim::web {
namespace {

class AssetsTest : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& content) {
    return folder_.write(name, content).string();
  }
  static WorldFiles filesWith(const std::string& mesh) {
    ignition::msgs::Scene scene;
    scene.add_model()->add_link()->add_visual()->mutable_geometry()->mutable_mesh()->set_filename(mesh);
    return WorldFiles(scene);
  }

  pongsim::test::TempFolder folder_;
  Assets assets_;
};

TEST_F(AssetsTest, AreThoseOfAllWorldsWhileTheseAreThere) {
  const std::string one = write("one/a.obj", "first"), two = write("two/b.glb", "second");
  assets_.set(&one, filesWith(one));
  assets_.set(&two, filesWith(two));
  EXPECT_EQ(assets_.fetch(one).bytes, "first");
  EXPECT_EQ(assets_.fetch(two).mediaType, "model/gltf-binary");
  assets_.remove(&one);
  EXPECT_FALSE(assets_.find(one));
  const Asset gone = assets_.fetch(one);
  EXPECT_EQ(gone.bytes, "");
  EXPECT_EQ(gone.error, "no world uses a file '" + one + "'");
}

TEST_F(AssetsTest, SaysWhatIsTooLargeForAMessage) {
  const std::string mesh = write("a.stl", "");
  std::filesystem::resize_file(mesh, Assets::kLargest + 1);
  assets_.set(this, filesWith(mesh));
  EXPECT_NE(assets_.fetch(mesh).error.find("is larger than"), std::string::npos);
  EXPECT_TRUE(assets_.find(mesh));
}

}  // namespace
}  // namespace pongsim::web
