#include "ros2/robot/kinematic_tree.hh"

#include <algorithm>

#include "support/ros2/robot_world.hh"

namespace pongsim::ros2 {
namespace {

using test::expectNear;
using test::inWorld;
using test::worldOf;
using Words = std::vector<std::string>;

std::string link(const std::string& name, const std::string& pose = "0 0 0 0 0 0") {
  return "<link name='" + name + "'><pose>" + pose + "</pose></link>";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& rest = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" + child + "</child>" +
         rest + "</joint>";
}

std::string axis(const std::string& xyz) { return "<axis><xyz>" + xyz + "</xyz></axis>"; }

/// Expects that joint positions give the same poses as in the simulation.
void expectPoses(Simulation& simulation, const Model& model, const KinematicTree& tree, double tolerance) {
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    if (!tree.links[i].link) continue;
    expectNear(tree.rootPose(model) * tree.poseInRoot(i, model), tree.links[i].link->pose(), tolerance,
               tree.links[i].frame + " at " + std::to_string(toSeconds(simulation.time())));
  }
}

struct Made {
  std::unique_ptr<Simulation> simulation;
  Model model;
  KinematicTree tree;

  explicit Made(const std::string& parts)
      : simulation(worldOf(inWorld("<model name='m'><pose>1 2 3 0.1 0.2 0.3</pose>" + parts + "</model>"))),
        model(simulation->world().model("m").value()),
        tree(treeOfModel(model, {}, std::string(model.name()) + "/", "world")) {}

