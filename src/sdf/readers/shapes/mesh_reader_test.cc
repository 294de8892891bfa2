#include "sdf/readers/shapes/mesh_reader.hh"

#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

class MeshReaderTest : public ::testing::Test {
 protected:
  /// Loads a link of a model in "DIR/w.sdf", what is in it beginning in line 2, column 1.
  Loaded loadWith(const std::string& content) {
    folder_.write("w.sdf", "<sdf version='1.9'><world name='w'><model name='m'><link name='l'>\n" + content +
                               "\n</link></model></world></sdf>");
    Loaded loaded = load([this](Diagnostics& diagnostics) {
      return loadFile(folder_.path() / "w.sdf", diagnostics, assets::finderIn({{folder_.path() / "models"}, {}}));
    });
    const std::string folder = folder_.path().string();
    for (std::string& message : loaded.messages) {
      for (std::size_t at = 0; (at = message.find(folder)) != std::string::npos;) {
        message.replace(at, folder.size(), "DIR");
      }
    }
    return loaded;
  }
  /// @return A collision 'c' with this in its `<mesh>`.
  static std::string collision(const std::string& mesh) {
    return "<collision name='c'><geometry><mesh>" + mesh + "</mesh></geometry></collision>\n";
  }
  static const description::Mesh& meshOf(const Loaded& loaded, std::size_t i = 0) {
    return std::get<description::Mesh>(loaded.model().links.at(0).collisions.at(i).geometry);
  }

  const pongsim::test::TempFolder folder_;
};

constexpr std::string_view kTriangles =
    "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\n";

TEST_F(MeshReaderTest, ReadsTheTrianglesOfACollision) {
  folder_.write("models/box/a.obj", kTriangles);
  const Loaded loaded = loadWith(collision("<uri>model://box/a.obj</uri><scale>1 -2 3</scale>"));
  EXPECT_EQ(loaded.messages, Messages());
  const description::Mesh& mesh = meshOf(loaded);
  EXPECT_EQ(mesh.uri, "model://box/a.obj");
  EXPECT_EQ(mesh.file, folder_.path() / "models/box/a.obj");
  EXPECT_EQ(mesh.scale, Vector3(1, -2, 3));
  ASSERT_NE(mesh.triangles, nullptr);
  EXPECT_EQ(mesh.triangles->triangles.size(), 2U);
}

TEST_F(MeshReaderTest, FindsAFileBesideItsOwnAndOneOfItsParts) {
  folder_.write("meshes/a.obj", kTriangles);
  const Loaded loaded =
      loadWith(collision("<uri>meshes/a.obj</uri><submesh><name>b</name><center>true</center></submesh>"));
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(meshOf(loaded).submesh, "b");
  EXPECT_TRUE(meshOf(loaded).isCentered);
  EXPECT_EQ(meshOf(loaded).triangles->vertices.at(0), Vector3(-0.5, -0.5, 0));
}

