#include "sdf/readers/shapes/heightmap_reader.hh"

#include "support/png_file.hh"
#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

class HeightmapReaderTest : public ::testing::Test {
 protected:
  /// Loads a collision 'c' with this in its `<heightmap>`, from "w.sdf".
  Loaded loadWith(const std::string& content) {
    folder_.write("w.sdf",
                  "<sdf version='1.9'><world name='w'><model name='m'><link name='l'><collision name='c'><geometry>\n"
                  "<heightmap>" +
                      content + "</heightmap></geometry></collision></link></model></world></sdf>");
    Loaded loaded = load([this](Diagnostics& diagnostics) {
      return loadFile(folder_.path() / "w.sdf", diagnostics, assets::finderIn({}));
    });
    const std::string folder = folder_.path().string();
    for (std::string& message : loaded.messages) {
      for (std::size_t at = 0; (at = message.find(folder)) != std::string::npos;) {
        message.replace(at, folder.size(), "DIR");
      }
    }
    return loaded;
  }
  static const description::Heightmap& heightmapOf(const Loaded& loaded) {
    return std::get<description::Heightmap>(loaded.model().links.at(0).collisions.at(0).geometry);
  }

  const pongsim::test::TempFolder folder_;
};

TEST_F(HeightmapReaderTest, MakesGroundOfAnImage) {
  // the upper right pixel is the brightest
  folder_.write("a.png", pongsim::test::grayPng(2, {0, 200, 0, 50}));
  const Loaded loaded = loadWith("<uri>a.png</uri><size>10 20 3</size><pos>0 0 1</pos>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Heightmap& map = heightmapOf(loaded);
  EXPECT_EQ(map.uri, "a.png");
  ASSERT_NE(map.triangles, nullptr);
  ASSERT_EQ(map.triangles->vertices.size(), 4U);
  EXPECT_EQ(map.triangles->vertices[1], Vector3(2.5, 5, 4));
  EXPECT_EQ(map.triangles->vertices[2], Vector3(-2.5, -5, 1));
  EXPECT_EQ(map.triangles->vertices[3], Vector3(2.5, -5, 1.75));
  ASSERT_EQ(map.triangles->triangles.size(), 2U);
  // all normals point up
  for (const auto& [a, b, c] : map.triangles->triangles) {
    const auto& v = map.triangles->vertices;
    EXPECT_GT((v[b] - v[a]).cross(v[c] - v[a]).z(), 0);
  }
}

TEST_F(HeightmapReaderTest, IsFlatWhereTheImageIsBlack) {
  folder_.write("a.png", pongsim::test::grayPng(3, std::vector<std::uint8_t>(9, 0)));
  const Loaded loaded = loadWith("<uri>a.png</uri>");
  for (const Vector3& vertex : heightmapOf(loaded).triangles->vertices) EXPECT_EQ(vertex.z(), 0);
}

TEST_F(HeightmapReaderTest, WarnsOfAnImageThatIsNotThereOrBroken) {
  EXPECT_EQ(
      loadWith("<uri>a.png</uri>").messages,
      Messages{"DIR/w.sdf:2:12: warning: heightmap 'a.png' is not found: collision 'c' of link 'l' of model 'm' will "
               "not collide | looked for it at DIR/a.png, a.png; set PONGSIM_RESOURCE_PATH to search more folders"});
  const Loaded loaded = loadWith("<uri>w.sdf</uri>");
  ASSERT_EQ(loaded.messages.size(), 1U);
  EXPECT_TRUE(loaded.messages[0].starts_with("DIR/w.sdf:2:12: warning: heightmap 'DIR/w.sdf' can't be read as a PNG "));
  EXPECT_EQ(heightmapOf(loaded).triangles, nullptr);
}

TEST_F(HeightmapReaderTest, RefusesWhatCanNotBeMeant) {
  EXPECT_EQ(loadWith("<size>1 1 0</size>").messages, Messages{"DIR/w.sdf:2:12: error: the heightmap of collision 'c' "
                                                              "of link 'l' of model 'm' must have a size above zero"});
}

}  // namespace
}  // namespace pongsim::sdf::test
