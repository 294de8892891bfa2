#include "web/typed/frames.hh"

#include <gtest/gtest.h>

namespace pongsim::web::typed {
namespace {

namespace im = ignition::msgs;

im::Scene scene() {
  im::Scene all;
  im::Model& rover = *all.add_model();
  rover.set_name("rover");
  rover.set_id(1);
  im::Link& chassis = *rover.add_link();
  chassis.set_name("chassis");
  chassis.set_id(2);
  im::Sensor& lidar = *chassis.add_sensor();
  lidar.set_name("lidar");
  lidar.mutable_pose()->mutable_position()->set_z(0.5);
  im::Model& arm = *rover.add_model();
  arm.set_name("arm");
  arm.set_id(3);
  im::Link& hand = *arm.add_link();
  hand.set_name("hand");
  hand.set_id(4);
  return all;
}

TEST(Frames, AreNamedByWhatHoldsThem) {
  im::Pose_V poses;
  for (const std::uint32_t id : {1, 2, 3, 4, 77}) {
    im::Pose& pose = *poses.add_pose();
    pose.set_id(id);
    pose.mutable_position()->set_x(id);
    pose.mutable_orientation()->set_w(1);
  }
  const auto transforms = Frames(scene()).transforms(poses, 2'500'000'000);
  const std::vector<std::pair<std::string, std::string>> names = {{"world", "rover"},
                                                                  {"rover", "rover::chassis"},
                                                                  {"rover", "rover::arm"},
                                                                  {"rover::arm", "rover::arm::hand"},
                                                                  {"rover::chassis", "rover::chassis::lidar"}};
  ASSERT_EQ(transforms.transforms_size(), 5);
  for (int i = 0; i < 5; ++i) {
    const auto& transform = transforms.transforms(i);
    EXPECT_EQ(transform.parent_frame_id(), names[static_cast<std::size_t>(i)].first);
    EXPECT_EQ(transform.child_frame_id(), names[static_cast<std::size_t>(i)].second);
    EXPECT_EQ(transform.rotation().w(), 1);
    EXPECT_EQ(transform.timestamp().seconds(), 2);
    EXPECT_EQ(transform.timestamp().nanos(), 500'000'000);
  }
  EXPECT_EQ(transforms.transforms(3).translation().x(), 4);
  EXPECT_EQ(transforms.transforms(4).translation().z(), 0.5);
}

TEST(Frames, HaveTheTimeOfTheMessageWhereItHasOne) {
  im::Pose_V poses;
  poses.mutable_header()->mutable_stamp()->set_sec(9);
  EXPECT_EQ(Frames(scene()).transforms(poses, 1).transforms(0).timestamp().seconds(), 9);
}

}  // namespace
}  // namespace pongsim::web::typed
