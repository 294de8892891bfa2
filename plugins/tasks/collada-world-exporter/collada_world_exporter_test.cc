#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "pongsim/appearance.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"
#include "support/working_folder.hh"

namespace pongsim::collada_world_exporter_test {
namespace {

namespace fs = std::filesystem;
using test::RunningWorld;
using test::WorkingFolder;

constexpr const char* kExporter =
    "<plugin filename='ignition-gazebo-collada-world-exporter-system' "
    "name='ignition::gazebo::systems::ColladaWorldExporter'/>";

std::vector<VisiblePart> partsOf(RunningWorld& world) {
  Diagnostics diagnostics;
  const Appearance appearance(world.simulation().world(), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  std::vector<VisiblePart> parts;
  for (std::size_t i = 0; i < appearance.partCount(); ++i) parts.push_back(appearance.part(i));
  return parts;
}

/// @return What a COLLADA file shows, as it is read by way of Assimp.
std::vector<VisiblePart> partsOf(const fs::path& file) {
  RunningWorld world("<model name='m'><static>true</static><link name='l'><visual name='v'><geometry><mesh><uri>" +
                     file.string() + "</uri></mesh></geometry></visual></link></model>");
  return partsOf(world);
}

std::vector<Vector3> cornersInWorld(const VisiblePart& part) {
  std::vector<Vector3> corners;
  for (const VisiblePart::Corner& corner : part.corners) {
    corners.push_back(part.X_WorldPart * part.scale.cwiseProduct(corner.position.cast<double>()));
  }
  return corners;
}

/// @return Whether each point of `some` is one of `all`, but for a few tenths of a millimetre.
bool areAmong(const std::vector<Vector3>& some, const std::vector<Vector3>& all) {
  constexpr double kCell = 1e-4;
  using Cell = std::array<long, 3>;
  const auto cellOf = [](const Vector3& point) {
    return Cell{std::lround(point.x() / kCell), std::lround(point.y() / kCell), std::lround(point.z() / kCell)};
  };
  std::set<Cell> cells;
  for (const Vector3& point : all) cells.insert(cellOf(point));
  return std::ranges::all_of(some, [&](const Vector3& point) {
    const Cell middle = cellOf(point);
    for (int i = 0; i < 27; ++i) {
      if (cells.contains({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1})) return true;
    }
    return false;
  });
}

/// @return Volume that the triangles enclose, with their sense [m^3].
double volumeOf(const VisiblePart& part) {
  const std::vector<Vector3> corners = cornersInWorld(part);
  double volume = 0;
  for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
    const Vector3 &a = corners[part.triangles[i]], &b = corners[part.triangles[i + 1]],
                  &c = corners[part.triangles[i + 2]];
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

void expectSame(const std::vector<VisiblePart>& read, const std::vector<VisiblePart>& shown) {
  ASSERT_EQ(read.size(), shown.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::vector<Vector3> one = cornersInWorld(read[i]), other = cornersInWorld(shown[i]);
    EXPECT_EQ(read[i].triangles.size(), shown[i].triangles.size()) << shown[i].name;
    EXPECT_TRUE(areAmong(one, other)) << shown[i].name;
    EXPECT_TRUE(areAmong(other, one)) << shown[i].name;
    EXPECT_NEAR(volumeOf(read[i]), volumeOf(shown[i]), 1e-4) << shown[i].name;
    EXPECT_LT((read[i].diffuse - shown[i].diffuse).norm(), 1e-5F) << shown[i].name;
    const Vector3 normal = read[i].X_WorldPart.rotation * read[i].corners[0].normal.cast<double>();
    EXPECT_NEAR(normal.norm(), 1, 1e-5);
  }
}

TEST(ColladaWorldExporter, WritesWhatIsReadBackWithTheSameVertices) {
  const WorkingFolder folder;
  RunningWorld world(test::projectFolder() / "plugins/tasks/collada-world-exporter/collada_world_exporter.sdf");
  EXPECT_FALSE(fs::exists("collada_world_exporter"));
  world.step(1);
  const fs::path file = folder.path() / "collada_world_exporter/meshes/collada_world_exporter.dae";
  ASSERT_TRUE(fs::exists(file));
  const std::vector<VisiblePart> shown = partsOf(world);
  ASSERT_EQ(shown.size(), 4U);
  EXPECT_EQ(shown[0].name, "shapes::link::box");
  EXPECT_NEAR(volumeOf(shown[0]), 0.75, 1e-6);
  expectSame(partsOf(file), shown);
  std::ifstream stream(file);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  for (const char* light :
       {"<light id=\"light_0\" name=\"", "<light id=\"light_1\" name=\"", "<spot>", "<directional>"}) {
    EXPECT_NE(text.find(light), std::string::npos) << light;
  }
}

TEST(ColladaWorldExporter, WritesOnce) {
  const WorkingFolder folder;
  RunningWorld world(std::string{kExporter});
  world.step(1);
  EXPECT_TRUE(fs::exists("w/meshes/w.dae"));
  fs::remove_all("w");
  world.step(10);
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  world.step(10);
  EXPECT_FALSE(fs::exists("w"));
}

TEST(ColladaWorldExporter, SaysWhereItCantWriteAndTheRestRuns) {
  const WorkingFolder folder;
  std::ofstream("w") << "in the way";
  RunningWorld world(std::string(kExporter) +
                     "<model name='m'><link name='l'><inertial><mass>1</mass></inertial></link></model>");
  testing::internal::CaptureStderr();
  world.step(100);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("collada-world-exporter: failed in postUpdate: the world can't be exported: "), std::string::npos)
      << said;
  EXPECT_LT(world.model("m").pose().position.z(), -0.01);
  EXPECT_NE(world.simulation().finish().error.find("the world can't be exported: "), std::string::npos);
}

TEST(ColladaWorldExporter, RefusesANameThatLeadsElsewhere) {
  Diagnostics diagnostics;
  Simulation::fromText(std::string("<sdf version='1.9'><world name='../up'>") + kExporter + "</world></sdf>", "w.sdf",
                       {}, diagnostics);
  std::vector<std::string> said;
  for (const Diagnostic& each : diagnostics.all()) said.push_back(each.message);
  EXPECT_EQ(std::ranges::count(
                said, "collada-world-exporter is left out: the world's name '../up' can't be used for a folder"),
            1)
      << testing::PrintToString(said);
}

/// As Fortress's own test of the system tells it: the file's two parts, and one of them once more.
TEST(ColladaWorldExporter, OfFortressTestWorldWritesSubmeshes) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  const WorkingFolder folder;
  setenv("IGN_GAZEBO_RESOURCE_PATH", (*worlds / "test/models").c_str(), 1);
  RunningWorld world(*worlds / "test/collada_world_exporter_submesh.sdf");
  unsetenv("IGN_GAZEBO_RESOURCE_PATH");
  world.step(1);
  const std::vector<VisiblePart> shown = partsOf(world);
  ASSERT_EQ(shown.size(), 3U);
  const std::string name = "collada_world_exporter_submesh_test";
  EXPECT_EQ(shown[2].texture.filename(), "cordless_drill.png");
  EXPECT_TRUE(fs::exists(folder.path() / name / "materials/textures/cordless_drill.png"));
  expectSame(partsOf(folder.path() / name / "meshes" / (name + ".dae")), shown);
}

/// As Fortress's own test of the system tells it.
TEST(ColladaWorldExporter, OfFortressModelWritesTextures) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  const WorkingFolder folder;
  setenv("IGN_GAZEBO_RESOURCE_PATH", (*worlds / "test/models").c_str(), 1);
  RunningWorld world(std::string(kExporter) + "<include><uri>model://building_L1</uri></include>");
  unsetenv("IGN_GAZEBO_RESOURCE_PATH");
  world.step(1);
  for (const char* texture : {"default.png", "blue_linoleum.png"}) {
    EXPECT_TRUE(fs::exists(fs::path("w/materials/textures") / texture)) << texture;
  }
  expectSame(partsOf(folder.path() / "w/meshes/w.dae"), partsOf(world));
  for (const VisiblePart& part : partsOf(folder.path() / "w/meshes/w.dae")) EXPECT_FALSE(part.texture.empty());
}

TEST(ColladaWorldExporter, OfFortressTestWorldWritesShapes) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  const WorkingFolder folder;
  RunningWorld world(*worlds / "test/collada_world_exporter.sdf");
  world.step(1);
  const std::string name = "collada_world_exporter_box_test";
  expectSame(partsOf(folder.path() / name / "meshes" / (name + ".dae")), partsOf(world));
}

}  // namespace
}  // namespace pongsim::collada_world_exporter_test
