#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/marker.pb.h>
#include <ignition/msgs/marker_v.pb.h>

#include <memory>
#include <string>
#include <vector>

#include "support/ask_service.hh"
#include "support/running_world.hh"

namespace pongsim::marker_test {
namespace {

using ignition::msgs::Boolean;
using ignition::msgs::Empty;
using ignition::msgs::Image;
using ignition::msgs::Marker;
using ignition::msgs::Marker_V;
using test::RunningWorld;

/// A camera that sees nothing, one picture each 0.1 s.
const std::string kWorld =
    "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>"
    "<scene><background>0 0 0 1</background></scene><model name='m'><static>true</static><link name='l'>"
    "<sensor name='s' type='camera'><topic>cam</topic><update_rate>10</update_rate><camera><image><width>32</width>"
    "<height>24</height></image></camera></sensor></link></model>";

/// Skips where there is nothing to draw with.
class SensorMarkers : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const std::string& said : RunningWorld::complaintsAbout(kWorld)) {
      if (said.find("libOSMesa") != std::string::npos) GTEST_SKIP() << said;
    }
    world_ = std::make_unique<RunningWorld>(kWorld);
    world_->listen("/cam", images_);
  }

  /// A green box ahead of the camera.
  static Marker box() {
    Marker marker;
    marker.set_ns("test");
    marker.set_id(1);
    marker.set_type(Marker::BOX);
    marker.mutable_pose()->mutable_position()->set_x(3);
    marker.mutable_material()->mutable_diffuse()->set_g(1);
    return marker;
  }

  template <class Request, class Reply>
  CallResult ask(const std::string& service, const Request& request, Reply& reply) {
    return test::askService(world_->simulation().transport(), service, request, reply);
  }
  CallResult add(const Marker& marker) {
    Empty reply;
    return ask("/sensors/marker", marker, reply);
  }

  /// @return Whether the picture 0.1 s later shows a green box.
  bool isSeen() {
    images_.clear();
    world_->step(100);
    EXPECT_FALSE(images_.empty());
    if (images_.empty()) return false;
    const std::string& pixels = images_.back().data();
    return pixels.find(std::string("\0\xff\0", 3)) != std::string::npos;
  }

  std::unique_ptr<RunningWorld> world_;
  std::vector<Image> images_;
};

TEST_F(SensorMarkers, AreSeenUntilTheirTimeIsOver) {
  EXPECT_FALSE(isSeen());
  Marker marker = box();
  marker.mutable_lifetime()->set_nsec(150'000'000);
  EXPECT_TRUE(add(marker));
  EXPECT_TRUE(isSeen());
  EXPECT_FALSE(isSeen());
}

TEST_F(SensorMarkers, AreListedAndRemoved) {
  EXPECT_TRUE(add(box()));
  Marker_V list;
  EXPECT_TRUE(ask("/sensors/marker/list", Empty(), list));
  ASSERT_EQ(list.marker_size(), 1);
  EXPECT_EQ(list.marker(0).ns(), "test");
  EXPECT_EQ(list.marker(0).id(), 1U);
  Marker removal = box();
  removal.set_action(Marker::DELETE_MARKER);
  EXPECT_TRUE(add(removal));
  EXPECT_FALSE(isSeen());
  EXPECT_EQ(test::refusalOf(add(removal)), "there is no marker 1 of the name space 'test'");
}

TEST_F(SensorMarkers, OfAnArrayAreAddedAlsoBesideOnesThatAreRefused) {
  Marker_V all;
  *all.add_marker() = box();
  *all.add_marker() = box();
  all.mutable_marker(0)->set_parent("nobody");
  all.mutable_marker(1)->set_id(2);
  Boolean reply;
  const CallResult result = ask("/sensors/marker_array", all, reply);
  EXPECT_EQ(test::refusalOf(result),
            "number 1: marker 1 has the parent 'nobody', but there is no such model, link (MODEL::LINK) or visual "
            "(MODEL::LINK::VISUAL)");
  EXPECT_TRUE(isSeen());
  all.mutable_marker(0)->clear_parent();
  EXPECT_TRUE(ask("/sensors/marker_array", all, reply));
  EXPECT_TRUE(reply.data());
}

TEST_F(SensorMarkers, WithNumbersThatCanNotBeAreRefused) {
  Marker marker = box();
  marker.mutable_scale()->set_y(1e300);
  EXPECT_EQ(test::refusalOf(add(marker)), "a marker's scale.y is 1e+300");
  EXPECT_FALSE(isSeen());
}

TEST_F(SensorMarkers, WithALifetimeGoAtAReset) {
  Marker marker = box();
  EXPECT_TRUE(add(marker));
  marker.set_id(2);
  marker.mutable_lifetime()->set_sec(100);
  EXPECT_TRUE(add(marker));
  world_->step(1);
  Diagnostics diagnostics;
  world_->simulation().reset(diagnostics);
  world_->step(1);
  Marker_V list;
  EXPECT_TRUE(ask("/sensors/marker/list", Empty(), list));
  ASSERT_EQ(list.marker_size(), 1) << "as in Fortress";
  EXPECT_EQ(list.marker(0).id(), 1U);
}

TEST_F(SensorMarkers, ChangeNothingThatMoves) {
  RunningWorld other(kWorld);
  EXPECT_TRUE(add(box()));
  world_->step(5);
  other.step(5);
  EXPECT_EQ(world_->simulation().stateHash(), other.simulation().stateHash());
}

}  // namespace
}  // namespace pongsim::marker_test