TEST_F(MeshReaderTest, SharesTrianglesAndLeavesVisualsAlone) {
  folder_.write("a.obj", kTriangles);
  const Loaded loaded =
      loadWith(collision("<uri>a.obj</uri>") +
               "<collision name='d'><geometry><mesh><uri>a.obj</uri><scale>2 2 2</scale></mesh></geometry></collision>"
               "<visual name='v'><geometry><mesh><uri>a.obj</uri></mesh></geometry></visual>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(meshOf(loaded, 0).triangles, meshOf(loaded, 1).triangles);
  const auto& visual = std::get<description::Mesh>(loaded.model().links.at(0).visuals.at(0).geometry);
  EXPECT_EQ(visual.file, folder_.path() / "a.obj");
  EXPECT_EQ(visual.triangles, nullptr);
}

TEST_F(MeshReaderTest, WarnsOfAFileThatIsNotThereOrBroken) {
  folder_.write("b.obj", "v 0 0 0\n");
  folder_.write("c.obj", kTriangles);
  const Loaded loaded = loadWith(
      collision("<uri>model://no/a.stl</uri>") +
      "<visual name='v'><geometry><mesh><uri>a.dae</uri></mesh></geometry></visual>\n"
      "<collision name='d'><geometry><mesh><uri>w.sdf</uri></mesh></geometry></collision>\n"
      "<collision name='e'><geometry><mesh><uri>c.obj</uri><submesh><name>aa</name></submesh></mesh></geometry>"
      "</collision>");
  EXPECT_EQ(
      loaded.messages,
      (Messages{
          "DIR/w.sdf:2:37: warning: mesh 'model://no/a.stl' is not found: collision 'c' of link 'l' of model 'm' will "
          "not collide | looked for it at DIR/models/no/a.stl, no/a.stl",
          "DIR/w.sdf:3:34: warning: mesh 'a.dae' is not found: visual 'v' of link 'l' of model 'm' will not be seen | "
          "looked for it at DIR/a.dae, DIR/models/a.dae, a.dae",
          "DIR/w.sdf:4:37: warning: mesh 'DIR/w.sdf' is not in a supported format: collision 'd' of link 'l' of model "
          "'m' will not collide | supported formats are .dae, .stl, .obj, .glb and .gltf",
          "DIR/w.sdf:5:37: warning: mesh 'DIR/c.obj' has no submesh 'aa': collision 'e' of link 'l' of model 'm' will "
          "not collide | did you mean 'a'?",
      }));
  EXPECT_EQ(meshOf(loaded).triangles, nullptr);
}

TEST_F(MeshReaderTest, ReadsHowItMoves) {
  using description::MeshOptimization;
  folder_.write("a.obj", kTriangles);
  const auto mesh = [](const std::string& attributes, const std::string& more) {
    return "<collision name='c" + std::to_string(attributes.size()) + "'><geometry><mesh" + attributes +
           "><uri>a.obj</uri>" + more + "</mesh></geometry></collision>\n";
  };
  const Loaded loaded = loadWith(mesh("", "") + mesh(" optimization='convex_hull'", "") +
                                 mesh(" optimization='convex_decomposition'",
                                      "<convex_decomposition><max_convex_hulls>7</max_convex_hulls>"
                                      "<voxel_resolution>5000</voxel_resolution></convex_decomposition>"));
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(meshOf(loaded, 0).optimization, MeshOptimization::kNone);
  EXPECT_EQ(meshOf(loaded, 1).optimization, MeshOptimization::kConvexHull);
  EXPECT_EQ(meshOf(loaded, 1).maxConvexHulls, 16U);
  EXPECT_EQ(meshOf(loaded, 1).voxelResolution, 200'000U);
  EXPECT_EQ(meshOf(loaded, 2).optimization, MeshOptimization::kConvexDecomposition);
  EXPECT_EQ(meshOf(loaded, 2).maxConvexHulls, 7U);
  EXPECT_EQ(meshOf(loaded, 2).voxelResolution, 5000U);
}

TEST_F(MeshReaderTest, SaysWhatIsWrongWithHowItMoves) {
  folder_.write("a.obj", kTriangles);
  const Loaded loaded = loadWith(
      "<collision name='c'><geometry><mesh optimization='convex_hul'><uri>a.obj</uri></mesh></geometry></collision>\n"
      "<collision name='d'><geometry><mesh optimization='exact'><uri>a.obj</uri>"
      "<convex_decomposition><max_convex_hulls>0</max_convex_hulls></convex_decomposition></mesh></geometry></"
      "collision>");
  ASSERT_EQ(loaded.messages.size(), 3U);
  EXPECT_EQ(loaded.messages[0],
            "DIR/w.sdf:2:37: error: attribute 'optimization' has the unknown value 'convex_hul' | did you mean "
            "'convex_hull'?");
  EXPECT_EQ(loaded.messages[1],
            "DIR/w.sdf:3:37: error: attribute 'optimization' has the unknown value 'exact' | it can be convex_hull, "
            "convex_decomposition");
  EXPECT_EQ(loaded.messages[2].substr(0, 41), "DIR/w.sdf:3:96: error: <max_convex_hulls>");
}

TEST_F(MeshReaderTest, RefusesWhatCanNotBeMeant) {
  const Loaded loaded = loadWith(collision("<scale>1 0 1</scale>"));
  EXPECT_EQ(loaded.messages,
            (Messages{
                "DIR/w.sdf:2:31: error: the mesh of collision 'c' of link 'l' of model 'm' has no <uri> | write "
                "<uri>model://NAME/FILE</uri>",
                "DIR/w.sdf:2:37: error: the mesh of collision 'c' of link 'l' of model 'm' has a scale of zero",
            }));
}

}  // namespace
}  // namespace pongsim::sdf::test
