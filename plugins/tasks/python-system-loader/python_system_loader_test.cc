#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/environment_variable.hh"
#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::python_system_loader_test {
namespace {

using test::RunningWorld;

std::string loaderOf(const std::string& parameters) {
  return "<plugin filename='gz-sim-python-system-loader-system' name='gz::sim::systems::PythonSystemLoader'>" +
         parameters + "</plugin>";
}

/// A box of 2 kg, with its centre of mass 1 m along x, and a hinge in a second model.
std::string boxWith(const std::string& plugin) {
  return "<gravity>0 0 0</gravity><model name='box'><pose>1 2 3 0 0 0</pose><link name='l'><inertial>"
         "<pose>1 0 0 0 0 0</pose><mass>2</mass></inertial></link>" +
         plugin +
         "</model><model name='rod'><link name='r'/><joint name='j' type='revolute'><parent>world</parent>"
         "<child>r</child><axis><xyz>0 0 1</xyz></axis></joint></model>";
}

class PythonSystemLoaderTest : public testing::Test {
 protected:
  /// @return What is complained about a world with this module.
  std::vector<std::string> complaintsAbout(const std::string& code) {
    folder_.write("module_of_test.py", code);
    return RunningWorld::complaintsAbout(boxWith(loaderOf("<module_name>module_of_test</module_name>")));
  }

  test::TempFolder folder_;
  test::EnvironmentVariable path_{"GZ_SIM_SYSTEM_PLUGIN_PATH", folder_.path().string()};
};

// written as Gazebo's own example is
constexpr const char* kPusher = R"(
from gz.math import Vector3d
from gz.sim import Link, Model


class Pusher(object):
    def configure(self, entity, sdf, ecm, event_mgr):
        self.model = Model(entity)
        self.link = Link(self.model.canonical_link(ecm))
        assert self.model.valid(ecm) and self.model.name(ecm) == "box" and self.link.name(ecm) == "l"
        assert sdf.get_name() == "plugin" and sdf.get_element("more").get_attribute("kind").get_as_string() == "a<b"
        self.force = sdf.get_double("force")

    def pre_update(self, info, ecm):
        if info.paused:
            return
        if info.iterations % 10 == 0:
            self.link.add_world_force(ecm, Vector3d(0, 0, self.force))


def get_system():
    return Pusher()
)";

TEST_F(PythonSystemLoaderTest, RunsAModuleThatIsWrittenForGazebo) {
  folder_.write("pusher.py", kPusher);
  RunningWorld world(boxWith(loaderOf("<module_name>pusher</module_name><force>100</force><more kind='a&lt;b'/>")));
  world.step(9);
  EXPECT_EQ(world.model("box").link("l")->linearVelocity().norm(), 0);
  world.step(1);
  // at the centre of mass, so it does not turn: 100 N * 1 ms / 2 kg
  EXPECT_NEAR(world.model("box").link("l")->linearVelocity().z(), 0.05, 1e-9);
  EXPECT_NEAR(world.model("box").link("l")->angularVelocity().norm(), 0, 1e-12);
  world.step(10);
  EXPECT_NEAR(world.model("box").link("l")->linearVelocity().z(), 0.1, 1e-9);
}

