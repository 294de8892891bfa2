#include "ros2/robot/urdf_writer.hh"

#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "ros2/robot/robot_list.hh"
#include "ros2/robot/xml_writer.hh"
#include "support/ros2/robot_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

using test::expectNear;
using test::inWorld;
using test::worldOf;
using test::worldOfFile;
using Words = std::vector<std::string>;

Pose poseOf(const ::urdf::Pose& pose) {
  return {{pose.position.x, pose.position.y, pose.position.z},
          {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z}};
}

/// Pose of a frame in that of the root, with all joints at zero, computed from the URDF.
Pose poseInRoot(const ::urdf::ModelInterface& robot, const std::string& link) {
  Pose X_LinkBelow;
  for (auto at = robot.getLink(link); at->parent_joint != nullptr; at = at->getParent()) {
    X_LinkBelow = poseOf(at->parent_joint->parent_to_joint_origin_transform) * X_LinkBelow;
  }
  return X_LinkBelow;
}

/// Parses the text with urdfdom and compares it with the model.
void expectSame(const Simulation& simulation, const Model& model, const KinematicTree& tree, const UrdfText& urdf,
                const std::string& where) {
  const auto robot = ::urdf::parseURDF(urdf.text);
  ASSERT_NE(robot, nullptr) << where << "\n" << urdf.text;
  EXPECT_EQ(robot->links_.size(), tree.links.size()) << where;
  const Pose X_WorldRoot = tree.rootPose(model);
  for (const TreeLink& link : tree.links) {
    const auto found = robot->getLink(link.frame);
    ASSERT_NE(found, nullptr) << where << " " << link.frame;
    if (!link.link) continue;
    expectNear(X_WorldRoot * poseInRoot(*robot, link.frame), link.link->pose(), 1e-9, where + " " + link.frame);
    ASSERT_NE(found->inertial, nullptr) << where << " " << link.frame;
    const MassInfo mass = link.link->mass();
    EXPECT_EQ(found->inertial->mass, mass.mass) << where << " " << link.frame;
    EXPECT_EQ(found->inertial->ixx, mass.inertia(0, 0));
    EXPECT_EQ(found->inertial->iyz, mass.inertia(1, 2));
    EXPECT_EQ(found->inertial->izz, mass.inertia(2, 2));
    const auto& center = found->inertial->origin.position;
    EXPECT_EQ(Vector3(center.x, center.y, center.z), mass.center) << where << " " << link.frame;
  }
  EXPECT_EQ(simulation.iterations(), 0U);
}

struct Written {
  std::unique_ptr<Simulation> simulation;
  UrdfText urdf;
  ::urdf::ModelInterfaceSharedPtr robot;

  explicit Written(const std::string& parts) : simulation(worldOf(inWorld("<model name='m'>" + parts + "</model>"))) {
    const Model model = simulation->world().model("m").value();
    const KinematicTree tree = treeOfModel(model, {}, std::string(model.name()) + "/", "world");
    urdf = writeUrdf(simulation->world(), model, tree);
    robot = ::urdf::parseURDF(urdf.text);
    EXPECT_NE(robot, nullptr) << urdf.text;
    expectSame(*simulation, model, tree, urdf, "m");
  }
};

TEST(UrdfWriter, WritesJointsWithLimitsAndDynamics) {
  const Written written(
      "<link name='a'/><link name='b'><pose>0 1 0 0 0 1</pose></link><link name='c'/>"
      "<joint name='ab' type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 0 "
      "1</xyz><limit><lower>-1</lower>"
      "<upper>2</upper><effort>3</effort><velocity>4</velocity></limit><dynamics><damping>0.5</damping>"
      "<friction>0.25</friction></dynamics></axis></joint>"
      "<joint name='bc' type='continuous'><parent>b</parent><child>c</child><axis><xyz>0 1 0</xyz></axis></joint>");
  EXPECT_EQ(written.urdf.warnings, Words());
  const auto hinge = written.robot->getJoint("ab");
  ASSERT_NE(hinge, nullptr);
  EXPECT_EQ(hinge->type, ::urdf::Joint::REVOLUTE);
  EXPECT_EQ(hinge->parent_link_name, "m/a");
  EXPECT_EQ(hinge->limits->lower, -1);
  EXPECT_EQ(hinge->limits->upper, 2);
  EXPECT_EQ(hinge->limits->effort, 3);
  EXPECT_EQ(hinge->limits->velocity, 4);
  EXPECT_EQ(hinge->dynamics->damping, 0.5);
  EXPECT_EQ(hinge->dynamics->friction, 0.25);
  EXPECT_EQ(written.robot->getJoint("bc")->type, ::urdf::Joint::CONTINUOUS);
}

