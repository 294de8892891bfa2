#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "support/fortress_worlds.hh"
#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

class FortressWorlds : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto folder = pongsim::test::fortressWorlds();
    if (!folder) GTEST_SKIP() << "Fortress's worlds are not there";
    folder_ = *folder;
  }

  std::filesystem::path folder_;
};

/// Errors that some worlds cause, and why Fortress does not load these worlds either.
const std::map<std::string_view, std::string_view> kReasons = {
    {"' is not in the local Fuel cache", "Fortress downloads it, and without a network says that it can't"},
};

bool isReason(const std::string& message) {
  return std::ranges::any_of(kReasons, [&](const auto& reason) { return message.ends_with(reason.first); });
}

TEST_F(FortressWorlds, LoadOrAreRefusedAsFortressRefusesThem) {
  const assets::Finder finder = assets::finderIn({{folder_ / "test/models"}, "/nowhere"});
  std::size_t loaded = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    if (entry.path().extension() != ".sdf") continue;
    Diagnostics diagnostics;
    const Root root = loadFile(entry.path(), diagnostics, finder);
    for (const Diagnostic& diagnostic : diagnostics.all()) {
      EXPECT_GT(diagnostic.position.line, 0) << format(diagnostic);
      EXPECT_GT(diagnostic.position.column, 0) << format(diagnostic);
    }
    for (const Diagnostic& diagnostic : diagnostics.all()) {
      EXPECT_TRUE(diagnostic.severity == Severity::kWarning || isReason(diagnostic.message)) << format(diagnostic);
    }
    if (diagnostics.hasErrors()) continue;
    ++loaded;
    EXPECT_EQ(root.worlds.size() + root.models.size() + root.lights.size(), 1U) << entry.path();
  }
  EXPECT_GT(loaded, 100U);
}

TEST_F(FortressWorlds, ThatIncludeModelsHoldThem) {
  const assets::Finder finder = assets::finderIn({{folder_ / "test/models"}, "/nowhere"});
  Diagnostics diagnostics;
  const Root root = loadFile(folder_ / "test/include_connected_nested_models.sdf", diagnostics, finder);
  for (const Diagnostic& diagnostic : diagnostics.all()) EXPECT_NE(diagnostic.severity, Severity::kError);
  const description::Model& model = root.worlds.at(0).models.at(1);
  EXPECT_EQ(model.name, "include_connected_nested_new_name");
  EXPECT_EQ(model.models.at(0).name, "nested_models_new_name");
  EXPECT_EQ(model.joints.at(0).child, "nested_models_new_name::model_00::link_00");
}

TEST_F(FortressWorlds, OfTheFirstTutorialsLoadWithoutAWord) {
  for (const char* name : {"tutorials/moving_robot.sdf", "tutorials/building_robot.sdf"}) {
    Diagnostics diagnostics;
    loadFile(folder_ / name, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  }
}

TEST_F(FortressWorlds, MovingRobotHasItsPartsInPlace) {
  Diagnostics diagnostics;
  const Root root = loadFile(folder_ / "tutorials/moving_robot.sdf", diagnostics);
  const description::World& world = root.worlds.at(0);
  EXPECT_EQ(world.name, "Moving_robot");
  EXPECT_EQ(world.physics.name, "1ms");
  EXPECT_EQ(world.plugins.size(), 7U);
  ASSERT_EQ(world.models.size(), 2U);
  EXPECT_TRUE(world.models[0].isStatic);

  const description::Model& robot = world.models[1];
  EXPECT_EQ(robot.canonicalLink, "chassis");
  ASSERT_EQ(robot.links.size(), 4U);
  const Quaternion wheel = fromRollPitchYaw(-1.5707, 0, 0);
  expectPose(robot.links[0].X_ModelLink, {0.5, 0, 0.4});
  expectPose(robot.links[1].X_ModelLink, {0, 0.6, 0.4}, wheel);
  expectPose(robot.links[2].X_ModelLink, {0, -0.6, 0.4}, wheel);
  expectPose(robot.links[3].X_ModelLink, {1.3, 0, 0.2});
  EXPECT_EQ(robot.links[0].inertial.mass, 1.14395);
  EXPECT_EQ(robot.links[1].inertial.moments(2, 2), 0.125);
  EXPECT_EQ(robot.frames.at(0).attachedLink, "chassis");

  ASSERT_EQ(robot.joints.size(), 3U);
  const description::Joint& left = robot.joints[0];
  EXPECT_EQ(left.type, description::JointType::kRevolute);
  EXPECT_EQ(left.parent, "chassis");
  EXPECT_EQ(left.child, "left_wheel");
  expectPose(left.X_ChildJoint, {0, 0, 0});
  expectPose(left.X_ParentJoint, {-0.5, 0.6, 0}, wheel);
  EXPECT_LT((left.axes.at(0).xyz - wheel.conjugate() * Vector3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(left.axes.at(0).upper, std::numeric_limits<double>::infinity());
  EXPECT_EQ(left.position.line, 214);
  EXPECT_EQ(left.position.column, 13);
  EXPECT_EQ(robot.joints[2].type, description::JointType::kBall);
  expectPose(robot.joints[2].X_ParentJoint, {0.8, 0, -0.2});
  EXPECT_EQ(robot.plugins.at(0).sdf.child("wheel_radius")->text, "0.4");
}

}  // namespace
}  // namespace pongsim::sdf::test
