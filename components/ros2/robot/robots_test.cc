#include "ros2/robot/robots.hh"

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "ros2/pairs/pairs.hh"
#include "ros2/robot/robot_list.hh"
#include "ros2/robot/transforms.hh"
#include "support/process.hh"
#include "support/ros2/robot_world.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

using test::inWorld;
using Words = std::vector<std::string>;

std::string wheel(const std::string& name, const std::string& side) {
  return "<link name='" + name + "'><pose>0 " + side +
         " 0 -1.5707963 0 0</pose><collision name='c'><geometry><sphere><radius>0.1</radius></sphere></geometry>"
         "</collision></link><joint name='" +
         name + "_joint' type='revolute'><parent>chassis</parent><child>" + name +
         "</child><axis><xyz>0 0 1</xyz></axis></joint>";
}

/// A vehicle with two wheels, a sensor and a drive.
std::string vehicle(const std::string& name, const std::string& drive = "") {
  return "<model name='" + name +
         "'><link name='chassis'><sensor name='imu' type='imu'><pose>0 0 0.3 0 0 0</pose></sensor></link>"
         "<plugin filename='ignition-gazebo-imu-system' name='ignition::gazebo::systems::Imu'/>" +
         wheel("left", "0.3") + wheel("right", "-0.3") +
         "<plugin filename='ignition-gazebo-diff-drive-system' name='ignition::gazebo::systems::DiffDrive'>"
         "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint><wheel_separation>0.6"
         "</wheel_separation><wheel_radius>0.1</wheel_radius>" +
         drive + "</plugin></model>";
}

/// The last transform of each child frame, and all parents that a child has had.
struct Tree {
  std::map<std::string, geometry_msgs::TransformStamped> transforms;
  std::map<std::string, std::set<std::string>> parents;

  void add(const tf2_msgs::TFMessage& message) {
    for (const auto& transform : message.transforms) {
      transforms[transform.child_frame_id] = transform;
      parents[transform.child_frame_id].insert(transform.header.frame_id);
    }
  }
  /// @return The root frames.
  std::set<std::string> roots() const {
    std::set<std::string> all;
    for (const auto& [child, transform] : transforms) {
      if (!transforms.contains(transform.header.frame_id)) all.insert(transform.header.frame_id);
    }
    return all;
  }
  bool hasFrames(const Words& frames) const {
    return std::ranges::all_of(frames, [this](const std::string& frame) { return transforms.contains(frame); });
  }
};

/// A simulation with robots, and another ROS node.
class RobotsTest : public testing::Test {
 protected:
  void run(const std::string& models, const RobotSettings& robotSettings = {}, const Settings& settings = {}) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(inWorld(models), "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
    node_.emplace(simulation_->transport().node());
    bridge_.emplace(*node_, ros_, settings);
    robots_.emplace(simulation_->world(), *node_, ros_, *bridge_, settings, robotSettings);
  }

  /// As in the system.
  void step() {
    bridge_->update();
    robots_->preUpdate(simulation_->time());
    simulation_->step();
    robots_->postUpdate(simulation_->time());
  }

  bool stepUntil(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + pongsim::test::kDeadline;
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      step();
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return true;
  }

  void hearTransforms() {
    for (const char* topic : {"/tf", "/tf_static"}) {
      heard_.push_back(peer_.subscribe<tf2_msgs::TFMessage>(
          topic,
          [this](const tf2_msgs::TFMessage& message) {
            const std::lock_guard lock(mutex_);
            tree_.add(message);
          },
          topic == std::string("/tf") ? Qos{.depth = 100} : kLatchedQos));
    }
  }
  Tree tree() {
    const std::lock_guard lock(mutex_);
    return tree_;
  }

  template <class Message>
  void hear(const std::string& topic, std::vector<Message>& messages, const Qos& qos = kDefaultQos) {
    heard_.push_back(peer_.subscribe<Message>(
        topic,
        [this, &messages](const Message& message) {
          const std::lock_guard lock(mutex_);
          messages.push_back(message);
        },
        qos));
  }
  template <class Message>
  std::vector<Message> copyOf(const std::vector<Message>& messages) {
    const std::lock_guard lock(mutex_);
    return messages;
  }