TEST(UrdfWriter, WritesShapesWithTheirMaterials) {
  const Written written(
      "<link name='a'><visual name='v'><pose>1 0 0 0 0 "
      "0</pose><geometry><capsule><radius>0.1</radius><length>2</length>"
      "</capsule></geometry><material><diffuse>1 0.5 0.25 0.5</diffuse></material></visual>"
      "<collision name='box'><pose>0 0 1 0 0 0</pose><geometry><box><size>1 2 3</size></box></geometry></collision>"
      "<collision name='egg'><geometry><ellipsoid><radii>1 2 3</radii></ellipsoid></geometry></collision>"
      "<collision name='ground'><geometry><plane/></geometry></collision></link>");
  const auto link = written.robot->getLink("m/a");
  ASSERT_EQ(link->visual_array.size(), 3U);
  EXPECT_EQ(link->visual_array[0]->geometry->type, ::urdf::Geometry::CYLINDER);
  EXPECT_EQ(link->visual_array[1]->origin.position.z, 1);
  EXPECT_EQ(link->visual_array[1]->origin.position.x, 1);
  EXPECT_EQ(link->visual_array[2]->origin.position.z, -1);
  EXPECT_EQ(link->visual_array[0]->material->color.g, 0.5F);
  EXPECT_EQ(link->visual_array[0]->material->color.a, 0.5F);
  ASSERT_EQ(link->collision_array.size(), 2U);
  EXPECT_EQ(link->collision_array[0]->origin.position.z, 1);
  EXPECT_EQ(dynamic_cast<const ::urdf::Box&>(*link->collision_array[0]->geometry).dim.z, 3);
  EXPECT_EQ(dynamic_cast<const ::urdf::Sphere&>(*link->collision_array[1]->geometry).radius, 3);
  EXPECT_EQ(written.urdf.warnings,
            (Words{"collision 'egg' of 'm/a' is an ellipsoid, which URDF does not have: a sphere around it is used",
                   "collision 'ground' of 'm/a' is an infinite plane, which URDF does not have: it is left out"}));
}

TEST(UrdfWriter, NamesTheFilesOfMeshes) {
  const pongsim::test::TempFolder folder;
  folder.write("a mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const std::string mesh = "<geometry><mesh><uri>a mesh.obj</uri><scale>1 2 3</scale></mesh></geometry>";
  folder.write("w.sdf", inWorld("<model name='m'><link name='a'><visual name='v'>" + mesh +
                                "</visual><collision name='c'>" + mesh + "</collision></link></model>"));
  const auto simulation = worldOfFile(folder.path() / "w.sdf");
  ASSERT_NE(simulation, nullptr);
  const Model model = simulation->world().model("m").value();
  const auto robot = ::urdf::parseURDF(
      writeUrdf(simulation->world(), model, treeOfModel(model, {}, std::string(model.name()) + "/", "world")).text);
  ASSERT_NE(robot, nullptr);
  const auto link = robot->getLink("m/a");
  ASSERT_EQ(link->visual_array.size(), 1U);
  ASSERT_EQ(link->collision_array.size(), 1U);
  for (const auto& geometry : {link->visual_array[0]->geometry, link->collision_array[0]->geometry}) {
    const auto* found = dynamic_cast<const ::urdf::Mesh*>(geometry.get());
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->filename, "file://" + folder.path().string() + "/a%20mesh.obj");
    EXPECT_EQ(found->scale.z, 3);
  }
}

TEST(UrdfWriter, EscapesNames) {
  const Written written("<link name='a &amp; \"b\" &lt;c&gt;'/>");
  EXPECT_NE(written.robot->getLink("m/a & \"b\" <c>"), nullptr);
}

TEST(UrdfWriter, TurnsRotationsIntoAnglesAndBackAtAQuarterTurnToo) {
  for (const double pitch : {0.0, 1.0, std::numbers::pi / 2, -std::numbers::pi / 2, std::numbers::pi / 2 - 1e-9}) {
    for (const double yaw : {0.0, 0.3, -2.0, 3.1}) {
      const Quaternion rotation = fromRollPitchYaw(0.7, pitch, yaw);
      const Vector3 angles = exactRollPitchYawOf(rotation);
      EXPECT_LE(fromRollPitchYaw(angles.x(), angles.y(), angles.z()).angularDistance(rotation), 1e-14)
          << pitch << " " << yaw;
    }
  }
}

/// For every robot of every world, the URDF is valid and describes the same robot.
TEST(UrdfWriter, WritesTheRobotsOfAllWorlds) {
  std::vector<std::filesystem::path> files;
  const auto add = [&files](const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".sdf") files.push_back(entry.path());
    }
  };
  add(pongsim::test::projectFolder() / "worlds");
  if (const auto fortress = pongsim::test::fortressWorlds()) {
    for (const char* name : {"examples/ackermann_steering", "examples/diff_drive", "examples/joint_position_controller",
                             "examples/lift_drag", "examples/lift_drag_nested", "examples/mecanum_drive",
                             "examples/quadcopter", "examples/track_drive", "examples/tracked_vehicle_simple",
                             "examples/elevator", "examples/video_record_dbl_pendulum", "examples/skid_steer_mecanum",
                             "test/double_pendulum", "test/diff_drive_nested", "test/joint_sensor", "test/force_torque",
                             "test/fixed_world_joint", "test/include_connected_nested_models"}) {
      const auto file = *fortress / (std::string(name) + ".sdf");
      if (std::filesystem::exists(file)) files.push_back(file);
    }
  }
  std::size_t robots = 0;
  for (const auto& file : files) {
    Diagnostics diagnostics;
    const auto simulation = Simulation::fromFile(file, {.loadSystems = false}, diagnostics);
    if (simulation == nullptr) continue;
    for (const Model& model : simulation->world().models()) {
      if (!isRobot(model)) continue;
      ++robots;
      const KinematicTree tree = treeOfModel(model, {}, std::string(model.name()) + "/", "world");
      expectSame(*simulation, model, tree, writeUrdf(simulation->world(), model, tree),
                 file.filename().string() + " " + std::string(model.name()));
    }
  }
  EXPECT_GE(robots, pongsim::test::fortressWorlds() ? 20U : 3U);
}

}  // namespace
}  // namespace pongsim::ros2
