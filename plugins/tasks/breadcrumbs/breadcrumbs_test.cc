#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/int32.pb.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::breadcrumbs_test {
namespace {

using test::RunningWorld;

constexpr const char* kCrumb = R"(<breadcrumb><sdf version="1.9"><model name="crumb"><pose>-1 0 0 0 0 0</pose>
  <link name="l"><inertial><mass>1</mass></inertial></link></model></sdf></breadcrumb>)";
constexpr const char* kTopic = "/model/carrier/breadcrumbs/crumb/deploy";

std::string worldWith(const std::string& parameters, const std::string& more = "") {
  return R"(<model name="carrier"><static>true</static><pose>5 0 3 0 0 1.5707963267948966</pose><link name="l"/>
      <plugin filename="ignition-gazebo-breadcrumbs-system" name="ignition::gazebo::systems::Breadcrumbs">)" +
         parameters + "</plugin></model>" + more;
}

class BreadcrumbsTest : public testing::Test {
 protected:
  void start(const std::string& parameters, const std::string& more = "", const std::string& topic = kTopic) {
    topic_ = topic;
    world_.emplace(worldWith(parameters, more));
    world_->listen(topic + "/remaining", remaining_);
  }
  void deploy() { world_->tell(topic_, ignition::msgs::Empty()); }
  bool has(const std::string& model) { return world_->simulation().world().model(model).has_value(); }
  std::vector<int> remaining() {
    std::vector<int> numbers;
    for (const auto& message : remaining_) numbers.push_back(message.data());
    return numbers;
  }

  std::string topic_;
  std::optional<RunningWorld> world_;
  std::vector<ignition::msgs::Int32> remaining_;
};

TEST_F(BreadcrumbsTest, LeaveACopyWhereTheModelIs) {
  start(kCrumb);
  world_->step(10);
  EXPECT_FALSE(has("crumb_0"));
  deploy();
  world_->step(1);
  ASSERT_TRUE(has("crumb_0"));
  // behind the carrier, which is turned, and in this step it falls already
  const Pose pose = world_->model("crumb_0").pose();
  EXPECT_NEAR(pose.position.x(), 5, 1e-9);
  EXPECT_NEAR(pose.position.y(), -1, 1e-9);
  EXPECT_NEAR(pose.position.z(), 3 - 9.8e-6, 1e-9);
  EXPECT_NEAR(yawOf(pose.rotation), 1.5707963267948966, 1e-9);
  deploy();
  deploy();
  world_->step(1);
  EXPECT_TRUE(has("crumb_1") && has("crumb_2"));
  EXPECT_EQ(remaining(), (std::vector<int>{-2, -3, -4}));
}

TEST_F(BreadcrumbsTest, LeaveNoMoreThanThereAre) {
  start(std::string(kCrumb) + "<max_deployments>2</max_deployments><topic>drop it</topic>", "", "/drop_it");
  for (int i = 0; i < 4; ++i) deploy();
  world_->step(2);
  EXPECT_TRUE(has("crumb_1"));
  EXPECT_FALSE(has("crumb_2"));
  EXPECT_EQ(remaining(), (std::vector<int>{1, 0, 0, 0}));
}

TEST_F(BreadcrumbsTest, ListenToNobodyWhereThereAreNone) {
  start("<max_deployments>0</max_deployments>");
  const Publisher publisher = world_->simulation().transport().node().advertise<ignition::msgs::Empty>(kTopic);
  EXPECT_FALSE(publisher.hasSubscribers());
}

constexpr const char* kTaken =
    "<model name='crumb_0'><static>1</static><link name='l'/></model>"
    "<model name='crumb_0_1'><static>1</static><link name='l'/></model>";

TEST_F(BreadcrumbsTest, LeaveNoneWhereTheNameIsTaken) {
  start(kCrumb, kTaken);
  testing::internal::CaptureStderr();
  deploy();
  world_->step(2);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("there is a 'crumb_0' already"), std::string::npos);
  EXPECT_EQ(world_->simulation().world().models().size(), 3U);
  EXPECT_TRUE(remaining().empty());
}

TEST_F(BreadcrumbsTest, TakeAnotherNameWhereTheyMay) {
  start(std::string(kCrumb) + "<allow_renaming>true</allow_renaming>", kTaken);
  deploy();
  deploy();
  world_->step(2);
  EXPECT_TRUE(has("crumb_0_2"));
  EXPECT_TRUE(has("crumb_1"));
}

