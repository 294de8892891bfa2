#include "web/assets/world_files.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/scene.pb.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::web {
namespace {

/// A model with a mesh and textures, another one without model.config, and files that must not be served.
class WorldFilesTest : public testing::Test {
 protected:
  WorldFilesTest() {
    for (const char* name :
         {"models/arm/model.config", "models/arm/meshes/arm.dae", "models/arm/materials/textures/skin.png",
          "models/arm/notes.md", "models/arm/key.json", "models/arm/page.html", "models/arm/page.js", "plain/notes.txt",
          "models/other/model.config", "models/other/meshes/other.dae", "plain/box.obj", "plain/box.mtl",
          "plain/deep/secret.png", "loose/meshes/a.stl", "loose/materials/a.png", "loose/photo.png", "secret.png",
          "walker/skin.dae"}) {
      folder_.write(name, name);
    }
    std::filesystem::create_symlink(at("secret.png"), at("models/arm/meshes/link.png"));
  }
  std::string at(const std::string& name) const { return (folder_.path() / name).string(); }
  WorldFiles files() const {
    ignition::msgs::Scene scene;
    const auto addMesh = [&scene](const std::string& file) {
      scene.add_model()->add_link()->add_visual()->mutable_geometry()->mutable_mesh()->set_filename(file);
    };
    addMesh(at("models/arm/meshes/arm.dae"));
    addMesh("file://" + at("plain/box.obj"));
    addMesh(at("loose/meshes/a.stl"));
    addMesh("/etc/passwd");
    addMesh(at("nothing.dae"));
    return WorldFiles(scene, {at("walker/skin.dae"), "/etc/hostname"});
  }

  pongsim::test::TempFolder folder_;
};

TEST_F(WorldFilesTest, HaveWhatTheSceneNamesAndWhatLiesInTheModelsFolder) {
  const WorldFiles files = this->files();
  for (const char* name : {"models/arm/meshes/arm.dae", "models/arm/materials/textures/skin.png", "plain/box.obj",
                           "plain/box.mtl", "loose/meshes/a.stl", "loose/materials/a.png", "walker/skin.dae"}) {
    EXPECT_EQ(files.find(at(name)), std::filesystem::canonical(at(name))) << name;
  }
  EXPECT_TRUE(files.find("file://" + at("models/arm/meshes/arm.dae")));
  EXPECT_TRUE(files.find(at("models/arm/meshes/../materials/textures/skin.png")));
  EXPECT_TRUE(files.find("model://arm/materials/textures/skin.png"));
}

TEST_F(WorldFilesTest, HaveNothingElse) {
  const WorldFiles files = this->files();
  for (const std::string& address : {at("secret.png"),
                                     at("models/other/meshes/other.dae"),
                                     at("models/arm/notes.md"),
                                     at("plain/deep/secret.png"),
                                     at("loose/photo.png"),
                                     at("models/arm/meshes/link.png"),
                                     at("models/arm/../../secret.png"),
                                     at("models/arm/meshes"),
                                     at("models/arm/key.json"),
                                     at("models/arm/page.html"),
                                     at("models/arm/page.js"),
                                     at("plain/notes.txt"),
                                     std::string("/etc/passwd"),
                                     std::string("arm.dae"),
                                     std::string(),
                                     std::string("model://arm/../../secret.png"),
                                     std::string("model://other/meshes/other.dae"),
                                     std::string("model:///etc/passwd"),
                                     std::string("http://a.org/b.png"),
                                     at("plain/box.obj") + '\0',
                                     std::string("model://"),
                                     std::string("file://")}) {
    EXPECT_EQ(files.find(address), std::nullopt) << address;
  }
}

TEST_F(WorldFilesTest, OfInsertedModelsLieInTheFoldersOfModels) {
  ignition::msgs::Scene scene;
  for (const char* file : {"models/arm/meshes/arm.dae", "plain/box.obj", "loose/meshes/a.stl", "secret.png"}) {
    scene.add_model()->add_link()->add_visual()->mutable_geometry()->mutable_mesh()->set_filename(at(file));
  }
  WorldFiles files;
  EXPECT_EQ(files.addInserted(scene, {at("models"), at("plain")}),
            (std::vector<std::string>{at("loose/meshes/a.stl"), at("secret.png")}));
  for (const char* named : {"models/arm/meshes/arm.dae", "models/arm/materials/textures/skin.png", "plain/box.obj"})
    EXPECT_TRUE(files.find(at(named))) << named;
  // of a folder that is not a model's only what is named; nothing of other folders
  for (const char* other :
       {"plain/box.mtl", "plain/deep/secret.png", "loose/meshes/a.stl", "loose/materials/a.png", "secret.png"})
    EXPECT_FALSE(files.find(at(other))) << other;
}

TEST_F(WorldFilesTest, OfInsertedModelsAreNotElsewhereByAnotherName) {
  std::filesystem::create_directory_symlink(at("loose/meshes"), at("plain/link"));
  std::filesystem::create_symlink(at("walker/skin.dae"), at("plain/skin.dae"));
  ignition::msgs::Scene scene;
  const std::vector<std::string> outside{at("plain/../secret.png"), at("plain/link/../photo.png"),
                                         "file://" + at("plain/../loose/meshes/a.stl")};
  for (const std::string& file : outside)
    scene.add_model()->add_link()->add_visual()->mutable_geometry()->mutable_mesh()->set_filename(file);
  // a link that the owner of the folder has made
  scene.add_model()->add_link()->add_visual()->mutable_geometry()->mutable_mesh()->set_filename(at("plain/skin.dae"));
  WorldFiles files;
  EXPECT_EQ(files.addInserted(scene, {at("plain") + "/", at("none")}),
            (std::vector<std::string>{outside[0], outside[1], outside[2].substr(7)}));
  for (const char* other : {"secret.png", "loose/photo.png", "loose/meshes/a.stl"})
    EXPECT_FALSE(files.find(at(other))) << other;
  EXPECT_TRUE(files.find(at("plain/skin.dae")));
}

}  // namespace
}  // namespace pongsim::web