  Words frames() const {
    Words all;
    for (const TreeLink& each : tree.links) all.push_back(each.frame);
    return all;
  }
};

TEST(KinematicTree, HangsLinksOnTheOneThatNoJointMoves) {
  const Made made(link("wheel", "0 1 0 1 0 0") + link("chassis", "0 0 0.5 0 0 0.7") + link("tool", "1 0 0 0 0 0") +
                  joint("axle", "revolute", "chassis", "wheel", axis("0 0 1")) +
                  joint("weld", "fixed", "wheel", "tool"));
  EXPECT_EQ(made.frames(), (Words{"m/chassis", "m/wheel", "m/tool"}));
  EXPECT_EQ(made.tree.links[1].joint, "axle");
  EXPECT_EQ(made.tree.links[1].motion, Motion::kTurning);
  EXPECT_EQ(made.tree.links[2].motion, Motion::kFixed);
  EXPECT_EQ(made.tree.warnings, Words());
  expectPoses(*made.simulation, made.model, made.tree, 1e-12);
}

TEST(KinematicTree, FollowsJointsOfAllKindsAsTheSimulationMoves) {
  const std::string frame = "<pose>0.1 0.2 0.3 0.4 0.5 0.6</pose>";
  Made made(link("base") + link("turned", "1 0 0 0.3 0.2 0.1") + link("slid", "0 1 0 0 0 1") +
            link("crossed", "0 0 1 0.2 0 0") + link("swung", "-1 0 0 0 0.3 0") +
            joint("turn", "revolute", "base", "turned", frame + axis("1 2 3")) +
            joint("slide", "prismatic", "base", "slid", frame + axis("0 1 1")) +
            joint("cross", "universal", "base", "crossed", frame + axis("1 0 0") + "<axis2><xyz>0 1 0</xyz></axis2>") +
            joint("swing", "ball", "base", "swung", frame));
  expectPoses(*made.simulation, made.model, made.tree, 1e-12);
  EXPECT_EQ(made.tree.warnings,
            (Words{"joint 'cross' has two axes: it is two joints in the URDF, with '_axis1' and '_axis2'",
                   "joint 'swing' is a ball joint, which URDF does not have: it is \"floating\" there"}));
  ASSERT_TRUE(made.model.joint("turn")->resetPosition(0.7));
  ASSERT_TRUE(made.model.joint("slide")->resetPosition(-0.4));
  ASSERT_TRUE(made.model.joint("cross")->resetPosition(0.5));
  ASSERT_TRUE(made.model.joint("cross")->resetPosition(-0.3, 1));
  expectPoses(*made.simulation, made.model, made.tree, 1e-9);
  // and after they have moved by themselves
  made.model.joint("turn")->setVelocityTarget(1);
  made.model.link("swung")->setVelocity({0, 0, 0}, {0.1, 0.2, 0.3});
  made.simulation->step(50);
  EXPECT_GT(made.model.joint("turn")->position(), 0.7);
  expectPoses(*made.simulation, made.model, made.tree, 1e-3);
}

TEST(KinematicTree, PutsALinkOnTheAxisOfAJointThatItsChildIsNotOn) {
  const Made made(link("base") + link("arm", "1 0 0 0 0 0") +
                  joint("hinge", "revolute", "base", "arm", "<pose>-0.5 0 0 0 0 0</pose>" + axis("0 0 1")));
  EXPECT_EQ(made.frames(), (Words{"m/base", "m/hinge", "m/arm"}));
  EXPECT_EQ(made.tree.links[1].joint, "hinge");
  EXPECT_EQ(made.tree.links[2].joint, "hinge_offset");
  ASSERT_TRUE(made.model.joint("hinge")->resetPosition(1.2));
  expectPoses(*made.simulation, made.model, made.tree, 1e-9);
}

TEST(KinematicTree, GoesAgainstAJointWhereNothingElseLeadsToALink) {
  const Made made(link("base") + link("other", "0 0 1 0 0 0") + link("child", "0 1 0 0.4 0 0") +
                  joint("first", "revolute", "base", "child", axis("0 0 1")) +
                  joint("second", "revolute", "other", "child", axis("1 0 0")));
  EXPECT_EQ(made.frames(), (Words{"m/base", "m/child", "m/second", "m/other"}));
  expectPoses(*made.simulation, made.model, made.tree, 1e-12);
  EXPECT_EQ(made.tree.links[2].axis, Vector3(-1, 0, 0));
}

TEST(KinematicTree, HasTheWorldAtItsRootWhereAJointHangsOnIt) {
  const Made made(link("base", "0 0 1 0 0 0") + link("arm") + joint("hold", "fixed", "world", "base") +
                  joint("hinge", "revolute", "base", "arm", axis("0 0 1")));
  EXPECT_EQ(made.frames(), (Words{"world", "m/base", "m/arm"}));
  expectPoses(*made.simulation, made.model, made.tree, 1e-12);
}

TEST(KinematicTree, SaysWhatUrdfHasNot) {
  const Made made(link("a") + link("b", "0 1 0 0 0 0") + link("c", "0 2 0 0 0 0") + link("alone", "3 0 0 0 0 1") +
                  joint("ab", "fixed", "a", "b") + joint("bc", "fixed", "b", "c") + joint("ac", "fixed", "a", "c"));
  EXPECT_EQ(made.frames(), (Words{"m/a", "m/b", "m/c", "m/alone"}));
  EXPECT_EQ(made.tree.warnings, (Words{"link 'm::alone' has no parent: it is \"floating\" in the URDF",
                                       "joint 'ac' closes a loop: it is left out of the URDF"}));
  EXPECT_EQ(made.tree.links[3].motion, Motion::kFree);
  expectPoses(*made.simulation, made.model, made.tree, 1e-12);
}

TEST(KinematicTree, TakesInNestedModels) {
  const Made made(link("base") + "<model name='inner'><pose>0 0 1 0 0 0</pose>" + link("base") +
                  link("tip", "0 0 1 0 0 0") + joint("hinge", "revolute", "base", "tip", axis("0 1 0")) + "</model>" +
                  joint("weld", "fixed", "base", "inner::base"));
  EXPECT_EQ(made.frames(), (Words{"m/base", "m/inner/base", "m/inner/tip"}));
  EXPECT_EQ(made.tree.links[2].joint, "inner/hinge");
  expectPoses(*made.simulation, made.model, made.tree, 1e-12);
}

TEST(KinematicTree, HasAllLinksOfAUrdf) {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
  const auto simulation = worldOf(
      "<robot name='r'><link name='base'>" + inertial + "</link><link name='arm'>" + inertial +
      "</link><link name='camera'/><joint name='hinge' type='revolute'><origin xyz='0 1 0' rpy='0.1 0.2 0.3'/>"
      "<parent link='base'/><child link='arm'/><axis xyz='0 0 2'/><limit lower='-1' upper='1' effort='1' velocity='1'/>"
      "</joint><joint name='weld' type='fixed'><origin xyz='0 0 1'/><parent link='arm'/><child link='camera'/></joint>"
      "</robot>");
  const Model model = simulation->world().model("r").value();
  ASSERT_NE(model.urdf(), nullptr);
  const KinematicTree tree = treeOfUrdf(model, {.prefix = "p/"});
  ASSERT_EQ(tree.links.size(), 3U);
  EXPECT_EQ(tree.links[2].frame, "p/camera");
  // it is merged into the arm
  EXPECT_FALSE(tree.links[2].link);
  ASSERT_TRUE(model.joint("hinge")->resetPosition(0.5));
  expectPoses(*simulation, model, tree, 1e-9);
  expectNear(tree.rootPose(model) * tree.poseInRoot(2, model), model.link("arm")->pose() * Pose{{0, 0, 1}}, 1e-9,
             "camera");
}

}  // namespace
}  // namespace pongsim::ros2