TEST_F(BreadcrumbsTest, RestAfterTheirTime) {
  start(std::string(kCrumb) + "<disable_physics_time>0.5</disable_physics_time>");
  deploy();
  world_->step(500);
  EXPECT_FALSE(has("crumb_0__static__"));
  world_->step(1);
  EXPECT_TRUE(has("crumb_0__static__"));
  world_->step(1000);
  // it has fallen for 501 steps
  EXPECT_NEAR(world_->model("crumb_0").pose().position.z(), 3 - 9.8e-6 * 501 * 502 / 2, 1e-4);
}

TEST_F(BreadcrumbsTest, DoNotRestWhereTheyAreGone) {
  start(std::string(kCrumb) + "<disable_physics_time>0.1</disable_physics_time>");
  deploy();
  world_->step(10);
  EXPECT_TRUE(world_->simulation().remove(world_->model("crumb_0")));
  world_->step(200);
  EXPECT_FALSE(has("crumb_0__static__"));
}

TEST_F(BreadcrumbsTest, AreLeftWhilePaused) {
  start(kCrumb);
  deploy();
  world_->simulation().stepPaused();
  EXPECT_TRUE(has("crumb_0"));
}

TEST_F(BreadcrumbsTest, Perform) {
  start(std::string(kCrumb) +
        "<performer_volume><geometry><box><size>1 2 3</size></box></geometry></performer_volume>");
  deploy();
  world_->step(1);
  std::vector<Performer> performers;
  world_->simulation().world().performers(performers);
  ASSERT_EQ(performers.size(), 1U);
  EXPECT_EQ(performers[0].model, world_->model("crumb_0").id());
  EXPECT_EQ(performers[0].size, Vector3(1, 2, 3));
}

TEST_F(BreadcrumbsTest, BeginAgainAfterAReset) {
  start(std::string(kCrumb) + "<max_deployments>1</max_deployments>");
  deploy();
  world_->step(2);
  Diagnostics diagnostics;
  world_->simulation().reset(diagnostics);
  EXPECT_FALSE(has("crumb_0"));
  deploy();
  world_->step(2);
  EXPECT_TRUE(has("crumb_0"));
}

TEST_F(BreadcrumbsTest, KnowFromASavedStateHowManyTheyLeft) {
  start(std::string(kCrumb) + "<disable_physics_time>0.5</disable_physics_time>");
  deploy();
  world_->step(250);
  const std::vector<std::byte> state = world_->simulation().saveState();
  world_->step(100);
  EXPECT_TRUE(world_->simulation().restoreState(state));
  world_->step(200);
  EXPECT_FALSE(has("crumb_0__static__"));
  world_->step(100);
  EXPECT_TRUE(has("crumb_0__static__"));
  deploy();
  world_->step(2);
  EXPECT_TRUE(has("crumb_1"));
}

TEST(Breadcrumbs, SayWhatIsWrong) {
  const std::string left = "breadcrumbs of carrier is left out: ";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "no <breadcrumb> is given"},
      {"<breadcrumb/>", "<breadcrumb> has no <sdf>"},
      {"<breadcrumb><sdf version='1.9'/></breadcrumb>", "there is no <world> and no <model> in this file"},
      {"<breadcrumb><sdf version='1.9'><model name='m'/></sdf></breadcrumb>", "model 'm' has no link"},
      {std::string(kCrumb) + "<performer_volume><geometry><sphere/></geometry></performer_volume>",
       "<performer_volume> is not a box"}};
  for (const auto& [parameters, message] : cases) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector<std::string>{left + message});
  }
}

TEST(Breadcrumbs, OfFortressTestWorldRestWhereTheyHaveFallen) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/breadcrumbs.sdf");
  world.step(100);
  world.tell("/model/vehicle_blue/breadcrumbs/B2/deploy", ignition::msgs::Empty());
  world.step(800);
  const Pose relative = world.model("vehicle_blue").pose().inverse() * world.model("B2_0").pose();
  EXPECT_NEAR(relative.position.x(), -2.2, 1e-2);
  EXPECT_NEAR(relative.position.y(), 0, 1e-2);
  EXPECT_NEAR(relative.position.z(), 2 - 9.8 / 8, 1e-2);
}

}  // namespace
}  // namespace pongsim::breadcrumbs_test
