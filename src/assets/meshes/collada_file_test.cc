#include "assets/meshes/collada_file.hh"

#include <gtest/gtest.h>

#include <stdexcept>

#include "assets/meshes/mesh_file.hh"
#include "support/assets/mesh_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

class ColladaFileTest : public ::testing::Test {
 protected:
  /// @return The example with one part replaced.
  static std::string with(std::string_view old, std::string_view now) {
    std::string text(test::kCollada);
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), now);
  }
  std::filesystem::path write(std::string_view text) { return folder_.write("a.dae", text); }
  std::string faultOf(std::string_view text) {
    const auto found = readMeshFile(write(text));
    const auto* problem = std::get_if<Problem>(&found);
    if (problem == nullptr) return "(none)";
    EXPECT_EQ(problem->text, "can't be read as a mesh");
    return problem->hint;
  }
  std::vector<MeshPart> read(std::string_view text) {
    auto found = readMeshFile(write(text));
    if (const auto* problem = std::get_if<Problem>(&found)) ADD_FAILURE() << problem->text << " " << problem->hint;
    return found.index() == 0 ? std::get<0>(found) : std::vector<MeshPart>();
  }
  test::TempFolder folder_;
};

TEST_F(ColladaFileTest, RefusesTextAmongIndices) {
  EXPECT_EQ(faultOf(with("<p>0 1 2</p>", "<p>0 1\xFF 2</p>")),
            "line 10: <p> contains '1\xFF', which is not a whole number");
  EXPECT_EQ(faultOf(with("<p>0 1 2</p>", "<p>0 x 2</p>")), "line 10: <p> contains 'x', which is not a whole number");
  EXPECT_EQ(faultOf(with("<p>0 1 2</p>", "<p>0 1.0 2</p>")),
            "line 10: <p> contains '1.0', which is not a whole number");
  EXPECT_EQ(faultOf(with("<p>0 1 2</p>", "<p>&#32;<!-- -->0 - 2</p>")),
            "line 10: <p> contains '-', which is not a whole number");
  EXPECT_EQ(faultOf(with("<p>0 1 2</p>", "<p>0 1\f 2</p>")),
            "line 10: <p> contains '1\f', which is not a whole number");
}

TEST_F(ColladaFileTest, RefusesCountsOfWhatIsNotThere) {
  EXPECT_EQ(faultOf(with("count=\"9\"", "count=\"2000000000\"")),
            "line 6: <float_array> has fewer values than its count");
  EXPECT_EQ(faultOf(with("count=\"9\"", "count=\"-1\"")),
            "line 6: <float_array> has count=\"-1\", which is not a whole number");
  EXPECT_EQ(faultOf(with("triangles count=\"1\"", "triangles count=\"90000000\"")),
            "line 10: <p> has fewer indices than its <triangles> says");
  EXPECT_EQ(faultOf(with("offset=\"0\"", "offset=\"300000000\"")), "line 10: <input> has an offset of more than 63");
  const std::string polygons = with("<triangles count=\"1\">", "<polylist count=\"1\">");
  const auto replaced = [&](std::string_view sizes) {
    std::string text = polygons;
    text.replace(text.find("<p>0 1 2</p></triangles>"), 24, std::string(sizes) + "<p>0 1 2</p></polylist>");
    return text;
  };
  EXPECT_EQ(read(replaced("<vcount>3</vcount>")).size(), 2U);
  EXPECT_EQ(faultOf(replaced("")), "line 10: <p> has fewer indices than its <polylist> says");
  EXPECT_EQ(faultOf(replaced("<vcount>4</vcount>")), "line 10: <p> has fewer indices than its <polylist> says");
  EXPECT_EQ(faultOf(replaced("<vcount>-3</vcount>")), "line 10: <vcount> contains a negative number");
}

TEST_F(ColladaFileTest, RefusesAnotherNumberOfListsThanTheCount) {
  EXPECT_EQ(faultOf(with("<p>0 1 2</p>", "<p>0 1 2</p><p>0 1 2</p>")),
            "line 10: <triangles> has the wrong number of <p>");
  EXPECT_EQ(faultOf(with("<p>0 1 2</p>", "")), "line 10: <triangles> has the wrong number of <p>");
  std::string polygons = with("<triangles count=\"1\">", "<polygons count=\"2\">");
  polygons.replace(polygons.find("</triangles>"), 12, "</polygons>");
  EXPECT_EQ(faultOf(polygons), "line 10: <polygons> has the wrong number of <p>");
  EXPECT_EQ(faultOf(with("url=\"#shape\"", "url=\"#\"")), "line 13: <instance_geometry> refers to no geometry");
}

TEST_F(ColladaFileTest, RefusesAccessorsPastTheEndOfTheirArray) {
  const std::string fault = "line 7: <accessor> goes past the end of the array 'pa'";
  EXPECT_EQ(faultOf(with("count=\"3\" stride=\"3\"", "count=\"4\" stride=\"3\"")), fault);
  EXPECT_EQ(faultOf(with("count=\"3\" stride=\"3\"", "count=\"3\" stride=\"2000000000\"")), fault);
  EXPECT_EQ(faultOf(with("count=\"3\" stride=\"3\"", "count=\"3\" offset=\"1\" stride=\"3\"")), fault);
  std::string names = with("<float_array id=\"pa\"", "<Name_array id=\"pa\"");
  names.replace(names.find("</float_array>"), 14, "</Name_array>");
  EXPECT_EQ(faultOf(names), fault);
}