TEST_F(PythonSystemLoaderTest, AsksForTheWorldAndCommandsJoints) {
  folder_.write("asker.py", R"(
from gz.math import Pose3d, Quaterniond, Vector3d
from gz.sim8 import K_NULL_ENTITY, Joint, Link, Model, World, world_entity


class Asker:
    def configure(self, entity, sdf, ecm, event_mgr):
        world = World(world_entity(ecm))
        assert world.entity() == entity and world.name(ecm) == "w" and world.gravity(ecm) == Vector3d()
        assert world.model_by_name(ecm, "nobody") == K_NULL_ENTITY and world.model_count(ecm) == 2
        self.box = Model(world.model_by_name(ecm, "box"))
        assert not self.box.static(ecm) and self.box.links(ecm) == [self.box.link_by_name(ecm, "l")]
        rod = Model(world.model_by_name(ecm, "rod"))
        self.joint = Joint(rod.joint_by_name(ecm, "j"))
        assert self.joint.parent_link_name(ecm) == "world" and self.joint.child_link_name(ecm) == "r"
        assert sdf.get_pose("place").pos() == Vector3d(4, 5, 6) and sdf.get_int("no", 7) == (7, False)

    def pre_update(self, info, ecm):
        self.joint.set_velocity(ecm, [2.0])
        if info.iterations == 1:
            self.box.set_world_pose_cmd(ecm, Pose3d(4, 5, 6, 0, 0, 0.5))

    def post_update(self, info, ecm):
        pose = Link(self.box.canonical_link(ecm)).world_pose(ecm)
        assert pose.pos() == Vector3d(4, 5, 6) and abs(pose.yaw() - 0.5) < 1e-9, pose
        assert abs(self.joint.velocity(ecm)[0] - 2) < 1e-4 and len(self.joint.position(ecm)) == 1

    def reset(self, info, ecm):
        self.joint.set_velocity(ecm, [0.0])


def get_system():
    return Asker()
)");
  const std::string plugin = loaderOf("<module_name>asker</module_name><place>4 5 6 0 0 0</place>");
  Diagnostics diagnostics;
  SimulationOptions options;
  options.strict = true;
  const auto simulation =
      Simulation::fromText(RunningWorld::textOf(boxWith("") + plugin), "w.sdf", options, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  EXPECT_NO_THROW(simulation->step(5));
  EXPECT_NEAR(simulation->world().model("rod")->joint("j")->position(), 0.01, 1e-6);
}

TEST_F(PythonSystemLoaderTest, SaysWhatIsNotThere) {
  const std::string start = "python-system-loader of box is left out: module 'module_of_test': ";
  const auto complaint = [&](const std::string& code) {
    const std::vector<std::string> found = complaintsAbout(code);
    return found.size() == 1 && found[0].starts_with(start) ? found[0].substr(start.size()) : "other";
  };
  EXPECT_TRUE(complaint("from gz.transport import Node")
                  .starts_with("ImportError: gz.transport is not here: pongsim has Model, Link, Joint, World"));
  EXPECT_TRUE(complaint("from gz.sim import Sensor").find("gz.sim") != std::string::npos);
  EXPECT_TRUE(complaint("a = 1").starts_with("AttributeError: module 'module_of_test' has no attribute 'get_system'"));
  const std::string beyond = complaint(
      "from gz.sim import Model\nclass S:\n  def configure(self, e, s, ecm, m):\n    Model(e).source_file_path(ecm)\n"
      "def get_system():\n  return S()\n");
  EXPECT_TRUE(
      beyond.starts_with("AttributeError: pongsim has no gz.sim.Model.source_file_path for systems in Python ("))
      << beyond;
  EXPECT_TRUE(beyond.ends_with("module_of_test.py:4)")) << beyond;
}

// neither the present folder nor what is installed, and no path
TEST_F(PythonSystemLoaderTest, FindsModulesInTheFoldersOfSystemsOnly) {
  const auto complaints = [](const std::string& module) {
    return RunningWorld::complaintsAbout(boxWith(loaderOf("<module_name>" + module + "</module_name>")));
  };
  const std::string start = "python-system-loader of box is left out: ";
  const std::vector<std::string> ofJson = complaints("json");
  ASSERT_EQ(ofJson.size(), 1U);
  EXPECT_TRUE(ofJson[0].starts_with(start +
                                    "module 'json': ImportError: there is no module 'json' in the folders of systems "
                                    "and in PYTHONPATH: " +
                                    folder_.path().string() + ", "))
      << ofJson[0];
  folder_.write("here/inner.py", "raise RuntimeError('it ran')");
  for (const std::string& module : {std::string("here/inner"), (folder_.path() / "here/inner").string(),
                                    std::string("..inner"), std::string("inner.")}) {
    const std::vector<std::string> found = complaints(module);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0], start + "'" + module + "' is no name of a Python module");
  }
}

TEST_F(PythonSystemLoaderTest, IsNotRunInWhatComesFromOutside) {
  folder_.write("toucher.py", "import pathlib\npathlib.Path(__file__).with_name('ran').touch()\n");
  RunningWorld world(boxWith(""));
  Diagnostics diagnostics;
  InsertOptions options;
  options.isFromOutside = true;
  const auto inserted =
      world.simulation().insertText("<sdf version='1.9'><model name='m'><link name='l'/>" +
                                        loaderOf("<module_name>toucher</module_name>") + "</model></sdf>",
                                    "m.sdf", options, diagnostics);
  EXPECT_TRUE(inserted);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_NE(diagnostics.all()[0].message.find("what is inserted or downloaded may not name"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "ran"));
}

TEST_F(PythonSystemLoaderTest, IsSwitchedOffWhenItFails) {
  folder_.write("failing.py",
                "class S:\n  def update(self, info, ecm):\n    raise ValueError('three') \n"
                "def get_system():\n  return S()\n");
  RunningWorld world(boxWith(loaderOf("<module_name>failing</module_name>")));
  testing::internal::CaptureStderr();
  world.step(3);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("ValueError: three"), std::string::npos) << said;
  EXPECT_EQ(world.simulation().iterations(), 3U);
}

}  // namespace
}  // namespace pongsim::python_system_loader_test
