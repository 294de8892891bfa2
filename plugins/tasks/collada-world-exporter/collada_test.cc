#include "collada.hh"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace pongsim::collada_test {
namespace {

VisiblePart triangle() {
  VisiblePart part;
  part.name = "m::l::v";
  part.scale = {2, 3, 4};
  part.corners = {{{0, 0, 0}, {0, 0, 1}, {0, 0}}, {{1, 0, 0}, {0, 0, 1}, {1, 0}}, {{0, 1, 0.25}, {0, 0, 1}, {0, 1}}};
  part.triangles = {0, 1, 2};
  part.ambient = part.specular = part.emissive = {0, 0, 0};
  part.diffuse = {1, 0.5, 0};
  part.opacity = 0.25;
  return part;
}

std::string written(const std::vector<VisiblePart>& parts, const std::vector<VisibleLight>& lights = {},
                    const std::map<std::filesystem::path, std::string>& textures = {}) {
  std::ostringstream out;
  writeCollada(parts, lights, textures, out);
  return out.str();
}

void expectIn(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

TEST(Collada, HasSizesInTheVerticesAndPlacesInTheNodes) {
  VisiblePart part = triangle();
  part.X_WorldPart = {{7, 8, 9}, Quaternion(Eigen::AngleAxisd(std::acos(-1) / 2, Vector3::UnitZ()))};
  const std::string text = written({part});
  expectIn(text, "<float_array id=\"mesh_0-Positions-array\" count=\"9\">0 0 0 2 0 0 0 3 1</float_array>");
  expectIn(text, "<up_axis>Z_UP</up_axis>");
  expectIn(text, "<geometry id=\"mesh_0\" name=\"m::l::v\">");
  expectIn(text, "<p>0 1 2</p>");
  const std::size_t matrix = text.find("<matrix sid=\"matrix\">");
  ASSERT_NE(matrix, std::string::npos);
  std::istringstream numbers(text.substr(matrix + 21));
  const double expected[] = {0, -1, 0, 7, 1, 0, 0, 8, 0, 0, 1, 9, 0, 0, 0, 1};
  for (const double value : expected) {
    double read = 0;
    numbers >> read;
    EXPECT_NEAR(read, value, 1e-9);
  }
}

TEST(Collada, TurnsWhatIsMirrored) {
  VisiblePart part = triangle();
  part.scale.x() = -2;
  expectIn(written({part}), "<p>0 2 1</p>");
}

TEST(Collada, TellsMaterialsAndTextures) {
  expectIn(written({triangle()}), "<color>1 0.5 0 0.25</color>");
  expectIn(written({triangle()}), "<float>0.25</float>");
  VisiblePart part = triangle();
  part.texture = "/there/wood & stone.png";
  const std::string text = written({part}, {}, {{part.texture, "wood & stone.png"}});
  expectIn(text, "<init_from>../materials/textures/wood &amp; stone.png</init_from>");
  expectIn(text, "<texture texture=\"image_wood &amp; stone.png_sampler\" texcoord=\"UVSET0\"/>");
  // v counts from the bottom
  expectIn(text, "<float_array id=\"mesh_0-UVMap-array\" count=\"6\">0 1 1 1 0 0</float_array>");
}

TEST(Collada, TellsLights) {
  VisibleLight light;
  light.name = "lamp";
  light.type = VisibleLight::Type::kSpot;
  light.direction = {0, 0, -1};
  light.diffuse = {1, 0.5, 0.25};
  light.constantAttenuation = 0.5;
  light.outerAngle = std::acos(-1) / 3;
  light.falloff = 0.75;
  const std::string text = written({}, {light});
  for (const char* part : {"<light id=\"light_0\" name=\"lamp\">", "<color>1 0.5 0.25</color>",
                           "<constant_attenuation>0.5</constant_attenuation>", "<falloff_angle>60</falloff_angle>",
                           "<falloff_exponent>0.75</falloff_exponent>", "<instance_light url=\"#light_0\"/>"}) {
    expectIn(text, part);
  }
  expectIn(text, "<matrix sid=\"matrix\">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>");
  light.type = VisibleLight::Type::kDirectional;
  EXPECT_EQ(written({}, {light}).find("attenuation"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::collada_test