TEST_F(ColladaFileTest, RefusesTrianglesWithoutVertices) {
  EXPECT_EQ(faultOf(with("semantic=\"VERTEX\" source=\"#v\"", "semantic=\"NORMAL\" source=\"#p\"")),
            "line 10: <p> needs an <input> of VERTEX before it");
  EXPECT_EQ(faultOf(with("semantic=\"POSITION\"", "semantic=\"NORMAL\"")),
            "line 10: <triangles> needs <vertices> with one input of POSITION before it");
}

TEST_F(ColladaFileTest, RefusesNodesThatContainThemselves) {
  const std::string_view instance = "<instance_geometry url=\"#shape\"/></node>\n<node id=\"r\"";
  EXPECT_EQ(faultOf(with(instance, "<instance_node url=\"#s\"/></node>\n<node id=\"r\"")),
            "line 12: <visual_scene> contains itself");
  EXPECT_EQ(faultOf(with(instance, "<instance_node url=\"#left\"/></node>\n<node id=\"r\"")),
            "line 13: <node> contains itself");
  // many files have a node with the same name as the node that it refers to
  std::string library = "<library_nodes><node id=\"left\"><instance_geometry url=\"#shape\"/></node></library_nodes>";
  std::string text = with(instance, "<instance_node url=\"#left\"/></node>\n<node id=\"r\"");
  text.insert(text.find("<library_visual_scenes>"), library);
  EXPECT_EQ(read(text).size(), 2U);
}

TEST_F(ColladaFileTest, RefusesMoreNodesThanTheLimit) {
  std::string library = "<library_nodes>";
  for (int i = 0; i < 30; ++i) {
    const std::string next = "<instance_node url=\"#n" + std::to_string(i + 1) + "\"/>";
    library += "<node id=\"n" + std::to_string(i) + "\">" + next + next + "</node>";
  }
  library += "<node id=\"n30\"><instance_geometry url=\"#shape\"/></node></library_nodes>";
  std::string text = with("<instance_geometry url=\"#shape\"/></node>\n<node id=\"r\"",
                          "<instance_node url=\"#n0\"/></node>\n<node id=\"r\"");
  text.insert(text.find("<library_visual_scenes>"), library);
  EXPECT_NE(faultOf(text).find("makes more than 100000 nodes, which is the limit"), std::string::npos) << faultOf(text);
}

TEST_F(ColladaFileTest, RefusesParametersOfAnEffectInACircle) {
  const std::string effects =
      "<library_effects><effect id=\"e\"><profile_COMMON>"
      "<newparam sid=\"a\"><surface><init_from>b</init_from></surface></newparam>"
      "<newparam sid=\"b\"><sampler2D><source>a</source></sampler2D></newparam>"
      "</profile_COMMON></effect></library_effects><library_geometries>";
  EXPECT_EQ(faultOf(with("<library_geometries>", effects)),
            "line 5: <effect> has the parameter 'a', which refers back to itself");
}

TEST_F(ColladaFileTest, ReadsTheMeshOfASkinAndLeavesWhatIsNotUsed) {
  const std::string controllers =
      "<library_animations><animation/></library_animations>"
      "<library_controllers><controller id=\"k\"><skin source=\"#shape\"><vertex_weights count=\"2000000000\"/></skin>"
      "</controller></library_controllers>"
      "<library_images><image id=\"i\"><init_from><hex format=\"png\">00</hex></init_from></image>"
      "<image id=\"j\"><init_from>file://</init_from></image></library_images>"
      "<library_visual_scenes>";
  std::string text = with("<library_visual_scenes>", controllers);
  const std::string_view instance = "<instance_geometry url=\"#shape\"/>";
  text.replace(text.find(instance), instance.size(),
               "<instance_controller url=\"#k\"><skeleton/></instance_controller>");
  text.insert(text.find("<triangles"), "<lines count=\"2000000000\"><p>x</p></lines>");
  const auto parts = read(text);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].nodeName, "left");
  EXPECT_EQ(parts[0].mesh.triangles.size(), 1U);
  const std::string used = readCollada(text);
  for (const char* name : {"animation", "controller", "hex", "lines"}) EXPECT_EQ(used.find(name), std::string::npos);
}

TEST_F(ColladaFileTest, SaysWhereTheXmlIsNotWellFormed) {
  EXPECT_EQ(faultOf("<COLLADA>\n<p></COLLADA>"), "line 2: the XML is not well-formed");
  EXPECT_EQ(faultOf("<sdf/>"), "there is no <COLLADA>");
  EXPECT_THROW(readCollada("no XML"), std::runtime_error);
}

}  // namespace
}  // namespace pongsim::assets
