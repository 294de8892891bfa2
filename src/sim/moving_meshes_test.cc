// Moving meshes from files, in whole worlds.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "pongsim/simulation.hh"
#include "support/environment_variable.hh"
#include "support/solids.hh"
#include "support/temp_folder.hh"

namespace pongsim {
namespace {

namespace fs = std::filesystem;

std::string collision(const std::string& name, const std::string& geometry) {
  return "<collision name='" + name + "'><geometry>" + geometry + "</geometry></collision>";
}

std::string meshOf(const std::string& file, const std::string& attributes = "", const std::string& more = "") {
  return "<mesh" + attributes + "><uri>" + file + "</uri>" + more + "</mesh>";
}

/// @param com z coordinate of the centre of mass.
std::string model(const std::string& name, const std::string& pose, const std::string& geometry, double mass,
                  double inertia, double com = 0) {
  const std::string moment = std::to_string(inertia);
  return "<model name='" + name + "'><pose>" + pose + "</pose><link name='link'><inertial><pose>0 0 " +
         std::to_string(com) + " 0 0 0</pose><mass>" + std::to_string(mass) + "</mass><inertia><ixx>" + moment +
         "</ixx><iyy>" + moment + "</iyy><izz>" + moment + "</izz></inertia></inertial>" + collision("skin", geometry) +
         "</link></model>";
}

constexpr std::string_view kGround =
    "<model name='ground'><static>true</static><link name='link'><collision name='c'><geometry><plane/></geometry>"
    "</collision></link></model>";

class MovingMeshesTest : public ::testing::Test {
 protected:
  MovingMeshesTest() {
    keepPiecesIn(folder_.path() / "cache");
    folder_.write("bowl.obj", test::asObj(test::bowl(0.2, 0.02, 40, 12)));
    folder_.write("wheel.obj", test::asObj(test::spokedWheel(0.2, 0.05, 360, 5)));
  }

  void keepPiecesIn(const fs::path& folder) { cache_.set(folder.string()); }

  std::unique_ptr<Simulation> load(const std::string& content, int threads = 1) {
    const fs::path file = folder_.write("w.sdf", "<sdf version='1.9'><world name='w'>" + content + "</world></sdf>");
    Diagnostics diagnostics;
    SimulationOptions options;
    options.loadSystems = false;
    options.threads = threads;
    auto simulation = Simulation::fromFile(file, options, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    return simulation;
  }

  static Vector3 place(Simulation& simulation, std::string_view name) {
    return simulation.world().model(name)->link("link")->pose().position;
  }

  std::vector<fs::path> kept() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "cache")) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
    return files;
  }

  static std::string bowlAndBall(const std::string& attributes = "") {
    return std::string(kGround) + model("bowl", "0 0 0.2 0 0 0", meshOf("bowl.obj", attributes), 2, 0.04, -0.15) +
           model("ball", "0.05 0 0.3 0 0 0", "<sphere><radius>0.05</radius></sphere>", 0.2, 0.0002);
  }

  const test::TempFolder folder_;
  test::EnvironmentVariable cache_{"XDG_CACHE_HOME"};
};

TEST_F(MovingMeshesTest, ABowlHoldsABallForTenSeconds) {
  const auto simulation = load(bowlAndBall());
  simulation->step(10000);
  const Vector3 way = place(*simulation, "ball") - place(*simulation, "bowl");
  EXPECT_NEAR(way.norm(), 0.18 - 0.05, 0.008);
  EXPECT_LT(way.head<2>().norm(), 0.04);
  // contacts refer to the collision by its name in the file
  std::vector<Contact> contacts;
  simulation->world().contacts(contacts);
  std::set<std::string> names;
  for (const Contact& contact : contacts) {
    names.insert(simulation->world().collision(contact.collision1)->scopedName());
    names.insert(simulation->world().collision(contact.collision2)->scopedName());
  }
  EXPECT_TRUE(names.contains("bowl::link::skin"));
  EXPECT_LE(names.size(), 3U);
  // mass and inertia are those of the file, not computed from the mesh
  EXPECT_EQ(simulation->world().model("bowl")->link("link")->mass().mass, 2);
}

TEST_F(MovingMeshesTest, AsItsHullABowlBearsTheBallOnItsRim) {
  const auto simulation = load(bowlAndBall(" optimization='convex_hull'"));
  simulation->step(400);
  EXPECT_GT(place(*simulation, "ball").z(), 0.24);
}

TEST_F(MovingMeshesTest, AStaticMeshMayBeOptimizedToo) {
  for (const auto& [attributes, height] : {std::pair("", 0.07), std::pair(" optimization='convex_hull'", 0.25),
                                           std::pair(" optimization='convex_decomposition'", 0.07)}) {
    const std::string bowl = "<model name='bowl'><static>true</static><pose>0 0 0.2 0 0 0</pose><link name='link'>" +
                             collision("skin", meshOf("bowl.obj", attributes)) + "</link></model>";
    const auto simulation =
        load(bowl + model("ball", "0 0 0.26 0 0 0", "<sphere><radius>0.05</radius></sphere>", 0.2, 0.0002));
    simulation->step(2000);
    EXPECT_NEAR(place(*simulation, "ball").z(), height, 0.02) << attributes;
  }
}