  const int domain_ = pongsim::test::testDomain();
  Participant participant_{{.domain = domain_}};
  RosNode ros_{participant_, {}};
  Participant peerParticipant_{{.domain = domain_}};
  RosNode peer_{peerParticipant_, {.name = "peer"}};
  std::mutex mutex_;
  Tree tree_;
  std::unique_ptr<Simulation> simulation_;
  std::optional<Node> node_;
  std::optional<Bridge> bridge_;
  std::optional<Robots> robots_;
  std::vector<std::unique_ptr<RosSubscription>> heard_;
};

TEST_F(RobotsTest, HangALinkOnItsJointAndTheTopmostOneOnItsOdometry) {
  run(vehicle("v"));
  hearTransforms();
  const Words all{"v/chassis", "v/left", "v/right", "v/chassis/imu"};
  ASSERT_TRUE(stepUntil([&] { return tree().hasFrames(all); }));
  const Tree found = tree();
  EXPECT_EQ(found.roots(), std::set<std::string>{"v/odom"});
  for (const auto& [child, parents] : found.parents) EXPECT_EQ(parents.size(), 1U) << child;
  EXPECT_EQ(found.transforms.at("v/chassis/imu").transform.translation.z, 0.3);
  EXPECT_EQ(found.transforms.at("v/left").transform.translation.y, 0.3);
}

TEST_F(RobotsTest, FollowTheJointsAtTheTimeOfTheStamp) {
  run("<model name='m'><link name='base'/><joint name='hold' type='fixed'><parent>world</parent><child>base</child>"
      "</joint><link name='arm'/><joint name='hinge' type='revolute'><parent>base</parent><child>arm</child><axis>"
      "<xyz>0 0 1</xyz></axis></joint></model>");
  simulation_->world().model("m")->joint("hinge")->setVelocityTarget(1);
  std::vector<tf2_msgs::TFMessage> messages;
  hear("/tf", messages, {.depth = 100});
  ASSERT_TRUE(stepUntil([&] { return copyOf(messages).size() >= 5; }));
  std::vector<tf2_msgs::TFMessage> heard = copyOf(messages);
  // the first one comes as soon as there is a subscriber
  heard.erase(heard.begin());
  for (const tf2_msgs::TFMessage& message : heard) {
    ASSERT_EQ(message.transforms.size(), 1U);
    const auto& transform = message.transforms[0];
    EXPECT_EQ(transform.header.frame_id, "m/base");
    const double time = transform.header.stamp.sec + 1e-9 * transform.header.stamp.nanosec;
    // at multiples of 20 ms
    EXPECT_NEAR(std::remainder(time, 0.02), 0, 1e-9);
    EXPECT_NEAR(2 * std::atan2(transform.transform.rotation.z, transform.transform.rotation.w), time, 2e-3);
  }
}

TEST_F(RobotsTest, HangOnTheWorldWhereTheyHaveNoOdometry) {
  run("<model name='drone'><pose>1 2 3 0 0 0</pose><link name='body'><sensor name='eye' type='camera'><camera/>"
      "</sensor></link><plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>"
      "</model><model name='post'><static>true</static><pose>4 0 0 0 0 0</pose><link name='l'>"
      "<sensor name='imu' type='imu'/></link>"
      "<plugin filename='ignition-gazebo-imu-system' name='ignition::gazebo::systems::Imu'/></model>");
  hearTransforms();
  ASSERT_TRUE(stepUntil([&] { return tree().hasFrames({"drone/body", "drone/body/eye", "post/l", "post/l/imu"}); }));
  const Tree found = tree();
  EXPECT_EQ(found.roots(), std::set<std::string>{"world"});
  EXPECT_EQ(found.transforms.at("drone/body").transform.translation.z, 3);
  EXPECT_EQ(found.transforms.at("post/l").transform.translation.x, 4);
}

TEST_F(RobotsTest, HaveTheWorldAboveTheirOdometryWhereTheUserWantsTheTruth) {
  RobotSettings settings;
  settings.groundTruth = "always";
  settings.worldFrame = "map";
  run(vehicle("v") + vehicle("u"), settings);
  hearTransforms();
  ASSERT_TRUE(stepUntil([&] { return tree().hasFrames({"v/odom", "v/chassis", "u/odom", "u/chassis"}); }));
  EXPECT_EQ(tree().roots(), std::set<std::string>{"map"});
}

