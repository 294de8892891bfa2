#include "web/foxglove/typed_channels.hh"

#include <foxglove/scene.pb.h>
#include <foxglove/sensors.pb.h>
#include <foxglove/transforms.pb.h>
#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pose_v.pb.h>

#include "support/web/session_of_a_world.hh"

namespace pongsim::web::foxglove {
namespace {

namespace im = ignition::msgs;

class TypedOffersTest : public SessionTest {
 protected:
  void subscribe(const json& channel) {
    say({{"op", "subscribe"}, {"subscriptions", {{{"id", channel["id"]}, {"channelId", channel["id"]}}}}});
  }
  /// Publishes until the client has received a message of that type, and returns it.
  template <class M>
  M received(const std::function<void()>& publish) {
    M message;
    world_.stepUntil([&] {
      publish();
      client_->free();
      for (const std::string& bytes : client_->takeBinaries()) {
        if (bytes[0] == '\1') return message.ParseFromString(bytes.substr(13));
      }
      return false;
    });
    return message;
  }

  Service scene_ = world_.node().serve<im::Empty, im::Scene>("/world/w/scene/info", [](const auto&, im::Scene& scene) {
    im::Model& model = *scene.add_model();
    model.set_name("rover");
    model.set_id(1);
    model.add_link()->set_name("chassis");
    return true;
  });
};

TEST_F(TypedOffersTest, HaveTheSceneAndItsFrames) {
  auto poses = world_.node().advertise<im::Pose_V>("/world/w/pose/info");
  open();
  const json scene = channel("/foxglove/world/w/scene");
  EXPECT_EQ(scene["schemaName"], "foxglove.SceneUpdate");
  subscribe(scene);
  EXPECT_EQ(received<::foxglove::SceneUpdate>([] {}).entities(0).id(), "rover::chassis");
  open();
  const json frames = channel("/foxglove/world/w/tf");
  EXPECT_EQ(frames["schemaName"], "foxglove.FrameTransforms");
  subscribe(frames);
  im::Pose_V message;
  message.add_pose()->set_id(1);
  const auto got = received<::foxglove::FrameTransforms>([&] { poses.publish(message); });
  EXPECT_EQ(got.transforms(0).child_frame_id(), "rover");
}

TEST_F(TypedOffersTest, HaveWhatSensorsSay) {
  auto scans = world_.node().advertise<im::LaserScan>("/scan");
  open();
  const json scan = channel("/foxglove/scan");
  EXPECT_EQ(scan["schemaName"], "foxglove.LaserScan");
  subscribe(scan);
  im::LaserScan message;
  message.set_count(1);
  message.add_ranges(5);
  EXPECT_EQ(received<::foxglove::LaserScan>([&] { scans.publish(message); }).ranges(0), 5);
}

TEST_F(TypedOffersTest, AreNotForOurPage) {
  auto scans = world_.node().advertise<im::LaserScan>("/scan");
  open("pongsim.web.v1");
  ASSERT_FALSE(channel("/scan").is_null());
  ASSERT_FALSE(service("/world/w/scene/info").is_null());
  world_.steps(3);
  client_->free();
  for (const std::string& text : client_->takeTexts()) EXPECT_EQ(text.find("/foxglove"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::web::foxglove