TEST_F(MovingMeshesTest, GiveTheSameBitsColdWarmBrokenReadOnlyAndOnThreads) {
  std::set<std::uint64_t> hashes;
  const auto run = [&](int threads = 1) {
    const auto simulation =
        load(bowlAndBall() + model("other", "0.9 0 0.5 0.3 0 0", meshOf("bowl.obj"), 2, 0.04, -0.15), threads);
    simulation->step(700);
    hashes.insert(simulation->stateHash());
  };
  run();
  ASSERT_EQ(kept().size(), 1U);
  run();
  run(3);
  fs::resize_file(kept()[0], 100);
  run();
  EXPECT_GT(fs::file_size(kept()[0]), 1000U);
  std::ofstream(kept()[0], std::ios::trunc) << "not what it was";
  run(2);
  keepPiecesIn("/proc/nowhere");
  run();
  // the default folder, below ~/.cache
  keepPiecesIn("");
  {
    const test::EnvironmentVariable home("HOME", folder_.path().string());
    run();
  }
  EXPECT_TRUE(fs::exists(folder_.path() / ".cache/pongsim/meshes"));
  EXPECT_EQ(hashes.size(), 1U);
}

TEST_F(MovingMeshesTest, GoOnWithTheSameBitsFromASavedState) {
  const auto simulation = load(bowlAndBall());
  simulation->step(600);
  const std::vector<std::byte> state = simulation->saveState();
  simulation->step(600);
  const std::uint64_t hash = simulation->stateHash();
  EXPECT_TRUE(simulation->restoreState(state));
  simulation->step(600);
  EXPECT_EQ(simulation->stateHash(), hash);
  const auto other = load(bowlAndBall());
  EXPECT_TRUE(other->restoreState(state));
  other->step(600);
  EXPECT_EQ(other->stateHash(), hash);
}

TEST_F(MovingMeshesTest, ASpokedWheelRollsItsWay) {
  const auto simulation = load("<gravity>0.49 0 -9.8</gravity>" + std::string(kGround) +
                               model("wheel", "-4 0 0.2 0 0 0", meshOf("wheel.obj"), 1, 0.03));
  simulation->step(3000);
  const double acceleration = 0.49 / (1 + 0.03 / (0.2 * 0.2));
  EXPECT_NEAR(place(*simulation, "wheel").x() + 4, acceleration * 9 / 2, 0.02 * acceleration * 9 / 2);
}

TEST_F(MovingMeshesTest, AGripperLiftsAPeg) {
  const sdf::Outline hook{
      {{0, -0.05}, {0.06, -0.05}, {0.06, -0.03}, {0.02, -0.03}, {0.02, 0.03}, {0.06, 0.03}, {0.06, 0.05}, {0, 0.05}}};
  folder_.write("finger.obj", test::asObj(*sdf::extrude(hook, 0.06)));
  const auto link = [](const std::string& name, const std::string& pose, const std::string& content) {
    return "<link name='" + name + "'><pose>" + pose +
           "</pose><inertial><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia>"
           "</inertial>" +
           content + "</link>";
  };
  const auto joint = [](const std::string& name, const std::string& parent, const std::string& child,
                        const std::string& axis, int effort) {
    return "<joint name='" + name + "' type='prismatic'><parent>" + parent + "</parent><child>" + child +
           "</child><axis><xyz>" + axis + "</xyz><limit><effort>" + std::to_string(effort) +
           "</effort></limit></axis></joint>";
  };
  // the other finger has the same mesh, mirrored
  const std::string gripper =
      "<model name='gripper'><pose>0 0 0.05 0 0 0</pose>" + link("palm", "0 0 0.25 0 0 0", "") +
      link("one", "-0.1 0 0 0 0 0", collision("c", meshOf("finger.obj"))) +
      link("other", "0.1 0 0 0 0 0", collision("c", meshOf("finger.obj", "", "<scale>-1 1 1</scale>"))) +
      joint("lift", "world", "palm", "0 0 1", 200) + joint("a", "palm", "one", "1 0 0", 10) +
      joint("b", "palm", "other", "-1 0 0", 10) + "</model>";
  const auto simulation = load(std::string(kGround) + gripper +
                               model("peg", "0.01 0.005 0.06 0 0 0",
                                     "<cylinder><radius>0.02</radius><length>0.12</length></cylinder>", 0.1, 1e-4));
  Model hand = *simulation->world().model("gripper");
  hand.joint("lift")->setVelocityTarget(0);
  hand.joint("a")->setVelocityTarget(0.05);
  hand.joint("b")->setVelocityTarget(0.05);
  simulation->step(2500);
  const Vector3 held = place(*simulation, "peg");
  EXPECT_LT(std::abs(held.x()), 0.03);
  hand.joint("lift")->setVelocityTarget(0.1);
  simulation->step(1500);
  EXPECT_NEAR(place(*simulation, "peg").z() - held.z(), 0.15, 0.01);
}

}  // namespace
}  // namespace pongsim