TEST_F(RobotsTest, CallTheBaseAsItsOdometryDoesToo) {
  run(vehicle("v", "<frame_id>odom</frame_id><child_frame_id>base_footprint</child_frame_id>"));
  hearTransforms();
  ASSERT_TRUE(stepUntil([&] { return tree().hasFrames({"v/chassis", "base_footprint"}); }));
  const Tree found = tree();
  EXPECT_EQ(found.roots(), std::set<std::string>{"odom"});
  EXPECT_EQ(found.transforms.at("base_footprint").header.frame_id, "v/chassis");
}

TEST_F(RobotsTest, AreNotTakenForOnesThatHadTheirPlaceInMemory) {
  run(vehicle("v", "<frame_id>odom</frame_id><child_frame_id>base_footprint</child_frame_id>"));
  robots_.reset();
  Transforms transforms(*node_, ros_, {}, {});
  const std::list<Fixture> fixtures;
  const auto robotsNow = [&] {
    RobotList list(simulation_->world(), {}, {});
    list.update();
    return list.robots();
  };
  const auto isHeardSoon = [&](const Words& frames) {
    const auto end = std::chrono::steady_clock::now() + pongsim::test::kDeadline;
    while (!tree().hasFrames(frames) && std::chrono::steady_clock::now() < end) {
      transforms.preUpdate(simulation_->time());
      simulation_->step();
      transforms.postUpdate(simulation_->time());
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return tree().hasFrames(frames);
  };
  std::list<Robot> robots = robotsNow();
  transforms.follow(robots, fixtures);
  hearTransforms();
  ASSERT_TRUE(isHeardSoon({"v/chassis", "base_footprint"}));

  // another one of the same name, whose odometry gives the base no other name
  ASSERT_TRUE(simulation_->remove(*simulation_->world().model("v")));
  Diagnostics diagnostics;
  const std::string next = vehicle("v", "<frame_id>odom</frame_id><child_frame_id>v/chassis</child_frame_id>");
  ASSERT_TRUE(simulation_->insertText("<sdf version='1.9'>" + next + "</sdf>", "model.sdf", {}, diagnostics));
  robots.front() = robotsNow().front();
  transforms.follow(robots, fixtures);
  {
    const std::lock_guard lock(mutex_);
    tree_ = {};
  }
  ASSERT_TRUE(isHeardSoon({"v/chassis", "v/chassis/imu"}));
  EXPECT_FALSE(tree().hasFrames({"base_footprint"}));
}

TEST_F(RobotsTest, LeaveToARuleWhatItBringsToTf) {
  Settings settings;
  TopicRule rule;
  rule.ros = "/tf";
  rule.ignition = "/model/v/tf";
  rule.pair = findPair("tf2_msgs/msg/TFMessage", "ignition.msgs.Pose_V");
  ASSERT_NE(rule.pair, nullptr);
  settings.rules = {rule};
  run(vehicle("v"), {}, settings);
  std::vector<tf2_msgs::TFMessage> messages;
  hear("/tf", messages, {.depth = 100});
  ASSERT_TRUE(stepUntil([&] { return copyOf(messages).size() >= 40; }));
  std::set<std::pair<std::int32_t, std::uint32_t>> stamps;
  std::size_t count = 0;
  for (const tf2_msgs::TFMessage& message : copyOf(messages)) {
    for (const auto& transform : message.transforms) {
      if (transform.child_frame_id != "v/chassis") continue;
      ++count;
      stamps.emplace(transform.header.stamp.sec, transform.header.stamp.nanosec);
    }
  }
  EXPECT_GT(count, 3U);
  EXPECT_EQ(stamps.size(), count);
}

TEST_F(RobotsTest, AreDescribedToWhoComesLate) {
  run(vehicle("v"));
  step();
  std::vector<std_msgs::String> texts;
  hear("/robot_description", texts, kLatchedQos);
  ASSERT_TRUE(stepUntil([&] { return !copyOf(texts).empty(); }));
  EXPECT_NE(copyOf(texts)[0].data.find("<link name=\"v/chassis\">"), std::string::npos);
  std::vector<std_msgs::String> later;
  hear("/robot_description", later, kLatchedQos);
  ASSERT_TRUE(stepUntil([&] { return !copyOf(later).empty(); }));
  EXPECT_EQ(copyOf(later)[0], copyOf(texts)[0]);
}

TEST_F(RobotsTest, TellTheirJoints) {
  run(vehicle("v"));
  simulation_->world().model("v")->joint("left_joint")->resetPosition(0.5);
  std::vector<sensor_msgs::JointState> states;
  hear("/joint_states", states);
  ASSERT_TRUE(stepUntil([&] { return copyOf(states).size() >= 2; }));
  const sensor_msgs::JointState state = copyOf(states)[0];
  EXPECT_EQ(state.name, (Words{"left_joint", "right_joint"}));
  ASSERT_EQ(state.position.size(), 2U);
  EXPECT_NEAR(state.position[0], 0.5, 1e-3);
  EXPECT_EQ(state.velocity.size(), 2U);
  EXPECT_EQ(state.effort.size(), 2U);
}

TEST_F(RobotsTest, HaveTopicsOfTheirOwnWhereTheyAreSeveral) {
  run(vehicle("v"));
  std::vector<sensor_msgs::JointState> states, own;
  std::vector<std_msgs::String> text;
  hear("/joint_states", states);
  hear("/u/joint_states", own);
  hear("/u/robot_description", text, kLatchedQos);
  ASSERT_TRUE(stepUntil([&] { return !copyOf(states).empty(); }));
  EXPECT_EQ(copyOf(states).back().name, (Words{"left_joint", "right_joint"}));
  // a robot is inserted at run time
  Diagnostics diagnostics;
  ASSERT_TRUE(simulation_->insertText("<sdf version='1.9'>" + vehicle("u") + "</sdf>", "u", {}, diagnostics));
  robots_->worldChanged();
  ASSERT_TRUE(stepUntil([&] { return !copyOf(own).empty() && !copyOf(text).empty(); }));
  ASSERT_TRUE(stepUntil([&] { return copyOf(states).back().name.size() == 4; }));
  EXPECT_EQ(copyOf(states).back().name, (Words{"v/left_joint", "v/right_joint", "u/left_joint", "u/right_joint"}));
  EXPECT_EQ(copyOf(own).back().name, (Words{"left_joint", "right_joint"}));
  // and removed
  ASSERT_TRUE(simulation_->remove(simulation_->world().model("v").value()));
  robots_->worldChanged();
  ASSERT_TRUE(stepUntil([&] { return copyOf(states).back().name == Words{"left_joint", "right_joint"}; }));
}

TEST_F(RobotsTest, WarnWhereAnotherNodeDescribesThemToo) {
  run(vehicle("v"));
  const auto other = peer_.advertise<std_msgs::String>("/robot_description", kLatchedQos);
  const auto isKnown = [this] {
    return std::ranges::any_of(participant_.graph().endpoints(), [this](const Graph::Endpoint& endpoint) {
      return endpoint.contract.topic == "rt/robot_description" &&
             endpoint.id.isOfSameParticipant(peerParticipant_.id());
    });
  };
  testing::internal::CaptureStderr();
  const bool is = stepUntil(isKnown);
  for (int i = 0; i < 500; ++i) step();
  const std::string said = testing::internal::GetCapturedStderr();
  ASSERT_TRUE(is);
  const std::size_t first = said.find("another node publishes '/robot_description', too");
  EXPECT_NE(first, std::string::npos) << said;
  EXPECT_EQ(said.find("another node publishes", first + 1), std::string::npos) << said;
}

TEST_F(RobotsTest, AreNotToldOfWhereTheUserDoesNotWantIt) {
  RobotSettings settings;
  settings.tellsDescription = settings.tellsJointStates = settings.tellsTransforms = false;
  run(vehicle("v"), settings);
  const auto offers = [this](const std::string& topic) {
    return std::ranges::any_of(peerParticipant_.graph().endpoints(),
                               [&topic](const Graph::Endpoint& endpoint) { return endpoint.contract.topic == topic; });
  };
  ASSERT_TRUE(stepUntil([&] { return offers("rt/model/v/odometry"); }));
  for (const char* topic : {"rt/tf", "rt/tf_static", "rt/joint_states", "rt/robot_description"}) {
    EXPECT_FALSE(offers(topic)) << topic;
  }
}

TEST_F(RobotsTest, LeaveTheirLinksToRobotStatePublisherWhereTheUserWantsIt) {
  RobotSettings settings;
  settings.tellsLinks = false;
  run(vehicle("v"), settings);
  hearTransforms();
  ASSERT_TRUE(stepUntil([this] { return tree().hasFrames({"v/chassis", "v/chassis/imu"}); }));
  EXPECT_EQ(tree().roots(), std::set<std::string>{"v/odom"});
  EXPECT_FALSE(tree().hasFrames({"v/left"}));
}

}  // namespace
}  // namespace pongsim::ros2
